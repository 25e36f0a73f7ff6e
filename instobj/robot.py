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

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.surface import sealed_body_surface
from design.spec.object import ObjectSpec
from estimator.recordings.formats.robot import lerobot_features, write_bag

if TYPE_CHECKING:
    import trimesh

__all__ = ["foxglove_channels", "lerobot_features", "write_bag"]

Document = dict[str, Any]
"""One frame as `instobj predict` prints it."""
_NEWTON_LENGTH_M = 0.004
"""Length of an arrow for each newton: 5 N are as long as a face of the paper's cube is high, about."""
_RED = {"r": 0.85, "g": 0.2, "b": 0.15, "a": 1.0}
_GREY = {"r": 0.6, "g": 0.6, "b": 0.65, "a": 0.35}
_FRAME = "object"
_BODY_EVERY = 50
"""Frames of which one carries the body's surface, for a viewer that comes later."""


def is_foxglove(target: Path | None) -> bool:
    """Return whether a target is an MCAP file, or Foxglove's live view (foxglove, foxglove:PORT)."""
    return target is not None and (target.suffix == ".mcap" or _port(target) is not None)


def _port(target: Path) -> int | None:
    name, _, port = str(target).partition(":")
    if name != "foxglove" or not (port.isdigit() or not port):
        return None
    return int(port or 8765)


@contextmanager
def foxglove_channels(target: Path, spec: ObjectSpec) -> Iterator[Callable[[Document], None]]:
    """Send frames to an MCAP file, or to Foxglove's live view on 127.0.0.1.

    Channels: /instobj/contacts (the document), /instobj/wrench (N and N m about the object's origin)
    and /instobj/scene (the surface, and an arrow for each contact) in the frame "object".

    Parameters
    ----------
    target : Path
        A new MCAP file, or "foxglove" or "foxglove:PORT" for the live view.
    spec : ObjectSpec
        The object.

    Returns
    -------
    context manager
        Gives a function that sends one frame, a document of `instobj predict --port`.

    Raises
    ------
    InputError
        The file exists, or the port is taken.
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
        yield _sender(spec, context)
    finally:
        end()


def _sender(spec: ObjectSpec, context: Any) -> Callable[[Document], None]:
    from foxglove import Channel
    from foxglove.channels import SceneUpdateChannel

    contacts = Channel("/instobj/contacts", message_encoding="json", context=context)
    wrench = Channel("/instobj/wrench", message_encoding="json", context=context)
    scene = SceneUpdateChannel("/instobj/scene", context=context)
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


def _scene(
    spec: ObjectSpec, contacts: list[Document], time_ns: int, body: trimesh.Trimesh | None
) -> Any:
    from foxglove import messages as m
    from scipy.spatial.transform import Rotation

    def pose(point_m: np.ndarray, rotation: Rotation) -> Any:
        quaternion = dict(zip("xyzw", rotation.as_quat().tolist(), strict=True))
        position = dict(zip("xyz", point_m.tolist(), strict=True))
        return m.Pose(position=m.Vector3(**position), orientation=m.Quaternion(**quaternion))

    arrows = []
    for point_mm, axes, contact in _placed(spec, contacts):
        length_m = _NEWTON_LENGTH_M * contact["force_n"]
        # The arrow runs along its own x: x is the outward normal turned round, its tip on the surface
        inwards = Rotation.from_matrix(np.column_stack([-axes[:, 2], axes[:, 1], axes[:, 0]]))
        tail_m = 1e-3 * point_mm + length_m * axes[:, 2]
        arrows.append(
            m.ArrowPrimitive(
                pose=pose(tail_m, inwards),
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
            pose=pose(np.zeros(3), Rotation.identity()), points=corners, color=m.Color(**_GREY)
        )
        entities["body"] = {"triangles": [surface]}
    stamp = m.Timestamp(*divmod(time_ns, 1_000_000_000))
    return m.SceneUpdate(
        entities=[
            m.SceneEntity(timestamp=stamp, frame_id=_FRAME, id=name, **primitives)
            for name, primitives in entities.items()
        ]
    )
