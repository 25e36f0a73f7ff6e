"""Robots' tools: contacts as channels of Foxglove, recordings as bags, raw counts as LeRobot features.

Needs the extra `instobj[robot]`. Recordings that robots wrote are read by every command that takes
recordings (`estimator.recordings.formats.robot`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.surface import sealed_body_surface
from design.spec.object import ObjectSpec
from estimator.frames.heatmap import mm_to_pixel
from estimator.recordings.formats.robot import lerobot_features, write_bag, write_lerobot

if TYPE_CHECKING:
    import trimesh

__all__ = ["foxglove_channels", "lerobot_features", "write_bag", "write_lerobot"]

Document = dict[str, Any]
"""One frame as `instobj predict` prints it."""
_NEWTON_LENGTH_M = 0.004
"""Length of an arrow for each newton: 5 N are as long as a face of the paper's cube is high, about."""
_RED = {"r": 0.85, "g": 0.2, "b": 0.15, "a": 1.0}
_GREY = {"r": 0.6, "g": 0.6, "b": 0.65, "a": 0.35}
_FRAME = "object"
_LAST_PORT = 65535
_BODY_EVERY = 50
"""Frames of which one carries the body's surface, for a viewer that comes later."""


def is_foxglove(target: Path | None) -> bool:
    """Return whether a target is an MCAP file, or Foxglove's live view (foxglove, foxglove:PORT)."""
    return target is not None and (target.suffix == ".mcap" or _port(target) is not None)


def new_mcap_file(out: Path, stem: str) -> Path | None:
    """Return the MCAP file that frames of a recording go to; None where `out` is a folder.

    Raises
    ------
    InputError
        The file is there already, or the target shows a board live.
    """
    if not is_foxglove(out):
        return None
    if out.suffix != ".mcap" or out.exists():
        why = "exists already" if out.exists() else "shows the frames of a board live"
        raise InputError(f"{out} {why}. Give a new file such as --out {stem}_contacts.mcap")
    return out


def _port(target: Path) -> int | None:
    name, _, port = str(target).partition(":")
    if name != "foxglove" or not (port.isdigit() or not port):
        return None
    number = int(port or 8765)
    if number > _LAST_PORT:
        raise InputError(f"{target}: TCP ports end at {_LAST_PORT}. Give one such as foxglove:8765")
    return number


@contextmanager
def foxglove_channels(target: Path, spec: ObjectSpec) -> Iterator[Callable[..., None]]:
    """Send frames to an MCAP file, or to Foxglove's live view on 127.0.0.1.

    Channels: /instobj/contacts (the document), /instobj/wrench (N and N m about the object's origin),
    /instobj/heatmap_<face> (normal force, N, at the nearest location of the contact grid; a curved
    face's lies in the plane that touches its middle) and /instobj/scene (the surface, and an arrow
    for each contact) in the frame "object". Scene and heatmaps have Foxglove's own schemas.

    Parameters
    ----------
    target : Path
        A new MCAP file, or "foxglove" or "foxglove:PORT" for the live view.
    spec : ObjectSpec
        The object.

    Returns
    -------
    context manager
        Gives a function that sends one frame, a document of `instobj predict --port`, and takes
        another first part of the topics (`topic="/left"`).

    Raises
    ------
    InputError
        The file exists, the port is taken, or a frame has no stamp from 0 on.
    ImportError
        The extra `instobj[robot]` is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> import instobj
    >>> press = {"face": 1, "x_mm": 2.0, "y_mm": 0.0, "force_n": 3.0}
    >>> cube = instobj.ObjectSpec(name="cube")
    >>> with instobj.robot.foxglove_channels(Path("contacts.mcap"), cube) as send:
    ...     send({"time_s": 0.5, "contacts": [press]})
    """
    import foxglove

    context = foxglove.Context()
    port = _port(target)
    try:
        if port is None:
            end = foxglove.open_mcap(target, context=context).close
        else:
            end = foxglove.start_server(name=spec.name, port=port, context=context).stop
    except (OSError, RuntimeError) as error:
        raise InputError(f"cannot write to {target}: {error}. Give another name or port") from None
    try:
        topics: dict[str, Callable[[Document], None]] = {}

        def send(document: Document, topic: str = "/instobj") -> None:
            if not document["time_s"] >= 0:
                raise InputError(
                    f"{target} needs stamps from 0 on, which the frames lack. Leave it out"
                )
            if topic not in topics:
                topics[topic] = _sender(spec, context, topic)
            topics[topic](document)

        yield send
    finally:
        end()


def _sender(spec: ObjectSpec, context: Any, topic: str) -> Callable[[Document], None]:
    from foxglove import Channel
    from foxglove.channels import GridChannel, SceneUpdateChannel

    contacts = Channel(f"{topic}/contacts", message_encoding="json", context=context)
    wrench = Channel(f"{topic}/wrench", message_encoding="json", context=context)
    scene = SceneUpdateChannel(f"{topic}/scene", context=context)
    heatmaps = {
        frame.number: (frame, GridChannel(f"{topic}/heatmap_{frame.number}", context=context))
        for frame in face_frames(spec)
    }
    body, frames = sealed_body_surface(spec), count()

    def send(document: Document) -> None:
        time_ns = round(document["time_s"] * 1e9)
        contacts.log(document, log_time=time_ns)
        force_n, torque_nm = contact_wrench(spec, document["contacts"])
        named = {"force": force_n, "torque": torque_nm}
        values = {
            key: dict(zip("xyz", value.tolist(), strict=True)) for key, value in named.items()
        }
        wrench.log({"frame_id": _FRAME, **values}, log_time=time_ns)
        for frame, channel in heatmaps.values():
            channel.log(_heatmap(spec, frame, document["contacts"], time_ns), log_time=time_ns)
        shown = None if next(frames) % _BODY_EVERY else body
        scene.log(_scene(spec, document["contacts"], time_ns, shown), log_time=time_ns)

    return send


def contact_wrench(
    spec: ObjectSpec, contacts: list[Document]
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Return the net force (N) and torque about the origin (N m) of contacts on the object.

    Normal forces push inwards. Tangential ones count where a contact has them.
    """
    force, torque = np.zeros(3), np.zeros(3)
    for point_mm, push_n, _ in contact_forces(spec, contacts):
        force += push_n
        torque += np.cross(1e-3 * point_mm, push_n)
    return force, torque


def contact_forces(
    spec: ObjectSpec, contacts: list[Document]
) -> Iterator[tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"], Document]]:
    """Yield where each contact is (mm) and its force on the object (N), both in the object's frame."""
    for point_mm, axes, contact in _placed(spec, contacts):
        tangential_n = [contact.get("tangential_x_n", 0.0), contact.get("tangential_y_n", 0.0)]
        yield point_mm, axes @ np.array([*tangential_n, -contact["force_n"]]), contact


def _placed(
    spec: ObjectSpec, contacts: list[Document]
) -> Iterator[tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"], Document]]:
    """Yield where each contact is (mm, in the object) and its face's axes there."""
    frames = {frame.number: frame for frame in face_frames(spec)}
    for contact in contacts:
        frame = frames[contact["face"]]
        xy = frame.to_plane(np.array([contact["x_mm"], contact["y_mm"]]))
        yield frame.to_object(np.append(xy, 0.0)), frame.axes_at(xy), contact


def _heatmap(spec: ObjectSpec, frame: FaceFrame, contacts: list[Document], time_ns: int) -> Any:
    """Return the normal force (N) of one face's contacts at the nearest locations, as foxglove.Grid."""
    from foxglove import messages as m

    grid, pitch_mm = contact_grid(spec), spec.contact_grid.pitch_mm
    force_n = np.zeros((len(grid.y_mm), len(grid.x_mm)), "<f4")  # a row of the grid runs along x
    on_face = [contact for contact in contacts if contact["face"] == frame.number]
    xy_mm = np.array([[contact["x_mm"], contact["y_mm"]] for contact in on_face]).reshape(-1, 2)
    x, y = mm_to_pixel(xy_mm, grid.x_mm, grid.y_mm).T
    np.add.at(force_n, (y, x), [contact["force_n"] for contact in on_face])
    # The grid begins at the outer corner of its first location, half a pitch before the centre
    corner_mm = np.array([grid.x_mm[0], grid.y_mm[0]]) - pitch_mm / 2
    place_m = 1e-3 * frame.to_object(np.append(corner_mm, 0.0))
    number = m.PackedElementFieldNumericType.Float32
    return m.Grid(
        timestamp=m.Timestamp(*divmod(time_ns, 1_000_000_000)),
        frame_id=_FRAME,
        pose=_pose(place_m, Rotation.from_matrix(frame.axes_at(np.zeros(2)))),
        column_count=force_n.shape[1],
        cell_size=m.Vector2(x=1e-3 * pitch_mm, y=1e-3 * pitch_mm),
        row_stride=force_n.strides[0],
        cell_stride=force_n.itemsize,
        fields=[m.PackedElementField(name="force_n", offset=0, type=number)],
        data=force_n.tobytes(),
    )


def _pose(point_m: np.ndarray, rotation: Rotation) -> Any:
    from foxglove import messages as m

    quaternion = dict(zip("xyzw", rotation.as_quat().tolist(), strict=True))
    position = dict(zip("xyz", point_m.tolist(), strict=True))
    return m.Pose(position=m.Vector3(**position), orientation=m.Quaternion(**quaternion))


def _scene(
    spec: ObjectSpec, contacts: list[Document], time_ns: int, body: trimesh.Trimesh | None
) -> Any:
    from foxglove import messages as m

    arrows = []
    for point_mm, axes, contact in _placed(spec, contacts):
        length_m = _NEWTON_LENGTH_M * contact["force_n"]
        # The arrow runs along its own x: x is the outward normal turned round, its tip on the surface
        inwards = Rotation.from_matrix(np.column_stack([-axes[:, 2], axes[:, 1], axes[:, 0]]))
        tail_m = 1e-3 * point_mm + length_m * axes[:, 2]
        arrows.append(
            m.ArrowPrimitive(
                pose=_pose(tail_m, inwards),
                shaft_length=0.75 * length_m,
                shaft_diameter=0.002,
                head_length=0.25 * length_m,
                head_diameter=0.004,
                color=m.Color(**_RED),
            )
        )
    entities: dict[str, dict[str, Any]] = {"contacts": {"arrows": arrows}}
    if body is not None:
        points = (1e-3 * body.triangles.reshape(-1, 3)).tolist()
        corners = [m.Point3(**dict(zip("xyz", point, strict=True))) for point in points]
        surface = m.TriangleListPrimitive(
            pose=_pose(np.zeros(3), Rotation.identity()), points=corners, color=m.Color(**_GREY)
        )
        entities["body"] = {"triangles": [surface]}
    stamp = m.Timestamp(*divmod(time_ns, 1_000_000_000))
    return m.SceneUpdate(
        entities=[
            m.SceneEntity(timestamp=stamp, frame_id=_FRAME, id=name, **primitives)
            for name, primitives in entities.items()
        ]
    )
