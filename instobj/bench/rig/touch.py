"""Heights at which a tip first touches the object, by the load cell or the chips, near where it must be."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.bench.rig.chips import MOST_FRAMES
from instobj.bench.rig.contact_law import LARGEST_RATIO, likely_unit
from instobj.bench.rig.cycle import (
    APPROACH_MM_S,
    raise_and_listen,
    require_at,
    require_rest,
    settle,
    soon,
    take_tare,
    travel,
)
from instobj.bench.rig.machine import until
from instobj.bench.rig.mounting import safe_height_mm
from instobj.bench.rig.phases import Phase
from instobj.bench.rig.plan import PressSettings
from instobj.bench.rig.station import Spot, Station

BELOW_MM, ABOVE_MM = 1.0, 3.0
"""Distance from the expected surface within which it is sought: a hand that sets a height by eye or by a
sheet of paper is off by some tenths, and where it was pressed in already, by up to 2 mm upwards."""
_AHEAD_MM, _ARRIVED_MM = 0.5, 0.02
_STEP_MM = 0.1
"""Height of a step on the fine way down."""
_STEP_MM_S = 1.0
"""Speed of such a step."""
_BACK_MM, _BACK_OF_CHIPS_MM = 0.5, 1.5
"""Way back up after the first touch, from where fine steps begin; the chips' mean of three frames shows it
0.6 mm later, and some tenths below the surface."""
_FAINTEST_MM = 1.0
"""Way on after the first touch, in which counts must change by three times that."""
_LATE_FRAMES = MOST_FRAMES + 2
"""After which no frame of a moving tip is in the chips' longest mean."""
_FIRM = 3.0
"""Force over `touch_n` from which a touch is firm."""
_FAINT = 0.4
"""Force over `touch_n` below which nothing is felt yet."""
_FEWEST = 2
"""Steps in which a touch is felt, at least: a line needs two."""
_TARE_FRAMES, _TARE_FRAMES_OF_CHIPS = 6, 20
"""Frames whose mean is the load cell's zero, or the chips' where they alone find the surface."""
_SETTLING, _AVERAGED = 2, 3
"""Readings that are dropped after a step, and those whose mean counts."""
_READ_S = 60.0
"""Time after which a silent machine or load cell is given up."""


def touched(
    station: Station,
    spec: ObjectSpec,
    spots: list[Spot],
    expected_mm: Float[np.ndarray, "touch"],
    settings: PressSettings,
) -> tuple[Float[np.ndarray, "touch"], float]:
    """Machine Z (mm) at which the tip first touches the object at places, and how many times as stiff as
    expected the first one is.

    A first touch on a slow way down stops the feed; then small steps from above it, each with the mean
    of three readings at rest, and the height at which their force law begins. `expected_mm` are the
    heights of the specification's surface where it was mounted; the way down ends `BELOW_MM` below
    them, whatever the load cell says, and steps where the softest object would have been felt. From
    the first touch on the tip travels `clearance_mm` above it, and the others are expected as much
    higher or lower.

    Without a load cell the chips' change of counts stands for the force, which it follows. Once the tip is up
    again they must be back at rest: a chip that jumped is no touch.

    Raises
    ------
    InputError
        Nothing is touched where the surface is, or by a stiffness that is not the object's.
    """
    heights_mm, ratio, off_mm = [], 1.0, 0.0
    for spot, wanted_mm in zip(spots, expected_mm.tolist(), strict=True):
        travel(station, spot)
        take_tare(station, _TARE_FRAMES if station.cell is not None else _TARE_FRAMES_OF_CHIPS)
        station.surface_mm = wanted_mm + off_mm
        coarse_mm = _coarse(station)
        highest_mm = min(station.safe_mm, coarse_mm + settings.clearance_mm)
        station.safe_mm = safe_height_mm(station.machine.travel.top_mm, highest_mm)
        steps = _steps(station, coarse_mm)
        station.machine.send(f"G53G0Z{station.safe_mm:g}")
        settle(station)
        require_at(station, (*spot.machine_mm, station.safe_mm))
        station.enter(Phase.ABOVE, station.safe_mm)
        first_mm = first_touch_mm(*steps, station.witnesses.touch_level, spec.indenter.kind)
        if station.cell is None:
            _require_touch(station, *steps, first_mm)
            require_rest(station)
        if not heights_mm:
            off_mm = first_mm - wanted_mm
            ratio = 1.0 if station.cell is None else _stiffness(station, *steps, first_mm)
        heights_mm.append(first_mm)
    return np.array(heights_mm), ratio


def first_touch_mm(
    heights_mm: Float[np.ndarray, "step"],
    forces_n: Float[np.ndarray, "step"],
    touch_n: float,
    tip: str,
) -> float:
    """Height at which the force begins: F^(2/3) is a line under a sphere (Hertz), F under others.

    Changes of counts, in any unit, follow the force: on the gallery's small cube they grow with the power
    1.57 to 1.71 of the travel, the force with 1.63 to 1.73, and the height is right within 0.06 mm.
    """
    power, felt = 2 / 3 if tip == "hemisphere" else 1.0, slice(-felt_steps(forces_n, touch_n), None)
    slope, start = np.polyfit(heights_mm[felt], forces_n[felt] ** power, 1)
    return float(-start / slope)


def felt_steps(forces_n: Float[np.ndarray, "step"], touch_n: float) -> int:
    """Return how many of the last steps were felt, one after the other."""
    faint = np.flatnonzero(forces_n < _FAINT * touch_n)
    return len(forces_n) - (int(faint[-1]) + 1 if len(faint) else 0)


def felt_enough(forces_n: Float[np.ndarray, "step"], touch_n: float) -> bool:
    """Return whether the last step gave three times the force of touch and two were felt."""
    firm = len(forces_n) > 0 and forces_n[-1] >= _FIRM * touch_n
    return bool(firm and felt_steps(forces_n, touch_n) >= _FEWEST)


def _coarse(station: Station) -> float:
    """Height at which a slow move down was stopped by the object; the tip is up again.

    The machine never holds more than a millimetre of that move: it ends there if nobody speaks to it.
    """
    link, bottom_mm = station.machine, station.surface_mm - BELOW_MM
    if station.spot is not None:
        bottom_mm = max(bottom_mm, station.spot.lowest_mm)
    station.enter(Phase.SEEKING, bottom_mm - 0.006)  # heights are sent with two digits
    target_mm = station.safe_mm

    def height_mm() -> float:
        return station.safe_mm if link.state is None else link.state.position_mm[2]

    def near() -> bool:
        ahead_mm = _AHEAD_MM if target_mm > bottom_mm else _ARRIVED_MM
        return touch() or height_mm() <= target_mm + ahead_mm

    def touch() -> bool:
        return station.witnesses.touch(station.heard_s)

    def faint_touch() -> bool:
        return station.witnesses.chips.see(station.heard_s, MOST_FRAMES)

    while not touch():
        if height_mm() <= bottom_mm + _ARRIVED_MM:
            if station.cell is None and soon(station, faint_touch, _LATE_FRAMES):
                break
            felt = "no chip sees a contact"
            if station.cell is not None:
                felt = f"the load cell says {station.cell.force_n:.2g} N"
            raise InputError(
                f"the tip went down to Z = {bottom_mm:.1f} mm, {station.surface_mm - bottom_mm:.2g} mm below "
                f"where --middle has the surface, and {felt}{station.witnesses.doubt(BELOW_MM)} Or is that Z "
                "too high?"
            )
        target_mm = max(target_mm - _AHEAD_MM, bottom_mm)
        link.send(f"G53G1Z{target_mm:.2f}F{60 * APPROACH_MM_S:g}")
        until(link, station.tick, near, "the way down", _READ_S)
    touched_mm = raise_and_listen(station)
    if touched_mm > station.surface_mm + ABOVE_MM:
        raise InputError(
            f"something was touched at Z = {touched_mm:.1f} mm, more than {ABOVE_MM:g} mm above where "
            f"--middle has the surface ({station.surface_mm:.1f} mm). Is it this object, and this face up?"
        )
    return touched_mm


def _steps(
    station: Station, coarse_mm: float
) -> tuple[Float[np.ndarray, "step"], Float[np.ndarray, "step"]]:
    """Heights and mean forces of steps down, until enough was felt; changes of counts without a load cell."""
    heights, readings, strengths = [], [], np.zeros(0)
    touch_level, by_chips = station.witnesses.touch_level, station.cell is None
    first_mm = min(coarse_mm + (_BACK_OF_CHIPS_MM if by_chips else _BACK_MM), station.safe_mm)
    firm_n = _FIRM * station.witnesses.touch_n
    softest_mm = station.witnesses.law.depth_mm(firm_n, 1 / LARGEST_RATIO)
    softest_mm = _FAINTEST_MM if by_chips else softest_mm
    lowest_mm = max(coarse_mm, station.surface_mm - BELOW_MM) - softest_mm
    station.enter(Phase.SEEKING, lowest_mm)
    lowest_mm = station.machine.floor_mm
    station.machine.send(f"G53G0Z{first_mm:.3f}")
    while not felt_enough(strengths, touch_level):
        height_mm = first_mm - _STEP_MM * len(heights)
        if height_mm < lowest_mm:
            little = (
                "changes no chip's counts enough" if by_chips else f"gives less than {firm_n:.2g} N"
            )
            raise InputError(
                f"{max(coarse_mm - lowest_mm, 0.0):.1f} mm below its first touch the object {little}"
                f"{station.witnesses.doubt(BELOW_MM)} Or does the object move?"
            )
        station.machine.send(f"G53G1Z{height_mm:.3f}F{60 * _STEP_MM_S:g}")
        settle(station)
        heights.append(height_mm)
        readings.append(_still_reading(station))
        strengths = station.witnesses.strengths(readings)
        if station.cell is None and len(readings) == 1 and station.witnesses.touch(station.heard_s):
            raise InputError(
                f"{_BACK_OF_CHIPS_MM:g} mm above where the tip was stopped the chips still see a contact. "
                "Does a chip lie, has the object moved, or is there steel or a magnet in the tip?"
            )
        if station.cell is not None and strengths[0] < -touch_level:
            raise InputError(
                f"above the object the load cell says {strengths[0]:.2f} N: it drifts, or something pulls at "
                "it"
            )
    return np.array(heights), strengths


def _still_reading(station: Station) -> Float[np.ndarray, "channel"]:
    averaged = MOST_FRAMES if station.cell is None else _AVERAGED
    last = station.readings + _SETTLING + averaged
    until(station.machine, station.tick, lambda: station.readings >= last, "readings", _READ_S)
    return station.witnesses.reading(averaged, station.heard_s)


def _require_touch(
    station: Station,
    heights_mm: Float[np.ndarray, "step"],
    strengths: Float[np.ndarray, "step"],
    first_mm: float,
) -> None:
    """Refuse counts that change before the tip can touch.

    Raises
    ------
    InputError
        They do from the first step on, or too far above where the surface is.
    """
    limit_mm = min(heights_mm[0], station.surface_mm + BELOW_MM)
    if first_mm > limit_mm or felt_steps(strengths, station.witnesses.touch_level) == len(
        strengths
    ):
        raise InputError(
            f"the chips see something from Z = {max(first_mm, heights_mm[0]):.1f} mm on, and --middle has "
            f"the surface at {station.surface_mm:.1f} mm. Is there steel or a magnet in the tip, is the "
            "object another, or is that Z too low?"
        )


def _stiffness(
    station: Station,
    heights_mm: Float[np.ndarray, "step"],
    forces_n: Float[np.ndarray, "step"],
    first_mm: float,
) -> float:
    """Times what the specification lets expect.

    Raises
    ------
    InputError
        So many times that it is not the object but the load cell's scale.
    """
    ratio = station.witnesses.law.ratio(first_mm - heights_mm, forces_n)
    if not 1 / LARGEST_RATIO <= ratio <= LARGEST_RATIO:
        depth_mm = first_mm - heights_mm[-1]
        raise InputError(
            f"{depth_mm:.2f} mm below its first touch the load cell says {forces_n[-1]:.2g} N, and about "
            f"{station.witnesses.law.force_n(depth_mm):.2g} N are expected{likely_unit(ratio)}. Correct "
            "--load-port PORT=SCALE or the load cell's figures in the specification; or is silicone's "
            "modulus wrong?"
        )
    return ratio
