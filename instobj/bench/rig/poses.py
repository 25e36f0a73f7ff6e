"""Presses as a list of tool poses for a robot arm, in the object's frame."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from design.tables import table_text
from instobj.bench.rig.plan import PressPlan

FRAMES = {
    "object": "origin in the middle of the box round the body, mm, right-handed; docs/architecture.md",
    "tool": "origin at the tip's lowest point (between the tips of a probe), z along the press into the "
    "object, x along the face's x at the place",
    "pose": "position (mm) and rotation (quaternion x, y, z, w) of the tool's frame in the object's",
    "depth_mm": "below the surface of the specification; touch off with the arm's own load cell",
}


@dataclass(frozen=True)
class Pose:
    """One stop of the tool."""

    press: int
    face: int
    x_mm: float
    y_mm: float
    stop: str
    depth_mm: float
    object_x_mm: float
    object_y_mm: float
    object_z_mm: float
    quaternion_x: float
    quaternion_y: float
    quaternion_z: float
    quaternion_w: float
    speed_mm_s: float
    dwell_s: float


def poses(spec: ObjectSpec, plans: list[PressPlan]) -> list[Pose]:
    """Return the poses of every press: above the place, where the press begins to be slow, every stop (of
    every stroke, clear of the surface between two), above again."""
    all_poses: list[Pose] = []
    for plan in plans:
        frame, first = face_frame(spec, plan.face), all_poses[-1].press + 1 if all_poses else 0
        for number, place in enumerate(plan.places_mm):
            all_poses.extend(_press_poses(frame, plan, first + number, place))
    return all_poses


def _press_poses(
    frame: FaceFrame, plan: PressPlan, number: int, place_mm: tuple[float, float]
) -> Iterator[Pose]:
    settings = plan.settings
    xy = frame.to_plane(np.array(place_mm))
    axes = frame.axes_at(xy)
    tool = np.column_stack([axes[:, 0], -axes[:, 1], -axes[:, 2]])
    qx, qy, qz, qw = np.round(Rotation.from_matrix(tool).as_quat(), 6).tolist()
    stops = [
        ("above", -settings.clearance_mm, 0.0, settings.rest_s),
        ("near", -settings.approach_mm, 0.0, 0.0),
    ]
    for stroke in range(settings.strokes):
        speed = settings.stroke_speed_mm_s if stroke else settings.speed_mm_s
        stops += [("press", depth, speed, settings.dwell_s) for depth in settings.depths_mm]
        if settings.strokes == 1:
            stops.append(("surface", 0.0, speed, 0.0))
        elif stroke < settings.strokes - 1:
            stops.append(("clear", -settings.lift_mm, 0.0, settings.pause_s))
    stops.append(("above", -settings.clearance_mm, 0.0, 0.0))
    surface = frame.to_object(np.append(xy, 0.0))
    for stop, depth_mm, speed_mm_s, dwell_s in stops:
        x, y, z = np.round(surface - depth_mm * axes[:, 2], 4).tolist()
        yield Pose(
            number,
            plan.face,
            *place_mm,
            stop,
            depth_mm,
            x,
            y,
            z,
            qx,
            qy,
            qz,
            qw,
            speed_mm_s,
            dwell_s,
        )


def poses_text(listed: list[Pose], kind: str) -> str:
    """Return the poses as CSV, one row per stop, or as one JSON document that states the frames.

    `kind` is csv or json.
    """
    rows: list[dict[str, Any]] = [asdict(pose) for pose in listed]
    if kind == "json":
        return json.dumps({"frames": FRAMES, "poses": rows}, indent=1) + "\n"
    return table_text(list(rows[0]), (list(row.values()) for row in rows))
