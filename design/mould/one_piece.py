"""The mould in one piece: a box with integral bosses that its plug closes.

The paper's box (Knopke et al., RA-L 2024), 45 × 45 × 47.5 mm and 16 477.68 mm³: the body's 42 mm cube
within 1.5 mm walls on the five sensed faces is 45 × 45 × 43.5 mm and, with its 25 bosses,
45·45·43.5 − 42³ + 25·π·9·3 = 16 120.08 mm³; what the end walls are raised by for the plug
(`design/mould/plug_flange.py`) is 2 · 1.5 · (2 · 30.4 + 4 · 2 · 7.3) = 357.6 mm³. The open side is where
the silicone is poured in, next to the plug's flange.

No part has draft. The side bosses are undercuts: the plug comes out first, then the soft wall
folds inwards. `design/mould/halves.py` makes the same cavity from halves that draw apart.
"""

from __future__ import annotations

from design.mould.openings import hole_solid, mould_holes
from design.mould.room import cast_room
from design.mould.walls import fins_to_walls, walls
from design.solids.body import outer_solid
from design.solids.booleans import Solid, cut, join, one_body
from design.solids.shell import pocket_prisms
from design.spec.object import ObjectSpec


def make_mould_box(spec: ObjectSpec) -> Solid:
    """Outer box in the object's frame (mm), open on one side, with bosses and the slits' fins.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    inside = [*pocket_prisms(spec), *fins_to_walls(spec)]
    box = join(walls(spec, cast_room(spec), spec.shell.seal_layer_mm), *inside)
    return one_body(cut(box, *(hole_solid(hole) for hole in mould_holes(spec))), "mould_box")


def make_seal_mould(spec: ObjectSpec) -> Solid:
    """Box of the second pour, without bosses: the shell (on its plug, where it has one) gets its seal
    layer in it.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    return one_body(join(walls(spec, outer_solid(spec)), *fins_to_walls(spec)), "mould_seal_box")
