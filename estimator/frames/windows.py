"""Frames as an estimator of the whole object takes them: all channels, means of holds, some at random."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from estimator.frames.dataset import FrameSet


def all_counts(frames: FrameSet) -> Float[np.ndarray, "frame channel"]:
    """Channels of all faces side by side, sensor by sensor, axis by axis."""
    return frames.signal_counts.reshape(len(frames), -1)


def window_means(
    frames: FrameSet, window_frames: int
) -> tuple[Float[np.ndarray, "frame channel"], Int[np.ndarray, "frame"]]:
    """Mean of every frame and the ones before it in its press, over the window, and how many there were.

    A channel that misses one of these readings has none.
    """
    counts = all_counts(frames)
    rows = np.arange(len(counts))
    begins = np.concatenate([[True], np.diff(frames.press_id) != 0])
    number = np.minimum(rows - np.maximum.accumulate(rows * begins) + 1, window_frames)

    def mean_over_window(values: np.ndarray) -> np.ndarray:
        summed = np.vstack([np.zeros(values.shape[1]), np.cumsum(values, axis=0)])
        return summed[rows + 1] - summed[rows + 1 - number]

    means = mean_over_window(np.nan_to_num(counts)) / number[:, None]
    return np.where(mean_over_window(np.isnan(counts).astype(float)) > 0, np.nan, means), number


def chosen_rows(frames: FrameSet, most: int, seed: int = 0) -> Int[np.ndarray, "chosen"]:
    """Keep at most `count` valid frames, at random but in order."""
    (valid,) = np.nonzero(frames.valid)
    if len(valid) <= most:
        return valid
    return np.sort(np.random.default_rng(seed).choice(valid, most, replace=False))
