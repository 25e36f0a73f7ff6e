"""Effect of spread in assembly, material and surroundings on an object's signals and bounds.

Each contribution alone to first order (central differences), and all together by Monte Carlo.
Mechanics is the design's. A magnet that sits aside is taken to move as the one in the
designed seat does when the press lies as far aside the other way (`result.SEAT_ERROR` says how well).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, face_rows
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, magnets_model
from estimator.information.fisher import disturbance_counts, position_and_force_bounds, whitened
from estimator.information.scores import require_reached
from estimator.signals.field_setup import KnownField, counts, min_distance_mm, sensed_field
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import press_traces
from estimator.signals.live import is_live, read_change
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.press_states import PressStates, motions_as_signals, press_states
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import (
    CONTRIBUTIONS,
    Assembly,
    assembled,
    contribution_sizes,
    counts_of,
    designed,
    draw,
    read_by,
)
from estimator.tolerances.result import REACH_SHARE, BoundRange, Robustness, Spread
from estimator.tolerances.saturation import saturation
from fem.presses.results import MagnetMotions, PressForces

DRAWS = 200
_STEP = 0.05
"""Step of central differences, in standard deviations."""
_NEARER_MM = 1.0
"""Distance by which tolerances may bring magnet and sensor nearer than any press of the design does."""


@dataclass(frozen=True)
class Outcome:
    """Outcome of one assembly: counts at rest; face by face the change in each press, as chips read it,
    and its derivatives in x, y, F, of working channels; 0 where its own chips clip
    (`estimator.signals.live`). The bounds of all presses."""

    baseline: Float[np.ndarray, "sensor 3"]
    delta: tuple[Float[np.ndarray, "_ _"], ...]
    jacobian: tuple[Float[np.ndarray, "_ _ 3"], ...]
    position_mm: Float[np.ndarray, "press"]
    force_n: Float[np.ndarray, "press"]


@dataclass(frozen=True)
class _Deviation:
    """One independent deviation of an outcome; of bounds in their logarithms."""

    baseline: Float[np.ndarray, "sensor 3"]
    delta: tuple[Float[np.ndarray, "_ _"], ...]
    position: Float[np.ndarray, "press"]
    force: Float[np.ndarray, "press"]


@dataclass(frozen=True)
class Setting:
    """Setting that all assemblies share; `states` and `live` channels face by face.

    `reached` says which contact locations, face by face, reach `score.force_n`: `states` are of
    those alone.
    """

    spec: ObjectSpec
    design: Assembly
    faces: tuple[int, ...]
    states: tuple[PressStates, ...]
    live: tuple[Bool[np.ndarray, "_"], ...]
    model: MagnetsModel
    reached: Bool[np.ndarray, "place"]

    @property
    def reduced_places(self) -> int:
        """Return how many of the reached locations are judged at less, to leave room for softer silicone."""
        return sum(int(np.sum(s.force_n < self.spec.score.force_n)) for s in self.states)

    def read_by(self, face: int) -> int | None:
        """The face whose own channels alone are read in presses on it; None for all."""
        return face if self.spec.score.channels == "own" else None

    @cached_property
    def nuisances(self) -> Float[np.ndarray, "channel k"]:
        """Return what the design's nuisances add, which stand for those of every assembly."""
        return nuisance_columns(self.spec)

    def rows_read(self, face: int) -> Int[np.ndarray, "some"]:
        """Return the rows, among all channels, that are read in presses on a face."""
        live, own_face = self.live[self.faces.index(face)], self.read_by(face)
        if own_face is None:
            return np.flatnonzero(live)
        first = int(np.argmax(self.design.scene.sensors.face == own_face))
        return 3 * first + np.flatnonzero(live)

    @cached_property
    def design_motion(self) -> tuple[KnownField, ...]:
        """Fields of the design in the states of every face."""
        fields = []
        for face, states in zip(self.faces, self.states, strict=True):
            place, motion = read_by(
                self.design.pressed_scene, _flatten_states(states.design_motion), self.read_by(face)
            )
            fields.append(KnownField(place, motion, sensed_field(place, motion, self.model)))
        return tuple(fields)


def robustness(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    progress: Callable[[str], None] | None = None,
    draws: int = DRAWS,
) -> Robustness:
    """The budget at `score.force_n`, with `score.channels`, from `tolerances`.

    Locations that do not reach it are left out; locations that reach it only near the deepest press are
    judged at 0.7 of that press's force, and counted.

    Raises
    ------
    InputError
        Of `press_signals`, and where no press reaches the force.
    """
    say = progress or (lambda _: None)
    setting = setting_of(spec, forces, motions)
    nominal = outcome_of(setting, setting.design)
    rows = []
    for name, (_, title) in CONTRIBUTIONS.items():
        say(f"{title}, to first order")
        rows.append(_summary(name, setting, nominal, _linear(setting, name)))
    say(f"all together: {draws} objects")
    rng = np.random.default_rng((spec.seed, 6))
    objects = [outcome_of(setting, draw(spec, setting.design, rng)) for _ in range(draws)]
    scale = draws**-0.5
    deviations = (deviation_of(outcome, nominal, scale) for outcome in objects)
    together = summed_spread(rows)
    return Robustness(
        tuple(sorted(rows, key=lambda row: -_share(row, together))),
        together,
        _summary("monte_carlo", setting, nominal, deviations),
        draws,
        spec.score.force_n,
        setting.reduced_places,
        *bound_ranges(nominal, objects),
        saturation=saturation(spec, press_signals(spec, forces, motions), motions, draws),
    )


def twin_bounds(
    spec: ObjectSpec, forces: PressForces, motions: MagnetMotions, twins: int
) -> dict[str, Float[np.ndarray, "object press"]]:
    """Bounds `position_mm` and `force_n` of the design, then of `twins` objects within tolerance.

    Twins are drawn with the specification's seed; presses run face by face, forces as in
    `robustness`. NaN where the force is not reached, and where softer silicone would be pressed deeper
    than was simulated.
    """
    setting, rng = setting_of(spec, forces, motions), np.random.default_rng((spec.seed, 7))
    objects = [setting.design, *(draw(spec, setting.design, rng) for _ in range(twins))]
    outcomes = [outcome_of(setting, assembly) for assembly in objects]
    valid = [
        np.concatenate([s.simulated(o.modulus_ratio) for s in setting.states]) for o in objects
    ]
    bounds = {}
    for name in ("position_mm", "force_n"):
        bounds[name] = np.full((len(objects), len(setting.reached)), np.nan)
        values = [getattr(outcome, name) for outcome in outcomes]
        bounds[name][:, setting.reached] = np.where(valid, values, np.nan)
    return bounds


def setting_of(spec: ObjectSpec, forces: PressForces, motions: MagnetMotions) -> Setting:
    design, grid, working = designed(spec), contact_grid(spec), live_channels(spec)
    moving = motions_as_signals(forces, motions)
    states, live, reaches = [], [], []
    places = contact_places(spec)[face_rows(spec, motions.faces)]
    for face, has_place in zip(motions.faces.tolist(), places, strict=True):
        xy = grid.xy_mm[has_place]
        where = np.full(len(xy), face)
        reach = press_traces(moving, where, *xy.T).force_n[:, -1]
        reaches.append(reach)
        enough = reach >= spec.score.force_n
        force = np.minimum(spec.score.force_n, REACH_SHARE * reach)
        some = (part[enough] for part in (where, xy, force))
        states.append(press_states(forces, motions, *some))
        is_own_sensor = design.scene.sensors.face == face
        live.append((working[is_own_sensor] if spec.score.channels == "own" else working).ravel())
    nearest = min_distance_mm(design.scene, motions.all_motions)
    reach = np.concatenate(reaches)
    reached = reach >= spec.score.force_n
    require_reached(spec, reach, reached)
    model = magnets_model(spec.magnets, nearest - _NEARER_MM)
    return Setting(
        spec, design, tuple(motions.faces.tolist()), tuple(states), tuple(live), model, reached
    )


def outcome_of(setting: Setting, assembly: Assembly) -> Outcome:
    spec, model, deltas, jacobians, bounds = setting.spec, setting.model, [], [], []
    baseline = counts_of(spec, assembly.scene, setting.states[0].rest[None], model)[0]
    pressed, ratio = assembly.pressed_scene, assembly.modulus_ratio
    for face, states, live, known_field in zip(
        setting.faces, setting.states, setting.live, setting.design_motion, strict=True
    ):
        motion = states.design_motion if ratio == 1 else states.motion(ratio)
        motion = moved_aside(assembly, states, motion, face)
        read_face = setting.read_by(face)
        place, moved = read_by(pressed, _flatten_states(motion), read_face)
        if motion is states.design_motion:
            moved = known_field.motion  # which `known` need not compare
        values = counts(place, known_field.field_of(place, moved, model), spec)
        values = values.reshape(*motion.shape[:2], live.size)[..., live]
        rest = baseline if read_face is None else baseline[assembly.scene.sensors.face == face]
        rest, most = rest.ravel()[live], full_scale_counts(spec.sensors)
        change = values[0] - rest
        deltas.append(read_change(rest, change, most))
        jacobians.append(states.differentiate(values) * is_live(rest, change, most)[..., None])
        bounds.append(
            position_and_force_bounds(
                jacobians[-1], _sigma(spec, live), setting.nuisances[setting.rows_read(face)]
            )
        )
    return Outcome(
        baseline,
        tuple(deltas),
        tuple(jacobians),
        *(np.concatenate(of_faces) for of_faces in zip(*bounds, strict=True)),
    )


def _flatten_states(motion: Float[np.ndarray, "7 press body 6"]) -> Float[np.ndarray, "row body 6"]:
    return motion.reshape(-1, *motion.shape[2:])


def moved_aside(
    assembly: Assembly,
    states: PressStates,
    motion: Float[np.ndarray, "7 press body 6"],
    face: int,
) -> Float[np.ndarray, "7 press body 6"]:
    """Motions of the pressed face's bodies where they sit aside; all seven states change alike."""
    is_on_face = assembly.scene.body_face == face
    if not assembly.aside_mm[is_on_face].any():
        return motion
    slope = states.slope_per_mm(motion)[:, :, is_on_face]
    moved = motion.copy()
    # b body, k direction (x, y), p press, c of 6 motions; all seven states alike
    moved[:, :, is_on_face] -= np.einsum("bk,kpbc->pbc", assembly.aside_mm[is_on_face], slope)
    return moved


def _sigma(spec: ObjectSpec, live: Bool[np.ndarray, "every"]) -> Float[np.ndarray, "some"]:
    return disturbance_counts(spec.sensors, "fresh", len(live))[live]


def _linear(setting: Setting, name: str) -> Iterator[_Deviation]:
    """Yield what one standard deviation of each of a contribution's numbers changes, to first order."""
    design, (size, _) = setting.design, CONTRIBUTIONS[name]
    if not getattr(setting.spec.tolerances, size):
        return
    for step in _STEP * _independent_steps(setting, name):
        plus, minus = (
            outcome_of(setting, assembled(setting.spec, design, {name: way * step}))
            for way in (1.0, -1.0)
        )
        yield deviation_of(plus, minus, 1 / (2 * _STEP))


def _independent_steps(setting: Setting, name: str) -> Float[np.ndarray, "step number"]:
    """One standard deviation of each number; numbers that no channel shares are in one step.

    Read by its own sensors alone, each face feels its own sensors' errors and no others'.
    """
    size = contribution_sizes(setting.design)[name]
    faces = len(setting.faces)
    if setting.spec.score.channels == "own" and name.startswith("sensor"):
        return np.tile(np.eye(size // faces), faces)
    return np.eye(size)


def deviation_of(outcome: Outcome, reference: Outcome, scale: float) -> _Deviation:
    """Differences, of bounds in their logarithms; 0 where a bound is infinite."""

    def log_ratio(a: Any, b: Any) -> Float[np.ndarray, "press"]:
        finite = np.isfinite(a) & np.isfinite(b)
        return scale * np.log(np.where(finite, a, 1.0) / np.where(finite, b, 1.0))

    return _Deviation(
        scale * (outcome.baseline - reference.baseline),
        tuple(scale * (a - b) for a, b in zip(outcome.delta, reference.delta, strict=True)),
        log_ratio(outcome.position_mm, reference.position_mm),
        log_ratio(outcome.force_n, reference.force_n),
    )


def _summary(
    name: str, setting: Setting, nominal: Outcome, deviations: Iterable[_Deviation]
) -> Spread:
    """Sums of squares over independent deviations, as figures of a `Spread`."""
    estimators = [
        calibrated_estimator(jacobian, _sigma(setting.spec, live), setting.nuisances[rows])
        for jacobian, live, rows in zip(
            nominal.jacobian, setting.live, map(setting.rows_read, setting.faces), strict=True
        )
    ]
    places = len(nominal.position_mm)
    total: list[Any] = [0 * nominal.baseline, *np.zeros((2, places)), np.zeros((places, 3))]
    total.append(np.zeros(places))
    for deviation in deviations:
        false = [
            # p press, k of (x, y, F), c channel: what an estimator makes of a false change
            np.einsum("pkc,pc->pk", e, d)
            for e, d in zip(estimators, deviation.delta, strict=True)
        ]
        size = [np.sum(d**2, axis=1) for d in deviation.delta]
        parts = (deviation.baseline, deviation.position, deviation.force, np.concatenate(false))
        for index, part in enumerate(parts):
            total[index] = total[index] + part**2
        total[4] = total[4] + np.concatenate(size)
    baseline, position, force, false, size = total
    signal = np.sqrt(size / np.concatenate([np.sum(d**2, axis=1) for d in nominal.delta]))
    place, newton = np.sqrt(false[:, 0] + false[:, 1]), np.sqrt(false[:, 2])
    figures = [np.sqrt(np.mean(baseline)), np.sqrt(np.max(baseline))]
    for values in (signal, np.sqrt(position), np.sqrt(force), place, newton):
        figures += [np.median(values), np.max(values)]
    return Spread(name, *map(float, figures))


def calibrated_estimator(
    jacobian: Float[np.ndarray, "press channel 3"],
    sigma_counts: Float[np.ndarray, "channel"],
    nuisances: Float[np.ndarray, "channel k"],
) -> Float[np.ndarray, "press 3 channel"]:
    """Weighted least squares about the design's own signal, nuisances integrated out: counts to errors
    of (x, y, F). Channels that stand still in every press drop out."""
    shared = nuisances * np.asarray(jacobian.any(axis=(0, 2)))[:, None]
    weights = whitened(np.diag(np.ones_like(sigma_counts)), sigma_counts, shared)
    # rows of `weights` are Wᵀ: the least squares of W r by W J is (W J)⁺ W r
    return np.linalg.pinv(weights.T @ jacobian) @ weights.T


def summed_spread(rows: list[Spread]) -> Spread:
    """Root sum of squares, figure by figure (of medians: as the figures stand)."""
    names = [field.name for field in fields(Spread)][1:]
    return Spread(
        "together", *(float(np.hypot.reduce([getattr(r, name) for r in rows])) for name in names)
    )


def _share(row: Spread, together: Spread) -> float:
    pairs = [(r.false_place_mm, r.false_force_n) for r in (row, together)]
    return sum((own_error / (whole or 1.0)) ** 2 for own_error, whole in zip(*pairs, strict=True))


def bound_ranges(nominal: Outcome, objects: list[Outcome]) -> list[BoundRange]:
    ranges = []
    for name in ("position_mm", "force_n"):
        for pick in (np.median, np.max):
            drawn = [float(pick(getattr(outcome, name))) for outcome in objects]
            low, high = np.quantile(drawn, [0.05, 0.95], method="nearest")
            ranges.append(BoundRange(float(pick(getattr(nominal, name))), float(low), float(high)))
    return ranges
