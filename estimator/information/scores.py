"""Scores of the contact locations: sensitivity δ, bounds, errors of the place and detectable forces."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int, Shaped

from design.errors import InputError, StoreError
from design.layout.places.contact_grid import PlaceGrid, contact_grid
from design.layout.places.contact_places import contact_places, face_rows
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from design.tables import write_table
from estimator.information.fisher import (
    SUFFIXES,
    Bounds,
    NoiseState,
    cramer_rao_bounds,
    detectable_force_n,
    disturbance_counts,
    whitened,
    whitened_slopes,
)
from estimator.information.position_error import position_errors_mm
from estimator.information.rival_presses import rival_presses
from estimator.information.sensitivity import (
    channel_noise,
    covariance_sensitivity,
    own_channels,
    periodic_press,
    read_channels,
)
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import (
    Traces,
    counts_at_force,
    depth_at_force,
    press_traces,
)
from estimator.signals.live import live_jacobian, read_change
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals, require_finite

COVARIANCE_SAMPLES = 64
_AT_FORCE = ("delta", "position", "force_bound", "weakest")
"""Beginnings of the names of scores that hold at `score.force_n` alone."""
BEYOND_BOUND = 1.2
"""Ratio to the position bound from which on a position error is reported."""


@dataclass(frozen=True)
class PlaceScores:
    """Scores of every contact location; arrays are (face, place) of the contact grid, NaN (and not
    `reaches_score_force`) at places that a face has not.

    Attributes
    ----------
    delta_raw, delta_scaled : convex-hull sensitivity of the face's own d channels
        (N = 1000, white noise) for presses up to `force_at_score_n`, in
        counts^d/N and, with each channel divided by its range over the face (three sigma of noise
        at either end included), in 1/N
    position_bound_mm, force_bound_n : Cramér–Rao bounds at `force_at_score_n`, freshly zeroed, and
        `…_drifted_…` (`estimator.information.fisher`); infinite where the signals cannot tell
    position_error_mm : root mean square distance of that press from where maximum likelihood reads it,
        freshly zeroed (`estimator.information.position_error`); infinite where the bound is
    detectable_force_n : force at which the signal stands five sigma off rest
    weakest_direction_deg : direction of the largest position bound, 0 to 180° from x
    force_at_score_n : `score.force_n`, or the force of the deepest press where that is less: bounds
        and δ of such a place are NaN, as no press shows them
    reaches_score_force : whether `score.force_n` is reached
    depth_at_score_mm, stiffness_n_per_mm : indentation depth at that force, and force over depth
    """

    faces: Int[np.ndarray, "face"]
    grid: PlaceGrid
    delta_raw: Float[np.ndarray, "face place"]
    delta_scaled: Float[np.ndarray, "face place"]
    position_bound_mm: Float[np.ndarray, "face place"]
    position_bound_drifted_mm: Float[np.ndarray, "face place"]
    position_error_mm: Float[np.ndarray, "face place"]
    force_bound_n: Float[np.ndarray, "face place"]
    force_bound_drifted_n: Float[np.ndarray, "face place"]
    detectable_force_n: Float[np.ndarray, "face place"]
    detectable_force_drifted_n: Float[np.ndarray, "face place"]
    weakest_direction_deg: Float[np.ndarray, "face place"]
    force_at_score_n: Float[np.ndarray, "face place"]
    reaches_score_force: Bool[np.ndarray, "face place"]
    depth_at_score_mm: Float[np.ndarray, "face place"]
    stiffness_n_per_mm: Float[np.ndarray, "face place"]

    @property
    def places(self) -> Bool[np.ndarray, "face place"]:
        """Return which places of the grid each face has."""
        return ~np.isnan(self.force_at_score_n)

    @property
    def judged(self) -> Bool[np.ndarray, "face place"]:
        """Return which of them a press reaches `score.force_n` at."""
        return self.reaches_score_force

    @property
    def unreached(self) -> str:
        """In words, how many places are not judged; empty where all are."""
        out = self.places & ~self.judged
        if not out.any():
            return ""
        return (
            f"{out.sum()} of {self.places.sum()} contact locations are not judged: the deepest press stays "
            f"below score.force_n there, at {self.force_at_score_n[out].min():.3g} N or more. Press deeper "
            "(press.depths_mm, as far as check allows) or lower score.force_n"
        )

    @property
    def misread(self) -> Bool[np.ndarray, "face place"]:
        """Locations where maximum likelihood errs by more than `BEYOND_BOUND` times the bound (fresh)."""
        return self.judged & (self.position_error_mm > BEYOND_BOUND * self.position_bound_mm)

    @property
    def exceeds_bound(self) -> str:
        """In words, where a reader does worse than the bound; empty where it does nowhere."""
        misread = self.misread
        if not misread.any():
            return ""
        errors = np.where(misread, self.position_error_mm, -np.inf)
        face, place = np.unravel_index(np.argmax(errors), errors.shape)
        x, y = self.grid.xy_mm[place]
        return (
            f"At {misread.sum()} of {self.judged.sum()} contact locations an estimator (maximum likelihood) "
            f"errs by more than {BEYOND_BOUND:g} times the bound, as signals bend or a distant place gives "
            f"nearly the same; most on face {self.faces[face]} at ({x:g}, {y:g}) mm: "
            f"{errors[face, place]:.2g} mm, bound {self.position_bound_mm[face, place]:.2g} mm"
        )


@dataclass(frozen=True)
class WeakestPlace:
    """The place with the largest position bound; `direction_deg` from the face's x."""

    face: int
    place: int
    x_mm: float
    y_mm: float
    position_bound_mm: float
    direction_deg: float


def score_places(
    spec: ObjectSpec, signals: Signals, progress: Callable[[str], None] | None = None
) -> PlaceScores:
    """Score every contact location; bounds and detectable forces from `score.channels`.

    Nuisances of `limits.use` are integrated out. Beside them the position error takes chips that clip
    in a press for ones that still tell of the nuisances.

    Raises
    ------
    InputError
        Signals that are not finite, forces that do not grow with depth, no hull volume, or a force
        that no press reaches.
    """
    rows = []
    for pressed in _pressed_faces(spec, signals):
        if progress:
            progress(f"face {pressed.face}: {len(pressed.xy_mm)} places")
        rows.append(_score_face(pressed))
    columns = _columns(spec, signals, rows)
    require_reached(spec, columns["force_at_score_n"], columns["reaches_score_force"])
    for name in columns:
        if name.startswith(_AT_FORCE):
            columns[name][~columns["reaches_score_force"]] = np.nan
    return PlaceScores(signals.faces, contact_grid(spec), **columns)


def require_reached(
    spec: ObjectSpec,
    force_n: Float[np.ndarray, "..."],
    reached: Bool[np.ndarray, "..."],
) -> None:
    """Raise InputError where no press reaches `score.force_n`: nothing could be judged at it."""
    if not reached.any():
        raise InputError(
            f"no press reaches {spec.score.force_n:g} N (score.force_n, search.forces_n): the hardest one "
            f"gets to {np.nanmax(force_n):.3g} N, {spec.press.depths_mm[-1]:g} mm deep. Lower the force, or "
            "press deeper (press.depths_mm)"
        )


def fill_places(
    places: Bool[np.ndarray, "face place"], values: Sequence[Shaped[np.ndarray, "_ *rest"]]
) -> Shaped[np.ndarray, "face place *rest"]:
    """Values of the places that each face has, in the grid's order; NaN (or False) elsewhere."""
    kind, rest = values[0].dtype, values[0].shape[1:]
    filled = np.full((*places.shape, *rest), np.nan if kind.kind == "f" else False, kind)
    filled[places] = np.concatenate(values)
    return filled


@dataclass(frozen=True)
class PlaceBounds:
    """Bounds as `PlaceScores` has them under the same names, freshly zeroed; those of a location that does
    not reach `score.force_n` are of its deepest press."""

    position_bound_mm: Float[np.ndarray, "face place"]
    detectable_force_n: Float[np.ndarray, "face place"]


def reached_places(spec: ObjectSpec, signals: Signals) -> Bool[np.ndarray, "face place"]:
    """Return at which contact locations a press reaches `score.force_n`."""
    rows = [{"reached": face.reaches_score_force} for face in _pressed_faces(spec, signals)]
    return _columns(spec, signals, rows)["reached"]


def place_bounds(spec: ObjectSpec, signals: Signals) -> PlaceBounds:
    """Bounds of every contact location alone, in half the time of `score_places`; raises as it does,
    but for a force that no press reaches."""
    rows = []
    for pressed in _pressed_faces(spec, signals):
        bounds, detectable = pressed.fresh
        rows.append(
            {
                "position_bound_mm": bounds.position_mm,
                "detectable_force_n": detectable,
            }
        )
    return PlaceBounds(**_columns(spec, signals, rows))


@dataclass(frozen=True)
class _PressedFace:
    """Presses of one face at its contact locations (`xy_mm`), with the k nuisances of the object.

    `reach_n` is the force of the deepest press, `force_n` the least of that and of `score.force_n`; `used`
    are the channels that are read.
    """

    spec: ObjectSpec
    signals: Signals
    face: int
    xy_mm: Float[np.ndarray, "place 2"]
    nuisances: Float[np.ndarray, "channel k"]

    @cached_property
    def presses(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return np.full(len(self.xy_mm), self.face), self.xy_mm[:, 0], self.xy_mm[:, 1]

    @cached_property
    def used(self) -> Int[np.ndarray, "some"]:
        return read_channels(self.spec, self.signals, self.face)

    @cached_property
    def all_traces(self) -> Traces:
        return press_traces(self.signals, *self.presses)

    @cached_property
    def traces(self) -> Traces:
        return self.all_traces.select_channels(self.used)

    @property
    def reach_n(self) -> Float[np.ndarray, "place"]:
        return self.traces.force_n[:, -1]

    @property
    def force_n(self) -> Float[np.ndarray, "place"]:
        return np.minimum(self.spec.score.force_n, self.reach_n)

    @property
    def reaches_score_force(self) -> Bool[np.ndarray, "place"]:
        return self.reach_n >= self.spec.score.force_n

    @cached_property
    def jacobian(self) -> Float[np.ndarray, "place channel 3"]:
        return live_jacobian(self.spec, self.signals, *self.presses, self.force_n)[:, self.used]

    @cached_property
    def shared(self) -> Float[np.ndarray, "channel k"]:
        """Nuisances in the channels that are read; a chip clipped at rest says nothing of them."""
        in_range = abs(self.signals.baseline_counts.ravel()[self.used]) <= self.range_counts
        return self.nuisances[self.used] * in_range[:, None]

    @property
    def range_counts(self) -> float:
        return full_scale_counts(self.spec.sensors)

    def sigma(self, state: NoiseState) -> Float[np.ndarray, "channel"]:
        channels = self.signals.baseline_counts.size
        return disturbance_counts(self.spec.sensors, state, channels)[self.used]

    def read(self, change: Float[np.ndarray, "*any channel"]) -> Float[np.ndarray, "*any channel"]:
        """Changes of counts of the used channels, as their chips tell them."""
        rest = self.signals.baseline_counts.ravel()[self.used]
        return read_change(rest, change, range_counts=self.range_counts)

    def bounds(self, state: NoiseState) -> tuple[Bounds, Float[np.ndarray, "place"]]:
        """Bounds and detectable forces (N)."""
        sigma = self.sigma(state)
        detectable = detectable_force_n(self.traces, sigma, read=self.read, nuisances=self.shared)
        return cramer_rao_bounds(self.jacobian, sigma, self.shared), detectable

    @cached_property
    def fresh(self) -> tuple[Bounds, Float[np.ndarray, "place"]]:
        return self.bounds("fresh")


def _pressed_faces(spec: ObjectSpec, signals: Signals) -> Iterator[_PressedFace]:
    """Yield the faces that were pressed."""
    require_finite(spec, signals)
    xy_mm, nuisances = contact_grid(spec).xy_mm, nuisance_columns(spec)
    places = contact_places(spec)[face_rows(spec, signals.faces)]
    for face, is_place in zip(signals.faces.tolist(), places, strict=True):
        yield _PressedFace(spec, signals, face, xy_mm[is_place], nuisances)


def _columns(
    spec: ObjectSpec, signals: Signals, rows: Sequence[dict[str, Any]]
) -> dict[str, Shaped[np.ndarray, "face place"]]:
    """Figures of all faces in the grid's order."""
    places = contact_places(spec)[face_rows(spec, signals.faces)]
    return {name: fill_places(places, [row[name] for row in rows]) for name in rows[0]}


def _score_face(pressed: _PressedFace) -> dict[str, Any]:
    spec, signals, face = pressed.spec, pressed.signals, pressed.face
    live = live_channels(spec).ravel()
    face_channels = own_channels(signals, spec.sensors, face)
    face_channels = face_channels[live[face_channels]]
    if not len(face_channels):
        raise InputError(
            f"face {face} has no live channel: as_built calls all of them dead. Fix a sensor, or "
            "take the entries out"
        )
    force, rest = pressed.force_n, signals.baseline_counts.ravel()[face_channels]
    press = pressed.all_traces.select_channels(face_channels)
    press = periodic_press(press, force, COVARIANCE_SAMPLES)
    press = read_change(rest, press, pressed.range_counts)
    row = sensitivities(press, force, channel_noise(spec.sensors, live.size)[face_channels])
    for state, suffix in SUFFIXES.items():
        bounds, detectable = pressed.fresh if state == "fresh" else pressed.bounds(state)
        row[f"position_bound{suffix}_mm"] = bounds.position_mm
        row[f"force_bound{suffix}_n"] = bounds.force_n
        row[f"detectable_force{suffix}_n"] = detectable
    bounds, _ = pressed.fresh
    x, y = bounds.weakest_direction.T
    depth = depth_at_force(pressed.traces, force[:, None])[:, 0]
    return row | {
        "weakest_direction_deg": np.rad2deg(np.arctan2(y, x)) % 180,
        "position_error_mm": _position_error_mm(pressed, bounds),
        "force_at_score_n": force,
        "reaches_score_force": pressed.reaches_score_force,
        "depth_at_score_mm": depth,
        "stiffness_n_per_mm": force / depth,
    }


def _position_error_mm(pressed: _PressedFace, bounds: Bounds) -> Float[np.ndarray, "place"]:
    """Errors of maximum likelihood, freshly zeroed; infinite where the bound is."""
    sigma, shared = pressed.sigma("fresh"), pressed.shared
    rivals = rival_presses(pressed.spec, pressed.signals, pressed.face, pressed.used)
    counts = counts_at_force(pressed.traces, pressed.force_n[:, None]).counts[:, 0]
    error = position_errors_mm(
        rivals.whitened(sigma, shared),
        pressed.xy_mm,
        whitened(pressed.read(counts), sigma, shared),
        whitened_slopes(pressed.jacobian, sigma, shared),
    )
    return np.where(np.isfinite(bounds.position_mm), error, np.inf)


def sensitivities(
    press: Float[np.ndarray, "place frame channel"],
    force_n: Float[np.ndarray, "place"],
    noise: Float[np.ndarray, "channel"],
) -> dict[str, Float[np.ndarray, "place"]]:
    raw = covariance_sensitivity(press, force_n, noise)
    span = press.max(axis=(0, 1)) - press.min(axis=(0, 1)) + 6 * noise
    return {
        "delta_raw": raw.delta,
        "delta_scaled": raw.scaled(span).delta,
    }


def weakest_place(scores: PlaceScores) -> WeakestPlace:
    """Return where the freshly zeroed object knows the contact location least."""
    bound = scores.position_bound_mm
    worst = np.argmax(np.where(scores.judged, bound, -np.inf))
    face, place = (int(i) for i in np.unravel_index(worst, bound.shape))
    x, y = scores.grid.xy_mm[place]
    return WeakestPlace(
        int(scores.faces[face]),
        place,
        float(x),
        float(y),
        float(bound[face, place]),
        float(scores.weakest_direction_deg[face, place]),
    )


_UNITS = {
    "delta_raw": "counts^d/N",
    "delta_scaled": "1/N",
}


def save_scores_csv(scores: PlaceScores, path: Path | str) -> None:
    """One row for every face and place, nan where a face has not the place; names carry the units."""
    names = [f.name for f in fields(scores)][2:]
    header = [f"{name} [{_UNITS[name]}]" if name in _UNITS else name for name in names]
    xy = scores.grid.xy_mm
    rows = (
        [
            face,
            place,
            *xy[place].tolist(),
            *(repr(getattr(scores, n)[row, place].item()) for n in names),
        ]
        for row, face in enumerate(scores.faces)
        for place in range(len(xy))
    )
    write_table(path, ["face", "place", "x_mm", "y_mm", *header], rows)


def load_scores_csv(path: Path | str) -> PlaceScores:
    """Read what `save_scores_csv` wrote.

    Raises
    ------
    StoreError
        No such file, or columns or rows are missing.
    """
    try:
        with Path(path).open(newline="", encoding="utf-8") as file:
            rows = [
                {key.split(" [")[0]: value for key, value in row.items()}
                for row in csv.DictReader(file)
            ]
        table = {name: np.array([row[name] for row in rows]) for name in rows[0]}
        faces, x, y = (
            np.unique(table[key].astype(kind))
            for key, kind in (("face", int), ("x_mm", float), ("y_mm", float))
        )
        shape = (len(faces), len(x) * len(y))
        columns = {f.name: table[f.name].reshape(shape) for f in fields(PlaceScores)[2:]}
    except (OSError, ValueError, KeyError, IndexError, AttributeError) as error:
        raise StoreError(f"{path} is not a table of scores ({error!r}). Score anew") from None
    reached = columns.pop("reaches_score_force") == "True"
    values = {name: column.astype(float) for name, column in columns.items()}
    return PlaceScores(faces, PlaceGrid(x, y), reaches_score_force=reached, **values)
