"""Heights at which a tip first touches the object, measured by the load cell."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.rig.cycle import raise_tip, require_at, settle, take_tare, travel
from instobj.rig.grbl import until
from instobj.rig.grbl_lines import TRAVEL_SETTINGS
from instobj.rig.mounting import safe_height_mm
from instobj.rig.plan import PressSettings
from instobj.rig.station import Spot, Station

_COARSE_MM_S = 2.0
_AHEAD_MM = 0.5
_STEP_MM = 0.1
_STEP_MM_S = 1.0
_BACK_MM = 0.5
_DEEPEST_MM = 2.5
_FIRM = 3.0
_FAINT = 0.4
_FEWEST = 2
_TARE_FRAMES = 5
_SETTLING, _AVERAGED = 2, 3
_MARGIN_MM = 1.0
_READ_S = 60.0


def touched(
    station: Station, spec: ObjectSpec, spots: list[Spot], settings: PressSettings
) -> Float[np.ndarray, "touch"]:
    """Machine Z (mm) at which the tip first touches the object at places.

    A first touch on a slow way down stops the feed; then small steps from above it, each with the mean
    of three readings at rest, and the height at which their force law begins. From the first touch on
    the tip travels `clearance_mm` above it.

    Raises
    ------
    InputError
        Nothing is touched down to the end of the machine's travel.
    """
    heights_mm = []
    for spot in spots:
        travel(station, spot)
        take_tare(station, _TARE_FRAMES)
        coarse_mm = _coarse(station, settings)
        wanted_mm = min(station.safe_mm, coarse_mm + settings.clearance_mm)
        station.safe_mm = safe_height_mm(station.machine.settings, wanted_mm)
        steps = _steps(station, settings, min(coarse_mm + _BACK_MM, station.safe_mm))
        station.machine.send(f"G53G0Z{station.safe_mm:g}")
        settle(station)
        require_at(station, (*spot.machine_mm, station.safe_mm))
        heights_mm.append(first_touch_mm(*steps, settings.touch_n, spec.indenter.kind))
    return np.array(heights_mm)


def first_touch_mm(
    heights_mm: Float[np.ndarray, "step"],
    forces_n: Float[np.ndarray, "step"],
    touch_n: float,
    tip: str,
) -> float:
    """Height at which the force begins: F^(2/3) is a line under a sphere (Hertz), F under others."""
    power, felt = 2 / 3 if tip == "hemisphere" else 1.0, slice(-felt_steps(forces_n, touch_n), None)
    slope, start = np.polyfit(heights_mm[felt], forces_n[felt] ** power, 1)
    return float(-start / slope)


def felt_steps(forces_n: Float[np.ndarray, "step"], touch_n: float) -> int:
    """How many of the last steps were felt, one after the other."""
    faint = np.flatnonzero(forces_n < _FAINT * touch_n)
    return len(forces_n) - (int(faint[-1]) + 1 if len(faint) else 0)


def felt_enough(forces_n: Float[np.ndarray, "step"], touch_n: float) -> bool:
    """Whether the last step gave three times the force of touch and two were felt: a line needs two."""
    firm = len(forces_n) > 0 and forces_n[-1] >= _FIRM * touch_n
    return bool(firm and felt_steps(forces_n, touch_n) >= _FEWEST)


def _coarse(station: Station, settings: PressSettings) -> float:
    """Height at which a slow move down was stopped by the object; the tip is up again.

    The machine never holds more than a millimetre of that move: it ends there if nobody speaks to it.
    """
    link = station.machine
    station.lowest_mm = bottom_mm = _MARGIN_MM - link.settings[TRAVEL_SETTINGS[2]]
    target_mm = station.safe_mm

    def height_mm() -> float:
        return station.safe_mm if link.state is None else link.state.position_mm[2]

    def near() -> bool:
        touches = station.cell.force_n >= settings.touch_n
        return touches or height_mm() <= target_mm + _AHEAD_MM

    while station.cell.force_n < settings.touch_n:
        if height_mm() <= bottom_mm + _AHEAD_MM:
            raise_tip(station)
            raise InputError(
                f"the tip went down to Z = {bottom_mm:.1f} mm and touched nothing. Is the object below "
                "the tip, and the load cell connected the right way round (--load-scale)?"
            )
        target_mm = max(target_mm - _AHEAD_MM, bottom_mm)
        link.send(f"G53G1Z{target_mm:.2f}F{60 * _COARSE_MM_S:g}")
        until(link, station.tick, near, "the way down", _READ_S)
    touched_mm = raise_tip(station)
    station.lowest_mm = touched_mm - _DEEPEST_MM
    return touched_mm


def _steps(
    station: Station, settings: PressSettings, first_mm: float
) -> tuple[Float[np.ndarray, "step"], Float[np.ndarray, "step"]]:
    """Heights and mean forces of steps down, until enough was felt."""
    heights, forces = [], []
    station.machine.send(f"G53G0Z{first_mm:.3f}")
    while not felt_enough(np.array(forces), settings.touch_n):
        height_mm = first_mm - _STEP_MM * len(heights)
        if height_mm < station.lowest_mm:
            raise InputError(
                f"{_DEEPEST_MM:g} mm below its first touch the object gives less than "
                f"{_FIRM * settings.touch_n:g} N. Does it move?"
            )
        station.machine.send(f"G53G1Z{height_mm:.3f}F{60 * _STEP_MM_S:g}")
        settle(station)
        heights.append(height_mm)
        forces.append(_still_force_n(station))
    return np.array(heights), np.array(forces)


def _still_force_n(station: Station) -> float:
    cell, last = station.cell, station.cell.readings + _SETTLING + _AVERAGED
    until(station.machine, station.tick, lambda: cell.readings >= last, "the load cell", _READ_S)
    return cell.mean_n(_AVERAGED) - cell.tare_n
