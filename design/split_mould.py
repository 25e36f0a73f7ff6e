"""A mould in two halves with loose pins for bosses, so that nothing is torn when it opens.

The parting plane holds the direction in which silicone is poured; each half draws away along the
plane's normal, after the pins, each of which draws outwards along its own axis. By default the seam
of a box runs along two of its edges and every side wall leaves with plenty of draft; that of a round
body runs at its largest silhouette. Tapered dowels on the flanges find the halves, bolts or clamps
outside them hold them together; the plug of the one-piece mould, or the rod that holds the core,
clips onto the same tabs. Dowels and bolts take a flange of some length: a low mould gets it downwards.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.mould import fins_to_walls, walls
from design.mould_frame import MouldFrame, mould_frame, parting, play_mm
from design.mould_openings import mould_holes
from design.mould_pins import Pin, fixed_bosses, loose_pins, pin_holes
from design.mould_plug import CLIP_REACH_MM, rod_hole
from design.mould_room import cast_room
from design.solid_ops import Shape, Solid, common, cut, join, one_body
from design.solids import OVERSHOOT_MM, box_between
from design.spec import ObjectSpec

FLANGE_THICKNESS_MM = 4.0
FLANGE_LENGTH_MM = 26.0
"""At least: dowels and bolts lie at shares of it and must not meet."""
DOWEL_DIAMETER_MM = 4.0
DOWEL_HEIGHT_MM = 2.5
BOLT_HOLE_MM = 3.4
PLACES = (0.15, 0.42, 0.7, 0.9)
"""Of dowels and bolts by turns, as shares of the flange's length."""
LEAST_GAP_MM = 5.0
"""Between the middles of a dowel and a bolt."""


def make_mould_half(spec: ObjectSpec, side: int) -> Solid:
    """The half on the side (1 or −1) of the parting plane that its normal points to, mm.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    room, half_space = cast_room(spec), _half_space(spec, side)
    outer = join(walls(spec, room), cut(_flange(spec), room), *fins_to_walls(spec))
    half = cut(common(outer, half_space), *_holes(spec))
    dowels = [_dowel(spec, *place, grow_mm=0.0) for place in _dowel_places(spec)]
    sockets = [_dowel(spec, *place, grow_mm=play_mm(spec)) for place in _dowel_places(spec)]
    bossed = join(half, *fixed_bosses(spec, side))
    joined = join(bossed, *dowels) if side > 0 else cut(bossed, *sockets)
    return one_body(joined, "mould_half_a" if side > 0 else "mould_half_b")


def _holes(spec: ObjectSpec) -> list[cq.Solid]:
    """Of pins, bolts, pouring, vents and a rod."""
    pins = [hole for pin in loose_pins(spec) for hole in pin_holes(spec, pin)]
    rod = [rod_hole(spec)] if mould_frame(spec).opening == "bore" else []
    return [*pins, *_bolt_holes(spec), *rod, *(hole.solid() for hole in mould_holes(spec))]


def _parting_plane(spec: ObjectSpec) -> cq.Plane:
    """x across the mould in the parting plane, y along `out`, normal as the plane's."""
    plane = parting(spec)
    across = np.cross(mould_frame(spec).out, plane.normal)
    origin = cq.Vector(*(plane.offset_mm * plane.normal))
    return cq.Plane(origin, cq.Vector(*across), cq.Vector(*plane.normal))


def _in_plane(spec: ObjectSpec, low: list[float], high: list[float]) -> cq.Solid:
    """Box given across, along `out` and along the normal."""
    return box_between(low, high).moved(cq.Location(_parting_plane(spec)))


def _reach(spec: ObjectSpec) -> tuple[tuple[float, float], float, float]:
    """Ends of the block in the parting plane, across it, and of the flanges along `out`."""
    frame, plane = mould_frame(spec), parting(spec)
    across = frame.axes.T @ np.cross(frame.out, plane.normal)
    start = frame.axes.T @ (plane.offset_mm * plane.normal)
    ends = _line_in_block(frame, start, across)
    clips = CLIP_REACH_MM + 2 * play_mm(spec) if frame.plugged else 0.0
    top = frame.rim_mm - clips
    return ends, min(float(frame.low_mm[2]), top - FLANGE_LENGTH_MM), top


def _line_in_block(frame: MouldFrame, start: np.ndarray, way: np.ndarray) -> tuple[float, float]:
    """Where a line through the block, level and given along the axes, enters and leaves it."""
    steep = abs(way) > 1e-9
    crossings = np.stack(
        [(end - start)[steep] / way[steep] for end in (frame.low_mm, frame.high_mm)]
    )
    return float(crossings.min(axis=0).max()), float(crossings.max(axis=0).min())


def _flange(spec: ObjectSpec) -> cq.Solid:
    """Both halves' flanges along the seam, clear of the plug's clips."""
    (left, right), bottom, top = _reach(spec)
    wide, thick = spec.mould.flange_mm, FLANGE_THICKNESS_MM
    return _in_plane(spec, [left - wide, bottom, -thick], [right + wide, top, thick])


def _half_space(spec: ObjectSpec, side: int) -> cq.Solid:
    reach = 4 * max(spec.body.size_mm) + 4 * spec.mould.flange_mm
    low, high = (0.0, reach) if side > 0 else (-reach, 0.0)
    return _in_plane(spec, [-reach, -reach, low], [reach, reach, high])


def _dowel_places(spec: ObjectSpec) -> list[tuple[float, float]]:
    """Across the mould and along `out`, in the middle of both flanges."""
    return [place for index, place in enumerate(_flange_places(spec)) if not index % 2]


def _bolt_places(spec: ObjectSpec) -> list[tuple[float, float]]:
    return [place for index, place in enumerate(_flange_places(spec)) if index % 2]


def _flange_places(spec: ObjectSpec) -> list[tuple[float, float]]:
    """Dowels and bolts by turns, first on one flange, then on the other, out of the pins' way.

    Each stands at its share of the flange's length from its lower end, or as near as pins and those
    before it leave room; where there is none it stays, and the checks find it.
    """
    (left, right), bottom, top = _reach(spec)
    middle, pins = spec.mould.flange_mm / 2, loose_pins(spec)
    shifts = sorted(np.linspace(-0.85, 0.85, 69), key=abs)
    places: list[tuple[float, float]] = []
    for across in (left - middle, right + middle):
        for share in PLACES:
            levels = [bottom + (share + shift) * (top - bottom) for shift in shifts]
            inside = [z for z in levels if bottom + LEAST_GAP_MM / 2 <= z <= top - LEAST_GAP_MM / 2]
            clear = (z for z in inside if _is_clear(spec, pins, places, (across, z)))
            places.append((across, next(clear, levels[0])))
    return places


def _is_clear(
    spec: ObjectSpec,
    pins: list[Pin],
    taken: list[tuple[float, float]],
    place: tuple[float, float],
) -> bool:
    if any(np.hypot(*np.subtract(place, other)) < LEAST_GAP_MM for other in taken):
        return False
    frame, plane = mould_frame(spec), parting(spec)
    across, level = place
    point = across * np.cross(frame.out, plane.normal) + level * frame.out
    point = point + plane.offset_mm * plane.normal
    return all(
        _off_axis_mm(pin, point) > pin.radius_mm + pin.rim_mm + LEAST_GAP_MM / 2 for pin in pins
    )


def _off_axis_mm(pin: Pin, point_mm: np.ndarray) -> float:
    """Distance from the half-line along which a pin is drawn."""
    start = point_mm - pin.head_axis_mm[0]
    return float(np.linalg.norm(start - max(start @ pin.way, 0.0) * pin.way))


def _dowel(spec: ObjectSpec, across: float, level: float, grow_mm: float) -> Shape:
    """Cone from half A into half B, tapered by the draft."""
    root, height = DOWEL_DIAMETER_MM / 2 + grow_mm, DOWEL_HEIGHT_MM + grow_mm
    tip = root - height * float(np.tan(np.deg2rad(spec.mould.dowel_draft_deg)))
    start, along = cq.Vector(across, level, OVERSHOOT_MM), cq.Vector(0, 0, -1)
    stem = cq.Solid.makeCylinder(root, OVERSHOOT_MM, start, along)
    end = cq.Vector(across, level, 0)
    cone = (
        cq.Solid.makeCone(root, tip, height, end, along)
        if tip < root
        else cq.Solid.makeCylinder(root, height, end, along)
    )
    return stem.fuse(cone).moved(cq.Location(_parting_plane(spec)))


def _bolt_holes(spec: ObjectSpec) -> list[cq.Solid]:
    long, along = 2 * FLANGE_THICKNESS_MM + 2 * OVERSHOOT_MM, cq.Vector(0, 0, 1)
    return [
        cq.Solid.makeCylinder(
            BOLT_HOLE_MM / 2, long, cq.Vector(across, level, -long / 2), along
        ).moved(cq.Location(_parting_plane(spec)))
        for across, level in _bolt_places(spec)
    ]
