"""Effect of surroundings on the resting signals, in counts.

A face's own estimator works on changes against a zero taken somewhere else, or a while ago: what
turning the object, or an approaching jaw adds to a channel looks like a press.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.spec.environment import SteelPlateSpec
from design.spec.object import ObjectSpec
from estimator.signals.field_setup import scene
from estimator.signals.presses import rest_counts

TYPICAL_EARTH_UT = 50.0
"""Between 25 µT near the equator and 65 µT near the poles."""


@dataclass(frozen=True)
class Surroundings:
    """Changes of resting channels, counts.

    Attributes
    ----------
    earth_field_ut : the specification's, or a typical one where it gives none
    turning_largest_counts : largest change of a channel when the object is turned over in it
    turning_rms_counts : rms change of a channel between two random orientations
    jaw_gap_mm : gaps between a face and a steel jaw that covers it
    jaw_counts : (face, gap) largest change of that face's own channels
    jaw_elsewhere_counts : (face, gap) largest change of any other face's channels
    """

    earth_field_ut: float
    turning_largest_counts: float
    turning_rms_counts: float
    jaw_gap_mm: Float[np.ndarray, "gap"]
    jaw_counts: Float[np.ndarray, "face gap"]
    jaw_elsewhere_counts: Float[np.ndarray, "face gap"]


def surroundings(spec: ObjectSpec, jaw_gap_mm: tuple[float, ...] = (0.0, 10.0)) -> Surroundings:
    """Turning in Earth's field, and a steel jaw at one face after another.

    The jaw is a half-space of relative permeability 1000, an upper bound
    (`estimator.field.environment`).
    """
    earth_ut = spec.environment.earth_field_ut or TYPICAL_EARTH_UT
    per_channel = spec.sensors.counts_per_mt * 1e-3 * earth_ut
    changes = np.array(
        [[jaw_change(spec, frame, gap) for gap in jaw_gap_mm] for frame in face_frames(spec)]
    )
    size = np.abs(changes).max(axis=-1)
    is_own_face = sensors_of_faces(spec)[:, None] == scene(spec).sensors.face
    return Surroundings(
        earth_ut,
        2 * per_channel,
        float(np.sqrt(2 / 3) * per_channel),
        np.asarray(jaw_gap_mm, float),
        np.where(is_own_face[:, None], size, 0.0).max(axis=-1),
        np.where(is_own_face[:, None], 0.0, size).max(axis=-1),
    )


def sensors_of_faces(spec: ObjectSpec) -> Int[np.ndarray, "face"]:
    """The numbers of the faces that have sensors, in order."""
    return np.array([frame.number for frame in face_frames(spec)])


def jaw_change(spec: ObjectSpec, frame: FaceFrame, gap_mm: float) -> Float[np.ndarray, "sensor 3"]:
    """Change of every resting channel (counts) when a steel jaw comes to a face."""
    surface = frame.to_object(np.array([0.0, 0.0, gap_mm]))
    x, y, z = surface.tolist()
    nx, ny, nz = (-frame.normal).tolist()
    jaw = SteelPlateSpec(position_mm=(x, y, z), normal=(nx, ny, nz))
    plates = (*spec.environment.steel_plates, jaw)
    beside = spec.environment.changed(steel_plates=plates)
    return rest_counts(spec.changed(environment=beside)) - rest_counts(spec)
