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
"""Of the unit cube: leaders differ by at least that much in some variable."""
_SAME = 1e-3
"""Of the unit cube: as near the start a trial is the start, rounded."""
_KEPT = {field.name for field in fields(FidelityScore)}
_RIGID, _CHAIN = (SECOND_FIDELITY.stage,), (SIGNALS.stage,)
_ALLOWANCE = 1.25
"""A finalist takes the chain that much longer than the start did, with its checks of fabrication."""

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
        """How many were scored, in words, where that is fewer than asked for."""
        scored = sum(not one.corrected for one in self.leaders), len(self.finalists)
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
        """What fails here is made again by whoever needs it, and told there."""
        if self.workers.count > 1:
            tasks, _ = tasks_of([one.spec for one in layouts], stages)
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
    """The search's leaders taken through all fidelity levels; None where no trial but the start keeps
    every limit.

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
    say("twins of the start within tolerance")
    began = time.monotonic()
    twins = bounds_of_twins(start.spec)
    needed_s = _ALLOWANCE * (chain_seconds(start.spec) + time.monotonic() - began)

    def short() -> bool:
        return limit.left_s <= needed_s

    everyone = _score([start, *named], FIRST, lowest_scoring, memo, say)
    ahead.make(everyone[1:2], _RIGID)
    ahead.make(everyone[2:], _RIGID, short)
    everyone = _score(everyone, SECOND, second_scoring, memo, say, short)
    needed_s += second_seconds(start.spec)  # who walks on is scored there again
    everyone += _corrected(space, chosen, everyone, memo, say, short, ahead)
    ranked = sorted(everyone[1:], key=lambda one: merit(search, one, start, SECOND))
    finalists, unfinished = _finalists(start, ranked, search.finalists, memo, say, limit, ahead)
    finalists.sort(key=lambda one: merit(search, one, start, LAST))
    ranked.sort(key=lambda one: one is not unfinished)
    correlations = {
        FIRST: _correlations(everyone, FIRST, SECOND),
        SECOND: _correlations([start, *finalists], SECOND, LAST),
    }
    ratios = _ratios(start, twins, finalists, say)
    estimators = _estimators((start, *finalists), say, limit, ahead)
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
    """Of the best finalist; none where the time ends."""
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
    """By layout, for as long as there is time: the verdict stands without them."""
    found: dict[str, dict[str, float]] = {}
    took = 0.0
    if limit.left_s <= 0:
        return found
    try:
        ahead.make(layouts, (METRICS.stage,))
        for one in layouts:
            if took > limit.left_s:
                say(f"estimators of {one.label} are left out: time runs short")
                continue
            say(f"estimators of {one.label}")
            before = limit.left_s
            found[one.label] = estimator_errors(one.spec)
            took = max(took, before - limit.left_s)
    except TimeSpent:
        say("further estimators are left out: the time is over")
    return found


def _corrected(
    space: SearchSpace,
    chosen: Sequence[Trial],
    scored: Sequence[Promoted],
    memo: Path,
    say: Say,
    short: Callable[[], bool],
    ahead: _Ahead,
) -> list[Promoted]:
    """The best leaders once they have walked on, at most as many as finalists; none, where time is
    short."""
    search, start, new = space.spec.search, scored[0], []
    params = {trial.number: trial.params for trial in chosen}
    ranked = sorted(scored[1:], key=lambda one: merit(search, one, start, SECOND))
    for one in ranked[: search.finalists]:
        if short():
            say(f"{one.label} does not walk on: time runs short")
            break
        say(f"{one.label} walks on, the lowest fidelity level corrected by the second")
        assert one.trial is not None
        walked = corrected_params(space, params[one.trial], start, one, short)
        if walked is None:
            say(f"{one.label}: nothing near it is better")
            continue
        spec = with_layout(space.spec, walked)
        new.append(Promoted(f"{one.label}, walked on", one.trial, spec, {}, corrected=True))
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
    """The first leaders that can be fabricated and the highest level can score; one, where the next may
    take too long. Besides, the one that the end of the time broke off, where there are none.

    Raises
    ------
    InputError
        None can be.
    """
    finalists: list[Promoted] = []
    for number, one in enumerate(ranked):
        began = limit.left_s
        side_by_side = min(ahead.workers.count, count - len(finalists))
        try:
            ahead.make(ranked[number : number + side_by_side], (FINDINGS.stage, *_CHAIN))
            say(f"fabrication checks of {one.label}")
            why = why_unbuildable(one.spec, start.spec)
            if why:
                say(
                    f"{one.label} falls out, the next takes its place: it cannot be fabricated: {why}"
                )
                continue
            finalists += _score([start, one], LAST, highest_scoring, memo, say)[1:]
        except TimeSpent:
            say(f"fidelity level {LAST} of {one.label} is left out: the time is over")
            return finalists, None if finalists else one
        took = began - limit.left_s
        if len(finalists) == count or (finalists and took > limit.left_s / 2):
            break
    if not finalists:
        raise InputError(
            "no leader could be fabricated and scored at the higher fidelity levels: see the reasons above. "
            "Raise search.leaders and go on with --resume"
        )
    return finalists, None


def leaders(space: SearchSpace, kept: KeptTrials, count: int) -> list[Trial]:
    """The best trials within all limits that are not almost the same layout, nor the start.

    With several objectives, by their product: in the middle of the front.
    """
    start = start_params(space)
    own = None if start is None else unit_of(space, start)
    within = [
        trial
        for trial in kept.finished
        if trial.feasible and (own is None or abs(unit_of(space, trial.params) - own).max() > _SAME)
    ]
    within.sort(key=lambda trial: float(np.log(trial.values).sum()))
    found: list[Trial] = []
    points: list[np.ndarray] = []
    for trial in within:
        point = unit_of(space, trial.params)
        if all(abs(point - other).max() >= _APART for other in points):
            found.append(trial)
            points.append(point)
        if len(found) == count:
            break
    return found


def _correlations(layouts: list[Promoted], lower: str, upper: str) -> dict[str, float]:
    return rank_correlations(*([one.levels[level] for one in layouts] for level in (lower, upper)))


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
    left: list[Promoted] = []
    with scoring() as score:
        for one in layouts:
            key = f"{level} {search_key(one.spec)}"
            if known.get(key, {}).keys() != _KEPT:
                if len(left) > 1 and enough():
                    say(f"fidelity level {level}: {one.label} falls out: time runs short")
                    continue
                say(f"fidelity level {level}: {one.label}")
                try:
                    known[key] = asdict(score(one.spec))
                except (ValueError, ArithmeticError) as error:
                    if one.trial is None:
                        raise
                    say(f"fidelity level {level}: {one.label} falls out: {error}")
                    continue
                with atomic_path(memo) as temporary:
                    temporary.write_text(json.dumps(known, indent=1), encoding="utf-8")
            one.levels[level] = _score_of(known[key], layouts[0], level)
            left.append(one)
    return left


def _score_of(kept: dict[str, Any], start: Promoted, level: str) -> FidelityScore:
    """A score that JSON kept, against the start's once that is there."""
    bounds_mm = tuple(kept["position_bounds_mm"])
    score = FidelityScore(
        **{name: kept[name] for name in SCORE_NAMES}, position_bounds_mm=bounds_mm
    )
    but = start.spec.search.limits.places_worse
    return score if but == 1 else against_start(start.levels.get(level, score), score, but)


_SCORER = ("sensor_chip",)
_SHELL = ("shell_thickness_mm", "silicone")


def _alike(spec: ObjectSpec, names: tuple[str, ...]) -> tuple[Any, ...]:
    """What layouts that share mechanics, or scorers, have in common."""
    choices = structure_choices(spec)
    return tuple(choices[name] for name in names)


@contextmanager
def lowest_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    found: dict[tuple[Any, ...], tuple[LayoutScorer, ...]] = {}

    def score(spec: ObjectSpec) -> FidelityScore:
        key = *_alike(spec, _SCORER + _SHELL), *spec.magnets.sizes
        if key not in found:
            found[key] = scorers(spec, each_alone(spec.body.sensed))
        return lowest_fidelity_score(spec, found[key])

    yield score


@contextmanager
def second_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    """One factorization for all layouts of a shell that follow each other."""
    try:
        yield second_score
    finally:
        forget_shell()


@contextmanager
def highest_scoring() -> Iterator[Callable[[ObjectSpec], FidelityScore]]:
    yield chain_score
