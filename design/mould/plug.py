"""Closure of a mould from above: the plug that leaves the core's room, or the rod that holds the core.

Both hang from one flange (`design/mould/plug_flange.py`).

A rod fills the bore from the block's upper side to the core, guided by the block's wall; its nose
sits in the core's outlet. A core that lies in the silicone for good cannot be pushed in later, and
its shell never folds outwards off a plug through a narrow bore.
"""

from __future__ import annotations

import numpy as np

from design.layout.body import body_of
from design.layout.core_hold import core_outlet
from design.layout.mould.closure import flange_span_mm
from design.layout.mould.frame import mould_frame
from design.mould.openings import hole_solid, mould_holes, seal_holes
from design.mould.plug_flange import flange_solids
from design.mould.room import cast_room, core_outside
from design.solids.booleans import Shape, Solid, common, cut, join, one_body
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, rod_about_z
from design.solids.shell import cavity
from design.spec.object import ObjectSpec


def make_mould_plug(spec: ObjectSpec) -> Solid:
    """Return what the core fills, and the flange, in the object's frame (mm).

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    block, *keys = cavity(spec)
    inside: Shape = common(block, cast_room(spec)) if body_of(spec).on_base else block
    whole = join(inside, *keys, *flange_solids(spec))
    return one_body(cut(whole, *(hole_solid(hole) for hole in mould_holes(spec))), "mould_plug")


def make_mould_holder(spec: ObjectSpec) -> Solid:
    """The rod through the bore with its nose and flange, in the object's frame (mm).

    Air that rises to the rim of the bore leaves by vents along the rod and through the flange.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    outlet, play = core_outlet(spec), spec.printer.clearance_mm
    rod = rod_about_z(spec.body.bore_mm / 2, -mould_frame(spec).rim_mm, 0.5 * outlet.floor_mm)
    radius, low = outlet.radius_mm - play, outlet.floor_mm - OVERSHOOT_MM
    nose = rod_about_z(radius, low, outlet.nose_mm)
    past = 2 * radius
    flat = box_between(
        (outlet.flat_mm - play, -past, outlet.floor_mm - 2.0), (past, past, outlet.nose_mm + 1.0)
    )
    outside = join(cut(rod, core_outside(spec)), *flange_solids(spec))
    holes = [*mould_holes(spec), *seal_holes(spec)]
    vents = [hole_solid(hole.outside) for hole in holes if hole.use == "vent"]
    return one_body(join(cut(outside, *vents), cut(nose, flat)), "mould_holder")


def pour_width_mm(spec: ObjectSpec) -> float:
    """Width of what silicone is poured through: a slot next to the flange, a hole, the open side."""
    frame, wall = mould_frame(spec), spec.mould.wall_mm
    if frame.opening != "open":
        return spec.mould.pour_mm
    ends = frame.low_mm[:2] + wall, frame.high_mm[:2] - wall
    if not frame.plugged:
        return float(np.min(ends[1] - ends[0]))
    left, right = flange_span_mm(spec)
    return float(max(left - ends[0][0], ends[1][0] - right))


def rod_hole(spec: ObjectSpec) -> cq.Solid:
    """Hole in the mould's wall round the rod."""
    frame = mould_frame(spec)
    radius = spec.body.bore_mm / 2 + spec.printer.clearance_mm
    return rod_about_z(radius, -frame.rim_mm - OVERSHOOT_MM, 0.0)
