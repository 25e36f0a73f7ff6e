"""Runs of CMA-ES joined to fewer and longer ones: a long run finds better layouts than several short ones.

Measured over run lengths, seeds and tasks: docs/measured/layout_search.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import isfinite, prod

from design.search.space import SearchSpace
from design.spec.search import SearchSpec
from instobj.search.time_limit import FIRST_LOOK_S

_LONGEST = 600
"""Generations that one run gains by, seen on the paper's cube; more were not tried."""
_SPARE = 2.0
"""A joined run shall take half of the time at most that is left to all trials."""
_USED = 0.9
"""Share of a trial's time that generations are planned for: their speed is measured once, on few layouts."""
START_SHARE = 0.5
"""Share of the start's time for its generations, the rest for its walk; and of the time of all trials for
the start, where others follow."""


def merge_restarts(
    space: SearchSpace, at_once: int, kept_generations: Sequence[int] = ()
) -> SearchSpace:
    """The search with its `trials` joined to fewer of up to 600 generations, as many in all or a little
    fewer.

    A run may take as long as the trials that it stands for. Trials that are scored `at_once` stay as many,
    so does one for each combination of choices. Of a search that goes on, each kept trial counts by its
    generations: a run that time had cut short leaves more to come.
    Untouched: several objectives, whose front has a layout of each trial; trials without generations.
    """
    search, kept = space.spec.search, len(kept_generations)
    if not search.polish_steps or len(search.objectives) > 1 or kept >= search.trials:
        return space
    missing = search.trials - sum(kept_generations) // search.polish_steps
    if missing <= 0:
        return _changed_space(space, trials=kept)
    combinations = prod(len(v.choices) for v in space.variables if v.choices)
    fewest = max(combinations, at_once)
    times = max(1, min(_LONGEST // search.polish_steps, missing // fewest))
    return _changed_space(
        space,
        trials=kept + missing // times,
        polish_steps=search.polish_steps * times,
    )


def fit_budget(
    space: SearchSpace, generations: int, generation_s: float, layouts: int, left_s: float
) -> SearchSpace:
    """The search as asked for with joined runs of `generations`, or as many as half of the time
    `left_s` of all trials allows where one of `layouts` takes `generation_s`.

    Where half holds fewer than asked for, all of the time is one run's: of as many as asked for, or as it
    holds, at least one.
    """
    all_hold = max(left_s, 0.0) / max(generation_s * layouts, 1e-9)
    fits = max(all_hold / _SPARE, min(space.spec.search.polish_steps, _USED * all_hold))
    return _changed_space(space, polish_steps=max(1, int(min(generations, fits))))


def quick_space(space: SearchSpace, generation_s: float, seconds: float) -> SearchSpace:
    """The search with no more generations than `seconds` hold, but one."""
    fits = int(seconds / max(generation_s, 1e-9))
    steps = space.spec.search.polish_steps
    return _changed_space(space, polish_steps=min(steps, max(fits, 1)))


def plan_trial(
    space: SearchSpace, generation_s: float, left_s: float, first_s: float | None = None
) -> tuple[SearchSpace, float]:
    """Return the search with no more generations than a trial's time holds, and that time, s.

    The specification's own layout has `first_s` for its generations at most, infinite where no other trial
    follows; None: another layout.
    """
    seconds = left_s
    if first_s is not None and isfinite(first_s):
        seconds = max(START_SHARE * left_s, FIRST_LOOK_S)
    planned_s = _USED * seconds if first_s is None else min(first_s, START_SHARE * seconds)
    if space.spec.search.polish_steps:
        space = quick_space(space, generation_s, planned_s)
    return space, seconds


def describe_merge(requested: SearchSpec, merged: SearchSpec, kept: int = 0) -> str:
    """Return what becomes of the trials that are asked for, in words; `kept` of them are there already."""
    kept_text = f"the {kept} kept and " if kept else ""
    return (
        f"instead of {requested.trials} trials of {requested.polish_steps} generations {kept_text}up to "
        f"{merged.trials - kept} longer ones of up to {merged.polish_steps}, which usually finds more; each "
        "is as long as the time of this call holds"
    )


def _changed_space(space: SearchSpace, **budget: float) -> SearchSpace:
    return replace(space, spec=space.spec.changed(search=space.spec.search.changed(**budget)))
