"""Cycle of a machine on a press rig: start, moves, rest."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from design.errors import InputError
from instobj.bench.rig.clock import Listening
from instobj.bench.rig.machine import MachineFault, until
from instobj.bench.rig.mounting import safe_height_mm
from instobj.bench.rig.phases import Phase
from instobj.bench.rig.station import Spot, Station
from instobj.bench.rig.stop import ARRIVED_MM, halt

PATIENCE_S = 5.0
_HOMING_S = 180.0
_MOVE_S = 600.0
SILENT_S = 1.0
_WITHOUT_BOARD = 5
"""Times the patience where the board's clock stands still too."""
_AVERAGED = 3
_FIRST_READINGS, _FIRST_FRAMES = 30, 10
"""At rest before anything moves: enough for the noise of cell and chips within a fifth."""
_LARGEST_DRIFT_N = 1.0
"""Change of the load cell's level at rest beyond which the run stops."""
APPROACH_MM_S = 2.0
"""Speed on the way down before the object is touched."""
_REST_FRAMES = 40
"""Within which silicone is back at rest after a press."""


def greet(station: Station) -> None:
    """Bring a machine of any state to a stop with empty buffers, and read its settings.

    Raises
    ------
    MachineFault
        It does not speak its dialect.
    """
    link = station.machine
    halt(link, link.dialect.boot_s)
    link.send(*link.dialect.queries)
    until(
        link,
        station.tick,
        lambda: bool(link.settings) and not link.unanswered,
        f"its settings ({', '.join(link.dialect.queries)})",
        PATIENCE_S,
    )


def home(station: Station) -> None:
    """Find the limit switches, the uppermost first: from here on coordinates mean something."""
    link = station.machine
    station.enter(Phase.HOMING)
    try:
        link.send(*link.dialect.home)
        until(
            link,
            station.tick,
            lambda: link.alarm is not None or not link.unanswered,
            "the end of homing",
            _HOMING_S,
        )
        if link.alarm is not None:
            raise MachineFault(f"{link.where}: homing ended in {link.alarm.why}")
    except BaseException:
        station.enter(Phase.LOST)
        raise
    station.safe_mm = safe_height_mm(link.travel.top_mm, math.inf)
    station.enter(Phase.ABOVE, station.safe_mm)
    link.trusted, link.lost = True, False
    station.expect()
    settle(station)


def raise_and_listen(station: Station) -> float:
    """Stop, lift the tip, and wait for readings of the time after it; the height (mm) at which it was
    stopped."""
    stopped_mm = station.raise_tip()
    station.listen_again(stopped_mm)
    last, first = station.frames + 1, station.readings
    until(
        station.machine,
        station.tick,
        lambda: station.frames >= last and station.readings > first,
        "board and load cell",
        PATIENCE_S,
    )
    return stopped_mm


def settle(
    station: Station, dwell_s: float = 0.0, enough: Callable[[], bool] = lambda: False
) -> bool:
    """Wait until every line is answered and the machine stands still; False if `enough` came first.

    Raises
    ------
    MachineFault
        It stands still and answers nothing more, by our clock and the board's: characters were lost.
    """
    link, silent_s, unanswered = station.machine, SILENT_S + dwell_s, -1
    listening = Listening(silent_s, link.clock)
    changed_s = listening.now_s, station.frame_ms / 1000

    def tick() -> None:
        nonlocal changed_s, unanswered
        station.tick()
        now_s = listening.look(), station.frame_ms / 1000
        idle = link.state is not None and link.state.name == "Idle"
        if not idle or link.unanswered != unanswered:
            changed_s, unanswered = now_s, link.unanswered
        elif (
            min(now_s[0] - changed_s[0], now_s[1] - changed_s[1]) > silent_s
            or now_s[0] - changed_s[0] > _WITHOUT_BOARD * silent_s
        ):
            raise MachineFault(
                f"{link.where}: {unanswered} lines without answer. Characters were lost"
            )

    def finished() -> bool:
        return enough() or not link.unanswered

    until(link, tick, finished, "the answer to every line", _MOVE_S)
    if link.unanswered:
        return False
    first = link.states + 2

    def still() -> bool:
        return link.states >= first and link.state is not None and link.state.name == "Idle"

    until(link, station.tick, lambda: enough() or still(), "a standstill", _MOVE_S)
    return still()


def travel(station: Station, spot: Spot) -> None:
    """To above a place, at the safe height; frames carry its label from there on."""
    x, y = spot.machine_mm
    station.machine.send(f"G53G0X{x:.3f}Y{y:.3f}")
    settle(station)
    require_at(station, (x, y, station.safe_mm))
    station.spot = spot


def require_at(station: Station, wanted_mm: tuple[float, float, float]) -> None:
    """The tip is reported where it was sent."""
    state = station.machine.state
    position_mm = (np.nan,) * 3 if state is None else state.position_mm
    if not np.allclose(position_mm, wanted_mm, atol=ARRIVED_MM, rtol=0):
        raise MachineFault(
            f"{station.machine.where}: the tip is at {position_mm}, not at {wanted_mm}. Characters of a line "
            "may have been lost"
        )


def learn_rest(station: Station) -> None:
    """Noise and levels of load cell and chips, before anything is pressed.

    Raises
    ------
    InputError
        One of them says nothing that changes as readings do.
    """
    readings = _rest(station, _FIRST_FRAMES, _FIRST_READINGS)
    if station.cell is not None:
        station.cell.learn(readings, station.limit_n)


def take_tare(station: Station, frames: int) -> None:
    """Let frames pass with nothing touched; the load cell's mean level becomes its zero, the chips' theirs.

    Raises
    ------
    InputError
        The cell left its last level by more than 1 N: something touches, or the cell is loose.
    """
    cell, readings = station.cell, _rest(station, frames, _AVERAGED)
    if cell is None:
        return
    level_n = cell.mean_n(readings)
    if abs(level_n - cell.tare_n) > _LARGEST_DRIFT_N:
        raise InputError(
            f"in the air the load cell says {level_n - cell.tare_n:+.2f} N. Something touches the tip, "
            "or the cell is loose"
        )
    cell.tare_n = level_n


def _rest(station: Station, frames: int, readings: int) -> int:
    """Let frames and readings pass; how many readings there were."""
    last, first = station.frames + frames, station.readings
    station.witnesses.chips.rest()

    def rested() -> bool:
        return station.frames >= last and station.readings >= first + readings

    until(station.machine, station.tick, rested, "rest", _MOVE_S)
    station.witnesses.chips.rested(station.channels, station.heard_s)
    return station.readings - first


def soon(station: Station, met: Callable[[], bool], frames: int) -> bool:
    """Return whether something is met within some frames."""
    last = station.frames + frames
    until(
        station.machine,
        station.tick,
        lambda: met() or station.frames >= last,
        "frames of the board",
        _MOVE_S,
    )
    return met()


def require_rest(station: Station) -> None:
    """Wait until the chips are back at rest, with the tip up.

    Raises
    ------
    InputError
        They still see a contact.
    """
    chips = station.witnesses.chips
    if not soon(station, lambda: chips.see_nothing(station.heard_s), _REST_FRAMES):
        raise InputError(
            "the tip is up again, and the chips still see a contact. Does a chip lie, or has the object "
            "moved?"
        )
