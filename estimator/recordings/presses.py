"""Presses in a recording: interruptions, boundaries, and the lag of the force.

The load cells of the public recordings report late: about 8 frames behind the Hall sensors
(measured: it cuts the variance that a static curve H(F) leaves from about 18 to about 3 %).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE

PAUSE_S = 5.0
"""Pause after which a new stretch of frames begins."""
CONTACT_FORCE_N = 0.3
"""Force from which a load cell shows a contact."""
LAGS = range(-10, 26)
"""Frames by which the force may lag behind the signals (negative: it is ahead)."""
LEAST_CONTACT_FRAMES = 5
"""Frames in a row that make a contact; shorter excursions are edges and glitches."""
_LEVEL_ROUNDS = 50
"""Rounds in which levels of rest are found, at most."""
_STEADY_REST_N = 0.15
"""Least force by which a cell may leave its level at rest."""
LAG_FRAMES = 3 * max(LAGS)
"""More are needed to tell a lag."""
_CURVE_DEGREE = 3
"""Degree of the polynomial in the force that follows a signal."""


@dataclass(frozen=True)
class LagReport:
    """Lag of the force behind the Hall signals, from a cubic H(F) fitted to each press.

    `residual_uncorrected` and `residual_corrected` are the shares of the Hall signals' variance
    that the curve leaves at lag 0 and at `frames`; `share_within_2` is the share of presses whose
    own best lag lies within 2 frames of it. `corrected` says whether it was trusted and applied.
    Without a press long enough to fit, both residuals are 1.
    """

    frames: int
    per_press: tuple[int, ...]
    share_within_2: float
    residual_uncorrected: float
    residual_corrected: float
    corrected: bool


def stretches(
    time_s: Float[np.ndarray, "stamp"], case: Float[np.ndarray, "frame label"]
) -> Int[np.ndarray, "frame"]:
    """Number of the uninterrupted stretch that each frame lies in.

    A stretch ends at a pause of more than `PAUSE_S`, where time runs backwards and where the
    contact case changes.
    """
    breaks = np.any(case[1:] != case[:-1], axis=1)
    if len(time_s):
        step = np.diff(time_s)
        breaks |= (step > PAUSE_S) | (step < 0)
    return np.concatenate([[0], np.cumsum(breaks)])


def frame_times_s(
    time_s: Float[np.ndarray, "stamp"], stretch: Int[np.ndarray, "frame"], nominal_rate_hz: float
) -> tuple[Float[np.ndarray, "frame"], float]:
    """Strictly increasing time axis (s) and frame rate (Hz).

    Stamps in whole seconds repeat: frames are spread evenly over each stretch, at the rate that
    all stretches share. Without stamps, or with one, the nominal rate is used.
    """
    if len(time_s) < 2:
        return np.arange(len(stretch)) / nominal_rate_hz, nominal_rate_hz
    if np.all(np.diff(time_s) > 0):
        return time_s, float(1 / np.median(np.diff(time_s)))
    position, mean_position, mean_time = _frames_within(time_s, stretch)
    centred, time_centred = position - mean_position, time_s - mean_time
    slope = np.sum(centred * time_centred) / max(np.sum(centred**2), 1.0)
    period = slope if slope > 0 else 1 / nominal_rate_hz
    times = mean_time + centred * period
    for begin in np.flatnonzero(np.diff(stretch)) + 1:
        times[begin:] += max(0.0, times[begin - 1] + period - times[begin])
    return times, float(1 / period)


def _frames_within(
    time_s: Float[np.ndarray, "frame"], stretch: Int[np.ndarray, "frame"]
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame"], Float[np.ndarray, "frame"]]:
    """Position of each frame, and mean position and time of its stretch."""
    position = np.arange(len(stretch), dtype=float)
    count = np.bincount(stretch)
    mean_position = np.bincount(stretch, position) / count
    mean_time = np.bincount(stretch, time_s) / count
    return position, mean_position[stretch], mean_time[stretch]


def tared(
    force_n: Float[np.ndarray, "frame cell"],
    no_contact: Bool[np.ndarray, "frame"],
    rest_force_n: float,
    signed: bool,
) -> Float[np.ndarray, "frame cell"]:
    """Forces (N) counted positive in compression from each cell's own rest level.

    Rest is the lowest level. Where the file's sign is not known (not `signed`), it is the level of
    the frames labelled as no contact, else that extreme at which the force dwells longer.
    """
    columns = [_tared_cell(cell, no_contact, rest_force_n, signed) for cell in force_n.T]
    return np.column_stack(columns)


def _tared_cell(
    force_n: Float[np.ndarray, "frame"],
    no_contact: Bool[np.ndarray, "frame"],
    rest_force_n: float,
    signed: bool,
) -> Float[np.ndarray, "frame"]:
    low, high = np.percentile(force_n, [1, 99])
    at_low = force_n <= low + rest_force_n
    if signed:
        return force_n - _rest_level_n(force_n, float(np.median(force_n[at_low])), rest_force_n)
    if no_contact.any():
        rest = np.median(force_n[no_contact])
        return (force_n - rest) * (1.0 if high - rest >= rest - low else -1.0)
    at_high = force_n >= high - rest_force_n
    if at_high.sum() > at_low.sum():
        return np.median(force_n[at_high]) - force_n
    return force_n - np.median(force_n[at_low])


def _rest_level_n(
    force_n: Float[np.ndarray, "frame"], level_n: float, rest_force_n: float
) -> float:
    """Level where forces gather, from a level near it: the median of those within `rest_force_n` of it, again
    and again (noise puts the lowest ones far below it)."""
    for _ in range(_LEVEL_ROUNDS):
        before_n = level_n
        level_n = float(np.median(force_n[np.abs(force_n - level_n) <= rest_force_n]))
        if level_n == before_n:
            break
    return level_n


def number_presses(
    force_n: Float[np.ndarray, "frame cell"],
    stretch: Int[np.ndarray, "frame"],
    rest_force_n: float,
) -> Int[np.ndarray, "frame"]:
    """Press id of every frame: one excursion of force with the rest around it.

    Between two excursions of one stretch the boundary lies in the middle of the rest.
    """
    starts = [0]
    for first, last in runs(stretch):
        starts.append(first)
        excursions = force_excursions(force_n[first:last].max(axis=1), rest_force_n)
        for (_, end), (begin, _) in pairwise(excursions):
            starts.append(first + (end + begin + 1) // 2)
    marks = np.zeros(len(stretch), dtype=int)
    marks[np.unique(starts)] = 1
    return np.cumsum(marks) - 1


def runs(labels: Int[np.ndarray, "frame"]) -> list[tuple[int, int]]:
    """Ranges (first, last + 1) of equal neighbouring labels."""
    edges = np.flatnonzero(np.diff(labels)) + 1
    bounds = [0, *edges.tolist(), len(labels)]
    return list(pairwise(bounds))


def force_excursions(
    force_n: Float[np.ndarray, "frame"], rest_force_n: float
) -> list[tuple[int, int]]:
    """Frame ranges above `CONTACT_FORCE_N`, joined where the force never came back to rest."""
    pressed = [
        (first, last)
        for first, last in runs((force_n > CONTACT_FORCE_N).astype(int))
        if force_n[first] > CONTACT_FORCE_N and last - first >= LEAST_CONTACT_FRAMES
    ]
    joined: list[tuple[int, int]] = []
    for first, last in pressed:
        if joined and force_n[joined[-1][1] : first].min() > rest_force_n:
            joined[-1] = (joined[-1][0], last)
        else:
            joined.append((first, last))
    return joined


def estimate_lag(
    counts: Float[np.ndarray, "frame face sensor 3"],
    force_n: Float[np.ndarray, "frame cell"],
    face: Int[np.ndarray, "frame cell"],
    press: Int[np.ndarray, "frame"],
    stretch: Int[np.ndarray, "frame"],
) -> LagReport:
    """Return how many frames the force lags behind the signals of the face that it presses.

    Each press and cell gives one curve of residual variance against lag; the recording's lag
    minimises their mean. It is applied only if the presses agree and the residual falls. Presses too
    short to tell are taken together with those after them in their stretch.
    """
    curves = np.array(
        [
            residual_by_lag(
                _live(counts[first:last, face[first, cell] - 1]), force_n[first:last, cell]
            )
            for first, last in long_presses(press, stretch)
            for cell in range(force_n.shape[1])
            if face[first, cell] != NO_FACE
            and np.ptp(force_n[first:last, cell]) > 3 * CONTACT_FORCE_N
            and last - first > LAG_FRAMES
        ]
    ).reshape(-1, len(LAGS))
    curves = curves[np.isfinite(curves).all(axis=1)]
    if not len(curves):
        return LagReport(0, (), 0.0, 1.0, 1.0, False)
    mean = curves.mean(axis=0)
    best, zero = int(np.argmin(mean)), LAGS.index(0)
    best_lags = curves.argmin(axis=1)
    agreement = float(np.mean(np.abs(best_lags - best) <= 2))
    trusted = agreement >= 0.5 and mean[best] < 0.8 * mean[zero]
    lags = tuple(int(LAGS[k]) for k in best_lags)
    return LagReport(
        LAGS[best], lags, agreement, float(mean[zero]), float(mean[best]), bool(trusted)
    )


def long_presses(
    press: Int[np.ndarray, "frame"], stretch: Int[np.ndarray, "frame"]
) -> list[tuple[int, int]]:
    """Frame ranges of presses, short ones joined with the next of their stretch until they are long."""
    joined: list[tuple[int, int]] = []
    for first, last in runs(press):
        if joined and stretch[joined[-1][0]] == stretch[first]:
            begin, end = joined[-1]
            if end - begin <= LAG_FRAMES:
                joined[-1] = (begin, last)
                continue
        joined.append((first, last))
    return joined


def _live(counts: Float[np.ndarray, "frame sensor 3"]) -> Float[np.ndarray, "frame channel"]:
    flat = counts.reshape(len(counts), -1)
    return flat[:, np.isfinite(flat).all(axis=0)]


def residual_by_lag(
    counts: Float[np.ndarray, "frame channel"], force_n: Float[np.ndarray, "frame"]
) -> Float[np.ndarray, "lag"]:
    """Share of variance that a cubic in force leaves; every lag judges the same frames."""
    first, last = -min(LAGS), len(force_n) - max(LAGS)
    signal = counts[first:last] - counts[first:last].mean(axis=0)
    variance = np.sum(signal**2)
    if not variance > 0:
        return np.full(len(LAGS), np.nan)
    force = np.stack([force_n[first + lag : last + lag] for lag in LAGS])
    scale = np.maximum(np.ptp(force, axis=1, keepdims=True), 1e-9)
    relative = (force - force.mean(axis=1, keepdims=True)) / scale
    basis, _ = np.linalg.qr(relative[..., None] ** np.arange(_CURVE_DEGREE, -1, -1))
    return 1 - np.sum((basis.transpose(0, 2, 1) @ signal) ** 2, axis=(1, 2)) / variance


def shifted_forces(
    force_n: Float[np.ndarray, "frame cell"], stretch: Int[np.ndarray, "frame"], lag: int
) -> Float[np.ndarray, "frame cell"]:
    """Force of the same instant as each frame's signals; NaN where the stretch ended too early."""
    source = np.arange(len(force_n)) + lag
    inside = (source >= 0) & (source < len(force_n))
    inside[inside] &= stretch[source[inside]] == stretch[inside]
    shifted = np.full(force_n.shape, np.nan)
    shifted[inside] = force_n[source[inside]]
    return shifted


def shifted_shear(
    shear_n: Float[np.ndarray, "frame cell 2"],
    stretch: Int[np.ndarray, "frame"],
    lag: int,
    rest: Bool[np.ndarray, "frame"],
) -> Float[np.ndarray, "frame cell 2"]:
    """Tangential forces as `shifted_forces`, counted from their median at rest."""
    axes = [shifted_forces(shear_n[..., axis], stretch, lag) for axis in range(2)]
    shifted = np.stack(axes, axis=2)
    return shifted - np.median(shifted[rest], axis=0) if rest.any() else shifted


def rest_limit_n(force_n: Float[np.ndarray, "frame cell"]) -> float:
    """Force below which hardly any frame at rest is missed (N): three standard deviations of the noisiest
    load cell at rest, between those of the steadiest cells and the force that counts as contact."""
    low = [abs(cell[abs(cell) < CONTACT_FORCE_N]) for cell in force_n.T]
    noise_n = max((1.4826 * float(np.median(part)) for part in low if len(part)), default=0.0)
    return float(np.clip(3 * noise_n, _STEADY_REST_N, CONTACT_FORCE_N))


def is_at_rest(
    force_n: Float[np.ndarray, "frame cell"], rest_force_n: float
) -> Bool[np.ndarray, "frame"]:
    """Frames in which every cell stays within `rest_force_n` of its rest level."""
    return np.all(np.abs(force_n) < rest_force_n, axis=1)
