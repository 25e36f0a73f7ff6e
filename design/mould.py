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
folds inwards.
"""

from __future__ import annotations

from dataclasses import dataclass

import cadquery as cq
import numpy as np

from design.shell import cavity_block, envelope, pocket_prisms
from design.solids import OVERSHOOT_MM, box_between, single_solid
from design.spec import ObjectSpec


@dataclass(frozen=True)
class MouldDimensions:
    """Dimensions of the mould that do not follow from the object, mm.

    The flange overlaps the shell's rim by `flange_overlap_mm`, but at most by a quarter of the
    shell's thickness, so that thin shells keep room to pour.
    """

    wall_mm: float = 1.5
    tab_height_mm: float = 4.0
    play_mm: float = 0.1
    flange_overlap_mm: float = 2.0
    plate_mm: float = 3.0
    clip_mm: float = 2.5
    clip_reach_mm: float = 4.0
    grip_height_mm: float = 3.0
    grip_width_mm: float = 10.3


def make_mould_box(spec: ObjectSpec, dimensions: MouldDimensions | None = None) -> cq.Solid:
    """Outer box in the object's frame (mm), open towards −z, bosses reaching into the pockets.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    d = dimensions or MouldDimensions()
    half = np.asarray(spec.body.size_mm) / 2
    outer = half + d.wall_mm
    block = box_between((-outer[0], -outer[1], -half[2]), outer)
    room = box_between((-half[0], -half[1], -half[2] - OVERSHOOT_MM), half)
    bosses = pocket_prisms(spec)
    return single_solid(block.cut(room).fuse(*bosses, *_tabs(spec, d)), "mould_box")


def make_mould_plug(spec: ObjectSpec, dimensions: MouldDimensions | None = None) -> cq.Solid:
    """Inner plug in the object's frame (mm): the cavity's block, flange, clips and grip at −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    d = dimensions or MouldDimensions()
    pieces = (*_flange(spec, d), *_clips(spec, d))
    return single_solid(cavity_block(spec).fuse(*pieces), "mould_plug")


def cast_cavity(spec: ObjectSpec, dimensions: MouldDimensions | None = None) -> cq.Shape:
    """What silicone fills between the assembled box and plug within the body's envelope."""
    return envelope(spec).cut(make_mould_box(spec, dimensions), make_mould_plug(spec, dimensions))


def _flange_half_width(spec: ObjectSpec, d: MouldDimensions) -> float:
    return spec.core_size_mm[0] / 2 + min(d.flange_overlap_mm, spec.shell.thickness_mm / 4)


def _tabs(spec: ObjectSpec, d: MouldDimensions) -> list[cq.Solid]:
    """Two tabs that continue the ±y walls beyond the open face; they hold the plug in place."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width = _flange_half_width(spec, d) - d.play_mm
    low = np.array([-half_width, half_y, -half_z - d.tab_height_mm])
    high = np.array([half_width, half_y + d.wall_mm, -half_z + OVERSHOOT_MM])
    return [box_between(low, high), _mirrored_in_y(low, high)]


def _flange(spec: ObjectSpec, d: MouldDimensions) -> list[cq.Solid]:
    """Bridge between the tabs, plate on the tabs and grip, stacked outwards from the open face."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width = _flange_half_width(spec, d)
    half_lengths = (half_y - d.play_mm, half_y + d.wall_mm + d.clip_mm, spec.core_size_mm[1] / 2)
    half_widths = (half_width, half_width, min(d.grip_width_mm / 2, half_width))
    levels = -half_z - np.cumsum([0.0, d.tab_height_mm, d.plate_mm, d.grip_height_mm])
    return [
        box_between((-x, -y, bottom), (x, y, top))
        for x, y, top, bottom in zip(
            half_widths, half_lengths, levels[:-1], levels[1:], strict=True
        )
    ]


def _clips(spec: ObjectSpec, d: MouldDimensions) -> list[cq.Solid]:
    """Two arms that hang from the plate outside the ±y walls and reach below the rim."""
    _, half_y, half_z = np.asarray(spec.body.size_mm) / 2
    half_width, wall = _flange_half_width(spec, d), half_y + d.wall_mm
    plate_middle = -half_z - d.tab_height_mm - d.plate_mm / 2
    low = np.array([-half_width, wall + d.play_mm, plate_middle])
    high = np.array([half_width, wall + d.clip_mm, -half_z + d.clip_reach_mm])
    return [box_between(low, high), _mirrored_in_y(low, high)]


def _mirrored_in_y(low: np.ndarray, high: np.ndarray) -> cq.Solid:
    return box_between((low[0], -high[1], low[2]), (high[0], -low[1], high[2]))
