"""Promotion through the fidelity levels: leaders scored with rigid magnets, finalists by the chain.

What a level said is kept in a file beside the trials, layout by layout, so that a broken search goes
on from there.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.files import atomic_path
from design.search.space import SearchSpace, start_params, unit_of, with_layout
from design.search.structure import structure_choices
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from estimator.layouts.fidelity import (
    SCORE_NAMES,
    FidelityScore,
    against_start,
    lowest_fidelity_score,
    rank_correlations,
)
from estimator.layouts.scorer import LayoutScorer
from instobj.commands.buildable import why_unbuildable
from instobj.search.corrected import corrected_params
from instobj.search.fidelity import (
    Bounds,
    TwinRatio,
    bounds_of_twins,
    chain_score,
    chain_seconds,
    estimator_errors,
    second_score,
    second_seconds,
    twin_ratios,
)
from instobj.search.lowest_fidelity import each_alone, scorers
from instobj.search.time_limit import TimeLimit, TimeSpent
from instobj.search.trials import KeptTrials, Trial, search_key
from instobj.search.verdict import FIRST, LAST, SECOND, Promoted, merit, objections
from instobj.stages.makers.magnet_free import forget_shell
from instobj.stages.tasks import tasks_of
from instobj.stages.workers import Here, Workers
from instobj.store.content import store_root
from instobj.store.readers import FINDINGS, METRICS, SECOND_FIDELITY, SIGNALS

_APART = 0.05
"""Share of a variable's range by which two leaders differ, at least in one variable.

Otherwise all leaders could be one optimum, scored many times.
"""
_SAME = 1e-3
"""Share of a variable's range: a trial as near the start in all variables is the start, rounded."""
_KEPT = {field.name for field in fields(FidelityScore)}
"""Names of a stored score; one with other names is of an earlier version, and scored again."""
_RIGID, _CHAIN = (SECOND_FIDELITY.stage,), (SIGNALS.stage,)
"""Stages that the second and the highest fidelity level need."""
_ALLOWANCE = 1.25
"""Time that a finalist may take in the chain, over the start's: its checks of fabrication come on top."""

Say = Callable[[str], None]


@dataclass(frozen=True)
class Promotion:
    """Result of a promotion.

    `correlations` are rank correlations of every score between a level and the next, by its number;
    `ratios` of the best against the start at the highest fidelity level, with 95 % intervals between
    toleranced twins. `estimators` holds what estimators trained for the start and for each finalist
    achieve on simulated presses held out (`instobj.search.fidelity.estimator_errors`). `objections`
    say why the highest fidelity level does not call the best one better than the start. `asked` are
    the numbers of leaders and finalists that should have been scored.

    Where the time ended before the chain had scored a finalist there is none, and the leaders begin
    with the one that it had come to.
    """

    start: Promoted
    leaders: tuple[Promoted, ...]
    finalists: tuple[Promoted, ...]
    correlations: dict[str, dict[str, float]]
    ratios: dict[str, TwinRatio]
    estimators: dict[str, dict[str, float]]
    objections: tuple[str, ...]
    asked: tuple[int, int]

    @property
    def shortened(self) -> str:
        """Text on how many were scored, where that is fewer than asked for; else empty."""
        scored = sum(not leader.corrected for leader in self.leaders), len(self.finalists)
        if scored == self.asked:
            return ""
        return (
            f"{scored[0]} of {self.asked[0]} leaders and {scored[1]} of {self.asked[1]} finalists were "
            "scored: the others fell out for want of time, or could not be fabricated or scored"
        )

    @property
    def better(self) -> bool:
        """Verdict of the highest fidelity level: objectives' mean, all limits and 95 % of the twins."""
        return not self.objections

    @property
    def best(self) -> Promoted:
        """The finalist that the highest fidelity level puts first, or the first leader without one."""
        return (self.finalists or self.leaders)[0]

    @property
    def level(self) -> str:
        """The highest fidelity level that has scored the best one."""
        return LAST if self.finalists else SECOND


@dataclass(frozen=True)
class _Ahead:
    """Stages of several layouts made side by side where there are several workers; scoring, which takes
    one layout after the other, then finds them in the store."""

    workers: Workers
    say: Say

    def make(
        self,
        layouts: Sequence[Promoted],
        stages: tuple[str, ...],
        enough: Callable[[], bool] = lambda: False,
    ) -> None:
        """Make the stages; one that fails is made again where it is needed, and reported there."""
        if self.workers.count > 1:
            tasks, _ = tasks_of([layout.spec for layout in layouts], stages)
            self.workers.make(tasks, store_root(), self.say, enough)


@one_thread()
def promote(
    space: SearchSpace,
    kept: KeptTrials,
    folder: Path,
    say: Say,
    limit: TimeLimit,
    workers: Workers | None = None,
) -> Promotion | None:
    """Take the search's leaders through all fidelity levels.

    None where no trial but the start keeps every limit.

    Tensors take one thread: two gain little here, and wait for each other where other programs run.
    The start goes first, to the highest level: what that takes is what a finalist will need, and it is
    kept free. Where time runs short, fewer leaders and fewer finalists, at least one of each.
    """
    search, memo = space.spec.search, folder / "rungs.json"
    chosen = leaders(space, kept, search.leaders)
    if not chosen:
        return None
    start = Promoted("start", None, space.spec, {})
    named = [
        Promoted(f"trial {trial.number}", trial.number, with_layout(space.spec, trial.params), {})
        for trial in chosen
    ]
    ahead = _Ahead(workers or Here(), say)
    ahead.make([start], (*_CHAIN, *_RIGID))
    _score([start], LAST, highest_scoring, memo, say)
    # What the start takes at the highest level, with its twins, is what one finalist will need.
    say("twins of the start within tolerance")
    began = time.monotonic()
    twins = bounds_of_twins(start.spec)
    needed_s = _ALLOWANCE * (chain_seconds(start.spec) + time.monotonic() - began)

    def short() -> bool:
        """Return whether no more is left than one finalist needs: leaders then stop."""
        return limit.left_s <= needed_s

    # Level 1, all leaders; level 2, the first leader whatever the time, others while there is some.
    everyone = _score([start, *named], FIRST, lowest_scoring, memo, say)
    ahead.make(everyone[1:2], _RIGID)
    ahead.make(everyone[2:], _RIGID, short)
    everyone = _score(everyone, SECOND, second_scoring, memo, say, short)
    needed_s += second_seconds(start.spec)  # who walks on is scored there again
    everyone += _corrected(space, chosen, everyone, memo, say, short, ahead)
    # Level 3, the chain: the best of level 2 in order, until there are enough or the time ends.
    ranked = sorted(everyone[1:], key=lambda layout: merit(search, layout, start, SECOND))
    finalists, unfinished = _finalists(start, ranked, search.finalists, memo, say, limit, ahead)
    finalists.sort(key=lambda layout: merit(search, layout, start, LAST))
    # False sorts before True: the one that the end of the time broke off comes first; order else kept.
    ranked.sort(key=lambda layout: layout is not unfinished)
    correlations = {
        FIRST: _correlations(everyone, FIRST, SECOND),
        SECOND: _correlations([start, *finalists], SECOND, LAST),
    }
    ratios = _ratios(start, twins, finalists, say)
    estimators = _estimators((start, *finalists), say, limit, ahead)
    # The verdict is on the best finalist, or on the first leader where there is no finalist.
    against = objections(search, (finalists or ranked)[0], start, ratios)
    return Promotion(
        start,
        tuple(ranked),
        tuple(finalists),
        correlations,
        ratios,
        estimators,
        against,
        (len(named), min(search.finalists, len(named))),
    )


def _ratios(
    start: Promoted, twins: list[Bounds], finalists: Sequence[Promoted], say: Say
) -> dict[str, TwinRatio]:
    """Return the ratios of the best finalist; none where the time ends."""
    if not finalists:
        return {}
    say("twins within tolerance")
    try:
        return twin_ratios(start.spec, twins, bounds_of_twins(finalists[0].spec))
    except TimeSpent:
        say("twins are left out: the time is over")
        return {}


def _estimators(
    layouts: Sequence[Promoted], say: Say, limit: TimeLimit, ahead: _Ahead
) -> dict[str, dict[str, float]]:
    """Return estimators' errors by layout, while there is time: the verdict stands without them."""
    errors: dict[str, dict[str, float]] = {}
    longest_s = 0.0
    if limit.left_s <= 0:
        return errors
    try:
        ahead.make(layouts, (METRICS.stage,))
        for layout in layouts:
            # The next layout will take about as long as the slowest so far.
            if longest_s > limit.left_s:
                say(f"estimators of {layout.label} are left out: time runs short")
                continue
            say(f"estimators of {layout.label}")
            left_before_s = limit.left_s
            errors[layout.label] = estimator_errors(layout.spec)
            longest_s = max(longest_s, left_before_s - limit.left_s)
    except TimeSpent:
        say("further estimators are left out: the time is over")
    return errors


def _corrected(
    space: SearchSpace,
    chosen: Sequence[Trial],
    scored: Sequence[Promoted],
    memo: Path,
    say: Say,
    short: Callable[[], bool],
    ahead: _Ahead,
) -> list[Promoted]:
    """Return the best leaders after a walk with corrected scores (space mapping), scored up to level 2.

    At most as many as finalists; none where time is short.
    """
    search, start, new = space.spec.search, scored[0], []
    params = {trial.number: trial.params for trial in chosen}
    ranked = sorted(scored[1:], key=lambda layout: merit(search, layout, start, SECOND))
    for leader in ranked[: search.finalists]:
        if short():
            say(f"{leader.label} does not walk on: time runs short")
            break
        say(f"{leader.label} walks on, the lowest fidelity level corrected by the second")
        assert leader.trial is not None  # only the start has none
        walked = corrected_params(space, params[leader.trial], start, leader, short)
        if walked is None:
            say(f"{leader.label}: nothing near it is better")
            continue
        spec = with_layout(space.spec, walked)
        new.append(Promoted(f"{leader.label}, walked on", leader.trial, spec, {}, corrected=True))
    # The start goes along: scores are stored against the first layout's.
    lower = _score([start, *new], FIRST, lowest_scoring, memo, say)
    ahead.make(lower[1:], _RIGID, short)
    return _score(lower, SECOND, second_scoring, memo, say, short)[1:]


def _finalists(
    start: Promoted,
    ranked: Sequence[Promoted],
    count: int,
    memo: Path,
    say: Say,
    limit: TimeLimit,
    ahead: _Ahead,
) -> tuple[list[Promoted], Promoted | None]:
    """Return the first leaders that can be fabricated and that the highest level can score.

    One alone where the next may take too long. Besides, where there is none: the leader at which the
    time ended.

    Raises
    ------
    InputError
        None can be.
    """
    finalists: list[Promoted] = []
    for number, leader in enumerate(ranked):
        left_before_s = limit.left_s
        side_by_side = min(ahead.workers.count, count - len(finalists))
        try:
            ahead.make(ranked[number : number + side_by_side], (FINDINGS.stage, *_CHAIN))
            say(f"fabrication checks of {leader.label}")
            why = why_unbuildable(leader.spec, start.spec)
            if why:
                say(
                    f"{leader.label} falls out, the next takes its place: it cannot be fabricated: {why}"
                )
                continue
            finalists += _score([start, leader], LAST, highest_scoring, memo, say)[1:]
        except TimeSpent:
            say(f"fidelity level {LAST} of {leader.label} is left out: the time is over")
            return finalists, None if finalists else leader
        took = left_before_s - limit.left_s
        # Stop where the next one, if it takes as long, would use more than half of the time left.
        if len(finalists) == count or (finalists and took > limit.left_s / 2):
            break
    if not finalists:
        raise InputError(
            "no leader could be fabricated and scored at the higher fidelity levels: see the reasons above. "
            "Raise search.leaders and go on with --resume"
        )
    return finalists, None


def leaders(space: SearchSpace, kept: KeptTrials, count: int) -> list[Trial]:
    """Return the best trials within all limits that are not almost the same layout, nor the start.

    With several objectives, by their product: in the middle of the front.
    """
    start = start_params(space)
    # Variables scaled to 0 … 1 of their ranges; distances are the largest of any variable.
    origin = None if start is None else unit_of(space, start)
    within = [
        trial
        for trial in kept.finished
        if trial.feasible
        and (origin is None or abs(unit_of(space, trial.params) - origin).max() > _SAME)
    ]
    within.sort(key=lambda trial: float(np.log(trial.values).sum()))
    # Greedy, best first: each next trial must be apart from all that are chosen.
    chosen: list[Trial] = []
    points: list[np.ndarray] = []
    for trial in within:
        point = unit_of(space, trial.params)
        if all(abs(point - other).max() >= _APART for other in points):
            chosen.append(trial)
            points.append(point)
        if len(chosen) == count:
            break
    return chosen


def _correlations(layouts: list[Promoted], lower: str, upper: str) -> dict[str, float]:
    return rank_correlations(
        *([layout.levels[level] for layout in layouts] for level in (lower, upper))
    )


Scoring = Callable[[], AbstractContextManager[Callable[[ObjectSpec], FidelityScore]]]


def _score(
    layouts: list[Promoted],
    level: str,
    scoring: Scoring,
    memo: Path,
    say: Say,
    enough: Callable[[], bool] = lambda: False,
) -> list[Promoted]:
    """Fill in a level, from the file or anew; layouts that cannot be scored fall out, with a reason.

    Once `enough`, what is neither on file nor the start or the first layout falls out too.
    """
    known = json.loads(memo.read_text(encoding="utf-8")) if memo.is_file() else {}
    scored: list[Promoted] = []
    with scoring() as score:
        for layout in layouts:
            key = f"{level} {search_key(layout.spec)}"
            if known.get(key, {}).keys() != _KEPT:
                # The start and one more always: without both there is nothing to compare.
                if len(scored) > 1 and enough():
                    say(f"fidelity level {level}: {layout.label} falls out: time runs short")
                    continue
                say(f"fidelity level {level}: {layout.label}")
                try:
                    known[key] = asdict(score(layout.spec))
                except (ValueError, ArithmeticError) as error:
                    # Without the start (no trial) no other score means anything.
                    if layout.trial is None:
                        raise
                    say(f"fidelity level {level}: {layout.label} falls out: {error}")
                    continue
                with atomic_path(memo) as temporary:
                    temporary.write_text(json.dumps(known, indent=1), encoding="utf-8")
            layout.levels[level] = _score_of(known[key], layouts[0], level)
            scored.append(layout)
    return scored


def _score_of(kept: dict[str, Any], start: Promoted, level: str) -> FidelityScore:
    """Return the score that JSON kept, compared with the start's once that is there."""
    bounds_mm = tuple(kept["position_bounds_mm"])
    score = FidelityScore(
        **{name: kept[name] for name in SCORE_NAMES}, position_bounds_mm=bounds_mm
    )
    # At 1 all places may be worse than the start's: nothing to compare. The start compares with itself.
    worse_allowed = start.spec.search.limits.places_worse
    if worse_allowed == 1:
        return score
    return against_start(start.levels.get(level, score), score, worse_allowed)


_SCORER = ("sensor_chip",)
_SHELL = ("shell_thickness_mm", "silicone")
"""Structural choices that layouts must share to share a scorer of the lowest level."""


def _alike(spec: ObjectSpec, names: tuple[str, ...]) -> tuple[Any, ...]:
    """Return the structural choices of these names: layouts that agree in them share a scorer."""
    choices = structure_choices(spec)
    return tuple(choices[name] for name in names)


@contextmanager
def lowest_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    """Yield the score of level 1; scorers are made once for all layouts that can share them."""
    made: dict[tuple[Any, ...], tuple[LayoutScorer, ...]] = {}

    def score(spec: ObjectSpec) -> FidelityScore:
        key = *_alike(spec, _SCORER + _SHELL), *spec.magnets.sizes
        if key not in made:
            made[key] = scorers(spec, each_alone(spec.body.sensed))
        return lowest_fidelity_score(spec, made[key])

    yield score


@contextmanager
def second_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    """Yield the score of level 2; layouts of one shell that follow each other share a factorization."""
    try:
        yield second_score
    finally:
        forget_shell()


@contextmanager
def highest_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    """Yield the score of level 3, the whole chain."""
    yield chain_score
