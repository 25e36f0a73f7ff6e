"""How much of the sensed surface the contact locations stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.worked_out import once

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_SAMPLES = 401
"""Along each axis of a face: a share is good to 0.3 %."""


@once
def covered_shares(spec: ObjectSpec) -> Float[np.ndarray, "face"]:
    """`covered_share` of each sensed face alone."""
    covered, area = _covered_and_whole_mm2(spec)
    return covered / area


@once
def covered_share(spec: ObjectSpec) -> float:
    """Share of the area of all sensed faces that lies in a cell (pitch × pitch) of a contact location.

    Areas are along the surface. Patches of a curved body overlap, and what is steeper than 60° on
    all of them belongs to none and is not counted.
    """
    covered, area = _covered_and_whole_mm2(spec)
    return float(covered.sum()) / float(area.sum())


@once
def _covered_and_whole_mm2(spec: ObjectSpec) -> Float[np.ndarray, "2 face"]:
    """Area of each sensed face that contact locations stand for, and all of it."""
    grid, pitch = contact_grid(spec), spec.contact_grid.pitch_mm
    reach, found = np.array(grid.shape) * pitch / 2, []
    share = (np.arange(_SAMPLES) + 0.5) / _SAMPLES * 2 - 1
    for frame, places in zip(face_frames(spec), contact_places(spec), strict=True):
        half_x, half_y = frame.half_extents_mm
        xy = np.stack(np.meshgrid(half_x * share, half_y * share, indexing="ij"), axis=-1)
        xy = xy[frame.covers(xy)]
        _, slope = frame.relief.at(xy)
        weight = np.sqrt(1 + np.sum(slope**2, axis=-1)) * 4 * half_x * half_y / _SAMPLES**2
        within = np.asarray((abs(xy) <= reach).all(axis=1))
        cell = np.floor((xy[within] + reach) / pitch).astype(int)
        x, y = np.clip(cell, 0, np.array(grid.shape) - 1).T
        within[within] = places.reshape(grid.shape)[x, y]
        found.append([float(weight[within].sum()), float(weight.sum())])
    return np.array(found).T
