"""The higher fidelity levels of a layout search on the chain's stages: what they need, run and stored."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from design.spec.search import OVER_LIMIT
from estimator.layouts.fidelity import FidelityScore, excess_over_limit, score_signals
from instobj.stages.run import Run
from instobj.store.readers import PRESSES, SECOND_FIDELITY, SIGNALS

TWINS = 20


def second_score(spec: ObjectSpec) -> FidelityScore:
    """Second fidelity level: rigid magnets on the magnet-free shell, stored and reused."""
    return score_of(Run(spec).read(SECOND_FIDELITY))


def score_of(content: dict[str, Any]) -> FidelityScore:
    """Score that JSON kept, whose bounds came back as a list."""
    score = FidelityScore(**content)
    return replace(score, position_bounds_mm=tuple(score.position_bounds_mm))


def chain_score(spec: ObjectSpec) -> FidelityScore:
    """Highest fidelity level: the score of the chain's own signals, its stages stored and reused."""
    run = Run(spec)
    return score_signals(spec, run.read(SIGNALS), *run.read(PRESSES))


def chain_seconds(spec: ObjectSpec) -> float:
    """Return what the chain's stages up to the signals took when they were made, which they are where they
    are not stored."""
    run = Run(spec)
    run.require(SIGNALS.stage)
    return sum(result.seconds for result in run.results.values())


def second_seconds(spec: ObjectSpec) -> float:
    """Return what the second fidelity level took, of the same kind."""
    return Run(spec).require(SECOND_FIDELITY.stage).seconds


@dataclass(frozen=True)
class TwinRatio:
    """Ratio of the start's bound to a layout's: of the designs, and between twins.

    `low`, `high` hold 95 % of the ratios between any twin of the start and any of the layout.
    """

    design: float
    low: float
    high: float


Bounds = dict[str, Float[np.ndarray, "object press"]]


def twin_ratios(start: ObjectSpec, old: list[Bounds], new: list[Bounds]) -> dict[str, TwinRatio]:
    """Bounds of toleranced twins of the start over those of a layout, each of `bounds_of_twins`.

    Twins share their design's mechanics; `tolerances` of each specification sizes their errors.
    Geometric means over the judged forces. Places that do not reach a force are left out;
    places that reach it only near the deepest press are judged at less, of both alike
    (`estimator.tolerances.budget`).
    """
    start_summary, layout_summary = (_summaries(start, bounds) for bounds in (old, new))
    return {
        name: TwinRatio(
            float(start_summary[name][0] / layout_summary[name][0]),
            *_interval(start_summary[name][1:, None] / layout_summary[name][1:]),
        )
        for name in start_summary
    }


def bounds_of_twins(spec: ObjectSpec) -> list[Bounds]:
    """Bounds of the design, then of its twins, at each judged force."""
    from estimator.tolerances.budget import twin_bounds

    presses = Run(spec).read(PRESSES)
    return [
        twin_bounds(spec.changed(score=spec.score.changed(force_n=force_n)), *presses, TWINS)
        for force_n in spec.scoring_forces_n
    ]


def _summaries(spec: ObjectSpec, bounds: list[Bounds]) -> dict[str, Float[np.ndarray, "object"]]:
    each = []
    for at_force in bounds:
        position, force = at_force["position_mm"], at_force["force_n"]
        each.append(
            {
                "worst_position_bound_mm": np.nanmax(position, axis=1),
                "percentile_99_position_bound_mm": np.nanpercentile(position, 99, axis=1),
                "percentile_95_position_bound_mm": np.nanpercentile(position, 95, axis=1),
                "median_position_bound_mm": np.nanmedian(position, axis=1),
                OVER_LIMIT: excess_over_limit(spec, position),
                "worst_force_bound_n": np.nanmax(force, axis=1),
            }
        )
    return {
        name: np.exp(np.mean([np.log(summary[name]) for summary in each], axis=0))
        for name in each[0]
    }


def _interval(ratios: Float[np.ndarray, "before after"]) -> tuple[float, float]:
    low, high = np.quantile(ratios, [0.025, 0.975])
    return float(low), float(high)


def score_row(score: FidelityScore) -> dict[str, Any]:
    """A score with the names and units that tables show."""
    return {
        "worst place mm": score.worst_position_bound_mm,
        "99 % place mm": score.percentile_99_position_bound_mm,
        "95 % place mm": score.percentile_95_position_bound_mm,
        "median place mm": score.median_position_bound_mm,
        "place over limit": score.position_over_limit,
        "worst force N": score.worst_force_bound_n,
        "false N": score.median_false_force_n,
        "false N, 95 %": score.percentile_95_false_force_n,
        "δ 5/50 %": score.sensitivity_ratio,
        "free range": score.saturation_margin,
        "free in 95 % of objects": score.objects_margin,
    }
