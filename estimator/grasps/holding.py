"""Figures of taking and holding an object: loading rate, creep, contact slip, steadiness."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.stats import chi2

from estimator.grasps.track import fresh_variance

_RATE_FRAMES = 3
"""Frames over which a slope is taken: two would show noise."""
_REFERENCE_FRAMES = 3
"""Frames whose median is where a contact began and ended."""
LEAST_SLIP_MM = 0.3
"""Least distance that counts as slip: below, estimators drift."""
_SURE = 25.0
"""Misfit, in variances of a frame, that a slip must take away: its way is five deviations of its own."""
_BEGINS, _LASTS, _FINE = 200, 28, 8
"""Beginnings and durations of slips that are tried, and beginnings a frame about the best."""
_SHORTEST = 1 / 16
"""Frames that a slip lasts at least: a jump, wherever between two frames."""
_ALIKE = 1e-3
"""Probabilities of an onset that differ by less count as the same."""
_TOGETHER = float(chi2.ppf(0.99, 2))
"""Misfit, in variances, that slips of one onset and one duration may leave above slips of two each."""
_STRAIGHT_MM = 0.05
"""Least deviation of a frame from a straight slip: estimators read places along a slip no better."""
_AGREE, _WIDEST = 2.0, 25
"""Deviations by which means over narrower and wider windows may differ, and half of the widest window."""


def loading_rate_n_per_s(
    time_s: Float[np.ndarray, "frame"], force_n: Float[np.ndarray, "frame"]
) -> float:
    """Steepest rise of a force: largest least-squares slope over three frames; NaN where there are fewer."""
    slopes = []
    for first in range(len(force_n) - _RATE_FRAMES + 1):
        window = slice(first, first + _RATE_FRAMES)
        centred = time_s[window] - time_s[window].mean()
        if (square := float(centred @ centred)) > 0:
            slopes.append(float(centred @ force_n[window]) / square)
    return max(slopes, default=float("nan"))


def creep_per_decade(
    time_s: Float[np.ndarray, "frame"], force_n: Float[np.ndarray, "frame"]
) -> float:
    """Change of a held force per tenfold time, as a share of its mean: negative where it relaxes.

    Slope of the force against log10 of the time since the hold began, by least squares; the first
    frame has no logarithm. NaN with fewer than four frames.
    """
    if len(force_n) < 4 or not np.all(np.diff(time_s) > 0):
        return float("nan")
    decades = np.log10(time_s[1:] - time_s[0])
    centred = decades - decades.mean()
    return float(centred @ force_n[1:] / (centred @ centred) / force_n.mean())


def unsteadiness(force_n: Float[np.ndarray, "frame"]) -> float:
    """Root mean square deviation of a held force from its mean, over that mean."""
    return float(np.std(force_n) / np.mean(force_n))


def peak_frames(force_n: Float[np.ndarray, "frame"], hold: slice) -> slice:
    """Frames over which a force is at its peak: the window with the largest mean, or the hold where that
    is larger.

    The largest of many noisy readings is too large, so that each frame stands for the widest window about
    it whose mean agrees with those of all narrower ones (intersecting intervals; Goldenshluger & Nemirovski,
    Math. Methods Statist. 6, 1997). What rises above the noise keeps a window of its own.
    """
    count, sigma = len(force_n), float(np.sqrt(fresh_variance(force_n)))
    total = np.concatenate([[0.0], np.cumsum(force_n)])
    low, high = np.full(count, -np.inf), np.full(count, np.inf)
    mean, half = force_n.copy(), np.zeros(count, int)
    agrees = np.ones(count, bool)
    for reach in range(min(_WIDEST, (count - 1) // 2) + 1):
        middle, width = np.arange(reach, count - reach), 2 * reach + 1
        wide = np.full(count, np.nan)
        wide[middle] = (total[middle + reach + 1] - total[middle - reach]) / width
        error = _AGREE * sigma / np.sqrt(width)
        low, high = np.fmax(low, wide - error), np.fmin(high, wide + error)
        agrees &= np.isfinite(wide) & (low <= high)
        mean, half = np.where(agrees, wide, mean), np.where(agrees, reach, half)
    peak = int(np.argmax(mean))
    if force_n[hold].mean() >= mean[peak]:
        return hold
    return slice(peak - int(half[peak]), peak + int(half[peak]) + 1)


@dataclass(frozen=True)
class Slip:
    """Motion of a contact along the surface while it is held.

    `onset_s` is NaN where it did not slip. `distance_mm` is where it ended against where it began.
    """

    onset_s: float
    distance_mm: float

    @property
    def slipped(self) -> bool:
        """Return whether there was slip."""
        return not np.isnan(self.onset_s)


def contact_slip(
    time_s: Float[np.ndarray, "frame"], centre_mm: Float[np.ndarray, "frame 2"]
) -> Slip:
    """Onset and distance of slip of a face's centre of force.

    The straight slip between two rests that fits best is held against no slip at all, by least squares. It
    counts where it is longer than `LEAST_SLIP_MM`, explains far more than noise would, and the centre does
    not come back. Noise is a robust scatter of successive differences, which a slow slip does not
    widen. Give NaN for frames in which another contact takes part: it moves the centre as well.
    """
    present = np.isfinite(centre_mm).all(axis=1)
    time_s, centre_mm = time_s[present], centre_mm[present]
    if len(centre_mm) < 2 * _REFERENCE_FRAMES:
        return Slip(float("nan"), float("nan"))
    variance = _variance_mm2(centre_mm)
    onset_s, gain, way = best_slip(time_s, centre_mm, variance)
    distance = float(np.linalg.norm(way))
    moved = (centre_mm - np.median(centre_mm[:_REFERENCE_FRAMES], axis=0)) @ way
    stays = np.median(moved[-_REFERENCE_FRAMES:]) > distance**2 / 2
    slipped = distance > LEAST_SLIP_MM and gain > _SURE * variance and bool(stays)
    return Slip(onset_s if slipped else float("nan"), distance)


def common_onset_s(
    time_s: Float[np.ndarray, "frame"], centres_mm: Sequence[Float[np.ndarray, "frame 2"]]
) -> float:
    """Onset of one slip of several faces' centres: an object that slips out of jaws moves against all.

    The slip of `contact_slip` is fitted to all of them at once, each as exact as it is steady. NaN where
    slips of their own explain the centres far better, or where fewer than two are given.
    """
    if len(centres_mm) < 2:
        return float("nan")
    present = np.isfinite(np.concatenate(centres_mm, axis=1)).all(axis=1)
    time_s = time_s[present]
    if len(time_s) < 2 * _REFERENCE_FRAMES:
        return float("nan")
    steady = [centre[present] / np.sqrt(_variance_mm2(centre[present])) for centre in centres_mm]
    apart = sum(best_slip(time_s, centre, 1.0)[1] for centre in steady)
    onset_s, gain, _ = best_slip(time_s, np.concatenate(steady, axis=1), 1.0)
    return onset_s if apart - gain < _TOGETHER else float("nan")


def _variance_mm2(centre_mm: Float[np.ndarray, "frame 2"]) -> float:
    return max(float(fresh_variance(centre_mm).mean()), _STRAIGHT_MM**2)


def best_slip(
    time_s: Float[np.ndarray, "frame"], centre_mm: Float[np.ndarray, "frame k"], variance: float
) -> tuple[float, float, Float[np.ndarray, "k"]]:
    """Onset, misfit taken away (mm²) and way of the best straight slip.

    The onset is the middle of the one frame's time that most probably holds it, whatever the duration. A jump
    between two frames began in their middle, give or take half a frame.
    """
    last = len(time_s) - 1
    lasts = np.geomspace(_SHORTEST, max(last, 1.0), _LASTS)
    begins = np.linspace(0, last, min(last + 1, _BEGINS))
    gain, _ = _gains(time_s, centre_mm, begins, lasts)
    best = float(begins[np.argmax(gain.max(axis=1))])
    # middles of eighths of frames, so that their mean is the middle of a frame
    width = _FINE * (2 + max(1.0, last / _BEGINS))
    fine = best + (np.arange(-width, width) + 0.5) / _FINE
    fine = fine[(fine > -1) & (fine < last)]
    gain, ways = _gains(time_s, centre_mm, fine, lasts)
    # durations are as likely before in equal steps of their logarithm
    weight = np.exp((gain - gain.max()) / (2 * variance)).sum(axis=1)
    weight /= weight.sum()
    held = (abs(fine[:, None] - fine) <= 0.5) @ weight
    onset = float(fine[held >= held.max() - _ALIKE].mean())
    begin, end = np.unravel_index(int(np.argmax(gain)), gain.shape)
    return float(np.interp(onset, np.arange(last + 1), time_s)), float(gain.max()), ways[begin, end]


def _gains(
    time_s: Float[np.ndarray, "frame"],
    centre_mm: Float[np.ndarray, "frame k"],
    begins: Float[np.ndarray, "begin"],
    lasts: Float[np.ndarray, "last"],
) -> tuple[Float[np.ndarray, "begin last"], Float[np.ndarray, "begin last k"]]:
    """Misfit that slips of many beginnings and durations (in frames) take away, and their ways."""
    frame = np.arange(len(time_s))
    share = np.clip((frame - begins[:, None, None]) / lasts[:, None], 0.0, 1.0)
    # a slip that goes on has come so far in the middle of the last frames
    reached = share[..., -1 - _REFERENCE_FRAMES // 2, None].copy()
    share -= share.mean(axis=2, keepdims=True)
    spread = np.maximum(np.sum(share**2, axis=2), 1e-9)
    # least squares of the centre on the share: b begin, l duration, f frame, k direction
    moment = np.einsum("blf,fk->blk", share, centre_mm)
    return np.sum(moment**2, axis=2) / spread, reached * moment / spread[..., None]
