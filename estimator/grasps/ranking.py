"""Rankings of grippers from repeated grasps: medians, intervals, tests, and grasps still needed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import combinations
from math import ceil
from typing import Any

import numpy as np
from jaxtyping import Float
from scipy.stats import mannwhitneyu, norm, wilcoxon

LEVEL = 0.05
"""Chance of a difference as large without one, below which a ranking counts as sure."""
POWER = 0.8
"""Chance with which further grasps shall make a ranking sure."""
RESAMPLED = 4000
"""Draws of a bootstrap."""
_MOST_GRASPS = 10_000
"""More grasps than this are said as "more than"."""


def median_interval(values: Float[np.ndarray, "grasp"]) -> tuple[float, float, float]:
    """Median, and the ends of its 95 % interval by the percentile bootstrap over grasps (Efron &
    Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13).

    With fewer than six grasps it is too narrow. ∞ counts, NaN does not. NaN without grasps, and ends with
    one.
    """
    finite = values[~np.isnan(values)]
    if not len(finite):
        return float("nan"), float("nan"), float("nan")
    if len(finite) == 1:
        return float(finite[0]), float("nan"), float("nan")
    drawn = np.random.default_rng(0).choice(finite, (RESAMPLED, len(finite)))
    low, high = np.percentile(np.median(drawn, axis=1), [2.5, 97.5], method="nearest")
    return float(np.median(finite)), float(low), float(high)


@dataclass(frozen=True)
class Difference:
    """One gripper against another.

    Attributes
    ----------
    shift : median difference second − first, of pairs where paired
    low, high : its 95 % interval by bootstrap
    p_value : two-sided, of Wilcoxon's signed ranks where paired, else of Mann and Whitney; after
        Holm's correction where several pairs are compared
    larger : share of grasps (pairs) in which the second is larger; ties count half
    more_grasps : further grasps of each until the ranking is sure with 80 % probability; 0 where it
        is, None where there is no difference to see
    """

    first: str
    second: str
    paired: bool
    shift: float
    low: float
    high: float
    p_value: float
    larger: float
    more_grasps: int | None

    @property
    def sure(self) -> bool:
        """Return whether the order is significant."""
        return self.p_value < LEVEL


def compare(groups: Mapping[str, Float[np.ndarray, "_"]], paired: bool = False) -> list[Difference]:
    """Compare every two groups; grasps count as independent of each other.

    `paired` groups have their grasps in the same order. p values are Holm's (Scand. J. Statist. 6, 1979).
    """
    pairs = list(combinations(groups, 2))
    raw = [_p_value(groups[a], groups[b], paired) for a, b in pairs]
    corrected = _holm(raw)
    return [
        _difference(a, b, groups[a], groups[b], paired, p)
        for (a, b), p in zip(pairs, corrected, strict=True)
    ]


def _difference(
    first: str, second: str, a: np.ndarray, b: np.ndarray, paired: bool, p_value: float
) -> Difference:
    a, b = _known(a, b, paired)
    larger = share_larger(a, b, paired)
    rng = np.random.default_rng(0)
    if not len(a) or not len(b):
        shift = low = high = float("nan")
    elif paired:
        shift, low, high = median_interval(b - a)
    else:
        drawn = [np.median(rng.choice(x, (RESAMPLED, len(x))), axis=1) for x in (a, b)]
        shift = float(np.median(b) - np.median(a))
        low, high = (float(end) for end in np.percentile(drawn[1] - drawn[0], [2.5, 97.5]))
    fewest = min(len(a), len(b))
    needed = 0 if p_value < LEVEL else grasps_needed(larger, paired)
    more = None if needed is None else max(0 if p_value < LEVEL else 1, needed - fewest)
    return Difference(
        first, second, paired, shift, low, high, p_value, larger, 0 if p_value < LEVEL else more
    )


def _known(a: np.ndarray, b: np.ndarray, paired: bool) -> tuple[np.ndarray, np.ndarray]:
    if paired:
        both = np.isfinite(a) & np.isfinite(b)
        return a[both], b[both]
    return a[~np.isnan(a)], b[~np.isnan(b)]


def _p_value(a: np.ndarray, b: np.ndarray, paired: bool) -> float:
    """1 where too few grasps, or none that differ, say nothing."""
    a, b = _known(a, b, paired)
    if min(len(a), len(b)) < 2 or len(np.unique(np.concatenate([a, b]))) < 2:
        return 1.0
    if not paired:
        return float(mannwhitneyu(a, b)[1])
    if np.all(a == b):
        return 1.0
    outcome: Any = wilcoxon(a, b)
    return float(outcome.pvalue)


def share_larger(a: Float[np.ndarray, "_"], b: Float[np.ndarray, "_"], paired: bool) -> float:
    """Share of pairs in which b is larger than a; ties count half. NaN without grasps."""
    if not len(a) or not len(b):
        return float("nan")
    against = b if paired else b[:, None]
    return float(np.mean((against > a) + 0.5 * (against == a)))


def _holm(p_values: list[float]) -> list[float]:
    corrected, largest = [1.0] * len(p_values), 0.0
    for rank, index in enumerate(np.argsort(p_values).tolist()):
        largest = max(largest, min(1.0, (len(p_values) - rank) * p_values[index]))
        corrected[index] = largest
    return corrected


def grasps_needed(larger: float, paired: bool) -> int | None:
    """Grasps of each gripper that make the ranking sure with 80 % probability; None for no difference.

    Noether, Sample size determination for some common nonparametric tests, JASA 82, 1987: per group
    (z₁ + z₂)²/(6 (p − ½)²) for rank sums, pairs (z₁ + z₂)²/(4 (p − ½)²) for signs; the signed ranks that
    pairs are tested by need no more. p is taken as seen, so that the number is itself uncertain.
    """
    away = abs(larger - 0.5)
    if not away > 0:
        return None
    quantiles = norm.ppf(1 - LEVEL / 2) + norm.ppf(POWER)
    return min(_MOST_GRASPS, ceil(quantiles**2 / ((4 if paired else 6) * away**2)))


def exchanged_share(
    groups: Mapping[str, Float[np.ndarray, "_"]],
    paired: bool = False,
    draws: int = 1000,
) -> float:
    """Share of draws in which groups with labels exchanged at random are ranked surely: at most about
    `LEVEL` where the test is honest."""
    rng, names = np.random.default_rng(0), list(groups)
    sizes = np.cumsum([len(groups[name]) for name in names])[:-1]
    ranked = 0
    for _ in range(draws):
        if paired:
            table = np.stack([groups[name] for name in names], axis=1)
            parts = list(rng.permuted(table, axis=1).T)
        else:
            parts = np.split(rng.permutation(np.concatenate(list(groups.values()))), sizes)
        pairs = combinations(parts, 2)
        ranked += min(_holm([_p_value(a, b, paired) for a, b in pairs])) < LEVEL
    return ranked / draws
