"""The zero of a stream of readings that follows rest, for exported estimators (no torch).

Signals count as still when they scatter over a few frames no more than from one frame to the next
(von Neumann's ratio; it needs no noise level), over 0.6 s at least: in 8 frames at 200 Hz a slow press
hides below the noise. A still level becomes the zero

- at once, when it reads as less than 15 % of the largest force of a press that ended within the last
  5 s: silicone shows hysteresis of up to 10 %, and a new mounting shifts the rest;
- at once, when no press explains it, but the zero read from it is one: then the zero was taken
  while something touched;
- by at most 1 count/s, when it reads as no contact: drift.

A reader that knows what drift looks like also judges all that was followed in the last ten minutes:
where that is a press, and no drift, it grew slowly, and the zero goes back to where it was. Holds of
any force and length are then no rest. The price: a hold that keeps less than 15 % of the force of the
press before it is taken for rest; so is, by readers without that knowledge, a force that grows by less
than about 0.02 N/s. Measured on the public recording of one probe, which begins within a press, with
models of its own training presses: docs/measured/estimators.md.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.recordings.presses import PAUSE_S

ZeroMode = Literal["rest", "first", "none"]
"""Way that readings are zeroed: by following rest, by the first frames, or not at all."""


class StillReading(NamedTuple):
    """Reading of a still change against rest: probability of contact, force (N), and whether contacts
    or rest explain the change; None where the reader cannot say."""

    contact: float
    force_n: float
    explained: bool | None = None


ReadStill = Callable[[Float[np.ndarray, "channel"], int], StillReading]
"""Reads the mean change of n frames."""
ZERO_FRAMES = 8
STILL_RATIO = 1.3
"""Largest ratio of the variance in a window to half the mean squared step from frame to frame."""
RETURN_SHARE = 0.15
"""Share of the largest force of a press up to which it counts as ended."""
SETTLE_S = 5.0
"""Time after a load from which its press is over; drift is followed over so long at most."""
DRIFT_COUNTS_PER_S = 1.0
"""Rate at which the zero follows the readings, at most."""
LEAST_FORCE_N = 0.3
"""Force below which nothing presses."""
PRESS_FORCE_N = 1.0
"""Force of a press that ends, at least: noise of single frames reads as less. Also the force read from
the change turned round, from which the zero itself was taken in a press."""
LEAST_FRAMES = 5
"""Frames of the stretch that is judged, at least."""
REMEMBERED_S = 600.0
"""Time over which drift that was followed is forgotten."""
_FRAME_S = 0.1
"""Between frames without time stamps."""
_WINDOW_S = 0.6
"""Length of the stretch of frames that is judged."""
_JUDGED_EVERY_S = 0.08
"""Time between two judgements."""


def is_still(window: Float[np.ndarray, "frame channel"]) -> bool:
    """Return whether frames scatter about their mean no more than from one to the next."""
    steps = np.diff(window, axis=0)
    noise = np.maximum(np.mean(steps**2, axis=0) / 2, 1 / 12)
    return bool(np.mean(window.var(axis=0, ddof=1) / noise) <= STILL_RATIO)


def level_of(window: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "channel"]:
    """Return the mean without each channel's largest and smallest reading: one may be wrong."""
    if len(window) < LEAST_FRAMES:
        return window.mean(axis=0)
    outer = window.max(axis=0) + window.min(axis=0)
    return (window.sum(axis=0) - outer) / (len(window) - 2)


def is_pause(elapsed_s: float) -> bool:
    """Return whether frames so far apart belong to different stretches; so does time that runs back."""
    return elapsed_s > PAUSE_S or elapsed_s < 0


@dataclass
class RestZero:
    """The zero after each frame of raw counts (channel,), None before the first still frames.

    Attributes
    ----------
    frames : least length of the window that must be still, and that gives the zero; it lasts 0.6 s or more
    read : how the estimator reads a constant change
    read_drift : the same for all that was followed lately, with drift as a disturbance; None where the
        reader does not know drift
    rested_s : when a level was last taken for rest

    Raises
    ------
    InputError
        Fewer than five frames, among which stillness does not show.
    """

    frames: int
    read: ReadStill
    read_drift: ReadStill | None = None
    level: Float[np.ndarray, "channel"] | None = None
    rested_s: float = -math.inf
    window: deque[tuple[float, np.ndarray]] = field(default_factory=deque)
    now_s: float = 0.0
    _judged_s: float = -math.inf
    loaded_s: float = -math.inf
    largest_n: float = 0.0
    _followed: np.ndarray = field(default_factory=lambda: np.zeros(1))

    def __post_init__(self) -> None:
        if self.frames < LEAST_FRAMES:
            raise InputError(
                f"a zero that follows rest needs {LEAST_FRAMES} frames or more; got {self.frames}. "
                "Give more frames (--zero rest:20), or take --zero first"
            )

    def update(self, raw: Float[np.ndarray, "channel"], time_s: float = math.nan) -> None:
        """Take one frame and its time (s), if known."""
        elapsed_s = self.pass_by(raw, time_s)
        since_s = self.now_s - self._judged_s
        if since_s >= _JUDGED_EVERY_S:
            self._judge(elapsed_s if math.isinf(since_s) else since_s)
            self._judged_s = self.now_s

    def pass_by(self, raw: Float[np.ndarray, "channel"], time_s: float = math.nan) -> float:
        """Take a frame into the window alone, for readers that leave frames out; s since the last one."""
        now_s = self.now_s + _FRAME_S if math.isnan(time_s) else time_s
        elapsed_s, self.now_s = now_s - self.now_s, now_s
        if is_pause(elapsed_s):
            self.window.clear()
            self.loaded_s = min(self.loaded_s, now_s)
            self._judged_s = -math.inf
        self.window.append((now_s, raw))
        while len(self.window) > self.frames and self._spans(1):
            self.window.popleft()
        return elapsed_s

    def _spans(self, first: int) -> bool:
        """Return whether the window lasts long enough from that frame on."""
        return self.now_s - self.window[first][0] >= _WINDOW_S

    def _judge(self, elapsed_s: float) -> None:
        if self.level is not None:
            self.note_force(self.read(self.window[-1][1] - self.level, 1).force_n)
        if len(self.window) >= self.frames and self._spans(0):
            window = np.array([raw for _, raw in self.window])
            if is_still(window):
                self.consider(level_of(window), max(0.0, elapsed_s))

    def note_force(self, force_n: float) -> None:
        if self.now_s - self.loaded_s > SETTLE_S:
            self.largest_n = 0.0
        if force_n > max(LEAST_FORCE_N, RETURN_SHARE * self.largest_n):
            self.loaded_s = self.now_s
            self.largest_n = max(self.largest_n, force_n)

    def consider(self, level: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Move the zero to, or towards, a still level that is rest."""
        if self.level is None:
            self._start(level)
            return
        change = level - self.level
        still = self.read(change, len(self.window))
        if not still.explained and self._is_from_press(change, still.force_n):
            self._start(level)
            self.largest_n = 0.0
        elif still.explained is False:
            return  # a magnet near by, or a wrong chip: neither rest nor a press
        elif self.largest_n >= PRESS_FORCE_N and still.force_n <= RETURN_SHARE * self.largest_n:
            # A window that a press begins in reads as less than the press: it is no return.
            if not self.window or self.loaded_s < self.window[0][0]:
                self._start(level)
        elif still.contact < 0.5 or still.force_n < LEAST_FORCE_N:
            self._follow(change, elapsed_s)

    def _is_from_press(self, change: Float[np.ndarray, "channel"], force_n: float) -> bool:
        """Return whether the zero reads as a press, seen from a level of that force."""
        turned = self.read(-change, len(self.window))
        return turned.explained is not False and turned.force_n > max(PRESS_FORCE_N, 2 * force_n)

    def _start(self, level: Float[np.ndarray, "channel"]) -> None:
        """Take a level for the zero, with nothing followed yet."""
        self.level, self._followed, self.rested_s = level, np.zeros(len(level)), self.now_s

    def _follow(self, change: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Go towards a level that is rest; back, where all that was followed lately is a press."""
        assert self.level is not None
        most = DRIFT_COUNTS_PER_S * min(elapsed_s, SETTLE_S)
        step = np.clip(change, -most, most)
        kept = math.exp(-min(elapsed_s, SETTLE_S) / REMEMBERED_S)
        followed = kept * self._followed + step
        if self.read_drift is not None:
            drift = self.read_drift(followed, len(self.window))
            if drift.contact >= 0.5 and drift.force_n >= LEAST_FORCE_N:
                self.level = self.level - self._followed
                self._followed = np.zeros(len(change))
                return
        self.level, self._followed, self.rested_s = self.level + step, followed, self.now_s


@dataclass
class StreamZero:
    """The zero of a stream in any mode: following rest, the mean of the first frames, or none."""

    mode: ZeroMode
    frames: int
    read: ReadStill
    read_drift: ReadStill | None = None
    _rest: RestZero | None = None
    _zeroed_s: float = math.nan
    _now_s: float = math.nan
    _resting: list[np.ndarray] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.mode == "rest":
            self._rest = RestZero(self.frames, self.read, self.read_drift)

    def after(
        self, raw: Float[np.ndarray, "channel"], time_s: float
    ) -> Float[np.ndarray, "channel"] | None:
        """The zero once a frame of raw counts has come; None while there is none."""
        if self.mode == "none":
            return np.zeros(len(raw))
        if self._rest is not None:
            self._rest.update(raw, time_s)
            return self._rest.level
        self._now_s = time_s
        if len(self._resting) < self.frames:
            self._resting.append(raw)
            self._zeroed_s = time_s
            return None
        return level_of(np.array(self._resting))

    @property
    def age_s(self) -> float:
        """Return the time since rest was last seen; 0 without a zero of its own, or without stamps."""
        if self._rest is not None:
            age = self._rest.now_s - self._rest.rested_s
        else:
            age = self._now_s - self._zeroed_s
        return age if math.isfinite(age) else 0.0

    def pass_by(self, raw: Float[np.ndarray, "channel"], time_s: float) -> None:
        """Take a frame that is not read itself; a zero that follows rest sees it."""
        if self._rest is not None:
            self._rest.pass_by(raw, time_s)
