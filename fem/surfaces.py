"""Closed triangle surfaces that the tetrahedral mesh must follow.

The sealed body (pockets full of silicone and magnets), every magnet as a prism of equal volume,
and a thin ring inside the wall that puts mesh edges on the line where the core's support ends.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.layouts import magnet_layout
from design.spec import ObjectSpec

if TYPE_CHECKING:
    import trimesh

_OVERSHOOT_MM = 1.0
_SUPPORT_RING_MM = 2.0


def all_surfaces(spec: ObjectSpec, magnets: bool = True) -> trimesh.Trimesh:
    """Body, magnets (or none) and support ring in one object, each still closed by itself."""
    import trimesh

    prisms = magnet_surfaces(spec) if magnets else []
    surfaces = [sealed_body_surface(spec), *prisms, support_ring_surface(spec)]
    start = np.cumsum([0, *(len(surface.vertices) for surface in surfaces)])
    return trimesh.Trimesh(
        np.concatenate([surface.vertices for surface in surfaces]),
        np.concatenate([s.faces + first for s, first in zip(surfaces, start, strict=False)]),
        process=False,
    )


def sealed_body_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """Outer box less the cavity, which runs from the core's top out through the open face."""
    import trimesh

    outer = trimesh.creation.box(spec.body.size_mm)
    core_x, core_y, core_z = spec.core_size_mm
    bottom = -spec.body.size_mm[2] / 2 - _OVERSHOOT_MM
    cavity = trimesh.creation.box((core_x, core_y, core_z / 2 - bottom))
    cavity.apply_translation((0, 0, (core_z / 2 + bottom) / 2))
    return outer.difference(cavity)


def magnet_surfaces(spec: ObjectSpec) -> list[trimesh.Trimesh]:
    """Each magnet as an n-sided prism of the disk's own volume and height."""
    layout = magnet_layout(spec)
    prism = _prism(spec.mesh.magnet_sides, spec.magnets.diameter_mm / 2, spec.magnets.height_mm)
    surfaces = []
    for centre, axis in zip(layout.centre_mm, layout.axis, strict=True):
        surface = prism.copy()
        surface.apply_transform(_frame_along(axis, centre))
        surfaces.append(surface)
    return surfaces


def in_magnet(
    points_mm: Float[np.ndarray, "n 3"],
    centre_mm: Float[np.ndarray, "3"],
    axis: Float[np.ndarray, "3"],
    spec: ObjectSpec,
) -> Bool[np.ndarray, "n"]:
    """Whether points lie inside the prism of a magnet with this centre and axis."""
    sides = spec.mesh.magnet_sides
    x, y, z = ((points_mm - centre_mm) @ _frame_along(axis, centre_mm)[:3, :3]).T
    apothem = _circumradius(sides, spec.magnets.diameter_mm / 2) * np.cos(np.pi / sides)
    normal = 2 * np.pi / sides * np.arange(sides)
    distance = np.max(np.outer(np.cos(normal), x) + np.outer(np.sin(normal), y), axis=0)
    return (distance < apothem) & (abs(z) < spec.magnets.height_mm / 2)


def support_ring_surface(spec: ObjectSpec) -> trimesh.Trimesh:
    """Closed ring in the cavity wall, from the end of the core a little towards the open face."""
    import trimesh

    core_x, core_y, core_z = spec.core_size_mm
    width = min(_SUPPORT_RING_MM, spec.shell.thickness_mm / 3)
    outer = trimesh.creation.box((core_x + 2 * width, core_y + 2 * width, width))
    inner = trimesh.creation.box((core_x, core_y, 2 * width))
    ring = outer.difference(inner)
    ring.apply_translation((0, 0, -core_z / 2 - width / 2))
    return ring


def _prism(sides: int, radius_mm: float, height_mm: float) -> trimesh.Trimesh:
    import trimesh

    theta = (np.arange(sides) + 0.5) * 2 * np.pi / sides
    circumradius = _circumradius(sides, radius_mm)
    corner = np.column_stack([np.cos(theta), np.sin(theta)]) * circumradius
    half = np.full((sides, 1), height_mm / 2)
    vertices = np.vstack(
        [np.hstack([corner, half]), np.hstack([corner, -half]), [[0, 0, 1], [0, 0, -1]] * half[0]]
    )
    i = np.arange(sides)
    j = (i + 1) % sides
    top, bottom = np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    faces = np.concatenate(
        [
            np.column_stack([top, i, j]),
            np.column_stack([bottom, sides + j, sides + i]),
            np.column_stack([i, sides + i, sides + j]),
            np.column_stack([i, sides + j, j]),
        ]
    )
    return trimesh.Trimesh(vertices, faces, process=False)


def _circumradius(sides: int, radius_mm: float) -> float:
    """Of the regular polygon with the area of a circle of `radius_mm`."""
    angle = 2 * np.pi / sides
    return float(radius_mm * np.sqrt(angle / np.sin(angle)))


def _frame_along(axis: np.ndarray, origin_mm: np.ndarray) -> np.ndarray:
    """Homogeneous transform that takes +z to `axis` and the origin to `origin_mm`."""
    helper = np.eye(3)[int(np.argmin(abs(axis)))]
    x = np.cross(helper, axis)
    x /= np.linalg.norm(x)
    transform = np.eye(4)
    transform[:3, :3] = np.column_stack([x, np.cross(axis, x), axis])
    transform[:3, 3] = origin_mm
    return transform
