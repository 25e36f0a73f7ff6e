"""A mould in two halves with loose pins for bosses, so that nothing is torn when it opens.

The parting plane holds the direction in which silicone is poured; each half draws away along the
plane's normal, after the pins, each of which draws outwards along its own axis. By default the seam
of a box runs along two of its edges and every side wall leaves with plenty of draft; that of a round
body runs at its largest silhouette. Tapered dowels on the flanges find the halves, bolts or clamps
outside them hold them together; the plug of the one-piece mould, or the rod that holds the core,
clips onto the same tabs. Dowels and bolts take a flange of some length: a low mould gets it downwards.
"""

from __future__ import annotations

import numpy as np

from design.layout.mould.frame import (
    BOLT_HOLE_MM,
    DOWEL_DIAMETER_MM,
    FLANGE_THICKNESS_MM,
    flange_width_mm,
    mould_frame,
    parting,
)
from design.layout.mould.pins import Pin, loose_pins
from design.layout.mould.pouring import Hole
from design.mould.flange import Flange, flanges, roots_mm
from design.mould.openings import hole_solid, mould_holes, seal_holes
from design.mould.pins import fixed_bosses, pin_holes
from design.mould.plug import rod_hole
from design.mould.room import cast_room, finished_room
from design.mould.walls import block, fins_to_walls, walls
from design.solids.booleans import (
    Shape,
    Solid,
    common,
    cut,
    join,
    one_body,
    pieces_that_meet,
    without_offcuts,
)
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, tapered_rod
from design.spec.object import ObjectSpec

DOWEL_DRAFT_DEG = 10.0
"""Dowels find their holes from 0.4 mm off and come out again without force."""
DOWEL_HEIGHT_MM = 2.5
_OFFCUT = 1e-3
"""Share of a half below which a piece that its holes cut off is left out: 1.6 of 75 000 mm³ between a
rod and a vent made a half that was refused."""


def make_mould_half(spec: ObjectSpec, side: int) -> Solid:
    """The half on the side (1 or −1) of the parting plane that its normal points to, mm.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    walled = walls(spec, cast_room(spec), spec.shell.seal_layer_mm)
    holes = _holes(spec, loose_pins(spec), mould_holes(spec))
    half = _half(spec, side, cast_room(spec), walled, holes)
    bossed = join(half, *fixed_bosses(spec, side))
    return one_body(
        _with_dowels(spec, side, bossed), "mould_half_a" if side > 0 else "mould_half_b"
    )


def make_seal_half(spec: ObjectSpec, side: int) -> Solid:
    """The same of the second pour, of a body whose core is cast in: no bosses, and the pins that hold
    the core alone.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    room = finished_room(spec)
    pins = tuple(pin for pin in loose_pins(spec) if pin.locator is not None)
    half = _half(spec, side, room, walls(spec, room), _holes(spec, pins, seal_holes(spec)))
    name = "mould_seal_half_a" if side > 0 else "mould_seal_half_b"
    return one_body(_with_dowels(spec, side, half), name)


def _half(spec: ObjectSpec, side: int, room: Shape, walled: Shape, holes: list[cq.Solid]) -> Shape:
    """Walls and flanges on one side of the parting plane, less holes, with the fins of slits."""
    ends = flanges(spec)
    outer = join(walled, cut(flange_solid(spec, *ends), room))
    half_space, fins = _half_space(spec, side), fins_to_walls(spec)
    half = cut(common(outer, half_space), *holes, *bolt_holes(spec, *ends))
    half = pieces_that_meet(half, block(spec))  # holes may cut off an end of a flange
    half = without_offcuts(half, _OFFCUT)  # or a sliver between them
    return join(half, *(common(fin, half_space) for fin in fins))  # whole: vents may meet them


def _with_dowels(spec: ObjectSpec, side: int, half: Shape) -> Shape:
    grown, ends = 0.0 if side > 0 else spec.printer.clearance_mm, flanges(spec)
    dowels = [dowel_solid(spec, *place, grown) for end in ends for place in end.places_mm[::2]]
    return join(half, *dowels) if side > 0 else cut(half, *dowels)


def _holes(spec: ObjectSpec, pins: tuple[Pin, ...], holes: tuple[Hole, ...]) -> list[cq.Solid]:
    """Solids of the holes of pins, pouring, vents and a rod."""
    through = [hole for pin in pins for hole in pin_holes(spec, pin)]
    rod = [rod_hole(spec)] if mould_frame(spec).opening == "bore" else []
    return [*through, *rod, *(hole_solid(hole) for hole in holes)]


def _parting_plane(spec: ObjectSpec) -> cq.Plane:
    """x across the mould in the parting plane, y along `out`, normal as the plane's."""
    plane = parting(spec)
    across = np.cross(mould_frame(spec).out, plane.normal)
    origin = cq.Vector(*(plane.offset_mm * plane.normal))
    return cq.Plane(origin, cq.Vector(*across), cq.Vector(*plane.normal))


def _box_in_plane(spec: ObjectSpec, low: list[float], high: list[float]) -> cq.Solid:
    """Box given across, along `out` and along the normal."""
    return box_between(low, high).moved(cq.Location(_parting_plane(spec)))


def flange_solid(spec: ObjectSpec, first: Flange, second: Flange) -> Shape:
    """Both halves' flanges along the seam, notched for pins; below the block there are two strips."""
    thick, block = FLANGE_THICKNESS_MM, float(mould_frame(spec).low_mm[2])
    slab = _box_in_plane(spec, [first.low_mm, block, -thick], [second.high_mm, first.top_mm, thick])
    strips = [
        _box_in_plane(
            spec, [side.low_mm, side.bottom_mm, -thick], [side.high_mm, block + 1.0, thick]
        )
        for side in (first, second)
        if side.bottom_mm < block
    ]
    past, (left, right) = thick + 1.0, roots_mm(spec)
    notches = [
        _box_in_plane(spec, [first.low_mm - 1.0, start, -past], [left, end, past])
        for start, end in first.notches
    ]
    notches += [
        _box_in_plane(spec, [right, start, -past], [second.high_mm + 1.0, end, past])
        for start, end in second.notches
    ]
    return cut(join(slab, *strips), *notches)


def _half_space(spec: ObjectSpec, side: int) -> cq.Solid:
    reach = 4 * max(spec.body.size_mm) + 4 * flange_width_mm(spec)
    low, high = (0.0, reach) if side > 0 else (-reach, 0.0)
    return _box_in_plane(spec, [-reach, -reach, low], [reach, reach, high])


def dowel_solid(spec: ObjectSpec, across: float, level: float, grow_mm: float) -> Shape:
    """Cone from half A into half B, tapered by the draft."""
    root, height = DOWEL_DIAMETER_MM / 2 + grow_mm, DOWEL_HEIGHT_MM + grow_mm
    tip = root - height * float(np.tan(np.deg2rad(DOWEL_DRAFT_DEG)))
    stem = tapered_rod(cq.Vector(across, level, OVERSHOOT_MM), cq.Vector(0, 0, -OVERSHOOT_MM), root)
    cone = tapered_rod(cq.Vector(across, level, 0), cq.Vector(0, 0, -height), root, tip)
    return stem.fuse(cone).moved(cq.Location(_parting_plane(spec)))


def bolt_holes(spec: ObjectSpec, *ends: Flange) -> list[cq.Solid]:
    long, axis = 2 * FLANGE_THICKNESS_MM + 2 * OVERSHOOT_MM, cq.Vector(0, 0, 1)
    return [
        cq.Solid.makeCylinder(
            BOLT_HOLE_MM / 2, long, cq.Vector(across, level, -long / 2), axis
        ).moved(cq.Location(_parting_plane(spec)))
        for end in ends
        for across, level in end.places_mm[1::2]
    ]
