"""Where faces, contact places, magnets and sensors are, in the object's frame.

Every array that is indexed by magnet or sensor runs face by face, in the order of the
specification within a face.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from jaxtyping import Float, Int

from design.body.kinds import core_frames, face_frame, face_frames
from design.body.surface_chart import FaceFrame
from design.layout.as_built import magnets_as_built, sensors_as_built
from design.layout.pockets import Body, Outline, magnet_bodies, sensor_boards, shell_bodies
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec, SensorSpec

__all__ = ["FaceFrame", "core_frames", "face_frame", "face_frames"]


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
    """Magnets at rest: centre (mm), unit axis along the polarization, the face they belong to.

    `side` is the unit vector along a block's first edge (the face's x, where it is not tilted);
    `strength` is each one's polarization over the specification's.
    """

    centre_mm: Float[np.ndarray, "magnet 3"]
    axis: Float[np.ndarray, "magnet 3"]
    face: Int[np.ndarray, "magnet"]
    side: Float[np.ndarray, "magnet 3"]
    strength: Float[np.ndarray, "magnet"]


@dataclass(frozen=True)
class SensorLayout:
    """Sensors: sensing point (mm), chip axes as rows (X, Y, Z in the object's frame), face."""

    position_mm: Float[np.ndarray, "sensor 3"]
    axes: Float[np.ndarray, "sensor 3 3"]
    face: Int[np.ndarray, "sensor"]


Layout = TypeVar("Layout", MagnetLayout, SensorLayout)


@dataclass(frozen=True)
class ShellBodies:
    """Rigid bodies in the silicone: magnets, or sensor boards in the reverse arrangement.

    `frame` holds their axes as columns (the third along the height), in the object's frame; all
    have one outline and height.
    """

    centre_mm: Float[np.ndarray, "body 3"]
    frame: Float[np.ndarray, "body 3 3"]
    face: Int[np.ndarray, "body"]
    outline: Outline
    height_mm: float

    @property
    def volume_mm3(self) -> float:
        """Of one body."""
        return self.outline.area_mm2 * self.height_mm


def shell_body_layout(spec: ObjectSpec) -> ShellBodies:
    """What moves with the silicone, face by face."""
    bodies = shell_bodies(spec)
    first = bodies[0][0]
    return ShellBodies(*_in_object(face_frames(spec), bodies), first.outline, first.height_mm)


def magnet_layout(spec: ObjectSpec) -> MagnetLayout:
    """All magnets, face by face, as designed or as `as_built` found them; axes point north."""
    in_shell = spec.arrangement == "sensors-in-core"
    frames = face_frames(spec) if in_shell else core_frames(spec)
    centre, frame, face = _in_object(frames, magnet_bodies(spec))
    north = np.tile(spec.magnets.polarities, len(frames))[:, None] * frame[:, :, 2]
    designed = MagnetLayout(centre, north, face, frame[:, :, 0], np.ones(len(face)))
    return magnets_as_built(spec, designed, frames)


def sensor_layout(spec: ObjectSpec) -> SensorLayout:
    """All sensors, face by face, as designed or as `as_built` found them; azimuths run
    counter-clockwise from x, seen from outside.

    Chip axes of a chip that faces inward (facts measured on the recordings): X = −tangential,
    Y = radial outward, Z = outward normal of the face where the chip is.
    """
    if spec.arrangement == "sensors-in-core":
        frames, bodies = core_frames(spec), _sensors_in_core(spec)
    else:
        frames, bodies = face_frames(spec), sensor_boards(spec)
    centre, frame, face = _in_object(frames, bodies)
    axes = (frame @ chip_on_board(spec.sensors)).transpose(0, 2, 1)
    return sensors_as_built(spec, SensorLayout(centre, axes, face), frames)


def _sensors_in_core(spec: ObjectSpec) -> tuple[tuple[Body, ...], ...]:
    depth = spec.sensors.depth_below_core_face_mm
    return tuple(
        tuple(replace(board, centre_mm=np.append(board.centre_mm[:2], -depth)) for board in face)
        for face in sensor_boards(spec)
    )


def chip_on_board(sensors: SensorSpec) -> Float[np.ndarray, "3 3"]:
    """The chip's axes as columns, in the board's (−tangential, radial, normal)."""
    turn = np.deg2rad(sensors.mount_rotation_deg)
    angle = float(np.linalg.norm(turn))
    across = np.cross(np.eye(3), turn)
    rotation = np.eye(3) + np.sinc(angle / np.pi) * across
    rotation += 0.5 * np.sinc(angle / (2 * np.pi)) ** 2 * across @ across
    outward = np.diag([-1.0, 1.0, -1.0])
    return outward @ rotation if sensors.chip == "outward" else rotation


def _in_object(
    frames: tuple[FaceFrame, ...], bodies: tuple[tuple[Body, ...], ...]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Centres, axes as columns and faces of bodies given face by face in the faces' own frames."""
    placed = [(frame, body) for frame, face in zip(frames, bodies, strict=True) for body in face]
    return (
        np.stack([frame.to_object(body.centre_mm) for frame, body in placed]),
        np.stack([frame.axes_at(body.centre_mm[:2]) @ body.frame for frame, body in placed]),
        np.array([frame.number for frame, _ in placed]),
    )


def slipped(layout: Layout, slip: SlipSpec) -> Layout:
    """Magnets or sensors moved with a core that slipped, in the shell's frame."""
    from scipy.spatial.transform import Rotation

    if not slip.slipped:
        return layout
    turn = Rotation.from_rotvec(np.deg2rad(slip.rotation_deg)).as_matrix().T
    shift = np.asarray(slip.shift_mm, float)
    if isinstance(layout, SensorLayout):
        position = layout.position_mm @ turn + shift
        return replace(layout, position_mm=position, axes=layout.axes @ turn)
    centre = layout.centre_mm @ turn + shift
    return replace(layout, centre_mm=centre, axis=layout.axis @ turn, side=layout.side @ turn)
