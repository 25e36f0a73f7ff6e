"""Bosses of a split mould: loose pins, drawn along their own axes, or fixed where the pull allows.

A pin fills a pocket, goes through the mould and ends in a head that rests on a seat one wall above
the surface. On a body whose block is thicker than that the seat is sunk, and the head reaches out of
the block. Locating pins hold the core of a closed body: where a pocket lies over the wire hole the
pocket's pin is longer, elsewhere they have heads of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import cadquery as cq
import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.core_hold import LOCATOR_NOSE_MM, Locator, locators
from design.layout.mould_frame import mould_frame, parting, play_mm, thin_at_seam
from design.layout.pockets import Body, Outline, Pocket, distance_of_segments_mm, shell_pockets
from design.mould.plug_flange import flange_span_mm
from design.mould.room import core_outside
from design.solids.booleans import Shape, Solid, cut, join, one_body
from design.solids.primitives import OVERSHOOT_MM, cylinder_on_face, pocket_prism, pocket_solid
from design.spec.object import ObjectSpec
from design.spec.worked_out import once

PIN_HEAD_MM = 2.0
PIN_HEAD_RIM_MM = 1.5
HEAD_STEP_MM = 1.0
"""Heads that reach out of a thick block come in lengths of this step, so that few kinds are printed."""
_ALONG = 1 - 1e-9


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
        """Of a circle about its axis that holds all of it but the head's rim."""
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

    def _axis_between_mm(self, *heights_mm: float) -> np.ndarray:
        floor, axis = self.pocket.axis_ends_mm[0], self.pocket.axis
        rise = (np.array(heights_mm)[:, None] - floor[2]) / axis[2]
        return self.frame.to_object(floor + rise * axis)


@once
def loose_pins(spec: ObjectSpec) -> tuple[Pin, ...]:
    """Pins of pockets that do not point along the pull, face by face, then locating pins."""
    met = _met(spec)
    pins = [
        _pin(spec, frame, pocket)
        for frame, pocket in _places(spec)
        if _key(frame, pocket) not in met and not _along_pull(spec, frame, pocket)
    ]
    pins += [_locating_pin(spec, locator) for locator in locators(spec)]
    rim = min(_rim_mm(spec, pins), _below_rim_mm(spec, pins))
    return tuple(replace(pin, rim_mm=rim) for pin in pins)


def pins_thin_the_seam(spec: ObjectSpec) -> bool:
    """Whether holes of pins, or of their heads, leave walls to the parting plane that are too thin."""
    play = play_mm(spec)
    return any(
        thin_at_seam(spec, axis, pin.radius_mm + play + rim)
        for pin in loose_pins(spec)
        for axis, rim in ((pin.shank_axis_mm, 0.0), (pin.head_axis_mm, pin.rim_mm))
    )


def fixed_bosses(spec: ObjectSpec, side: int) -> list[cq.Solid]:
    """Bosses that stay on the half at that side (1, −1) of the parting plane."""
    met, normal = _met(spec), parting(spec).normal
    return [
        pocket_solid(frame, pocket)
        for frame, pocket in _places(spec)
        if _key(frame, pocket) not in met
        and _along_pull(spec, frame, pocket)
        and side * float((frame.axes @ pocket.axis) @ normal) > 0
    ]


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
        pocket, own = pin.pocket, float(index) if pin.locator else -1.0
        shape = (*pocket.outline.half_mm, *pocket.axis_ends_mm[:, 2], *pocket.axis, pin.top_mm, own)
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
    """Where every loose pin of a split mould goes, in the order of the parts."""
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
    return [(pin.frame.number, _rounded(at[0]), _rounded(at[1])) for at in places]


def _rounded(value_mm: float) -> float:
    """Without a minus before zero."""
    return round(float(value_mm), 4) + 0.0


def make_pin(spec: ObjectSpec, pin: Pin) -> Solid:
    """Boss, shank through the wall, head, and the nose of a locating pin, in the object's frame.

    Raises
    ------
    InputError
        The pin is not one valid solid.
    """
    seat, draft, solids = pin.seat_mm, spec.mould.draft_deg, []
    for pocket in pin.pockets:
        solids.append(pocket_prism(pin.frame, pocket, None, seat + OVERSHOOT_MM))
        solids.append(pocket_prism(pin.frame, pocket, seat, pin.top_mm, pin.rim_mm))
        if draft and pocket.axis[2] == 1:
            solids.append(pocket_prism(pin.frame, pocket, 0.0, seat + OVERSHOOT_MM, 0.0, draft))
    body: Shape = join(*solids)
    if pin.locator is not None:
        rod, nose = _rod_and_nose(spec, pin.locator)
        body = join(cut(join(body, rod), core_outside(spec)), nose)
    return one_body(body, "mould_pin")


def pin_holes(spec: ObjectSpec, pin: Pin) -> list[cq.Solid]:
    """Hole through the wall, and room for the head all the way out."""
    play, draft, seat = play_mm(spec), spec.mould.draft_deg, pin.seat_mm
    out = 2 * max(spec.body.size_mm) + spec.mould.flange_mm
    holes = []
    for pocket in pin.pockets:
        holes.append(pocket_prism(pin.frame, pocket, None, seat + OVERSHOOT_MM, play))
        holes.append(pocket_prism(pin.frame, pocket, seat, out, pin.rim_mm + play))
        if draft and pocket.axis[2] == 1:
            holes.append(pocket_prism(pin.frame, pocket, 0.0, seat + OVERSHOOT_MM, play, draft))
    return holes


def _places(spec: ObjectSpec) -> list[tuple[FaceFrame, Pocket]]:
    """Every pocket with the flat frame that touches the body there."""
    return [
        (frame.tangent(pocket.body.centre_mm[:2]), pocket)
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]


def _met(spec: ObjectSpec) -> set[tuple[float, ...]]:
    """Pockets whose pins are one with a locating pin."""
    return {_key(l.frame, pocket) for l in locators(spec) for pocket in l.pockets}


def _key(frame: FaceFrame, pocket: Pocket) -> tuple[float, ...]:
    return (float(frame.number), *pocket.body.centre_mm.tolist())


def _along_pull(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket) -> bool:
    return abs(float((frame.axes @ pocket.axis) @ parting(spec).normal)) > _ALONG


def _pin(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket, rise: float = 0.0) -> Pin:
    """Its rim is left to `_rim_mm`; by `rise` the surface rises beside it, per mm."""
    radius = pocket.outline.radius_mm + PIN_HEAD_RIM_MM
    seat = spec.mould.wall_mm + rise * radius
    rim = radius * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0]])
    start = frame.to_object(rim + np.append(pocket.body.centre_mm[:2], 0.0))
    leaves = max(_exit_mm(spec, point, frame.normal) for point in start)
    sunk = max(0.0, float(np.ceil((leaves - seat) / HEAD_STEP_MM - 1e-6)) * HEAD_STEP_MM)
    return Pin(frame, pocket, seat, seat + sunk + PIN_HEAD_MM, PIN_HEAD_RIM_MM)


def _locating_pin(spec: ObjectSpec, locator: Locator) -> Pin:
    """A pin whose pocket is the outer half of the hole that it leaves."""
    outline = Outline((locator.radius_mm, locator.radius_mm), True)
    depth = locator.depth_mm / 2
    body = Body(np.array([0.0, 0.0, -depth / 2]), np.eye(3), outline, depth, "a locating pin")
    frame = locator.frame.tangent(np.zeros(2))
    pin = _pin(spec, frame, Pocket(body, outline), locator.rise_mm)
    return replace(pin, locator=locator)


def _exit_mm(spec: ObjectSpec, start_mm: np.ndarray, way: np.ndarray) -> float:
    """How far a line goes until it leaves the mould's block; below 0 where it starts outside."""
    frame = mould_frame(spec)
    low, high = frame.corners(frame.low_mm, frame.high_mm)
    ends = np.where(way > 0, high, low)
    steep = abs(way) > 1e-9
    return float(np.min((ends - start_mm)[steep] / way[steep]))


def _rim_mm(spec: ObjectSpec, pins: Sequence[Pin]) -> float:
    """Width of all heads' rims, narrower where pins stand close, and never below 0.

    A wall is left between the rooms of two heads; where that would take the rims away the rooms
    run together.
    """
    gaps = [
        distance_of_segments_mm(a.head_axis_mm, b.head_axis_mm) - a.radius_mm - b.radius_mm
        for a, b in combinations(pins, 2)
    ]
    gap, play, printer = min(gaps, default=np.inf), play_mm(spec), spec.printer
    walled, merged = (gap - 2 * play - printer.wall_mm) / 2, (gap - play) / 2
    room = walled if walled >= least_rim_mm(spec) else merged
    return float(np.clip(room, 0.0, PIN_HEAD_RIM_MM))


def _below_rim_mm(spec: ObjectSpec, pins: Sequence[Pin]) -> float:
    """Width of rims that stay below the clips of a plug's flange, which end at the mould's rim.

    Of heads on the outside of the walls that the clips reach over; never below 0.
    """
    frame = mould_frame(spec)
    if not frame.plugged:
        return PIN_HEAD_RIM_MM
    ends = flange_span_mm(spec)
    room = PIN_HEAD_RIM_MM
    for pin in pins:
        across, along, out = frame.axes.T @ pin.head_axis_mm[1]
        beside = pin.radius_mm + PIN_HEAD_RIM_MM + play_mm(spec)
        if abs(along) > frame.high_mm[1] and ends[0] - beside < across < ends[1] + beside:
            room = min(room, frame.rim_mm - play_mm(spec) - float(out) - pin.radius_mm)
    return max(room, 0.0)


def least_rim_mm(spec: ObjectSpec) -> float:
    """Of a pin's head: half of the printer's smallest feature."""
    return spec.printer.feature_mm / 2


def _rod_and_nose(spec: ObjectSpec, locator: Locator) -> tuple[cq.Solid, cq.Solid]:
    """Through the silicone into the core, which is to be cut off the rod; into the core's hole."""
    depth, middle = locator.depth_mm, (0.0, 0.0)
    start = -depth - OVERSHOOT_MM - locator.radius_mm * locator.rise_mm
    rod = cylinder_on_face(locator.frame, middle, locator.radius_mm, start, -depth / 4)
    tip = depth + min(LOCATOR_NOSE_MM, 0.8 * locator.hole_mm)
    narrow = locator.radius_mm - play_mm(spec)
    sunk = OVERSHOOT_MM / 2
    nose = cylinder_on_face(locator.frame, middle, narrow, -tip, -depth + sunk)
    return rod, nose
