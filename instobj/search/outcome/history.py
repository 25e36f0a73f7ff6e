"""A search as arrays for figures: what was tried, and what random search does with as many scorings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from jaxtyping import Bool, Float

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, structure_of
from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from estimator.layouts.polish import LowestFidelity, judge, populations
from instobj.search.loop import is_feasible
from instobj.search.lowest_fidelity import StartScores, start_scores, structure_fidelity
from instobj.search.study import KeptStudy

_MOST_RANDOM = 8192
_CHUNK = 512


@dataclass(frozen=True)
class History:
    """Lowest-fidelity objectives of finished trials, in the order in which they were kept.

    Attributes
    ----------
    names : of the objectives
    values : their scores, in their own units; of feasible and other trials
    feasible : whether a trial keeps every limit
    start : the same scores of the specification as it was
    random : of feasible layouts of a random search, after `random_scorings` (one a row)
    scorings_per_trial : layouts scored for each trial, at most: a run that has converged ends
    """

    names: tuple[str, ...]
    values: Float[np.ndarray, "trial objective"]
    feasible: Bool[np.ndarray, "trial"]
    start: Float[np.ndarray, "objective"]
    random: Float[np.ndarray, "found objective"]
    random_scorings: Float[np.ndarray, "found"]
    scorings_per_trial: int


def search_history(space: SearchSpace, kept: KeptStudy) -> History:
    """Collect the trials, and score as many random layouts as the search did (8192 at most)."""
    names, finished = space.spec.search.objectives, kept.finished()
    start = start_scores(space.spec)
    free = sum(not v.choices for v in space.variables)
    scorings = 1 + (sum(populations(free, space.spec.search.polish_steps)) if free else 0)
    found, at = _random_search(space, start, min(scorings * len(finished), _MOST_RANDOM))
    return History(
        names,
        np.array([[trial.user_attrs["scores"][name] for name in names] for trial in finished]),
        np.array([is_feasible(trial) for trial in finished]),
        np.array([start.scores[name] for name in names]),
        found,
        at,
        scorings,
    )


def best_so_far(
    name: str, values: Float[np.ndarray, "n"], counted: Bool[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Best value among those counted up to each; NaN before the first."""
    worst = -np.inf if name in OBJECTIVES_TO_MAXIMIZE else np.inf
    run = np.maximum if name in OBJECTIVES_TO_MAXIMIZE else np.minimum
    found = run.accumulate(np.where(counted, values, worst))
    return np.where(np.isfinite(found), found, np.nan)


def _random_search(
    space: SearchSpace, start: StartScores, count: int
) -> tuple[Float[np.ndarray, "found objective"], Float[np.ndarray, "found"]]:
    """Scores of the feasible ones of `count` random layouts, of one structure a chunk."""
    rng, names = np.random.default_rng(space.spec.seed), space.spec.search.objectives
    flags = np.array([not v.choices for v in space.variables])
    by_structure: dict[Any, LowestFidelity] = {}
    found: list[np.ndarray] = [np.zeros((0, len(names)))]
    at: list[np.ndarray] = [np.zeros(0)]
    for first in range(0, count, _CHUNK):
        size = min(_CHUNK, count - first)
        units = rng.random((size, len(space.variables)))
        params = [params_at(space, unit) for unit in units]
        structure = structure_of(space, params[0])
        if structure not in by_structure:
            by_structure[structure] = structure_fidelity(space, params[0], start)
        lowest = by_structure[structure]
        fixed = dict(structure)
        poles = [polarities(lowest.space.structured, one | fixed) for one in params]
        with torch.no_grad():
            point = torch.as_tensor(units[:, flags], dtype=torch.float32)
            judged = judge(lowest, point, torch.tensor(poles), names)
        kept = (judged.broken_mm == 0).numpy()
        found.append(
            np.stack([judged.scores[name].double().numpy()[kept] for name in names], axis=1)
        )
        at.append(first + 1.0 + np.flatnonzero(kept))
    return np.concatenate(found), np.concatenate(at)
