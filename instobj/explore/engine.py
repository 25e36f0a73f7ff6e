"""One design after another at the lowest fidelity level of the search, as quick as a hand moves parts.

The mechanics is that of the shell without magnets (stage `candidates`), which the search uses too. Only
scorers are made anew for a design, so an edit takes milliseconds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from design.search.structure import size_variants
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from estimator.information.fisher import DETECTION_DISTANCE, cramer_rao_bounds
from estimator.layouts.batch import Layouts, layouts_of
from estimator.layouts.bounds import bounds
from estimator.layouts.presses.basis import PressBasis, press_bases
from estimator.layouts.presses.changes import PressChanges, press_changes
from estimator.layouts.presses.counts import counts_when_pressed
from estimator.layouts.scorer import (
    LayoutScorer,
    layout_scorer,
    require_scorable,
    within_candidates,
)
from estimator.signals.hall import full_scale_counts
from fem.candidates.motions import load_candidates
from instobj.stages.run import Run

FORCES_N = (1.0, 2.0, 3.0, 5.0, 8.0, 12.0)
"""Forces that a person may choose."""


@dataclass(frozen=True)
class Judgement:
    """Figures of a design at every contact location of the grid; NaN at places that a face has not.

    Attributes
    ----------
    position_bound_mm, force_bound_n : Cramér–Rao bounds at `force_n`, of the face's own channels
    beyond : whether a part lies where its motions are not known, and was taken at the nearest place that is
    """

    force_n: float
    position_bound_mm: Float[np.ndarray, "face place"]
    force_bound_n: Float[np.ndarray, "face place"]
    beyond: bool


@dataclass(frozen=True)
class Summary:
    """Median, 95th percentile and worst of a figure, and where the worst is (row of the face, place)."""

    median: float
    percentile_95: float
    worst: float
    face: int
    place: int


@dataclass(frozen=True)
class Pressed:
    """What the chips of a face tell of presses at every place of the grid: change in counts, its noise (one
    standard deviation), and the covariance of the place that is told (mm²); NaN where nothing is."""

    counts: Float[np.ndarray, "place sensor 3"]
    noise_counts: Float[np.ndarray, "3"]
    position_mm2: Float[np.ndarray, "place 2 2"]


@dataclass(frozen=True)
class Explorer:
    """The mechanics of one shell, for any layout of magnets and sensors in it; `open_explorer` makes it.

    `presses` by face: of each size of magnet the presses to every one of `forces_n`.
    """

    spec: ObjectSpec
    forces_n: tuple[float, ...]
    presses: Mapping[int, Sequence[tuple[PressBasis, ...]]]

    @property
    def grid(self) -> PlaceGrid:
        """Contact locations of the grid; a face may have some of them only."""
        return next(iter(self.presses.values()))[0][0].places

    @one_thread()
    def judge(self, design: ObjectSpec, force_n: float) -> Judgement:
        """Bounds of a design that differs in magnets' and sensors' places, poles and grades, or in chips.

        Raises
        ------
        InputError
            Another force, or what `require_scorable` refuses.
        """
        require_scorable(design)
        told = {face: self._told(design, face, [force_n]) for face in self.presses}
        found = {face: bounds(one.changes[0].by_parameter[:, :, :3]) for face, one in told.items()}
        position, force = (
            np.stack([self._on_grid(face, both[which][0]) for face, both in found.items()])
            for which in (0, 1)
        )
        return Judgement(force_n, position, force, any(one.beyond for one in told.values()))

    @one_thread()
    def least_forces_n(self, design: ObjectSpec) -> Float[np.ndarray, "face place"]:
        """Return forces at which the signal stands five sigma off rest, straight between `forces_n`;
        infinite where the largest of them does not reach that, NaN as in `judge`."""
        found = []
        for face in self.presses:
            changes = self._told(design, face, self.forces_n).changes
            found.append(self._on_grid(face, _crossings_n(self.forces_n, changes)[0]))
        return np.stack(found)

    @one_thread()
    def range_used(self, design: ObjectSpec) -> float:
        """Return the largest counts, at rest and in the deepest presses, over the chips' full scale."""
        told = (self._told(design, face, self.forces_n[-1:]) for face in self.presses)
        return max(one.largest_counts for one in told) / full_scale_counts(design.sensors)

    @one_thread()
    def press(self, design: ObjectSpec, face: int, force_n: float) -> Pressed:
        """Return what the chips of a face tell of presses on it.

        Raises
        ------
        InputError
            As `judge`, or a face that is not sensed.
        """
        if face not in self.presses:
            raise InputError(f"face {face} is not sensed. Press one of {list(self.presses)}")
        told = self._told(design, face, [force_n])
        there, sigma = self.presses[face][0][0].there, told.scorers[0].sigma_counts.double().numpy()
        # (place, channel, x y F and the change itself), in standard deviations of each channel
        white = told.changes[0].by_parameter[:, 0].permute(2, 0, 1).double().numpy()
        found = cramer_rao_bounds(white[:, :, :3], np.ones(white.shape[1]))
        counts = np.full((len(there), white.shape[1] // 3, 3), np.nan)
        counts[there] = white[:, :, 3].reshape(len(white), -1, 3) * sigma
        position = np.full((len(there), 2, 2), np.nan)
        position[there] = found.position_mm2
        return Pressed(counts, sigma, position)

    def _told(self, design: ObjectSpec, face: int, forces_n: Sequence[float]) -> _Told:
        """Return what presses of a face change in a design, force by force."""
        judged = design.for_scoring
        numbers = [self._index_of(force) for force in forces_n]
        of_force = [[of_size[number] for of_size in self.presses[face]] for number in numbers]
        scorers = [layout_scorer(judged, of_sizes) for of_sizes in of_force]
        layouts = layouts_of(design, face)
        inside = within_candidates(scorers[0], layouts)
        with torch.no_grad():
            return _Told(scorers, inside, [press_changes(one, inside) for one in scorers], layouts)

    def _on_grid(self, face: int, values: Float[torch.Tensor, "own"]) -> Float[np.ndarray, "place"]:
        there = self.presses[face][0][0].there
        on_grid = np.full(len(there), np.nan)
        on_grid[there] = values.double().numpy()
        return on_grid

    def _index_of(self, force_n: float) -> int:
        if force_n not in self.forces_n:
            raise InputError(
                f"no presses to {force_n:g} N are at hand. Choose one of "
                f"{', '.join(f'{one:g}' for one in self.forces_n)} N"
            )
        return self.forces_n.index(force_n)


@dataclass(frozen=True)
class _Told:
    """Presses of one face of a design, force by force."""

    scorers: Sequence[LayoutScorer]
    layouts: Layouts
    changes: Sequence[PressChanges]
    asked: Layouts

    @property
    def largest_counts(self) -> float:
        """Of any own channel, at rest and in the deepest presses."""
        with torch.no_grad():
            pressed = counts_when_pressed(self.scorers[-1], self.layouts, self.changes[-1]).counts
        return max(float(one.abs().max()) for one in (pressed, self.changes[-1].resting_counts))

    @property
    def beyond(self) -> bool:
        """Whether a part was taken at the nearest place whose motions are known."""
        parts = [
            (self.layouts.of(face), self.asked.of(face)) for face in self.asked.by_face or (0,)
        ]
        return not all(
            torch.equal(a.magnet_mm, b.magnet_mm) and torch.equal(a.sensor_mm, b.sensor_mm)
            for a, b in parts
        )


def _crossings_n(
    forces_n: Sequence[float], changes: Sequence[PressChanges]
) -> Float[torch.Tensor, "layout place"]:
    """Return the forces at which signals stand `DETECTION_DISTANCE` off rest: straight between forces,
    infinite where the largest one does not reach it."""
    # Mahalanobis distance √(ΔSᵀ Σ⁻¹ ΔS) at 0 and at every force; changes are whitened already.
    distance = torch.stack([one.by_parameter[:, :, 3].norm(dim=0) for one in changes])
    distance = torch.cat([torch.zeros_like(distance[:1]), distance])
    force = torch.tensor([0.0, *forces_n])
    after = (distance >= DETECTION_DISTANCE).int().argmax(dim=0)  # 0 where none reaches it
    high = distance.gather(0, after[None])[0]
    low = distance.gather(0, (after - 1).clamp(min=0)[None])[0]
    share = (DETECTION_DISTANCE - low) / torch.where(high > low, high - low, 1.0)
    below, above = force[(after - 1).clamp(min=0)], force[after]
    return torch.where(after > 0, below + share * (above - below), torch.inf)


def summary_of(values: Float[np.ndarray, "face place"]) -> Summary:
    """Summarize a figure over all places that there are."""
    known = np.asarray(values[~np.isnan(values)])
    face, place = np.unravel_index(np.nanargmax(values), values.shape)
    middle, high = np.percentile(known, (50, 95)) if np.isfinite(known).all() else _ranks(known)
    return Summary(float(middle), float(high), float(known.max()), int(face), int(place))


def _ranks(known: Float[np.ndarray, "place"]) -> tuple[float, float]:
    """Return median and 95th percentile where some are infinite, between which nothing is interpolated."""
    middle, high = np.percentile(known, (50, 95), method="higher")
    return middle, high


def open_explorer(spec: ObjectSpec, forces_n: Sequence[float] = FORCES_N) -> Explorer:
    """Set up the mechanics of a specification's shell, made anew where none is stored: minutes.

    Raises
    ------
    InputError
        What the lowest level cannot score (`require_scorable`), or mechanics that fails.
    """
    require_scorable(spec)
    tables = [
        (variant, load_candidates(Run(variant, checked=False).require("candidates").folder))
        for variant in size_variants(spec)
    ]
    presses = {
        face: [press_bases(variant, motions, face, forces_n) for variant, motions in tables]
        for face in spec.body.sensed
    }
    return Explorer(spec, tuple(forces_n), presses)
