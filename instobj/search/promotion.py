"""Promotion through the fidelity levels: leaders scored with rigid magnets, finalists by the chain."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from design.errors import InputError
from design.search.space import SearchSpace, start_params, unit_of, with_layout
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from instobj.commands.buildable import why_unbuildable
from instobj.search.corrected import corrected_params
from instobj.search.fidelity import (
    Bounds,
    TwinRatio,
    bounds_of_twins,
    twin_ratios,
)
from instobj.search.levels import Levels
from instobj.search.time_limit import TimeLimit, TimeSpent
from instobj.search.trials import KeptTrials, Trial
from instobj.search.verdict import FIRST, LAST, SECOND, Promoted, Promotion, merit, objections
from instobj.store.readers import FINDINGS

_APART = 0.05
"""Share of the unit cube: leaders differ by at least that much in some variable."""
_LEADERS_PER_FINALIST = 3
"""Layouts at the second level for each finalist: some cannot be fabricated, or are worse there."""
_SAME = 1e-3
"""Share of a variable's range: a trial as near the start in all variables is the start, rounded."""
_ALLOWANCE = 1.25
"""A finalist takes the chain that much longer than the start did, with its checks of fabrication."""


@dataclass
class Promoter:
    """Way of a search's leaders through the fidelity levels, within its time.

    The functions say what else is asked of layouts: where a leader walks between the levels, what keeps
    one from being fabricated, and bounds of its toleranced twins.
    """

    space: SearchSpace
    limit: TimeLimit
    levels: Levels
    walk: Callable[..., dict[str, Any] | None] = corrected_params
    unbuildable: Callable[[ObjectSpec, ObjectSpec], str] = why_unbuildable
    twins: Callable[[ObjectSpec], list[Bounds]] = bounds_of_twins

    def __post_init__(self) -> None:
        self.search, self.say = self.space.spec.search, self.levels.say
        self.start = Promoted("start", None, self.space.spec, {})
        self.needed_s = 0.0

    @one_thread()
    def promote(self, kept: KeptTrials) -> Promotion | None:
        """Take leaders through all levels; None where no trial but the start keeps every limit.

        Tensors take one thread: two gain little here, and wait for each other where other programs run.
        Where time runs short, fewer leaders and fewer finalists, at least one of each.
        """
        trials = leaders(self.space, kept, _LEADERS_PER_FINALIST * self.search.finalists)
        if not trials:
            return None
        twins = self._judge_start()
        scored = self._judge_leaders(trials)
        finalists, ranked = self._judge_finalists(self._ranked(scored, SECOND))
        finalists = self._ranked(finalists, LAST)
        ratios = self._ratios(twins, finalists)
        best = (finalists or ranked)[0]
        return Promotion(
            self.start,
            tuple(ranked),
            tuple(finalists),
            ratios,
            objections(self.search, best, self.start, ratios),
            (len(trials), min(self.search.finalists, len(trials))),
        )

    def _judge_start(self) -> list[Bounds]:
        """Score the start at the highest level, and bound its twins.

        What that takes is what a finalist will need; it is kept free.
        """
        start, (second, last) = self.start, (self.levels.table[name] for name in (SECOND, LAST))
        self.levels.make([start], (*last.stages, *second.stages))
        self.levels.score([start], LAST)
        self.say("virtual objects of the start")
        began_s = self.limit.left_s
        twins = self.twins(start.spec)
        self.needed_s = _ALLOWANCE * (last.seconds(start.spec) + began_s - self.limit.left_s)
        return twins

    def _judge_leaders(self, trials: Sequence[Trial]) -> list[Promoted]:
        """Score as many as there is time for at the lower levels, then the ones that the space mapping has
        improved."""
        spec, second = self.space.spec, self.levels.table[SECOND]
        layouts = [
            Promoted(f"trial {trial.number}", trial.number, with_layout(spec, trial.params), {})
            for trial in trials
        ]
        layouts = self.levels.score([self.start, *layouts], FIRST)
        self.levels.make(layouts[1:2], second.stages)
        self.levels.make(layouts[2:], second.stages, self._short)
        _, *scored = self.levels.score(layouts, SECOND, self._short)
        # who walks on is scored there again
        self.needed_s += second.seconds(spec)
        layouts = self.levels.score([self.start, *self._walked(trials, scored)], FIRST)
        self.levels.make(layouts[1:], second.stages, self._short)
        return scored + self.levels.score(layouts, SECOND, self._short)[1:]

    def _walked(self, trials: Sequence[Trial], scored: Sequence[Promoted]) -> list[Promoted]:
        """Best leaders once they have walked on, at most as many as finalists; none for want of time."""
        params: dict[int | None, dict[str, Any]] = {trial.number: trial.params for trial in trials}
        walked: list[Promoted] = []
        for leader in self._ranked(scored, SECOND)[: self.search.finalists]:
            label, number = leader.label, leader.trial
            if self._short():
                self.say(f"{label} does not walk on: time runs short")
                break
            self.say(f"{label} walks on, the lowest fidelity level corrected by the second")
            end = self.walk(self.space, params[number], self.start, leader, self._short)
            if end is None:
                self.say(f"{label}: nothing near it is better")
                continue
            spec = with_layout(self.space.spec, end)
            walked.append(Promoted(f"{label}, walked on", number, spec, {}, corrected=True))
        return walked

    def _judge_finalists(self, ranked: list[Promoted]) -> tuple[list[Promoted], list[Promoted]]:
        """Score the first leaders that can be fabricated by the chain; one, where the next may take too long.

        Then the leaders follow, first the one that the end of the time broke off where none is a finalist.

        Raises
        ------
        InputError
            None can be fabricated and scored.
        """
        count, workers = self.search.finalists, self.levels.workers.count
        finalists: list[Promoted] = []
        for place, leader in enumerate(ranked):
            before_s = self.limit.left_s
            try:
                side_by_side = ranked[place : place + min(workers, count - len(finalists))]
                stages = FINDINGS.stage, *self.levels.table[LAST].stages
                self.levels.make(side_by_side, stages)
                self.say(f"fabrication checks of {leader.label}")
                why = self.unbuildable(leader.spec, self.start.spec)
                if why:
                    self.say(
                        f"{leader.label} falls out, the next takes its place: it cannot be fabricated: {why}"
                    )
                    continue
                finalists += self.levels.score([self.start, leader], LAST)[1:]
            except TimeSpent:
                self.say(f"fidelity level {LAST} of {leader.label} is left out: the time is over")
                others = [layout for layout in ranked if layout is not leader]
                return finalists, ranked if finalists else [leader, *others]
            took_s, left_s = before_s - self.limit.left_s, self.limit.left_s
            # the next may take twice as long as this one
            if len(finalists) == count or (finalists and took_s > left_s / 2):
                break
        if not finalists:
            raise InputError(
                "no leader could be fabricated and scored at the higher fidelity levels: see the reasons "
                "above. Raise search.finalists and go on with --resume"
            )
        return finalists, ranked

    def _ratios(self, twins: list[Bounds], finalists: Sequence[Promoted]) -> dict[str, TwinRatio]:
        """Bounds of the start's twins over those of the best finalist's; none where the time ends."""
        if not finalists:
            return {}
        self.say("twins within tolerance")
        try:
            return twin_ratios(self.start.spec, twins, self.twins(finalists[0].spec))
        except TimeSpent:
            self.say("twins are left out: the time is over")
            return {}

    def _short(self) -> bool:
        return self.limit.left_s <= self.needed_s

    def _ranked(self, layouts: Sequence[Promoted], level: str) -> list[Promoted]:
        return sorted(layouts, key=lambda layout: merit(self.search, layout, self.start, level))


def leaders(space: SearchSpace, kept: KeptTrials, count: int) -> list[Trial]:
    """Best trials within all limits that are not almost the same layout, nor the start.

    With several objectives, by their product: in the middle of the front.
    """
    start = start_params(space)
    within = [trial for trial in kept.finished if trial.feasible]
    within.sort(key=lambda trial: float(np.log(trial.values).sum()))
    chosen: list[Trial] = []
    points: list[np.ndarray] = []
    for trial in within:
        point = unit_of(space, trial.params)
        if start is not None and abs(point - unit_of(space, start)).max() <= _SAME:
            continue
        if all(abs(point - chosen_point).max() >= _APART for chosen_point in points):
            chosen.append(trial)
            points.append(point)
        if len(chosen) == count:
            break
    return chosen
