"""The zero of a stream of readings that follows rest, for exported estimators (no torch).

Signals count as still when they scatter over a few frames no more than from one frame to the next
(von Neumann's ratio; it needs no noise level), over 0.6 s at least: in 8 frames at 200 Hz a slow press
hides below the noise. A still level becomes the zero

- at once, when it reads as less than 15 % of the largest force of a press that ended within the last
  5 s: silicone shows hysteresis of up to 10 %, and a new mounting shifts the rest;
- at once, when it does not read as a press, but the zero read from it does: then the zero was taken
  while something touched;
- by at most 1 count/s, when it reads as no contact: drift.

The price: a hold that keeps less than 15 % of the force of the press before it, and a force that
grows by less than about 0.02 N/s, are taken for rest. Measured on the public recording of one probe,
which begins within a press, with models of its own training presses: docs/measured/estimators.md.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.recordings.presses import PAUSE_S

ZeroMode = Literal["rest", "first", "none"]
"""Way that readings are zeroed: by following rest, by the first frames, or not at all."""
ReadStill = Callable[[Float[np.ndarray, "channel"]], tuple[float, float]]
"""Probability of contact and force (N) that a change against rest is read as."""
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
"""Force read from the change turned round, from which the zero itself was taken in a press."""
LEAST_FRAMES = 5
"""Frames of the stretch that is judged, at least."""
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

    Raises
    ------
    InputError
        Fewer than five frames, among which stillness does not show.
    """

    frames: int
    read: ReadStill
    level: Float[np.ndarray, "channel"] | None = None
    window: deque[tuple[float, np.ndarray]] = field(default_factory=deque)
    now_s: float = 0.0
    _judged_s: float = -math.inf
    loaded_s: float = -math.inf
    largest_n: float = 0.0

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
            self.note_force(self.read(self.window[-1][1] - self.level)[1])
        if len(self.window) >= self.frames and self._spans(0):
            window = np.array([raw for _, raw in self.window])
            if is_still(window):
                self.consider(window.mean(axis=0), max(0.0, elapsed_s))

    def note_force(self, force_n: float) -> None:
        if self.now_s - self.loaded_s > SETTLE_S:
            self.largest_n = 0.0
        if force_n > max(LEAST_FORCE_N, RETURN_SHARE * self.largest_n):
            self.loaded_s = self.now_s
            self.largest_n = max(self.largest_n, force_n)

    def consider(self, level: Float[np.ndarray, "channel"], elapsed_s: float) -> None:
        """Move the zero to, or towards, a still level that is rest."""
        if self.level is None:
            self.level = level
            return
        change = level - self.level
        contact, force_n = self.read(change)
        if self.read(-change)[1] > max(PRESS_FORCE_N, 2 * force_n):
            self.level, self.largest_n = level, 0.0
        elif force_n <= RETURN_SHARE * self.largest_n:
            self.level = level
        elif contact < 0.5 or force_n < LEAST_FORCE_N:
            step = DRIFT_COUNTS_PER_S * min(elapsed_s, SETTLE_S)
            self.level = self.level + np.clip(change, -step, step)


@dataclass
class StreamZero:
    """The zero of a stream in any mode: following rest, the mean of the first frames, or none."""

    mode: ZeroMode
    frames: int
    read: ReadStill
    _rest: RestZero | None = None
    _resting: list[np.ndarray] = field(default_factory=list)

    def __post_init__(self) -> None:
        if self.mode == "rest":
            self._rest = RestZero(self.frames, self.read)

    def after(
        self, raw: Float[np.ndarray, "channel"], time_s: float
    ) -> Float[np.ndarray, "channel"] | None:
        """The zero once a frame of raw counts has come; None while there is none."""
        if self.mode == "none":
            return np.zeros(len(raw))
        if self._rest is not None:
            self._rest.update(raw, time_s)
            return self._rest.level
        if len(self._resting) < self.frames:
            self._resting.append(raw)
            return None
        return np.mean(self._resting, axis=0)

    def pass_by(self, raw: Float[np.ndarray, "channel"], time_s: float) -> None:
        """Take a frame that is not read itself; a zero that follows rest sees it."""
        if self._rest is not None:
            self._rest.pass_by(raw, time_s)
