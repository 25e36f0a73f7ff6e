"""One design after another at the lowest fidelity level of the search, as quick as a hand moves parts.

The mechanics of the shell without magnets (stage `candidates`) is the search's. A design needs new scorers
only, so an edit takes milliseconds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from design.search.structure import size_variants
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from estimator.information.fisher import (
    DETECTION_DISTANCE,
    cramer_rao_bounds,
    whitened,
    whitened_slopes,
)
from estimator.layouts.batch import Layouts, layouts_of
from estimator.layouts.bounds import bounds
from estimator.layouts.presses.basis import PressBasis, press_bases
from estimator.layouts.presses.changes import PressChanges, press_changes
from estimator.layouts.presses.counts import counts_when_pressed
from estimator.layouts.presses.layer import layer_basis, layer_of
from estimator.layouts.scorer import (
    LayoutScorer,
    clamp_to_candidates,
    layout_scorer,
    require_scorable,
)
from estimator.layouts.without_mesh import coarse
from estimator.signals.hall import full_scale_counts
from fem.candidates.motions import load_candidates
from instobj.explore.disturbances import face_nuisances
from instobj.stages.run import Run

Columns = Float[np.ndarray, "channel k"]
"""Counts that nuisances add to a face's channels, in standard deviations of each (`face_nuisances`)."""
_PROFILE_REACH, _PROFILE_NODES = 4.0, 33
"""Thicknesses of the shell round a press in which its skin is drawn bent, and distances in that."""


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
    """Changes of a face's chips and bodies in presses at every place of the grid; NaN where there is none.

    Attributes
    ----------
    changes : ∂/∂x, ∂/∂y, ∂/∂F of every channel and its change in the press itself, in standard deviations
        of its noise per mm and N
    nuisances : what Earth's field and warmth add to the channels, in the same unit (`face_nuisances`)
    noise_counts : one standard deviation of the axes X, Y and Z
    motions : displacement (mm) and small rotation (rad) of each body in the silicone, in the face's frame
    """

    changes: Float[np.ndarray, "place channel 4"]
    nuisances: Float[np.ndarray, "channel k"]
    noise_counts: Float[np.ndarray, "3"]
    motions: Float[np.ndarray, "place body 6"]

    def counts(self, places: Sequence[int]) -> Float[np.ndarray, "sensor 3"]:
        """Return the change in counts while all of these places are pressed: signals are linear here."""
        change = self.changes[list(places), :, 3].sum(axis=0)
        return change.reshape(-1, 3) * self.noise_counts

    def position_mm2(self, places: Sequence[int]) -> Float[np.ndarray, "press 2 2"]:
        """Return the covariance of each place (mm²) where place and force of all these presses are sought
        at once."""
        slopes = self.changes[list(places), :, :3]
        # each press first, the others behind it: bounds are those of the first two parameters
        ordered = [np.hstack(list(np.roll(slopes, -k, axis=0))) for k in range(len(places))]
        if np.isnan(slopes).any():
            return np.full((len(places), 2, 2), np.nan)
        noise = np.ones(slopes.shape[1])
        return cramer_rao_bounds(np.stack(ordered), noise, self.nuisances).position_mm2


@dataclass(frozen=True)
class Explorer:
    """The mechanics of one shell, for any layout of magnets and sensors in it; `open_explorer` makes it.

    `presses` by face: of each size of magnet the presses to every one of `forces_n`. `coarse`: by the closed
    form of a layer, at few places, instead of the shell's own mechanics.
    """

    spec: ObjectSpec
    forces_n: tuple[float, ...]
    presses: Mapping[int, Sequence[tuple[PressBasis, ...]]]
    coarse: bool = False

    @property
    def first_force_n(self) -> float:
        """The force that a page opens at: of `forces_n` the nearest to `score.force_n`."""
        return min(self.forces_n, key=lambda force: abs(force - self.spec.score.force_n))

    @property
    def grid(self) -> PlaceGrid:
        """Contact locations of the grid; a face may have some of them only."""
        return next(iter(self.presses.values()))[0][0].places

    @one_thread()
    def judge(self, design: ObjectSpec, force_n: float) -> Judgement:
        """Bounds of a design that differs in magnets' and sensors' places, poles and grades, in chips, or in
        its use: `limits.use` says whether nuisances are integrated out.

        Raises
        ------
        InputError
            Another force, or what `require_scorable` refuses.
        """
        require_scorable(design)
        position, force, beyond = [], [], False
        nuisances = face_nuisances(design)
        for face in self.presses:
            presses = self._face_presses(design, face, [force_n])
            place_bounds, force_bounds = bounds(presses.slopes(nuisances[face]))
            position.append(self._fill_grid(face, place_bounds[0].double().numpy()))
            force.append(self._fill_grid(face, force_bounds[0].double().numpy()))
            beyond = beyond or presses.clamped
        return Judgement(force_n, np.stack(position), np.stack(force), beyond)

    @one_thread()
    def least_forces_n(self, design: ObjectSpec) -> Float[np.ndarray, "face place"]:
        """Return forces at which the signal stands five sigma off rest, straight between `forces_n`;
        infinite where the largest of them does not reach that, NaN as in `judge`."""
        least, nuisances = [], face_nuisances(design)
        for face in self.presses:
            distances = self._face_presses(design, face, self.forces_n).distances(nuisances[face])
            least.append(self._fill_grid(face, _crossings_n(self.forces_n, distances)))
        return np.stack(least)

    @one_thread()
    def range_used(self, design: ObjectSpec) -> float:
        """Return the largest counts, at rest and in the deepest presses, over the chips' full scale."""
        presses = (self._face_presses(design, face, self.forces_n[-1:]) for face in self.presses)
        return max(face.largest_counts for face in presses) / full_scale_counts(design.sensors)

    @one_thread()
    def press(self, design: ObjectSpec, face: int, force_n: float) -> Pressed:
        """Return what chips and bodies of a face do in presses on it.

        Raises
        ------
        InputError
            As `judge`, or a face that is not sensed.
        """
        if face not in self.presses:
            raise InputError(f"face {face} is not sensed. Press one of {list(self.presses)}")
        presses = self._face_presses(design, face, [force_n])
        sigma = presses.scorers[0].sigma_counts.double().numpy()
        # (place, channel, x y F and the change itself), in standard deviations of each channel
        white = presses.changes[0].by_parameter[:, 0].permute(2, 0, 1).double().numpy()
        motions = self._fill_grid(face, presses.motions(design.magnets.count))
        nuisances = face_nuisances(design)[face]
        return Pressed(self._fill_grid(face, white), nuisances, sigma, motions)

    def _face_presses(
        self, design: ObjectSpec, face: int, forces_n: Sequence[float]
    ) -> _FacePresses:
        layouts = layouts_of(design, face)
        numbers = [self._number_of(force) for force in forces_n]
        bases = [[of_size[number] for of_size in self.presses[face]] for number in numbers]
        scorers = [layout_scorer(design, of_sizes) for of_sizes in bases]
        inside = clamp_to_candidates(scorers[0], layouts)
        with torch.no_grad():
            changes = [press_changes(scorer, inside) for scorer in scorers]
        return _FacePresses(scorers, inside, changes, not _same_places(inside, layouts))

    def _fill_grid(
        self, face: int, values: Float[np.ndarray, "location *rest"]
    ) -> Float[np.ndarray, "place *rest"]:
        """Return values of a face's locations at the places of the grid; NaN at the others."""
        has_location = self.presses[face][0][0].on_face
        grid = np.full((len(has_location), *values.shape[1:]), np.nan)
        grid[has_location] = values
        return grid

    def _number_of(self, force_n: float) -> int:
        if force_n not in self.forces_n:
            listed = ", ".join(f"{force:g}" for force in self.forces_n)
            raise InputError(f"no presses to {force_n:g} N are at hand. Choose one of {listed} N")
        return self.forces_n.index(force_n)


@dataclass(frozen=True)
class _FacePresses:
    """Changes in presses of one face of a design, force by force; `clamped`: whether a part was taken at
    the nearest place whose motions are stored."""

    scorers: Sequence[LayoutScorer]
    layouts: Layouts
    changes: Sequence[PressChanges]
    clamped: bool

    @property
    def largest_counts(self) -> float:
        """Largest magnitude of any channel of the face, at rest and in the deepest presses."""
        with torch.no_grad():
            pressed = counts_when_pressed(self.scorers[-1], self.layouts, self.changes[-1]).counts
        return max(float(pressed.abs().max()), float(self.changes[-1].resting_counts.abs().max()))

    def slopes(self, nuisances: Columns) -> Float[Tensor, "channel 1 3 place"]:
        """Return the derivatives by x, y and force at the first force, white, nuisances integrated out."""
        slopes = self.changes[0].by_parameter[:, :, :3]
        if not nuisances.shape[1]:
            return slopes
        by_place = slopes[:, 0].permute(2, 0, 1).double().numpy()
        white = whitened_slopes(by_place, np.ones(len(slopes)), nuisances)
        return torch.as_tensor(white, dtype=slopes.dtype).permute(1, 2, 0)[:, None]

    def distances(self, nuisances: Columns) -> Float[np.ndarray, "force location"]:
        """Return Mahalanobis distances √(ΔSᵀ Σ⁻¹ ΔS) off rest at every force."""
        changed = [change.by_parameter[:, 0, 3].T.double().numpy() for change in self.changes]
        noise = np.ones(len(nuisances))
        return np.linalg.norm([whitened(rows, noise, nuisances) for rows in changed], axis=2)

    def motions(self, magnets: int) -> Float[np.ndarray, "location body 6"]:
        """Motions of the face's own bodies at the first force."""
        parts = self.changes[0].motions
        bodies = parts[0][2].shape[1] if parts[0][0] is None else magnets
        moved = np.zeros((parts[0][1].count, bodies, 6))
        for which, basis, rows in parts:
            # the last of four blocks of columns is the motion itself (`PressBasis.own_table`)
            moves = rows[0].double() @ basis.own_table.basis[:, -basis.count :].double()
            moved[:, slice(None) if which is None else list(which)] = moves.permute(2, 0, 1).numpy()
        return moved


def _same_places(a: Layouts, b: Layouts) -> bool:
    return all(
        torch.equal(a.layouts_of_face(face).magnet_mm, b.layouts_of_face(face).magnet_mm)
        and torch.equal(a.layouts_of_face(face).sensor_mm, b.layouts_of_face(face).sensor_mm)
        for face in a.by_face or (0,)
    )


def _crossings_n(
    forces_n: Sequence[float], distances: Float[np.ndarray, "force location"]
) -> Float[np.ndarray, "location"]:
    """Return the forces at which signals stand `DETECTION_DISTANCE` off rest: straight between forces,
    infinite where the largest one does not reach it."""
    distance, force = np.stack([0 * distances[0], *distances]), np.array([0.0, *forces_n])
    reached = distance >= DETECTION_DISTANCE
    after = np.maximum(reached.argmax(axis=0), 1)
    place = np.arange(distance.shape[1])
    low, high = distance[after - 1, place], distance[after, place]
    share = (DETECTION_DISTANCE - low) / np.where(high > low, high - low, 1.0)
    crossing = force[after - 1] + share * (force[after] - force[after - 1])
    return np.where(reached.any(axis=0), crossing, np.inf)


def skin_profile_mm(spec: ObjectSpec, force_n: float) -> Float[np.ndarray, "distance 3"]:
    """Return how the skin moves round a press, by the closed form of a layer: distance along the surface,
    displacement inwards and away from the press (mm)."""
    layer = layer_of(spec)
    away = np.linspace(0, _PROFILE_REACH * spec.shell.thickness_mm, _PROFILE_NODES)
    moved = layer.motions(np.column_stack([away, 0 * away]), np.zeros(1), force_n)[:, 0, 3]
    return np.column_stack([away, -moved[:, 2], moved[:, 0]])


def summary_of(values: Float[np.ndarray, "face place"]) -> Summary:
    """Summarize a figure over all places that have it; ranks are not interpolated where some are infinite."""
    figures = np.asarray(values[~np.isnan(values)])
    method = "linear" if np.isfinite(figures).all() else "higher"
    middle, high = np.percentile(figures, (50, 95), method=method)
    face, place = np.unravel_index(np.nanargmax(values), values.shape)
    return Summary(float(middle), float(high), float(figures.max()), int(face), int(place))


def open_explorer(spec: ObjectSpec) -> Explorer:
    """Set up the mechanics of a specification's shell at `spec.pressed_forces_n`, as the search's; it takes
    minutes where none is stored.

    Raises
    ------
    InputError
        Refused by `require_scorable`, or mechanics that fails.
    """
    require_scorable(spec)
    forces_n = spec.pressed_forces_n
    tables = [
        (variant, load_candidates(Run(variant, checked=False).require("candidates").folder))
        for variant in size_variants(spec)
    ]
    presses = {
        face: [press_bases(variant, motions, face, forces_n) for variant, motions in tables]
        for face in spec.body.sensed
    }
    return Explorer(spec, forces_n, presses)


def open_coarse_explorer(spec: ObjectSpec) -> Explorer:
    """Set up presses by the closed form of a layer, which takes seconds: at few contact locations, and
    alike for every size of magnet.

    Raises
    ------
    InputError
        Refused by `require_scorable`, or a shell or a face without room for candidates.
    """
    require_scorable(spec)
    forces_n, few = spec.pressed_forces_n, coarse(spec)
    by_force = [few.changed(score=few.score.changed(force_n=force)) for force in forces_n]
    presses = {}
    for face in spec.body.sensed:
        bases = tuple(layer_basis(pressed, face) for pressed in by_force)
        presses[face] = [bases] * len(size_variants(spec))
    return Explorer(spec, forces_n, presses, coarse=True)


def is_stored(spec: ObjectSpec) -> bool:
    """Return whether the mechanics of a specification's shell is stored."""
    variants = size_variants(spec)
    return all(Run(spec, checked=False).stored("candidates") is not None for spec in variants)


def open_shell(spec: ObjectSpec) -> Explorer:
    """Set up the best mechanics of a shell that takes seconds: what is stored, or else coarse.

    Raises
    ------
    InputError
        As `open_explorer` and `open_coarse_explorer`.
    """
    return open_explorer(spec) if is_stored(spec) else open_coarse_explorer(spec)
