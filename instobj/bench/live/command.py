"""`instobj bench live`: a board, a recording or a simulated object on a page, recorded as `collect` does."""

from __future__ import annotations

import time
from collections import deque
from contextlib import closing
from dataclasses import dataclass, field
from typing import Any

import aiohttp  # noqa: F401  its absence is said before a demo is computed
import numpy as np

from design.catalogue.bus_parts import MOTION
from design.errors import InputError, InstobjError
from estimator.calibration.resting import channel_names
from estimator.recordings.attitude import Attitude
from estimator.recordings.boards.growing import finish_recording
from estimator.recordings.boards.lines import Frame, Header, Load, Message, Status
from estimator.recordings.boards.link import board_messages
from instobj.bench.collect.board_state import status_text, supply_text
from instobj.bench.collect.labelled_frames import STALE_S, Collection, load_lines, take_load
from instobj.bench.collect.options import stop_on_signals
from instobj.bench.live.contacts import open_estimator
from instobj.bench.live.page import PageSettings, ServedPage, serve_page
from instobj.bench.live.recorder import Recorder
from instobj.bench.live.source import LiveOptions, LiveSource, live_source
from instobj.bench.live.watch import Watch
from instobj.store.progress import NEWS_EVERY_S, ProgressLine
from instobj.store.publish import file_rows

_NEWS_S = 0.25
"""Time between two messages of news, about."""
_TICK_S = 0.2
"""Pause between two looks at the session."""
_LAST_WORD_S = 0.5
"""Time that the page stays after a failure, to show it."""


@dataclass
class _Session:
    """State of the reader between two chunks."""

    source: LiveSource
    state: Collection
    recorder: Recorder
    page: ServedPage
    watch: Watch
    arrivals_s: deque[float] = field(default_factory=lambda: deque(maxlen=400))
    labels: list[list[float]] = field(default_factory=list)
    attitude: Attitude | None = None
    message: str = ""
    news_at_s: float = 0.0


def live(options: LiveOptions) -> dict[str, Any]:
    """Serve the page until stopped; the document says what came, was lost and was written.

    Raises
    ------
    InputError
        Bad options, model or source, an address that cannot be served, or a line that broke off;
        what was recorded is kept and finished.
    """
    token, progress = options.token, ProgressLine()
    return run_live(live_source(options, progress), options, token, progress)


def run_live(
    source: LiveSource, options: LiveOptions, token: str, progress: ProgressLine
) -> dict[str, Any]:
    """Serve and record a source; as `live`."""
    mode, zero_frames = source.zeroing.raw_settings
    estimator = open_estimator(source.spec, source.model, mode, zero_frames)
    watch = Watch(source.spec, estimator, 0 if mode == "none" else zero_frames)
    settings = PageSettings(source.scene, options.address, options.page_port, token)
    state = Collection(source.readings, source.readings.first_places)
    with (
        closing(source.chunks),
        serve_page(watch, settings) as page,
        stop_on_signals(state.stop),
        progress.stage(f"live, {source.name}"),
    ):
        session = _Session(source, state, Recorder(state), page, watch)
        progress.say(f"open {page.url} in a browser; Ctrl-C ends")
        failure = _follow(session, options, progress)
    return _ended(session, failure)


def _follow(session: _Session, options: LiveOptions, progress: ProgressLine) -> InstobjError | None:
    """Read until the end, then keep the page until it is stopped; the error that ended the line."""
    until_s = time.monotonic() + (options.seconds if options.seconds is not None else float("inf"))
    failure = None
    try:
        _read(session, options, until_s, progress)
        session.message = "the readings have ended" if not session.state.stopped else ""
    except InstobjError as error:
        failure, session.message = error, str(error)
    session.recorder.switch(False)
    _tell(session)
    while failure is None and not session.state.stopped and time.monotonic() < until_s:
        time.sleep(_TICK_S)
    time.sleep(_LAST_WORD_S if failure else 0.0)
    return failure


def _read(session: _Session, options: LiveOptions, until_s: float, progress: ProgressLine) -> None:
    stream = board_messages(session.source.chunks, session.state.decoder, session.source.name)
    loads, alive, told_at_s = load_lines(session.state.options), True, time.monotonic()
    with closing(loads), session.recorder.open:
        for messages in stream:
            for load in next(loads):
                take_load(load, session.state, session.state.load_clock)
            _take(session, messages, options)
            _obey(session)
            if time.monotonic() >= session.news_at_s:
                _tell(session)
            if time.monotonic() - told_at_s > NEWS_EVERY_S:
                told_at_s = time.monotonic()
                progress.step(_counts_text(session, time.time()))
            if alive and not session.page.alive:
                alive = False
                progress.say("the page's server ended; reading and recording go on until Ctrl-C")
            if session.state.stopped or time.monotonic() >= until_s:
                return


def _take(session: _Session, messages: list[Message], options: LiveOptions) -> None:
    state = session.state
    for message in messages:
        if isinstance(message, Header):
            _take_header(session, message, options)
        elif isinstance(message, Load):
            take_load(message, state, state.clock)
        elif isinstance(message, Status):
            state.status = message
        elif isinstance(message, Frame):
            now_s = time.time()
            time_s = state.clock.time_s(message.board_ms, now_s)
            session.recorder.take(message, time_s)
            halls = len(message.counts)
            if session.attitude is not None:
                halls -= len(MOTION)
                session.attitude.update(time_s, np.array(message.counts[halls:]))
            session.watch.take_row(now_s, time_s, message.counts[:halls])
            session.arrivals_s.append(now_s)
            _tell_labels(session, time_s)


def _take_header(session: _Session, header: Header, options: LiveOptions) -> None:
    state, known_names = session.state, channel_names(session.source.spec)
    if state.channels and header.channels != state.channels:
        raise InputError("the board names other channels than before. Was it exchanged?")
    halls = [name for name in header.channels if name not in MOTION]
    foreign = [name for name in halls if name not in known_names]
    if foreign:
        raise InputError(
            f"{session.source.name} names channels that {session.source.spec.name} has not: "
            f"{', '.join(foreign[:5])}. Give the specification of the object that is read"
        )
    first = not state.channels
    state.channels = header.channels
    session.watch.take_header(halls)
    if first and len(halls) < len(header.channels):
        session.attitude = Attitude()
    if first and options.record:
        session.recorder.switch(True)


def _tell_labels(session: _Session, now_s: float) -> None:
    """The load cells' places and forces, where they have changed."""
    labels = [
        [float(load.face), x, y, load.force_n / len(load.tips_mm)]
        for heard_s, load in session.state.loads.values()
        if load.face and now_s - heard_s <= STALE_S
        for x, y in load.tips_mm
    ]
    if labels != session.labels:
        session.labels = labels
        session.watch.take_labels(labels)


def _obey(session: _Session) -> None:
    for command in session.page.commands():
        if command == "zero":
            session.state.zero_left = max(1, session.state.options.zero_frames)
        else:
            session.recorder.switch(command == "record on")


def _tell(session: _Session) -> None:
    session.news_at_s = time.monotonic() + _NEWS_S
    statistics = session.state.decoder.statistics
    session.watch.news = {
        "source": " · ".join(
            filter(None, (session.source.name, _battery_text(session), _attitude_text(session)))
        ),
        "rate_hz": round(_rate_hz(session.arrivals_s, time.time()), 2),
        "counted": {
            "frames": statistics.frames,
            "lost": statistics.lost_frames,
            "damaged": statistics.damaged_lines,
            "restarts": statistics.restarts,
        },
        "recording": session.recorder.news(),
        "told": "; ".join(filter(None, (session.message, session.recorder.message))),
    }


def _battery_text(session: _Session) -> str:
    return "" if session.state.status is None else supply_text(session.state.status)


def _attitude_text(session: _Session) -> str:
    return "" if session.attitude is None else session.attitude.text


def _rate_hz(arrivals_s: deque[float], now_s: float) -> float:
    """Frames per second over two seconds until then; 0 once none comes."""
    recent = sum(now_s - arrived_s <= 2.0 for arrived_s in arrivals_s)
    lasted_s = min(2.0, now_s - arrivals_s[0]) if arrivals_s else 0.0
    return recent / lasted_s if lasted_s > 0 else 0.0


def _counts_text(session: _Session, until_s: float) -> str:
    statistics, recording = session.state.decoder.statistics, session.recorder.news()
    return (
        f"{statistics.frames} frames at {_rate_hz(session.arrivals_s, until_s):.0f}/s, "
        f"{statistics.lost_frames} lost, {statistics.damaged_lines} damaged lines, "
        f"{recording['rows']} rows recorded"
    )


def _ended(session: _Session, failure: InstobjError | None) -> dict[str, Any]:
    options, rows = session.state.options, session.recorder.rows
    files = []
    if rows:
        finish_recording(options.csv_path, options.target)
        files = [options.csv_path, options.target]
    if failure is not None:
        raise InputError(f"{failure} ({rows} rows kept in {options.csv_path})") from None
    statistics = session.state.decoder.statistics
    return {
        "command": "live",
        "frames": statistics.frames,
        "lost_frames": statistics.lost_frames,
        "damaged_lines": statistics.damaged_lines,
        "frames_added": rows,
        "frames_without_force": session.state.unlabelled,
        # As long as frames came: the page stays for a while after the last one.
        "texts": [
            _counts_text(session, max(session.arrivals_s, default=0.0)),
            *filter(None, [statistics.wrapped_text]),
            *([] if session.state.status is None else [status_text(session.state.status)]),
        ],
        "files": file_rows(files),
    }
