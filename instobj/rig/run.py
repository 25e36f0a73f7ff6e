"""A run on a press rig: the machine made ready, heights touched, presses done and recorded."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from design.errors import InputError, InstobjError
from design.layout.body import face_frame
from design.layout.tips import tip_places_mm
from design.spec.object import ObjectSpec
from estimator.recordings.boards.growing import growing_recording
from estimator.recordings.boards.link import serial_chunks
from instobj.rig.cycle import end_rows, greet, home, press, raise_tip, take_tare
from instobj.rig.grbl import grbl_link, until
from instobj.rig.grbl_lines import TRAVEL_SETTINGS
from instobj.rig.journal import Journal
from instobj.rig.load_lines import forces_on
from instobj.rig.mounting import (
    Surface,
    highest_mm,
    require_travel,
    require_upright,
    safe_height_mm,
    touch_places,
    touched_surface,
)
from instobj.rig.plan import face_places
from instobj.rig.press_code import press_code
from instobj.rig.station import Spot, Station
from instobj.rig.touch import touched

Say = Callable[[str], None]
_AFTER_S = 1.0
"""Between the last row of a recording and the first that is added, at least."""
_HEARD_S = 10.0
_TARE_FRAMES = 10


@dataclass(frozen=True)
class Ports:
    """Where machine, board and load cell are; `load_scale` None: the load cell sends lines `L`."""

    machine: str
    board: str
    load: str | None = None
    machine_baud: int = 115_200
    board_baud: int = 115_200
    load_scale: float | None = None
    lost_s: float = 1.5


@contextmanager
def station_on(ports: Ports, limit_n: float) -> Iterator[Station]:
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
    with grbl_link(ports.machine, ports.machine_baud) as link:
        station = Station(link, board, loads, limit_n, ports.lost_s)
        greet(station)

        def heard() -> bool:
            return bool(station.channels and station.frames and station.cell.readings)

        try:
            until(link, station.tick, heard, "board or load cell", _HEARD_S)
        except InputError:
            missing = "load cell" if station.frames else "board"
            raise InputError(
                f"the {missing} said nothing sound within {_HEARD_S:g} s. Check --board-port, --load-port, "
                "the baud rate, and that the load cell sends lines (`instobj docs recordings`)"
            ) from None
        yield station


def check_plan(spec: ObjectSpec, journal: Journal, settings: dict[int, float]) -> list[str]:
    """The plan in words, checked against the machine.

    Raises
    ------
    InputError
        A face that leans, places out of the machine's travel, or presses too long for its buffer.
    """
    plan, mounting = journal.plan, journal.mounting
    places = np.concatenate([plan.places_mm, touch_places(face_places(spec, plan.face))])
    require_upright(spec, plan.face, places)
    machine = mounting.machine_mm(face_frame(spec, plan.face).to_plane(places))
    low, high = machine.min(axis=0), machine.max(axis=0)
    corners = [(axis, float(end[k])) for k, axis in enumerate("XY") for end in (low, high)]
    require_travel(settings, corners)
    press_code(plan.settings, -settings[TRAVEL_SETTINGS[2]], highest_mm(settings))
    one, left, again = plan.settings, len(journal.remaining), ""
    if one.strokes > 1:
        again = (
            f", {one.strokes} strokes a press, from the second at {one.stroke_speed_mm_s:g} mm/s"
        )
    return [
        f"face {plan.face} of {plan.object_name}: {left} of {len(plan)} presses to do, about "
        f"{plan.seconds * left / len(plan) / 60:.0f} minutes",
        f"machine's frame: X {low[0]:.1f} to {high[0]:.1f}, Y {low[1]:.1f} to {high[1]:.1f} mm, Z from "
        f"{highest_mm(settings):g} mm down until the load cell says {one.touch_n:g} N",
        f"stops {', '.join(f'{depth:g}' for depth in one.depths_mm)} mm below the first touch, "
        f"{one.speed_mm_s:g} mm/s{again}; a press ends at {one.full_n:g} N, everything stops at "
        f"{one.limit_n:g} N",
        "the machine homes first, upwards; keep hands away and the emergency stop near",
    ]


def spot_of(spec: ObjectSpec, journal: Journal, xy_mm: tuple[float, float]) -> Spot:
    """A place with its tips and the machine's X and Y."""
    tips = np.asarray(xy_mm) + tip_places_mm(spec.indenter)
    over = face_frame(spec, journal.plan.face).to_plane(np.array(xy_mm))
    x, y = journal.mounting.machine_mm(over).tolist()
    return Spot(journal.plan.face, tuple((float(a), float(b)) for a, b in tips), (x, y))


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
        recording, station.channels, 1, tips, journal.session, travel=True
    ) as station.growing:
        station.clock.not_before_s = station.growing.last_s + _AFTER_S
        try:
            _presses(station, spec, journal, say)
        except InstobjError as error:
            journal.note("stopped", reason=str(error))
            raise InputError(f"{error}. {_raised(station)}; --resume goes on") from None
        finally:
            station.close_rows()


def _raised(station: Station) -> str:
    if not station.machine.trusted and station.machine.alarm is None:
        return "Nothing was moved" if not station.safe_mm else "Where the tip is is not known"
    try:
        raise_tip(station)
    except InstobjError as error:
        return f"The tip could NOT be raised ({error})"
    return "The tip is up"


def _presses(station: Station, spec: ObjectSpec, journal: Journal, say: Say) -> None:
    plan = journal.plan
    home(station)
    take_tare(station, _TARE_FRAMES)
    surface = _touched_surface(station, spec, journal)
    journal.note("touched", plane=list(surface.plane), uneven_mm=surface.uneven_mm)
    say(f"touched at Z = {surface.plane[0]:.2f} mm, uneven by {surface.uneven_mm:.2f} mm")
    wanted_mm = _highest(surface, journal) + plan.settings.clearance_mm
    station.safe_mm = safe_height_mm(station.machine.settings, wanted_mm)
    raise_tip(station)
    rest_frames = max(5, round(plan.settings.rest_s * spec.sensors.frame_rate_hz))
    for number in journal.remaining:
        spot = spot_of(spec, journal, plan.places_mm[number])
        height_mm = float(surface.height_mm(np.array(plan.places_mm[number])))
        journal.note("begun", press=number, row=_rows(station))
        largest_n = press(station, spot, height_mm, plan.settings, rest_frames)
        journal.note("finished", press=number, row=_rows(station), largest_n=round(largest_n, 3))
        say(f"press {len(journal.finished)} of {len(plan)}: {largest_n:.2f} N")
    end_rows(station)


def _rows(station: Station) -> int:
    growing = station.growing
    return 0 if growing is None else growing.rows_before + growing.rows_added


def _highest(surface: Surface, journal: Journal) -> float:
    return float(surface.height_mm(np.array(journal.plan.places_mm)).max())


def _touched_surface(station: Station, spec: ObjectSpec, journal: Journal) -> Surface:
    plan = journal.plan
    places = touch_places(face_places(spec, plan.face))
    spots = [spot_of(spec, journal, (float(x), float(y))) for x, y in places]
    heights = touched(station, spec, spots, plan.settings)
    return touched_surface(spec, plan.face, places, heights)
