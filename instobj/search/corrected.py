"""Walks of leaders at the lowest fidelity level, corrected by what the second one said of them.

Space mapping (Bandler et al., IEEE Trans. Microw. Theory Tech. 42, 1994): near a layout, scores are
those of the lowest level times what the second one made of them there, and so are their limits. What the
lowest level leaves out of the mechanics then counts, as far as it changes little on a short walk: of nineteen
leaders that had walked, on cubes, boxes, handles, pears and boards in the shell, the second level's bounds
over the start's, where they were largest, were 0.90 to 1.08 times what bounds so corrected foretold.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import torch

from design.search.places import polarities
from design.search.space import SearchSpace, params_at, unit_of
from estimator.layouts.fidelity import MARGINS
from estimator.layouts.polish import Judged, LowestFidelity, judge, walk
from instobj.search.lowest_fidelity import StartScores, misfit_of, structure_fidelity
from instobj.search.verdict import FIRST, SECOND, Promoted, score_at

_REACH = 0.04
"""Share of every variable's range, to either side: how far the correction is trusted."""
_STEPS, _RATE = 300, 0.05
_SPREAD = (0.0, 0.02, 0.05, 0.1)
"""Shares of that reach (rms): where copies of the layout begin."""
_CHAIN_OVER_WALKED = 1.07
"""Largest counts over what the second level makes of the leader's: of twelve walked finalists 0.91
to 1.064."""


def corrected_params(
    space: SearchSpace,
    params: Mapping[str, Any],
    start: Promoted,
    layout: Promoted,
    over: Callable[[], bool] = lambda: False,
) -> dict[str, Any] | None:
    """Variables of the layout after its walk; None where nothing near it is better within all limits.

    `start` and `layout` hold the scores of both levels. The walk ends where it is once the time is `over`.
    """
    lowest = corrected_fidelity(space, params, start, layout)
    free = np.array([not v.choices for v in space.variables])
    if not free.any():
        return None
    unit, objectives = unit_of(space, params), space.spec.search.objectives
    centre = torch.as_tensor(unit[free], dtype=torch.float32)
    poles = torch.tensor([polarities(lowest.space.structured, params)]).expand(len(_SPREAD), -1)

    def judged_at(near: torch.Tensor) -> Judged:
        point = (centre + _REACH * (2 * near - 1)).clamp(0, 1)
        return judge(lowest, point, poles[: len(point)], objectives)

    weights = torch.ones(len(objectives))
    rng = np.random.default_rng(space.spec.seed)
    away = np.array(_SPREAD)[:, None] * rng.normal(size=(len(_SPREAD), int(free.sum())))
    begin = torch.as_tensor(0.5 + 0.5 * away, dtype=torch.float32).clamp(0, 1)
    walked = walk(judged_at, begin, weights, _STEPS, _RATE, over)
    with torch.no_grad():
        judged = judged_at(walked)
        broken, worth = judged.broken_mm, judged.loss(weights)
        loss_before = float(judged_at(torch.full_like(walked[:1], 0.5)).loss(weights))
    for row in worth.argsort().tolist():
        unit[free] = (centre + _REACH * (2 * walked[row] - 1)).clamp(0, 1).numpy()
        chosen = {v.name: params[v.name] for v in space.variables if v.choices}
        walked_params = params_at(space, unit) | chosen
        if float(worth[row]) >= loss_before:
            return None
        if float(broken[row]) == 0 and not misfit_of(space.spec, walked_params):
            return walked_params
    return None


def corrected_fidelity(
    space: SearchSpace, params: Mapping[str, Any], start: Promoted, layout: Promoted
) -> LowestFidelity:
    """The lowest level with a start that the layout compares with as it does at the second one.

    The start's scores at the second level, times the layout's at the lowest over those at the second.
    """
    limited = space.spec.search.limits.times_start
    scores = {name: _corrected(name, start, layout) for name in limited}
    corrected_start = StartScores(scores, _counts_over_lowest(layout))
    return structure_fidelity(space, dict(params), corrected_start)


def _counts_over_lowest(layout: Promoted) -> float:
    low, high = (
        np.array([1 - getattr(layout.levels[level], name) for name in MARGINS])
        for level in (FIRST, SECOND)
    )
    return _CHAIN_OVER_WALKED * float(np.max(high / low))


def _corrected(name: str, start: Promoted, layout: Promoted) -> float:
    low, high = (score_at(name, layout, level) for level in (FIRST, SECOND))
    return score_at(name, start, SECOND) * (low / high)
