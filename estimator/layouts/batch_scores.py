"""Scores of a batch of layouts over the contact locations of all pressed faces, with gradients."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.spec.object import ObjectSpec
from estimator.information.cross_face import LEAST_FALSE_FORCE_N
from estimator.information.scores import compliance_deviation, on_places
from estimator.information.two_contacts import PERCENT
from estimator.layouts.batch import Layouts
from estimator.layouts.bounds import percentile
from estimator.layouts.cross_face import CROSS_FACE_FORCE_N, false_forces_n
from estimator.layouts.robustness import slip_places_mm, tolerance_places_mm
from estimator.layouts.scorer import LayoutScorer
from estimator.layouts.scoring import PlaceInformation, places_information
from estimator.layouts.task_loss import expected_loss, press_loss
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
        pairs = zip(scorers, layouts, strict=True)
        return _all_faces(scorers, [values(*pair).flatten(1) for pair in pairs])

    return pooled


def _all_faces(
    scorers: Sequence[LayoutScorer], values: Sequence[Float[Tensor, "layout _"]]
) -> Float[Tensor, "layout press"]:
    """Values of the pressed faces, as often as there are faces that they stand for."""
    return torch.cat(
        [v.repeat(1, one.faces) for one, v in zip(scorers, values, strict=True)], dim=1
    )


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
_CROSS_FACE = ("median_false_force_n", "percentile_95_false_force_n")
OVER_START = "position_bound_over_start"
DEARER = tuple(_DEARER)
"""Scores that are worked out only where they are named: they cost as much as all others or more."""


@dataclass(frozen=True)
class PlaceBounds:
    """Position bounds (mm) of another layout, of each scorer at the places of all its faces.

    A batch is told by how much it exceeds them where it does so most (`worst_ratio` of `but`), and may
    have `most` of them there.
    """

    position_mm: tuple[Float[Tensor, "_ _"], ...]
    but: float
    most: float = 1.0


def batch_scores(
    scorers: Sequence[LayoutScorer],
    layouts: Sequence[Layouts],
    named: Collection[str],
    start: PlaceBounds | None = None,
) -> dict[str, Float[Tensor, "layout"]]:
    """Scores over the places of all pressed faces, those of `DEARER` only where they are named.

    Scorers of several forces: the geometric mean over them of the scores at each, so that every
    force counts alike, but for `task_loss`, which is the mean; false forces from presses nearest to
    `CROSS_FACE_FORCE_N`, the largest counts and those that virtual objects keep to from those of the
    largest force. With `start`, also
    `OVER_START`: the position bound over the start's, by `worst_ratio`.
    NaN where a score does not exist: pairs of tips that do not fit on a face, grasps without two
    opposite faces among those pressed.
    """
    places = places_information(scorers, layouts)
    forces = sorted({scorer.presses.force_n for scorer in scorers})
    of_cross_face = min(forces, key=lambda force: abs(force - CROSS_FACE_FORCE_N))
    each: list[dict[str, Tensor]] = []
    for force in forces:
        here = [k for k, scorer in enumerate(scorers) if scorer.presses.force_n == force]
        asked = {name for name in named if name not in _CROSS_FACE or force == of_cross_face}
        each.append(
            _scores_at_one_force(
                [scorers[k] for k in here],
                [layouts[k] for k in here],
                [places[k] for k in here],
                asked,
            )
        )
    losses = {force: scores.pop("task_loss") for force, scores in zip(forces, each, strict=True)}
    found = {"task_loss": expected_loss(scorers[0].spec.search.task, losses)}
    for name in each[forces.index(of_cross_face)]:
        values = torch.stack([scores[name] for scores in each if name in scores])
        found[name] = values[0] if len(values) == 1 else values.log().mean(dim=0).exp()
    for name in ("largest_counts", "kept_counts"):
        found[name] = torch.stack([getattr(face, name) for face in places]).amax(dim=0)
    if start is not None:
        found[OVER_START] = _over_start([face.position_bound_mm for face in places], start)
    return found


def position_bounds(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
) -> list[Float[Tensor, "layout _"]]:
    """Position bounds (mm) at the places of each scorer."""
    return [places.position_bound_mm for places in places_information(scorers, layouts)]


def _over_start(
    bounds_mm: Sequence[Float[Tensor, "layout _"]], start: PlaceBounds
) -> Float[Tensor, "layout"]:
    pairs = zip(bounds_mm, start.position_mm, strict=True)
    over = [(bound[:, None] / before).flatten(1) for bound, before in pairs]
    return worst_ratio(torch.cat(over, dim=1), start.but)


def worst_ratio(over_start: Float[Tensor, "layout press"], but: float) -> Float[Tensor, "layout"]:
    """Geometric mean over the worst presses, twice the share `but` of all, at least one.

    In their middle lies the ratio that all but that share keep. A mean has a smoother slope than
    one press that stands for all, and where the tail is long it is the stricter.
    """
    count = max(1, round(2 * but * over_start.shape[1]))
    return over_start.log().topk(min(count, over_start.shape[1]), dim=1).values.mean(dim=1).exp()


def _scores_at_one_force(
    scorers: Sequence[LayoutScorer],
    layouts: Sequence[Layouts],
    places: Sequence[PlaceInformation],
    named: Collection[str],
) -> dict[str, Float[Tensor, "layout"]]:
    position, force, sensitivity = (
        _all_faces(scorers, [getattr(face, name) for face in places])
        for name in ("position_bound_mm", "force_bound_n", "sensitivity")
    )
    force_n = scorers[0].presses.force_n
    ordered, sorted_mm = sensitivity.sort(dim=1).values, position.sort(dim=1).values
    found = {
        "worst_position_bound_mm": sorted_mm[:, -1],
        "percentile_99_position_bound_mm": percentile(sorted_mm, 99.0),
        "percentile_95_position_bound_mm": percentile(sorted_mm, 95.0),
        "median_position_bound_mm": percentile(sorted_mm, 50.0),
        "worst_force_bound_n": force.amax(dim=1),
        "sensitivity_ratio": percentile(ordered, 5.0) / percentile(ordered, 50.0),
        "task_loss": press_loss(scorers[0].spec.search.task, force_n, position, force).mean(dim=1),
        "edge_position_bound_mm": _edge_mean(scorers, [face.position_bound_mm for face in places]),
    }
    for name in _DEARER.keys() & set(named):
        found[name] = _DEARER[name].score(scorers, layouts)
    return found


def _edge_mean(
    scorers: Sequence[LayoutScorer], bounds_mm: Sequence[Float[Tensor, "layout _"]]
) -> Float[Tensor, "layout"]:
    found = [
        bound[:, scorer.presses.outermost] for scorer, bound in zip(scorers, bounds_mm, strict=True)
    ]
    return _all_faces(scorers, found).mean(dim=1)


def unevenness(spec: ObjectSpec, scorers: Sequence[LayoutScorer]) -> float:
    """Deviation of compliance from what the search wants, at the force nearest to `score.force_n`."""
    forces = {scorer.presses.force_n for scorer in scorers}
    nearest = min(forces, key=lambda force: abs(force - spec.score.force_n))
    at_it = [scorer.presses for scorer in scorers if scorer.presses.force_n == nearest]
    there = np.stack([presses.there for presses in at_it])
    compliance = on_places(there, [presses.mm_per_n for presses in at_it])
    wanted = spec.search.compliance_mm_per_n
    return compliance_deviation(wanted, at_it[0].places, compliance, there)
