"""Input of `instobj bench collect`: options at its start, lines typed while it runs, and Ctrl-C."""

from __future__ import annotations

import os
import re
import select
import signal
import sys
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from math import isfinite
from pathlib import Path

from design.errors import InputError
from estimator.recordings.boards.link import replay_chunks, serial_chunks

_NOWHERE = re.compile(r"-(?::-)*")
_TRAVEL = re.compile(r"([^=]*)=(\d+(?:\.\d*)?)mm")
_PLACE = re.compile(r"([1-6])((?::-?\d+(?:\.\d*)?,-?\d+(?:\.\d*)?)+)")


@dataclass(frozen=True)
class CollectOptions:
    """Options of the command line; `places` are those of load cells 1, 2, …, `tips` the most of one."""

    out: Path
    port: str | None = None
    replay: Path | None = None
    load_port: str | None = None
    baud: int = 115_200
    speed: float = 1.0
    places: tuple[str, ...] = ()
    cells: int | None = None
    tips: int | None = None
    zero_frames: int = 20
    seconds: float | None = None
    frames: int | None = None

    @property
    def csv_path(self) -> Path:
        """The recording that grows."""
        return self.out.with_name(self.out.name.removesuffix(".nc").removesuffix(".csv") + ".csv")

    @property
    def target(self) -> Path:
        """The recording under its final name."""
        return self.csv_path.with_suffix(".nc")

    @property
    def source(self) -> str:
        """Port or file, for messages."""
        return str(self.port or self.replay)

    @property
    def first_places(self) -> list[Place | None]:
        """Return what each load cell presses at first."""
        places = [parse_place(text.partition("=")[0]) for text in self.places]
        return places + [None] * ((self.cells or 1) - len(places))

    @property
    def forces_n(self) -> list[float | None]:
        """Return the constant force (N) of each load cell that `=N` gives one."""
        return [_force_n(text) for text in self.places]

    @property
    def travel_mm(self) -> float | None:
        """Return the travel that labels the first press where no load cell does, as `3:0,0=2mm` gives it.

        Raises
        ------
        InputError
            Several places or tips, or a load cell as well.
        """
        travels = [travel_of(text)[1] for text in self.places]
        if not any(travel is not None for travel in travels):
            return None
        if len(travels) > 1 or self.load_port is not None or self.places[0].count(":") > 1:
            raise InputError(
                f"--place {self.places[0]}: travel labels presses of one tip without a load cell. Give one "
                "--place of one tip, and no --load-port"
            )
        return travels[0]

    def enough(self, frames: int, seconds: float) -> bool:
        """Return whether this many frames, or this long, are what was asked for."""
        return (self.frames is not None and frames >= self.frames) or (
            self.seconds is not None and seconds >= self.seconds
        )


@dataclass(frozen=True)
class Place:
    """Face pressed and the places (mm) of the tips on it."""

    face: int
    tips_mm: tuple[tuple[float, float], ...]


def parse_place(text: str) -> Place | None:
    """`3:1.5,4.5` is face 3 at (1.5, 4.5) mm, `3:0,7.5:0,-7.5` two tips, `-` or `-:-` nothing pressed.

    Raises
    ------
    InputError
        Anything else.
    """
    if _NOWHERE.fullmatch(text):
        return None
    match = _PLACE.fullmatch(text)
    if match is None:
        raise InputError(
            f"{text!r} is not a contact location. Give FACE:X,Y in mm, such as 3:1.5,-4.5, with :X,Y "
            "for each further tip, or - where nothing is pressed (-:- by two tips)"
        )
    pairs = [pair.split(",") for pair in match[2][1:].split(":")]
    return Place(int(match[1]), tuple((float(x), float(y)) for x, y in pairs))


def travel_of(text: str) -> tuple[str, float | None]:
    """Return place and travel (mm) of `3:0,0=2mm`; the text itself and None where it gives no travel."""
    match = _TRAVEL.fullmatch(text)
    return (text, None) if match is None else (match[1], float(match[2]))


def _force_n(text: str) -> float | None:
    place, equals, given = text.partition("=")
    if not equals or travel_of(text)[1] is not None:
        return None
    try:
        force_n = float(given)
    except ValueError:
        force_n = float("nan")
    if not isfinite(force_n):
        raise InputError(
            f"--place {text}: {given!r} is no force in N. Give one, such as {place}=9.81, or a travel, "
            f"{place}=2mm"
        )
    return force_n


def open_source(options: CollectOptions) -> tuple[Generator[bytes], CollectOptions]:
    """The bytes to read, and the options with `cells` and `tips` filled in.

    Raises
    ------
    InputError
        Not exactly one source, a recording replayed into itself, or no places.
    """
    if (options.port is None) == (options.replay is None):
        raise InputError("give either --port or --replay: where the readings come from")
    _ = options.first_places, options.forces_n, options.travel_mm  # refused before a port is opened
    cells = max(1, len(options.places))
    tips = max([1, *(max(1, text.count(":") + text.startswith("-")) for text in options.places)])
    if options.replay is not None:
        from estimator.recordings.formats.files import read_table

        outputs = (options.csv_path.resolve(), options.target.resolve())
        if options.replay.resolve() in outputs:
            raise InputError(f"{options.replay} cannot be replayed into itself. Give another name")
        table = read_table(options.replay)
        chunks = replay_chunks(table, options.speed)
        cells, tips = max(cells, table.tip_xy_mm.shape[1]), max(tips, table.tip_xy_mm.shape[2])
    else:
        chunks = serial_chunks(options.port or "", options.baud)
    return chunks, replace(options, cells=options.cells or cells, tips=options.tips or tips)


@dataclass
class TypedLines:
    """Lines from standard input (typed or piped), without ever waiting; POSIX systems only."""

    _rest: bytes = b""
    _open: bool = os.name == "posix"

    @property
    def ended(self) -> bool:
        """Return whether no line can come any more."""
        return not self._open

    def poll(self) -> list[str]:
        """Lines that were completed since the last time."""
        if not self._open:
            return []
        try:
            handle = sys.stdin.fileno()
            if not select.select([handle], [], [], 0)[0]:
                return []
            data = os.read(handle, 4096)
        except (AttributeError, OSError, ValueError):
            data = b""
        self._open = bool(data)
        *lines, self._rest = (self._rest + data).split(b"\n")
        return [line.decode("utf-8", "replace").strip() for line in lines]


@contextmanager
def stop_on_signals(stop: Callable[[], None]) -> Iterator[None]:
    """Ctrl-C and SIGTERM call `stop` once; the next one acts as it did before."""
    numbers = (signal.SIGINT, signal.SIGTERM)
    handlers = {number: signal.getsignal(number) for number in numbers}

    def ask(number: int, _: object) -> None:
        stop()
        signal.signal(number, handlers[signal.Signals(number)])

    for number in numbers:
        signal.signal(number, ask)
    try:
        yield
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)
