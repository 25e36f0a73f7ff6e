"""Flange of a plug or a rod, by which it hangs in the mould, and the tabs of the mould that take it.

The shape of the authors' public mould (Knopke et al., RA-L 2024), read off its STEP file: the walls at
the ends of `length_axis` are raised by 2 mm under the flange and by 4 mm next to it, in posts of 7.3 mm,
between which the flange cannot slide. It is 10 mm high: a bridge of 2 mm between the walls; blocks
10 mm long over them, with clips down to the rim outside; and between the blocks a gabled grip with
chamfers of 3 mm where it meets them. Theirs has 0.05 mm of play along and 0.2 mm across, ours
`printer.clearance_mm` and twice that, so that parts of both sets fit each other. On a narrow flange
the gable is lower, never steeper than 45°.
"""

from __future__ import annotations

import numpy as np

from design.layout.mould.closure import (
    CLIP_MM,
    FLANGE_HEIGHT_MM,
    SEAT_MM,
    clip_mm,
    flange_span_mm,
)
from design.layout.mould.frame import MouldFrame, mould_frame, mould_style
from design.solids.booleans import Shape, common, cut
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between
from design.spec.object import ObjectSpec

POST_HEIGHT_MM = 4.0
POST_MM = 7.3
BLOCK_MM = 10.0
CHAMFER_MM = 3.0


def flange_solids(spec: ObjectSpec) -> list[Shape]:
    """Bridge, blocks with their clips, and grip, in the object's frame (mm)."""
    frame, play = mould_frame(spec), spec.printer.clearance_mm
    left, right = flange_span_mm(spec)
    wall = float(frame.high_mm[1])
    (start, end), inner = clip_mm(spec), grip_half_mm(frame)
    bridge = wall - spec.mould.wall_mm - play
    rim, seat, top = frame.rim_mm + np.array([0.0, SEAT_MM, FLANGE_HEIGHT_MM])
    solids: list[Shape] = [
        _box(frame, (left, right), (-bridge, bridge), (rim, seat)),
        grip_solid(frame, (left, right), inner, (seat, top)),
    ]
    for side in (1, -1):
        clip = sorted((side * start, side * end))
        solids.append(_box(frame, (left, right), clip, (rim, top)))
        block = sorted((side * inner, side * end))
        solids.append(_box(frame, (left, right), block, (seat, top)))
    return solids


def tabs(spec: ObjectSpec) -> list[cq.Solid]:
    """Return what the walls at the ends of `wall_span` are raised by, in the object's frame (mm)."""
    frame = mould_frame(spec)
    if not frame.plugged:
        return []
    (left, right), gap = flange_span_mm(spec), 2 * spec.printer.clearance_mm
    wall, end = spec.mould.wall_mm, float(frame.high_mm[1])
    low, high = frame.rim_mm - OVERSHOOT_MM, frame.rim_mm + POST_HEIGHT_MM
    corners = frame.low_mm[0], frame.high_mm[0]
    if mould_style(spec) == "split":  # the seam parts corners
        within = corners[0] + wall, corners[1] - wall
        if min(left - gap - within[0], within[1] - right - gap) > spec.printer.wall_mm:
            corners = within
    outer = max(left - gap - POST_MM, corners[0]), min(right + gap + POST_MM, corners[1])
    solids = []
    for side in (1, -1):
        wall_span = sorted((side * (end - wall), side * end))
        solids.append(_box(frame, outer, wall_span, (low, frame.rim_mm + SEAT_MM)))
        for post in ((outer[0], left - gap), (right + gap, outer[1])):
            solids.append(_box(frame, post, wall_span, (low, high)))
    return solids


def grip_half_mm(frame: MouldFrame) -> float:
    """Half the length of the grip between the blocks; 0 where the blocks meet."""
    inner = float(frame.high_mm[1]) + CLIP_MM - BLOCK_MM
    return inner if inner > CHAMFER_MM + OVERSHOOT_MM else 0.0


def grip_solid(
    frame: MouldFrame,
    across_mm: tuple[float, float],
    inner_mm: float,
    levels_mm: tuple[float, float],
) -> Shape:
    """The gable with its chamfers: a box, cut by a prism over each slope."""
    left, right = across_mm
    middle, (seat, top) = (left + right) / 2, levels_mm
    if not inner_mm:
        return _box(frame, across_mm, (-OVERSHOOT_MM, OVERSHOOT_MM), levels_mm)
    whole = _box(frame, across_mm, (-inner_mm, inner_mm), levels_mm)
    rise = min(top - seat, (right - left) / 2)
    cutters = []
    for edge in (left, right):
        over = sorted((middle, edge + np.sign(edge - middle)))
        room = _box(frame, over, (-inner_mm, inner_mm), (seat, top + 1.0))
        foot, ridge = (
            frame.axes @ np.array(p) for p in ((edge, 0.0, seat), (middle, 0.0, seat + rise))
        )
        cutters.append(common(prism_over_slope(frame, foot, ridge, inner_mm), room))
    return cut(whole, *cutters)


def prism_over_slope(
    frame: MouldFrame, foot_mm: np.ndarray, ridge_mm: np.ndarray, inner_mm: float
) -> cq.Solid:
    """All above the plane through foot and ridge, between the blocks, but for the chamfers."""
    slope = (ridge_mm - foot_mm) / np.linalg.norm(ridge_mm - foot_mm)
    above = frame.out - (frame.out @ slope) * slope
    above /= np.linalg.norm(above)
    short, high = inner_mm - CHAMFER_MM, 4 * FLANGE_HEIGHT_MM
    outline = [
        (0.0, short),
        (CHAMFER_MM, inner_mm),
        (high, inner_mm),
        (high, -inner_mm),
        (CHAMFER_MM, -inner_mm),
        (0.0, -short),
    ]
    reach = float(np.linalg.norm(ridge_mm - foot_mm)) + high
    start = foot_mm - high * slope
    corners = [cq.Vector(*(start + h * above + s * frame.length_axis)) for h, s in outline]
    wire = cq.Wire.makePolygon(corners, close=True)
    return cq.Solid.extrudeLinear(wire, [], cq.Vector(*((reach + high) * slope)))


def _box(
    frame: MouldFrame,
    across_mm: tuple[float, float] | list[float],
    along_mm: tuple[float, float] | list[float],
    out_mm: tuple[float, float],
) -> cq.Solid:
    """A box between these levels along the mould's axes."""
    ends = np.array([across_mm, along_mm, out_mm], float)
    return box_between(*frame.corners(ends[:, 0], ends[:, 1]))
