"""Weak areas of any body: how the position bound goes with a location's place on it.

Measures of a contact location follow from the specification alone (`design.layout.places.measures`):
distances to the border of its patch and to the nearest magnet, the signal's path over a magnet to a
sensor, and the surface's curvature. A table of their thirds and rank correlations says which of them
an object's weak locations go with.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.contact_places import face_rows
from design.layout.places.measures import (
    LONGEST_PATH_MM,
    MEASURES,
    Measure,
    PlaceMeasures,
    place_measures,
)
from design.spec.object import ObjectSpec
from design.tables import write_table
from estimator.information.scores import PlaceScores

_DIGITS = 5
"""Decimals of a measure to which locations count as different."""


@dataclass(frozen=True)
class Third:
    """The locations with the smallest, middle or largest values of a measure; equal values stay
    together, so that thirds may be uneven, or two.

    `bound_mm` is the 95th percentile of their position bounds (fresh baseline): medians hide what is
    weak. Of the paper's cube only the middles of edges are, a third of its edges.
    """

    measure: Measure
    low: float
    high: float
    places: int
    bound_mm: float


@dataclass(frozen=True)
class WeakAreas:
    """Properties that weak locations have in common.

    `rank_correlation` is Spearman's, of the position bound with each measure that varies over the
    object: above 0, larger is weaker. `thirds` holds the same measures. `weakest_tenth` holds, for
    each, the median over the weakest tenth of the locations.
    """

    measures: PlaceMeasures
    rank_correlation: dict[Measure, float]
    thirds: tuple[Third, ...]
    weakest_tenth: dict[Measure, float]

    @property
    def told_by(self) -> Measure | None:
        """The measure that orders the locations most like their bounds do; None where none varies."""
        order = self.rank_correlation
        return max(order, key=lambda name: abs(order[name])) if order else None

    @property
    def exceeds_rule(self) -> float:
        """Share of the locations whose signal path is longer than the design rule's."""
        path = self.measures.path_mm
        return float(np.mean(path[np.isfinite(path)] > LONGEST_PATH_MM))

    @property
    def edge_ratio(self) -> float:
        """Bound that 95 % of the locations keep in the third nearest the border, over that of the innermost.

        NaN where all locations lie equally far from the border.
        """
        bounds = [third.bound_mm for third in self.thirds if third.measure == "border_mm"]
        return bounds[0] / bounds[-1] if bounds else float("nan")

    @property
    def edge_paths_mm(self) -> tuple[float, float]:
        """Median signal path (mm) of the outer and of the inner third; NaN as `edge_ratio`."""
        thirds = [third for third in self.thirds if third.measure == "border_mm"]
        if not thirds:
            return float("nan"), float("nan")
        border, path = self.measures.border_mm, self.measures.path_mm
        # A location lies in a third where its distance does, within the rounding of equal values.
        least, most = thirds[0].high + 10.0**-_DIGITS, thirds[-1].low - 10.0**-_DIGITS
        return float(np.nanmedian(path[border <= least])), float(np.nanmedian(path[border >= most]))


def weak_areas(spec: ObjectSpec, scores: PlaceScores) -> WeakAreas:
    """Return which measures the position bounds of an object (fresh baseline) go with."""
    from scipy.stats import rankdata

    rows, judged = face_rows(spec, scores.faces), scores.judged
    measures = place_measures(spec)
    measures = PlaceMeasures(*(getattr(measures, name)[rows] for name in MEASURES))
    bound = scores.position_bound_mm[judged]
    weakest = bound >= np.quantile(bound, 0.9, method="lower")
    correlation: dict[Measure, float] = {}
    thirds: list[Third] = []
    tenth: dict[Measure, float] = {}
    for name in MEASURES:
        value = getattr(measures, name)[judged]
        if len(np.unique(value.round(_DIGITS))) < 2:
            continue
        # Spearman's correlation: Pearson's of the ranks; equal bounds have none, and count as 0
        correlation[name] = 0.0
        if len(np.unique(bound)) > 1:
            ranks = np.corrcoef(rankdata(bound), rankdata(value.round(_DIGITS)))
            correlation[name] = float(ranks[0, 1])
        tenth[name] = float(np.median(value[weakest]))
        for some in thirds_of(value):
            limits = float(value[some].min()), float(value[some].max())
            thirds.append(Third(name, *limits, int(some.sum()), bound_of_most(bound[some])))
    return WeakAreas(measures, correlation, tuple(thirds), tenth)


def bound_of_most(bound_mm: Float[np.ndarray, "n"]) -> float:
    """Return the bound (mm) that 95 % of the locations keep."""
    # "lower" picks a bound that exists: nothing between a finite and an infinite one
    return float(np.quantile(bound_mm, 0.95, method="lower"))


def thirds_of(value: Float[np.ndarray, "n"]) -> list[Bool[np.ndarray, "n"]]:
    """Return which locations have its smallest, middle and largest values; equal ones stay together."""
    levels, counts = np.unique(value.round(_DIGITS), return_counts=True)
    cuts = levels[1:]
    if len(levels) > 3:
        below = np.cumsum(counts)[:-1] / len(value)
        cuts = cuts[np.unique([abs(below - share).argmin() for share in (1 / 3, 2 / 3)])]
    group = np.searchsorted(cuts, value.round(_DIGITS), side="right")
    return [some for some in (group == number for number in range(3)) if some.any()]


def save_weak_areas_csv(areas: WeakAreas, scores: PlaceScores, path: Path | str) -> None:
    """One row for every face and location that it has; `over_median` is the bound over the median's."""
    bound, is_place = scores.position_bound_mm, scores.places
    ratio, xy = bound / np.median(bound[scores.judged]), scores.grid.xy_mm
    header = ["face", "place", "x_mm", "y_mm", *MEASURES, "position_bound_mm", "over_median"]
    rows = (
        [
            scores.faces[row],
            place,
            *xy[place].tolist(),
            *(repr(float(getattr(areas.measures, name)[row, place])) for name in MEASURES),
            repr(float(bound[row, place])),
            repr(float(ratio[row, place])),
        ]
        for row, place in np.argwhere(is_place).tolist()
    )
    write_table(Path(path), header, rows)
