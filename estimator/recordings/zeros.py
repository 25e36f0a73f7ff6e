"""Zeros of recorded presses: levels at rest, and how they drift from one press to the next."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.recordings.checks.faults import known_mean

ZERO_FRAMES = 20
LEAST_ZERO_FRAMES = 5
LONGEST_BRIDGE_S = 120.0
"""Between two zeros, of which the drift is spread evenly over the press between them."""
LARGEST_DRIFT_NOISES = 6.0
"""Of a channel between two zeros: more is a jump, and jumps have a moment that nobody knows."""


@dataclass(frozen=True)
class Zeros:
    """Mean counts at rest of every press (`counts`: press, face, sensor, axis) and the mean time of
    these frames; `before` tells which come from the rest before their press, not after it."""

    counts: Float[np.ndarray, "press 5 sensor 3"]
    time_s: Float[np.ndarray, "press"]
    before: Bool[np.ndarray, "press"]

    def of_frames(self, press: Int[np.ndarray, "frame"]) -> Float[np.ndarray, "frame 5 sensor 3"]:
        """One zero per press."""
        return self.counts[press]

    def bridged(
        self,
        press: Int[np.ndarray, "frame"],
        time_s: Float[np.ndarray, "frame"],
        session: Int[np.ndarray, "frame"],
        noise_counts: Float[np.ndarray, "5 sensor 3"],
    ) -> tuple[Float[np.ndarray, "frame 5 sensor 3"], Float[np.ndarray, "frame 2"]]:
        """Along the line from a press's zero to the next one's, where both were taken before their
        presses of one session, two minutes apart at most and without a jump; else the press's own.
        Also `FrameSet.zero_span_s` of every frame."""
        follows = np.minimum(np.arange(len(self.counts)) + 1, len(self.counts) - 1)
        owner = np.zeros(len(self.counts), int)
        owner[press] = session
        apart_s = self.time_s[follows] - self.time_s
        near = (owner[follows] == owner) & (apart_s > 0) & (apart_s <= LONGEST_BRIDGE_S)
        near &= self.before & self.before[follows]
        drift = self.counts[follows] - self.counts
        steady = np.abs(drift) <= LARGEST_DRIFT_NOISES * noise_counts
        drift = np.where(near[:, None, None, None] & steady, drift, 0.0)
        since_s, apart_s = time_s - self.time_s[press], np.where(near, apart_s, np.inf)[press]
        along = np.clip(since_s / apart_s, 0, 1)[:, None, None, None]
        return self.counts[press] + along * drift[press], np.stack([since_s, apart_s], axis=1)


def rest_levels(
    counts: Float[np.ndarray, "frame 5 sensor 3"],
    time_s: Float[np.ndarray, "frame"],
    press: Int[np.ndarray, "frame"],
    loaded: Bool[np.ndarray, "frame"],
    rest: Bool[np.ndarray, "frame"],
) -> Zeros:
    """Of up to `ZERO_FRAMES` rest frames before each press, or after it where there are too few.

    Raises
    ------
    RecordingError
        Hardly any rest.
    """
    at_rest = np.flatnonzero(rest)
    if len(at_rest) < LEAST_ZERO_FRAMES:
        raise RecordingError(
            f"it holds {len(at_rest)} frames at rest; at least {LEAST_ZERO_FRAMES} are needed to "
            "zero the signals. Record some frames before each press"
        )
    levels, times_s, before = [], [], []
    for number in range(int(press.max()) + 1):
        frames = np.flatnonzero(press == number)
        begin = frames[loaded[frames]][0] if loaded[frames].any() else frames[-1] + 1
        split = int(np.searchsorted(at_rest, begin))
        chosen = at_rest[max(0, split - ZERO_FRAMES) : split]
        before.append(len(chosen) >= LEAST_ZERO_FRAMES)
        if not before[-1]:
            chosen = at_rest[split : split + ZERO_FRAMES]
        if len(chosen) < LEAST_ZERO_FRAMES:
            chosen = at_rest[-ZERO_FRAMES:]
        levels.append(known_mean(counts[chosen]))
        times_s.append(float(time_s[chosen].mean()))
    return Zeros(np.array(levels), np.array(times_s), np.array(before))
