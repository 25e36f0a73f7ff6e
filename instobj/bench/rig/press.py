"""Presses of a place on a press rig: strokes, the stop above the surface before them, and their last rows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from design.errors import InputError
from instobj.bench.rig.chips import MOST_FRAMES
from instobj.bench.rig.clock import Listening
from instobj.bench.rig.cycle import (
    APPROACH_MM_S,
    PATIENCE_S,
    SILENT_S,
    raise_and_listen,
    require_at,
    require_rest,
    settle,
    soon,
    take_tare,
    travel,
)
from instobj.bench.rig.machine import until
from instobj.bench.rig.phases import Phase
from instobj.bench.rig.plan import PressSettings
from instobj.bench.rig.press_code import press_code
from instobj.bench.rig.station import Spot, Station

_LEAST_MM = 0.1
"""Depth below which a press has not happened."""
_NEAR_FRAMES = MOST_FRAMES + 2
"""Above the surface before a press: the chips' longest mean, and frames under way."""


def press(
    station: Station, spot: Spot, surface_mm: float, settings: PressSettings, rest_frames: int
) -> float:
    """Rest above a place, press it in strokes to every stop, come back up; returns the largest force
    (N). A stroke ends early at the full force, and those after it go less deep.

    Without a load cell each stroke begins with the chips' word that nothing is touched yet, and nothing is
    known of forces (0 N).
    """
    travel(station, spot)
    station.surface_mm = surface_mm
    station.recording = station.resting = True
    take_tare(station, rest_frames)
    station.resting, largest_n, remaining = False, 0.0, settings
    if station.cell is None:
        remaining = None
        for speed_mm_s in (settings.speed_mm_s, *_later_speeds(settings)):
            require_rest(station)
            near(station, settings.lift_mm)
            _strokes(station, surface_mm, replace(settings, strokes=1, speed_mm_s=speed_mm_s))
        require_rest(station)
    while remaining is not None:
        force_n, remaining = _strokes(station, surface_mm, remaining)
        largest_n = max(largest_n, force_n)
    require_at(station, (*spot.machine_mm, station.safe_mm))
    return largest_n


def _later_speeds(settings: PressSettings) -> list[float]:
    return [settings.stroke_speed_mm_s] * (settings.strokes - 1)


def near(station: Station, lift_mm: float) -> None:
    """To a height above the surface, and some frames there: lost steps show as a contact that chips see too
    early.

    Raises
    ------
    InputError
        They see one.
    """
    height_mm = station.surface_mm + lift_mm
    station.enter(Phase.NEARING, height_mm - 0.006)  # heights are sent with two digits
    station.machine.send(f"G53G1Z{height_mm:.2f}F{60 * APPROACH_MM_S:g}")
    settle(station)
    soon(station, lambda: False, _NEAR_FRAMES)
    station.witnesses.require_clear(lift_mm, station.heard_s, MOST_FRAMES)


def end_rows(station: Station) -> None:
    """Record no more, and wait for travel and force of the frames that came last, a second at most."""
    station.recording, listening = False, Listening(SILENT_S, station.machine.clock)
    last_s = listening.now_s + SILENT_S

    def finished() -> bool:
        return not station.rows.waiting or listening.look() > last_s

    until(station.machine, station.tick, finished, "the last frames' travel", PATIENCE_S)


def _strokes(
    station: Station, surface_mm: float, settings: PressSettings
) -> tuple[float, PressSettings | None]:
    """Strokes until the full force; the largest force (N), and what is left to do, if anything."""
    largest_n = 0.0

    def full() -> bool:
        nonlocal largest_n
        if station.cell is None:
            return False
        largest_n = max(largest_n, station.cell.force_n)
        return largest_n >= settings.full_n

    parts = press_code(settings, surface_mm, station.safe_mm, station.machine.dialect.room_bytes)
    # Heights are sent with two digits: the floor is as much lower.
    station.enter(Phase.PRESSING, surface_mm - settings.depths_mm[-1] - 0.006)
    for part in parts:
        station.machine.send_whole(part)
    if settle(station, max(settings.dwell_s, settings.pause_s), full):
        station.enter(Phase.ABOVE, station.safe_mm)
        return largest_n, None
    ends = np.cumsum([len(part) for part in parts])
    answered = int(ends[-1]) - station.machine.unanswered
    begun = int(np.searchsorted(ends, answered, side="right")) + 1
    stopped_mm = raise_and_listen(station)
    reached_mm = surface_mm - stopped_mm
    if reached_mm < _LEAST_MM:
        raise InputError(
            f"{settings.full_n:g} N were met {reached_mm:.2f} mm below the height of touch. Does something "
            "lie on the object, or has it moved?"
        )
    strokes_left = settings.strokes - begun
    return largest_n, settings.settings_after_full(
        reached_mm, strokes_left
    ) if strokes_left > 0 else None
