"""One score of a layout on three fidelity levels, and how well one level predicts the next.

1. `lowest_fidelity_score`: magnets rigid, holding each other in first reflection, on stored presses, signals
   linear in their motions; a fraction of a millisecond a layout in batches (`estimator.layouts.scoring`).
2. `second_fidelity_score`: rigid magnets tied to the magnet-free mesh through its one factorization, contact
   and fields in full; about a minute of one core a layout. It wants the default mesh: ties on edges of
   5 mm (18 functionals) gave the worst bound of a layout with deep magnets as 1.18 instead of
   0.55 mm.
3. `score_signals` on the chain's own signals: mesh that resolves the magnets, everything else as on
   the second fidelity level; minutes per layout (`instobj.search.fidelity` runs the stages).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np
import torch
from jaxtyping import Float

from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from design.spec.search import OVER_LIMIT
from estimator.information.cross_face import LEAST_FALSE_FORCE_N, cross_face_disturbance
from estimator.information.scores import score_places
from estimator.layouts.batch import layouts_of
from estimator.layouts.batch_scores import (
    DEARER,
    batch_scores,
    limits_mm,
    position_bounds,
)
from estimator.layouts.cross_face import CROSS_FACE_FORCE_N
from estimator.layouts.scorer import LayoutScorer
from estimator.signals.hall import full_scale_counts
from estimator.signals.presses import Signals, press_signals, saturation_margin
from estimator.tolerances.saturation import saturation
from fem.candidates.tied_magnets import DEGREE, rigid_magnet_response
from fem.linear.factorization import Factorization
from fem.linear.response import ElasticSystem, ResponseOperator
from fem.presses.results import MagnetMotions, PressForces
from fem.presses.table import simulate_lattice


@dataclass(frozen=True)
class FidelityScore:
    """Scores by which a layout is judged, the same at every level.

    Attributes
    ----------
    worst_position_bound_mm, percentile_99_position_bound_mm, percentile_95_position_bound_mm,
    median_position_bound_mm, worst_force_bound_n : Cramér–Rao bounds over the contact locations of
        all faces; at every one of `spec.scoring_forces_n`, then the geometric mean of
        these, so that every force counts alike
    median_false_force_n, percentile_95_false_force_n : force that a face reads on itself, by its own
        channels alone, from presses of 10 N on an adjacent face; over pairs of faces and places, at
        least `LEAST_FALSE_FORCE_N`
    sensitivity_ratio : 5th over 50th percentile of δ over the places of all faces
    saturation_margin : share of the sensors' range that stays free, at rest and in the deepest press
    objects_margin : the same in 95 % of virtual objects (`estimator.tolerances.saturation`)
    position_over_limit : position bound over `limits.position_bound_mm`, geometric mean over forces and
        locations; 1 where it is within the limit, and no more than where nothing is known of the place
    position_bounds_mm : position bound of every force, face and location that the face has, in
        this order

    Other scores of presses are geometric means over the forces like the bounds; false forces are of
    10 N whatever the forces.
    """

    worst_position_bound_mm: float
    percentile_99_position_bound_mm: float
    percentile_95_position_bound_mm: float
    median_position_bound_mm: float
    position_over_limit: float
    worst_force_bound_n: float
    median_false_force_n: float
    percentile_95_false_force_n: float
    sensitivity_ratio: float
    saturation_margin: float
    objects_margin: float
    position_bounds_mm: tuple[float, ...] = field(repr=False)


SCORE_NAMES = tuple(f.name for f in fields(FidelityScore) if f.name != "position_bounds_mm")
MARGINS = ("saturation_margin", "objects_margin")
"""They may be negative."""


def lowest_fidelity_score(spec: ObjectSpec, scorers: Sequence[LayoutScorer]) -> FidelityScore:
    """Score on stored presses, with a scorer for each face that counts.

    `estimator.layouts.scoring` says what is left out. Of 34 layouts of the paper's cube the second
    level had 0.94 to 1.22 times the median position bound and 0.87 to 1.67 times the worst one.
    """
    layouts = [
        layouts_of(spec, scorer.presses.face, scorer.presses.first_mm.dtype) for scorer in scorers
    ]
    with torch.no_grad():
        scores = batch_scores(scorers, layouts, DEARER)
    mean_scores = {name: float(values) for name, values in scores.items()}
    range_counts = full_scale_counts(spec.sensors)
    margins = {
        margin: 1 - mean_scores.pop(name) / range_counts
        for margin, name in zip(MARGINS, ("largest_counts", "kept_counts"), strict=True)
    }
    return FidelityScore(
        **mean_scores,
        position_bounds_mm=_flat(position_bounds(scorers, layouts)),
        **margins,
    )


def second_fidelity_score(
    spec: ObjectSpec,
    system: ElasticSystem,
    factor: Factorization,
    plain: ResponseOperator,
    degree: int = DEGREE,
) -> FidelityScore:
    """Score with rigid magnets tied to the magnet-free mesh; arguments as `rigid_magnet_response`.

    Raises
    ------
    InputError
        A magnet outside the silicone, a sensor in a magnet, or one that saturates at rest.
    """
    response = rigid_magnet_response(spec, system, factor, plain, degree)
    forces, motions = simulate_lattice(spec, response)
    return score_signals(spec, press_signals(spec, forces, motions), forces, motions)


def score_signals(
    spec: ObjectSpec, signals: Signals, forces: PressForces, motions: MagnetMotions
) -> FidelityScore:
    """Score simulated signals and the presses behind them: of the second fidelity level or the chain.

    Raises
    ------
    InputError
        Signals that cannot be scored (`score_places`).
    """
    each = [
        _score_at_force(spec.changed(score=spec.score.changed(force_n=force)), signals)
        for force in spec.scoring_forces_n
    ]
    places = [scores.pop("places") for scores in each]
    means = {
        name: float(np.exp(np.mean([np.log(scores[name]) for scores in each]))) for name in each[0]
    }
    return FidelityScore(
        **means,
        **_false_forces(spec, signals),
        saturation_margin=saturation_margin(signals, spec),
        objects_margin=saturation(spec, signals, motions, deepest_alone=True).margin[-1],
        position_bounds_mm=_flat(scored.position_bound_mm[scored.places] for scored in places),
    )


def _score_at_force(spec: ObjectSpec, signals: Signals) -> dict[str, Any]:
    """Scores of presses to `score.force_n`."""
    scores = score_places(spec, signals)
    judged = scores.judged
    bound = scores.position_bound_mm[judged]
    low, middle = np.percentile(scores.delta_raw[judged], [5.0, 50.0])
    return {
        "worst_position_bound_mm": float(bound.max()),
        "percentile_99_position_bound_mm": float(np.percentile(bound, 99.0)),
        "percentile_95_position_bound_mm": float(np.percentile(bound, 95.0)),
        "median_position_bound_mm": float(np.median(bound)),
        OVER_LIMIT: excess_over_limit(spec, bound),
        "worst_force_bound_n": float(scores.force_bound_n[judged].max()),
        "sensitivity_ratio": float(low / middle),
        "places": scores,
    }


def bounds_by_press(
    spec: ObjectSpec, score: FidelityScore
) -> dict[tuple[float, int], Float[np.ndarray, "place"]]:
    """Position bounds (mm) of the locations that a face has, by force and face."""
    counts = contact_places(spec).sum(axis=1).tolist()
    keys = [(force, face) for force in spec.scoring_forces_n for face in spec.body.sensed]
    ends = np.cumsum(counts * len(spec.scoring_forces_n))[:-1]
    return dict(zip(keys, np.split(np.array(score.position_bounds_mm), ends), strict=True))


def excess_over_limit(spec: ObjectSpec, bounds_mm: Float[np.ndarray, "*press"]) -> Any:
    """`FidelityScore.position_over_limit` of bounds at one force, over the last axis; NaN is left out."""
    least, most = limits_mm(spec)
    return np.exp(np.nanmean(np.log(np.clip(bounds_mm, least, most) / least), axis=-1))


def regressed_share(start: FidelityScore, score: FidelityScore, limit_mm: float = 0.0) -> float:
    """Share of (force, face, location) whose position bound is larger than the start's and than a limit, of
    those where both reach the force."""
    start_bounds, bounds = np.array(start.position_bounds_mm), np.array(score.position_bounds_mm)
    both = ~np.isnan(start_bounds + bounds)
    return float(np.mean(bounds[both] > np.maximum(start_bounds[both], limit_mm)))


def _flat(bounds_mm: Iterable[Any]) -> tuple[float, ...]:
    """Arrays of one force after the other, as one list of numbers that JSON keeps."""
    return tuple(np.concatenate([np.ravel(bounds) for bounds in bounds_mm]).tolist())


def _false_forces(spec: ObjectSpec, signals: Signals) -> dict[str, float]:
    cross = cross_face_disturbance(spec, signals, CROSS_FACE_FORCE_N).summary("adjacent")
    names = ("median_false_force_n", "percentile_95_false_force_n")
    forces = {name: np.maximum(cross.get(name, np.nan), LEAST_FALSE_FORCE_N) for name in names}
    return {name: float(force_n) for name, force_n in forces.items()}
