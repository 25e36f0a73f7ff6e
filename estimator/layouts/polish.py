"""Lowest fidelity of a layout search: value of a batch of layouts, and better ones from these.

A layout repeated on all faces is pressed on several of them; the worst gives its score. Limits
that a layout breaks make it worth less, smoothly, so that every engine is led back inside.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from cmaes import CMA
from jaxtyping import Bool, Float, Int
from torch import Tensor

from design.spec.search import OBJECTIVES_TO_MAXIMIZE
from estimator.field.device import one_thread
from estimator.layouts.batch_scores import batch_scores
from estimator.layouts.limits.rules import constraint_violations_mm
from estimator.layouts.scorer import LayoutScorer, clamp_to_candidates
from estimator.layouts.vectors import LayoutSpace, layouts_at

PENALTY_PER_MM = 10.0
"""A limit broken by 0.1 mm doubles every objective, more than any layout gains by it."""
MM_PER_EXCESS = 10.0
"""A score or channel beyond its limit by a tenth counts as a length broken by 1 mm."""
AFTER_ALL = 100.0
"""More than logarithms of bounds differ by; it has no slope."""
ROUNDING_MM = 2e-3
"""Excess over a limit below which it counts as kept. Walks and runs keep limits to the last bit; in another
batch the same layout's places differ by 1e-5 mm, its position bounds by up to 1.2e-4 of themselves
(`estimator.layouts.bounds`), which counts tenfold. Rules of places keep ten times as much free, `SLACK_MM`;
scores and prices exceed their limits by 0.02 % at most."""
_LEARNING_RATE = 0.03
"""Learning rate in the unit cube: 1 mm in a range of 30."""

SPREAD = 0.3
"""Standard deviation of a run's first generation, of the unit cube."""
_MEAN, _NARROW = 8, 4
"""Layouts of a generation in the mean of a run, and at most in its second half, over CMA-ES's default
(Hansen, arXiv:1604.00772)."""
_GENERATIONS = 200
"""Least generations of each half of a run, unless generations would be smaller than CMA-ES's default. Limits
leave many local optima: broad generations choose among them, if there are enough to learn from."""
_EASED: Mapping[str, str] = dict.fromkeys(
    ("worst_position_bound_mm", "percentile_99_position_bound_mm"),
    "percentile_95_position_bound_mm",
)
"""Objectives of early generations instead of the ones that a few places decide."""
_LAYOUTS_OF_A_CARD = 8192
"""Judged at once on a graphics card: at two faces and three forces 5 GB of its memory."""

Judge = Callable[[Float[Tensor, "layout variable"], Int[Tensor, "layout"]], "Judged"]
"""Judges points that belong to these layouts of a batch."""


@dataclass(frozen=True)
class Judged:
    """Worth of layouts: every objective as something to minimise, above 0.

    `broken` holds the excess over every limit (`RULES`, then scores), 0 where it is kept to the last
    bit. `scores` are those of the lowest fidelity level. `eased`:
    the objectives, with the 95th percentile where few places decide.
    """

    objectives: Float[Tensor, "layout objective"]
    broken: Float[Tensor, "layout limit"]
    scores: dict[str, Float[Tensor, "layout"]]
    eased: Float[Tensor, "layout objective"]

    @property
    def broken_mm(self) -> Float[Tensor, "layout"]:
        """Return the sum of all excesses over limits; 0 where all are kept, within rounding."""
        return torch.where(self.broken > ROUNDING_MM, self.broken, 0).sum(dim=1)

    @property
    def penalty(self) -> Float[Tensor, "layout"]:
        """Share by which objectives grow for broken limits."""
        return PENALTY_PER_MM * self.broken.sum(dim=1)

    @property
    def penalized(self) -> Float[Tensor, "layout objective"]:
        """Objectives with their penalty."""
        return self.objectives * (1 + self.penalty)[:, None]

    def loss(self, weights: Float[Tensor, "objective"]) -> Float[Tensor, "layout"]:
        """Weighted logarithms of penalised objectives, for walks: what breaks a limit, be it by a hair,
        comes after all that keep them."""
        return self.penalized.log() @ weights + AFTER_ALL * (self.broken > 0).any(dim=1)


@dataclass(frozen=True)
class LowestFidelity:
    """Scorers of the pressed faces for one structure.

    `at_most` bounds what `batch_scores` gives (`sensitivity_ratio` from below).
    """

    space: LayoutSpace
    scorers: tuple[LayoutScorer, ...]
    at_most: Mapping[str, float]


@one_thread()
def judge(
    lowest: LowestFidelity,
    unit: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    objectives: tuple[str, ...],
) -> Judged:
    """Score layouts at points of the unit cube; differentiable."""
    of_face = {scorer.presses.face: scorer for scorer in lowest.scorers}
    first = next(iter(of_face))
    laid = {first: layouts_at(lowest.space, unit, polarity, first)}
    near = {first: clamp_to_candidates(of_face[first], laid[first])}
    for face in [*of_face][1:]:
        if laid[first].by_face:  # layouts of all faces: parts are placed once
            laid[face], near[face] = (each[first].seen_from(face) for each in (laid, near))
        else:
            laid[face] = layouts_at(lowest.space, unit, polarity, face)
            near[face] = clamp_to_candidates(of_face[face], laid[face])
    named = {*objectives, *lowest.at_most}
    scores = batch_scores(
        lowest.scorers,
        [near[scorer.presses.face] for scorer in lowest.scorers],
        named,
    )
    told_at_once = bool(lowest.space.sensors)  # sensors that move: limits hold of all faces
    checked = list(laid.items())[: 1 if told_at_once else None]
    of_places = torch.stack(
        [
            constraint_violations_mm(lowest.space, layouts_of_face, face)
            for face, layouts_of_face in checked
        ]
    )
    of_scores = [
        MM_PER_EXCESS * _excess(_to_minimize(name, scores) / most)
        for name, most in lowest.at_most.items()
    ]
    broken = torch.cat(
        [of_places.amax(dim=0), *(layouts_of_face[:, None] for layouts_of_face in of_scores)], dim=1
    )
    worth, eased = (
        torch.stack([_to_minimize(name, scores) for name in names], dim=1).clamp(min=1e-9)
        for names in (objectives, [_EASED.get(name, name) for name in objectives])
    )
    return Judged(worth, broken, scores, eased)


def _excess(shares: Float[Tensor, "layout"]) -> Float[Tensor, "layout"]:
    """Return by how much shares are above 1.

    Slopes are 0 where none is: on a processor they are left out then, a sixth of a walk's step. A graphics
    card would have to wait for the answer.
    """
    excess = torch.relu(shares - 1)
    return excess.detach() if excess.is_cpu and not excess.any() else excess


def _to_minimize(name: str, scores: dict[str, Tensor]) -> Float[Tensor, "layout"]:
    return 1 / scores[name] if name in OBJECTIVES_TO_MAXIMIZE else scores[name]


@one_thread()
def polish(
    judge_at: Judge,
    unit: Float[Tensor, "layout variable"],
    generations: int,
    weights: Float[Tensor, "layout objective"],
    over: Callable[[], bool] = lambda: False,
) -> Float[Tensor, "layout variable"]:
    """Better points by the weighted logarithms of the objectives, each by a CMA-ES of its own.

    A run begins round its point, in broad generations and then in narrow ones (`populations`);
    `runs_together` of them are judged side by side. In its first half the penalty grows from a
    thousandth to all of it, so that early generations cross what later ones may not; what a few places
    decide gives way to the 95th percentile at first, whose slope is smoother. Runs that are too short for
    broad generations are plain CMA-ES. No point ends worth less than it began, but that what keeps all limits
    goes before what breaks one by a hair; none breaks a limit more than it began, and none without a value is
    taken. Repeatable: a run's seed comes from its point; no generation begins once the time is `over`.
    """
    sizes = populations(unit.shape[1], generations)
    runs = [Evolution(row, unit[row], weights[row]) for row in range(len(unit))]
    together = runs_together(unit.device, max(sizes, default=1))
    for first in range(0, len(runs), together):
        _evolve(judge_at, runs[first : first + together], sizes, over)
    return torch.stack([run.best for run in runs]) if runs else unit


def population(variables: int) -> int:
    """Layouts of a generation in the mean: as many generations of this size are one run."""
    return _MEAN * _default_population(variables)


def populations(variables: int, generations: int) -> list[int]:
    """Layouts of every generation of a run, which has `generations` times `population` of them, or somewhat
    more or less, as its halves are whole generations."""
    default = _default_population(variables)
    half = generations * _MEAN * default // 2
    narrow = min(max(half // _GENERATIONS, default), _NARROW * default)
    broad = max(narrow, half // _GENERATIONS)
    return [broad] * -(-half // broad) + [narrow] * (half // narrow)


def _default_population(variables: int) -> int:
    return 4 + int(3 * np.log(max(variables, 2)))


def runs_together(device: torch.device, generation: int) -> int:
    """Return how many runs are judged in one batch, with generations of at most this many layouts.

    One on a processor, whose caches that fills.
    """
    return 1 if device.type == "cpu" else max(1, _LAYOUTS_OF_A_CARD // generation)


class Generations(CMA):
    """CMA-ES of the package whose generations are drawn at once.

    A point out of bounds is drawn again up to a hundred times, then moved to the bounds, as in the
    package; there one after the other, which took as long as judging a tenth of the points.
    """

    def ask_all(self) -> Float[np.ndarray, "point variable"]:
        """A generation."""
        axes, deviations = self._eigen_decomposition()
        points = np.empty((self.population_size, self.dim))
        low, high = np.asarray(self._bounds).T
        wanted = np.arange(len(points))
        for _ in range(1 + self._n_max_resampling):
            drawn = self._rng.standard_normal((len(wanted), self.dim))
            points[wanted] = self._mean + self._sigma * (drawn * deviations) @ axes.T
            within = ((points[wanted] >= low) & (points[wanted] <= high)).all(axis=1)
            wanted = wanted[~within]
            if not len(wanted):
                break
        return np.clip(points, low, high)

    def resize(self, size: int) -> Generations:
        """Return the same distribution for generations of `size` points."""
        if size == self.population_size:
            return self
        generations = Generations(
            self._mean.copy(),
            self._sigma,
            bounds=self._bounds,
            seed=int(self._rng.randint(2**31)),
            population_size=size,
            cov=self._C.copy(),
        )
        generations._p_sigma, generations._pc = self._p_sigma, self._pc
        return generations


class Evolution:
    """A run of CMA-ES round one layout of a batch."""

    def __init__(
        self, row: int, begin: Float[Tensor, "variable"], weights: Float[Tensor, "objective"]
    ) -> None:
        self.row, self.begin, self.weights = row, begin, weights.cpu()
        self.best, self.least, self.whole = begin, np.inf, float(weights.sum())
        self.begun: Tensor | None = None
        count = max(len(begin), 2)  # the package takes no single variable
        mean = np.full(count, 0.5)
        mean[: len(begin)] = begin.cpu().numpy()
        self.search = Generations(
            mean,
            SPREAD,
            bounds=np.repeat([[0.0, 1.0]], count, axis=0),
            seed=zlib.crc32(begin.cpu().numpy().tobytes()),
            population_size=population(count),
        )

    def ask(self, size: int) -> Float[Tensor, "layout variable"]:
        """The next generation."""
        self.search = self.search.resize(size)
        self._asked = self.search.ask_all()
        points = self._asked[:, : len(self.begin)]
        return torch.as_tensor(points, dtype=self.begin.dtype, device=self.begin.device)

    def tell(self, worth: Worth, progress: float) -> None:
        """Tell what the generation is worth, eased and with a share of the penalty."""
        objective_share, share = share_of_objective(progress), share_of_penalty(progress)
        with np.errstate(invalid="ignore"):  # no share of what is infinite
            value = objective_share * worth.value + (1 - objective_share) * worth.eased
        value = np.where(np.isfinite(worth.value) & np.isfinite(worth.eased), value, np.inf)
        now = value + self.whole * np.log1p(share * worth.penalty)
        self.search.tell(list(zip(self._asked, now.tolist(), strict=True)))

    def keep_best(self, worth: Worth) -> None:
        """The best so far that keeps all limits, before others, with all of the penalty; none
        that breaks a limit more than the run's own point, which is the first to be judged."""
        self.begun = worth.broken if self.begun is None else self.begun
        finally_worth = worth.value + self.whole * np.log1p(worth.penalty)
        finally_worth += AFTER_ALL * (worth.penalty > 0)
        finally_worth[_break_more(worth.broken, self.begun).numpy()] = np.inf
        leader = int(finally_worth.argmin())
        if finally_worth[leader] < self.least:
            self.best, self.least = worth.points[leader], float(finally_worth[leader])


@dataclass(frozen=True)
class Worth:
    """Worth of points of one run: weighted logarithms of the objectives, as they are and eased, penalty, and
    broken limits."""

    points: Float[Tensor, "layout variable"]
    value: Float[np.ndarray, "layout"]
    eased: Float[np.ndarray, "layout"]
    penalty: Float[np.ndarray, "layout"]
    broken: Float[Tensor, "layout limit"]


def _evolve(
    judge_at: Judge, runs: Sequence[Evolution], sizes: Sequence[int], over: Callable[[], bool]
) -> None:
    """Runs side by side, each as if alone, in generations of these sizes, until the time is `over`."""
    for run, worth in _judged(judge_at, runs, [run.begin[None] for run in runs]):
        run.keep_best(worth)
    begun = np.cumsum([0, *sizes])
    plain = bool(runs) and max(sizes, default=0) <= _default_population(len(runs[0].begin))
    for size, evaluated in zip(sizes, begun[:-1], strict=True):
        going = [run for run in runs if not run.search.should_stop()]
        if not going or over():
            break
        for run, worth in _judged(judge_at, going, [run.ask(size) for run in going]):
            run.tell(worth, 1.0 if plain else float(evaluated / begun[-1]))
            run.keep_best(worth)


def _judged(
    judge_at: Judge, runs: Sequence[Evolution], points: Sequence[Float[Tensor, "_ variable"]]
) -> Iterator[tuple[Evolution, Worth]]:
    """Points of every run, judged in one batch."""
    counts = [len(of_run) for of_run in points]
    rows = torch.tensor(np.repeat([run.row for run in runs], counts), device=points[0].device)
    with torch.no_grad():
        judged = judge_at(torch.cat(list(points)), rows)
    parts = judged.objectives.log(), judged.eased.log(), judged.penalty.double(), judged.broken
    of_runs = (part.cpu().split(counts) for part in parts)
    for run, trial_points, *logs, penalty, broken in zip(runs, points, *of_runs, strict=True):
        value, eased = ((log @ run.weights).double().nan_to_num(torch.inf).numpy() for log in logs)
        yield run, Worth(trial_points, value, eased, penalty.numpy(), broken)


def share_of_penalty(progress: float) -> float:
    """A thousandth at first, all for the second half."""
    return 10 ** (-3 * max(0.0, 1 - 2 * progress))


def share_of_objective(progress: float) -> float:
    """None at first, all for the second half."""
    return min(1.0, 2 * progress)


def _break_more(
    broken: Float[Tensor, "layout limit"], begun: Float[Tensor, "_ limit"]
) -> Bool[Tensor, "layout"]:
    return (broken > begun).any(dim=1)


@one_thread()
def walk(
    judged_at: Callable[[Tensor], Judged],
    begin: Float[Tensor, "layout variable"],
    weights: Float[Tensor, "objective"],
    steps: int,
    rate: float,
    over: Callable[[], bool] = lambda: False,
) -> Float[Tensor, "layout variable"]:
    """Return points as `descend`, by what layouts are worth; none breaks a limit more than its start.

    The way may lead through broken limits. Where nothing on it keeps what the beginning kept, the beginning
    is the end, however sums are rounded.
    """
    with torch.no_grad():
        begun = judged_at(begin).broken

    def loss(point: Float[Tensor, "layout variable"]) -> Float[Tensor, "layout"]:
        judged = judged_at(point)
        # infinity has no slope and is never the least
        refused = torch.where(_break_more(judged.broken, begun), torch.inf, 0.0)
        return judged.loss(weights) + refused

    return descend(loss, begin, steps, rate, over)


@one_thread()
def descend(
    loss_at: Callable[[Tensor], Tensor],
    unit: Float[Tensor, "layout variable"],
    steps: int,
    rate: float = _LEARNING_RATE,
    over: Callable[[], bool] = lambda: False,
) -> Float[Tensor, "layout variable"]:
    """The best points on walks of `steps` (Adam) within the unit cube, each by itself, or of fewer once
    the time is `over`.

    No point ends worse than it began. Steps shrink along half a cosine. Written out: PyTorch's optimizers
    load its compiler, which takes 1.5 s.
    """
    point, mean, square = unit.clone(), torch.zeros_like(unit), torch.zeros_like(unit)
    best, least = unit.clone(), torch.full((len(unit),), torch.inf, dtype=unit.dtype)
    for step in range(steps + 1):
        loss = loss_at(point.requires_grad_())
        better = loss.detach() < least
        least = torch.where(better, loss.detach(), least)
        best = torch.where(better[:, None], point.detach(), best)
        if over() or step == steps:
            break
        (slope,) = torch.autograd.grad(loss.sum(), point)
        slope = _defined(slope)
        # Kingma and Ba (arXiv:1412.6980), algorithm 1: means of slopes and of their squares, unbiased
        mean.lerp_(slope, 1 - _KEPT_SLOPE)
        square.mul_(_KEPT_SQUARE).addcmul_(slope, slope, value=1 - _KEPT_SQUARE)
        size = rate * (1 + np.cos(np.pi * step / steps)) / 2 / (1 - _KEPT_SLOPE ** (step + 1))
        scale = (square / (1 - _KEPT_SQUARE ** (step + 1))).sqrt() + 1e-8
        point = (point.detach() - size * mean / scale).clamp(0, 1)
    return best


_KEPT_SLOPE, _KEPT_SQUARE = 0.9, 0.999
"""Shares of the means that a step of Adam keeps (β₁, β₂), its authors' defaults."""


def _defined(slope: Float[Tensor, "layout variable"]) -> Float[Tensor, "layout variable"]:
    """A layout whose slope is not finite stays where it is."""
    defined: Bool[Tensor, "layout"] = slope.isfinite().all(dim=1)
    return torch.where(defined[:, None], slope, 0.0)
