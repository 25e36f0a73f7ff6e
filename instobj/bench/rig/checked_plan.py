"""Plan of presses where the object was mounted: checked against machine and object, and its places there."""

from __future__ import annotations

import math

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import face_frame
from design.layout.tips import tip_places_mm
from design.spec.object import ObjectSpec
from instobj.bench.rig.contact_law import ContactLaw, contact_law, travel_bound_mm
from instobj.bench.rig.journal import Journal
from instobj.bench.rig.machine import MachineLink
from instobj.bench.rig.mounting import relief_mm, require_travel, require_upright, touch_places
from instobj.bench.rig.plan import PressSettings, face_places
from instobj.bench.rig.press_code import press_code
from instobj.bench.rig.station import Spot
from instobj.bench.rig.touch import BELOW_MM

SENT_MM = 0.006
"""Heights are sent with two digits: bounds are as much lower."""


def check_plan(
    spec: ObjectSpec, journal: Journal, machine: MachineLink, by_travel: bool = False
) -> list[str]:
    """The plan in words, checked against the machine.

    Raises
    ------
    InputError
        A face that leans, places out of the machine's travel, or presses too long for its buffer.
    """
    plan, mounting = journal.plan, journal.mounting
    places = np.concatenate([plan.places_mm, touch_places(face_places(spec, plan.face))])
    require_upright(spec, plan.face, places)
    travel = machine.travel
    reached_mm = mounting.machine_mm(face_frame(spec, plan.face).to_plane(places))
    low, high = reached_mm.min(axis=0), reached_mm.max(axis=0)
    corners = [(axis, float(end[k])) for k, axis in enumerate("XY") for end in (low, high)]
    require_travel(travel, corners)
    press_code(plan.settings, travel.low_mm[2], travel.top_mm, machine.dialect.room_bytes)
    expected = expected_mm(spec, journal, places)
    bound_mm = BELOW_MM + plan.settings.depths_mm[-1]
    if by_travel:
        bound_mm = _bound_of_travel_mm(spec, plan.settings)
    lowest_mm = float(expected.min()) - bound_mm
    require_travel(travel, [("Z", lowest_mm), ("Z", float(expected.max()))])
    _require_bounded(contact_law(spec), plan.settings)
    ending = f"a press ends at {plan.settings.full_n:g} N, everything stops at {plan.settings.limit_n:.3g} N"
    if by_travel:
        ending = (
            f"without a load cell nothing goes {bound_mm:.2f} mm below the surface that --middle states: "
            f"the stiffest silicone gives {plan.settings.limit_n:.3g} N there at most"
        )
    press, presses_left, strokes_text = plan.settings, len(journal.remaining), ""
    if press.strokes > 1:
        strokes_text = (
            f", {press.strokes} strokes a press, "
            f"from the second at {press.stroke_speed_mm_s:g} mm/s"
        )
    return [
        f"face {plan.face} of {plan.object_name}: {presses_left} of {len(plan)} presses to do, about "
        f"{plan.seconds * presses_left / len(plan) / 60:.0f} minutes",
        f"machine's frame: X {low[0]:.1f} to {high[0]:.1f}, Y {low[1]:.1f} to {high[1]:.1f} mm, Z from "
        f"{travel.top_mm:g} mm down to the surface at {expected.min():.1f} to {expected.max():.1f} "
        f"mm; {BELOW_MM:g} mm below it the way down ends, whatever the sensors say",
        f"stops {', '.join(f'{depth:g}' for depth in press.depths_mm)} mm below the first touch, "
        f"{press.speed_mm_s:g} mm/s{strokes_text}; {ending}",
        "the machine homes first, upwards; keep hands away and the emergency stop near",
    ]


def _require_bounded(law: ContactLaw, settings: PressSettings) -> None:
    deepest_mm, most_mm = settings.depths_mm[-1], law.depth_mm(settings.limit_n)
    if deepest_mm > most_mm:
        raise InputError(
            f"--plan depths_mm={deepest_mm:g}: about {law.force_n(deepest_mm):.0f} N are expected there, and "
            f"everything stops at {settings.limit_n:.3g} N. Give --plan depths_mm below {most_mm:.2f}, or "
            "raise full_n"
        )


def _bound_of_travel_mm(spec: ObjectSpec, settings: PressSettings) -> float:
    """Return the travel below the stated surface that holds whatever any sensor says.

    Raises
    ------
    InputError
        Several tips, or stops below it.
    """
    if len(tip_places_mm(spec.indenter)) > 1:
        raise InputError(
            "travel labels presses of one tip. Take a load cell, or an indenter with one tip"
        )
    bound_mm, deepest_mm = travel_bound_mm(spec, settings.limit_n), settings.depths_mm[-1]
    if deepest_mm > bound_mm:
        raise InputError(
            f"--plan depths_mm={deepest_mm:g}: without a load cell presses end at {bound_mm:.2f} mm, where "
            f"{settings.limit_n:.3g} N are expected of the stiffest silicone or press.depths_mm end. Give "
            "--plan depths_mm above that"
        )
    return bound_mm


def expected_mm(
    spec: ObjectSpec, journal: Journal, xy_mm: Float[np.ndarray, "place 2"]
) -> Float[np.ndarray, "place"]:
    """Machine Z of the specification's surface at places, as it was mounted."""
    return journal.mounting.middle_mm[2] + relief_mm(spec, journal.plan.face, xy_mm)


def spot_of(
    spec: ObjectSpec, journal: Journal, xy_mm: tuple[float, float], bound_mm: float = math.inf
) -> Spot:
    """A place with its tips, the machine's X and Y, and a bound below the stated surface."""
    tips = np.asarray(xy_mm) + tip_places_mm(spec.indenter)
    over = face_frame(spec, journal.plan.face).to_plane(np.array(xy_mm))
    x, y = journal.mounting.machine_mm(over).tolist()
    lowest_mm = float(expected_mm(spec, journal, np.array(xy_mm))) - bound_mm - SENT_MM
    return Spot(journal.plan.face, tuple((float(a), float(b)) for a, b in tips), (x, y), lowest_mm)
