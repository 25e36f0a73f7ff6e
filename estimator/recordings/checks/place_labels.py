"""Labels of places held against the signals: presses that respond like those of another place."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import FrameSet
from estimator.recordings.checks.faults import Fault, rows_text
from estimator.recordings.contacts import Place, place_text
from estimator.recordings.presses import LEAST_CONTACT_FRAMES, runs

_LOADED_SHARE = 0.5
"""Share of the largest force from which frames are compared."""
_OWN_DISTANCE = 0.4
_DISTANCE_RATIO = 2.5
"""Chord from its own case, and over that to the nearest other case, from which a label is doubted."""


def place_label_faults(
    frames: FrameSet, places: tuple[Place, ...]
) -> tuple[Bool[np.ndarray, "frame"], list[Fault]]:
    """Presses that respond unlike the others of their place, and like those of another place.

    A press's pattern is its mean change under load as a unit vector over the live channels;
    compared are chords to the mean pattern of the other presses of its own place (must exceed 0.4)
    and of each other place with the same faces (2.5 times nearer). A place pressed once cannot be
    judged.
    """
    wrong = np.zeros(len(frames), dtype=bool)
    press, place, pattern = press_patterns(frames)
    pressed, index, count = np.unique(place, return_inverse=True, return_counts=True)
    mean = np.array([pattern[index == number].mean(axis=0) for number in range(len(pressed))])
    likeness: dict[int, int] = {}
    for k in np.flatnonzero(count[index] > 1):
        own_place = index[k]
        others = (mean[own_place] * count[own_place] - pattern[k]) / (count[own_place] - 1)
        near = float(chords(pattern[k], others[None])[0])
        rivals = chords(pattern[k], mean)
        same = [_faces(places[other_place]) == _faces(places[place[k]]) for other_place in pressed]
        rivals[~np.array(same)] = np.inf
        rivals[own_place] = np.inf
        best = int(rivals.argmin())
        if near > max(_OWN_DISTANCE, _DISTANCE_RATIO * rivals[best]):
            likeness[int(k)] = int(pressed[best])
    faults = []
    for k, best in likeness.items():
        rows = np.flatnonzero(frames.press_id == press[k])
        wrong[rows] = True
        detail = (
            f"labelled {place_text(places[place[k]])} mm, responds like {place_text(places[best])}"
        )
        swapped = [
            j for j, other_place in likeness.items() if place[j] == best and other_place == place[k]
        ]
        if swapped:
            partner = np.flatnonzero(frames.press_id == press[swapped[0]])
            detail += f", as if swapped with {rows_text(partner)}"
        faults.append(Fault("wrong place label", rows_text(rows), detail, "press not used"))
    return wrong, faults


def press_patterns(
    frames: FrameSet,
) -> tuple[Int[np.ndarray, "press"], Int[np.ndarray, "press"], Float[np.ndarray, "press channel"]]:
    """Press id, place id and unit pattern of every press with loaded, usable frames."""
    patterns = [
        (press, place, mean / max(_size(mean), 1e-9))
        for press, place, mean, _ in _loaded_means(frames)
    ]
    if not patterns:
        empty = np.empty(0, dtype=int)
        return empty, empty, np.empty((0, frames.signal_counts[0].size))
    press, place, pattern = zip(*patterns, strict=True)
    return np.array(press), np.array(place), np.array(pattern)


def pattern_noises(frames: FrameSet) -> Float[np.ndarray, "press channel"]:
    """Standard deviation of `press_patterns` by the noise of the readings, that of the zero counted as
    large as the mean's."""
    noise_by_channel = np.nan_to_num(frames.noise_counts)
    noise = np.broadcast_to(noise_by_channel, frames.signal_counts.shape[1:]).ravel()
    noises = [
        noise * np.sqrt(2 / rows) / max(_size(mean), 1e-9)
        for _, _, mean, rows in _loaded_means(frames)
    ]
    return np.array(noises).reshape(-1, len(noise))


def _loaded_means(
    frames: FrameSet,
) -> Iterator[tuple[int, int, Float[np.ndarray, "channel"], int]]:
    """Press id, place id, mean signals and number of the loaded, usable frames of every press."""
    total = np.nansum(frames.force_n[..., 2], axis=1)
    loaded = frames.valid & (frames.place_id >= 0)
    signal = frames.signal_counts.reshape(len(frames), -1)
    for first, last in runs(frames.press_id):
        rows = np.arange(first, last)[loaded[first:last]]
        rows = rows[total[rows] >= _LOADED_SHARE * total[rows].max()] if len(rows) else rows
        if len(rows) >= LEAST_CONTACT_FRAMES:
            yield (
                int(frames.press_id[first]),
                int(frames.place_id[rows[0]]),
                signal[rows].mean(axis=0),
                len(rows),
            )


def _size(mean: Float[np.ndarray, "channel"]) -> float:
    return float(np.sqrt(np.nansum(mean**2)))


def chords(
    pattern: Float[np.ndarray, "channel"], others: Float[np.ndarray, "place channel"]
) -> Float[np.ndarray, "place"]:
    """Distances of a unit pattern from others, over the channels that both have."""
    return np.sqrt(np.nansum((pattern - others) ** 2, axis=-1))


def _faces(place: Place) -> tuple[int, ...]:
    return tuple(face for face, _, _ in place)
