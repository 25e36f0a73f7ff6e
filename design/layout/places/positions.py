"""Magnets and sensors in the object's frame, as designed and as built.

Every array that is indexed by magnet or sensor runs face by face, in the order of the
specification within a face. Sensors see the layout as built; mechanics goes on with the design: a
magnet found 0.3 mm from its seat is carried by the motion of the seat (`estimator.tolerances.budget`
says how wrong that is).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from jaxtyping import Bool, Float, Int

from design.body.surface_chart import FaceFrame
from design.layout.body import core_frames, face_frames
from design.layout.pockets import (
    Body,
    Outline,
    board_frame,
    lists_of_sensed_faces,
    magnet_bodies,
    sensor_boards,
    sensor_places,
    shell_bodies,
)
from design.spec.assembly import BuiltMagnet
from design.spec.cached_geometry import cached_geometry
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec, SensorSpec


@dataclass(frozen=True)
class MagnetLayout:
    """Magnets at rest: centre (mm), unit axis along the polarization, the face they belong to.

    `side` is the unit vector along a block's first edge (the face's x, where it is not tilted);
    `strength` is each one's polarization over that of one of its size and the first one's remanence;
    `size` is which of `magnets.distinct_sizes` it has.
    """

    centre_mm: Float[np.ndarray, "magnet 3"]
    axis: Float[np.ndarray, "magnet 3"]
    face: Int[np.ndarray, "magnet"]
    side: Float[np.ndarray, "magnet 3"]
    strength: Float[np.ndarray, "magnet"]
    size: Int[np.ndarray, "magnet"]

    @property
    def frames(self) -> Float[np.ndarray, "magnet 3 3"]:
        """Axes of each as columns: side, across, along the polarization."""
        return np.stack([self.side, np.cross(self.axis, self.side), self.axis], axis=-1)


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

    `frame` holds their axes as columns (the third along the height), in the object's frame.
    """

    centre_mm: Float[np.ndarray, "body 3"]
    frame: Float[np.ndarray, "body 3 3"]
    face: Int[np.ndarray, "body"]
    bodies: tuple[Body, ...]
    """The same in their faces' own frames: outline and height of each."""

    @property
    def volume_mm3(self) -> Float[np.ndarray, "body"]:
        return np.array([body.volume_mm3 for body in self.bodies])


@cached_geometry
def shell_body_layout(spec: ObjectSpec) -> ShellBodies:
    """Return what moves with the silicone, face by face."""
    bodies = shell_bodies(spec)
    all_bodies = tuple(body for face in bodies for body in face)
    return ShellBodies(*_transform_to_object(face_frames(spec), bodies), all_bodies)


def cover_mm(frame: FaceFrame, body: Body) -> float:
    """Silicone over a rigid body of a face, where it is thinnest; negative where the body stands out.

    Measured from the rims of both its ends along the surface's normals; NaN off the patch.
    """
    return float(covers_mm(frame, (body,))[0])


def covers_mm(frame: FaceFrame, bodies: tuple[Body, ...]) -> Float[np.ndarray, "body"]:
    """The same of several bodies of a face, found together."""
    rims = np.concatenate([_rims_mm(frame, body) for body in bodies])
    ends = np.cumsum([2 * _corners_of(body.outline) for body in bodies])
    above = frame.from_object(rims)[:, 2]
    return np.array([-heights.max() for heights in np.split(above, ends[:-1])])


@cached_geometry
def shell_covers_mm(spec: ObjectSpec) -> tuple[Float[np.ndarray, "body"], ...]:
    """The same of all that moves with the silicone, face by face."""
    faces = zip(face_frames(spec), shell_bodies(spec), strict=True)
    return tuple(covers_mm(frame, bodies) for frame, bodies in faces)


def _corners_of(outline: Outline) -> int:
    return _RIM_POINTS if outline.round else 4


def _rims_mm(frame: FaceFrame, body: Body) -> Float[np.ndarray, "point 3"]:
    """Points round both ends of a body, in the object's frame."""
    outline = body.outline
    turn = np.linspace(0, 2 * np.pi, _RIM_POINTS, endpoint=False)
    circle = outline.half_mm[0] * np.column_stack([np.cos(turn), np.sin(turn)])
    rim = circle if outline.round else outline.corners_mm(4)
    ends = [np.column_stack([rim, [end * body.height_mm / 2] * len(rim)]) for end in (-1, 1)]
    axes = frame.axes_at(body.centre_mm[:2]) @ body.frame
    return frame.to_object(body.centre_mm) + np.concatenate(ends) @ axes.T


@cached_geometry
def magnet_layout(spec: ObjectSpec) -> MagnetLayout:
    """All magnets, face by face, as designed or as `as_built` found them; axes point north."""
    in_shell = spec.arrangement == "sensors-in-core"
    frames = face_frames(spec) if in_shell else core_frames(spec)
    centre, frame, face = _transform_to_object(frames, magnet_bodies(spec))
    north = np.tile(spec.magnets.polarities, len(frames))[:, None] * frame[:, :, 2]
    strength, size = (
        np.tile(each, len(frames)) for each in (spec.magnets.strengths, spec.magnets.size_numbers)
    )
    designed = MagnetLayout(centre, north, face, frame[:, :, 0], strength, size)
    return magnets_as_built(spec, designed, frames)


_RIM_POINTS = 48
_RIM = np.array(
    [[x, y] for x in (-1, -0.5, 0, 0.5, 1) for y in (-1, -0.5, 0, 0.5, 1) if 1 in (abs(x), abs(y))]
)
"""Points round a rectangle, in shares of its half edges."""


@cached_geometry
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
    centre, frame, face = _transform_to_object(frames, bodies)
    if spec.sensors.rotations_deg is None:
        axes = (frame @ chip_on_board(spec.sensors)).transpose(0, 2, 1)
    else:
        axes = _turned_chips(spec, frames, bodies)
    return sensors_as_built(spec, SensorLayout(centre, axes, face), frames)


def _turned_chips(
    spec: ObjectSpec, frames: tuple[FaceFrame, ...], bodies: tuple[tuple[Body, ...], ...]
) -> Float[np.ndarray, "sensor 3 3"]:
    """Chip axes as rows by `sensors.rotations_deg`, from the axes of the face where each chip is."""
    lists = lists_of_sensed_faces(spec, spec.sensors.rotations_deg or ())
    return np.stack(
        [
            (frame.axes_at(body.centre_mm[:2]) @ rotation_matrix(vector)).T
            for frame, face, vectors in zip(frames, bodies, lists, strict=True)
            for body, vector in zip(face, vectors, strict=True)
        ]
    )


def _sensors_in_core(spec: ObjectSpec) -> tuple[tuple[Body, ...], ...]:
    depth = spec.sensors.depth_below_core_face_mm
    return tuple(
        tuple(
            replace(board, centre_mm=np.append(board.centre_mm[:2], -depth - sink))
            for board, sink in zip(face, sinks, strict=True)
        )
        for face, sinks in zip(sensor_boards(spec), board_sinks_mm(spec), strict=True)
    )


BoardPlace = tuple[tuple[float, float, float], float]
"""(x, y, azimuth) of a sensor on the core, and by how much its board lies deeper (mm)."""


def board_places(spec: ObjectSpec) -> list[tuple[FaceFrame, list[BoardPlace]]]:
    """Frame of the core and places of its sensors, sensed face by face."""
    faces = zip(core_frames(spec), sensor_places(spec), board_sinks_mm(spec), strict=True)
    return [(frame, list(zip(places, sinks, strict=True))) for frame, places, sinks in faces]


@cached_geometry
def board_sinks_mm(spec: ObjectSpec) -> tuple[tuple[float, ...], ...]:
    """Depth by which every board lies deeper than on a flat core, sensed face by face (mm).

    Under a flat board a curved core falls away: the board, its chip and the recess's floor go down
    until no corner stands out of the core into the silicone. 0 on flat faces; NaN where a board
    reaches beyond its patch, or no depth makes it flush.
    """
    return tuple(
        tuple(sinks_of_boards_mm(spec, frame, np.asarray(places)).tolist())
        for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True)
    )


@dataclass(frozen=True)
class MountedStack:
    """Board and chip in a recess: (x, y) of the board's middle in the face's frame, levels (mm)."""

    board_xy_mm: Float[np.ndarray, "2"]
    board_top_mm: float
    chip_top_mm: float


def mounted_stack(spec: ObjectSpec, place: tuple[float, float, float]) -> MountedStack:
    """Stack of board and chip as on a flat core: a chip that faces inward hangs under a board that is
    flush with the face, one that faces outward stands on a board on the recess's floor."""
    core, sensors, (x, y, azimuth) = spec.core, spec.sensors, place
    middle = (core.recess_inner_radius_mm + core.recess_outer_radius_mm) / 2
    radial = np.array([np.cos(azimuth), np.sin(azimuth)])
    board_xy = np.array([x, y]) + (middle - sensors.radius_mm) * radial
    thick, high = sensors.package_mm[2], sensors.chip_mm[2]
    if sensors.chip == "inward":
        return MountedStack(board_xy, 0.0, -thick)
    return MountedStack(board_xy, thick - core.recess_depth_mm, thick + high - core.recess_depth_mm)


def sinks_of_boards_mm(
    spec: ObjectSpec, frame: FaceFrame, places: Float[np.ndarray, "board 3"]
) -> Float[np.ndarray, "board"]:
    """Depth by which boards at (x, y, azimuth) of a core's patch lie deeper than on a flat core (mm).

    As deep as the point round board or chip that needs most, down along the normal at the place: a
    corner, or on a saddle the middle of an edge.
    """
    if frame.flat:
        return np.zeros(len(places))
    corners, tops = rims_of_stack(spec, places)
    xy = places[:, :2]
    axes = frame.axes_at(xy)
    touching = frame.to_object(np.column_stack([xy, np.zeros(len(xy))]))
    # b body, c corner, j own axis in the plane (x, y), i object coordinate
    points = touching[:, None] + np.einsum("bij,bcj->bci", axes[..., :2], corners)
    normals = np.repeat(axes[..., 2], corners.shape[1], axis=0)
    points = points.reshape(-1, 3)
    fall = np.sum(
        (frame.plane_coordinates(points) - frame.project_along(points, normals))
        * (normals @ frame.axes),
        axis=1,
    )
    return np.maximum(0.0, (fall.reshape(len(xy), -1) + tops).max(axis=1))


def rims_of_stack(
    spec: ObjectSpec, places: Float[np.ndarray, "board 3"]
) -> tuple[Float[np.ndarray, "board point 2"], Float[np.ndarray, "point"]]:
    """Points round the upper sides of board and chip about the place (mm, the face's x and y), and their
    levels."""
    stack, sensors = mounted_stack(spec, (0.0, 0.0, 0.0)), spec.sensors
    board = _RIM / 2 * sensors.package_mm[:2] + [0.0, stack.board_xy_mm[0]]
    chip = _RIM / 2 * sensors.chip_mm[:2]
    turns = board_frame(places[:, 2])[:, :2, :2]
    tops = np.repeat([stack.board_top_mm, stack.chip_top_mm], len(_RIM))
    return np.concatenate([board, chip]) @ turns.transpose(0, 2, 1), tops


def chip_on_board(sensors: SensorSpec) -> Float[np.ndarray, "3 3"]:
    """The chip's axes as columns, in the board's (−tangential, radial, normal)."""
    return np.diag([-1.0, 1.0, -1.0]) if sensors.chip == "outward" else np.eye(3)


def rotation_matrix(vector_deg: tuple[float, float, float]) -> Float[np.ndarray, "3 3"]:
    """Rotation by a rotation vector, turned axes as columns."""
    turn = np.deg2rad(vector_deg)
    angle = float(np.linalg.norm(turn))
    across = np.cross(np.eye(3), turn)
    rotation = np.eye(3) + np.sinc(angle / np.pi) * across
    return rotation + 0.5 * np.sinc(angle / (2 * np.pi)) ** 2 * across @ across


def _transform_to_object(
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


_AXIS_NAMES = "XYZ"


def magnets_as_built(
    spec: ObjectSpec, designed: MagnetLayout, frames: tuple[FaceFrame, ...]
) -> MagnetLayout:
    """Magnets where `as_built` found them; `frames` are those of the surfaces that they sit under."""
    layout = designed
    of_face = {frame.number: frame for frame in frames}
    for built in spec.as_built.magnets:
        row = _row(layout.face, built.face, built.magnet)
        layout = _with_magnet(spec, layout, row, built, of_face[built.face])
    return layout


def _with_magnet(
    spec: ObjectSpec, layout: MagnetLayout, row: int, built: BuiltMagnet, frame: FaceFrame
) -> MagnetLayout:
    centre, axis, side, strength = (
        given.copy() for given in (layout.centre_mm, layout.axis, layout.side, layout.strength)
    )
    if built.centre_mm is not None:
        centre[row] = frame.to_object(np.array(built.centre_mm))
    if built.axis is not None:
        axis[row] = _unit(frame.axes @ np.array(built.axis))
        side[row] = _unit(side[row] - (side[row] @ axis[row]) * axis[row])
    if built.flipped:
        axis[row] = -axis[row]
    if built.remanence_t is not None:
        strength[row] = built.remanence_t / spec.magnets.remanences_t[0]
    return replace(layout, centre_mm=centre, axis=axis, side=side, strength=strength)


def sensors_as_built(
    spec: ObjectSpec, designed: SensorLayout, frames: tuple[FaceFrame, ...]
) -> SensorLayout:
    """Sensors where `as_built` found them; `frames` are those of the surfaces that they sit under."""
    from scipy.spatial.transform import Rotation

    of_face = {frame.number: frame for frame in frames}
    position, axes = designed.position_mm.copy(), designed.axes.copy()
    for built in spec.as_built.sensors:
        row, frame = _row(designed.face, built.face, built.sensor), of_face[built.face]
        if built.position_mm is not None:
            position[row] = frame.to_object(np.array(built.position_mm))
        turn = Rotation.from_rotvec(frame.axes @ np.deg2rad(built.rotation_deg)).as_matrix()
        axes[row] = axes[row] @ turn.T
    return replace(designed, position_mm=position, axes=axes)


def live_channels(spec: ObjectSpec) -> Bool[np.ndarray, "sensor 3"]:
    """Return which channels work: the axes that the part measures, but the ones that `as_built` calls
    dead."""
    count, faces = spec.sensors.count_per_face, spec.body.sensed
    live = np.zeros((len(faces) * count, 3), bool)
    live[:, [_AXIS_NAMES.index(axis) for axis in spec.sensors.axes]] = True
    for built in spec.as_built.sensors:
        row = faces.index(built.face) * count + built.sensor - 1
        live[row, [_AXIS_NAMES.index(axis) for axis in built.dead]] = False
    return live


def _row(face: Int[np.ndarray, "part"], number: int, count_from_1: int) -> int:
    return int(np.flatnonzero(face == number)[count_from_1 - 1])


def _unit(vector: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3"]:
    return vector / np.linalg.norm(vector)
