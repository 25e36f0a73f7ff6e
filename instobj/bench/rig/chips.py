"""Counts of the chips as the second witness of contact, or as the only one without a load cell."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.recordings.formats.generic import CHANNEL

FRAMES, MOST_FRAMES = 3, 10
"""Whose mean is compared with the level at rest: their noise is 0.58 of one frame's."""
_SEEN, _UNSEEN = 6.0, 4.0
"""Times the noise of that mean. Of 45 channels one passes 6 by chance once in 10⁷ frames; the largest of 45
stays below 4 in 997 frames of 1 000."""
_LEAST_NOISE = 1e-9
_DRIFT_S = 900.0
"""`sensors.drift_counts` is what a level drifts within 15 minutes, as a random walk."""
_LONGEST_RUN = 5
"""Equal frames in a row: boards may send a reading twice or three times, noise never so often."""


class NoWitness(InputError):
    """The chips' counts are none."""


@dataclass
class Chips:
    """Level of every channel at rest, and how far the counts are from it.

    `noise_counts` (X, Y, Z) and `drift_counts` are the specification's.
    """

    noise_counts: tuple[float, float, float]
    drift_counts: float
    _last: deque[np.ndarray] = field(default_factory=lambda: deque(maxlen=MOST_FRAMES))
    _rest: list[np.ndarray] = field(default_factory=list)
    _noise: np.ndarray = field(default_factory=lambda: np.zeros(0))
    _resting: bool = False
    _run: int = 1
    _stamp_run: int = 1
    _stamp_ms: int = -1
    _since_s: float = 0.0

    def take(self, counts: tuple[float, ...], board_ms: int) -> None:
        """Take one frame.

        Raises
        ------
        NoWitness
            No channel speaks, or frames or their clock stand still.
        """
        now = np.array(counts)
        if not np.isfinite(now).any():
            raise NoWitness("no chip of the board says anything. Check the sensors' cable")
        same = bool(self._last) and np.array_equal(now, self._last[-1], equal_nan=True)
        self._run = self._run + 1 if same else 1
        self._stamp_run = self._stamp_run + 1 if board_ms == self._stamp_ms else 1
        self._stamp_ms = board_ms
        if max(self._run, self._stamp_run) > _LONGEST_RUN:
            what = "frames" if self._run > _LONGEST_RUN else "times of frames"
            raise NoWitness(
                f"{_LONGEST_RUN + 1} {what} of the board in a row are the same: it stands still. "
                "Restart it"
            )
        self._last.append(now)
        if self._resting:
            self._rest.append(now)

    def forget(self) -> None:
        """Frames before now are of another moment than later ones."""
        self._last.clear()
        self._run = self._stamp_run = 1

    def rest(self) -> None:
        """The frames that follow are at rest, until `rested`."""
        self._rest, self._resting = [], True

    def rested(self, channels: tuple[str, ...], now_s: float) -> None:
        """Take the frames since `rest` for the level at rest."""
        self._resting, self._since_s = False, now_s
        axes = [match[2] for name in channels if (match := CHANNEL.fullmatch(name))]
        stated = np.array([self.noise_counts["XYZ".index(axis)] for axis in axes])
        if len(self._rest) >= 2 * FRAMES:
            # Pooled over channels: the noise of a single one from few frames is uncertain itself.
            spread = np.nanstd(np.stack(self._rest), axis=0, ddof=1) / stated
            stated = stated * max(1.0, float(np.sqrt(np.nanmean(np.square(spread)))))
        self._noise = stated

    def see(self, now_s: float, frames: int = FRAMES) -> bool:
        """Return whether some chip certainly sees a contact in the mean of the last frames."""
        return bool(np.any(np.abs(self.change(now_s, frames)) > _SEEN))

    def see_nothing(self, now_s: float) -> bool:
        """Return whether no chip sees a contact."""
        change = self.change(now_s)
        return change.size > 0 and not np.any(np.abs(change) > _UNSEEN)

    def change(self, now_s: float, frames: int = FRAMES) -> Float[np.ndarray, "channel"]:
        """Return the change of the last frames' mean from the level at rest, in units of its noise.

        Of `MOST_FRAMES` at most. NaN where a channel does not speak; without channels while the level is not
        known.
        """
        if not self._rest or self._resting or len(self._last) < frames:
            return np.zeros(0)
        last = list(self._last)[-frames:]
        level, now = (_means(np.stack(part)) for part in (self._rest, last))
        drift = self.drift_counts**2 * max(now_s - self._since_s, 0.0) / _DRIFT_S
        noise = np.sqrt(self._noise**2 * (1 / frames + 1 / len(self._rest)) + drift)
        # A channel whose stated noise is 0 counts as one that changes by any count.
        return (now - level) / np.maximum(noise, _LEAST_NOISE)


def _means(frames: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "channel"]:
    """Over the frames in which a channel speaks, NaN where it never does."""
    has_reading = np.isfinite(frames)
    count = has_reading.sum(axis=0)
    total = np.where(has_reading, frames, 0.0).sum(axis=0)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)
