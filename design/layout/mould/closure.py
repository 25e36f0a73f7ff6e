"""Places of the flange of a plug or a rod, as numbers.

`design/mould/plug_flange.py` describes its shape, and builds it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.layout.body import body_of
from design.layout.mould.frame import mould_frame

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

SEAT_MM = 2.0
"""Height above the rim at which the flange rests on the walls."""
FLANGE_HEIGHT_MM = 10.0
FLANGE_OVERLAP_MM = 2.0
"""Overlap of the flange over the shell's rim, but at most a quarter of the shell's thickness, so that thin
shells keep room to pour. A rod's flange is as wide as the rod."""
CLIP_MM = 2.5
"""Distance from the wall to the outer side of a clip, its play included."""


def flange_span_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Ends of the flange across the mould: over the plug's edges, but within the silicone's box."""
    frame, bore = mould_frame(spec), body_of(spec).opening == "bore"
    over = 0.0 if bore else min(FLANGE_OVERLAP_MM, spec.shell.thickness_mm / 4)
    wall = spec.mould.wall_mm
    left = max(frame.plug_mm[0, 0] - over, frame.low_mm[0] + wall)
    right = min(frame.plug_mm[1, 0] + over, frame.high_mm[0] - wall)
    return float(left), float(right)


def clip_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Return where a clip begins and ends along the mould, outside its wall."""
    wall = float(mould_frame(spec).high_mm[1])
    return wall + spec.printer.clearance_mm, wall + CLIP_MM


def flange_corners_mm(
    spec: ObjectSpec,
) -> list[tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]]:
    """Lowest and highest corner, in the object's frame, of boxes that hold the flange: both clips, and
    what lies between the walls and over them. None where nothing closes the mould from above."""
    frame = mould_frame(spec)
    if not frame.plugged:
        return []
    left, right = flange_span_mm(spec)
    start, end = clip_mm(spec)
    rim, seat, top = frame.rim_mm + np.array([0.0, SEAT_MM, FLANGE_HEIGHT_MM])
    inner = start - 2 * spec.printer.clearance_mm - spec.mould.wall_mm
    boxes = [
        ((left, start, rim), (right, end, top)),
        ((left, -end, rim), (right, -start, top)),
        ((left, -end, seat), (right, end, top)),
        ((left, -inner, rim), (right, inner, top)),
    ]
    return [frame.corners(np.array(low), np.array(high)) for low, high in boxes]
