"""The two-part mould: an outer box with integral bosses, and an inner plug that clips onto it.

The dimensions that the specification leaves open are fixed here, for the paper's cube, by the
bounding boxes and volumes of the authors' public parts (Knopke et al., RA-L 2024).

Box, 45 × 45 × 47.5 mm and 16 477.68 mm³: the body's 42 mm cube within 1.5 mm walls on the five
sensed faces is 45 × 45 × 43.5 mm and, with its 25 bosses, 45·45·43.5 − 42³ + 25·π·9·3 =
16 120.08 mm³. The 4 mm of height and 357.60 mm³ left over are too little for a closed rim (1044)
but are exactly two tabs of the wall's thickness, 29.8 mm wide: 2 · 29.8 · 4 · 1.5 = 357.6. The
open face is where the silicone is poured in, beside the plug's flange.

Plug, 30 × 50 × 44 mm and 34 454.65 mm³: the cavity's 26 × 26 × 34 block (22 984 mm³) and 10 mm of
flange outside the body. The flange is 30 mm wide (the tabs with 0.1 mm of play on both sides, 2 mm
over the plug's edge), which leaves two pouring slots of 6 × 42 mm. It is 50 mm long: two clips of
2.5 mm over the box's 45 mm. Chosen within that: a bridge between the tabs (30 × 41.8 × 4), a plate
resting on the tabs (30 × 50 × 3), clips that reach 4 mm below the rim (2 of 30 × 2.4 × 8). A grip
26 mm long and 3 mm high fills the height, and the volume left over makes it 10.3 mm wide.

No part has draft. The side bosses are undercuts: the plug comes out first, then the soft wall
folds inwards. `design/split_mould.py` makes the same cavity from halves that draw apart.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.shell import cast_envelope, cavity, envelope, pocket_prisms, slit_fins
from design.solids import OVERSHOOT_MM, box_between, single_solid
from design.spec import ObjectSpec

TAB_HEIGHT_MM = 4.0
FLANGE_OVERLAP_MM = 2.0
"""Of the flange over the shell's rim, but at most a quarter of the shell's thickness, so that thin
shells keep room to pour."""
PLATE_MM = 3.0
CLIP_MM = 2.5
CLIP_REACH_MM = 4.0
GRIP_HEIGHT_MM = 3.0
GRIP_WIDTH_MM = 10.3


def play_mm(spec: ObjectSpec) -> float:
    """Gap between parts of the mould that slide: `moulplay_mm(spec)`, else the printer's clearance."""
    given = spec.mould.play_mm
    return spec.printer.clearance_mm if given is None else given


def make_mould_box(spec: ObjectSpec) -> cq.Solid:
    """Outer box in the object's frame (mm), open towards −z, with bosses and the slits' fins.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    room = cast_envelope(spec)
    inside = [*pocket_prisms(spec), *fins_to_walls(spec)]
    return single_solid(walls(spec, room).fuse(*inside), "mould_box")


def make_seal_mould(spec: ObjectSpec) -> cq.Solid:
    """Box of the second pour, without bosses: the shell on its plug gets its seal layer in it.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    box = walls(spec, envelope(spec))
    fins = fins_to_walls(spec)
    return single_solid(box.fuse(*fins) if fins else box, "mould_seal_box")


def walls(spec: ObjectSpec, room: cq.Solid) -> cq.Shape:
    """The mould's walls and tabs round a room that is open towards −z, without bosses."""
    half = np.asarray(spec.body.size_mm) / 2
    outer = half + spec.mould.wall_mm
    block = box_between((-outer[0], -outer[1], -half[2]), outer)
    low = room.BoundingBox()
    mouth = box_between(
        (low.xmin, low.ymin, low.zmin - OVERSHOOT_MM), (low.xmax, low.ymax, low.zmin + OVERSHOOT_MM)
    )
    return block.cut(room, mouth).fuse(*_tabs(spec))


def fins_to_walls(spec: ObjectSpec) -> list[cq.Shape]:
    """Fins of the relief slits, from the walls inwards, down to the open face."""
    half = np.asarray(spec.body.size_mm) / 2
    outer = half + spec.mould.wall_mm
    block = box_between((-outer[0], -outer[1], -half[2]), outer)
    return [fin.intersect(block) for fin in slit_fins(spec)]


def make_mould_plug(spec: ObjectSpec) -> cq.Solid:
    """Inner plug in the object's frame (mm): what the core fills, flange, clips and grip at −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    block, *keys = cavity(spec)
    return single_solid(block.fuse(*keys, *_flange(spec), *_clips(spec)), "mould_plug")


def cast_cavity(spec: ObjectSpec) -> cq.Shape:
    """What silicone fills between the assembled mould and plug within the first pour's envelope."""
    return cast_envelope(spec).cut(*mould_around(spec), make_mould_plug(spec))


def mould_around(spec: ObjectSpec) -> list[cq.Solid]:
    """Everything that closes round the shell from outside: the box, or halves and pins."""
    if spec.mould.style == "one-piece":
        return [make_mould_box(spec)]
    from design.split_mould import make_mould_half, mould_pins

    return [make_mould_half(spec, 1), make_mould_half(spec, -1), *mould_pins(spec)]


def has_mould(spec: ObjectSpec) -> bool:
    """Whether moulds are made for the body: boxes that are open towards −z alone."""
    return spec.body.kind == "box" and spec.body.opened == (6,)


def pour_width_mm(spec: ObjectSpec) -> float:
    """Width of the two slots that the plug's flange leaves open beside it."""
    return spec.body.size_mm[0] / 2 - _flange_half_width(spec)


def _flange_half_width(spec: ObjectSpec) -> float:
    return spec.core_size_mm[0] / 2 + min(FLANGE_OVERLAP_MM, spec.shell.thickness_mm / 4)


def _tabs(spec: ObjectSpec) -> list[cq.Solid]:
    """Two tabs that continue the ±y walls beyond the open face; they hold the plug in place."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width = _flange_half_width(spec) - play_mm(spec)
    low = np.array([-half_width, half_y, -half_z - TAB_HEIGHT_MM])
    high = np.array([half_width, half_y + spec.mould.wall_mm, -half_z + OVERSHOOT_MM])
    return [box_between(low, high), _mirrored_in_y(low, high)]


def _flange(spec: ObjectSpec) -> list[cq.Solid]:
    """Bridge between the tabs, plate on the tabs and grip, stacked outwards from the open face."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width = _flange_half_width(spec)
    half_lengths = (
        half_y - play_mm(spec),
        half_y + spec.mould.wall_mm + CLIP_MM,
        spec.core_size_mm[1] / 2,
    )
    half_widths = (half_width, half_width, min(GRIP_WIDTH_MM / 2, half_width))
    levels = -half_z - np.cumsum([0.0, TAB_HEIGHT_MM, PLATE_MM, GRIP_HEIGHT_MM])
    return [
        box_between((-x, -y, bottom), (x, y, top))
        for x, y, top, bottom in zip(
            half_widths, half_lengths, levels[:-1], levels[1:], strict=True
        )
    ]


def _clips(spec: ObjectSpec) -> list[cq.Solid]:
    """Two arms that hang from the plate outside the ±y walls and reach below the rim."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width, wall = _flange_half_width(spec), half_y + spec.mould.wall_mm
    plate_middle = -half_z - TAB_HEIGHT_MM - PLATE_MM / 2
    low = np.array([-half_width, wall + play_mm(spec), plate_middle])
    high = np.array([half_width, wall + CLIP_MM, -half_z + CLIP_REACH_MM])
    return [box_between(low, high), _mirrored_in_y(low, high)]


def _mirrored_in_y(low: np.ndarray, high: np.ndarray) -> cq.Solid:
    return box_between((low[0], -high[1], low[2]), (high[0], -low[1], high[2]))
