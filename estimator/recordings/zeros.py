"""Zeros of recorded presses: mean levels at rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import RecordingError
from estimator.recordings.checks.faults import known_mean

ZERO_FRAMES = 20
"""Frames at rest whose mean is the zero, at most."""
LEAST_ZERO_FRAMES = 5
"""Frames at rest, at least."""


@dataclass(frozen=True)
class Zeros:
    """Mean counts at rest of every press (`counts`: press, face, sensor, axis); `is_before` says which
    come from the rest before their press, not after it."""

    counts: Float[np.ndarray, "press face sensor 3"]
    is_before: Bool[np.ndarray, "press"]


def rest_levels(
    counts: Float[np.ndarray, "frame face sensor 3"],
    press: Int[np.ndarray, "frame"],
    loaded: Bool[np.ndarray, "frame"],
    rest: Bool[np.ndarray, "frame"],
) -> Zeros:
    """Levels of up to `ZERO_FRAMES` rest frames before each press, or after it where there are too few.

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
    levels, is_before = [], []
    for number in range(int(press.max()) + 1):
        frames = np.flatnonzero(press == number)
        begin = frames[loaded[frames]][0] if loaded[frames].any() else frames[-1] + 1
        split = int(np.searchsorted(at_rest, begin))
        chosen = at_rest[max(0, split - ZERO_FRAMES) : split]
        is_before.append(len(chosen) >= LEAST_ZERO_FRAMES)
        if not is_before[-1]:
            chosen = at_rest[split : split + ZERO_FRAMES]
        if len(chosen) < LEAST_ZERO_FRAMES:
            chosen = at_rest[-ZERO_FRAMES:]
        levels.append(known_mean(counts[chosen]))
    return Zeros(np.array(levels), np.array(is_before))
