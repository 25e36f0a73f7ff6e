"""A search as arrays for figures: objectives of every trial, and which of them are best."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from design.search.space import SearchSpace
from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from instobj.search.trials import KeptTrials


@dataclass(frozen=True)
class History:
    """Lowest-fidelity objectives of finished trials, in the order in which they were kept.

    Attributes
    ----------
    names : of the objectives
    values : their scores, in their own units; of feasible and other trials
    feasible : whether a trial keeps every limit
    start : the same scores of the specification as it was
    scorings : layouts scored until a trial was kept, its own included
    """

    names: tuple[str, ...]
    values: Float[np.ndarray, "trial objective"]
    feasible: Bool[np.ndarray, "trial"]
    start: Float[np.ndarray, "objective"]
    scorings: Int[np.ndarray, "trial"]


def search_history(space: SearchSpace, kept: KeptTrials) -> History:
    """Collect the objectives of all finished trials, and those of the start."""
    names, finished = space.spec.search.objectives, kept.finished
    start = finished[0].start_scores  # the same in all
    return History(
        names,
        np.array([[trial.scores[name] for name in names] for trial in finished]),
        np.array([trial.feasible for trial in finished]),
        np.array([start[name] for name in names]),
        np.cumsum([trial.scorings for trial in finished]),
    )


def best_so_far(
    name: str, values: Float[np.ndarray, "n"], counted: Bool[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Best value among those counted up to each; NaN before the first."""
    worst = -np.inf if name in OBJECTIVES_TO_MAXIMIZE else np.inf
    run = np.maximum if name in OBJECTIVES_TO_MAXIMIZE else np.minimum
    best = run.accumulate(np.where(counted, values, worst))
    return np.where(np.isfinite(best), best, np.nan)


def front_rows(history: History) -> list[int]:
    """Return feasible trials that none beats in both of the first two objectives, by the first."""
    if len(history.names) < 2:
        return []
    # objectives to maximise change their sign: less is better in both columns
    sign = np.array([-1.0 if name in OBJECTIVES_TO_MAXIMIZE else 1.0 for name in history.names[:2]])
    feasible = np.flatnonzero(history.feasible)
    front = feasible[pareto_front(sign * history.values[feasible, :2])]
    return front[np.argsort(history.values[front, 0])].tolist()


def pareto_front(values: Float[np.ndarray, "n 2"]) -> Bool[np.ndarray, "n"]:
    """Return the trials than which no other is better or equal in both (and better in one)."""
    no_worse = np.all(values[None] <= values[:, None], axis=2)
    better = np.any(values[None] < values[:, None], axis=2)
    return ~np.any(no_worse & better, axis=1)
