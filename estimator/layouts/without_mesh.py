"""Layouts scored and improved before there is a mesh: the lowest fidelity level on the presses of a layer.

`estimator.layouts.presses.layer` presses; fields, noise, bounds and limits are those of a search. Whole
chains of eleven bodies had 0.6 to 2.4 times the median bound and 0.3 to 1.9 times the 95th percentile
(docs/measured/bodies.md). On a coarse mesh of a box the lowest level with mechanics ranked 64 layouts nearly
alike (Spearman 0.82 for the median, 0.52 for the 95th percentile).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import torch
from jaxtyping import Float

from design.errors import InputError
from design.fit.parts import ROOMY
from design.layout.places.contact_places import contact_places
from design.search.faces import layout_groups
from design.search.places import polarities
from design.search.space import (
    SearchSpace,
    params_at,
    search_space,
    start_params,
    unit_of,
    with_layout,
)
from design.search.structure import with_structure
from design.spec.learning import SATURATION_MARGIN
from design.spec.object import ObjectSpec
from design.spec.search import OVER_LIMIT
from estimator.information.fisher import DETECTION_DISTANCE
from estimator.layouts.batch import layouts_of
from estimator.layouts.bounds import bounds
from estimator.layouts.polish import AFTER_ALL, Judged, LowestFidelity, descend, judge
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.presses.layer import layer_basis
from estimator.layouts.scorer import LayoutScorer, layout_scorer
from estimator.layouts.vectors import layout_space
from estimator.signals.hall import full_scale_counts

_OBJECTIVES = (OVER_LIMIT, "percentile_95_position_bound_mm", "median_position_bound_mm")
_WEIGHTS = (1.0, 0.5, 0.5)
"""Weights: what lies beyond the limit comes first; of layouts that keep it everywhere the finer one wins."""
_MOST_PLACES = 48
"""Contact locations of the largest face that are judged, at about this number. A coarser grid changes the
median by up to a third (tests)."""
ROUNDS = (
    *((0.1, 0.05), (0.1, 0.05), (0.1, 0.04), (0.07, 0.04)),
    *((0.05, 0.03), (0.05, 0.03), (0.03, 0.02), (0.02, 0.02)),
)
"""Rounds of walks: how far round the best layout so far they begin, and their first step, both as shares
of every variable's range."""
_WALKS, _STEPS = 16, 6
"""Walks side by side, and their steps: a step of 16 walks takes a fifth longer than one of 1. Six rounds of
ten steps were worth less in a box (by 0.15, three seeds) and as much on a ball (two); six of six were worth
0.2 less on the ball."""
_BACK = (1.0, 0.97, 0.93, 0.87, 0.8, 0.7, 0.6, 0.5, 0.35, 0.2)
"""Shares of the ways from a layout that keeps the limits to ends of walks, which often lie a hair beyond."""
BROKEN = AFTER_ALL / 2
"""Value above which a layout breaks a limit."""
MEDIAN_FACTOR = 2.5
"""Largest factor between forecast and chain in the medians of eleven bodies (docs/measured/bodies.md)."""
Points = Float[np.ndarray, "layout variable"]


@dataclass(frozen=True)
class FirstScore:
    """Position bounds (mm) of an object over its contact locations, at `score.force_n`, by a layer's presses:
    median, 95th percentile, and share within `limits.position_bound_mm`; share that feels a touch of
    `limits.detectable_force_n`, with signals in proportion to force; shares within the limit were all bounds
    `MEDIAN_FACTOR` times larger, and smaller."""

    median_mm: float
    percentile_95_mm: float
    within: float
    felt: float = 1.0
    within_range: tuple[float, float] = (0.0, 1.0)


def first_score(spec: ObjectSpec) -> FirstScore:
    """Score a specification without a mesh, on all sensed faces."""
    spec = coarse(spec)
    scorers = [layout_scorer(spec, layer_basis(spec, face)) for face in spec.body.sensed]
    position, signal = list[np.ndarray](), list[np.ndarray]()
    with torch.no_grad():
        for scorer in scorers:
            layouts = layouts_of(spec, scorer.presses.face)
            changes = press_changes(scorer, layouts).by_parameter
            position.append(bounds(changes[:, :, :3])[0].flatten().numpy())
            # the third is the change with force, in standard deviations per N
            signal.append(scorer.presses.force_n * changes[:, 0, 2].norm(dim=0).numpy())
    bound_mm, distance = np.concatenate(position), np.concatenate(signal)
    limits, share = spec.limits, spec.limits.detectable_force_n / spec.score.force_n
    within, least, most = (
        float(np.mean(factor * bound_mm <= limits.position_bound_mm))
        for factor in (1.0, MEDIAN_FACTOR, 1 / MEDIAN_FACTOR)
    )
    return FirstScore(
        float(np.median(bound_mm)),
        float(np.percentile(bound_mm, 95.0)),
        within,
        float(np.mean(share * distance >= DETECTION_DISTANCE)),
        (least, most),
    )


def coarse(spec: ObjectSpec) -> ObjectSpec:
    """With few contact locations, judged at `score.force_n` alone, and with all parts free to move."""
    grid = spec.contact_grid
    most = int(contact_places(spec).sum(axis=1).max())
    pitch = round(grid.pitch_mm * max(1.0, (most / _MOST_PLACES) ** 0.5), 2)
    return spec.changed(
        contact_grid=grid.changed(pitch_mm=pitch),
        search=spec.search.changed(forces_n=(spec.score.force_n,)),
    )


@dataclass(frozen=True)
class LevelWithoutMesh:
    """The lowest fidelity level of one structure on a layer's presses, and its own layout in it."""

    space: SearchSpace
    lowest: LowestFidelity
    start: dict[str, float]

    @classmethod
    def create(cls, spec: ObjectSpec) -> LevelWithoutMesh | None:
        """Return it; None where a shell or a face has no room for candidates."""
        wall = ROOMY * spec.silicone.thinnest_wall_mm
        space = search_space(spec.changed(silicone=spec.silicone.changed(thinnest_wall_mm=wall)))
        start = start_params(space)
        if start is None:
            return None
        structured = with_structure(space.spec, start)
        try:
            scorers = group_scorers(structured)
        except InputError:
            return None
        full = full_scale_counts(structured.sensors)
        limits = {"largest_counts": (1 - SATURATION_MARGIN) * full, "kept_counts": full}
        return cls(space, LowestFidelity(layout_space(space, structured), scorers, limits), start)

    @property
    def point(self) -> Points:
        """The specification's own, as one row of the unit cube."""
        return unit_of(self.space, self.start)[None]

    def _judged(self, points: torch.Tensor) -> Judged:
        poles = torch.tensor(polarities(self.lowest.space.structured, self.start))
        return judge(self.lowest, points, poles.expand(len(points), -1), _OBJECTIVES)

    def losses(self, points: Points) -> Float[np.ndarray, "layout"]:
        """Value of layouts, less for better: weighted logarithms of bounds, with broken limits."""
        with torch.no_grad():
            judged = self._judged(torch.as_tensor(points, dtype=torch.float32))
        return judged.loss(torch.tensor(_WEIGHTS)).nan_to_num(torch.inf).numpy()

    @property
    def gap_mm(self) -> float:
        """Silicone between pockets, where that is more than can be cast."""
        return self.lowest.space.gap_mm

    def with_gap(self, gap_mm: float) -> LevelWithoutMesh:
        """The same with as much silicone between pockets."""
        kept = replace(self.lowest, space=replace(self.lowest.space, gap_mm=gap_mm))
        return replace(self, lowest=kept)

    def walked(self, best: Float[np.ndarray, "1 variable"], number: int, seed: int = 0) -> Points:
        """Layouts on the ways from the `best` one so far to ends of walks down the gradient, which begin
        there and at places round it: round `number` of `ROUNDS`."""
        spread, rate = ROUNDS[number]
        drawn = np.random.default_rng((seed, number)).normal(0, spread, (_WALKS - 1, best.shape[1]))
        begin = np.concatenate([best, np.clip(best + drawn, 0, 1)])
        start = torch.as_tensor(begin, dtype=torch.float32)
        ends = descend(self._penalized, start, _STEPS, rate).numpy()
        return np.concatenate([best + share * (ends - best) for share in _BACK])

    def _penalized(self, points: torch.Tensor) -> torch.Tensor:
        """Value with broken limits, without the step between layouts that break limits and others."""
        return self._judged(points).penalized.log() @ torch.tensor(_WEIGHTS)

    def layout_at(self, point: Float[np.ndarray, "variable"]) -> ObjectSpec | None:
        """The specification with the layout of a point; None where it breaks a check."""
        from design.fabrication.layout import failures, layout_findings  # loads CadQuery, 2 s

        try:
            laid = with_layout(self.space.spec, params_at(self.space, point))
        except InputError:
            return None
        return None if failures(layout_findings(laid)) else laid


def group_scorers(spec: ObjectSpec) -> tuple[LayoutScorer, ...]:
    """A scorer of the first face of every size, which stands for the others of that size."""
    return tuple(
        layout_scorer(spec, layer_basis(spec, group[0]), faces=len(group))
        for group in layout_groups(spec)
    )
