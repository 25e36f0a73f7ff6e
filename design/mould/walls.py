"""Walls of every mould, without bosses."""

from __future__ import annotations

from design.layout.mould.frame import mould_frame
from design.mould.plug_flange import tabs
from design.mould.room import drawn_out
from design.solids.booleans import Shape, common, cut, join
from design.solids.kernel import cq
from design.solids.primitives import box_between
from design.solids.shell import slit_fins
from design.spec.object import ObjectSpec


def walls(spec: ObjectSpec, room: Shape, layer_mm: float = 0.0) -> Shape:
    """The mould's walls and tabs round a room that lacks a layer, open where the body is, without bosses."""
    return join(cut(block(spec), drawn_out(spec, room, layer_mm)), *tabs(spec))


def block(spec: ObjectSpec) -> cq.Solid:
    """The block that a mould is cut from."""
    frame = mould_frame(spec)
    return box_between(*frame.corners(frame.low_mm, frame.high_mm))


def fins_to_walls(spec: ObjectSpec) -> list[Shape]:
    """Fins of the relief slits, from the walls inwards, down to the open face."""
    return [common(fin, block(spec)) for fin in slit_fins(spec)]
