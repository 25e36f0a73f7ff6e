"""`instobj collect`: a board's readings and their labels, into a recording that grows."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Generator, Iterator
from contextlib import closing
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import numpy as np

from design.errors import InputError, StoreError
from estimator.boards.growing import GrowingRecording, finish_recording, growing_recording
from estimator.boards.lines import Frame, Header, LineDecoder, Load, Message, Status
from estimator.boards.link import BoardClock, board_messages, serial_chunks
from instobj.commands.hardware.board_state import status_row, status_text
from instobj.commands.hardware.collect_options import (
    CollectOptions,
    Place,
    TypedLines,
    open_source,
    parse_place,
    stop_on_signals,
)
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows

STALE_S = 1.0
"""A load cell's last line labels frames for so long."""
_PAUSE_S = 1.0
_KEYS = "z takes the baseline, q ends, FACE:X,Y sets the contact location, - none, Enter continues"


@dataclass
class _Collection:
    """State between two lines.

    With forces given by hand, `waiting` is from the zero until the user says that the weight lies.
    """

    options: CollectOptions
    places: list[Place | None]
    decoder: LineDecoder = field(default_factory=LineDecoder)
    clock: BoardClock = field(default_factory=BoardClock)
    load_clock: BoardClock = field(default_factory=BoardClock)
    channels: tuple[str, ...] = ()
    loads: dict[int, tuple[float, Load]] = field(default_factory=dict)
    zero_left: int = 0
    zero_counts: list[tuple[float, ...]] = field(default_factory=list)
    last_counts: tuple[float, ...] = ()
    steps_s: deque[float] = field(default_factory=lambda: deque(maxlen=500))
    first_s: float | None = None
    last_s: float = 0.0
    unlabelled: int = 0
    waiting: bool = False
    stopped: bool = False
    status: Status | None = None

    @property
    def cells(self) -> int:
        """Load cells of the recording."""
        return self.options.cells or 1

    @property
    def tips(self) -> int:
        """Tips per load cell."""
        return self.options.tips or 1

    def stop(self) -> None:
        """End after the line at hand."""
        self.stopped = True


def collect(options: CollectOptions) -> dict[str, Any]:
    """Collect until told to stop; the document says what came and what was lost.

    Raises
    ------
    InputError
        Bad options, no board, or a line that broke off; what had come is kept and finished.
    """
    chunks, options = open_source(options)
    state = _Collection(options, options.first_places, zero_left=options.zero_frames)
    progress, failure = ProgressLine(), None
    growing: GrowingRecording | None = None
    with (
        progress.stage(f"collecting {options.csv_path}"),
        stop_on_signals(state.stop),
        closing(chunks),
    ):
        try:
            stream = board_messages(chunks, state.decoder, options.source)
            first = _until_header(stream, state)
            with (
                closing(_load_messages(state)) as loads,
                growing_recording(
                    options.csv_path, state.channels, state.cells, state.tips, options.session
                ) as growing,
            ):
                _run(chain([first], stream), loads, state, growing, progress)
        except (InputError, StoreError) as error:
            failure = error
    if growing is None or not growing.rows_before + growing.rows_added:
        raise failure or InputError(
            f"no labelled frame came ({_counts_text(state)}). Give a load cell's lines, or --force"
        )
    frames = finish_recording(options.csv_path, options.target)
    if failure is not None:
        raise InputError(f"{failure} ({growing.rows_added} frames kept in {options.csv_path})")
    return _document(state, growing, frames)


def _until_header(stream: Iterator[list[Message]], state: _Collection) -> list[Message]:
    """The messages among which the board names its channels."""
    for messages in stream:
        headers = [message for message in messages if isinstance(message, Header)]
        if headers:
            state.channels = headers[0].channels
            return messages
        if state.stopped:
            break
    raise InputError(f"{state.options.source} named no channels. Nothing was written")


def _run(
    stream: Iterator[list[Message]],
    loads: Iterator[list[Load]],
    state: _Collection,
    growing: GrowingRecording,
    progress: ProgressLine,
) -> None:
    typed = TypedLines()
    shown_s, every_s = time.monotonic(), 5.0
    if progress.console.is_terminal:
        every_s = 0.5
        progress.say(_KEYS)
    for messages in stream:
        for message in next(loads):
            _take_load(message, state, state.load_clock)
        for line in typed.poll():
            _obey(line, state, progress)
        for message in messages:
            if isinstance(message, Load):
                _take_load(message, state, state.clock)
            elif isinstance(message, Frame) and not _enough(state, growing):
                _take_frame(message, state, growing)
            elif isinstance(message, Status):
                state.status = message
            elif isinstance(message, Header) and message.channels != state.channels:
                raise InputError("the board names other channels than before. Was it exchanged?")
        if time.monotonic() - shown_s > every_s:
            shown_s = time.monotonic()
            progress.step(f"{_counts_text(state)}; {_change_text(state)}")
        if state.stopped or _enough(state, growing):
            return


def _load_messages(state: _Collection) -> Generator[list[Load]]:
    """What the second port has said since the last time."""
    if state.options.load_port is None:
        while True:
            yield []
    decoder = LineDecoder()
    for chunk in serial_chunks(state.options.load_port, state.options.baud, timeout_s=0.0):
        yield [message for message in decoder.feed(chunk) if isinstance(message, Load)]


def _take_load(load: Load, state: _Collection, clock: BoardClock) -> None:
    if load.cell > state.cells or len(load.tips_mm) > state.tips:
        raise InputError(
            f"a line came from load cell {load.cell} with {len(load.tips_mm)} tips; this recording "
            f"holds {state.cells} cells and {state.tips} tips. Give --cells and --tips"
        )
    state.loads[load.cell] = (clock.time_s(load.board_ms, time.time()), load)


def _take_frame(frame: Frame, state: _Collection, growing: GrowingRecording) -> None:
    time_s = state.clock.time_s(frame.board_ms, time.time())
    zeroing = state.zero_left > 0
    labels = [_label(cell, time_s, zeroing, state) for cell in range(1, state.cells + 1)]
    known = [label for label in labels if label is not None]
    if len(known) < state.cells or (state.waiting and not zeroing):
        state.unlabelled += 1
        return
    flat = [value for label in known for value in label]
    growing.append([time_s, float(growing.session), float(zeroing), *frame.counts, *flat])
    state.steps_s.append(min(max(time_s - state.last_s, 0.0), _PAUSE_S))
    state.first_s = time_s if state.first_s is None else state.first_s
    state.last_s, state.last_counts = time_s, frame.counts
    if zeroing:
        state.zero_left -= 1
        state.zero_counts.append(frame.counts)
        state.waiting = bool(state.options.forces_n)


def _label(cell: int, time_s: float, zeroing: bool, state: _Collection) -> list[float] | None:
    """Force, face and contact locations of a load cell; None where no force is known."""
    heard_s, load = state.loads.get(cell, (-np.inf, None))
    place = state.places[cell - 1]
    if load is not None and load.face is not None:
        place = Place(load.face, load.tips_mm) if load.face else None
    place = None if zeroing else place
    force_n = _force_n(cell, place, load if time_s - heard_s <= STALE_S else None, state)
    if force_n is None:
        return None
    tips = [] if place is None else [value for tip in place.tips_mm for value in tip]
    face = float("nan") if place is None else float(place.face)
    return [force_n, face, *tips, *[float("nan")] * (2 * state.tips - len(tips))]


def _force_n(cell: int, place: Place | None, load: Load | None, state: _Collection) -> float | None:
    """What the load cell says now; else, where none ever spoke, what the command line says."""
    if load is not None:
        return load.force_n
    if cell in state.loads or state.options.load_port is not None:
        return None
    given = state.options.forces_n[cell - 1 : cell]
    if place is None:
        return 0.0 if given or state.zero_left else None
    return given[0] if given else None


def _obey(line: str, state: _Collection, progress: ProgressLine) -> None:
    """One typed line."""
    if line == "q":
        state.stopped = True
    elif line == "z":
        state.zero_left, state.zero_counts = max(1, state.options.zero_frames or 20), []
        progress.say(f"baseline: {state.zero_left} frames, touch nothing")
        state.waiting = False
    elif not line:
        state.waiting = False
    else:
        try:
            places = [parse_place(text) for text in line.split()]
        except InputError as error:
            progress.say(f"{error}; {_KEYS}")
            return
        if len(places) > state.cells or any(p and len(p.tips_mm) > state.tips for p in places):
            progress.say(
                f"more contact locations than {state.cells} load cells and {state.tips} tips"
            )
            return
        state.places[: len(places)] = places
        state.waiting = False
        progress.say(f"contact location from now on: {line}")


def _enough(state: _Collection, growing: GrowingRecording) -> bool:
    lasted_s = state.last_s - state.first_s if state.first_s is not None else 0.0
    return state.options.enough(growing.rows_added, lasted_s)


def _rate_hz(state: _Collection) -> float:
    """Frames per second over the last 500 steps without pauses."""
    steps_s = [step for step in state.steps_s if 0 < step < _PAUSE_S]
    return len(steps_s) / sum(steps_s) if steps_s else float("nan")


def _counts_text(state: _Collection) -> str:
    found = state.decoder.statistics
    return (
        f"{found.frames} frames at {_rate_hz(state):.1f}/s, {found.lost_frames} lost, "
        f"{found.damaged_lines} damaged lines, {found.restarts} restarts, "
        f"{state.unlabelled} without a force"
    )


def _change_text(state: _Collection) -> str:
    """Largest change against the zero, and the forces."""
    if not state.zero_counts or not state.last_counts:
        return "not zeroed"
    change = np.asarray(state.last_counts) - np.mean(state.zero_counts, axis=0)
    if np.isnan(change).all():
        return "no reading"
    largest = int(np.nanargmax(np.abs(change)))
    forces = ", ".join(f"{load.force_n:.2f} N" for _, (_, load) in sorted(state.loads.items()))
    return f"largest change {state.channels[largest]} {change[largest]:+.0f}" + (
        f", force {forces}" if forces else ""
    )


def _document(state: _Collection, growing: GrowingRecording, frames: int) -> dict[str, Any]:
    csv_path, target = state.options.csv_path, state.options.target
    found = state.decoder.statistics
    texts = [_counts_text(state), f"{growing.rows_added} frames added, {frames} in the recording"]
    if state.status is not None:
        texts.append(status_text(state.status))
    if growing.cut_bytes:
        texts.append(f"an unfinished last line of {growing.cut_bytes} bytes was cut off")
    texts.append(f"next: instobj recordings {target}")
    return {
        "command": "collect",
        "frames_added": growing.rows_added,
        "frames": frames,
        "session": growing.session,
        "rate_hz": None if np.isnan(_rate_hz(state)) else round(_rate_hz(state), 3),
        "lost_frames": found.lost_frames,
        "damaged_lines": found.damaged_lines,
        "restarts": found.restarts,
        "frames_without_force": state.unlabelled,
        "board": None if state.status is None else status_row(state.status),
        "texts": texts,
        "files": file_rows([csv_path, target]),
    }
