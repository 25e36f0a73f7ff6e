"""Cycle of a machine on a press rig: start, stop with the tip raised, moves, presses."""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np

from design.errors import InputError
from instobj.rig.grbl import Listening, MachineFault, until
from instobj.rig.grbl_lines import ALARMS, KEPT_POSITION
from instobj.rig.mounting import safe_height_mm
from instobj.rig.plan import PressSettings
from instobj.rig.press_code import press_code
from instobj.rig.station import Spot, Station

_PATIENCE_S = 5.0
_HOMING_S = 180.0
_MOVE_S = 600.0
_AGAIN_S = 0.3
_TRIES, _TRYING_S = 20, 20.0
"""To raise the tip: a line in which every eleventh character is lost comes whole now and then."""
_ARRIVED_MM = 0.03
_SILENT_S = 1.0
_WITHOUT_BOARD = 5
"""Times the patience where the board's clock stands still too."""
_AVERAGED = 3
_LARGEST_DRIFT_N = 1.0


def greet(station: Station) -> None:
    """Bring a machine of any state to a stop with empty buffers, and read its settings.

    Raises
    ------
    MachineFault
        It does not speak Grbl 1.1.
    """
    _halted(station)
    link = station.machine
    _asked(station, lambda: link.send("$$"), lambda: bool(link.settings) and not link.unanswered)


def home(station: Station) -> None:
    """Find the limit switches, the uppermost first: from here on coordinates mean something."""
    link = station.machine
    link.send("$H")
    until(
        link,
        station.tick,
        lambda: link.alarm is not None or not link.unanswered,
        "the end of homing",
        _HOMING_S,
    )
    if link.alarm is not None:
        why = ALARMS.get(link.alarm, "unknown")
        raise MachineFault(f"{link.where}: homing ended in ALARM:{link.alarm} ({why})")
    station.safe_mm = safe_height_mm(link.settings, math.inf)
    link.trusted = True
    station.expect()
    settle(station)


def raise_tip(station: Station) -> float:
    """Stop the feed, forget all lines, lift the tip to the safe height and stay there; returns the
    height (mm) at which it was stopped.

    Tried again where characters are lost: the safe height is whole millimetres, so that a lost digit
    leads upwards.

    Raises
    ------
    MachineFault
        The machine is in an alarm that lost its position, or does not answer.
    """
    station.watching, alarm = False, station.machine.alarm
    give_up_s = time.monotonic() + _TRYING_S
    try:
        for left in reversed(range(_TRIES)):
            try:
                return _lifted(station, alarm)
            except MachineFault:
                alarm = station.machine.alarm or alarm
                over = not left or time.monotonic() > give_up_s
                if over or alarm not in (None, KEPT_POSITION):
                    raise
    finally:
        station.watching = True
        station.expect()
    raise AssertionError


def _lifted(station: Station, alarm: int | None) -> float:
    link = station.machine
    _halted(station)
    state = link.state
    if state is not None and state.name == "Alarm" and alarm == KEPT_POSITION:
        link.send("$X")
    elif state is None or state.name == "Alarm":
        raise MachineFault(
            f"{link.where} has lost its position and cannot lift the tip. --resume homes it, upwards first"
        )
    link.trusted = True
    link.send(f"G53G0Z{station.safe_mm:g}")
    settle(station)
    return state.position_mm[2]


def settle(
    station: Station, dwell_s: float = 0.0, enough: Callable[[], bool] = lambda: False
) -> bool:
    """Wait until every line is answered and the machine stands still; False if `enough` came first.

    Raises
    ------
    MachineFault
        It stands still and answers nothing more, by our clock and the board's: characters were lost.
    """
    link, silent_s, seen = station.machine, _SILENT_S + dwell_s, -1
    listening = Listening(silent_s)
    changed_s = listening.now_s, station.frame_ms / 1000

    def tick() -> None:
        nonlocal changed_s, seen
        station.tick()
        now_s = listening.look(), station.frame_ms / 1000
        idle = link.state is not None and link.state.name == "Idle"
        if not idle or link.unanswered != seen:
            changed_s, seen = now_s, link.unanswered
        elif (
            min(now_s[0] - changed_s[0], now_s[1] - changed_s[1]) > silent_s
            or now_s[0] - changed_s[0] > _WITHOUT_BOARD * silent_s
        ):
            raise MachineFault(f"{link.where}: {seen} lines without answer. Characters were lost")

    def over() -> bool:
        return enough() or not link.unanswered

    until(link, tick, over, "the answer to every line", _MOVE_S)
    if link.unanswered:
        return False
    first = link.states + 2

    def still() -> bool:
        return link.states >= first and link.state is not None and link.state.name == "Idle"

    until(link, station.tick, lambda: enough() or still(), "a standstill", _MOVE_S)
    return still()


def _halted(station: Station) -> None:
    """Feed held and buffers emptied; both are asked for again where characters were lost."""
    link = station.machine
    link.trusted = False
    first = link.states + 2

    def still() -> bool:
        state = link.state
        return link.states >= first and state is not None and (state.held or state.name == "Alarm")

    _asked(station, link.hold, still)
    greeted = link.greetings
    _asked(station, link.reset, lambda: link.greetings > greeted)
    link.alarm, first = None, link.states + 2
    _asked(station, link.ask, lambda: link.states >= first)


def _asked(station: Station, ask: Callable[[], None], met: Callable[[], bool]) -> None:
    """Ask until it is met, again and again: characters may be lost."""
    asked_s = 0.0

    def tick() -> None:
        nonlocal asked_s
        if time.monotonic() - asked_s > _AGAIN_S:
            asked_s = time.monotonic()
            ask()
        station.tick()

    until(station.machine, tick, met, "an answer", _PATIENCE_S)


def travel(station: Station, spot: Spot) -> None:
    """To above a place, at the safe height; frames carry its label from there on."""
    x, y = spot.machine_mm
    station.machine.send(f"G53G0X{x:.3f}Y{y:.3f}")
    settle(station)
    require_at(station, (x, y, station.safe_mm))
    station.spot = spot


def require_at(station: Station, wanted_mm: tuple[float, float, float]) -> None:
    state = station.machine.state
    there = (np.nan,) * 3 if state is None else state.position_mm
    if not np.allclose(there, wanted_mm, atol=_ARRIVED_MM, rtol=0):
        raise MachineFault(
            f"{station.machine.where}: the tip is at {there}, not at {wanted_mm}. Characters of a line "
            "may have been lost"
        )


def take_tare(station: Station, frames: int) -> None:
    """Let frames pass with nothing touched; the load cell's mean level becomes its zero.

    Raises
    ------
    InputError
        It left its last level by more than 1 N: something touches, or the cell is loose.
    """
    cell, tared = station.cell, station.cell.tared
    readings, last = cell.readings, station.frames + frames

    def rested() -> bool:
        return station.frames >= last and cell.readings >= readings + _AVERAGED

    until(station.machine, station.tick, rested, "rest", _MOVE_S)
    level_n = cell.mean_n(cell.readings - readings)
    if tared and abs(level_n - cell.tare_n) > _LARGEST_DRIFT_N:
        raise InputError(
            f"in the air the load cell says {level_n - cell.tare_n:+.2f} N. Something touches the tip, "
            "or the cell is loose"
        )
    cell.tare_n, cell.tared = level_n, True


def press(
    station: Station, spot: Spot, surface_mm: float, settings: PressSettings, rest_frames: int
) -> float:
    """Rest above a place, press it in strokes to every stop, come back up; returns the largest force
    (N). A stroke ends early at the full force, and those after it go less deep."""
    travel(station, spot)
    station.surface_mm, station.lowest_mm = surface_mm, surface_mm - settings.depths_mm[-1]
    station.recording = station.resting = True
    take_tare(station, rest_frames)
    station.resting, largest_n, left = False, 0.0, settings
    while left is not None:
        force_n, left = _strokes(station, surface_mm, left)
        largest_n = max(largest_n, force_n)
    require_at(station, (*spot.machine_mm, station.safe_mm))
    return largest_n


def end_rows(station: Station) -> None:
    """Record no more, and wait for travel and force of the frames that came last, a second at most."""
    station.recording, listening = False, Listening(_SILENT_S)
    last_s = listening.now_s + _SILENT_S

    def over() -> bool:
        return not station.waiting or listening.look() > last_s

    until(station.machine, station.tick, over, "the last frames' travel", _PATIENCE_S)


def _strokes(
    station: Station, surface_mm: float, settings: PressSettings
) -> tuple[float, PressSettings | None]:
    """Strokes until the full force; the largest force (N), and what is left to do, if anything."""
    largest_n = 0.0

    def full() -> bool:
        nonlocal largest_n
        largest_n = max(largest_n, station.cell.force_n)
        return largest_n >= settings.full_n

    parts = press_code(settings, surface_mm, station.safe_mm)
    for part in parts:
        station.machine.send_whole(part)
    if settle(station, max(settings.dwell_s, settings.pause_s), full):
        return largest_n, None
    ends = np.cumsum([len(part) for part in parts])
    answered = int(ends[-1]) - station.machine.unanswered
    begun = int(np.searchsorted(ends, answered, side="right")) + 1
    reached_mm = surface_mm - raise_tip(station)
    left = settings.strokes - begun
    return largest_n, settings.after_full(reached_mm, left) if left > 0 else None
