"""Zero of a press from the rests before and after it: a recording holds both."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from jaxtyping import Bool, Float

from estimator.inversion.inversion import Inversion
from estimator.inversion.model.noise import Disturbances
from estimator.inversion.readings import ContactSets
from estimator.inversion.tracking import Tracker

_FRAMES = 20
"""Frames of a rest next to a press, at most, that its zero is taken from: older ones have drifted."""
_LEAST_FRAMES = 10
"""Frames of a rest below which nothing is taken from it: their noise is as large as the error, and a faint
touch that was not read weighs more."""
_EDGE = 2
"""Frames next to a press that are left out of a rest: a touch begins before it is read."""


def contacts_between_rests(
    inversion: Inversion,
    counts: Float[np.ndarray, "frame channel"],
    frame_read: Callable[[int], None] = lambda number: None,
) -> tuple[ContactSets, Tracker]:
    """Read the contacts of every frame of one zero, in order; return the tracker for the object's condition.

    Frames are read twice: first to see which are rests, then with the zero that these show. `frame_read`
    takes the number of each frame once it is read.
    """
    sets, tracker = _read(inversion, counts, frame_read)
    resting = (sets.number == 0) & sets.explained
    level, remaining = zero_by_rests(counts, resting, inversion.disturbances)
    # a core that slipped moves the rests as well, and the tracker knows by how much
    if tracker.slip is not None or not level.any():
        return sets, tracker
    disturbances = replace(inversion.disturbances, offset_counts=remaining)
    return _read(replace(inversion, disturbances=disturbances), counts - level, frame_read)


def _read(
    inversion: Inversion,
    counts: Float[np.ndarray, "frame channel"],
    frame_read: Callable[[int], None],
) -> tuple[ContactSets, Tracker]:
    tracker, sets = Tracker(inversion), []
    for number, change in enumerate(counts):
        sets.append(tracker.feed(change))
        frame_read(number)
    return ContactSets.joined(sets), tracker


def zero_by_rests(
    counts: Float[np.ndarray, "frame channel"],
    resting: Bool[np.ndarray, "frame"],
    disturbances: Disturbances,
) -> tuple[Float[np.ndarray, "frame channel"], Float[np.ndarray, "channel"]]:
    """Return the error of the zero in every frame (counts, to be taken off), and its standard deviation that
    is left in pressed ones.

    It goes straight from the mean of a rest to that of the next, each shrunk by its noise to what an error of
    the size of `offset_counts` leaves probable. Without rests nothing is known.
    """
    rests, frames = _rests(resting), np.arange(len(counts))
    if not rests or resting.all():
        return np.zeros_like(counts), disturbances.offset_counts
    lengths = np.array([len(rest) for rest in rests])[:, None]
    noise = (disturbances.noise_counts**2 + 1 / 12) / lengths
    wrong = disturbances.offset_counts**2
    kept = wrong / (wrong + noise)
    levels = kept * np.array([_mean(counts[rest]) for rest in rests])
    middles = [rest.mean() for rest in rests]
    level = np.stack([np.interp(frames, middles, column) for column in levels.T], axis=1)
    # a straight line between two values of variance v has (1 − s)² v + s² v
    share = np.interp(frames[~resting], middles, np.arange(len(rests))) % 1
    line = float(np.mean((1 - share) ** 2 + share**2))
    return level, np.sqrt(line * np.mean(wrong * (1 - kept), axis=0))


def _mean(counts: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "channel"]:
    read = np.isfinite(counts)
    return np.where(read, counts, 0.0).sum(axis=0) / np.maximum(read.sum(axis=0), 1)


def _rests(resting: Bool[np.ndarray, "frame"]) -> list[np.ndarray]:
    """Frames of the ends of every rest, or of the whole one where it is short."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], resting.astype(int), [0]])))
    rests = []
    for first, last in edges.reshape(-1, 2).tolist():
        rest = np.arange(first + _EDGE * (first > 0), last - _EDGE * (last < len(resting)))
        if len(rest) >= 2 * _FRAMES:
            rests += [rest[:_FRAMES], rest[-_FRAMES:]]
        elif len(rest) >= _LEAST_FRAMES:
            rests.append(rest)
    return rests
