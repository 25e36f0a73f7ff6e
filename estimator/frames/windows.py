"""Frames as an estimator of the whole object takes them: all channels, some at random."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from estimator.frames.dataset import FrameSet


def all_counts(frames: FrameSet) -> Float[np.ndarray, "frame channel"]:
    """Channels of all faces side by side, sensor by sensor, axis by axis."""
    return frames.signal_counts.reshape(len(frames), -1)


def chosen_rows(frames: FrameSet, most: int, seed: int = 0) -> Int[np.ndarray, "chosen"]:
    """Keep at most `count` valid frames, at random but in order."""
    (valid,) = np.nonzero(frames.valid)
    if len(valid) <= most:
        return valid
    return np.sort(np.random.default_rng(seed).choice(valid, most, replace=False))
