"""Scores of a batch of layouts over the contact locations of all pressed faces, with gradients."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import torch
from jaxtyping import Float
from torch import Tensor

from design.spec.object import ObjectSpec
from design.spec.search import OVER_LIMIT
from estimator.information.cross_face import LEAST_FALSE_FORCE_N
from estimator.layouts.batch import Layouts
from estimator.layouts.bounds import percentile
from estimator.layouts.cross_face import CROSS_FACE_FORCE_N, false_forces_n
from estimator.layouts.scorer import LayoutScorer
from estimator.layouts.scoring import PlaceInformation, places_information


def all_faces(
    scorers: Sequence[LayoutScorer], values: Sequence[Float[Tensor, "layout _"]]
) -> Float[Tensor, "layout press"]:
    """Values of the pressed faces, as often as there are faces that they stand for."""
    return torch.cat(
        [v.repeat(1, scorer.faces) for scorer, v in zip(scorers, values, strict=True)], dim=1
    )


DEARER = ("median_false_force_n", "percentile_95_false_force_n")
"""Scores that are computed only where they are named: they cost as much as all others or more."""


def limits_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Least and greatest position bound (mm) that count: within the limit all are alike, and beyond the
    longest edge of the body nothing is known of the place."""
    limit = spec.limits.position_bound_mm
    return limit, max(limit, *spec.body.size_mm)


def batch_scores(
    scorers: Sequence[LayoutScorer],
    layouts: Sequence[Layouts],
    named: Collection[str],
) -> dict[str, Float[Tensor, "layout"]]:
    """Scores over the places of all pressed faces, those of `DEARER` only where they are named.

    Scorers of several forces: the geometric mean over them of the scores at each, so that every
    force counts alike; false forces from presses nearest to
    `CROSS_FACE_FORCE_N`, the largest counts and the ones that virtual objects keep to from those of the
    largest force.
    """
    places = places_information(scorers, layouts)
    forces = sorted({scorer.presses.force_n for scorer in scorers})
    of_cross_face = min(forces, key=lambda force: abs(force - CROSS_FACE_FORCE_N))
    each: list[dict[str, Tensor]] = []
    for force in forces:
        here = [k for k, scorer in enumerate(scorers) if scorer.presses.force_n == force]
        names = named if force == of_cross_face else ()
        each.append(
            scores_at_one_force(
                [scorers[k] for k in here],
                [layouts[k] for k in here],
                [places[k] for k in here],
                names,
            )
        )
    scores_of_batch = {}
    for name in each[forces.index(of_cross_face)]:
        values = torch.stack([scores[name] for scores in each if name in scores])
        scores_of_batch[name] = values[0] if len(values) == 1 else values.log().mean(dim=0).exp()
    for name in ("largest_counts", "kept_counts"):
        scores_of_batch[name] = torch.stack([getattr(face, name) for face in places]).amax(dim=0)
    return scores_of_batch


def position_bounds(
    scorers: Sequence[LayoutScorer], layouts: Sequence[Layouts]
) -> list[Float[Tensor, "layout _"]]:
    """Position bounds (mm) at the places of each scorer."""
    return [places.position_bound_mm for places in places_information(scorers, layouts)]


def scores_at_one_force(
    scorers: Sequence[LayoutScorer],
    layouts: Sequence[Layouts],
    places: Sequence[PlaceInformation],
    named: Collection[str],
) -> dict[str, Float[Tensor, "layout"]]:
    position, force, sensitivity = (
        all_faces(scorers, [getattr(face, name) for face in places])
        for name in ("position_bound_mm", "force_bound_n", "sensitivity")
    )
    least, most = limits_mm(scorers[0].spec)
    ordered, sorted_mm = sensitivity.sort(dim=1).values, position.sort(dim=1).values
    scores = {
        "worst_position_bound_mm": sorted_mm[:, -1],
        "percentile_99_position_bound_mm": percentile(sorted_mm, 99.0),
        "percentile_95_position_bound_mm": percentile(sorted_mm, 95.0),
        "median_position_bound_mm": percentile(sorted_mm, 50.0),
        OVER_LIMIT: (position.clamp(least, most) / least).log().mean(dim=1).exp(),
        "worst_force_bound_n": force.amax(dim=1),
        "sensitivity_ratio": percentile(ordered, 5.0) / percentile(ordered, 50.0),
    }
    if not any(scorer.presses.neighbours for scorer in scorers):
        # one sensed face: no press on another disturbs it, at no level of the search
        scores |= {
            name: torch.full_like(position[:, 0], torch.nan) for name in DEARER if name in named
        }
    elif {*DEARER} & {*named}:
        pairs = zip(scorers, layouts, strict=True)
        by_face = [false_forces_n(*pair).flatten(1) for pair in pairs]
        false_n = all_faces(scorers, by_face).clamp(min=LEAST_FALSE_FORCE_N).sort(dim=1).values
        scores |= {
            name: percentile(false_n, percent)
            for name, percent in zip(DEARER, (50.0, 95.0), strict=True)
            if name in named
        }
    return scores
