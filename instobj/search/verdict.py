"""Verdict on promoted layouts: merit compared with the start at a fidelity level, and objections."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from design.spec.learning import SATURATION_MARGIN
from design.spec.object import ObjectSpec
from design.spec.search import OBJECTIVES_TO_MAXIMIZE, OVER_LIMIT, SearchSpec
from estimator.layouts.fidelity import FidelityScore, regressed_share
from instobj.search.fidelity import TwinRatio

FIRST, SECOND, LAST = "1", "2", "3"
_EXCESS_WEIGHT = 10.0
"""Weight of exceeded limits compared with the logarithm of the objectives: limits come first."""


@dataclass(frozen=True)
class Promoted:
    """A promoted layout: its trial's number (None: the start) and its score at each level.

    A `corrected` one has walked on from that trial (`instobj.search.corrected`).
    """

    label: str
    trial: int | None
    spec: ObjectSpec
    levels: dict[str, FidelityScore]
    corrected: bool = False


@dataclass(frozen=True)
class Promotion:
    """Result of a promotion.

    `ratios` are those of the best against the start at the highest fidelity level, with 95 % intervals
    between toleranced twins. `objections` say why the highest fidelity level does not call the best one
    better than the start. `requested` are the numbers of leaders and finalists that should have been
    scored.

    Where the time ended before the chain had scored a finalist there is none, and the leaders begin
    with the one that it had come to.
    """

    start: Promoted
    leaders: tuple[Promoted, ...]
    finalists: tuple[Promoted, ...]
    ratios: dict[str, TwinRatio]
    objections: tuple[str, ...]
    requested: tuple[int, int]

    @property
    def shortened(self) -> str:
        """Return how many were scored, in words, where that is fewer than asked for."""
        scored = sum(not layout.corrected for layout in self.leaders), len(self.finalists)
        if scored == self.requested:
            return ""
        return (
            f"{scored[0]} of {self.requested[0]} leaders and {scored[1]} of "
            f"{self.requested[1]} finalists were "
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

    @property
    def gains(self) -> str:
        """Return what the best one gains over the start and what it costs, in one sentence."""
        return gains_in_words(self.start, self.best, self.level)


def merit(search: SearchSpec, layout: Promoted, start: Promoted, level: str) -> float:
    """Mean logarithm of the objectives over the start's, with what limits are exceeded: less is
    better, the start has 0."""
    exceeded = sum(excess(search, layout, start, level).values())
    return _mean_log(search, layout, start, level) + _EXCESS_WEIGHT * exceeded


def best_known(search: SearchSpec, promotion: Promotion) -> Promoted:
    """Return the best layout that is known: the start where what was found costs more than it gains."""
    start, best = promotion.start, promotion.best
    return start if merit(search, best, start, promotion.level) >= 0 else best


def best_in_words(search: SearchSpec, promotion: Promotion) -> str:
    """Return whether the best known layout is better than the start, and what the best one found gains."""
    best = promotion.best.label
    if promotion.better:
        return f"{best}, better than the start at the highest fidelity level: {promotion.gains}"
    if best_known(search, promotion) is promotion.start:
        return (
            "your own layout, unchanged, as nothing that was found is better. The best one found, "
            f"{best}: {promotion.gains}"
        )
    return (
        f"{best}, ahead of your own layout but not confirmed to be better, so search on before you build it: "
        f"{promotion.gains}"
    )


def excess(search: SearchSpec, layout: Promoted, start: Promoted, level: str) -> dict[str, float]:
    """Shares by which limits are exceeded."""
    reached = layout.levels[level]
    excesses = {
        "saturation_margin": SATURATION_MARGIN - reached.saturation_margin,
        "objects_margin": -reached.objects_margin,
    }
    for name, factor in search.limits.times_start.items():
        most = 1 / factor if name in OBJECTIVES_TO_MAXIMIZE else factor
        excesses[name] = _score_over_start(name, layout, start, level) / most - 1
    return {name: share for name, share in excesses.items() if share > 0}


def objections(
    search: SearchSpec, best: Promoted, start: Promoted, ratios: dict[str, TwinRatio]
) -> tuple[str, ...]:
    """Return what keeps a layout from being better at the highest fidelity level, in words; at the second one
    where the time ended before the highest."""
    reasons, level = [], LAST if LAST in best.levels else SECOND
    if level != LAST:
        reasons.append(
            "the time ended before the whole chain had scored it, these are scores of the second fidelity "
            "level: give more search.seconds and go on with --resume"
        )
    if _mean_log(search, best, start, level) >= 0:
        reasons.append("the objectives' mean is not better")
    for name, share in excess(search, best, start, level).items():
        if name == OVER_LIMIT:
            reasons.append(
                f"what got worse beyond limits.position_bound_mm = {best.spec.limits.position_bound_mm:g} "
                f"outweighs what got better: {name} misses its limit by {100 * share:.2g} %"
            )
        elif name == "saturation_margin":
            free, least = best.levels[level].saturation_margin, SATURATION_MARGIN
            reasons.append(
                f"{100 * free:.2g} % of the sensors' range stays free in the deepest press, less than "
                f"{100 * least:g} %"
            )
        elif name == "objects_margin":
            reasons.append(
                f"chips leave their range by {100 * share:.2g} % in the deepest press of more than 5 % of "
                "virtual objects"
            )
        else:
            reasons.append(f"{name} misses its limit by {100 * share:.2g} %")
    first = search.objectives[0]
    if level == LAST and not ratios:
        reasons.append("the time ended before virtual objects within tolerance were scored")
    if first in ratios and not ratios[first].low > 1:
        reasons.append(f"{first} is not better in 95 % of pairs of twins")
    return tuple(reasons)


def gains_in_words(start: Promoted, layout: Promoted, level: str) -> str:
    """Return a layout's bounds and the start's, the shares within the limit, and what got worse."""
    limit = layout.spec.limits.position_bound_mm
    start_score, layout_score = start.levels[level], layout.levels[level]
    bounds = bounds_in_words(
        *({name: score_at(name, who, level) for name in _BOUND_WORDS} for who in (start, layout))
    )
    within = (
        100 * np.nanmean(np.array(s.position_bounds_mm) <= limit)
        for s in (layout_score, start_score)
    )
    worse = 100 * regressed_share(start_score, layout_score)
    beyond = 100 * regressed_share(start_score, layout_score, limit)
    return (
        f"{bounds}; within the limit of {limit:g} mm lie "
        f"{' instead of '.join(f'{share:.0f} %' for share in within)} of locations and forces; "
        f"{worse:.0f} % got worse, {beyond:.0f} % beyond that limit"
    )


def bounds_in_words(start: Mapping[str, float], layout: Mapping[str, float]) -> str:
    """Return the worst and the median position bound of a layout instead of the start's; nothing without
    scores of the start."""
    return ", ".join(
        f"{words} {layout[name]:.3g} instead of {start[name]:.3g} mm"
        for name, words in _BOUND_WORDS.items()
        if name in start and name in layout
    )


_BOUND_WORDS = {"worst_position_bound_mm": "worst location", "median_position_bound_mm": "median"}


def _mean_log(search: SearchSpec, layout: Promoted, start: Promoted, level: str) -> float:
    logs = [np.log(_score_over_start(name, layout, start, level)) for name in search.objectives]
    return float(np.mean(logs))


def _score_over_start(name: str, layout: Promoted, start: Promoted, level: str) -> float:
    """A score over the start's, as something to minimise."""
    start_score, layout_score = (max(score_at(name, who, level), 1e-9) for who in (start, layout))
    value = layout_score / start_score
    return 1 / value if name in OBJECTIVES_TO_MAXIMIZE else value


def score_at(name: str, layout: Promoted, level: str) -> float:
    """A layout's score at a fidelity level."""
    return float(getattr(layout.levels[level], name))
