"""Exact solids of the bodies, one entry per kind: outside, cavity, core and the core's own room."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from design.body.kinds.base import BodyKind
from design.body.kinds.box import Box
from design.body.kinds.capsule import Capsule
from design.body.kinds.cylinder import Cylinder
from design.body.kinds.dome import Dome
from design.body.kinds.pad import Pad
from design.body.kinds.sphere import Sphere
from design.errors import InputError
from design.layout.body import body_of
from design.layout.core_hold import core_outlet
from design.layout.mould.frame import MouldFrame
from design.solids.booleans import Shape, join
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, rod_about_z
from design.spec.object import ObjectSpec

_Z = cq.Vector(0, 0, 1)


def _slab_added(body: BodyKind, room: Shape, frame: MouldFrame, layer_mm: float) -> Shape:
    """With a slab as wide as the room's box."""
    assert isinstance(room, cq.Shape)
    box = room.BoundingBox()
    corners = np.array([[box.xmin, box.ymin, box.zmin], [box.xmax, box.ymax, box.zmax]])
    low, high = np.sort(frame.axes.T @ corners.T, axis=1).T
    low[2], high[2] = frame.rim_mm - OVERSHOOT_MM, frame.rim_mm + OVERSHOOT_MM
    return join(room, box_between(*frame.corners(low, high)))


@dataclass(frozen=True)
class ExactSolids:
    """Functions that make a kind's solids from a body of it (mm)."""

    outer: Callable[[Any], cq.Solid]
    """The silicone's outside as if it were solid."""
    core: Callable[[Any], cq.Solid]
    """The core without recesses, passages and its own cavity."""
    cavity: Callable[[Any, float], cq.Solid | None] | None = None
    """Room that core and passage keep free, to that length beyond open faces; by default the core and its
    bore."""
    room: Callable[[Any, float], cq.Solid | None] | None = None
    """The core's own cavity, so far inside its surface; None where that leaves no room."""
    drawn_out: Callable[[Any, Shape, MouldFrame, float], Shape] = _slab_added
    """Room for silicone, drawn out a little past its open side; it lacks a layer of that thickness (mm)."""
    cast: Callable[[Any, float, tuple[int, ...]], cq.Solid] | None = None
    """The outside less a layer on the sensed faces; by default that of the body `less` it."""


def outer_solid(spec: ObjectSpec) -> cq.Solid:
    """The silicone's outside as if it were solid, mm.

    Raises
    ------
    InputError
        A body that is known by its triangles only.
    """
    return _solids(spec).outer(body_of(spec))


def cavity_solid(spec: ObjectSpec, overshoot_mm: float) -> cq.Solid | None:
    """Return what the core and its passage keep free, so far beyond the open faces; None where nothing."""
    body, solids = body_of(spec), _solids(spec)
    if solids.cavity is not None:
        return solids.cavity(body, overshoot_mm)
    core = solids.core(body)
    if 6 not in body.opened:
        return core
    low = -body.size_mm[2] / 2 - overshoot_mm
    return core.fuse(rod_about_z(body.bore_mm / 2, low, 0.0)).Solids()[0]


def core_solid(spec: ObjectSpec) -> cq.Solid:
    """The core without recesses, passages and its own cavity."""
    return _solids(spec).core(body_of(spec))


def core_hollow(spec: ObjectSpec) -> list[cq.Solid]:
    """The core's own cavity, one core wall inside it and open towards −z, where there is room.

    A core without an open face 6 is solid, or silicone would run into it. The outlet of a core that
    is cast in has a flat on one side, by which it is held from turning.
    """
    body, make = body_of(spec), _solids(spec).room
    if 6 not in body.opened or make is None:
        return []
    room = make(body, spec.core.wall_mm)
    if body.opening == "bore":
        return [_with_outlet(spec, room)]
    return [] if room is None else [room]


def cast_outer_solid(spec: ObjectSpec) -> cq.Solid:
    """The outside less the seal layer.

    Raises
    ------
    InputError
        As `outer_solid`.
    """
    body, solids, layer = body_of(spec), _solids(spec), spec.shell.seal_layer_mm
    if not layer:
        return solids.outer(body)
    if solids.cast is None:
        return solids.outer(body.less(layer))
    return solids.cast(body, layer, spec.body.sensed)


def past_opening(spec: ObjectSpec, room: Shape, frame: MouldFrame, layer_mm: float = 0.0) -> Shape:
    """Room for silicone drawn out a little past its open side; it lacks a layer of `layer_mm`."""
    return _solids(spec).drawn_out(body_of(spec), room, frame, layer_mm)


def _solids(spec: ObjectSpec) -> ExactSolids:
    if spec.body.kind not in SOLIDS:
        raise InputError(
            f"a body of kind {spec.body.kind!r} is known by its triangles and has no exact solid. Use "
            "its STL"
        )
    return SOLIDS[spec.body.kind]


def _with_outlet(spec: ObjectSpec, room: cq.Solid | None) -> cq.Solid:
    """A core's cavity with its outlet, which alone is cut where there is no room for the cavity."""
    outlet = core_outlet(spec)
    bore = rod_about_z(outlet.radius_mm, -spec.body.size_mm[2] / 2, 0.0)
    hollow = bore if room is None else room.fuse(bore)
    return hollow.cut(box_between(*outlet.key_mm)).Solids()[0]


def _ball(
    radius_mm: float, centre_mm: np.ndarray | tuple[float, ...] = (0.0, 0.0, 0.0)
) -> cq.Solid:
    return cast(cq.Solid, cq.Solid.makeSphere(radius_mm, cq.Vector(*centre_mm), _Z, -90, 90, 360))


def _box_room(body: Box, wall_mm: float) -> cq.Solid | None:
    half = body.core_half_mm - wall_mm
    if half.min() <= 0:
        return None
    bottom = -body.core_half_mm[2] - OVERSHOOT_MM
    return box_between((-half[0], -half[1], bottom), half)


def _cylinder(body: Cylinder) -> cq.Solid:
    radius, _, half = body.half_mm
    return rod_about_z(float(radius), float(-half), float(half))


def _cylinder_cavity(body: Cylinder, overshoot_mm: float) -> cq.Solid:
    low, high = body.core_span_mm(overshoot_mm)
    return rod_about_z(body.core_radius_mm, float(low[2]), float(high[2]))


def _cylinder_core(body: Cylinder) -> cq.Solid:
    radius, _, half = body.core_half_mm
    return rod_about_z(float(radius), float(-half), float(half))


def cylinder_room(body: Cylinder, wall_mm: float) -> cq.Solid | None:
    half = body.core_half_mm - wall_mm
    if half.min() <= 0:
        return None
    bottom = -body.core_half_mm[2] - OVERSHOOT_MM
    return rod_about_z(float(half[0]), float(bottom), float(half[2]))


def _cast_cylinder(body: Cylinder, layer_mm: float, sensed: tuple[int, ...]) -> cq.Solid:
    return rod_about_z(*body.cast_measures_mm(layer_mm, sensed))


def _cast_block(body: Box | Pad, layer_mm: float, sensed: tuple[int, ...]) -> cq.Solid:
    return box_between(*body.cast_corners_mm(layer_mm, sensed))


def _disk_added(body: Cylinder, room: Shape, frame: MouldFrame, layer_mm: float) -> Shape:
    start = (frame.rim_mm - OVERSHOOT_MM) * frame.out
    radius, out = body.radius_mm - layer_mm, cq.Vector(*frame.out)
    return join(room, cq.Solid.makeCylinder(radius, 2 * OVERSHOOT_MM, cq.Vector(*start), out))


def sphere_room(body: Sphere, wall_mm: float) -> cq.Solid | None:
    radius = body.core_radius_mm - wall_mm
    return _ball(radius) if radius > 0 else None


def _capsule(radius_mm: float, straight_mm: float) -> cq.Solid:
    """A half profile turned about z."""
    ends = np.array([-1.0, 1.0]) * (straight_mm + radius_mm)
    slanting = float(np.sqrt(0.5)) * radius_mm
    profile = (
        cq.Workplane("XZ")
        .moveTo(0, float(ends[0]))
        .threePointArc((slanting, -straight_mm - slanting), (radius_mm, -straight_mm))
        .lineTo(radius_mm, straight_mm)
        .threePointArc((slanting, straight_mm + slanting), (0, float(ends[1])))
        .close()
    )
    return cast(cq.Solid, profile.revolve(360, (0, 0, 0), (0, 1, 0)).val())


def _capsule_room(body: Capsule, wall_mm: float) -> cq.Solid | None:
    radius = body.core_radius_mm - wall_mm
    return _capsule(radius, body.straight_mm) if radius > 0 else None


def _pad_core(body: Pad) -> cq.Solid:
    half = body.half_mm
    return box_between(-half, (half[0], half[1], body.base_top_mm))


def _dome(body: Dome) -> cq.Solid:
    centre = cq.Vector(*body.centre_mm)
    return cast(cq.Solid, cq.Solid.makeSphere(body.radius_mm, centre, _Z, 0, 90, 360))


def _dome_cavity(body: Dome, overshoot_mm: float) -> cq.Solid | None:
    """A whole ball: what lies under the base's plane cuts no silicone."""
    return None if body.inside == "silicone" else _ball(body.core_radius_mm, body.centre_mm)


def _dome_core(body: Dome) -> cq.Solid:
    """The base, and a rigid dome on it where that is inside."""
    radius, _, half = body.half_mm
    base = rod_about_z(float(radius), float(-half), body.base_top_mm)
    if body.inside != "core":
        return base
    inner = _ball(body.core_radius_mm, body.centre_mm)
    above = box_between((-radius, -radius, -half), (radius, radius, half))
    return base.fuse(inner.intersect(above).Solids()[0]).clean().Solids()[0]


SOLIDS: dict[str, ExactSolids] = {
    "box": ExactSolids(
        outer=lambda body: box_between(-body.half_mm, body.half_mm),
        core=lambda body: box_between(-body.core_half_mm, body.core_half_mm),
        cavity=lambda body, overshoot_mm: box_between(*body.core_span_mm(overshoot_mm)),
        room=_box_room,
        cast=_cast_block,
    ),
    "pad": ExactSolids(
        outer=lambda body: box_between(*body.corners_mm),
        core=_pad_core,
        cavity=lambda body, overshoot_mm: None,
        cast=_cast_block,
    ),
    "cylinder": ExactSolids(
        outer=_cylinder,
        core=_cylinder_core,
        cavity=_cylinder_cavity,
        room=cylinder_room,
        drawn_out=_disk_added,
        cast=_cast_cylinder,
    ),
    "capsule": ExactSolids(
        outer=lambda body: _capsule(body.radius_mm, body.straight_mm),
        core=lambda body: _capsule(body.core_radius_mm, body.straight_mm),
        room=_capsule_room,
    ),
    "sphere": ExactSolids(
        outer=lambda body: _ball(body.radius_mm),
        core=lambda body: _ball(body.core_radius_mm),
        room=sphere_room,
    ),
    "dome": ExactSolids(
        outer=_dome,
        core=_dome_core,
        cavity=_dome_cavity,
        drawn_out=lambda body, room, frame, layer_mm: _ball(
            body.radius_mm - layer_mm, body.centre_mm
        ),
    ),
}
"""Solids by the name of the kind; a kind that is known by its triangles has none."""
