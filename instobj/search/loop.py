"""A search's main loop: draw a batch of layouts, have it scored, keep what came of it."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable
from typing import Any

import numpy as np
from optuna.trial import FrozenTrial, Trial

from design.errors import InputError
from design.search.space import SearchSpace, structure_of
from design.spec.search import SearchSpec
from estimator.field.device import SWITCH
from instobj.search.apart import GivenUp, Scored
from instobj.search.engines import Sampling, ask, sampling, tell, tell_failed
from instobj.search.study import KeptStudy

PLAIN_BATCH, CARD_BATCH = 16, 64
"""Layouts proposed and kept together where none is improved: scored at once they cost little more. On a
graphics card runs of CMA-ES go on side by side, and 32 or more of them fill it."""
_FAILURES_IN_A_ROW = 3
"""Batches without a single result after which a search is given up."""

Answer = list[Scored] | GivenUp | InputError
Score = Callable[[list[list[dict[str, Any]]], float], list[Answer]]
"""Scores lists of trials, each of one structure and within so many seconds, or says why it does not."""
Say = Callable[[str], None]


def run_search(
    space: SearchSpace,
    kept: KeptStudy,
    score: Score,
    say: Say,
    first: dict[str, Any] | None = None,
    worker: int = 0,
    over: Callable[[], bool] = lambda: False,
    processes: int = 1,
) -> None:
    """Work on the study until its trials are done, or the time is `over` after a batch.

    A batch has `layouts_at_once`. Trials that others keep meanwhile are
    learned from. `first` is tried first in a new study.

    Raises
    ------
    InputError
        Trials cannot be kept, or nothing but failures comes back.
    """
    search = space.spec.search
    past = kept.trials()
    seed = _seed(space.spec.seed, len(past), worker)
    engine = sampling(space.variables, len(search.objectives), seed, past, first)
    together = layouts_at_once(search, processes)
    seen, failed = len(past), 0
    while seen < search.trials:
        asked = ask(engine, min(together, search.trials - seen))
        finished = _scored_batch(space, engine, asked, score, processes)
        kept.keep(finished)
        for reason in sorted(set(_failures(finished))):
            say(f"no result, kept as failed: {reason}")
        failed = _count_failed(finished, failed)
        seen = _learn_from_others(engine, kept, seen, len(finished))
        say(_standing(kept, search, seen))
        if over():
            return


def layouts_at_once(search: SearchSpec, processes: int) -> int:
    """How many layouts a batch has: one for each process, more where they go on side by side."""
    if os.environ.get(SWITCH, "").startswith("cuda"):
        return max(processes, CARD_BATCH)
    return processes if search.polish_steps else max(processes, PLAIN_BATCH)


def _scored_batch(
    space: SearchSpace, engine: Sampling, asked: list[Trial], score: Score, processes: int
) -> list[FrozenTrial]:
    """All trials of the batch, finished: scored, or failed with a reason.

    Those of one structure are shared out to the processes.
    """
    groups: dict[Any, list[Trial]] = defaultdict(list)
    for trial in asked:
        groups[structure_of(space, trial.params)].append(trial)
    shares = [
        trials[k::processes]
        for trials in groups.values()
        for k in range(min(processes, len(trials)))
    ]
    answers = score(
        [[dict(trial.params) for trial in share] for share in shares],
        space.spec.search.trial_limit_s,
    )
    finished: list[FrozenTrial] = []
    for share, answer in zip(shares, answers, strict=True):
        if isinstance(answer, Exception):
            finished += [tell_failed(engine, trial, str(answer)) for trial in share]
            continue
        finished += [
            tell(engine, trial, result.params, result.values, _attributes(result))
            for trial, result in zip(share, answer, strict=True)
        ]
    return finished


def _attributes(result: Scored) -> dict[str, Any]:
    return {
        "scores": result.scores,
        "broken_mm": result.broken_mm,
        "misfit": result.misfit,
        "scorings": result.scorings,
    }


def _failures(finished: list[FrozenTrial]) -> list[str]:
    return [t.user_attrs["failure"] for t in finished if "failure" in t.user_attrs]


def _count_failed(finished: list[FrozenTrial], before: int) -> int:
    reasons = _failures(finished)
    failed = before + 1 if len(reasons) == len(finished) else 0
    if failed >= _FAILURES_IN_A_ROW:
        raise InputError(
            f"the search gave up: {failed} batches in a row had no result. The last reason: "
            f"{reasons[-1]}. Fix that, then go on with --resume"
        )
    return failed


def _learn_from_others(engine: Sampling, kept: KeptStudy, seen: int, own: int) -> int:
    """Add what other workers kept since; returns how many trials there are now."""
    trials = kept.trials()
    known = {_identity(t) for t in engine.study.get_trials(deepcopy=False)[-own:]} if own else set()
    if len(trials) > seen + own:
        engine.study.add_trials([t for t in trials[seen:] if _identity(t) not in known])
    return len(trials)


def _identity(trial: FrozenTrial) -> tuple[Any, ...]:
    return tuple(sorted(trial.params.items(), key=lambda item: item[0]))


def _standing(kept: KeptStudy, search: SearchSpec, seen: int) -> str:
    feasible = [t for t in kept.finished() if is_feasible(t)]
    if not feasible:
        return f"{_share(seen, search.trials)}, none within the limits yet"
    best = min(feasible, key=lambda t: t.values[0])
    name = search.objectives[0]
    return f"{_share(seen, search.trials)}, {name} {best.user_attrs['scores'][name]:.4g}"


def _share(seen: int, asked: int) -> str:
    """How far a search is; a resumed one may hold more trials than are asked for now."""
    return f"{seen} of {asked} trials" if seen <= asked else f"{seen} trials ({asked} asked for)"


def is_feasible(trial: FrozenTrial) -> bool:
    """Whether a finished trial keeps every limit."""
    return trial.user_attrs["broken_mm"] == 0 and not trial.user_attrs["misfit"]


def _seed(seed: int, past: int, worker: int) -> int:
    """Another stream for every continuation and worker, the same each time."""
    return int(np.random.SeedSequence([seed, past, worker]).generate_state(1)[0])
