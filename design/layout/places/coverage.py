"""Share of the sensed surface that the contact locations stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_SAMPLES = 401
"""Along each axis of a face: a share is good to 0.3 %."""
_IN_CELL = 5
"""Along each axis of a cell: its area is good to 0.1 %, the surface's slope differs little in it."""


@cached_geometry
def covered_shares(spec: ObjectSpec) -> Float[np.ndarray, "face"]:
    """`covered_share` of each sensed face alone."""
    covered, area = _covered_and_whole_mm2(spec)
    return covered / area


@cached_geometry
def covered_share(spec: ObjectSpec) -> float:
    """Share of the area of all sensed faces that lies in a cell (pitch × pitch) of a contact location.

    Areas are along the surface. Patches of a curved body overlap, and what is steeper than 60° on
    all of them belongs to none and is not counted.
    """
    covered, area = _covered_and_whole_mm2(spec)
    return float(covered.sum()) / float(area.sum())


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
    grid, pitch = contact_grid(spec), spec.contact_grid.pitch_mm
    reach, areas = np.array(grid.shape) * pitch / 2, []
    share = (np.arange(_SAMPLES) + 0.5) / _SAMPLES * 2 - 1
    for frame, places in zip(face_frames(spec), contact_places(spec), strict=True):
        half_x, half_y = frame.half_extents_mm
        xy = np.stack(np.meshgrid(half_x * share, half_y * share, indexing="ij"), axis=-1)
        xy = xy[frame.covers(xy)]
        _, slope = frame.relief.evaluate(xy)
        weight = np.sqrt(1 + np.sum(slope**2, axis=-1)) * 4 * half_x * half_y / _SAMPLES**2
        place = frame.from_plane(xy)
        within = np.asarray((abs(place) <= reach).all(axis=1))
        cell = np.floor((place[within] + reach) / pitch).astype(int)
        x, y = np.clip(cell, 0, np.array(grid.shape) - 1).T
        within[within] = places.reshape(grid.shape)[x, y]
        areas.append([float(weight[within].sum()), float(weight.sum())])
    return np.array(areas).T
