"""Where faces, contact places, magnets and sensors are, in the object's frame.

Object frame: origin at the body's centre, face 1 outward = +z, the open face 6 = −z.
Every array that is indexed by magnet or sensor runs face by face (1…5), in the order of the
specification within a face.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from design.pockets import pockets
from design.spec import SENSED_FACES, ObjectSpec

_FACE_AXES = {
    1: ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    2: ((0, -1, 0), (0, 0, -1), (1, 0, 0)),
    3: ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    4: ((0, 1, 0), (0, 0, -1), (-1, 0, 0)),
    5: ((-1, 0, 0), (0, 0, -1), (0, -1, 0)),
}
"""Face number → outward normal n and in-plane x, y (right-handed: x × y = n)."""


@dataclass(frozen=True)
class FaceFrame:
    """One sensed face: its number, orthonormal axes, centre and half extents (mm)."""

    number: int
    normal: Float[np.ndarray, "3"]
    x: Float[np.ndarray, "3"]
    y: Float[np.ndarray, "3"]
    centre_mm: Float[np.ndarray, "3"]
    half_extents_mm: tuple[float, float]

    @property
    def axes(self) -> Float[np.ndarray, "3 3"]:
        """Rotation whose columns are x, y, n: face coordinates to object coordinates."""
        return np.column_stack([self.x, self.y, self.normal])

    def to_object(self, xyz_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Points given as (x, y, height above the face) in mm, in the object's frame."""
        return self.centre_mm + np.asarray(xyz_mm, float) @ self.axes.T

    def from_object(self, points_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Inverse of `to_object`."""
        return (np.asarray(points_mm, float) - self.centre_mm) @ self.axes


def face_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces of the body in the order 1…5."""
    half = np.asarray(spec.body.size_mm) / 2
    frames = []
    for number in SENSED_FACES:
        normal, x, y = (np.asarray(axis, float) for axis in _FACE_AXES[number])
        extents = (float(abs(x) @ half), float(abs(y) @ half))
        frames.append(FaceFrame(number, normal, x, y, normal * (abs(normal) @ half), extents))
    return tuple(frames)


@dataclass(frozen=True)
class PlaceGrid:
    """A rectangular grid of contact places on a face; place index = ix · len(y_mm) + iy."""

    x_mm: Float[np.ndarray, "nx"]
    y_mm: Float[np.ndarray, "ny"]

    @property
    def shape(self) -> tuple[int, int]:
        return len(self.x_mm), len(self.y_mm)

    @property
    def xy_mm(self) -> Float[np.ndarray, "place 2"]:
        x, y = np.meshgrid(self.x_mm, self.y_mm, indexing="ij")
        return np.column_stack([x.ravel(), y.ravel()])

    def __len__(self) -> int:
        return len(self.x_mm) * len(self.y_mm)


def contact_grid(spec: ObjectSpec) -> PlaceGrid:
    """The specification's places (the paper: 10 × 10, pitch 3 mm, ±13.5 about the face centre)."""
    grid = spec.contact_grid
    x, y = ((np.arange(n) - (n - 1) / 2) * grid.pitch_mm for n in grid.count)
    return PlaceGrid(x, y)


def press_lattice(spec: ObjectSpec) -> PlaceGrid:
    """The contact grid refined by two, with half a pitch of margin: (2n + 1) places an axis.

    Contact place (X, Y) is lattice place (2X + 1, 2Y + 1). Signals between places are
    interpolated on this lattice, and derivatives in x and y are taken on it.
    """
    grid = spec.contact_grid
    x, y = ((np.arange(2 * n + 1) - n) * grid.pitch_mm / 2 for n in grid.count)
    return PlaceGrid(x, y)


def grid_places_in_lattice(spec: ObjectSpec) -> Int[np.ndarray, "place"]:
    """Lattice place of each contact place, in the order of the contact grid."""
    nx, ny = spec.contact_grid.count
    ix, iy = np.meshgrid(2 * np.arange(nx) + 1, 2 * np.arange(ny) + 1, indexing="ij")
    return (ix * (2 * ny + 1) + iy).ravel()


@dataclass(frozen=True)
class MagnetLayout:
    """Magnets at rest: centre (mm), unit axis along the polarization, and the face they sit in."""

    centre_mm: Float[np.ndarray, "magnet 3"]
    axis: Float[np.ndarray, "magnet 3"]
    face: Int[np.ndarray, "magnet"]


@dataclass(frozen=True)
class SensorLayout:
    """Sensors: sensing point (mm), chip axes as rows (X, Y, Z in the object's frame), face."""

    position_mm: Float[np.ndarray, "sensor 3"]
    axes: Float[np.ndarray, "sensor 3 3"]
    face: Int[np.ndarray, "sensor"]


def magnet_layout(spec: ObjectSpec) -> MagnetLayout:
    """All magnets as cast, face by face, north outward."""
    local = pockets(spec.shell, spec.magnets)
    centre = np.stack([pocket.centre_mm for pocket in local])
    axis = np.stack([pocket.axis for pocket in local])
    frames = face_frames(spec)
    return MagnetLayout(
        np.concatenate([frame.to_object(centre) for frame in frames]),
        np.concatenate([axis @ frame.axes.T for frame in frames]),
        np.repeat([frame.number for frame in frames], len(local)),
    )


def sensor_layout(spec: ObjectSpec) -> SensorLayout:
    """All sensors, face by face; azimuths run counter-clockwise from x, seen from outside.

    Chip axes (facts measured on the recordings): X = −tangential, Y = radial outward,
    Z = outward normal of the face.
    """
    sensors = spec.sensors
    position, axes, face = [], [], []
    depth = spec.shell.thickness_mm + sensors.depth_below_core_face_mm
    for frame, first in zip(face_frames(spec), sensors.first_azimuth_deg, strict=True):
        for k in range(sensors.count_per_face):
            azimuth = np.deg2rad(first + 360 * k / sensors.count_per_face)
            radial = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
            tangential = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
            position.append(frame.to_object(sensors.radius_mm * radial - [0, 0, depth]))
            axes.append(np.stack([-tangential, radial, [0.0, 0.0, 1.0]]) @ frame.axes.T)
            face.append(frame.number)
    return SensorLayout(np.array(position), np.array(axes), np.array(face))


def slipped_sensors(spec: ObjectSpec) -> SensorLayout:
    """The sensors moved with the core by `mechanics.slip`, in the shell's frame."""
    from scipy.spatial.transform import Rotation

    sensors, slip = sensor_layout(spec), spec.mechanics.slip
    if not slip.slipped:
        return sensors
    turn = Rotation.from_rotvec(np.deg2rad(slip.rotation_deg)).as_matrix()
    position = sensors.position_mm @ turn.T + np.asarray(slip.shift_mm, float)
    return SensorLayout(position, sensors.axes @ turn.T, sensors.face)
