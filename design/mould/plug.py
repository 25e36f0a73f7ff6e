"""Closure of a mould from above: the plug that leaves the core's room, or the rod that holds the core.

Both hang from one flange. For the paper's cube, the dimensions that the specification leaves open are
fixed by the bounding box and the volume of the authors' public plug (Knopke et al., RA-L 2024),
30 × 50 × 44 mm and 34 454.65 mm³: the cavity's 26 × 26 × 34 block (22 984 mm³) and 10 mm of flange
outside the body. The flange is 30 mm wide (the tabs with 0.1 mm of play on both sides, 2 mm over the
plug's edge), which leaves two pouring slots of 6 × 42 mm. It is 50 mm long: two clips of 2.5 mm over
the box's 45 mm. Chosen within that: a bridge between the tabs (30 × 41.8 × 4), a plate resting on the
tabs (30 × 50 × 3), clips that reach 4 mm below the rim (2 of 30 × 2.4 × 8). A grip 26 mm long and
3 mm high fills the height, and the volume left over makes it 10.3 mm wide.

A rod fills the bore from the block's upper side to the core, guided by the block's wall; its nose
sits in the core's outlet. A core that lies in the silicone for good cannot be pushed in later, and
its shell never folds outwards off a plug through a narrow bore.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.layout.body import body_of
from design.layout.core_hold import core_outlet
from design.layout.mould_frame import MouldFrame, mould_frame, play_mm
from design.mould.openings import mould_holes
from design.mould.room import cast_room, core_outside
from design.solids.booleans import Shape, Solid, common, cut, join, one_body
from design.solids.primitives import OVERSHOOT_MM, box_between, rod_about_z
from design.solids.shell import cavity
from design.spec.object import ObjectSpec

TAB_HEIGHT_MM = 4.0
FLANGE_OVERLAP_MM = 2.0
"""Of the flange over the shell's rim, but at most a quarter of the shell's thickness, so that thin
shells keep room to pour. A rod's flange is as wide as the rod."""
PLATE_MM = 3.0
CLIP_MM = 2.5
CLIP_REACH_MM = 4.0
GRIP_HEIGHT_MM = 3.0
GRIP_WIDTH_MM = 10.3


def make_mould_plug(spec: ObjectSpec) -> Solid:
    """What the core fills, flange, clips and grip, in the object's frame (mm).

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    block, *keys = cavity(spec)
    inside: Shape = common(block, cast_room(spec)) if body_of(spec).on_base else block
    frame = mould_frame(spec)
    whole = join(inside, *keys, *_flange(spec, frame), *_clips(spec, frame))
    return one_body(cut(whole, *(hole.solid() for hole in mould_holes(spec))), "mould_plug")


def make_mould_holder(spec: ObjectSpec) -> Solid:
    """The rod through the bore with its nose, flange, clips and grip, in the object's frame (mm).

    Air that rises to the rim of the bore leaves by vents along the rod and through the flange.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    frame, outlet, play = mould_frame(spec), core_outlet(spec), play_mm(spec)
    rod = rod_about_z(spec.body.bore_mm / 2, -frame.rim_mm, 0.5 * outlet.floor_mm)
    radius, low = outlet.radius_mm - play, outlet.floor_mm - OVERSHOOT_MM
    narrowing = float(np.tan(np.deg2rad(spec.mould.draft_deg)))
    nose = rod_about_z(radius, low, outlet.nose_mm, radius - narrowing * (outlet.nose_mm - low))
    past = 2 * radius
    flat = box_between(
        (outlet.flat_mm - play, -past, outlet.floor_mm - 2.0), (past, past, outlet.nose_mm + 1.0)
    )
    outside = join(cut(rod, core_outside(spec)), *_flange(spec, frame), *_clips(spec, frame))
    vents = [hole.outside.solid() for hole in mould_holes(spec) if hole.use == "vent"]
    return one_body(join(cut(outside, *vents), cut(nose, flat)), "mould_holder")


def tabs(spec: ObjectSpec) -> list[cq.Solid]:
    """Two tabs that continue the walls at the ends of `along` upwards; they hold the flange."""
    frame = mould_frame(spec)
    if not frame.plugged:
        return []
    (left, right), play = _span(spec, frame), play_mm(spec)
    end, wall = float(frame.high_mm[1]), spec.mould.wall_mm
    heights = frame.rim_mm - OVERSHOOT_MM, frame.rim_mm + TAB_HEIGHT_MM
    across = left + play, right - play
    return [_box_at_end(frame, side, across, (end - wall, end), heights) for side in (1, -1)]


def pour_width_mm(spec: ObjectSpec) -> float:
    """Width of what silicone is poured through: a slot beside the flange, a hole, the open side."""
    frame, wall = mould_frame(spec), spec.mould.wall_mm
    if frame.opening != "open":
        return spec.mould.pour_mm
    ends = frame.low_mm[:2] + wall, frame.high_mm[:2] - wall
    if not frame.plugged:
        return float(np.min(ends[1] - ends[0]))
    left, right = _span(spec, frame)
    return float(max(left - ends[0][0], ends[1][0] - right))


def rod_hole(spec: ObjectSpec) -> cq.Solid:
    """Hole in the mould's wall round the rod."""
    frame = mould_frame(spec)
    radius = spec.body.bore_mm / 2 + play_mm(spec)
    return rod_about_z(radius, -frame.rim_mm - OVERSHOOT_MM, 0.0)


def _span(spec: ObjectSpec, frame: MouldFrame) -> tuple[float, float]:
    """Ends of the flange across the mould: over the plug's edges, but within the silicone's box."""
    bore = frame.opening == "bore"
    over = 0.0 if bore else min(FLANGE_OVERLAP_MM, spec.shell.thickness_mm / 4)
    wall = spec.mould.wall_mm
    left = max(frame.plug_mm[0, 0] - over, frame.low_mm[0] + wall)
    right = min(frame.plug_mm[1, 0] + over, frame.high_mm[0] - wall)
    return float(left), float(right)


def _flange(spec: ObjectSpec, frame: MouldFrame) -> list[cq.Solid]:
    """Bridge between the tabs, plate on the tabs and grip, stacked outwards from the rim."""
    left, right = _span(spec, frame)
    inside = frame.high_mm[1] - spec.mould.wall_mm
    middle, grip = (left + right) / 2, min(GRIP_WIDTH_MM, right - left) / 2
    across = ((left, right), (left, right), (middle - grip, middle + grip))
    bridge, plate = inside - play_mm(spec), frame.high_mm[1] + CLIP_MM
    along = (
        (-bridge, bridge),
        (-plate, plate),
        (float(frame.plug_mm[0, 1]), float(frame.plug_mm[1, 1])),
    )
    levels = frame.rim_mm + np.cumsum([0.0, TAB_HEIGHT_MM, PLATE_MM, GRIP_HEIGHT_MM])
    return [
        box_between(*frame.corners(np.array([x[0], y[0], low]), np.array([x[1], y[1], high])))
        for x, y, low, high in zip(across, along, levels[:-1], levels[1:], strict=True)
    ]


def _clips(spec: ObjectSpec, frame: MouldFrame) -> list[cq.Solid]:
    """Two arms that hang from the plate outside the walls and reach below the rim."""
    left, right = _span(spec, frame)
    wall = float(frame.high_mm[1])
    levels = frame.rim_mm - CLIP_REACH_MM, frame.rim_mm + TAB_HEIGHT_MM + PLATE_MM / 2
    ends = wall + play_mm(spec), wall + CLIP_MM
    return [_box_at_end(frame, side, (left, right), ends, levels) for side in (1, -1)]


def _box_at_end(
    frame: MouldFrame,
    side: int,
    across_mm: tuple[float, float],
    along_mm: tuple[float, float],
    out_mm: tuple[float, float],
) -> cq.Solid:
    """A box that spans these lengths, at the upper (1) or lower (−1) end of `along`."""
    near, far = sorted(side * end for end in along_mm)
    low, high = ((across_mm[k], (near, far)[k], out_mm[k]) for k in (0, 1))
    return box_between(*frame.corners(np.array(low), np.array(high)))
