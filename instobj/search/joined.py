"""Runs of CMA-ES joined to fewer and longer ones: a long run finds better layouts than several short ones.

Measured over run lengths, seeds and tasks by `benchmarks/search_engines.py`.
"""

from __future__ import annotations

from dataclasses import replace
from math import prod

from design.search.space import SearchSpace
from design.spec.search import SearchSpec
from instobj.search.time_limit import TRIALS_SHARE

_LONGEST = 600
"""Generations that one run gains by, seen on the paper's cube; more were not tried."""
_SPARE = 2.0
"""A joined run shall take half of the time at most that trials have, and that one may take."""


def joined(space: SearchSpace, at_once: int) -> SearchSpace:
    """The search with its `trials` joined to fewer of up to 600 generations, as many in all or a little
    fewer.

    Trials that are scored `at_once` stay as many, so does one for each combination of choices.
    Untouched: several objectives, whose front has a layout of each trial; trials without generations.
    """
    search = space.spec.search
    if not search.polish_steps or len(search.objectives) > 1:
        return space
    combinations = prod(len(v.choices) for v in space.variables if v.choices)
    fewest = max(combinations, search.batch, at_once)
    times = max(1, min(_LONGEST // search.polish_steps, search.trials // fewest))
    return _with(space, search.trials // times, search.polish_steps * times)


def in_time(space: SearchSpace, least: int, generation_s: float, layouts: int) -> SearchSpace:
    """The search with runs that are as long as time allows where a generation of each of so many layouts
    takes so long, and no shorter than `least` generations."""
    search = space.spec.search
    seconds = min(search.trial_seconds, TRIALS_SHARE * search.seconds) / _SPARE
    fits = int(seconds / max(generation_s * layouts, 1e-9))
    return _with(space, search.trials, min(search.polish_steps, max(fits, least)))


def joining(asked: SearchSpec, now: SearchSpec) -> str:
    """What becomes of the trials that are asked for, in words."""
    return (
        f"{asked.trials} trials of {asked.polish_steps} generations are joined to {now.trials} of "
        f"{now.polish_steps}, or as many as time allows: long runs find better layouts"
    )


def _with(space: SearchSpace, trials: int, generations: int) -> SearchSpace:
    search = space.spec.search.changed(trials=trials, polish_steps=generations)
    return replace(space, spec=space.spec.changed(search=search))
