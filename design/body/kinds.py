"""The body's sensed faces, its core, and where the core's surface is, kind by kind.

Object frame: origin at the middle of the body's box, face 1 outward = +z, 2 = −y, 3 = +x, 4 = +y,
5 = −x, 6 = −z, on curved bodies the patches about those directions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FACE_AXES, STEEPEST, Cap, FaceFrame
from design.spec.worked_out import once

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


def is_sampled(spec: ObjectSpec) -> bool:
    """Whether the body is known by its triangles, its core an offset of them, and so its mould."""
    return spec.body.kind in ("ellipsoid", "imported")


@once
def face_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces of the body, in the order of their numbers."""
    return tuple(_FRAMES[spec.body.kind](spec, number, 0.0) for number in spec.body.sensed)


def face_frame(spec: ObjectSpec, number: int) -> FaceFrame:
    """The sensed face of that number; KeyError where there is none."""
    return {frame.number: frame for frame in face_frames(spec)}[number]


@once
def core_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces' frames moved inwards onto the core's faces."""
    inward = spec.shell.thickness_mm
    if spec.body.kind == "dome" and spec.body.inside != "core":
        return (_equator(spec),)
    return tuple(_FRAMES[spec.body.kind](spec, number, inward) for number in spec.body.sensed)


def core_half_mm(spec: ObjectSpec) -> Float[np.ndarray, "3"]:
    """Half extents of a core that is centred: the body's less one shell thickness a side."""
    return np.asarray(spec.body.size_mm) / 2 - spec.shell.thickness_mm


def core_distance_mm(
    spec: ObjectSpec, points_mm: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """Below 0 in what holds the silicone from inside; the distance to it close to its surface."""
    return _CORE_DISTANCES[spec.body.kind](spec, points_mm)


def base_top_mm(spec: ObjectSpec) -> float:
    """Height z of the plane on which a dome or a pad stands on its rigid base."""
    size = spec.body.size_mm
    high = size[0] / 2 if spec.body.kind == "dome" else spec.shell.thickness_mm
    return size[2] / 2 - high


def sphere_centre_mm(spec: ObjectSpec) -> Float[np.ndarray, "3"]:
    """Centre of a sphere's or a dome's surface."""
    return np.array([0.0, 0.0, base_top_mm(spec) if spec.body.kind == "dome" else 0.0])


def _axes(number: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    normal, x, y = (np.asarray(axis, float) for axis in FACE_AXES[number])
    return normal, x, y


def _plane(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    """A face of a box."""
    half = np.asarray(spec.body.size_mm) / 2
    normal, x, y = _axes(number)
    extents = (float(abs(x) @ half) - inward_mm, float(abs(y) @ half) - inward_mm)
    centre = normal * (abs(normal) @ half) - inward_mm * normal
    return FaceFrame(number, normal, x, y, centre, extents)


def _pad(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    """The top of a slab, or of the plate under it, which is as wide."""
    wide = _plane(spec, number, 0.0)
    return replace(wide, centre_mm=wide.centre_mm - inward_mm * wide.normal)


def _cylinder(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    frame = _plane(spec, number, inward_mm)
    radius = spec.body.size_mm[0] / 2 - inward_mm
    if number in (1, 6):
        return replace(frame, round=True)
    extents = (frame.half_extents_mm[0], float(_reach(radius, radius)))
    return replace(frame, half_extents_mm=extents, relief=Cap((np.inf, radius, radius)))


def _ball(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    """A patch of a sphere, or of an ellipsoid's outer surface."""
    half = np.asarray(spec.body.size_mm) / 2 - inward_mm
    normal, x, y = _axes(number)
    a, b, c = (float(abs(axis) @ half) for axis in (x, y, normal))
    extents = (_reach(a, c), _reach(b, c))
    return FaceFrame(number, normal, x, y, normal * c, extents, Cap((a, b, c)), round=True)


def _dome(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    radius = spec.body.size_mm[0] / 2 - inward_mm
    normal, x, y = _axes(number)
    centre = sphere_centre_mm(spec) + radius * normal
    reach = _reach(radius, radius)
    relief = Cap((radius, radius, radius))
    return FaceFrame(number, normal, x, y, centre, (reach, reach), relief, round=True)


def _equator(spec: ObjectSpec) -> FaceFrame:
    """The base's top under a dome of silicone, or under a hollow one."""
    radius = spec.body.size_mm[0] / 2
    return FaceFrame(1, *_axes(1), sphere_centre_mm(spec), (radius, radius), round=True)


def _reach(across_mm: float, high_mm: float) -> float:
    """Where a cap of those semi-axes is as steep as a patch may be."""
    return across_mm * STEEPEST / float(np.hypot(STEEPEST, high_mm / across_mm))


def _ellipsoid(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    if not inward_mm:
        return _ball(spec, number, 0.0)
    return _sampled(spec, number, inward_mm)


def _sampled(spec: ObjectSpec, number: int, inward_mm: float) -> FaceFrame:
    from design.body.sampled import sampled_frame

    return sampled_frame(spec, number, inward_mm)


def _from_box(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    return np.max(abs(points_mm) - core_half_mm(spec), axis=1)


def _from_base(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    return points_mm[:, 2] - base_top_mm(spec)


def _from_cylinder(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    radius, _, half = core_half_mm(spec)
    across = np.hypot(points_mm[:, 0], points_mm[:, 1]) - radius
    return np.maximum(across, abs(points_mm[:, 2]) - half)


def _from_sphere(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    radius = spec.body.size_mm[0] / 2 - spec.shell.thickness_mm
    return np.linalg.norm(points_mm - sphere_centre_mm(spec), axis=1) - radius


def _from_dome(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    base = _from_base(spec, points_mm)
    if spec.body.inside != "core":
        return base
    return np.minimum(base, _from_sphere(spec, points_mm))


def _from_sampled(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    from design.body.sampled import outer_distance_mm

    return outer_distance_mm(spec, points_mm) + spec.shell.thickness_mm


_FRAMES: dict[str, Callable[[ObjectSpec, int, float], FaceFrame]] = {
    "box": _plane,
    "pad": _pad,
    "cylinder": _cylinder,
    "sphere": _ball,
    "ellipsoid": _ellipsoid,
    "dome": _dome,
    "imported": _sampled,
}
_CORE_DISTANCES: dict[str, Callable[[ObjectSpec, np.ndarray], np.ndarray]] = {
    "box": _from_box,
    "pad": _from_base,
    "cylinder": _from_cylinder,
    "sphere": _from_sphere,
    "ellipsoid": _from_sampled,
    "dome": _from_dome,
    "imported": _from_sampled,
}
