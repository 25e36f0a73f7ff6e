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
from estimator.field.environment import environment
from estimator.field.forces import plate_loads
from estimator.field.models import exact_model
from estimator.signals.field_setup import counts, scene, sensed_field
from estimator.signals.presses import rest_counts

TYPICAL_EARTH_UT = 50.0
"""Between 25 µT near the equator and 65 µT near the poles."""
PERMEABILITY = {"steel": 1000.0, "aluminium": 1.000022, "plastic": 1.0}
"""Relative permeability of what jaws are made of; aluminium at 20 °C (CRC Handbook: χ = 2.2e-5)."""


@dataclass(frozen=True)
class Surroundings:
    """Changes of resting channels, counts.

    Attributes
    ----------
    earth_field_ut : the specification's, or a typical one where it gives none
    turning_largest_counts : largest change of a channel when the object is turned over in it
    turning_rms_counts : rms change of a channel between two random orientations
    jaw_counts : (face, gap) largest change of a face's own channels by a steel jaw that covers it
    jaw_elsewhere_counts : (face, gap) largest change of any other face's channels
    jaw_pull_n : (face, gap) largest force on a magnet
    """

    earth_field_ut: float
    turning_largest_counts: float
    turning_rms_counts: float
    jaw_counts: Float[np.ndarray, "face gap"]
    jaw_elsewhere_counts: Float[np.ndarray, "face gap"]
    jaw_pull_n: Float[np.ndarray, "face gap"]


def surroundings(spec: ObjectSpec, jaw_gap_mm: tuple[float, ...]) -> Surroundings:
    """Turning in Earth's field, and a steel jaw at one face after another, with each of the gaps between.

    The jaw is a half-space, an upper bound of real ones (`estimator.field.environment`).
    """
    earth_ut = spec.environment.earth_size_ut or TYPICAL_EARTH_UT
    per_channel = spec.sensors.counts_per_mt * 1e-3 * earth_ut
    jaws = [[with_jaw(spec, frame, gap) for gap in jaw_gap_mm] for frame in face_frames(spec)]
    rest = rest_counts(spec)
    size = np.array([[abs(rest_counts(jaw) - rest).max(axis=1) for jaw in row] for row in jaws])
    is_own_face = sensors_of_faces(spec)[:, None] == scene(spec).sensors.face
    return Surroundings(
        earth_ut,
        2 * per_channel,
        float(np.sqrt(2 / 3) * per_channel),
        np.where(is_own_face[:, None], size, 0.0).max(axis=-1),
        np.where(is_own_face[:, None], 0.0, size).max(axis=-1),
        np.array([[longest(pull(jaw)) for jaw in row] for row in jaws]),
    )


def sensors_of_faces(spec: ObjectSpec) -> Int[np.ndarray, "face"]:
    """The numbers of the faces that have sensors, in order."""
    return np.array([frame.number for frame in face_frames(spec)])


def with_jaw(
    spec: ObjectSpec, frame: FaceFrame, gap_mm: float, material: str = "steel"
) -> ObjectSpec:
    """Return the object with a jaw that covers a face; its plate is the environment's last one."""
    x, y, z = frame.to_object(np.array([0.0, 0.0, gap_mm])).tolist()
    nx, ny, nz = (-frame.normal).tolist()
    jaw = SteelPlateSpec(
        position_mm=(x, y, z),
        normal=(nx, ny, nz),
        relative_permeability=PERMEABILITY[material],
    )
    plates = (*spec.environment.steel_plates, jaw)
    return spec.changed(environment=spec.environment.changed(steel_plates=plates))


def pull(jaw: ObjectSpec) -> Float[np.ndarray, "magnet 6"]:
    """Return force (N) and torque (N mm) on every magnet by a jaw (`with_jaw`)."""
    return plate_loads(jaw, environment(jaw).plates[-1])


def longest(vectors: Float[np.ndarray, "magnet 6"]) -> float:
    """Return the largest length of forces (N) or displacements (mm), the first three components."""
    return float(np.linalg.norm(vectors[:, :3], axis=1).max())


def moved_counts(
    spec: ObjectSpec, motion: Float[np.ndarray, "body 6"]
) -> Float[np.ndarray, "sensor 3"]:
    """Return expected counts of all sensors with the shell's bodies moved; exact bodies."""
    place = scene(spec, core_slipped=True)
    return counts(place, sensed_field(place, motion[None], exact_model(spec.magnets))[0], spec)
