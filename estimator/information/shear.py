"""Signals of tangential forces, and the information about (x, y, F, Fx, Fy) that they leave.

Where the tip may also pull along the surface, five parameters share the signals: a place that is
well known when only (x, y, F) are asked can be lost. Tangential forces are small changes about a
frictionless press (`fem.presses.shear`).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.layout.places.contact_grid import PlaceGrid, contact_grid, grid_places_in_lattice
from design.layout.places.contact_places import contact_places, face_rows
from design.spec.object import ObjectSpec
from design.tables import write_table
from estimator.field.models import magnets_model
from estimator.information.fisher import (
    SUFFIXES,
    cramer_rao_bounds,
    disturbance_counts,
    whitened_slopes,
)
from estimator.information.scores import fill_places
from estimator.information.sensitivity import read_channels
from estimator.signals.field_setup import counts, min_distance_mm, scene, sensed_field
from estimator.signals.interpolation import press_traces, signal_gradient
from estimator.signals.live import live_in_press
from estimator.signals.monotone import monotone_cubic
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals
from fem.presses.results import MagnetMotions, ShearMotions

_STEP_N = 0.2
"""Half of the central difference: the field bends by 1e-5 of its slope over it."""


@dataclass(frozen=True)
class ShearSignals:
    """Change of counts per newton along the face's x and y, at every contact location and depth.

    `counts_per_n` (face, place, step, tangent, sensor, axis); `depth_mm` (step,).
    """

    faces: Int[np.ndarray, "face"]
    grid: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    counts_per_n: Float[np.ndarray, "face place step 2 sensor 3"]


@dataclass(frozen=True)
class ShearScores:
    """Cramér–Rao bounds of (x, y, F, Fx, Fy) at `score.force_n` and no tangential force.

    Attributes
    ----------
    position_bound_mm : √(σx² + σy²) with both tangential forces unknown
    normal_force_bound_n : σF
    tangential_force_bound_n : √(σFx² + σFy²)
    condition : of the whitened Jacobian in mm and N, freshly zeroed

    NaN at places that a face has not, and where no press reaches `score.force_n`.
    """

    faces: Int[np.ndarray, "face"]
    grid: PlaceGrid
    position_bound_mm: Float[np.ndarray, "face place"]
    position_bound_drifted_mm: Float[np.ndarray, "face place"]
    normal_force_bound_n: Float[np.ndarray, "face place"]
    normal_force_bound_drifted_n: Float[np.ndarray, "face place"]
    tangential_force_bound_n: Float[np.ndarray, "face place"]
    tangential_force_bound_drifted_n: Float[np.ndarray, "face place"]
    condition: Float[np.ndarray, "face place"]


def shear_signals(spec: ObjectSpec, motions: MagnetMotions, shear: ShearMotions) -> ShearSignals:
    """Derivative of every channel by the tangential forces, by central differences."""
    place = scene(spec)
    is_place = contact_places(spec)[face_rows(spec, motions.faces)]
    pressed = motions.motion[:, grid_places_in_lattice(spec)][is_place]
    nearest = min_distance_mm(place, pressed.reshape(-1, place.bodies, 6))
    model = magnets_model(spec.magnets, nearest - 0.1)
    change = _STEP_N * shear.motion_per_n[is_place]
    field_t = [
        sensed_field(
            place, (pressed[:, :, None] + side * change).reshape(-1, place.bodies, 6), model
        )
        for side in (1, -1)
    ]
    sides = [counts(place, field, spec) for field in field_t]
    slope = (sides[0] - sides[1]) / (2 * _STEP_N)
    slope = fill_places(is_place, [slope.reshape(*change.shape[:3], *slope.shape[1:])])
    return ShearSignals(shear.faces, shear.grid, shear.depth_mm, slope)


def contact_jacobian(
    spec: ObjectSpec, signals: Signals, shear: ShearSignals, face: int
) -> Float[np.ndarray, "place channel 5"]:
    """∂(counts)/∂(x, y, F, Fx, Fy) at `score.force_n`, or at the deepest press where that is less.

    At the places that the face has.
    """
    is_place = contact_places(spec)[spec.body.sensed.index(face)]
    xy = shear.grid.xy_mm[is_place]
    where = (np.full(len(xy), face), xy[:, 0], xy[:, 1])
    traces = press_traces(signals, *where)
    force = np.minimum(spec.score.force_n, traces.force_n[:, -1])
    gradient = signal_gradient(signals, *where, force)
    live = live_in_press(spec, signals.baseline_counts, gradient.counts)
    per_n = shear.counts_per_n[list(shear.faces).index(face), is_place]
    rest_first = np.concatenate([per_n[:, :1], per_n], axis=1).reshape(*traces.force_n.shape, -1)
    carry_over_missing(rest_first)
    tangential = monotone_cubic(traces.force_n, rest_first, force[:, None])[:, 0]
    tangential = tangential.reshape(len(xy), 2, -1).swapaxes(1, 2)
    return np.concatenate([gradient.jacobian, tangential], axis=2) * live[..., None]


def _reaches(spec: ObjectSpec, signals: Signals, face: int) -> Bool[np.ndarray, "place"]:
    """Return whether a press of each place that the face has gets to `score.force_n`."""
    is_place = contact_places(spec)[spec.body.sensed.index(face)]
    x, y = contact_grid(spec).xy_mm[is_place].T
    return press_traces(signals, np.full(len(x), face), x, y).force_n[:, -1] >= spec.score.force_n


def carry_over_missing(per_n: Float[np.ndarray, "place node value"]) -> None:
    """Give presses that found no contact the slopes of the next deeper one, in place."""
    for node in range(per_n.shape[1] - 2, -1, -1):
        missing = ~per_n[:, node].any(axis=1)
        per_n[missing, node] = per_n[missing, node + 1]


def score_shear(spec: ObjectSpec, signals: Signals, shear: ShearSignals) -> ShearScores:
    """Bounds of all five parameters at every contact location, from `score.channels`."""
    rows, nuisances = [], nuisance_columns(spec)
    reaches = [_reaches(spec, signals, face) for face in signals.faces.tolist()]
    for face in signals.faces.tolist():
        jacobian = contact_jacobian(spec, signals, shear, face)
        used = read_channels(spec, signals, face)
        jacobian = jacobian[:, used]
        row = {}
        for state, suffix in SUFFIXES.items():
            sigma = disturbance_counts(spec.sensors, state, len(nuisances))[used]
            bounds = cramer_rao_bounds(jacobian, sigma, nuisances[used])
            row[f"position_bound{suffix}_mm"] = bounds.position_mm
            row[f"normal_force_bound{suffix}_n"] = bounds.force_n
            row[f"tangential_force_bound{suffix}_n"] = bounds.tangential_force_n
            if state == "fresh":
                slopes = whitened_slopes(jacobian, sigma, nuisances[used])
                row["condition"] = np.linalg.cond(slopes)
        rows.append(row)
    places = contact_places(spec)[face_rows(spec, signals.faces)]
    columns = {name: fill_places(places, [row[name] for row in rows]) for name in rows[0]}
    reached = fill_places(places, reaches)
    for values in columns.values():
        values[~reached] = np.nan
    return ShearScores(signals.faces, shear.grid, **columns)


def save_shear_scores_csv(scores: ShearScores, path: Path | str) -> None:
    """One row for every face and place; the header's names carry the units."""
    names = [f.name for f in fields(scores)][2:]
    xy = scores.grid.xy_mm
    rows = (
        [
            face,
            place,
            *xy[place].tolist(),
            *(repr(getattr(scores, n)[row, place].item()) for n in names),
        ]
        for row, face in enumerate(scores.faces.tolist())
        for place in range(len(xy))
    )
    write_table(path, ["face", "place", "x_mm", "y_mm", *names], rows)
