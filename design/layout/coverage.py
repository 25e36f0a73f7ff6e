"""How much of the sensed surface the contact locations stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from design.layout.body import face_frames
from design.spec.worked_out import once

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

_SAMPLES = 401
"""Along each axis of a face: a share is good to 0.3 %."""


@once
def covered_share(spec: ObjectSpec) -> float:
    """Share of the area of all sensed faces that lies in a cell (pitch × pitch) of a contact location.

    Areas are along the surface. Patches of a curved body overlap, and what is steeper than 60° on
    all of them belongs to none and is not counted.
    """
    reach = np.asarray(spec.contact_grid.count) * spec.contact_grid.pitch_mm / 2
    covered = area = 0.0
    for frame in face_frames(spec):
        half_x, half_y = frame.half_extents_mm
        share = (np.arange(_SAMPLES) + 0.5) / _SAMPLES * 2 - 1
        xy = np.stack(np.meshgrid(half_x * share, half_y * share, indexing="ij"), axis=-1)
        on_face = frame.covers(xy)
        _, slope = frame.relief.at(xy)
        weight = np.sqrt(1 + np.sum(slope**2, axis=-1))[on_face] * half_x * half_y
        area += float(weight.sum())
        covered += float(weight[(abs(xy[on_face]) <= reach).all(axis=-1)].sum())
    return covered / area
