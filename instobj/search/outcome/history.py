"""A search as arrays for figures: what was tried, and what plain engines find with as many scorings."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from cmaes import CMA
from jaxtyping import Bool, Float, Int

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, structure_of
from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from estimator.field.device import one_thread
from estimator.layouts.polish import Judged, LowestFidelity, judge
from instobj.search.lowest_fidelity import StartScores, start_scores, structure_fidelity
from instobj.search.trials import KeptTrials

MOST_SCORINGS = 33_600
"""Layouts that plain engines score, minutes at three forces."""
_CHUNK = 512
_SPREAD = 0.3
"""Standard deviation of a first generation of plain CMA-ES, of the unit cube."""


@dataclass(frozen=True)
class Peer:
    """Result of a plain engine: the first objective (in its own unit) of the layouts within all limits,
    each after a number of `scorings`; `scored` in all."""

    name: str
    values: Float[np.ndarray, "found"]
    scorings: Float[np.ndarray, "found"]
    scored: int


@dataclass(frozen=True)
class History:
    """Lowest-fidelity objectives of finished trials, in the order in which they were kept.

    Attributes
    ----------
    names : of the objectives
    values : their scores, in their own units; of feasible and other trials
    feasible : whether a trial keeps every limit
    start : the same scores of the specification as it was
    peers : plain engines to compare with
    scorings : layouts scored until a trial was kept, its own included
    """

    names: tuple[str, ...]
    values: Float[np.ndarray, "trial objective"]
    feasible: Bool[np.ndarray, "trial"]
    start: Float[np.ndarray, "objective"]
    peers: tuple[Peer, ...]
    scorings: Int[np.ndarray, "trial"]


@one_thread()
def search_history(space: SearchSpace, kept: KeptTrials, seconds: float = np.inf) -> History:
    """Collect the trials, and let random search and plain CMA-ES score as many layouts as the search did, up
    to 33 600, or as `seconds` hold."""
    names, finished = space.spec.search.objectives, kept.finished
    start = start_scores(space.spec)
    free = sum(not v.choices for v in space.variables)
    each = np.array([trial.scorings for trial in finished])
    count = min(int(each.sum()), MOST_SCORINGS)
    engines = [random_search]
    if free > 1:  # CMA-ES knows no choices, and not a single number
        engines.append(cma_es_peer)
    peers = [engine(space, start, count, seconds / len(engines)) for engine in engines]
    return History(
        names,
        np.array([[trial.scores[name] for name in names] for trial in finished]),
        np.array([trial.feasible for trial in finished]),
        np.array([start.scores[name] for name in names]),
        tuple(peers),
        each.cumsum(),
    )


def best_so_far(
    name: str, values: Float[np.ndarray, "n"], counted: Bool[np.ndarray, "n"]
) -> Float[np.ndarray, "n"]:
    """Best value among those counted up to each; NaN before the first."""
    worst = -np.inf if name in OBJECTIVES_TO_MAXIMIZE else np.inf
    run = np.maximum if name in OBJECTIVES_TO_MAXIMIZE else np.minimum
    best = run.accumulate(np.where(counted, values, worst))
    return np.where(np.isfinite(best), best, np.nan)


class _Scorings:
    """First objectives of layouts within all limits, and after how many scorings each."""

    def __init__(self, name: str) -> None:
        self._name, self.count = name, 0
        self._values: list[np.ndarray] = [np.zeros(0)]
        self._at: list[np.ndarray] = [np.zeros(0)]

    def add(self, judged: Judged) -> None:
        kept = (judged.broken_mm == 0).numpy()
        self._values.append(judged.scores[self._name].double().numpy()[kept])
        self._at.append(self.count + 1.0 + np.flatnonzero(kept))
        self.count += len(kept)

    def peer(self, name: str) -> Peer:
        return Peer(name, np.concatenate(self._values), np.concatenate(self._at), self.count)


def random_search(space: SearchSpace, start: StartScores, count: int, seconds: float) -> Peer:
    """Random layouts, of one structure a chunk."""
    ends = time.monotonic() + seconds
    rng, names = np.random.default_rng(space.spec.seed), space.spec.search.objectives
    flags = np.array([not v.choices for v in space.variables])
    by_structure: dict[Any, LowestFidelity] = {}
    scorings = _Scorings(names[0])
    for first in range(0, count, _CHUNK):
        if first and time.monotonic() > ends:
            break
        size = min(_CHUNK, count - first)
        units = rng.random((size, len(space.variables)))
        params = [params_at(space, unit) for unit in units]
        structure = structure_of(space, params[0])
        if structure not in by_structure:
            by_structure[structure] = structure_fidelity(space, params[0], start)
        fixed = dict(structure)
        poles = [
            polarities(by_structure[structure].space.structured, point | fixed) for point in params
        ]
        scorings.add(_judged(by_structure[structure], units[:, flags], torch.tensor(poles), names))
    return scorings.peer("random search")


def cma_es_peer(space: SearchSpace, start: StartScores, count: int, seconds: float) -> Peer:
    """CMA-ES as it comes, by the first objective with penalties for broken limits; choices are those in the
    middle of the space."""
    ends, names = time.monotonic() + seconds, space.spec.search.objectives
    middle = params_at(space, np.full(len(space.variables), 0.5))
    lowest = structure_fidelity(space, middle, start)
    poles = torch.tensor(polarities(lowest.space.structured, middle))
    scorings, free = _Scorings(names[0]), sum(not v.choices for v in space.variables)

    def worth(units: np.ndarray) -> np.ndarray:
        judged = _judged(lowest, units, poles.expand(len(units), -1), names)
        scorings.add(judged)
        return judged.penalized[:, 0].double().numpy()

    plain_cma_es(
        worth,
        free,
        space.spec.seed,
        lambda: scorings.count >= count or (scorings.count > 0 and time.monotonic() > ends),
    )
    return scorings.peer("plain CMA-ES")


def plain_cma_es(
    worth: Callable[[Float[np.ndarray, "layout variable"]], Float[np.ndarray, "layout"]],
    free: int,
    seed: int,
    enough: Callable[[], bool],
    times: int = 1,
) -> None:
    """Minimise `worth` (above 0) in the unit cube of `free` numbers by CMA-ES with a multiple of its default
    population, again where it has converged, until there is enough."""
    rng = np.random.default_rng(seed)
    borders = np.repeat([[0.0, 1.0]], free, axis=0)
    population = times * (4 + int(3 * np.log(free)))
    while not enough():
        of_run = int(rng.integers(2**31))
        run = CMA(
            rng.random(free), _SPREAD, bounds=borders, seed=of_run, population_size=population
        )
        while not (run.should_stop() or enough()):
            units = np.array([run.ask() for _ in range(population)])
            run.tell(list(zip(units, np.log(worth(units)).tolist(), strict=True)))


def _judged(
    lowest: LowestFidelity, units: np.ndarray, poles: torch.Tensor, names: tuple[str, ...]
) -> Judged:
    with torch.no_grad():
        return judge(lowest, torch.as_tensor(units, dtype=torch.float32), poles, names)
