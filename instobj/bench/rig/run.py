"""A run on a press rig: the machine made ready, heights touched, presses done and recorded."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float

from design.errors import InputError, InstobjError
from design.layout.body import face_frame
from design.layout.tips import tip_places_mm
from design.spec.object import ObjectSpec
from estimator.recordings.boards.growing import growing_recording
from estimator.recordings.boards.link import serial_chunks
from instobj.bench.rig.chips import Chips
from instobj.bench.rig.contact_law import ContactLaw, contact_law
from instobj.bench.rig.cycle import (
    end_rows,
    greet,
    home,
    learn_rest,
    press,
    raise_and_listen,
    take_tare,
)
from instobj.bench.rig.dialects import Dialect
from instobj.bench.rig.journal import Journal
from instobj.bench.rig.load_cell import LoadCell, largest_reading_n
from instobj.bench.rig.load_lines import forces_on
from instobj.bench.rig.machine import MachineFault, MachineLink, machine_link, until
from instobj.bench.rig.mounting import (
    Surface,
    relief_mm,
    require_travel,
    require_upright,
    safe_height_mm,
    touch_places,
    touched_surface,
)
from instobj.bench.rig.phases import Phase
from instobj.bench.rig.plan import PressSettings, face_places
from instobj.bench.rig.press_code import press_code
from instobj.bench.rig.station import Spot, Station
from instobj.bench.rig.touch import BELOW_MM, touched
from instobj.bench.rig.witnesses import Witnesses

Say = Callable[[str], None]
_AFTER_S = 1.0
"""Between the last row of a recording and the first that is added, at least."""
_HEARD_S = 10.0


@dataclass(frozen=True)
class Ports:
    """Ports of machine, board and load cell; `load_scale` None: the load cell sends lines `L`."""

    machine: str
    board: str
    load: str | None = None
    board_baud: int = 115_200
    load_scale: float | None = None
    lost_s: float = 1.5


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
        station = new_station(link, board, loads, spec, limit_n, ports.lost_s)
        make_ready(station)
        yield station


def new_station(
    machine: MachineLink,
    board: Iterator[bytes],
    loads: Iterator[list[float]] | None,
    spec: ObjectSpec,
    limit_n: float,
    lost_s: float = Ports.lost_s,
) -> Station:
    """Three lines with what the specification lets expect of cell and chips."""
    cell = LoadCell(largest_reading_n(spec.load_cell) if loads is None else math.inf)
    chips = Chips(spec.sensors.noise_counts, spec.sensors.drift_counts)
    witnesses = Witnesses(cell, chips, contact_law(spec))
    return Station(machine, board, loads, limit_n, lost_s, witnesses)


def make_ready(station: Station) -> None:
    """The machine stopped, its settings read, and all three lines heard.

    Raises
    ------
    InputError
        One of them says nothing sound.
    """
    greet(station)

    def heard() -> bool:
        return bool(station.channels and station.frames and station.cell.readings)

    try:
        until(station.machine, station.tick, heard, "board or load cell", _HEARD_S)
    except MachineFault:
        missing = "load cell" if station.frames else "board"
        raise InputError(
            f"the {missing} said nothing sound within {_HEARD_S:g} s. Check --board-port, --load-port, "
            "the baud rate, and that the load cell sends lines (`instobj docs recordings`)"
        ) from None


def check_plan(spec: ObjectSpec, journal: Journal, machine: MachineLink) -> list[str]:
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
    expected = _expected_mm(spec, journal, places)
    lowest_mm = float(expected.min()) - BELOW_MM - plan.settings.depths_mm[-1]
    require_travel(travel, [("Z", lowest_mm), ("Z", float(expected.max()))])
    _require_bounded(contact_law(spec), plan.settings)
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
        f"mm; {BELOW_MM:g} mm below it the way down ends, whatever the load cell says",
        f"stops {', '.join(f'{depth:g}' for depth in press.depths_mm)} mm below the first touch, "
        f"{press.speed_mm_s:g} mm/s{strokes_text}; a press ends at {press.full_n:g} N, "
        f"everything stops at {press.limit_n:.3g} N",
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


def _expected_mm(
    spec: ObjectSpec, journal: Journal, xy_mm: Float[np.ndarray, "place 2"]
) -> Float[np.ndarray, "place"]:
    """Machine Z of the specification's surface at places, as it was mounted."""
    return journal.mounting.middle_mm[2] + relief_mm(spec, journal.plan.face, xy_mm)


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
    home(station)
    learn_rest(station)
    surface, stiffness = _touched_surface(station, spec, journal)
    # As stiff as measured or as expected, whichever is more: the limit must hold where the cell lies.
    deepest_mm = station.witnesses.law.depth_mm(station.limit_n, max(stiffness, 1.0))
    settings = plan.settings.down_to(deepest_mm)
    journal.note("touched", plane=list(surface.plane), uneven_mm=surface.uneven_mm)
    say(
        f"touched at Z = {surface.plane[0]:.2f} mm, uneven by {surface.uneven_mm:.2f} mm, "
        f"{stiffness:.2f} times as stiff as expected; presses end {settings.depths_mm[-1]:.2f} mm deep"
    )
    wanted_mm = _highest(surface, journal) + plan.settings.clearance_mm
    station.safe_mm = safe_height_mm(station.machine.travel.top_mm, wanted_mm)
    raise_and_listen(station)
    rest_frames = max(5, round(plan.settings.rest_s * spec.sensors.frame_rate_hz))
    for number in journal.remaining:
        spot = spot_of(spec, journal, plan.places_mm[number])
        height_mm = float(surface.height_mm(np.array(plan.places_mm[number])))
        journal.note("begun", press=number, row=_rows(station))
        largest_n = press(station, spot, height_mm, settings, rest_frames)
        journal.note("finished", press=number, row=_rows(station), largest_n=round(largest_n, 3))
        say(f"press {len(journal.finished)} of {len(plan)}: {largest_n:.2f} N")
    station.resting = True  # the last press has an unloaded level behind it too
    take_tare(station, rest_frames)
    end_rows(station)


def _rows(station: Station) -> int:
    growing = station.growing
    return 0 if growing is None else growing.rows_before + growing.rows_added


def _highest(surface: Surface, journal: Journal) -> float:
    return float(surface.height_mm(np.array(journal.plan.places_mm)).max())


def _touched_surface(station: Station, spec: ObjectSpec, journal: Journal) -> tuple[Surface, float]:
    plan = journal.plan
    places = touch_places(face_places(spec, plan.face))
    spots = [spot_of(spec, journal, (float(x), float(y))) for x, y in places]
    expected_mm = _expected_mm(spec, journal, places)
    heights_mm, stiffness = touched(station, spec, spots, expected_mm, plan.settings)
    return touched_surface(spec, plan.face, places, heights_mm), stiffness
