"""What every sensor sees in every press: expected changes of counts over the press lattice.

Axis order: face pressed, place (of the press lattice or of the contact grid), step (depth),
sensor (all faces, face by face), chip axis (X, Y, Z).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.files import atomic_path
from design.layouts import (
    MagnetLayout,
    PlaceGrid,
    SensorLayout,
    contact_grid,
    grid_places_in_lattice,
    magnet_layout,
    sensor_layout,
    slipped_sensors,
)
from design.spec import ObjectSpec
from estimator.field import FieldModel, field_model, sum_over_magnets, total_field
from estimator.hall import (
    check_rest,
    check_sensors_outside_magnets,
    counts_of_field,
    full_scale_counts,
    read_out,
)
from estimator.sources import magnet_source
from estimator.vectors import Vector, components, rotated
from fem.results import MagnetMotions, PressForces

SCHEMA_VERSION = 1
Progress = Callable[[str], None]
"""Called with a line about each part that is done."""

_PAIRS_PER_CHUNK = 9000
"""Magnet–sensor pairs at a time: a dozen arrays of them in float64 fit a second-level cache. Larger
ones may be handed back to the system at every step, which costs three times the arithmetic."""


@dataclass(frozen=True)
class Signals:
    """Noise-free signals of every press of the lattice.

    Attributes
    ----------
    faces : (face,) numbers of the faces pressed
    lattice : places pressed on each face, mm in the face's frame
    depth_mm : (step,) travel of the indenter below the undeformed face
    force_n : (face, place, step) normal force, N, compressive positive
    delta_counts : (face, place, step, sensor, axis) expected change against rest, counts
    baseline_counts : (sensor, axis) expected counts at rest
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "face place step"]
    delta_counts: Float[np.ndarray, "face place step sensor 3"]
    baseline_counts: Float[np.ndarray, "sensor 3"]


def press_signals(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    progress: Progress | None = None,
) -> Signals:
    """Expected signals of all sensors for the magnets' motions in every press.

    Each press moves the magnets of all faces. Displacement and finite rotation of a magnet both
    change its field. The field model is the cheapest whose error is at most 0.1 % at the smallest
    distance between a magnet and a sensor that any press reaches.

    Raises
    ------
    InputError
        A sensor lies in a magnet (at rest or pressed) or saturates at rest.
    """
    magnets, sensors = magnet_layout(spec), _sensors_of_the_model(spec)
    magnet = magnet_source(spec.magnets)
    check_sensors_outside_magnets(sensors, magnets, magnet)
    everywhere = motions.motion.reshape(-1, len(magnets.face), 6)
    model = field_model(magnet, min_distance_mm(everywhere, magnets, sensors))
    at_rest = np.zeros((len(magnets.face), 6)) if motions.rest is None else motions.rest
    rest_t = pressed_field(at_rest[None], magnets, sensors, model)[0]
    baseline = counts_of_field(1e3 * rest_t, sensors.axes, spec.sensors)
    check_rest(baseline, sensors, spec.sensors)
    per_face = motions.motion.shape[1:3]
    delta = np.empty((len(motions.faces), *per_face, len(sensors.face), 3))
    for index, face in enumerate(motions.faces):
        motion = motions.motion[index].reshape(-1, len(magnets.face), 6)
        field_t = pressed_field(motion, magnets, sensors, model)
        counts = counts_of_field(1e3 * field_t, sensors.axes, spec.sensors)
        delta[index] = counts.reshape(*per_face, *baseline.shape) - baseline
        if progress is not None:
            progress(f"face {face}: field of {motion.shape[0]} presses at {len(baseline)} sensors")
    return Signals(
        motions.faces, motions.lattice, motions.depth_mm, forces.force_n, delta, baseline
    )


def rest_counts(spec: ObjectSpec, model: FieldModel | None = None) -> Float[np.ndarray, "sensor 3"]:
    """Expected counts of all magnets at rest; exact bodies unless a model is given.

    A slip of the core moves the sensors rigidly against the shell, which is exact while the shell's
    outside is free.
    """
    magnets, sensors = magnet_layout(spec), slipped_sensors(spec)
    model = model or FieldModel(magnet_source(spec.magnets), "exact")
    field_t = total_field(sensors.position_mm, magnets.centre_mm, magnets.axis, model)
    return counts_of_field(1e3 * field_t, sensors.axes, spec.sensors)


def _sensors_of_the_model(spec: ObjectSpec) -> SensorLayout:
    """Where the slip moves the sensors instead of the magnets, the former are moved."""
    moved = spec.mechanics.slip.model == "sensors-only"
    return slipped_sensors(spec) if moved else sensor_layout(spec)


def min_distance_mm(
    motion: Float[np.ndarray, "press magnet 6"], magnets: MagnetLayout, sensors: SensorLayout
) -> float:
    """Smallest distance between a magnet's centre and a sensor over all presses and at rest.

    |c − s|² is expanded, so that one matrix product serves all sensors: 1e-14 of |c|² is lost.
    """
    chunk = max(1, _PAIRS_PER_CHUNK // len(magnets.face))
    smallest = _nearest_squared(magnets.centre_mm, sensors.position_mm)
    for start in range(0, len(motion), chunk):
        centre = (magnets.centre_mm + motion[start : start + chunk, :, :3]).reshape(-1, 3)
        smallest = min(smallest, _nearest_squared(centre, sensors.position_mm))
    return float(np.sqrt(max(smallest, 0.0)))


def _nearest_squared(
    centres_mm: Float[np.ndarray, "magnet 3"], positions_mm: Float[np.ndarray, "sensor 3"]
) -> float:
    squared = np.sum(centres_mm**2, axis=1) - 2 * positions_mm @ centres_mm.T
    return float(np.min(squared.min(axis=1) + np.sum(positions_mm**2, axis=1)))


def pressed_field(
    motion: Float[np.ndarray, "press magnet 6"],
    magnets: MagnetLayout,
    sensors: SensorLayout,
    model: FieldModel,
) -> Float[np.ndarray, "press sensor 3"]:
    """Flux density (T) at every sensor with the magnets moved, in cache-sized chunks.

    Presses run along the last dimension, one sensor at a time: long contiguous rows.
    """
    chunk = max(1, _PAIRS_PER_CHUNK // len(magnets.face))
    field = np.empty((len(motion), len(sensors.face), 3))
    rest, axis = components(magnets.centre_mm[:, None]), components(magnets.axis[:, None])
    for start in range(0, len(motion), chunk):
        x, y, z, *turn = motion[start : start + chunk].transpose(2, 1, 0).copy()
        centres = (rest[0] + x, rest[1] + y, rest[2] + z)
        axes = rotated(axis, tuple(turn))
        for sensor, position in enumerate(sensors.position_mm.tolist()):
            if model.name == "exact":
                _check_sensor_clear(position, centres, axes, model)
            parts = sum_over_magnets(tuple(position), centres, axes, model)
            field[start : start + chunk, sensor] = np.stack(parts, axis=-1)
    return field


def _check_sensor_clear(
    position_mm: list[float], centres_mm: Vector, axes: Vector, model: FieldModel
) -> None:
    offset = tuple(p - c for p, c in zip(position_mm, centres_mm, strict=True))
    if model.magnet.holds(offset, axes).any():
        raise InputError(
            f"a press drives {model.magnet.description} onto a sensor. "
            "Press less deep or increase sensors.depth_below_core_face_mm"
        )


def require_finite(signals: Signals) -> None:
    """Raise InputError that names the channel where forces or signals are not finite."""
    if not np.isfinite(signals.force_n).all():
        count = int(np.sum(~np.isfinite(signals.force_n)))
        raise InputError(f"the force of {count} presses is not finite. Simulate the presses anew")
    per_channel = np.sum(~np.isfinite(signals.delta_counts), axis=(0, 1, 2))
    bad = np.argwhere((per_channel > 0) | ~np.isfinite(signals.baseline_counts))
    if bad.size:
        named = ", ".join(f"sensor {sensor + 1} {'XYZ'[axis]}" for sensor, axis in bad[:4])
        more = f" and {len(bad) - 4} more" if len(bad) > 4 else ""
        raise InputError(
            f"signals are not finite on {named}{more} (sensors counted over all faces; "
            f"{int(per_channel.max())} presses on the worst). Leave the sensor out of the layout, or "
            "simulate anew"
        )


def saturation_margin(signals: Signals, spec: ObjectSpec) -> float:
    """1 − (largest |expected counts| in any press or at rest) / full scale; negative if clipped."""
    pressed = np.abs(signals.baseline_counts + signals.delta_counts).max()
    largest = max(float(pressed), float(np.abs(signals.baseline_counts).max()))
    return 1 - largest / full_scale_counts(spec.sensors)


def save_signals(signals: Signals, path: Path | str) -> None:
    """Write the lattice's signals as NetCDF with units (`load_signals` reads them)."""
    import xarray as xr

    per_press = ("face", "place", "step")
    data = xr.Dataset(
        {
            "force_n": (per_press, signals.force_n, {"units": "N"}),
            "delta_counts": (
                (*per_press, "sensor", "axis"),
                signals.delta_counts,
                {"units": "count"},
            ),
            "baseline_counts": (("sensor", "axis"), signals.baseline_counts, {"units": "count"}),
            "lattice_x_mm": (("ix",), signals.lattice.x_mm, {"units": "mm"}),
            "lattice_y_mm": (("iy",), signals.lattice.y_mm, {"units": "mm"}),
        },
        coords={"face": signals.faces, "depth_mm": (("step",), signals.depth_mm, {"units": "mm"})},
        attrs={"schema_version": SCHEMA_VERSION},
    )
    with atomic_path(path) as temporary:
        data.to_netcdf(temporary, engine="h5netcdf")


def load_signals(path: Path | str) -> Signals:
    """Read what `save_signals` wrote.

    Raises
    ------
    InputError
        No such file, or not signals of this schema.
    """
    import xarray as xr

    if not Path(path).is_file():
        raise InputError(f"no signals at {path}. Simulate the presses first")
    try:
        with xr.open_dataset(path, engine="h5netcdf") as data:
            if data.attrs.get("schema_version") != SCHEMA_VERSION or "delta_counts" not in data:
                raise InputError(
                    f"{path} holds no signals of schema {SCHEMA_VERSION}. Simulate anew"
                )
            return Signals(
                data["face"].values,
                PlaceGrid(data["lattice_x_mm"].values, data["lattice_y_mm"].values),
                data["depth_mm"].values,
                data["force_n"].values,
                data["delta_counts"].values,
                data["baseline_counts"].values,
            )
    except (OSError, KeyError) as error:
        raise InputError(f"{path} is not a file of signals ({error}). Simulate anew") from None


def save_grid_signals(spec: ObjectSpec, signals: Signals, path: Path | str, seed: int) -> None:
    """Write the signals of the contact places alone, with one simulated reading of each press.

    `reading_counts` is noisy, rounded and clipped to the sensor's full scale (`hall.read_out`);
    `delta_counts` and `baseline_counts` are the expected counts behind it.
    """
    import xarray as xr

    places, grid = grid_places_in_lattice(spec), contact_grid(spec)
    delta = signals.delta_counts[:, places]
    expected = signals.baseline_counts + delta
    reading = read_out(expected, spec.sensors, np.random.default_rng(seed))
    per_press = ("face", "place", "step")
    channel = (*per_press, "sensor", "axis")
    data = xr.Dataset(
        {
            "force_n": (per_press, signals.force_n[:, places], {"units": "N"}),
            "delta_counts": (channel, delta, {"units": "count"}),
            "baseline_counts": (("sensor", "axis"), signals.baseline_counts, {"units": "count"}),
            "reading_counts": (channel, reading.astype(np.int32), {"units": "count"}),
        },
        coords={
            "face": signals.faces,
            "place": np.arange(len(places)),
            "x_mm": (("place",), grid.xy_mm[:, 0], {"units": "mm"}),
            "y_mm": (("place",), grid.xy_mm[:, 1], {"units": "mm"}),
            "depth_mm": (("step",), signals.depth_mm, {"units": "mm"}),
            "sensor": np.arange(delta.shape[3]),
            "sensor_face": (("sensor",), sensor_layout(spec).face),
            "axis": list("XYZ"),
        },
        attrs={
            "schema_version": SCHEMA_VERSION,
            "object": spec.name,
            "seed": seed,
            "source": "simulated",
        },
    )
    with atomic_path(path) as temporary:
        data.to_netcdf(temporary, engine="h5netcdf")
