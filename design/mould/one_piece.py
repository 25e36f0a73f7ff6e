"""The mould in one piece: a box with integral bosses that its plug closes; and what a mould casts.

The paper's box (Knopke et al., RA-L 2024), 45 × 45 × 47.5 mm and 16 477.68 mm³: the body's 42 mm cube
within 1.5 mm walls on the five sensed faces is 45 × 45 × 43.5 mm and, with its 25 bosses,
45·45·43.5 − 42³ + 25·π·9·3 = 16 120.08 mm³. The 4 mm of height and 357.60 mm³ left over are too little
for a closed rim (1044) but are exactly two tabs of the wall's thickness, 29.8 mm wide:
2 · 29.8 · 4 · 1.5 = 357.6. The open side is where the silicone is poured in, beside the plug's flange
(`design/mould/plug.py`).

No part has draft. The side bosses are undercuts: the plug comes out first, then the soft wall
folds inwards. `design/mould/halves.py` makes the same cavity from halves that draw apart.
"""

from __future__ import annotations

import cadquery as cq

from design.layout.core_hold import why_no_mould
from design.layout.mould_frame import mould_frame, mould_style
from design.mould.openings import mould_holes
from design.mould.plug import make_mould_holder, make_mould_plug, tabs
from design.mould.room import cast_room, core_outside, drawn_out
from design.solids.booleans import Shape, Solid, common, cut, join, one_body
from design.solids.primitives import box_between
from design.solids.shell import envelope, pocket_prisms, slit_fins
from design.spec.object import ObjectSpec


def make_mould_box(spec: ObjectSpec) -> Solid:
    """Outer box in the object's frame (mm), open on one side, with bosses and the slits' fins.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    inside = [*pocket_prisms(spec), *fins_to_walls(spec)]
    box = join(walls(spec, cast_room(spec)), *inside)
    return one_body(cut(box, *(hole.solid() for hole in mould_holes(spec))), "mould_box")


def make_seal_mould(spec: ObjectSpec) -> Solid:
    """Box of the second pour, without bosses: the shell on its plug gets its seal layer in it.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    return one_body(join(walls(spec, envelope(spec)), *fins_to_walls(spec)), "mould_seal_box")


def walls(spec: ObjectSpec, room: Shape) -> Shape:
    """The mould's walls and tabs round a room, open where the body is, without bosses."""
    return join(cut(block(spec), drawn_out(spec, room)), *tabs(spec))


def block(spec: ObjectSpec) -> cq.Solid:
    """The block that a mould is cut from."""
    frame = mould_frame(spec)
    return box_between(*frame.corners(frame.low_mm, frame.high_mm))


def fins_to_walls(spec: ObjectSpec) -> list[Shape]:
    """Fins of the relief slits, from the walls inwards, down to the open face."""
    return [common(fin, block(spec)) for fin in slit_fins(spec)]


def cast_cavity(spec: ObjectSpec) -> Shape:
    """What silicone fills in the closed mould, within the first pour's envelope."""
    return cut(cast_room(spec), *mould_around(spec), *inside_of_mould(spec))


def mould_around(spec: ObjectSpec) -> list[Solid]:
    """Everything that closes round the shell from outside: the box, or halves and pins."""
    if mould_style(spec) == "one-piece":
        return [make_mould_box(spec)]
    from design.mould.halves import make_mould_half
    from design.mould.pins import loose_pins, make_pin

    pins = [make_pin(spec, pin) for pin in loose_pins(spec)]
    return [make_mould_half(spec, 1), make_mould_half(spec, -1), *pins]


def inside_of_mould(spec: ObjectSpec) -> list[Shape]:
    """What keeps the core's room free: the plug, or the core itself and the rod that holds it."""
    frame = mould_frame(spec)
    if frame.opening == "closed":
        return [core_outside(spec)]
    if frame.opening == "bore":
        return [core_outside(spec), make_mould_holder(spec)]
    return [make_mould_plug(spec)] if frame.plugged else []


def has_mould(spec: ObjectSpec) -> bool:
    """Whether a mould can be made for the body."""
    return why_no_mould(spec) is None
