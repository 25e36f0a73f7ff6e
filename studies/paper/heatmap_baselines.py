"""Heatmaps that any estimator must beat: ridge regression, and always the mean of the training."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from estimator.frames.dataset import FrameSet
from estimator.frames.face_data import FaceData, channel_counts, face_data, live_channels
from estimator.frames.splits import Split
from estimator.metrics.heatmaps import FaceMetrics, face_metrics, force_reference
from estimator.networks.training.data import thinned, with_contacts

RIDGE = 1e-3
"""Penalty of ridge regression, a share of the mean square of its inputs."""


def linear_baseline(frames: FrameSet, face: int, split: Split) -> FaceMetrics:
    """Linear (ridge) regression from signals in units of σ to the heatmap."""
    learned, held_out = (
        thinned(with_contacts(face_data(frames.select(part), face), name), 1)
        for part, name in ((split.train, "training"), (split.validation, "validation"))
    )
    alive = live_channels(held_out)
    channels = tuple(channel for channel in live_channels(learned) if channel in alive)
    tested = face_data(frames.select(split.test), face)
    sigma = frames.noise_counts[[axis for *_, axis in channels]]
    given, tested_rows = (
        np.column_stack([channel_counts(data.frames, channels) / sigma, np.ones(len(data))])
        for data in (learned, tested)
    )
    weights = ridge_weights(given, learned.heatmap_n.reshape(len(learned), -1))
    return _metrics(tested, (tested_rows @ weights).reshape(tested.heatmap_n.shape), frames)


def ridge_weights(
    given: Float[np.ndarray, "frame input"], wanted: Float[np.ndarray, "frame output"]
) -> Float[np.ndarray, "input output"]:
    """Weights of ridge regression in closed form."""
    # (XᵀX + λ I) W = XᵀY; λ is a thousandth of the mean of XᵀX's diagonal, whatever the inputs' units.
    normal = given.T @ given
    penalty = RIDGE * np.trace(normal) / len(normal) * np.eye(len(normal))
    return np.linalg.solve(normal + penalty, given.T @ wanted)


def mean_map_baseline(frames: FrameSet, face: int, split: Split) -> FaceMetrics:
    """Chance: always the mean training heatmap of contact frames, whatever the signals say."""
    train, test = (face_data(frames.select(part), face) for part in (split.train, split.test))
    mean = train.heatmap_n[train.contact].mean(axis=0)
    return _metrics(test, np.broadcast_to(mean, test.heatmap_n.shape).copy(), frames)


def _metrics(
    data: FaceData, predicted_n: Float[np.ndarray, "frame nx ny"], dataset: FrameSet
) -> FaceMetrics:
    reference = force_reference(face_data(dataset, data.face).heatmap_n)
    return face_metrics(data.face, predicted_n, data.heatmap_n, reference, data.rest)
