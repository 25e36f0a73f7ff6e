"""Fit of parts and presses with a file's surface that is rougher than it is sampled."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.roughness import roughness
from design.errors import InputError
from design.layout.body import body_of, face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, touched_reach_mm
from design.layout.pockets import shell_pockets

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

MOST_SHARE = 0.5
"""Share of the thinnest silicone by which a surface may be off: the rest still covers a magnet."""


def most_off_mm(spec: ObjectSpec) -> float:
    """Return how far the sampled surface may be off where something is."""
    return MOST_SHARE * spec.silicone.thinnest_wall_mm


def check_roughness(spec: ObjectSpec) -> Iterator[str]:
    """Return what is refused: magnets and contact locations where the surface is too far off."""
    most = most_off_mm(spec)
    for text, off_mm in _rough_faces(spec):
        if off_mm > most:
            yield (
                f"{text}; {most:g} mm, half of silicone.thinnest_wall_mm, are allowed. Smooth the surface in "
                "the program that made the file, move what is there, or leave the face out with "
                "body.sensed_faces"
            )


def roughness_in_words(spec: ObjectSpec) -> list[str]:
    """Return what is worth a warning, a sentence for each face."""
    return [
        f"{text}. Smooth the surface in the program that made the file where that matters"
        for text, off_mm in _rough_faces(spec)
        if off_mm <= most_off_mm(spec)
    ]


def rough_patches(spec: ObjectSpec) -> list[str]:
    """Return the faces of a file's body that are that rough anywhere, which may be why nothing fits."""
    body, texts = body_of(spec), list[str]()
    for face in spec.body.sensed if body.from_file else ():
        with suppress(InputError):  # a face without a patch is told otherwise
            off_mm = max(roughness(body, face).off_mm, default=0.0)
            if off_mm > most_off_mm(spec):
                texts.append(
                    f"Face {face} has grooves or ridges {off_mm:.2g} mm deep, finer than the grid on which "
                    "its surface is sampled: smooth them in the program that made the file"
                )
    return texts


def _rough_faces(spec: ObjectSpec) -> Iterator[tuple[str, float]]:
    """Return for every face of a file's body how far it is off where something is, in words and mm."""
    body = body_of(spec)
    if not body.from_file:
        return
    for index, frame in enumerate(face_frames(spec)):
        face_roughness = roughness(body, frame.number)
        used = _distance_to_use_mm(spec, index, frame, face_roughness.points_mm) <= 0
        if not used.any():
            continue
        off = np.where(used, face_roughness.off_mm, 0.0)
        worst = int(off.argmax())
        place = ", ".join(f"{x:.1f}" for x in face_roughness.points_mm[worst])
        yield (
            f"face {frame.number} has grooves or ridges finer than the grid on which its surface is "
            f"sampled: magnets and contact locations are up to {off[worst]:.2g} mm off, as at ({place}) mm",
            float(off[worst]),
        )


def _distance_to_use_mm(
    spec: ObjectSpec, index: int, frame: FaceFrame, points_mm: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """Return the distance of points to the nearest pocket or touched disk of a face; 0 or less within."""
    from scipy.spatial import KDTree

    plane_mm = ((points_mm - frame.centre_mm) @ frame.axes)[:, :2]
    places = frame.to_plane(contact_grid(spec).xy_mm[contact_places(spec)[index]])
    # the tree answers infinity where a face has no contact location
    distances = [KDTree(places).query(plane_mm)[0] - touched_reach_mm(spec)]
    for pocket in shell_pockets(spec)[index]:
        away = np.linalg.norm(plane_mm - pocket.body.centre_mm[:2], axis=1)
        distances.append(away - pocket.outline.radius_mm)
    return np.min(distances, axis=0)
