"""Cost of what changes since the zero: bounds with each nuisance as unknown, over those without any."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.information.fisher import disturbance_counts, position_and_force_bounds
from estimator.information.scores import PlaceScores
from estimator.information.sensitivity import read_channels
from estimator.signals.live import live_jacobian
from estimator.signals.nuisances import nuisances
from estimator.signals.presses import Signals

EVERY = "all together"
"""Name of the cost of all nuisances at once."""


@dataclass(frozen=True)
class NuisanceCost:
    """Cost of one nuisance, or of all: medians over the judged locations, freshly zeroed.

    Attributes
    ----------
    name : of the nuisance, or `EVERY`
    deviation, unit : size of its unknowns before a frame is seen; None and "" of all
    position, force : median bound with it over that without any nuisance
    """

    name: str
    deviation: float | None
    unit: str
    position: float
    force: float


def nuisance_costs(
    spec: ObjectSpec, signals: Signals, scores: PlaceScores
) -> tuple[NuisanceCost, ...]:
    """Return what each nuisance of `limits.use` costs, then all; nothing where there is none.

    At the forces of the scores and from `score.channels`.
    """
    all_nuisances = nuisances(spec)
    if not all_nuisances:
        return ()
    slopes = [_slopes(spec, signals, scores, face) for face in scores.faces.tolist()]
    steady = _medians(spec, slopes, np.zeros((signals.baseline_counts.size, 0)))
    sets: list[tuple[str, float | None, str, Float[np.ndarray, "channel k"]]] = [
        (nuisance.name, nuisance.deviation, nuisance.unit, nuisance.columns)
        for nuisance in all_nuisances
    ]
    sets.append((EVERY, None, "", np.hstack([nuisance.columns for nuisance in all_nuisances])))
    return tuple(
        NuisanceCost(name, deviation, unit, *(_medians(spec, slopes, columns) / steady).tolist())
        for name, deviation, unit, columns in sets
    )


def _slopes(
    spec: ObjectSpec, signals: Signals, scores: PlaceScores, face: int
) -> Float[np.ndarray, "place channel 3"]:
    """Derivatives at the judged locations of a face, 0 of channels that are not read."""
    row = scores.faces.tolist().index(face)
    judged = scores.judged[row]
    x_mm, y_mm = scores.grid.xy_mm[judged].T
    force_n = scores.force_at_score_n[row, judged]
    jacobian = live_jacobian(spec, signals, np.full(len(x_mm), face), x_mm, y_mm, force_n)
    read = np.isin(np.arange(jacobian.shape[1]), read_channels(spec, signals, face))
    return jacobian * read[:, None]


def _medians(
    spec: ObjectSpec,
    slopes: list[Float[np.ndarray, "_ channel 3"]],
    columns: Float[np.ndarray, "channel k"],
) -> Float[np.ndarray, "2"]:
    """Medians of the position and the force bound over all faces."""
    sigma = disturbance_counts(spec.sensors, "fresh", len(columns))
    bounds = [
        np.stack(position_and_force_bounds(face_slopes, sigma, columns)) for face_slopes in slopes
    ]
    return np.median(np.concatenate(bounds, axis=1), axis=1)
