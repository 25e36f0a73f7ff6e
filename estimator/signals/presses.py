"""Signals of every sensor in every press: expected changes of counts over the press lattice.

Axis order: face pressed, place (of the press lattice or of the contact grid), step (depth),
sensor (all faces, face by face), chip axis (X, Y, Z).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid, contact_grid, grid_places_in_lattice
from design.layout.places.contact_places import contact_places, face_rows, pressed_nodes
from design.layout.places.positions import magnet_layout, sensor_layout
from design.netcdf import FileKind, read_netcdf, write_netcdf
from design.spec.object import ObjectSpec
from estimator.field.models import MagnetsModel, exact_model, magnets_model
from estimator.field.seating import require_seated
from estimator.field.sources import magnet_sources
from estimator.signals.continuation import continued
from estimator.signals.field_setup import counts, min_distance_mm, scene, sensed_field, zero_motion
from estimator.signals.hall import (
    check_rest,
    check_sensors_outside_magnets,
    full_scale_counts,
    read_out,
)
from fem.presses.results import MagnetMotions, PressForces

_PER_PRESS = "face place step"
_CHANNEL = f"{_PER_PRESS} sensor axis"
_SIGNALS = FileKind(
    "signals",
    {
        "force_n": (_PER_PRESS, "N"),
        "delta_counts": (_CHANNEL, "count"),
        "baseline_counts": ("sensor axis", "count"),
        "lattice_x_mm": ("ix", "mm"),
        "lattice_y_mm": ("iy", "mm"),
    },
    coordinates={"face": ("face", ""), "depth_mm": ("step", "mm")},
)
_GRID_SIGNALS = FileKind(
    "signals of contact locations",
    {
        "force_n": (_PER_PRESS, "N"),
        "delta_counts": (_CHANNEL, "count"),
        "baseline_counts": ("sensor axis", "count"),
        "reading_counts": (_CHANNEL, "count"),
    },
    coordinates={
        "face": ("face", ""),
        "place": ("place", ""),
        "x_mm": ("place", "mm"),
        "y_mm": ("place", "mm"),
        "depth_mm": ("step", "mm"),
        "sensor": ("sensor", ""),
        "sensor_face": ("sensor", ""),
        "axis": ("axis", ""),
    },
)
NOT_READ = np.iinfo(np.int32).min
"""Value of `reading_counts` at places that a face has not."""
Progress = Callable[[str], None]
"""Called with a line about each part that is done."""


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

    Forces and changes are NaN at places that a face has not.
    """

    faces: Int[np.ndarray, "face"]
    lattice: PlaceGrid
    depth_mm: Float[np.ndarray, "step"]
    force_n: Float[np.ndarray, "face place step"]
    delta_counts: Float[np.ndarray, "face place step sensor 3"]
    baseline_counts: Float[np.ndarray, "sensor 3"]

    @cached_property
    def pressed(self) -> Bool[np.ndarray, "face place"]:
        """Return which places of the lattice each face has."""
        return np.asarray(~np.isnan(self.force_n).all(axis=2))

    @cached_property
    def whole(self) -> Signals:
        """Continued smoothly to all places of the lattice, for splines: never to be read there."""
        if self.pressed.all():
            return self
        force, delta = self.force_n.copy(), self.delta_counts.copy()
        for index, pressed in enumerate(self.pressed):
            for values in (force, delta):
                values[index] = continued(values[index], pressed, self.lattice.shape)
        return replace(self, force_n=force, delta_counts=delta)


def press_signals(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    progress: Progress | None = None,
) -> Signals:
    """Expected signals of all sensors for the magnets' motions in every press.

    Each press moves the magnets of all faces, or the sensors where they sit in the shell.
    Displacement and finite rotation both change what a sensor feels. The field model is the
    cheapest whose error is at most 0.1 % at the smallest distance between a magnet and a sensor
    that any press reaches.

    Raises
    ------
    InputError
        A sensor lies in a magnet (at rest or pressed) or saturates at rest.
    """
    place = scene(spec)
    check_sensors_outside_magnets(place.sensors, place.magnets, magnet_sources(spec.magnets))
    model = magnets_model(spec.magnets, min_distance_mm(place, motions.all_motions))
    still = zero_motion(place) if motions.rest is None else motions.rest[None]
    baseline = counts(place, sensed_field(place, still, model)[0], spec)
    check_rest(baseline, place.sensors, spec.sensors)
    delta = np.full((*motions.motion.shape[:3], *baseline.shape), np.nan)
    for index, (face, here) in enumerate(zip(motions.faces, motions.pressed, strict=True)):
        motion = motions.motion[index, here].reshape(-1, place.bodies, 6)
        pressed = counts(place, sensed_field(place, motion, model), spec)
        delta[index, here] = pressed.reshape(-1, *delta.shape[2:]) - baseline
        if progress is not None:
            progress(f"face {face}: field of {motion.shape[0]} presses at {len(baseline)} sensors")
    return Signals(
        motions.faces, motions.lattice, motions.depth_mm, forces.force_n, delta, baseline
    )


def rest_counts(
    spec: ObjectSpec, model: MagnetsModel | None = None
) -> Float[np.ndarray, "sensor 3"]:
    """Expected counts of all sensors at rest; exact bodies unless a model is given.

    A slip of the core moves what it carries rigidly against the shell, which is exact while the
    shell's outside is free.
    """
    place = scene(spec, core_slipped=True)
    model = model or exact_model(spec.magnets)
    return counts(place, sensed_field(place, zero_motion(place), model)[0], spec)


def checked_rest_counts(spec: ObjectSpec) -> Float[np.ndarray, "sensor 3"]:
    """Return `rest_counts` of an object whose sensors do not saturate at rest, none of them in a magnet, and
    whose magnets stay in their pockets while they are set.

    Raises
    ------
    InputError
        It says which sensor or magnet, by how much, and which key to change.
    """
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    check_sensors_outside_magnets(sensors, magnets, magnet_sources(spec.magnets))
    at_rest = rest_counts(spec)
    check_rest(at_rest, sensors, spec.sensors)
    require_seated(spec)
    return at_rest


def require_finite(spec: ObjectSpec, signals: Signals) -> None:
    """Raise InputError that names the channel where forces or signals are not finite.

    They must be at every place that a face has, and there alone.
    """
    pressed = pressed_nodes(spec)[face_rows(spec, signals.faces)]
    missing = ~np.isfinite(signals.force_n)
    if missing[pressed].any():
        count = int(missing[pressed].sum())
        raise InputError(f"the force of {count} presses is not finite. Simulate the presses anew")
    if not missing[~pressed].all():
        raise InputError(
            "the signals hold presses at places that contact_grid leaves out. Simulate them anew"
        )
    per_channel = np.sum(~np.isfinite(signals.delta_counts[pressed]), axis=(0, 1))
    bad = np.argwhere((per_channel > 0) | ~np.isfinite(signals.baseline_counts))
    if bad.size:
        per_face = len(signals.baseline_counts) // len(signals.faces)
        named = ", ".join(
            f"F{signals.faces[sensor // per_face]}-{'XYZ'[axis]}{sensor % per_face + 1}"
            for sensor, axis in bad[:4]
        )
        more = f" and {len(bad) - 4} more" if len(bad) > 4 else ""
        raise InputError(
            f"signals are not finite on {named}{more} ("
            f"{int(per_channel.max())} presses on the worst). Leave the sensor out of the layout, or "
            "simulate anew"
        )


def saturation_margin(signals: Signals, spec: ObjectSpec) -> float:
    """1 − (largest |expected counts| in any press or at rest) / full scale; negative if clipped."""
    delta = signals.delta_counts
    delta = delta if signals.pressed.all() else delta[signals.pressed]
    pressed = np.abs(signals.baseline_counts + delta).max()
    largest = max(float(pressed), float(np.abs(signals.baseline_counts).max()))
    return 1 - largest / full_scale_counts(spec.sensors)


def save_signals(signals: Signals, path: Path | str) -> None:
    """Write the lattice's signals as NetCDF with units (`load_signals` reads them)."""
    values = {
        "force_n": signals.force_n,
        "delta_counts": signals.delta_counts,
        "baseline_counts": signals.baseline_counts,
        "lattice_x_mm": signals.lattice.x_mm,
        "lattice_y_mm": signals.lattice.y_mm,
        "face": signals.faces,
        "depth_mm": signals.depth_mm,
    }
    write_netcdf(_SIGNALS, path, values)


def load_signals(path: Path | str) -> Signals:
    """Read what `save_signals` wrote.

    Raises
    ------
    InputError
        No such file.
    StoreError
        Damaged, or not signals of this schema.
    """
    values, _ = read_netcdf(_SIGNALS, path)
    return Signals(
        values["face"],
        PlaceGrid(values["lattice_x_mm"], values["lattice_y_mm"]),
        values["depth_mm"],
        values["force_n"],
        values["delta_counts"],
        values["baseline_counts"],
    )


def save_grid_signals(spec: ObjectSpec, signals: Signals, path: Path | str, seed: int) -> None:
    """Write the signals of the contact locations alone, with one simulated reading of each press.

    `reading_counts` is noisy, rounded and clipped to the sensor's full scale (`hall.read_out`);
    `delta_counts` and `baseline_counts` are the expected counts behind it. Places that a face has not
    are NaN, `NOT_READ` among the readings.
    """
    places, grid = grid_places_in_lattice(spec), contact_grid(spec)
    delta = signals.delta_counts[:, places]
    expected = signals.baseline_counts + delta
    has_place, rng = contact_places(spec), np.random.default_rng(seed)
    reading = np.full(expected.shape, NOT_READ, np.int32)
    reading[has_place] = read_out(expected[has_place], spec.sensors, rng).astype(np.int32)
    values = {
        "force_n": signals.force_n[:, places],
        "delta_counts": delta,
        "baseline_counts": signals.baseline_counts,
        "reading_counts": reading,
        "face": signals.faces,
        "place": np.arange(len(places)),
        "x_mm": grid.xy_mm[:, 0],
        "y_mm": grid.xy_mm[:, 1],
        "depth_mm": signals.depth_mm,
        "sensor": np.arange(delta.shape[3]),
        "sensor_face": sensor_layout(spec).face,
        "axis": list("XYZ"),
    }
    attributes = {"object": spec.name, "seed": seed, "source": "simulated"}
    write_netcdf(_GRID_SIGNALS, path, values, attributes)
