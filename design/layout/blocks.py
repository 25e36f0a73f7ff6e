"""Rectangular blocks that the core adds to its cavity and that slits take from the shell.

They are given as numbers, so that the CAD solids and the mesh of the mechanics are made from one
description, and touch no CAD kernel.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from math import prod
from typing import TYPE_CHECKING

import numpy as np

from design.body.meshes import manifold_of
from design.body.surface_chart import FaceFrame
from design.body.triangles import Block, block_surface
from design.layout.body import body_of, core_frames, face_frames
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from manifold3d import Manifold

    from design.spec.object import ObjectSpec

SUNK_MM = 0.5
"""Depth to which a key reaches into the core below its surface, so that both join."""
_SINKING_STEPS = 4
"""Rounds in which a key on a curved core is sunk until its corners are inside."""
_RAY_STEPS = 4001
"""Points of a ray from the middle to the surface."""


@cached_geometry
def core_keys(spec: ObjectSpec) -> tuple[Block, ...]:
    """Keys of every face of the core, face by face, each along the surface's normal at its place.

    Each begins 0.5 mm below the core's surface or deeper, until all of its underside lies in the core,
    so that a union with it has no coplanar faces.
    """
    places = spec.core.keys.positions_mm
    return tuple(_key(spec, frame, np.array(xy)) for frame in core_frames(spec) for xy in places)


def _key(spec: ObjectSpec, frame: FaceFrame, xy_mm: np.ndarray) -> Block:
    keys, tangent = spec.core.keys, frame.tangent(xy_mm)
    sunk = 0.0 if frame.flat else _sunk_mm(spec, tangent, xy_mm)
    sunk += SUNK_MM
    half = np.add(keys.size_mm, (0, 0, sunk)) / 2
    centre = tangent.to_object(np.append(xy_mm, (keys.size_mm[2] - sunk) / 2))
    return Block(centre, tangent.axes, half)


def _sunk_mm(spec: ObjectSpec, tangent: FaceFrame, xy_mm: np.ndarray) -> float:
    """Return how deep an underside lies whose corners are all in the core."""
    signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) / 2
    corners = xy_mm + signs * spec.core.keys.size_mm[:2]
    sunk = 0.0
    for _ in range(_SINKING_STEPS):
        points = tangent.to_object(np.column_stack([corners, np.full(4, -sunk)]))
        sunk += max(0.0, float(body_of(spec).core_distance_mm(points).max()))
    return sunk


def keys_volume_mm3(spec: ObjectSpec) -> float:
    """Volume of silicone that all keys displace."""
    keys = spec.core.keys
    core = body_of(spec).core_surface()
    if keys.positions_mm and core is not None and not all(f.flat for f in core_frames(spec)):
        inside = manifold_of(core)
        return float(sum((block_manifold(key) - inside).volume() for key in core_keys(spec)))
    return prod(keys.size_mm) * len(keys.positions_mm) * len(core_frames(spec))


@cached_geometry
def relief_slits(spec: ObjectSpec) -> tuple[Block, ...]:
    """One slit per edge between two sensed faces; each begins outside the body, past its edge.

    Slits along z run out through the open face. Of a body without edges they lie halfway between the
    side faces 2 to 5, in planes through z along which a mould opens, with straight bottoms.
    """
    if not spec.shell.slits.depth_mm:
        return ()
    pairs = combinations(face_frames(spec), 2)
    beside = [(a, b) for a, b in pairs if abs(a.normal @ b.normal) < 0.5]
    if body_of(spec).cuboid:
        return tuple(_slit(spec, a, b) for a, b in beside)
    return tuple(
        _slit_between(spec, a, b) for a, b in beside if abs(a.normal[2]) + abs(b.normal[2]) < 0.5
    )


def _slit_between(spec: ObjectSpec, a: FaceFrame, b: FaceFrame) -> Block:
    """Halfway between two sides; `depth_mm` is that at the height of the body's middle."""
    slits, body = spec.shell.slits, body_of(spec)
    out = (a.normal + b.normal) / np.sqrt(2)
    way = np.linspace(0, float(np.linalg.norm(body.half_mm)), _RAY_STEPS)
    within = replace(body, thickness_mm=0.0).core_distance_mm(way[:, None] * out) < 0
    surface = float(way[within].max())
    axis, start = np.array([0.0, 0.0, 1.0]), surface + slits.width_mm
    axes = np.column_stack([axis, -out, np.cross(axis, -out)])
    deep = slits.width_mm + slits.depth_mm
    length = 2 * (float(body.half_mm[2]) - slit_end_mm(spec))
    half = np.array([length, deep, slits.width_mm]) / 2
    return Block((start - deep / 2) * out, axes, half)


def slit_end_mm(spec: ObjectSpec) -> float:
    """Distance of a slit's ends from the corners: the shell's thickness, or where three do not meet."""
    slits = spec.shell.slits
    return float(max(spec.shell.thickness_mm, slits.depth_mm / np.sqrt(2) + slits.width_mm))


def _slit(spec: ObjectSpec, a: FaceFrame, b: FaceFrame) -> Block:
    slits, half_body = spec.shell.slits, np.asarray(spec.body.size_mm) / 2
    edge_axis = np.cross(a.normal, b.normal)
    inward = -(a.normal + b.normal) / np.sqrt(2)
    edge = (a.normal + b.normal) * half_body
    reach = float(abs(edge_axis) @ half_body)
    end_mm = slit_end_mm(spec)
    low, high = end_mm - reach, reach - end_mm
    if abs(edge_axis[2]) > 0.5 and not _sensed_below(spec):
        past = reach + slits.width_mm
        low, high = (-past, high) if edge_axis[2] > 0 else (low, past)
    start, end = -slits.width_mm, slits.depth_mm
    centre = edge + (low + high) / 2 * edge_axis + (start + end) / 2 * inward
    axes = np.column_stack([edge_axis, inward, np.cross(edge_axis, inward)])
    return Block(centre, axes, np.array([high - low, end - start, slits.width_mm]) / 2)


def _sensed_below(spec: ObjectSpec) -> bool:
    return any(frame.normal[2] < -0.5 for frame in face_frames(spec))


def slits_volume_mm3(spec: ObjectSpec, below_mm: float = 0.0) -> float:
    """Volume that the slits take from the body, or from the body less a layer on its faces.

    A slit's section inside the right-angled edge is its width w times its depth d less the corner's
    triangle, w d − w²/4; a layer t takes √2 t of the depth. Without edges the section is a triangle's.
    """
    if not body_of(spec).cuboid:
        within = (
            body_of(spec).cast_surface(below_mm, spec.body.sensed) if relief_slits(spec) else None
        )
        if within is None:
            return 0.0
        outside = manifold_of(within)
        return float(sum((block_manifold(b) ^ outside).volume() for b in relief_slits(spec)))
    width = spec.shell.slits.width_mm
    depth = spec.shell.slits.depth_mm - np.sqrt(2) * below_mm
    section = width * depth - width**2 / 4 if depth >= width / 2 else max(depth, 0.0) ** 2
    half_body = np.asarray(spec.body.size_mm) / 2
    return section * sum(_length_in_body_mm(block, half_body) for block in relief_slits(spec))


def _length_in_body_mm(slit: Block, half_body_mm: np.ndarray) -> float:
    """Length of a slit, along its first axis, within the body."""
    axis, reach = slit.axes[:, 0], float(abs(slit.axes[:, 0]) @ half_body_mm)
    middle = float(axis @ slit.centre_mm)
    ends = np.clip([middle - slit.half_mm[0], middle + slit.half_mm[0]], -reach, reach)
    return float(ends[1] - ends[0])


def block_manifold(block: Block) -> Manifold:
    """A block as a closed mesh."""
    return manifold_of(block_surface(block))
