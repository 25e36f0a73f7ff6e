"""Share of the sensed surface that the contact locations stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

_SAMPLES = 401
"""Along each axis of a face: a share is good to 0.3 %."""
_SHARED_SAMPLES, _ON_PATCH_MM = 121, 0.1
"""The same for all faces together: good to 1 %; and how near a patch a point of another lies on it."""
_IN_CELL = 5
"""Along each axis of a cell: its area is good to 0.1 %, the surface's slope differs little in it."""


@cached_geometry
def covered_shares(spec: ObjectSpec) -> Float[np.ndarray, "face"]:
    """`covered_share` of each sensed face alone."""
    covered, area = _covered_and_whole_mm2(spec)
    return covered / area


@cached_geometry
def covered_share(spec: ObjectSpec) -> float:
    """Share of the area of the sensed surface that lies in a cell (pitch × pitch) of a contact location.

    Areas are along the surface. Where patches of a curved body overlap it counts once, covered if a
    location of any of them has it; what is steeper than 60° on all of them belongs to none and is not
    counted.
    """
    if all(frame.flat for frame in face_frames(spec)):
        covered, area = _covered_and_whole_mm2(spec)
        return float(covered.sum()) / float(area.sum())
    covered = whole = 0.0
    for index, frame in enumerate(face_frames(spec)):
        xy, weight = _points_and_areas(frame, _SHARED_SAMPLES)
        points = frame.to_object(np.column_stack([xy, np.zeros(len(xy))]))
        patches, has_location = np.zeros(len(xy)), np.zeros(len(xy), bool)
        for number, patch in enumerate(face_frames(spec)):
            place = (
                np.column_stack([xy, 0 * weight]) if number == index else patch.from_object(points)
            )
            on_patch = (abs(place[:, 2]) < _ON_PATCH_MM) & patch.covers(place[:, :2])
            patches += on_patch
            has_location[on_patch] |= _find_covered(spec, number, patch, place[on_patch, :2])
        # a point on k patches is met k times
        covered += float(np.sum(weight / patches * has_location))
        whole += float(np.sum(weight / patches))
    return covered / whole


@cached_geometry
def cell_areas_mm2(spec: ObjectSpec) -> Float[np.ndarray, "location"]:
    """Area of the surface in the cell of each contact location, face by face.

    pitch² on flat faces and cylinders; a little more in the corners of doubly curved patches. What of
    a cell lies beyond the patch counts as the rest of it.
    """
    pitch, areas = spec.contact_grid.pitch_mm, []
    share = (np.arange(_IN_CELL) + 0.5) / _IN_CELL - 0.5
    within = pitch * np.stack(np.meshgrid(share, share, indexing="ij"), axis=-1).reshape(-1, 2)
    for frame, places in zip(face_frames(spec), contact_places(spec), strict=True):
        stretch = frame.area_stretch(contact_grid(spec).xy_mm[places][:, None] + within)
        areas.append(np.nanmean(stretch, axis=1) * pitch**2)
    return np.concatenate(areas)


@cached_geometry
def _covered_and_whole_mm2(spec: ObjectSpec) -> Float[np.ndarray, "2 face"]:
    """Area of each sensed face that contact locations stand for, and all of it."""
    areas = []
    for index, frame in enumerate(face_frames(spec)):
        xy, weight = _points_and_areas(frame, _SAMPLES)
        within = _find_covered(spec, index, frame, xy)
        areas.append([float(weight[within].sum()), float(weight.sum())])
    return np.array(areas).T


def _points_and_areas(
    frame: FaceFrame, samples: int
) -> tuple[Float[np.ndarray, "n 2"], Float[np.ndarray, "n"]]:
    """Points (x, y) spread over a patch, and the area of the surface that each stands for (mm²)."""
    share = (np.arange(samples) + 0.5) / samples * 2 - 1
    half_x, half_y = frame.half_extents_mm
    xy = np.stack(np.meshgrid(half_x * share, half_y * share, indexing="ij"), axis=-1)
    xy = xy[frame.covers(xy)]
    _, slope = frame.relief.evaluate(xy)
    return xy, np.sqrt(1 + np.sum(slope**2, axis=-1)) * 4 * half_x * half_y / samples**2


def _find_covered(
    spec: ObjectSpec, index: int, frame: FaceFrame, xy_mm: Float[np.ndarray, "n 2"]
) -> Bool[np.ndarray, "n"]:
    """Return whether points of the index-th face lie in a cell of a location that it has."""
    grid, pitch = contact_grid(spec), spec.contact_grid.pitch_mm
    reach, place = np.array(grid.shape) * pitch / 2, frame.from_plane(xy_mm)
    within = np.asarray((abs(place) <= reach).all(axis=1))
    cell = np.floor((place[within] + reach) / pitch).astype(int)
    x, y = np.clip(cell, 0, np.array(grid.shape) - 1).T
    within[within] = contact_places(spec)[index].reshape(grid.shape)[x, y]
    return within
