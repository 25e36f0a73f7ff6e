"""Frames of a board with their labels: what load cells say, or the command line, as rows of a recording."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Generator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field

import numpy as np

from design.errors import InputError
from estimator.recordings.boards.growing import GrowingRecording, growing_recording
from estimator.recordings.boards.lines import Frame, LineDecoder, Load, Status
from estimator.recordings.boards.link import BoardClock, serial_chunks
from instobj.bench.collect.options import CollectOptions, Place

STALE_S = 1.0
"""A load cell's last line labels frames for so long."""
PAUSE_S = 1.0
"""A longer step between frames is a pause."""
_READINGS_KEPT = 200
"""Latest readings of a load cell that are kept."""


_CLOCK_SHARE, _CLOCK_S = 0.1, 3.0
"""Error of a board's clock against this computer's: quartzes and resonators are off by less than 1 %,
lines wait in buffers for a second or two."""


@dataclass
class Pace:
    """A board's clock against this computer's, from its first frame on (s)."""

    here_s: float = 0.0
    board_s: float = 0.0
    _first: tuple[float, float] | None = None

    def take(self, board_s: float, here_s: float) -> None:
        """Times of a frame."""
        self._first = self._first or (board_s, here_s)
        self.board_s, self.here_s = board_s - self._first[0], here_s - self._first[1]

    @property
    def text(self) -> str:
        """Return what is wrong with the board's clock, in words; empty where nothing is."""
        off_s = self.board_s - self.here_s
        if abs(off_s) <= _CLOCK_S + _CLOCK_SHARE * self.here_s:
            return ""
        return (
            f"the board's clock went {self.board_s:.4g} s in {self.here_s:.4g} s of this computer's, so the "
            "times of the recording are wrong. A board must send whole milliseconds: does it send "
            "microseconds, or did its clock jump?"
        )


@dataclass
class Collection:
    """State between two lines.

    `loads` hold the last line of every load cell and `readings` the last ones (time in s, force in N).
    `travel_mm` labels presses where no load cell does; None where one does. With labels given by hand,
    `waiting` is from the zero until the user says that the weight lies, or that the tip is there.
    """

    options: CollectOptions
    places: list[Place | None]
    decoder: LineDecoder = field(default_factory=LineDecoder)
    clock: BoardClock = field(default_factory=BoardClock)
    load_clock: BoardClock = field(default_factory=BoardClock)
    pace: Pace = field(default_factory=Pace)
    channels: tuple[str, ...] = ()
    loads: dict[int, tuple[float, Load]] = field(default_factory=dict)
    readings: dict[int, deque[tuple[float, float]]] = field(default_factory=dict)
    zero_left: int = 0
    zero_counts: list[tuple[float, ...]] = field(default_factory=list)
    last_counts: tuple[float, ...] = ()
    steps_s: deque[float] = field(default_factory=lambda: deque(maxlen=500))
    began_s: float = 0.0
    first_s: float | None = None
    last_s: float = 0.0
    unlabelled: int = 0
    waiting: bool = False
    stopped: bool = False
    status: Status | None = None
    travel_mm: float | None = field(init=False)

    def __post_init__(self) -> None:
        self.travel_mm = self.options.travel_mm

    @property
    def cells(self) -> int:
        """Load cells of the recording."""
        return self.options.cells or 1

    @property
    def tips(self) -> int:
        """Tips per load cell."""
        return self.options.tips or 1

    def recording(self) -> AbstractContextManager[GrowingRecording]:
        """Open the recording that its frames are appended to."""
        by_travel = self.travel_mm is not None
        return growing_recording(
            self.options.csv_path, self.channels, self.cells, self.tips,
            travel=by_travel, force=not by_travel,
        )  # fmt: skip

    def stop(self) -> None:
        """End after the line at hand."""
        self.stopped = True


def load_lines(options: CollectOptions) -> Generator[list[Load]]:
    """Yield what load cells on a port of their own have said since the last time."""
    if options.load_port is None:
        while True:
            yield []
    decoder = LineDecoder()
    for chunk in serial_chunks(options.load_port, options.baud, timeout_s=0.0):
        yield [message for message in decoder.feed(chunk) if isinstance(message, Load)]


def take_load(load: Load, state: Collection, clock: BoardClock) -> None:
    """Keep what a load cell says.

    Raises
    ------
    InputError
        The recording has no room for that cell or for that many tips.
    """
    if load.cell > state.cells or len(load.tips_mm) > state.tips:
        raise InputError(
            f"a line came from load cell {load.cell} with {len(load.tips_mm)} tips; this recording "
            f"holds {state.cells} cells and {state.tips} tips. Give --place - for each cell, -:- for two tips"
        )
    time_s = clock.time_s(load.board_ms, time.time())
    state.loads[load.cell] = (time_s, load)
    kept = state.readings.setdefault(load.cell, deque(maxlen=_READINGS_KEPT))
    kept.append((time_s, load.force_n))


def take_frame(frame: Frame, time_s: float, state: Collection, growing: GrowingRecording) -> None:
    """Append a frame of `time_s` (by `state.clock`) whose force is known; count one without."""
    zeroing = state.zero_left > 0
    if state.travel_mm is None:
        labels = [_label(cell, time_s, zeroing, state) for cell in range(1, state.cells + 1)]
    else:
        labels = [_travel_label(None if zeroing else state.places[0], state.travel_mm)]
    labels_known = [label for label in labels if label is not None]
    if len(labels_known) < state.cells or (state.waiting and not zeroing):
        state.unlabelled += 1
        return
    flat = [value for label in labels_known for value in label]
    growing.append([time_s, float(growing.session), float(zeroing), *frame.counts, *flat])
    state.steps_s.append(min(max(time_s - state.last_s, 0.0), PAUSE_S))
    state.first_s = time_s if state.first_s is None else state.first_s
    state.last_s, state.last_counts = time_s, frame.counts
    if zeroing:
        state.zero_left -= 1
        state.zero_counts.append(frame.counts)
        given = (*state.options.forces_n, state.travel_mm)
        state.waiting = any(label is not None for label in given)


def _travel_label(place: Place | None, travel_mm: float) -> list[float]:
    """Face, contact location and travel of a press; nothing where none is."""
    return [float("nan")] * 4 if place is None else [place.face, *place.tips_mm[0], travel_mm]


def _label(cell: int, time_s: float, zeroing: bool, state: Collection) -> list[float] | None:
    """Force, face and contact locations of a load cell; None where no force is known."""
    heard_s, load = state.loads.get(cell, (-np.inf, None))
    place = state.places[cell - 1]
    if load is not None and load.face is not None:
        place = Place(load.face, load.tips_mm) if load.face else None
    place = None if zeroing else place
    force_n = _force_n(cell, place, load if time_s - heard_s <= STALE_S else None, time_s, state)
    if force_n is None:
        return None
    tips = [] if place is None else [value for tip in place.tips_mm for value in tip]
    face = float("nan") if place is None else float(place.face)
    return [force_n, face, *tips, *[float("nan")] * (2 * state.tips - len(tips))]


def _force_n(
    cell: int, place: Place | None, load: Load | None, time_s: float, state: Collection
) -> float | None:
    """Return what the load cell says at that time, or the command line where no cell ever spoke."""
    if load is not None:
        return _label_at(time_s, load, state.readings[cell])
    if cell in state.loads or state.options.load_port is not None:
        return None
    given_n = next(iter(state.options.forces_n[cell - 1 : cell]), None)
    if place is None:
        return 0.0 if given_n is not None or state.zero_left else None
    return given_n


def _label_at(time_s: float, last: Load, readings: deque[tuple[float, float]]) -> float:
    """Between the readings before and after a time (N); the last one where none is newer or they are
    far apart."""
    after = next((k for k, (read_s, _) in enumerate(readings) if read_s >= time_s), None)
    if not after:
        return last.force_n if after is None else readings[0][1]
    (before_s, before_n), (after_s, after_n) = readings[after - 1], readings[after]
    if not 0 < after_s - before_s <= STALE_S:
        return after_n
    return before_n + (after_n - before_n) * (time_s - before_s) / (after_s - before_s)
