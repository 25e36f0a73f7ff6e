"""A run on a press rig: the machine made ready, heights touched, presses done and recorded."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from design.errors import InputError, InstobjError
from design.layout.tips import tip_places_mm
from design.spec.object import ObjectSpec
from estimator.recordings.boards.growing import growing_recording
from estimator.recordings.boards.link import serial_chunks
from instobj.bench.rig.checked_plan import SENT_MM, expected_mm, spot_of
from instobj.bench.rig.chips import Chips
from instobj.bench.rig.contact_law import contact_law, travel_bound_mm
from instobj.bench.rig.cycle import (
    greet,
    home,
    learn_rest,
    raise_and_listen,
    take_tare,
)
from instobj.bench.rig.dialects import Dialect
from instobj.bench.rig.journal import Journal
from instobj.bench.rig.load_cell import LoadCell, largest_reading_n
from instobj.bench.rig.load_lines import forces_on
from instobj.bench.rig.machine import MachineFault, MachineLink, machine_link, until
from instobj.bench.rig.mounting import (
    UNEVEN_MM,
    Surface,
    safe_height_mm,
    touch_places,
    touched_surface,
)
from instobj.bench.rig.phases import Phase
from instobj.bench.rig.plan import PressSettings, face_places
from instobj.bench.rig.press import end_rows, press
from instobj.bench.rig.rows import Rows
from instobj.bench.rig.station import Spot, Station
from instobj.bench.rig.touch import touched
from instobj.bench.rig.witnesses import Witnesses

Say = Callable[[str], None]
_AFTER_S = 1.0
"""Between the last row of a recording and the first that is added, at least."""
_HEARD_S = 10.0
_LEAST_ROOM_MM = 0.1


@dataclass(frozen=True)
class Ports:
    """Ports of machine, board and load cell; `load_scale` None: the load cell sends lines `L`. Without a load
    cell `by_travel` labels presses."""

    machine: str
    board: str
    load: str | None = None
    board_baud: int = 115_200
    load_scale: float | None = None
    lost_s: float = 1.5
    by_travel: bool = False


@contextmanager
def station_on(
    ports: Ports, dialect: Dialect, spec: ObjectSpec, limit_n: float
) -> Iterator[Station]:
    """Machine, board and load cell, connected; nothing moves.

    Raises
    ------
    InputError
        A port cannot be opened, or nothing sound comes from it.
    """
    loads = None
    if ports.load is not None:
        loads = forces_on(ports.load, ports.board_baud, ports.load_scale)
    board = serial_chunks(ports.board, ports.board_baud, timeout_s=0.0)
    with machine_link(ports.machine, dialect) as link:
        station = new_station(link, board, loads, spec, limit_n, ports.lost_s, ports.by_travel)
        make_ready(station)
        yield station


def new_station(
    machine: MachineLink,
    board: Iterator[bytes],
    loads: Iterator[list[float]] | None,
    spec: ObjectSpec,
    limit_n: float,
    lost_s: float = Ports.lost_s,
    by_travel: bool = False,
) -> Station:
    """Three lines with what the specification lets expect of cell and chips; `by_travel` without a cell."""
    largest_n = largest_reading_n(spec.load_cell) if loads is None else math.inf
    cell = None if by_travel else LoadCell(largest_n)
    chips = Chips(spec.sensors.noise_counts, spec.sensors.drift_counts)
    witnesses = Witnesses(cell, chips, contact_law(spec))
    return Station(
        machine, board, loads, limit_n, lost_s, witnesses, rows=Rows(by_travel=by_travel)
    )


def make_ready(station: Station) -> None:
    """The machine stopped, its settings read, and all three lines heard.

    Raises
    ------
    InputError
        One of them says nothing sound.
    """
    greet(station)

    def heard() -> bool:
        return bool(station.channels and station.frames and station.readings)

    try:
        until(station.machine, station.tick, heard, "board or load cell", _HEARD_S)
    except MachineFault:
        missing = "load cell" if station.frames else "board"
        raise InputError(
            f"the {missing} said nothing sound within {_HEARD_S:g} s. Check --board-port, --load-port, "
            "the baud rate, and that the load cell sends lines (`instobj docs recordings`). A rig without "
            "one labels presses by travel: --load-port none"
        ) from None


def carry_out(
    station: Station, spec: ObjectSpec, journal: Journal, recording: Path, say: Say
) -> None:
    """Home, touch off, and do what the journal says is left.

    Raises
    ------
    InputError
        The run was stopped; the tip was raised where that was possible, and all that was recorded stays.
    """
    tips = len(tip_places_mm(spec.indenter))
    journal.begin()
    with growing_recording(
        recording,
        station.channels,
        1,
        tips,
        journal.session,
        travel=True,
        force=not station.rows.by_travel,
    ) as station.rows.growing:
        station.clock.not_before_s = station.rows.growing.last_s + _AFTER_S
        try:
            _presses(station, spec, journal, say)
        except BaseException as error:
            up = raised(station)
            journal.note("stopped", reason=str(error))
            if isinstance(error, InstobjError | KeyboardInterrupt):
                why = str(error) or "stopped by the user"
                end = "" if why[-1] in ".?" else "."
                raise InputError(f"{why}{end} {up}; --resume goes on") from None
            raise
        finally:
            station.rows.close()


def raised(station: Station) -> str:
    """The machine stopped and its tip lifted, in words: `up` only where its own position says so."""
    if station.phase is Phase.OFF:
        return "Nothing was moved"
    if station.phase in (Phase.HOMING, Phase.LOST):
        return "The tip was NOT raised"
    try:
        station.raise_tip()
    except InstobjError as error:
        return f"The tip could NOT be raised ({error})"
    return "The tip is up"


def _presses(station: Station, spec: ObjectSpec, journal: Journal, say: Say) -> None:
    plan = journal.plan
    bound_mm = math.inf
    if station.cell is None:
        bound_mm = travel_bound_mm(spec, station.limit_n)
    home(station)
    learn_rest(station)
    surface, stiffness = _touched_surface(station, spec, journal, bound_mm)
    # As stiff as measured or as expected, whichever is more: the limit must hold where the cell lies.
    deepest_mm = station.witnesses.law.depth_mm(station.limit_n, max(stiffness, 1.0))
    settings = plan.settings.down_to(deepest_mm)
    stiff_text = "" if station.cell is None else f"{stiffness:.2f} times as stiff as expected; "
    journal.note("touched", plane=list(surface.plane), uneven_mm=surface.uneven_mm)
    say(
        f"touched at Z = {surface.plane[0]:.2f} mm, uneven by {surface.uneven_mm:.2f} mm, "
        f"{stiff_text}presses end {settings.depths_mm[-1]:.2f} mm deep"
    )
    wanted_mm = _highest(surface, journal) + plan.settings.clearance_mm
    station.safe_mm = safe_height_mm(station.machine.travel.top_mm, wanted_mm)
    raise_and_listen(station)
    rest_frames = max(5, round(plan.settings.rest_s * spec.sensors.frame_rate_hz))
    for number in journal.remaining:
        spot = spot_of(spec, journal, plan.places_mm[number], bound_mm)
        height_mm = float(surface.height_mm(np.array(plan.places_mm[number])))
        # A surface that was touched lower than stated is pressed less deep: the bound stands.
        room_mm = height_mm - spot.lowest_mm - SENT_MM
        if room_mm < _LEAST_ROOM_MM:
            raise InputError(
                f"the surface was touched {bound_mm - room_mm:.1f} mm below where --middle has it, and "
                f"nothing may go {bound_mm:.1f} mm below that. Touch off again"
            )
        bounded = settings.down_to(room_mm)
        if station.cell is None and plan.reference[number] and journal.finished:
            _require_same_surface(station, spec, spot, height_mm, plan.settings)
        journal.note("begun", press=number, row=_rows(station))
        largest_n = press(station, spot, height_mm, bounded, rest_frames)
        force = {} if station.cell is None else {"largest_n": round(largest_n, 3)}
        journal.note("finished", press=number, row=_rows(station), **force)
        reached = f"{largest_n:.2f} N" if force else f"{bounded.depths_mm[-1]:.2f} mm"
        say(f"press {len(journal.finished)} of {len(plan)}: {reached}")
    station.resting = True  # the last press has an unloaded level behind it too
    take_tare(station, rest_frames)
    end_rows(station)


def _require_same_surface(
    station: Station, spec: ObjectSpec, spot: Spot, height_mm: float, settings: PressSettings
) -> None:
    """Touch the reference place again: small losses of steps add up, and no force shows them.

    Raises
    ------
    InputError
        Its surface is elsewhere than before.
    """
    safe_mm, station.recording = station.safe_mm, False
    again_mm = float(touched(station, spec, [spot], np.array([height_mm]), settings)[0][0])
    station.safe_mm = safe_mm
    raise_and_listen(station)
    if abs(again_mm - height_mm) > UNEVEN_MM:
        raise InputError(
            f"the reference place is touched at Z = {again_mm:.2f} mm, and was at {height_mm:.2f} mm. Has "
            "the machine lost steps, or has the object moved?"
        )


def _rows(station: Station) -> int:
    growing = station.growing
    return 0 if growing is None else growing.rows_before + growing.rows_added


def _highest(surface: Surface, journal: Journal) -> float:
    return float(surface.height_mm(np.array(journal.plan.places_mm)).max())


def _touched_surface(
    station: Station, spec: ObjectSpec, journal: Journal, bound_mm: float
) -> tuple[Surface, float]:
    plan = journal.plan
    places = touch_places(face_places(spec, plan.face))
    spots = [spot_of(spec, journal, (float(x), float(y)), bound_mm) for x, y in places]
    stated_mm = expected_mm(spec, journal, places)
    heights_mm, stiffness = touched(station, spec, spots, stated_mm, plan.settings)
    return touched_surface(spec, plan.face, places, heights_mm), stiffness
