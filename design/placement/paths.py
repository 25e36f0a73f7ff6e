"""Lengths of signal paths over the faces of an object, before it has contact locations."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.measures import signal_paths_mm, spots_over_bodies
from design.layout.places.positions import SensorLayout, magnet_layout
from design.spec.object import ObjectSpec

_SHARES = np.linspace(-0.75, 0.75, 7)
"""Shares of a face's half extents, where paths are looked at: a tip reaches about so far."""
_LONG = 0.9
"""Quantile of the paths that stands for the long ones."""


def long_path_mm(spec: ObjectSpec, sensors: SensorLayout) -> float:
    """The signal path that a tenth of the sensed faces exceeds, about; infinite where a magnet lies
    off its patch."""
    try:
        spots, magnets = spots_over_bodies(spec), magnet_layout(spec)
    except InputError:
        return float("inf")
    paths_by_face = [
        _paths(spec, number, spots, magnets.centre_mm, sensors) for number in spec.body.sensed
    ]
    paths = np.concatenate(paths_by_face)
    return float(np.quantile(paths, _LONG)) if np.isfinite(paths).all() else float("inf")


def _paths(
    spec: ObjectSpec,
    number: int,
    spots: Float[np.ndarray, "magnet 3"],
    magnets_mm: Float[np.ndarray, "magnet 3"],
    sensors: SensorLayout,
) -> Float[np.ndarray, "place"]:
    frame = face_frames(spec)[spec.body.sensed.index(number)]
    lattice = np.stack(np.meshgrid(_SHARES, _SHARES, indexing="ij"), axis=-1).reshape(-1, 2)
    places = lattice * frame.half_extents_mm
    places = places[frame.covers(places / 0.97)]
    touched = frame.to_object(np.column_stack([places, np.zeros(len(places))]))
    away = np.linalg.norm(touched[:, None] - spots, axis=-1)
    return signal_paths_mm(away, magnets_mm, sensors.position_mm[sensors.face == number])
