"""Draw the split mould of a specification as it goes together, the way it stands when it is poured.

python examples/draw_mould.py docs/fabrication_ball.png examples/ball.toml
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from design.build.parts import parts_of
from design.layout.core_hold import locators
from design.layout.mould.frame import mould_frame, parting
from design.layout.mould.pins import loose_pins
from design.mould.halves import make_mould_half
from design.mould.pins import make_pin
from design.mould.plug import make_mould_holder, make_mould_plug
from design.mould.room import core_outside
from design.solids.booleans import Shape, convert_to_triangles
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.render.pieces import COLOURS, Piece, picture_of

APART = 0.75
"""How far the halves are drawn, of the body's largest edge."""


def pieces(spec: ObjectSpec, apart_mm: float) -> list[Piece]:
    """Half B with what it holds where it stands, half A and the pins drawn out."""
    frame, normal = mould_frame(spec), parting(spec).normal
    core = {part.name: part for part in parts_of(spec)}["core"]
    inside = core.make() if frame.opening != "closed" else core_outside(spec)
    shown = [
        piece(make_mould_half(spec, 1), COLOURS["mould_half_a"], apart_mm * normal),
        piece(make_mould_half(spec, -1), COLOURS["mould_half_b"], -apart_mm * normal),
        piece(inside, COLOURS["core"], np.zeros(3)),
    ]
    if frame.plugged:
        made = make_mould_holder(spec) if frame.opening == "bore" else make_mould_plug(spec)
        shown.append(piece(made, COLOURS["mould_holder"], np.zeros(3)))
    for pin in loose_pins(spec):
        side = float(np.sign(np.round(pin.axis_mm[1] @ normal, 6)))
        drawn_mm = side * apart_mm * normal + 16.0 * pin.way
        shown.append(piece(make_pin(spec, pin), COLOURS["pin"], drawn_mm))
    return shown


def piece(shape: Shape, colour: tuple[float, float, float], by_mm: np.ndarray) -> Piece:
    """A part as triangles, moved."""
    return Piece(convert_to_triangles(shape), colour).moved(by_mm)


def draw(spec: ObjectSpec, target: Path) -> None:
    """One picture; `out`, the side that is poured into, is up."""
    from matplotlib.figure import Figure

    frame = mould_frame(spec)
    shown = pieces(spec, APART * max(spec.body.size_mm))
    side = np.cross(frame.out, parting(spec).normal)
    x, y, z = (side + 0.35 * parting(spec).normal + 0.6 * frame.out).tolist()
    up_x, up_y, up_z = frame.out.tolist()
    picture = picture_of(shown, (x, y, z), (up_x, up_y, up_z))
    left, right, bottom, top = picture.extent_mm
    figure = Figure(figsize=(11, 11 * (top - bottom) / (right - left)), layout="constrained")
    axes = figure.subplots()
    axes.imshow(picture.rgb, extent=picture.extent_mm)
    axes.set_axis_off()
    held = "locating pins" if locators(spec) else "rod" if frame.opening == "bore" else "plug"
    axes.set_title(f"Split mould of {spec.name}: halves, pins drawn outwards, core and {held}")
    axes.plot([left + 4, left + 24], [bottom + 3] * 2, color="black", lw=2)
    axes.text(left + 14, bottom + 4, "20 mm", ha="center", va="bottom")
    figure.savefig(target, dpi=90)


if __name__ == "__main__":
    draw(load_spec(sys.argv[2]), Path(sys.argv[1]))
