"""Room within a mould: that for silicone, and the core where it is cast in."""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.body.blocks import core_keys
from design.body.kinds import is_sampled, sphere_centre_mm
from design.body.sampled import sampled_core
from design.layout.mould_frame import MouldFrame, mould_frame
from design.solids.body import core_solid
from design.solids.booleans import Shape, join
from design.solids.primitives import OVERSHOOT_MM, block_solid, box_between
from design.solids.sampled import cast_surface
from design.solids.shell import cast_envelope
from design.spec.object import ObjectSpec


def cast_room(spec: ObjectSpec) -> Shape:
    """The outside of what the first pour casts: an exact solid, or triangles."""
    return cast_surface(spec) if is_sampled(spec) else cast_envelope(spec)


def core_outside(spec: ObjectSpec) -> Shape:
    """The core with its keys, its recesses and holes filled."""
    if is_sampled(spec):
        return sampled_core(spec)
    return join(core_solid(spec), *(block_solid(key) for key in core_keys(spec)))


def drawn_out(spec: ObjectSpec, room: Shape) -> Shape:
    """The room drawn out a little beyond the open side, so that cutting it leaves no skin there."""
    frame = mould_frame(spec)
    if frame.opening != "open":
        return room
    if spec.body.kind == "dome":
        radius = spec.body.size_mm[0] / 2
        centre = cq.Vector(*sphere_centre_mm(spec))
        return cq.Solid.makeSphere(radius, centre, cq.Vector(0, 0, 1), -90, 90, 360)
    if spec.body.kind == "cylinder":
        return join(room, _disk(spec, frame))
    assert isinstance(room, cq.Shape)
    box = room.BoundingBox()
    corners = np.array([[box.xmin, box.ymin, box.zmin], [box.xmax, box.ymax, box.zmax]])
    low, high = np.sort(frame.axes.T @ corners.T, axis=1).T
    low[2] = frame.rim_mm - OVERSHOOT_MM
    high[2] = frame.rim_mm + OVERSHOOT_MM
    return join(room, box_between(*frame.corners(low, high)))


def _disk(spec: ObjectSpec, frame: MouldFrame) -> cq.Solid:
    """The end of a cylinder, a little inside and outside of it."""
    start = (frame.rim_mm - OVERSHOOT_MM) * frame.out
    radius = spec.body.size_mm[0] / 2
    return cq.Solid.makeCylinder(radius, 2 * OVERSHOOT_MM, cq.Vector(*start), cq.Vector(*frame.out))
