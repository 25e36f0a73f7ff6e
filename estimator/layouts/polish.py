"""Lowest fidelity of a layout search: value of a batch of layouts, and better ones from these.

A layout repeated on all faces is pressed on several of them; its score is that of the worst. Limits
that a layout breaks make it worth less, smoothly, so that every engine is led back inside.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import torch
from cmaes import CMA
from jaxtyping import Bool, Float, Int
from torch import Tensor

from design.spec.object import ObjectSpec
from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from estimator.layouts.batch_scores import OVER_START, PlaceBounds, batch_scores
from estimator.layouts.limits.rules import broken_limits_mm
from estimator.layouts.scoring import LayoutScorer, within_candidates
from estimator.layouts.vectors import LayoutSpace, layouts_at

PENALTY_PER_MM = 10.0
"""A limit broken by 0.1 mm doubles every objective, more than any layout gains by it."""
_MM_PER_EXCESS = 10.0
"""A score or channel beyond its limit by a tenth counts as a length broken by 1 mm."""
_LEARNING_RATE = 0.03
"""Of the unit cube: 1 mm in a range of 30."""

_SPREAD = 0.3
"""Standard deviation of a run's first generation, of the unit cube."""

Judge = Callable[[Float[Tensor, "layout variable"], Int[Tensor, "layout"]], "Judged"]
"""Judges points that belong to these layouts of a batch."""


@dataclass(frozen=True)
class Judged:
    """What layouts are worth: every objective as something to minimise, above 0.

    `broken_mm` is 0 where all limits are kept. `worse_mm` is above 0 where position bounds are larger
    than the start's at more places than `PlaceBounds.but` (`OVER_START` above 1), which the verdict
    refuses; as this level's bounds of single places are rough, that makes no layout one that breaks
    limits. `scores` are those of the lowest fidelity level, with the objectives that the
    structure alone decides.
    """

    objectives: Float[Tensor, "layout objective"]
    broken_mm: Float[Tensor, "layout"]
    worse_mm: Float[Tensor, "layout"]
    scores: dict[str, Float[Tensor, "layout"]]

    @property
    def penalties(self) -> Float[Tensor, "layout 2"]:
        """By what shares objectives grow for broken limits, and for worse places: each by itself, so that
        a limit is worth keeping though places are worse. Bounds a tenth over the start's double them,
        a tenth as steep as limits: the start lies at that border and must come away from it."""
        return torch.stack([PENALTY_PER_MM * self.broken_mm, self.worse_mm], dim=1)

    @property
    def penalized(self) -> Float[Tensor, "layout objective"]:
        """Objectives with their penalties."""
        return self.objectives * (1 + self.penalties).prod(dim=1, keepdim=True)


@dataclass(frozen=True)
class LowestFidelity:
    """Scorers of the pressed faces for one structure, and what the structure itself decides.

    `constants` are scores that all its layouts share; `at_most` bounds scores (`sensitivity_ratio`
    from below); `broken_mm` is what the structure breaks, in the currency of mm; `start` are the
    bounds that layouts are held against place by place.
    """

    space: LayoutSpace
    scorers: tuple[LayoutScorer, ...]
    constants: Mapping[str, float]
    at_most: Mapping[str, float]
    broken_mm: float = 0.0
    start: PlaceBounds | None = None


def judge(
    lowest: LowestFidelity,
    unit: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    objectives: tuple[str, ...],
) -> Judged:
    """Score layouts at points of the unit cube; differentiable."""
    of_face = {scorer.presses.face: scorer for scorer in lowest.scorers}
    laid = {face: layouts_at(lowest.space, unit, polarity, face) for face in of_face}
    near = {face: within_candidates(of_face[face], one) for face, one in laid.items()}
    named = {*objectives, *lowest.at_most}
    scores = batch_scores(
        lowest.scorers,
        [near[scorer.presses.face] for scorer in lowest.scorers],
        named,
        lowest.start,
    )
    for name, value in lowest.constants.items():
        scores[name] = torch.full_like(scores["worst_position_bound_mm"], value)
    told_at_once = bool(lowest.space.sensors)  # sensors that move: limits hold of all faces
    checked = list(laid.items())[: 1 if told_at_once else None]
    broken = torch.stack(
        [broken_limits_mm(lowest.space, one, face).sum(dim=1) for face, one in checked]
    )
    excess = _saturation(lowest.space.structured, scores["largest_resting_counts"])
    for name, most in lowest.at_most.items():
        excess = excess + torch.relu(_to_minimize(name, scores) / most - 1)
    broken = broken.amax(dim=0) + lowest.broken_mm + _MM_PER_EXCESS * excess
    worse = torch.zeros_like(broken)
    if lowest.start is not None:
        worse = _MM_PER_EXCESS * torch.relu(scores[OVER_START] - 1)
    worth = torch.stack([_to_minimize(name, scores) for name in objectives], dim=1)
    return Judged(worth.clamp(min=1e-9), broken, worse, scores)


def _to_minimize(name: str, scores: dict[str, Tensor]) -> Float[Tensor, "layout"]:
    return 1 / scores[name] if name in OBJECTIVES_TO_MAXIMIZE else scores[name]


def polish(
    judge_at: Judge,
    unit: Float[Tensor, "layout variable"],
    generations: int,
    weights: Float[Tensor, "layout objective"],
) -> Float[Tensor, "layout variable"]:
    """Better points by the weighted logarithms of the objectives, each by a CMA-ES of its own.

    A run begins round its point, with `population` layouts a generation. The penalty grows from a
    thousandth to all of it, so that early generations cross what later ones may not. No point ends
    worth less than it began, and none without a value is taken. Repeatable: a run's seed comes from
    its point.
    """
    rows = torch.arange(len(unit))
    ends = [_evolved(judge_at, unit[row], row, generations, weights[row]) for row in rows]
    return torch.stack(ends) if ends else unit


def population(variables: int) -> int:
    """Layouts of a generation: eight times CMA-ES's default (Hansen, arXiv:1604.00772), as limits
    leave many local optima."""
    return 8 * (4 + int(3 * np.log(max(variables, 2))))


def _evolved(
    judge_at: Judge,
    begin: Float[Tensor, "variable"],
    row: Int[Tensor, ""],
    generations: int,
    weights: Float[Tensor, "objective"],
) -> Float[Tensor, "variable"]:
    def worth(points: Tensor) -> tuple[Float[np.ndarray, "layout"], Float[np.ndarray, "layout 2"]]:
        """Logarithm without penalties, and the penalties."""
        with torch.no_grad():
            judged = judge_at(points, row.expand(len(points)))
        value = (judged.objectives.log() @ weights).double().nan_to_num(torch.inf).numpy()
        return value, judged.penalties.double().numpy()

    whole = float(weights.sum())
    count = max(len(begin), 2)  # the package takes no single variable
    mean = np.full(count, 0.5)
    mean[: len(begin)] = begin.numpy()
    seed = zlib.crc32(begin.numpy().tobytes())
    bounds = np.repeat([[0.0, 1.0]], count, axis=0)
    search = CMA(mean, _SPREAD, bounds=bounds, seed=seed, population_size=population(count))
    value, penalties = worth(begin[None])
    best, least = begin, float(value[0] + whole * np.log1p(penalties[0]).sum())
    for generation in range(generations):
        if search.should_stop():
            break
        asked = [search.ask() for _ in range(search.population_size)]
        points = torch.as_tensor(np.array(asked)[:, : len(begin)], dtype=begin.dtype)
        value, penalties = worth(points)
        share = _share_of_penalty(generation / generations)
        now = value + whole * np.log1p(share * penalties).sum(axis=1)
        search.tell(list(zip(asked, now.tolist(), strict=True)))
        finally_worth = value + whole * np.log1p(penalties).sum(axis=1)
        leader = int(finally_worth.argmin())
        if finally_worth[leader] < least:
            best, least = points[leader], float(finally_worth[leader])
    return best


def _share_of_penalty(progress: float) -> float:
    """A thousandth at first, all for the last fifth."""
    return 10 ** (-3 * max(0.0, 1 - progress / 0.8))


def descend(
    loss_at: Callable[[Tensor], Tensor],
    unit: Float[Tensor, "layout variable"],
    steps: int,
    rate: float = _LEARNING_RATE,
    over: Callable[[], bool] = lambda: False,
) -> Float[Tensor, "layout variable"]:
    """The best points on walks of `steps` (Adam) within the unit cube, each by itself, or of fewer once
    the time is `over`.

    No point ends worse than it began.
    """
    point = unit.clone().requires_grad_()
    walk = torch.optim.Adam([point], lr=rate)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(walk, max(steps, 1))
    best, least = unit.clone(), torch.full((len(unit),), torch.inf, dtype=unit.dtype)
    for step in range(steps + 1):
        loss = loss_at(point)
        better = loss.detach() < least
        least = torch.where(better, loss.detach(), least)
        best = torch.where(better[:, None], point.detach(), best)
        if over():
            break
        if step < steps:
            walk.zero_grad()
            loss.sum().backward()
            _forget_undefined(point)
            walk.step()
            schedule.step()
            with torch.no_grad():
                point.clamp_(0, 1)
    return best


def _forget_undefined(point: Tensor) -> None:
    """A layout whose gradient is not finite stays where it is."""
    if point.grad is not None:
        defined: Bool[Tensor, "layout"] = point.grad.isfinite().all(dim=1)
        point.grad.nan_to_num_(0.0, 0.0, 0.0).mul_(defined[:, None])


def _saturation(spec: ObjectSpec, counts: Float[Tensor, "layout"]) -> Float[Tensor, "layout"]:
    """Share by which channels at rest exceed what they may."""
    full = spec.sensors.range_mt * spec.sensors.counts_per_mt
    return torch.relu(counts / (full * spec.search.limits.resting_share) - 1)
