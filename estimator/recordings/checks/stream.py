"""The checks of `readings` on a stream: chips that stand still, do not answer, or are noisy."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Bool, Float

from estimator.recordings.checks.readings import (
    LEAST_TURNS,
    NO_ANSWER,
    NOISE_FRAMES,
    is_noisy,
    longest_by_chance,
    noise_levels,
)
from estimator.recordings.table import channels_text

_LEAST_STEPS = 6
"""Steps of a channel from which its noise shows."""
_USUAL_RATE = 0.01
"""Share of a new noise level in the usual one: it is the mean of the last hundred frames."""
_LEAST_EQUAL_FRAMES = 20.0
"""Whole frames that repeat on end: a logger faster than its sensors sends fewer."""


@dataclass
class SoundReadings:
    """Judge of which readings of a stream can be believed, from the frames so far.

    A chip that stands still is found with its fourth equal reading (a single channel after some seven),
    and believed again with its next new one. A channel that turns noisy is found within thirteen
    frames. Streams without noise show nothing.
    """

    left_out: Bool[np.ndarray, "face sensor 3"] | None = None
    _last: np.ndarray | None = None
    _step: np.ndarray = field(default_factory=lambda: np.zeros(0))
    _steps: np.ndarray = field(default_factory=lambda: np.zeros(0))
    _turns: np.ndarray = field(default_factory=lambda: np.zeros(0))
    _runs: list[_Runs] = field(default_factory=list)
    _recent: deque[np.ndarray] = field(default_factory=lambda: deque(maxlen=NOISE_FRAMES))
    _usual: np.ndarray = field(default_factory=lambda: np.zeros(0))
    _noisy: np.ndarray = field(default_factory=lambda: np.zeros(0, bool))

    def known(
        self, counts: Float[np.ndarray, "face sensor 3"]
    ) -> Float[np.ndarray, "face sensor 3"]:
        """The next frame, NaN where its readings are none."""
        if self._last is None or self._last.shape != counts.shape:
            self._begin(counts)
            return counts
        repeated = counts == self._last
        live = np.isfinite(counts)
        self._note_noise(counts - self._last)
        self._last = np.where(live, counts, self._last)
        chips, channels, frames = self._runs
        whole = bool(np.all(repeated[live])) and bool(live.any())
        stuck = frames.take(np.array([whole]))[0]
        out = np.zeros(counts.shape, bool)
        if not whole:  # a frame that only repeats tells nothing of single chips
            out |= chips.take(repeated.all(axis=2))[..., None]
            out |= channels.take(repeated)
        else:
            out |= chips.standing[..., None] | channels.standing
        blank = np.any([np.all(counts == value, axis=2) for value in NO_ANSWER], axis=0)
        out |= blank[..., None] | stuck
        self._noisy = self._noisy_channels(counts)
        out |= self._noisy
        out &= live & self._has_noise()
        self.left_out = out
        return np.where(out, np.nan, counts)

    @property
    def text(self) -> str:
        """Names of the channels left out, for people; empty if there are none."""
        if self.left_out is None or self._last is None or not self.left_out.any():
            return ""
        channels = [tuple(index) for index in np.argwhere(self.left_out).tolist()]
        names = channels_text(channels, np.isfinite(self._last))
        why = "noisy" if self._noisy[self.left_out].all() else "standing still or without an answer"
        return f"{names}: {why}, left out"

    def _begin(self, counts: Float[np.ndarray, "face sensor 3"]) -> None:
        self._last, self.left_out = counts, np.zeros(counts.shape, bool)
        self._step, self._steps, self._turns = (np.zeros(counts.shape) for _ in range(3))
        self._usual, self._noisy = np.zeros(counts.shape), np.zeros(counts.shape, bool)
        self._recent.clear()
        self._runs = [
            _Runs(counts.shape[:2]), _Runs(counts.shape), _Runs((1,), _LEAST_EQUAL_FRAMES)
        ]  # fmt: skip

    def _noisy_channels(
        self, counts: Float[np.ndarray, "face sensor 3"]
    ) -> Bool[np.ndarray, "face sensor 3"]:
        """Return which channels the last frames show to be noisy."""
        self._recent.append(counts)
        if len(self._recent) < NOISE_FRAMES:
            return self._noisy
        level = noise_levels(np.stack(self._recent))
        # What is usual follows slowly, so that presses and noise of a while hardly change it.
        begun = self._usual.any()
        self._usual = self._usual + (_USUAL_RATE if begun else 1.0) * (level - self._usual)
        # Half as loud still counts once a channel is known to be noisy.
        return is_noisy(level, self._usual) | self._noisy & is_noisy(2 * level, self._usual)

    def _note_noise(self, step: Float[np.ndarray, "face sensor 3"]) -> None:
        moved = np.nan_to_num(step) != 0
        second = moved & (self._step != 0)
        self._steps += second
        self._turns += second & (step * self._step < 0)
        self._step = np.where(moved, step, self._step)

    def _has_noise(self) -> bool:
        shown = self._steps >= _LEAST_STEPS
        return bool(shown.any()) and bool(
            np.median(self._turns[shown] / self._steps[shown]) >= LEAST_TURNS
        )


class _Runs:
    """Repeats on end of several channels (or chips), and which are too many for chance."""

    def __init__(self, shape: tuple[int, ...], least: float = 0.0) -> None:
        self.standing = np.zeros(shape, bool)
        self._on_end, self._earlier, self._limits = (np.zeros(shape) for _ in range(3))
        self._frames, self._least = 0, least

    def take(self, repeated: np.ndarray) -> np.ndarray:
        """Take the next frame; which of them stand still."""
        self._frames += 1
        # what chance makes shows in runs that ended; of a standstill only its beginning counts
        self._earlier += np.where(repeated, 0, np.minimum(self._on_end, self._limits))
        self._on_end = np.where(repeated, self._on_end + 1, 0)
        share = np.maximum(self._earlier, np.median(self._earlier)) / self._frames
        share = np.maximum(share, 1 / (self._frames * share.size + 1))
        self._limits = np.maximum(longest_by_chance(share, self._frames), self._least)
        self.standing = self._on_end >= self._limits
        return self.standing
