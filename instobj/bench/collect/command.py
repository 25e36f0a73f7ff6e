"""`instobj bench collect`: a board's readings and their labels, into a recording that grows."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import closing
from itertools import chain
from typing import Any

import numpy as np

from design.errors import InputError, RecordingError, StoreError
from estimator.recordings.boards.growing import (
    GrowingRecording,
    finish_recording,
)
from estimator.recordings.boards.lines import Frame, Header, Load, Message, Status
from estimator.recordings.boards.link import PATIENCE_S, board_messages
from instobj.bench.collect.board_state import status_row, status_text
from instobj.bench.collect.labelled_frames import (
    PAUSE_S,
    Collection,
    load_lines,
    take_frame,
    take_load,
)
from instobj.bench.collect.options import (
    CollectOptions,
    TypedLines,
    open_source,
    parse_place,
    stop_on_signals,
    travel_of,
)
from instobj.store.progress import NEWS_EVERY_S, ProgressLine
from instobj.store.publish import file_rows

_KEYS = "z takes the baseline, q ends, FACE:X,Y sets the contact location, - none, Enter continues"


def collect(options: CollectOptions) -> dict[str, Any]:
    """Collect until stopped; the document says what came and what was lost.

    Raises
    ------
    InputError
        Bad options, no board, or a line that broke off; what had come is kept and finished.
    """
    chunks, options = open_source(options)
    state = Collection(options, options.first_places, zero_left=options.zero_frames)
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
            with closing(load_lines(options)) as loads, state.recording() as growing:
                _run(chain([first], stream), loads, state, growing, progress)
        except (InputError, StoreError) as error:
            failure = error
    if growing is None or not growing.rows_before + growing.rows_added:
        raise failure or InputError(
            f"no labelled frame came ({_counts_text(state)}). Give a load cell's lines, or --place FACE:X,Y=N"
        )
    try:
        frames = finish_recording(options.csv_path, options.target)
    except RecordingError as error:
        raise InputError(
            f"{_pace_text(state) or error} ({growing.rows_added} frames kept in {options.csv_path})"
        ) from None
    if failure is not None:
        raise InputError(f"{failure} ({growing.rows_added} frames kept in {options.csv_path})")
    return _document(state, growing, frames)


def _until_header(stream: Iterator[list[Message]], state: Collection) -> list[Message]:
    """The messages among which the board names its channels, which it does when asked."""
    give_up_s = time.monotonic() + PATIENCE_S
    for messages in stream:
        headers = [message for message in messages if isinstance(message, Header)]
        if headers:
            state.channels, state.began_s = headers[0].channels, time.monotonic()
            return messages
        if state.stopped or time.monotonic() > give_up_s:
            break
    raise InputError(f"{state.options.source} named no channels. Nothing was written")


def _run(
    stream: Iterator[list[Message]],
    loads: Iterator[list[Load]],
    state: Collection,
    growing: GrowingRecording,
    progress: ProgressLine,
) -> None:
    typed = TypedLines()
    shown_s, every_s = time.monotonic(), NEWS_EVERY_S
    if progress.console.is_terminal:
        every_s = 0.5
        progress.say(_KEYS)
    for messages in stream:
        for message in next(loads):
            take_load(message, state, state.load_clock)
        for line in typed.poll():
            _obey(line, state, progress)
        for message in messages:
            if isinstance(message, Load):
                take_load(message, state, state.clock)
            elif isinstance(message, Frame) and not _enough(state, growing):
                now_s = time.time()
                time_s = state.clock.time_s(message.board_ms, now_s)
                state.pace.take(time_s, now_s)
                take_frame(message, time_s, state, growing)
            elif isinstance(message, Status):
                state.status = message
            elif isinstance(message, Header) and message.channels != state.channels:
                raise InputError("the board names other channels than before. Was it exchanged?")
        if time.monotonic() - shown_s > every_s:
            shown_s = time.monotonic()
            progress.step(f"{_counts_text(state)}; {_change_text(state)}")
        if state.stopped or _enough(state, growing):
            return


def _obey(line: str, state: Collection, progress: ProgressLine) -> None:
    """One typed line."""
    travel_mm = None
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
            if state.travel_mm is not None:
                line, travel_mm = travel_of(line)
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
        if travel_mm is not None:
            state.travel_mm = travel_mm
        state.waiting = False
        travel = "" if state.travel_mm is None else f", {state.travel_mm:g} mm deep"
        progress.say(f"contact location from now on: {line}{travel}")


def _enough(state: Collection, growing: GrowingRecording) -> bool:
    """Return whether enough was collected.

    This computer's clock decides where a board sends: the board's may be wrong, and frames may get no
    label. A replay has the times of its recording.
    """
    if state.options.replay is None:
        lasted_s = time.monotonic() - state.began_s
    else:
        lasted_s = state.last_s - state.first_s if state.first_s is not None else 0.0
    return state.options.enough(growing.rows_added, lasted_s)


def _rate_hz(state: Collection) -> float:
    """Frames per second over the last 500 steps without pauses."""
    steps_s = [step for step in state.steps_s if 0 < step < PAUSE_S]
    return len(steps_s) / sum(steps_s) if steps_s else float("nan")


def _counts_text(state: Collection) -> str:
    statistics = state.decoder.statistics
    return (
        f"{statistics.frames} frames at {_rate_hz(state):.1f}/s, {statistics.lost_frames} lost, "
        f"{statistics.damaged_lines} damaged lines, {statistics.restarts} restarts, "
        f"{state.unlabelled} without a force"
    )


def _change_text(state: Collection) -> str:
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


def _pace_text(state: Collection) -> str:
    return state.pace.text if state.options.replay is None else ""


def _document(state: Collection, growing: GrowingRecording, frames: int) -> dict[str, Any]:
    csv_path, target = state.options.csv_path, state.options.target
    statistics = state.decoder.statistics
    texts = [_counts_text(state), f"{growing.rows_added} frames added, {frames} in the recording"]
    texts += filter(None, (statistics.wrapped_text, _pace_text(state)))
    if state.status is not None:
        texts.append(status_text(state.status))
    if growing.cut_bytes:
        texts.append(f"an unfinished last line of {growing.cut_bytes} bytes was cut off")
    mechanics = "" if state.travel_mm is None else " --spec SPEC"
    texts.append(f"next: instobj recordings {target}{mechanics}")
    return {
        "command": "collect",
        "frames_added": growing.rows_added,
        "frames": frames,
        "session": growing.session,
        "rate_hz": None if np.isnan(_rate_hz(state)) else round(_rate_hz(state), 3),
        "lost_frames": statistics.lost_frames,
        "damaged_lines": statistics.damaged_lines,
        "restarts": statistics.restarts,
        "frames_without_force": state.unlabelled,
        "board": None if state.status is None else status_row(state.status),
        "texts": texts,
        "files": file_rows([csv_path, target]),
    }
