"""Room within a mould: that for silicone, and the core where it is cast in."""

from __future__ import annotations

from design.layout.blocks import core_keys
from design.layout.body import body_of
from design.layout.mould.frame import mould_frame
from design.layout.surface import cast_surface
from design.solids.body import cast_outer_solid, core_solid, outer_solid, past_opening
from design.solids.booleans import Shape, join
from design.solids.primitives import block_solid
from design.solids.sampled import keyed_core
from design.spec.object import ObjectSpec


def cast_room(spec: ObjectSpec) -> Shape:
    """The outside of what the first pour casts: an exact solid, or triangles."""
    return cast_surface(spec) if body_of(spec).sampled else cast_outer_solid(spec)


def core_outside(spec: ObjectSpec) -> Shape:
    """The core with its keys, its recesses and holes filled."""
    body = body_of(spec)
    if body.sampled:
        return keyed_core(spec)
    return join(core_solid(spec), *(block_solid(key) for key in core_keys(spec)))


def finished_room(spec: ObjectSpec) -> Shape:
    """The outside of the finished silicone: an exact solid, or triangles."""
    return body_of(spec).outer_surface() if body_of(spec).sampled else outer_solid(spec)


def drawn_out(spec: ObjectSpec, room: Shape, layer_mm: float) -> Shape:
    """The room, which lacks a layer, drawn out a little beyond the open side, so that cutting it leaves
    no skin there."""
    frame = mould_frame(spec)
    if frame.opening != "open":
        return room
    return past_opening(spec, room, frame, layer_mm)
