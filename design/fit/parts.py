"""Fit of keys, slits, seal layer, channels, bay and mould with what else is in the object."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, floor, hypot, sin
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.fit.blocks import check_bay, check_keys, check_slits
from design.fit.nearest import nearest_bay, nearest_keys, nearest_slits, with_nearest
from design.layout.boards import channel_heights_mm
from design.layout.body import core_frames, face_frames
from design.layout.dents import dents_mm
from design.layout.places.positions import cover_mm, shell_covers_mm
from design.layout.pockets import sensor_places, shell_pockets, widest_mm

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

Corners = Float[np.ndarray, "corner 2"]
ROOMY = 1.25
"""Times the thinnest wall that can be cast or printed, below which the checks of fabrication warn."""


def check_parts(spec: ObjectSpec) -> Iterator[str]:
    """Yield what of these does not fit."""
    if spec.core.keys.positions_mm:
        yield from with_nearest(spec, check_keys, nearest_keys)
    if spec.shell.slits.depth_mm:
        yield from with_nearest(spec, check_slits, nearest_slits)
    if spec.shell.seal_layer_mm:
        yield from _check_seal_layer(spec)
    yield from _check_pocket_width(spec)
    yield from _check_dents(spec)
    yield from check_channels(spec)
    if spec.core.bay_mm is not None:
        yield from with_nearest(spec, check_bay, nearest_bay)


def check_mesh(spec: ObjectSpec) -> Iterator[str]:
    """Edges that the body has no room for, and a mesh that may leave its surfaces too far.

    The mesher then works on without end or memory.
    """
    mesh, thickness, least = spec.mesh, spec.shell.thickness_mm, min(spec.body.size_mm)
    for key, most, what in (
        ("edge_mm", least, "the shortest edge of the body"),
        ("surface_edge_mm", least / 2, "half of the shortest edge of the body"),
        ("envelope_mm", thickness / 8, "an eighth of shell.thickness_mm"),
    ):
        if getattr(mesh, key) > most:
            yield (
                f"mesh.{key} = {getattr(mesh, key):g} is more than {what}, {most:g} mm. Make it smaller; "
                f"by default it is {type(mesh).model_fields[key].default:g}"
            )


def _check_pocket_width(spec: ObjectSpec) -> Iterator[str]:
    wide, least = spec.shell.pocket_diameter_mm, widest_mm(spec)
    if spec.arrangement == "sensors-in-core" and spec.magnets.shape != "block" and wide < least:
        yield (
            f"shell.pocket_diameter_mm = {wide:g} is narrower than the magnets of {least:g} "
            f"mm, which would stand in the silicone. Make it {least:g} or more, or take a "
            "smaller magnet"
        )


def _check_dents(spec: ObjectSpec) -> Iterator[str]:
    measured = [magnet for magnet in spec.as_built.magnets if magnet.dent_mm is not None]
    if measured and spec.arrangement == "sensors-in-shell":
        yield ("as_built gives dent_mm of a magnet, but the magnets lie in the core. Leave it out")
        return
    depth = dents_mm(spec)
    not_with = {
        "mechanics.correction": (spec.mechanics.correction, "none"),
        "mechanics.slip": (spec.mechanics.slip.slipped, False),
        "indenter.friction": (spec.indenter.friction, "none"),
    }
    for key, (given, needed) in not_with.items():
        if depth.any() and given != needed:
            yield (
                f"dents of the seals (as_built) are not known with {key}; got "
                f"{given!r}. Leave one of the two out"
            )
    for frame, pockets, dents in zip(face_frames(spec), shell_pockets(spec), depth, strict=True):
        for pocket, dent in zip(pockets, dents, strict=True):
            if not dent:
                continue
            cover = cover_mm(frame, pocket.body)
            if dent >= cover:
                yield (
                    f"a dent of {dent:g} mm on face {frame.number} reaches {pocket.body.label}, over "
                    f"which there are {cover:.3g} mm of silicone. Make dent_mm (as_built) "
                    f"smaller than {floor(1e3 * cover) / 1e3:g}"
                )


def _check_seal_layer(spec: ObjectSpec) -> Iterator[str]:
    layer = spec.shell.seal_layer_mm
    room = float(np.min(np.concatenate(shell_covers_mm(spec))))
    if layer > room:
        yield (
            f"shell.seal_layer_mm = {layer:g} would leave magnets sticking out of the first pour: at "
            f"most {room:.3g} mm of silicone lie over them. Lower it or seat them deeper"
        )


def check_channels(spec: ObjectSpec) -> Iterator[str]:
    core = spec.core
    if not core.wire_channel_mm[0]:
        return
    deepest = max(
        -channel_heights_mm(spec, frame, np.array([x, y]), 0.0)[0]
        for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True)
        for x, y, _ in places
    )
    if deepest >= core.wall_mm:
        fall = deepest - core.wire_channel_mm[1]
        wall_left_mm = core.wall_mm - max(fall, 0.0)
        shallower = (
            f"Make the channels less than {wall_left_mm:.3g} mm deep, "
            if wall_left_mm > 0
            else "Make "
        )
        curved = f" and {fall:.3g} mm of the curved core's fall" if fall > 0 else ""
        yield (
            f"the depth of core.wire_channel_mm{curved} must be below core.wall_mm = {core.wall_mm:g}; got "
            f"{core.wire_channel_mm[1]:g}. {shallower}the wall thicker than {deepest:.4g} mm, or move "
            "the sensors inwards"
        )


def recess_outline(spec: ObjectSpec, x: float, y: float, azimuth: float) -> Corners:
    """Outline of a sensor's recess on the core's face."""
    core, offset = spec.core, hypot(x, y) - spec.sensors.radius_mm
    radii = (core.recess_inner_radius_mm + offset, core.recess_outer_radius_mm + offset)
    return _radial(azimuth, radii, core.recess_width_mm)


def rectangle(centre: tuple[float, float], half: tuple[float, float], azimuth: float) -> Corners:
    turn = np.array([[cos(azimuth), -sin(azimuth)], [sin(azimuth), cos(azimuth)]])
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.asarray(half)
    return corners @ turn.T + np.asarray(centre)


def _radial(azimuth: float, radii: tuple[float, float], width: float) -> Corners:
    """Rectangle between two radii along an azimuth."""
    middle = (radii[0] + radii[1]) / 2
    centre = (middle * cos(azimuth), middle * sin(azimuth))
    return rectangle(centre, ((radii[1] - radii[0]) / 2, width / 2), azimuth)


def distance_mm(polygon: Corners, point: Float[np.ndarray, "2"]) -> float:
    """Distance of a point from a convex polygon (corners counter-clockwise); 0 inside."""
    edge = np.roll(polygon, -1, axis=0) - polygon
    away = point - polygon
    left_of_edge = edge[:, 0] * away[:, 1] - edge[:, 1] * away[:, 0]
    if (left_of_edge >= 0).all():
        return 0.0
    length2 = np.maximum((edge**2).sum(axis=1), 1e-12)  # of a recess without length, 0
    share = np.clip((away * edge).sum(axis=1) / length2, 0, 1)
    return float(np.linalg.norm(away - share[:, None] * edge, axis=1).min())
