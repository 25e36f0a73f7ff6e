"""Bound of the place from the model against the scatter of repeated presses, place by place.

Noise is the scatter of repeats, pooled over all places (their covariance over all channels). The
model's bound is that of an unbiased estimate of x and y at a known travel (Cramér–Rao). Measured is
the scatter of the best linear reading of the repeats themselves, with slopes of the field from the
recorded neighbours of a place: the model takes no part in it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.stats import spearmanr

from estimator.calibration.known_travel.fit import Fitted
from estimator.calibration.known_travel.model import TravelModel
from estimator.recordings.formats.travel import TravelRecording

NEIGHBOURS_MM = 4.5
"""Places so near give the slopes, by a quadratic surface: 30 or so on a checkerboard of 1.4 mm."""
LEAST_NEIGHBOURS = 12
"""Neighbours from which slopes are fitted, at least: the quadratic surface has six terms."""
_ASIDE_MM = 0.1
"""Half the distance of the presses whose difference quotient is a slope."""
NULLS, _DRAWS = 1000, 20
"""Permutations that show a rank correlation by chance, and draws of scatters from the bound."""


@dataclass(frozen=True)
class BoundTest:
    """Predicted bound and measured scatter (mm, root of the sum over x and y) of every place.

    `null` are rank correlations of places exchanged: their 95 % point in size. `attainable` is the
    rank correlation that so few repeats would show if the bound were exactly right.
    """

    xy_mm: Float[np.ndarray, "place 2"]
    bound_mm: Float[np.ndarray, "place"]
    scatter_mm: Float[np.ndarray, "place"]
    slopes_bound_mm: Float[np.ndarray, "place"]
    rank_correlation: float
    slopes_rank_correlation: float
    size_ratio: float
    size_spread: float
    null: float
    attainable: float


def bound_test(
    model: TravelModel, fitted: Fitted, repeats: TravelRecording, seed: int = 0
) -> BoundTest:
    """Places with at least three repeats and enough neighbours on all sides."""
    places = np.unique(repeats.place_id)
    groups = [np.flatnonzero(repeats.place_id == place) for place in places]
    groups = [rows for rows in groups if len(rows) > 2]
    flat = repeats.field_mt.reshape(len(repeats), -1)
    flat = flat - drift_of_rounds(flat, groups, len(repeats))
    tip = np.array([repeats.tip_mm[rows].mean(axis=0) for rows in groups])
    level = np.array([flat[rows].mean(axis=0) for rows in groups])
    left = [flat[rows] - mean for rows, mean in zip(groups, level, strict=True)]
    spare = sum(len(rows) - 1 for rows in groups)
    precision = np.linalg.inv(sum(part.T @ part for part in left) / spare)
    xy, travel = fitted.twin.pose.locate_tips(tip)
    recorded = recorded_slopes(xy, level)
    predicted = _predicted_slopes(model, fitted, xy, travel)
    recorded[~model.covers(xy)] = np.nan
    inside = np.asarray(np.isfinite(recorded).all(axis=(1, 2)))
    predicted[~inside] = np.nan
    bound, of_slopes = (places_bound_mm(slopes, precision) for slopes in (predicted, recorded))
    scatter = np.array(
        [
            place_scatter_mm(slope, precision, part)
            for slope, part in zip(recorded, left, strict=True)
        ]
    )
    bound, of_slopes, scatter = bound[inside], of_slopes[inside], scatter[inside]
    ratio = np.log(scatter / bound)
    rng = np.random.default_rng((seed, 6))
    nulls = [_rank_correlation(rng.permutation(bound), scatter) for _ in range(NULLS)]
    return BoundTest(
        xy[inside],
        bound,
        scatter,
        of_slopes,
        _rank_correlation(bound, scatter),
        _rank_correlation(bound, of_slopes),
        float(np.exp(np.median(ratio))),
        float(np.exp(np.std(ratio))),
        float(np.quantile(np.abs(nulls), 0.95)),
        attainable_correlation(
            predicted[inside],
            precision,
            [len(g) for g, k in zip(groups, inside, strict=True) if k],
            rng,
        ),
    )


def attainable_correlation(
    slopes: np.ndarray, precision: np.ndarray, repeats: list[int], rng: np.random.Generator
) -> float:
    """Median rank correlation of the bound with scatters drawn from it."""
    # (Jᵀ P J)⁻¹: n place, c and d channels, i and j of (x, y)
    covariance = np.linalg.inv(np.einsum("nci,cd,ndj->nij", slopes, precision, slopes))
    bound = np.sqrt(np.trace(covariance, axis1=1, axis2=2))
    root, found = np.linalg.cholesky(covariance), []
    for _ in range(_DRAWS):
        drawn = [
            np.var(rng.standard_normal((count, 2)) @ one.T, axis=0, ddof=1).sum()
            for count, one in zip(repeats, root, strict=True)
        ]
        found.append(_rank_correlation(bound, np.array(drawn)))
    return float(np.median(found))


def recorded_slopes(
    xy_mm: Float[np.ndarray, "place 2"], level_mt: Float[np.ndarray, "place channel"]
) -> Float[np.ndarray, "place channel 2"]:
    """∂B/∂(x, y) by a quadratic surface through each place's neighbours, NaN at the border."""
    found = np.full((*level_mt.shape, 2), np.nan)
    for k, here in enumerate(xy_mm):
        offset = xy_mm - here
        near = np.linalg.norm(offset, axis=1) < NEIGHBOURS_MM
        surrounded = np.all(np.sign(offset[near]).min(axis=0) < 0) and np.all(
            np.sign(offset[near]).max(axis=0) > 0
        )
        if near.sum() < LEAST_NEIGHBOURS or not surrounded:
            continue
        x, y = offset[near].T
        terms = np.column_stack([np.ones(len(x)), x, y, x * x, x * y, y * y])
        found[k] = np.linalg.lstsq(terms, level_mt[near], rcond=None)[0][1:3].T
    return found


def drift_of_rounds(flat: np.ndarray, groups: list[np.ndarray], count: int) -> np.ndarray:
    """Change of the level from one round of repeats to the next: the mean over all places."""
    rounds = np.full(count, -1)
    for rows in groups:
        rounds[rows] = np.arange(len(rows))
    whole = flat.mean(axis=0)
    drift = np.zeros_like(flat)
    for number in range(rounds.max() + 1):
        drift[rounds == number] = flat[rounds == number].mean(axis=0) - whole
    return drift


def _predicted_slopes(
    model: TravelModel, fitted: Fitted, xy_mm: np.ndarray, travel_mm: np.ndarray
) -> Float[np.ndarray, "place channel 2"]:
    slopes = []
    for axis in np.eye(2):
        up, down = (
            model.change(fitted.twin, model.motion(xy_mm + sign * _ASIDE_MM * axis, travel_mm))
            for sign in (1, -1)
        )
        slopes.append((up - down).reshape(len(xy_mm), -1) / (2 * _ASIDE_MM))
    return np.stack(slopes, axis=-1)


def places_bound_mm(slopes: np.ndarray, precision: np.ndarray) -> Float[np.ndarray, "place"]:
    # Fisher information Jᵀ P J: n place, c and d channels, i and j of (x, y). The bound is √trace of its
    # inverse.
    information = np.einsum("nci,cd,ndj->nij", slopes, precision, slopes)
    return np.array(
        [
            np.sqrt(np.trace(np.linalg.inv(one))) if np.isfinite(one).all() else np.nan
            for one in information
        ]
    )


def place_scatter_mm(slope: np.ndarray, precision: np.ndarray, left: np.ndarray) -> float:
    """Root of the summed variances of x and y, read from the repeats of one place."""
    if not np.isfinite(slope).all():
        return np.nan
    reading = np.linalg.solve(slope.T @ precision @ slope, slope.T @ precision @ left.T)
    return float(np.sqrt(np.sum(reading**2) / (left.shape[0] - 1)))


def _rank_correlation(one: Float[np.ndarray, "place"], other: Float[np.ndarray, "place"]) -> float:
    """Spearman's."""
    return float(spearmanr(one, other).statistic)  # pyright: ignore[reportAttributeAccessIssue]
