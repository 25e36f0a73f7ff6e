"""Contact slip in raw channels alone: no specification, no model, no labels.

A contact that sticks moves all channels along one line of their space, forth and back, however it is pulled:
place and direction stay, and the change goes with the pull. Where it slides the place changes too, and the
path bends off that line. The bend is held against the channels' noise at rest.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from estimator.grasps.holding import best_slip
from estimator.grasps.phases import HOLD_SHARE, START_N, find_grasps
from estimator.grasps.track import fresh_variance

REST_FRAMES = 20
"""Frames at rest that a recording begins with."""
LEAST_HOLD = 20
"""Frames of a hold below which nothing is said of it."""
_TOUCH = 3.0
"""Size of a change, over that of noise in all channels, from which something touches."""
_MEAN_FRAMES = 5
"""Frames that are averaged: noise bends a path less, and a slip lasts longer."""
_NOISE_BEND, _LOAD_BEND = 2.6, 0.015
"""Bend of a contact that sticks, over that of noise alone, and as a share of its signal: pulls are not quite
straight, and skins creep. Chosen on 200 recordings by the model of the tests."""
_UNDER_WAY = 5.5
"""Length off the line, summed over frames in quadrature, from which a slip is under way, in the same unit."""


@dataclass(frozen=True)
class ChannelSlip:
    """One hold in raw channels.

    Attributes
    ----------
    start, end : frames of the hold, half open
    signal : size of its change against rest, in deviations of noise
    bend : distance of the path off its line, rms, over what a contact that sticks shows: above 1 it slips;
        NaN where the hold is too short
    onset : frame, with fractions, in which the slip begins; NaN where there is none
    """

    start: int
    end: int
    signal: float
    bend: float
    onset: float

    @property
    def slipped(self) -> bool:
        """Return whether the contact slid."""
        return self.bend > 1


def slips_in_channels(
    values: Float[np.ndarray, "frame channel"], time_s: Float[np.ndarray, "frame"]
) -> list[ChannelSlip]:
    """Find holds in raw channels and judge each; the first `REST_FRAMES` frames must be at rest.

    Channels with a gap are left out. A slide without any pull before it is a line as well, and is missed; two
    pulls across each other count as a slip.
    """
    values = values[:, np.isfinite(values).all(axis=0)]
    if len(values) < REST_FRAMES + LEAST_HOLD or not values.shape[1]:
        return []
    noise = np.sqrt(fresh_variance(values[:REST_FRAMES]))
    rest = np.median(values[:REST_FRAMES], axis=0)
    # a channel that stands still at rest has the noise of whole counts, 1/√12
    change = (values - rest) / np.where(noise > 0, noise, 1 / np.sqrt(12))
    size = np.linalg.norm(change, axis=1)
    touch = _TOUCH * np.sqrt(change.shape[1])
    return [
        _judged(change, size, grasp.start, grasp.end)
        for grasp in find_grasps(time_s, size * START_N / touch)
    ]


def _judged(
    change: Float[np.ndarray, "frame channel"],
    size: Float[np.ndarray, "frame"],
    start: int,
    end: int,
) -> ChannelSlip:
    # a slip may change the load, so that the hold's ends have levels of their own
    held = np.arange(start, end)[size[start:end] > np.max(size[start:end]) / 2]
    early, late = (np.median(size[part]) for part in np.array_split(held, 2))
    first = int(held[np.argmax(size[held] >= HOLD_SHARE * early)]) + _MEAN_FRAMES // 2
    last = int(held[np.flatnonzero(size[held] >= HOLD_SHARE * late)[-1]]) + 1
    signal = float(np.median(size[held]))
    if last - first < LEAST_HOLD:
        return ChannelSlip(first, max(first, last), signal, float("nan"), float("nan"))
    path = _unloaded(change[first:last])
    means = np.lib.stride_tricks.sliding_window_view(path, _MEAN_FRAMES, axis=0).mean(axis=-1)
    usual = np.hypot(_NOISE_BEND * _bend_of_noise(*means.shape), _LOAD_BEND * signal)
    bend = _off_the_line(means) / np.sqrt(len(means)) / usual
    onset = first + _onset(path, means, _UNDER_WAY * usual) if bend > 1 else float("nan")
    return ChannelSlip(first, last, signal, float(bend), onset)


def _unloaded(change: Float[np.ndarray, "frame channel"]) -> Float[np.ndarray, "frame channel"]:
    """Path of the hold from where it began, scaled to one load: a change of the load alone goes no way."""
    begin = np.median(change[: 2 * _MEAN_FRAMES], axis=0)
    # scale each frame so that its share along the beginning is that of the beginning
    share = change @ begin / (begin @ begin)
    return change / np.maximum(share, 0.1)[:, None] - begin


def _off_the_line(path: Float[np.ndarray, "frame channel"]) -> float:
    """Length of a path off the line that fits it best, over frames in quadrature: its second singular
    value."""
    return float(np.linalg.svd(path, compute_uv=False)[1])


def _bend_of_noise(frames: int, channels: int) -> float:
    """Largest bend that noise of one deviation makes, rms: of m independent frames (1 + √(channels/m))
    (Marchenko & Pastur, Math. USSR Sbornik 1, 1967), less by the averaging."""
    independent = frames / _MEAN_FRAMES
    return (1 + np.sqrt(channels / independent)) / np.sqrt(_MEAN_FRAMES)


def _onset(
    path: Float[np.ndarray, "frame channel"], means: Float[np.ndarray, "mean channel"], sure: float
) -> float:
    """Frame in which the path leaves the line of what came before."""
    counts = range(3, len(means) + 1)
    begun = next((n for n in counts if _off_the_line(means[:n]) > sure), len(means))
    line = np.linalg.svd(means[: max(3, begun - _MEAN_FRAMES // 2)], full_matrices=False)[2][0]
    off = path - np.outer(path @ line, line)
    onset, *_ = best_slip(np.arange(len(path), dtype=float), off, 1.0)
    return onset
