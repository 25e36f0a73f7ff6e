"""Exact solids of the bodies: the outside of the silicone, what the core keeps free, the core."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

import cadquery as cq
import numpy as np

from design.body.kinds import base_top_mm, core_half_mm, sphere_centre_mm
from design.body.surface import open_span_mm
from design.errors import InputError
from design.layout.core_hold import core_outlet
from design.solids.primitives import OVERSHOOT_MM, box_between, rod_about_z
from design.spec.object import ObjectSpec

_Z = cq.Vector(0, 0, 1)
Solid = TypeVar("Solid", cq.Solid, cq.Solid | None)


def outer_solid(spec: ObjectSpec) -> cq.Solid:
    """The silicone's outside as if it were solid, mm.

    Raises
    ------
    InputError
        A body that is known by its triangles only.
    """
    return _exact(_OUTER, spec)(spec)


def cavity_solid(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid | None:
    """What the core and its passage keep free, so far beyond the open faces; None where nothing."""
    return _exact(_CAVITIES, spec)(spec, overshoot_mm)


def core_solid(spec: ObjectSpec) -> cq.Solid:
    """The core without recesses, passages and its own cavity."""
    return _exact(_CORES, spec)(spec)


def core_hollow(spec: ObjectSpec) -> list[cq.Solid]:
    """The core's own cavity, one core wall inside it and open towards −z, where there is room.

    A core without an open face 6 is solid, or silicone would run into it. A ball's outlet has a flat
    on one side, by which the core is held from turning while it is cast in.
    """
    wall = spec.core.wall_mm
    if 6 not in spec.body.opened:
        return []
    half = core_half_mm(spec) - wall
    if spec.body.kind == "sphere":
        return [_ball_hollow(spec, float(half[0]))]
    if half.min() <= 0:
        return []
    if spec.body.kind == "box":
        bottom = -core_half_mm(spec)[2] - OVERSHOOT_MM
        return [box_between((-half[0], -half[1], bottom), half)]
    bottom = -core_half_mm(spec)[2] - OVERSHOOT_MM
    return [rod_about_z(float(half[0]), float(bottom), float(half[2]))]


def _ball_hollow(spec: ObjectSpec, radius_mm: float) -> cq.Solid:
    """A ball with its outlet, which alone is cut where there is no room for the ball."""
    outlet = core_outlet(spec)
    bore = rod_about_z(outlet.radius_mm, -spec.body.size_mm[2] / 2, 0.0)
    hollow = bore if radius_mm <= 0 else _sphere_at(radius_mm, np.zeros(3)).fuse(bore)
    return hollow.cut(box_between(*outlet.key_mm)).Solids()[0]


def _exact(kinds: dict[str, Callable[..., Solid]], spec: ObjectSpec) -> Callable[..., Solid]:
    if spec.body.kind not in kinds:
        raise InputError(
            f"a body of kind {spec.body.kind!r} is known by its triangles and has no exact solid. Use "
            "its STL"
        )
    return kinds[spec.body.kind]


def _sphere_at(radius_mm: float, centre_mm: np.ndarray) -> cq.Solid:
    return cast(cq.Solid, cq.Solid.makeSphere(radius_mm, cq.Vector(*centre_mm), _Z, -90, 90, 360))


def _upper_half(spec: ObjectSpec, radius_mm: float) -> cq.Solid:
    centre = cq.Vector(*sphere_centre_mm(spec))
    return cast(cq.Solid, cq.Solid.makeSphere(radius_mm, centre, _Z, 0, 90, 360))


def _box(spec: ObjectSpec) -> cq.Solid:
    half = np.asarray(spec.body.size_mm) / 2
    return box_between(-half, half)


def _pad(spec: ObjectSpec) -> cq.Solid:
    half = np.asarray(spec.body.size_mm) / 2
    return box_between((-half[0], -half[1], base_top_mm(spec)), half)


def _cylinder(spec: ObjectSpec) -> cq.Solid:
    radius, _, half = np.asarray(spec.body.size_mm) / 2
    return rod_about_z(float(radius), float(-half), float(half))


def _sphere(spec: ObjectSpec) -> cq.Solid:
    return _sphere_at(spec.body.size_mm[0] / 2, np.zeros(3))


def _dome(spec: ObjectSpec) -> cq.Solid:
    return _upper_half(spec, spec.body.size_mm[0] / 2)


def _box_cavity(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid:
    return box_between(*open_span_mm(spec, overshoot_mm))


def _cylinder_cavity(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid:
    low, high = open_span_mm(spec, overshoot_mm)
    return rod_about_z(float(core_half_mm(spec)[0]), float(low[2]), float(high[2]))


def _sphere_cavity(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid:
    ball = _sphere_at(float(core_half_mm(spec)[0]), np.zeros(3))
    if 6 not in spec.body.opened:
        return ball
    low = -spec.body.size_mm[2] / 2 - overshoot_mm
    return ball.fuse(rod_about_z(spec.body.bore_mm / 2, low, 0.0)).Solids()[0]


def _dome_cavity(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid | None:
    """A whole ball: what lies under the base's plane cuts no silicone."""
    if spec.body.inside == "silicone":
        return None
    return _sphere_at(spec.body.size_mm[0] / 2 - spec.shell.thickness_mm, sphere_centre_mm(spec))


def _box_core(spec: ObjectSpec) -> cq.Solid:
    return box_between(-core_half_mm(spec), core_half_mm(spec))


def _pad_core(spec: ObjectSpec) -> cq.Solid:
    half = np.asarray(spec.body.size_mm) / 2
    return box_between(-half, (half[0], half[1], base_top_mm(spec)))


def _cylinder_core(spec: ObjectSpec) -> cq.Solid:
    radius, _, half = core_half_mm(spec)
    return rod_about_z(float(radius), float(-half), float(half))


def _sphere_core(spec: ObjectSpec) -> cq.Solid:
    return _sphere_at(float(core_half_mm(spec)[0]), np.zeros(3))


def _dome_core(spec: ObjectSpec) -> cq.Solid:
    """The base, and a rigid dome on it where that is inside."""
    radius, _, half = np.asarray(spec.body.size_mm) / 2
    base = rod_about_z(float(radius), float(-half), base_top_mm(spec))
    if spec.body.inside != "core":
        return base
    inner = _sphere_at(float(radius) - spec.shell.thickness_mm, sphere_centre_mm(spec))
    low = (-radius, -radius, -half)
    above = box_between(low, (radius, radius, half))
    return base.fuse(inner.intersect(above).Solids()[0]).clean().Solids()[0]


_OUTER: dict[str, Callable[..., cq.Solid]] = {
    "box": _box,
    "pad": _pad,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "dome": _dome,
}
_CAVITIES: dict[str, Callable[..., cq.Solid | None]] = {
    "box": _box_cavity,
    "pad": lambda spec, overshoot_mm: None,
    "cylinder": _cylinder_cavity,
    "sphere": _sphere_cavity,
    "dome": _dome_cavity,
}
_CORES: dict[str, Callable[..., cq.Solid]] = {
    "box": _box_core,
    "pad": _pad_core,
    "cylinder": _cylinder_core,
    "sphere": _sphere_core,
    "dome": _dome_core,
}
