"""The whole mould, of either style: what closes round the shell, and what keeps the core's room free."""

from __future__ import annotations

from design.layout.mould.frame import mould_frame, mould_style
from design.layout.mould.pins import loose_pins
from design.mould.halves import make_mould_half
from design.mould.one_piece import make_mould_box
from design.mould.pins import make_pin
from design.mould.plug import make_mould_holder, make_mould_plug
from design.mould.room import core_outside
from design.solids.booleans import Shape, Solid
from design.spec.object import ObjectSpec


def mould_around(spec: ObjectSpec) -> list[Solid]:
    """Everything that closes round the shell from outside: the box, or halves and pins."""
    if mould_style(spec) == "one-piece":
        return [make_mould_box(spec)]
    pins = [make_pin(spec, pin) for pin in loose_pins(spec)]
    return [make_mould_half(spec, 1), make_mould_half(spec, -1), *pins]


def inside_of_mould(spec: ObjectSpec) -> list[Shape]:
    """Return what keeps the core's room free: the plug, or the core itself and the rod that holds it."""
    frame = mould_frame(spec)
    if frame.opening == "closed":
        return [core_outside(spec)]
    if frame.opening == "bore":
        return [core_outside(spec), make_mould_holder(spec)]
    return [make_mould_plug(spec)] if frame.plugged else []
