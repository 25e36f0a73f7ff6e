"""Recordings of jaws that take an object, hold it and let go, by the object of analytic presses."""

from dataclasses import replace

import numpy as np

from tests.support.mechanics.inverted import inverted, labelled_frames, noisy_counts

_JAWS = (2, 4)
"""Rows of faces 3 and 5."""
FORCE = np.concatenate([np.zeros(4), np.linspace(0.2, 1, 5), np.ones(8), [0.6, 0.2], np.zeros(3)])
"""Of one grasp over its peak: rest, closing, hold, release, rest."""


def handled(peaks_n, seed, spread_mm=6.0):
    """Data set of grasps between faces 3 and 5, one tip each at opposite places, with the peaks of each
    jaw; raw counts (frame, channel) of the same beside it."""
    rng, estimator = np.random.default_rng(seed), inverted()
    frames = len(FORCE) * len(peaks_n)
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    for number, peak in enumerate(peaks_n):
        rows = slice(number * len(FORCE), (number + 1) * len(FORCE))
        x, y = rng.uniform(-spread_mm, spread_mm, 2)
        for slot, (row, place) in enumerate(zip(_JAWS, ((x, y), (x, -y)), strict=True)):
            face[rows, slot] = np.where(FORCE > 0, row, -1)
            contact[rows, slot, :2] = place
            contact[rows, slot, 2] = peak * FORCE
    counts = noisy_counts(estimator, face, contact, rng, turned=False)
    there = (face >= 0)[..., None]
    number = np.where(face >= 0, estimator.model.signals.faces[face], 0)
    placed = np.where(there, contact, np.nan)
    labels = labelled_frames(number, placed[..., :2], placed[..., 2])
    return replace(labels, signal_counts=counts.reshape(frames, 5, 3, 3)), counts
