"""Main loop of a search: draw starts, have them improved and scored, keep what came of them."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from design.errors import InputError
from design.search.space import Params, SearchSpace, structure_of
from design.spec.search import SearchSpec
from estimator.field.device import SWITCH
from instobj.search.apart import WorkerTimeout
from instobj.search.trials import KeptTrials, Scored, Trial, failed_trial

PLAIN_BATCH, CARD_BATCH = 16, 64
"""Layouts drawn and kept together where none is improved: scored at once they cost little more. On a
graphics card runs of CMA-ES go on side by side, and 32 or more of them fill it."""
_FAILURES_IN_A_ROW = 3
"""Batches without a single result after which a search is given up."""

Answer = list[Scored] | WorkerTimeout | InputError
Score = Callable[[list[list[dict[str, Any]]], float], list[Answer]]
"""Scores lists of trials, each of one structure and within a number of seconds, or says why it does not."""
Say = Callable[[str], None]


def run_search(
    space: SearchSpace,
    kept: KeptTrials,
    score: Score,
    say: Say,
    first: Params | None = None,
    over: Callable[[], bool] = lambda: False,
    at_once: int = 1,
    announce: Say | None = None,
) -> None:
    """Add trials until there are as many as asked for, or the time is `over` after a batch.

    A batch has `layouts_at_once`, scored in `at_once` places. `first` is tried first, alone, so that there is
    something to look at soon. Why trials failed, and once that they have fewer generations than planned, goes
    to `announce`, as `say` may leave out lines.

    Raises
    ------
    InputError
        Trials cannot be kept, or nothing but failures comes back.
    """
    search, failed, announce = space.spec.search, 0, announce or say
    together = layouts_at_once(search, at_once)
    begun, cut = len(kept.trials), ""
    while (finished_count := len(kept.trials)) < search.trials:
        # a call without any result yet, whatever failed before, tries the first layout once
        alone = first if finished_count == begun and not kept.finished else None
        if alone is not None:
            starts = [dict(alone)]
        else:
            numbers = range(finished_count, min(finished_count + together, search.trials))
            starts = [drawn_start(space, number, first) for number in numbers]
        finished = _scored_batch(space, finished_count, starts, score, at_once)
        kept.keep(finished)
        for reason in sorted({trial.failure for trial in finished} - {""}):
            announce(f"no result, kept as failed: {reason}")
        if not cut and (alone is None or search.trials == 1):
            cut = _describe_cut(finished, search)
            if cut:
                announce(cut)
        failed = _count_failed(finished, failed)
        say(_standing(kept, search))
        if over():
            return


def layouts_at_once(search: SearchSpec, processes: int) -> int:
    """Return how many layouts a batch has: one for each process, more where they go on side by side."""
    if os.environ.get(SWITCH, "").startswith("cuda"):
        return max(processes, CARD_BATCH)
    return processes if search.polish_steps else max(processes, PLAIN_BATCH)


def drawn_start(space: SearchSpace, number: int, first: Params | None = None) -> Params:
    """Draw the layout that trial `number` begins at: uniform in every range, choices in turn.

    All choices of a list come once before one comes again, in an order that is new every time, so that few
    trials leave none out; the first turn begins with those of `first`, which is trial 0.
    """
    if number == 0 and first is not None:
        return dict(first)
    rng = np.random.default_rng([space.spec.seed, number])
    return {
        v.name: _choice(space, place, number, first or {})
        if v.choices
        else float(rng.uniform(v.low, v.high))
        for place, v in enumerate(space.variables)
    }


def _choice(space: SearchSpace, place: int, number: int, first: Params) -> Any:
    variable = space.variables[place]
    turn, index = divmod(number, len(variable.choices))
    order = np.random.default_rng([space.spec.seed, place, turn]).permutation(len(variable.choices))
    drawn = [variable.choices[k] for k in order]
    if turn == 0 and first.get(variable.name) in drawn:
        drawn.remove(first[variable.name])
        drawn.insert(0, first[variable.name])
    return drawn[index]


def _scored_batch(
    space: SearchSpace, first_number: int, starts: Sequence[Params], score: Score, at_once: int
) -> list[Trial]:
    """All trials of the batch, finished: scored, or failed with a reason.

    Those of one structure are shared out to what is scored at once.
    """
    groups: dict[Any, list[int]] = defaultdict(list)
    for index, params in enumerate(starts):
        groups[structure_of(space, params)].append(index)
    shares = [
        group[k::at_once] for group in groups.values() for k in range(min(at_once, len(group)))
    ]
    questions = [[dict(starts[index]) for index in share] for share in shares]
    answers = score(questions, space.spec.search.trial_limit_s)
    finished: dict[int, Trial] = {}
    for share, answer in zip(shares, answers, strict=True):
        for place, index in enumerate(share):
            number = first_number + index
            finished[index] = (
                failed_trial(number, dict(starts[index]), str(answer))
                if isinstance(answer, Exception)
                else Trial(**vars(answer[place]), number=number)
            )
    return [finished[index] for index in range(len(starts))]


def _count_failed(finished: list[Trial], failed_before: int) -> int:
    reasons = [trial.failure for trial in finished if trial.failure]
    failed = failed_before + 1 if len(reasons) == len(finished) else 0
    if failed >= _FAILURES_IN_A_ROW:
        raise InputError(
            f"the search gave up: {failed} batches in a row had no result. The last reason: "
            f"{reasons[-1]}. Fix that, then go on with --resume"
        )
    return failed


def _describe_cut(finished: Sequence[Trial], search: SearchSpec) -> str:
    """Return that the time held fewer generations than planned, or nothing."""
    had = [trial.generations for trial in finished if trial.generations]
    if not had or min(had) >= search.polish_steps:
        return ""
    return (
        f"a trial has {min(had)} generations, not {search.polish_steps}: as many as its time holds; more "
        "search.seconds give more"
    )


def _standing(kept: KeptTrials, search: SearchSpec) -> str:
    feasible = [trial for trial in kept.finished if trial.feasible]
    share = f"{len(kept.trials)} of {search.trials} trials"
    if not feasible:
        return f"{share}, none within the limits yet"
    best = min(feasible, key=lambda trial: trial.values[0])
    name = search.objectives[0]
    return f"{share}, {name} {best.scores[name]:.4g}"
