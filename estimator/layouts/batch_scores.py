"""Scores of a batch of layouts over the contact locations of all pressed faces, with gradients."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.information.cross_face import LEAST_FALSE_FORCE_N
from estimator.information.scores import outermost_places
from estimator.information.two_contacts import PERCENT
from estimator.layouts.batch import Layouts
from estimator.layouts.cross_face import false_forces_n
from estimator.layouts.robustness import slip_places_mm, tolerance_places_mm
from estimator.layouts.scoring import LayoutScorer, percentile, place_information
from estimator.layouts.two_contacts import grasps_mm, pairs_all_mm, pairs_own_mm

_OfFaces = Callable[[Sequence[LayoutScorer], Sequence[Layouts]], Tensor]


@dataclass(frozen=True)
class _Pooled:
    """Percentile of something over the places (or pairs of places) of all pressed faces."""

    values: _OfFaces
    percent: float

    def score(
        self, scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
    ) -> Float[Tensor, "layout"]:
        values = self.values(scorers, layouts)
        if not values.shape[1]:
            return torch.full_like(layouts[0].magnet_mm[:, 0, 0], torch.nan)
        return percentile(values.sort(dim=1).values, self.percent)


def _each_face(values: Callable[[LayoutScorer, Layouts], Tensor]) -> _OfFaces:
    def pooled(scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]) -> Tensor:
        faces = [values(*pair).flatten(1) for pair in zip(scorers, layouts, strict=True)]
        return torch.cat(faces, dim=1)

    return pooled


def _false_forces_n(scorer: LayoutScorer, layouts: Layouts) -> Tensor:
    return false_forces_n(scorer, layouts).clamp(min=LEAST_FALSE_FORCE_N)


_DEARER = {
    "median_false_force_n": _Pooled(_each_face(_false_forces_n), 50.0),
    "percentile_95_false_force_n": _Pooled(_each_face(_false_forces_n), 95.0),
    "pair_own_position_bound_mm": _Pooled(_each_face(pairs_own_mm), PERCENT),
    "pair_all_position_bound_mm": _Pooled(_each_face(pairs_all_mm), PERCENT),
    "grasp_position_bound_mm": _Pooled(grasps_mm, PERCENT),
    "slip_place_mm": _Pooled(_each_face(slip_places_mm), 50.0),
    "tolerance_place_mm": _Pooled(_each_face(tolerance_places_mm), 50.0),
}
DEARER = tuple(_DEARER)
"""Scores that are worked out only where they are named: they cost as much as all others or more."""


def batch_scores(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts], named: Collection[str]
) -> dict[str, Float[Tensor, "layout"]]:
    """Scores over the places of all pressed faces, those of `DEARER` only where they are named.

    NaN where a score does not exist: pairs of tips that do not fit on a face, grasps without two
    opposite faces among those pressed.
    """
    places = [place_information(*pair) for pair in zip(scorers, layouts, strict=True)]
    position, force, sensitivity = (
        torch.cat([getattr(face, name) for face in places], dim=1)
        for name in ("position_bound_mm", "force_bound_n", "sensitivity")
    )
    ordered = sensitivity.sort(dim=1).values
    rest = torch.stack([face.resting_counts.abs().flatten(1).amax(dim=1) for face in places])
    found = {
        "worst_position_bound_mm": position.amax(dim=1),
        "median_position_bound_mm": percentile(position.sort(dim=1).values, 50.0),
        "worst_force_bound_n": force.amax(dim=1),
        "sensitivity_ratio": percentile(ordered, 5.0) / percentile(ordered, 50.0),
        "edge_position_bound_mm": _edge_mean(scorers, [face.position_bound_mm for face in places]),
        "largest_resting_counts": rest.amax(dim=0),
    }
    for name in _DEARER.keys() & set(named):
        found[name] = _DEARER[name].score(scorers, layouts)
    return found


def _edge_mean(
    scorers: Sequence[LayoutScorer], bounds_mm: Sequence[Float[Tensor, "layout _"]]
) -> Float[Tensor, "layout"]:
    found = [
        bound[:, torch.as_tensor(outermost_places(scorer.presses.places))]
        for scorer, bound in zip(scorers, bounds_mm, strict=True)
    ]
    return torch.cat(found, dim=1).mean(dim=1)
