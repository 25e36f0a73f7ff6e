"""Error of the place as maximum likelihood reads it, where signals are not linear in the place.

The Cramér–Rao bound holds near the truth. A reader also meets folds, where signals turn round, and
rivals: places far away that give nearly the same signals. The likelihood has an optimum where the
misfit has no part along the slopes T of the signals. With Δ the signals of the true press less those
of place q at its best force, in standard deviations of noise, optima lie at q with the density

    √det(TᵀT) / 2π · exp(−|T T⁺ Δ|² / 2)

(Kac and Rice's formula with the expected curvature). An optimum is the answer by the odds
Q(h) / (1 − Q(h)), with Q the normal tail and 2h = |Δ − T T⁺ Δ|: the noise must make up for half of the
way between two presses.

For signals linear in the place this is the normal density of the bound. Of few rivals far away it is
the method of interval errors (Athley, IEEE Trans. Signal Process. 53, 2005). In between it is an
approximation: `benchmarks/position_error.py` holds it against simulated maximum likelihood.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from estimator.information.rival_presses import (
    PlaceSlopes,
    RivalPresses,
    place_slopes,
    unit_vectors,
)

_WINDOW = 0.4
"""Width (standard deviation) of normal windows round the lattice's places, in its steps: 1 / √(2π), where a
window is 1 at its own place. They share out the plane between the places; their sum is 0.83 to 1.18,
so that errors of linear signals are within 4 % of the bound."""
_BESIDE = 2.5
"""Steps of the lattice round a press within which its own slopes hold: lobes of the likelihood narrower
than the lattice are missed by its places, and the bound serves there."""
_MOST_NUMBERS = 1 << 22
"""Most numbers (presses times rivals) held in memory at a time."""


@dataclass(frozen=True)
class _Optima:
    """Optima of the likelihood near each place of the lattice.

    Attributes
    ----------
    axes, per_mm : as of `PlaceSlopes`
    along : how far the signals lie along the slopes there, in standard deviations of noise
    across : distance across them
    """

    axes: Float[np.ndarray, "press place 2 2"]
    per_mm: Float[np.ndarray, "press place 2"]
    in_plane: Float[np.ndarray, "press place 2"]
    across: Float[np.ndarray, "press place"]


def position_errors_mm(
    rivals: RivalPresses,
    xy_mm: Float[np.ndarray, "press 2"],
    signals: Float[np.ndarray, "press channel"],
    slopes: Float[np.ndarray, "press channel 3"],
) -> Float[np.ndarray, "press"]:
    """Root mean square distance of presses from where maximum likelihood reads them.

    The reader knows the face and where it ends, neither place nor force. Infinite where it has no
    place to tell.

    Parameters
    ----------
    rivals : whitened
    xy_mm, signals, slopes : of the presses, as of `rivals`
    """
    some = max(1, _MOST_NUMBERS // (4 * rivals.is_pressed.size))
    parts = [slice(start, start + some) for start in range(0, len(xy_mm), some)]
    return np.concatenate(
        [_errors_mm(rivals, xy_mm[part], signals[part], slopes[part]) for part in parts]
    )


def _errors_mm(
    rivals: RivalPresses,
    xy_mm: Float[np.ndarray, "press 2"],
    signals: Float[np.ndarray, "press channel"],
    slopes: Float[np.ndarray, "press channel 3"],
) -> Float[np.ndarray, "press"]:
    from scipy.special import log_ndtr

    away = rivals.xy_mm - xy_mm[:, None]
    optima = _with_press_slopes(
        _optima(rivals, signals), place_slopes(slopes), away, rivals.step_mm
    )
    # normal density of the optimum times normal window, on each axis on its own
    window = (_WINDOW * rivals.step_mm) ** 2
    narrow = optima.per_mm**2 * window
    square = window / (1 + narrow)
    shift = square * optima.per_mm * optima.in_plane
    with np.errstate(divide="ignore"):
        log_mass = (np.log(narrow / (1 + narrow)) - optima.in_plane**2 / (1 + narrow)).sum(-1) / 2
    half = optima.across / 2
    log_mass += log_ndtr(-half) - log_ndtr(half)
    top = log_mass.max(axis=1, keepdims=True)
    mass = np.exp(log_mass - np.where(np.isfinite(top), top, 0.0))
    distance = _axis_components(optima.axes, away) + shift
    square = (distance**2 + square).sum(-1)
    total = mass.sum(axis=1)
    mean = (mass * square).sum(axis=1) / np.where(total > 0, total, 1.0)
    return np.sqrt(np.where(total > 0, mean, np.inf))


def _optima(rivals: RivalPresses, signals: Float[np.ndarray, "press channel"]) -> _Optima:
    """From the force of each place that is nearest to the signals, by one step of the force."""
    slopes = rivals.place_slopes
    force, per_n = unit_vectors(rivals.slopes[..., 2])
    probes = np.concatenate(
        [rivals.signals[:, :, None], force[:, :, None], slopes.patterns], axis=2
    )
    on_itself = (probes @ rivals.signals[..., None])[..., 0]
    products = np.tensordot(signals, probes, axes=(1, 3))
    square = np.where(rivals.is_pressed, on_itself[..., 0], np.inf) - 2 * products[..., 0]
    best = square.argmin(axis=2)
    press, place = np.ogrid[: len(signals), : len(rivals.xy_mm)]
    square = square[press, place, best] + (signals**2).sum(axis=1)[:, None]
    products = products[press, place, best] - on_itself[place, best]
    # not beyond the lattice's next forces
    last = len(rivals.force_n) - 1
    low, high = (rivals.force_n[np.clip(best + by, 0, last)] for by in (-1, 1))
    force_of_best, per_n = rivals.force_n[best], per_n[place, best]
    change = np.clip(
        products[..., 1], per_n * (low - force_of_best), per_n * (high - force_of_best)
    )
    square += change**2 - 2 * change * products[..., 1]
    in_plane = products[..., 2:]
    across = np.sqrt(np.maximum(square - (in_plane**2).sum(axis=-1), 0.0))
    return _Optima(slopes.axes[place, best], slopes.per_mm[place, best], in_plane, across)


def _with_press_slopes(
    optima: _Optima,
    press_slopes: PlaceSlopes,
    away_mm: Float[np.ndarray, "press place 2"],
    step_mm: float,
) -> _Optima:
    """With each press's own slopes near it."""
    near = np.asarray((abs(away_mm) < _BESIDE * step_mm).all(axis=2))
    axes, per_mm = press_slopes.axes[:, None], press_slopes.per_mm[:, None]
    in_plane = -per_mm * _axis_components(axes, away_mm)
    return _Optima(
        np.where(near[..., None, None], axes, optima.axes),
        np.where(near[..., None], per_mm, optima.per_mm),
        np.where(near[..., None], in_plane, optima.in_plane),
        np.where(near, 0.0, optima.across),
    )


def _axis_components(
    axes: Float[np.ndarray, "press _ 2 2"], away_mm: Float[np.ndarray, "press place 2"]
) -> Float[np.ndarray, "press place 2"]:
    """Coordinates along the axes."""
    # written out: products of many small matrices are slow
    return axes[..., 0] * away_mm[..., :1] + axes[..., 1] * away_mm[..., 1:]
