"""Watch over a board for the page: last rows, contacts read from them, health; two threads share it."""

from __future__ import annotations

import math
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from estimator.grasps.growing import GrowingGrasps
from estimator.grasps.measures import MeasuredGrasp, conditions_of
from estimator.grasps.track import ContactTrack
from estimator.inversion.condition import Condition
from estimator.recordings.boards.link import counts_of
from estimator.recordings.checks.stream import SoundReadings
from instobj.bench.live.contacts import Found, InvertedContacts, placed_labels
from instobj.bench.live.health import (
    WINDOW,
    channel_health,
    health_limits,
    whole_condition,
)
from instobj.bench.live.protocol import CONTACT_WIDTH, LABEL_WIDTH

_KEPT = 4000
_MOST_BEHIND = 40
"""Rows before the newest that the zero is shown, at most."""
_AT_REST_S = 1.0
_UNSEEN_S = 0.5
"""Between two readings something may have pressed for so long without being seen."""
_SHOWN_GRASPS = 50
"""Last grasps whose answers the page shows."""
_SHOWN_MEASURES = ("peak_n", "grasp_n", "slip_mm")
AGAIN_S = 0.5
"""Pause after a frame that the estimator refused."""


@dataclass(frozen=True)
class Row:
    """One frame: its number, when it arrived, the board's time, raw counts and change, and which readings
    are not believed."""

    number: int
    arrived_s: float
    time_s: float
    raw: Float[np.ndarray, "channel"]
    change: Float[np.ndarray, "channel"]
    left_out: Bool[np.ndarray, "face sensor 3"]


@dataclass(frozen=True)
class Reading:
    """Last contacts of the estimator, and when the row that it read had arrived (0: in none)."""

    read: Found
    arrived_s: float


NOTHING = Reading(Found(np.zeros((0, CONTACT_WIDTH)), True), 0.0)


@dataclass
class Watch:
    """Rows come in by `take_row`, `read_next` reads contacts from them, viewers ask for what is new.

    Attributes
    ----------
    zero_frames : frames of which the zero is the mean; 0 takes counts for changes
    news : state of recording and line, for the page
    on_reading : called by the reading thread once it has seen new rows
    """

    spec: ObjectSpec
    estimator: InvertedContacts | None
    zero_frames: int
    reading: Reading = NOTHING
    labels: Float[np.ndarray, "label 10"] = field(
        default_factory=lambda: np.zeros((0, LABEL_WIDTH))
    )
    news: dict[str, Any] = field(default_factory=dict)
    on_reading: Callable[[], None] = lambda: None
    ended: bool = False
    _trouble: str = ""
    _read_frames: int = 0

    def __post_init__(self) -> None:
        self.names = channel_names(self.spec)
        self.live: Bool[np.ndarray, "channel"] = np.zeros(len(self.names), bool)
        self._limits = health_limits(self.spec)
        self._rows: deque[Row] = deque(maxlen=_KEPT)
        self._fresh = threading.Condition()
        self._channels: tuple[str, ...] = ()
        self._places = np.zeros(0, int)
        self._next, self._read_to = 0, 0
        self._rezero_asked = False
        self._sound = SoundReadings()
        presses = None if self.estimator is None else self.estimator.presses
        self._conditions = conditions_of(self.spec, presses)
        self._growing = GrowingGrasps(self._conditions)
        self._grasps: deque[dict[str, Any]] = deque(maxlen=_SHOWN_GRASPS)
        self._start_zero()

    def take_header(self, channels: Sequence[str]) -> None:
        """Learn which channels the counts of the rows that follow belong to."""
        self._channels = tuple(channels)
        index = {name: place for place, name in enumerate(self.names)}
        self._places = np.array([index[name] for name in self._channels])
        self.live[self._places] = True

    def take_row(self, arrived_s: float, time_s: float, counts: Sequence[float]) -> None:
        """Add a frame: when it arrived (s since 1970), the board's time (s), and its counts."""
        raw = np.full(len(self.names), np.nan)
        raw[self._places] = counts
        if self._zero is None:
            self._gather_zero(raw)
        change = raw * np.nan if self._zero is None else raw - self._zero
        read_counts = counts_of(self._channels, tuple(raw[self._places].tolist()))
        left_out = np.isnan(self._sound.known(read_counts)) & ~np.isnan(read_counts)
        with self._fresh:
            self._rows.append(Row(self._next, arrived_s, time_s, raw, change, left_out))
            self._next += 1
            self._fresh.notify()

    def take_labels(self, labels: list[list[float]]) -> None:
        """Place the labels of load cells: face, x and y (mm), and force (N) of each tip."""
        self.labels = placed_labels(self.spec, labels)

    def stop_reading(self, why: str) -> None:
        """Read no more contacts, and say why."""
        self.estimator, self._trouble, self.reading = None, why, NOTHING

    def end(self) -> None:
        """Let the thread that reads contacts end."""
        self.ended = True

    def rezero(self) -> None:
        """Take the zero again from the frames that follow, of channels and estimator alike."""
        self._start_zero()
        self._rezero_asked = True

    def read_next(self) -> None:
        """Wait for rows and read contacts in the newest."""
        with self._fresh:
            self._fresh.wait_for(lambda: self._next > self._read_to, timeout=0.2)
            waiting = list(islice(reversed(self._rows), min(self._next - self._read_to, _KEPT)))
            self._read_to = self._next
        if self.estimator is not None and waiting:
            self._read_rows(self.estimator, waiting)
        if waiting:
            self.on_reading()

    def rows_after(self, number: int, most: int) -> tuple[list[Row], int]:
        """Rows from that number on, `most` at most, and how many more there had been."""
        with self._fresh:
            wanted = self._next - number
            rows = list(islice(reversed(self._rows), min(wanted, most)))
        return rows[::-1], max(0, wanted - len(rows))

    def state(self) -> dict[str, Any]:
        """Health, zero, and the last news of the reader."""
        with self._fresh:
            rows = list(islice(reversed(self._rows), WINDOW))[::-1]
        raw = np.stack([row.raw for row in rows]) if rows else np.zeros((0, len(self.names)))
        drift = self._resting_drift(rows)
        health = channel_health(raw, self.live, drift, self._limits) if rows else []
        condition = whole_condition(self.reading.read.condition, health, self.names[: len(health)])
        return self.news | {
            "health": health,
            "condition": str(condition),
            "zeroed": self._zero is not None,
            "explained": self.reading.read.explained,
            "trouble": self._trouble or self._doubts(condition),
            "read": self._read_frames,
            "grasps": list(self._grasps),
            "now_s": time.time(),
        }

    def _doubts(self, condition: Condition) -> str:
        """Return what is to be done, and which channels and chips are not believed, for people; empty if
        nothing is."""
        chip = self.reading.read.chip_out
        lies = f"{chip}: its readings fit no contact, left out" if chip else ""
        # a channel's state stands in the table of channels
        asks = "" if condition.name == "fine" else str(condition)
        return "; ".join(filter(None, (asks, self._sound.text, lies)))

    def _start_zero(self) -> None:
        self._gathered: list[np.ndarray] = []
        self._first_rest: np.ndarray | None = None
        self._drift, self._pressed_s = np.full(len(self.names), np.nan), math.inf
        self._zero = None if self.zero_frames else np.zeros(len(self.names))

    def _gather_zero(self, raw: Float[np.ndarray, "channel"]) -> None:
        self._gathered.append(raw)
        if len(self._gathered) >= self.zero_frames:
            gathered = np.stack(self._gathered)
            has_reading = np.isfinite(gathered)
            total = np.where(has_reading, gathered, 0.0).sum(axis=0)
            self._zero = np.where(
                has_reading.any(axis=0), total / np.maximum(has_reading.sum(axis=0), 1), np.nan
            )

    def _read_rows(self, estimator: InvertedContacts, waiting: list[Row]) -> None:
        """Rows that nothing was read from yet, newest first."""
        if self._rezero_asked:
            self._rezero_asked = False
            estimator.rezero()
            self._growing.forget()
        newest, *older = waiting
        for row in reversed(older[:_MOST_BEHIND]):
            with suppress(InputError):  # told once it is read
                estimator.pass_by(self._counts(row), row.time_s, row.left_out)
        self._read(estimator, newest)

    def _counts(self, row: Row) -> Float[np.ndarray, "face sensor 3"]:
        return counts_of(self._channels, tuple(row.raw[self._places].tolist()))

    def _read(self, estimator: InvertedContacts, row: Row) -> None:
        try:
            contacts = estimator.feed(self._counts(row), row.time_s, row.left_out)
        except InputError as error:
            self._trouble, self.reading = str(error), NOTHING
            time.sleep(AGAIN_S)
            return
        self._trouble = ""
        if contacts is not None:
            self._read_frames += 1
            unseen_s = row.arrived_s - self.reading.arrived_s
            if len(contacts.contacts) or unseen_s > _UNSEEN_S or math.isinf(self._pressed_s):
                self._pressed_s = row.arrived_s
            self.reading = Reading(contacts, row.arrived_s)
            if contacts.track is not None:
                self._take_grasps(contacts.track)

    def _take_grasps(self, track: ContactTrack) -> None:
        """Judge the grasps that end with a frame; one that cannot be measured must not end the reading."""
        try:
            for grasp in self._growing.feed(track):
                self._grasps.append(self._judged(grasp))
        except (ValueError, ArithmeticError) as error:  # also numpy's LinAlgError
            number = self._growing.count
            text = f"grasp {number}: cannot be measured: {error}"
            self._grasps.append({"grasp": number, "text": text})

    def _judged(self, grasp: MeasuredGrasp) -> dict[str, Any]:
        """Return what the page says of a grasp that has ended: the answer of `instobj assess`, and forces and
        slip where the estimator explains most of it."""
        from instobj.commands.assess.groups import with_ends
        from instobj.commands.assess.sentences import answer_text
        from instobj.commands.assess.tracks import MOST_UNEXPLAINED

        unexplained, number = grasp.readings["unexplained"].value, grasp.grasp.number
        name = f"grasp {number}"
        text = answer_text(name, [grasp], unexplained, "inversion", self._conditions)
        row = {"grasp": number, "text": text}
        if unexplained <= MOST_UNEXPLAINED:
            row |= {name: with_ends(grasp.readings[name]) for name in _SHOWN_MEASURES}
        return row

    def _resting_drift(self, rows: list[Row]) -> Float[np.ndarray, "channel"] | None:
        """Change of the resting level since the first rest after the zero was asked for.

        Rest is a second without contacts; its level becomes the zero of the strips.
        """
        if self.estimator is None or not self.zero_frames:
            return None
        read_s = self.reading.arrived_s
        still = [row.raw for row in rows if -_AT_REST_S / 2 <= row.arrived_s - read_s <= 0]
        if still and read_s - self._pressed_s > _AT_REST_S:
            level = np.mean(still, axis=0)
            self._first_rest = level if self._first_rest is None else self._first_rest
            self._drift, self._zero = level - self._first_rest, level
        return self._drift
