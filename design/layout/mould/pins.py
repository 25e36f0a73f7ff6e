"""Loose pins of a split mould as numbers: which pockets they form, where heads rest, what makes room.

A pin fills a pocket, goes through the mould and ends in a head that rests on a seat one wall above
the surface. On a body whose block is thicker than that the seat is sunk, and the head reaches out of
the block. Locating pins hold the core of a closed body: where a pocket lies over the wire hole the
pocket's pin is longer, elsewhere they have heads of their own.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.core_hold import Locator, locators
from design.layout.mould.closure import flange_span_mm
from design.layout.mould.frame import mould_frame, parting, thin_at_seam
from design.layout.pockets import Body, Outline, Pocket, near_pairs, shell_pockets
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from manifold3d import Manifold

    from design.spec.object import ObjectSpec

PIN_HEAD_MM = 2.0
PIN_HEAD_RIM_MM = 1.5
HEAD_STEP_MM = 1.0
"""Heads that reach out of a thick block come in lengths of this step, so that few kinds are printed."""
_SIDES = 64
_ALONG = 1 - 1e-9
_STEEP = 1e-6
_OUTSIDE = 0.01
"""Share of a head's height, down to which it is within the mould's block."""


@dataclass(frozen=True)
class Pin:
    """A pin by its pocket, in the flat frame that touches the body there; lengths in mm.

    The head rests at `seat_mm` above that frame and ends at `top_mm`; its rim is `rim_mm` wide. A
    locating pin has the outer half of its own hole for a pocket, and is one with the pins of pockets
    that it meets.
    """

    frame: FaceFrame
    pocket: Pocket
    seat_mm: float
    top_mm: float
    rim_mm: float
    locator: Locator | None = None

    @property
    def pockets(self) -> tuple[Pocket, ...]:
        """All that it fills."""
        return (self.pocket, *(() if self.locator is None else self.locator.pockets))

    @property
    def radius_mm(self) -> float:
        """Radius of a circle about its axis that holds all of it but the head's rim."""
        centre = self.pocket.body.centre_mm[:2]
        return max(
            float(np.linalg.norm(p.body.centre_mm[:2] - centre)) + p.outline.radius_mm
            for p in self.pockets
        )

    @property
    def way(self) -> Float[np.ndarray, "3"]:
        """Unit vector along which the pin is drawn."""
        return self.frame.axes @ self.pocket.axis

    @property
    def axis_mm(self) -> Float[np.ndarray, "2 3"]:
        """Ends of the pin's axis in the object's frame, from the pocket's floor to the head's top."""
        return self._axis_between_mm(float(self.pocket.axis_ends_mm[0, 2]), self.top_mm)

    @property
    def head_axis_mm(self) -> Float[np.ndarray, "2 3"]:
        """The same from the seat to the head's top."""
        return self._axis_between_mm(self.seat_mm, self.top_mm)

    @property
    def shank_axis_mm(self) -> Float[np.ndarray, "2 3"]:
        """The same from the surface to the seat."""
        return self._axis_between_mm(0.0, self.seat_mm)

    def room(self) -> Manifold:
        """Return what it takes from the surface of the silicone to its head's top."""
        return self.shank() + self.head()

    def shank(self) -> Manifold:
        """From the surface to the seat, without the draft that widens it."""
        return self._prisms(0.0, self.seat_mm, 0.0)

    def head(self) -> Manifold:
        """From the seat to the head's top, with its rim."""
        return self._prisms(self.seat_mm, self.top_mm, self.rim_mm)

    def _prisms(self, low_mm: float, high_mm: float, grow_mm: float) -> Manifold:
        from manifold3d import Manifold, OpType

        prisms = [self._prism(pocket, low_mm, high_mm, grow_mm) for pocket in self.pockets]
        return Manifold.batch_boolean(prisms, OpType.Add)

    def _prism(self, pocket: Pocket, low_mm: float, high_mm: float, grow_mm: float) -> Manifold:
        """Prism of a pocket's outline along its axis; planes parallel to the face end it."""
        from manifold3d import CrossSection

        frame, body, axis = self.frame, pocket.body, pocket.axis
        x, y = (half + grow_mm for half in pocket.outline.half_mm)
        outline = Outline((x, y), pocket.outline.round)
        past = outline.radius_mm * float(np.hypot(*axis[:2]))
        length = (high_mm - low_mm + 2 * past) / float(axis[2])
        start = body.centre_mm + (low_mm - past - body.centre_mm[2]) / axis[2] * axis
        pose = np.column_stack([frame.axes @ body.frame, frame.to_object(start)])
        prism = CrossSection([outline.corners_mm(_SIDES)]).extrude(length).transform(pose)
        normal, level = frame.normal, float(frame.centre_mm @ frame.normal)
        above = prism.trim_by_plane(tuple(normal), level + low_mm)
        return above.trim_by_plane(tuple(-normal), -(level + high_mm))

    def _axis_between_mm(self, *heights_mm: float) -> np.ndarray:
        floor, axis = self.pocket.axis_ends_mm[0], self.pocket.axis
        rise = (np.array(heights_mm)[:, None] - floor[2]) / axis[2]
        return self.frame.to_object(floor + rise * axis)


@cached_geometry
def loose_pins(spec: ObjectSpec) -> tuple[Pin, ...]:
    """Pins of pockets that do not point along the pull, face by face, then locating pins."""
    met = met_pockets(spec)
    pins = [
        pin_of(spec, frame, pocket)
        for frame, pocket in places_of_pockets(spec)
        if key_of_pocket(frame, pocket) not in met and not along_pull(spec, frame, pocket)
    ]
    pins += [_locating_pin(spec, locator) for locator in locators(spec)]
    rim = min(common_rim_mm(spec, pins), rim_below_clips_mm(spec, pins))
    return tuple(replace(pin, rim_mm=rim) for pin in pins)


def pins_thin_the_seam(spec: ObjectSpec) -> bool:
    """Return whether holes of pins, or of their heads, leave walls to the parting plane that are too thin."""
    return any(thin_at_seam(spec, axis, radius) for _, axis, radius in pin_holes(spec))


def pin_holes(spec: ObjectSpec) -> Iterator[tuple[Pin, Float[np.ndarray, "2 3"], float]]:
    """Axes and radii of the mould's holes for pins and for their heads, which have none where they rest on
    the outside of its block."""
    play = spec.printer.clearance_mm
    for pin in loose_pins(spec):
        for axis, rim in ((pin.shank_axis_mm, 0.0), (pin.head_axis_mm, pin.rim_mm)):
            axis_vector = axis[1] - axis[0]
            inside = exit_mm(spec, axis[0], pin.way) / float(np.linalg.norm(axis_vector))
            if inside > _OUTSIDE:
                ends = axis[0] + np.outer([0.0, min(inside, 1.0)], axis_vector)
                yield pin, ends, pin.radius_mm + rim + play


def pin_kinds(pins: Sequence[Pin]) -> list[tuple[str, int, int]]:
    """Name of each kind of pin, the index of its first, and how many are alike."""
    return [(name, members[0], len(members)) for name, members in pins_of_kinds(pins)]


def pins_of_kinds(pins: Sequence[Pin]) -> list[tuple[str, list[int]]]:
    """Name of each kind of pin, and the indices of its pins.

    Pins are alike where outline, depth and tilt of their pockets and the lengths of their heads are;
    locating pins are kinds of their own.
    """
    kinds: dict[tuple[float, ...], list[int]] = {}
    for index, pin in enumerate(pins):
        pocket, locator_number = pin.pocket, float(index) if pin.locator else -1.0
        shape = (
            *pocket.outline.half_mm,
            *pocket.axis_ends_mm[:, 2],
            *pocket.axis,
            pin.top_mm,
            locator_number,
        )
        kinds.setdefault(tuple(np.round(shape, 6)), []).append(index)
    plain = [members for members in kinds.values() if pins[members[0]].locator is None]
    held = [members for members in kinds.values() if pins[members[0]].locator is not None]
    names = ["mould_pin"] if len(plain) == 1 else [f"mould_pin_{n + 1}" for n in range(len(plain))]
    names += [f"mould_locator_{n + 1}" for n in range(len(held))]
    return list(zip(names, plain + held, strict=True))


@dataclass(frozen=True)
class PinKind:
    """Pins that are alike: their part's name, how many, and the pockets that they form.

    `places` holds face, x and y (mm, in the face's frame) of each pocket.
    """

    name: str
    count: int
    places: tuple[tuple[int, float, float], ...]
    holds_core: bool


def pins_by_kind(spec: ObjectSpec) -> list[PinKind]:
    """Return where every loose pin of a split mould goes, in the order of the parts."""
    pins = loose_pins(spec)
    kinds = []
    for name, members in pins_of_kinds(pins):
        places = [place for index in members for place in _places_of(pins[index])]
        held = pins[members[0]].locator is not None
        kinds.append(PinKind(name, len(members), tuple(places), held))
    return kinds


def _places_of(pin: Pin) -> list[tuple[int, float, float]]:
    """Face, x and y of the pockets that a pin forms, or of its own hole."""
    if pin.locator is not None and not pin.locator.pockets:
        face, x, y = pin.locator.place
        return [(face, round(x, 2) + 0.0, round(y, 2) + 0.0)]
    formed = pin.pockets if pin.locator is None else pin.locator.pockets
    places = [pocket.body.centre_mm for pocket in formed]
    return [(pin.frame.number, _rounded(centre[0]), _rounded(centre[1])) for centre in places]


def _rounded(value_mm: float) -> float:
    """Without a minus before zero."""
    return round(float(value_mm), 4) + 0.0


def places_of_pockets(spec: ObjectSpec) -> list[tuple[FaceFrame, Pocket]]:
    """Every pocket with the flat frame that touches the body there."""
    return [
        (frame.tangent(pocket.body.centre_mm[:2]), pocket)
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]


def met_pockets(spec: ObjectSpec) -> set[tuple[float, ...]]:
    """Pockets whose pins are one with a locating pin."""
    return {key_of_pocket(l.frame, pocket) for l in locators(spec) for pocket in l.pockets}


def key_of_pocket(frame: FaceFrame, pocket: Pocket) -> tuple[float, ...]:
    return (float(frame.number), *pocket.body.centre_mm.tolist())


def along_pull(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket) -> bool:
    return abs(float((frame.axes @ pocket.axis) @ parting(spec).normal)) > _ALONG


def pin_of(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket, rise: float = 0.0) -> Pin:
    """Its rim is left to `common_rim_mm`; by `rise` the surface rises next to it, per mm."""
    radius = pocket.outline.radius_mm + PIN_HEAD_RIM_MM
    seat = spec.mould.wall_mm + rise * radius
    rim = radius * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
    start = frame.to_object(rim + np.append(pocket.body.centre_mm[:2], 0.0))
    leaves = max(exit_mm(spec, point, frame.normal) for point in start)
    sunk = max(0.0, float(np.ceil((leaves - seat) / HEAD_STEP_MM - 1e-6)) * HEAD_STEP_MM)
    return Pin(frame, pocket, seat, seat + sunk + PIN_HEAD_MM, PIN_HEAD_RIM_MM)


def _locating_pin(spec: ObjectSpec, locator: Locator) -> Pin:
    """A pin whose pocket is the outer half of the hole that it leaves."""
    outline = Outline((locator.radius_mm, locator.radius_mm), True)
    depth = locator.depth_mm / 2
    body = Body(np.array([0.0, 0.0, -depth / 2]), np.eye(3), outline, depth, "a locating pin")
    frame = locator.frame.tangent(np.zeros(2))
    pin = pin_of(spec, frame, Pocket(body, outline), locator.rise_mm)
    return replace(pin, locator=locator)


def exit_mm(spec: ObjectSpec, start_mm: np.ndarray, way: np.ndarray) -> float:
    """Return how far a line goes until it leaves the mould's block; below 0 where it starts outside."""
    frame = mould_frame(spec)
    low, high = frame.corners(frame.low_mm, frame.high_mm)
    ends = np.where(way > 0, high, low)
    steep = abs(way) > 1e-9
    return float(np.min((ends - start_mm)[steep] / way[steep]))


def common_rim_mm(spec: ObjectSpec, pins: Sequence[Pin]) -> float:
    """Width of all heads' rims, narrower where pins stand close, and never below 0.

    A wall is left between the rooms of two heads; where that would take the rims away the rooms
    run together.
    """
    play, printer = spec.printer.clearance_mm, spec.printer
    # heads further apart than this leave all of the rim
    enough = PIN_HEAD_RIM_MM + play + printer.wall_mm
    near = near_pairs([pin.head_axis_mm for pin in pins], [pin.radius_mm + enough for pin in pins])
    gaps = [
        away - pins[index_a].radius_mm - pins[index_b].radius_mm for index_a, index_b, away in near
    ]
    gap = min(gaps, default=np.inf)
    walled, merged = (gap - 2 * play - printer.wall_mm) / 2, (gap - play) / 2
    room = walled if walled >= least_rim_mm(spec) else merged
    return float(np.clip(room, 0.0, PIN_HEAD_RIM_MM))


def rim_below_clips_mm(spec: ObjectSpec, pins: Sequence[Pin]) -> float:
    """Width of rims that stay below the clips of a plug's flange, which end at the mould's rim.

    Of heads on the outside of the walls that the clips reach over; never below 0.
    """
    frame = mould_frame(spec)
    if not frame.plugged:
        return PIN_HEAD_RIM_MM
    ends = flange_span_mm(spec)
    room = PIN_HEAD_RIM_MM
    for pin in pins:
        seat, top = pin.head_axis_mm @ frame.axes
        beside = pin.radius_mm + PIN_HEAD_RIM_MM + spec.printer.clearance_mm
        if abs(top[1]) > frame.high_mm[1] and ends[0] - beside < top[0] < ends[1] + beside:
            way = (top - seat) / np.linalg.norm(top - seat)
            rise = float(np.sqrt(max(1 - way[2] ** 2, _STEEP)))
            level = float(max(top[2], _leaving(seat, top, float(frame.high_mm[1]))[2]))
            room = min(
                room, (frame.rim_mm - spec.printer.clearance_mm - level) / rise - pin.radius_mm
            )
    return max(room, 0.0)


def _leaving(seat: np.ndarray, top: np.ndarray, wall_mm: float) -> np.ndarray:
    """Return where a head's axis comes out of a wall along the mould; its seat, where that is outside."""
    inside = wall_mm - abs(seat[1])
    return seat if inside <= 0 else seat + inside / (abs(top[1]) - abs(seat[1])) * (top - seat)


def least_rim_mm(spec: ObjectSpec) -> float:
    """Least rim of a pin's head: half of the printer's thinnest wall."""
    return spec.printer.wall_mm / 2
