"""Levels of signals at rest under presses: white noise and drift, a random walk, separated.

Levels are what all frames at rest of a session tell of the signals without contact at every frame (Kalman
filter forwards, Rauch–Tung–Striebel smoother backwards; Rauch, Tung & Striebel, AIAA J. 3, 1965). Near a
press they weigh frames at rest by their distance in time, on both sides, and say how far they may be off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.recordings.checks.faults import known_mean
from estimator.recordings.presses import runs

LEAST_FRAMES = 5
"""At rest between two presses, for their mean to tell of drift."""
LARGEST_DRIFT_NOISES = 6.0
"""Largest drift of a channel between two rests: more is a jump, and jumps have a moment that nobody knows."""
LONGEST_GAP_S = 120.0
"""Time between two rests over which drift is still taken from them."""
USUAL_S = 3.0
"""Time over which drift grows to the white noise of frames averaged over it, where nothing shows it."""
_LEAST_S, _LONGEST_S = 0.5, 30.0
"""Bounds on the time over which drift grows to the white noise."""
_CONTACT_FRAMES = 3
"""Frames of a contact, at least."""
_ROUNDS = 5
"""Rounds of the fit of noise and drift."""
_TOUCH_FRAMES = 2
"""Beside a contact: its first and last frames are below the force that counts as one."""
_LEAST_NOISE_COUNTS = 0.3
"""Noise of whole numbers."""
_UNKNOWN_COUNTS2 = 1e8
"""Variance of an offset of which nothing is known."""


@dataclass(frozen=True)
class RestLevels:
    """Counts without contact at every frame, and how far they may be off.

    Attributes
    ----------
    counts : (frame, face, sensor, axis)
    error : (frame, 2) variance (counts²), mean over channels, and how the errors of two frames go
        together: their covariance is the later frame's variance times exp(-(difference of the second))
    drift_counts2_s : by how much the drift's variance grows a second
    """

    counts: Float[np.ndarray, "frame face sensor 3"]
    error: Float[np.ndarray, "frame 2"]
    drift_counts2_s: float


@dataclass(frozen=True)
class RestFrames:
    """Means of stretches at rest between presses: when, of how many frames, lasting how long, and the
    first frame after the contact before each."""

    counts: Float[np.ndarray, "rest channel"]
    time_s: Float[np.ndarray, "rest"]
    frames: Int[np.ndarray, "rest"]
    lasts_s: Float[np.ndarray, "rest"]
    first: Int[np.ndarray, "rest"]


def levels_under_presses(
    counts: Float[np.ndarray, "frame face sensor 3"],
    time_s: Float[np.ndarray, "frame"],
    session: Int[np.ndarray, "frame"],
    loaded: Bool[np.ndarray, "frame"],
    rest: Bool[np.ndarray, "frame"],
    noise_counts: Float[np.ndarray, "face sensor 3"],
) -> RestLevels:
    """Levels from frames at rest, but for those next to a contact. Sessions say nothing of each other, nor
    do the two sides of a jump of a channel."""
    flat, loaded = counts.reshape(len(counts), -1), contact_ranges(loaded)
    has_reading = np.any(np.isfinite(flat), axis=0)
    noise = np.maximum(np.nan_to_num(noise_counts.ravel()), _LEAST_NOISE_COUNTS)
    used = rest & ~rests_beside(loaded)
    if used.sum() < LEAST_FRAMES:
        used = rest
    flat, noise = flat[:, has_reading], noise[has_reading]
    rests = rests_of(flat, time_s, loaded, used)
    new = np.diff(session, prepend=session[:1]) != 0
    jumps = channel_jumps(rests, session, noise)
    rate = drift_rate(rests, session, jumps, noise, float(np.median(np.diff(time_s))))
    grows = np.tile(rate * np.diff(time_s, prepend=time_s[:1])[:, None], len(noise))
    grows[new] += _UNKNOWN_COUNTS2
    after, channel = np.nonzero(jumps)
    grows[rests.first[after + 1], channel] += _UNKNOWN_COUNTS2
    level, variance, memory = smoothed_levels(
        np.where(used[:, None], flat, np.nan), noise**2, grows
    )
    whole = np.zeros((len(counts), has_reading.size))
    whole[:, has_reading] = level
    error = np.stack([variance.mean(axis=1), memory.mean(axis=1)], axis=1)
    return RestLevels(whole.reshape(counts.shape), error, rate)


def contact_ranges(loaded: Bool[np.ndarray, "frame"]) -> Bool[np.ndarray, "frame"]:
    """Without single frames that noise of a load cell lifts over the force of a contact."""
    held = loaded.copy()
    for first, last in runs(loaded.astype(int)):
        held[first:last] &= last - first >= _CONTACT_FRAMES
    return held


def rests_beside(loaded: Bool[np.ndarray, "frame"]) -> Bool[np.ndarray, "frame"]:
    near = loaded.copy()
    for step in range(1, _TOUCH_FRAMES + 1):
        near[step:] |= loaded[:-step]
        near[:-step] |= loaded[step:]
    return near


def rests_of(
    flat: Float[np.ndarray, "frame channel"],
    time_s: Float[np.ndarray, "frame"],
    loaded: Bool[np.ndarray, "frame"],
    used: Bool[np.ndarray, "frame"],
) -> RestFrames:
    ended = np.diff(loaded.astype(int), prepend=0) < 0
    frames = np.flatnonzero(used)
    parts = np.split(frames, np.flatnonzero(np.diff(np.cumsum(ended)[frames])) + 1)
    parts = [part for part in parts if len(part) >= LEAST_FRAMES]
    return RestFrames(
        np.array([known_mean(flat[part]) for part in parts]).reshape(-1, flat.shape[1]),
        np.array([time_s[part].mean() for part in parts]),
        np.array([len(part) for part in parts], int),
        np.array([np.ptp(time_s[part]) for part in parts]),
        np.array([last_contact_before(loaded, int(part[0])) + 1 for part in parts], int),
    )


def last_contact_before(loaded: Bool[np.ndarray, "frame"], frame: int) -> int:
    """The last frame of a contact before a frame, or -1."""
    return frame - 1 - int(np.argmax(loaded[:frame][::-1])) if loaded[:frame].any() else -1


def channel_jumps(
    rests: RestFrames, session: Int[np.ndarray, "frame"], noise: Float[np.ndarray, "channel"]
) -> Bool[np.ndarray, "gap channel"]:
    """Return which channels jumped between a rest and the next one of the session."""
    same = np.diff(session[rests.first]) == 0
    return same[:, None] & (abs(np.diff(rests.counts, axis=0)) > LARGEST_DRIFT_NOISES * noise)


def drift_rate(
    rests: RestFrames,
    session: Int[np.ndarray, "frame"],
    jumps: Bool[np.ndarray, "gap channel"],
    noise: Float[np.ndarray, "channel"],
    frame_s: float,
) -> float:
    """Growth of the variance a second, from what neighbouring rests differ by beyond white
    noise: the median of all channels, within what lets half a second to 30 s of frames be averaged.

    Squared differences weigh by how much drift compared with noise they are expected to hold.
    """
    white = float(np.median(noise)) ** 2 * frame_s
    apart_s = np.diff(rests.time_s) - (rests.lasts_s[1:] + rests.lasts_s[:-1]) / 6
    near = (np.diff(session[rests.first]) == 0) & (apart_s > 0) & (apart_s <= LONGEST_GAP_S)
    shown = near[:, None] & ~jumps & np.isfinite(np.diff(rests.counts, axis=0))
    if not shown.any():
        return white / USUAL_S**2
    noises = noise**2 * (1 / rests.frames[1:] + 1 / rests.frames[:-1])[:, None]
    beyond = np.nan_to_num(np.diff(rests.counts, axis=0)) ** 2 - noises
    rate, least, most = white / USUAL_S**2, white / _LONGEST_S**2, white / _LEAST_S**2
    for _ in range(_ROUNDS):
        weight = np.where(shown, apart_s[:, None] / (noises + rate * apart_s[:, None]) ** 2, 0.0)
        has_weight = np.any(weight > 0, axis=0)
        seconds = (weight * apart_s[:, None]).sum(axis=0)[has_weight]
        rates = (weight * beyond).sum(axis=0)[has_weight] / seconds
        rate = float(np.clip(np.median(rates), least, most))
    return rate


def smoothed_levels(
    rest_counts: Float[np.ndarray, "frame channel"],
    noise2: Float[np.ndarray, "channel"],
    grows: Float[np.ndarray, "frame channel"],
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Level, its variance, and its memory: minus the logarithm of the smoother's gain, summed up.

    `rest_counts` holds NaN where there is no frame at rest, `grows` the variance added before each frame.
    """
    is_rest = np.isfinite(rest_counts)
    first = is_rest.argmax(axis=0)
    level = np.where(
        is_rest.any(axis=0), np.nan_to_num(rest_counts)[first, np.arange(len(noise2))], 0.0
    )
    spread = np.full(len(noise2), _UNKNOWN_COUNTS2)
    levels, spreads, beforehand = (np.empty_like(rest_counts) for _ in range(3))
    values = np.where(is_rest, rest_counts, 0.0)
    for k in range(len(rest_counts)):
        spread = spread + grows[k]
        beforehand[k] = spread
        if is_rest[k].any():
            gain = np.where(is_rest[k], spread / (spread + noise2), 0.0)
            level = level + gain * (values[k] - level)
            spread = (1 - gain) * spread
        levels[k], spreads[k] = level, spread
    back = np.ones_like(rest_counts)
    back[:-1] = spreads[:-1] / beforehand[1:]
    for k in range(len(rest_counts) - 2, -1, -1):
        levels[k] += back[k] * (levels[k + 1] - levels[k])
        spreads[k] += back[k] ** 2 * (spreads[k + 1] - beforehand[k + 1])
    memory = np.concatenate([np.zeros((1, len(noise2))), -np.log(back[:-1]).cumsum(axis=0)])
    return levels, spreads, memory
