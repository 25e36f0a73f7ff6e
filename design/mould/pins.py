"""Bosses of a split mould as solids: loose pins, or fixed where the pull allows.

Loose ones are drawn along their own axes; their numbers are those of `design.layout.mould.pins`.
"""

from __future__ import annotations

from design.layout.core_hold import LOCATOR_NOSE_MM, Locator
from design.layout.mould.frame import flange_width_mm, parting
from design.layout.mould.pins import Pin, along_pull, key_of_pocket, met_pockets, places_of_pockets
from design.mould.room import core_outside
from design.solids.booleans import Shape, Solid, cut, join, one_body
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, cylinder_on_face, pocket_prism, pocket_solid
from design.spec.object import ObjectSpec


def fixed_bosses(spec: ObjectSpec, side: int) -> list[cq.Solid]:
    """Bosses that stay on the half at that side (1, −1) of the parting plane."""
    met, normal = met_pockets(spec), parting(spec).normal
    return [
        pocket_solid(frame, pocket)
        for frame, pocket in places_of_pockets(spec)
        if key_of_pocket(frame, pocket) not in met
        and along_pull(spec, frame, pocket)
        and side * float((frame.axes @ pocket.axis) @ normal) > 0
    ]


def make_pin(spec: ObjectSpec, pin: Pin) -> Solid:
    """Boss, shank through the wall, head, and the nose of a locating pin, in the object's frame.

    Raises
    ------
    InputError
        The pin is not one valid solid.
    """
    seat, solids = pin.seat_mm, []
    for pocket in pin.pockets:
        solids.append(pocket_prism(pin.frame, pocket, None, seat + OVERSHOOT_MM))
        solids.append(pocket_prism(pin.frame, pocket, seat, pin.top_mm, pin.rim_mm))
    body: Shape = join(*solids)
    if pin.locator is not None:
        rod, nose = _rod_and_nose(spec, pin.locator)
        body = join(cut(join(body, rod), core_outside(spec)), nose)
    return one_body(body, "mould_pin")


def pin_holes(spec: ObjectSpec, pin: Pin) -> list[cq.Solid]:
    """Hole through the wall, and room for the head all the way out."""
    play, seat = spec.printer.clearance_mm, pin.seat_mm
    out = 2 * max(spec.body.size_mm) + flange_width_mm(spec)
    holes = []
    for pocket in pin.pockets:
        holes.append(pocket_prism(pin.frame, pocket, None, seat + OVERSHOOT_MM, play))
        holes.append(pocket_prism(pin.frame, pocket, seat, out, pin.rim_mm + play))
    return holes


def _rod_and_nose(spec: ObjectSpec, locator: Locator) -> tuple[cq.Solid, cq.Solid]:
    """Through the silicone into the core, which is to be cut off the rod; into the core's hole."""
    depth, middle = locator.depth_mm, (0.0, 0.0)
    start = -depth - OVERSHOOT_MM - locator.radius_mm * locator.rise_mm
    rod = cylinder_on_face(locator.frame, middle, locator.radius_mm, start, -depth / 4)
    tip = depth + min(LOCATOR_NOSE_MM, 0.8 * locator.hole_mm)
    narrow = locator.radius_mm - spec.printer.clearance_mm
    sunk = OVERSHOOT_MM / 2
    nose = cylinder_on_face(locator.frame, middle, narrow, -tip, -depth + sunk)
    return rod, nose
