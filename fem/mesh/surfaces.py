"""Closed triangle surfaces that the tetrahedral mesh must follow.

The sealed body (pockets full of silicone), every magnet or sensor board in it as a prism of equal
volume, and thin rings inside the wall that put mesh edges on the line where the core's support ends.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.positions import ShellBodies, shell_body_layout
from design.layout.surface import sealed_body_surface, support_rings
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

ON_SURFACE_MM = 0.1
"""Distance from the face at which a vertex of the mesh counts as on it, at least."""


def surface_tolerance_mm(spec: ObjectSpec) -> float:
    """Return how far a node may lie from the surface that it belongs to."""
    return max(ON_SURFACE_MM, 2 * spec.mesh.envelope_mm)


def all_surfaces(spec: ObjectSpec, magnets: bool = True) -> trimesh.Trimesh:
    """Body, magnets (or none) and support rings in one object, each still closed by itself."""
    import trimesh

    prisms = body_surfaces(spec) if magnets else []
    surfaces = [sealed_body_surface(spec), *prisms, *support_rings(spec)]
    start = np.cumsum([0, *(len(surface.vertices) for surface in surfaces)])
    return trimesh.Trimesh(
        np.concatenate([surface.vertices for surface in surfaces]),
        np.concatenate([s.faces + first for s, first in zip(surfaces, start, strict=False)]),
        process=False,
    )


def body_surfaces(spec: ObjectSpec) -> list[trimesh.Trimesh]:
    """Each rigid body (magnet or sensor board) as a prism of its outline's area and its height."""
    layout = shell_body_layout(spec)
    surfaces = []
    for centre, frame, body in zip(layout.centre_mm, layout.frame, layout.bodies, strict=True):
        surface = prism_surface(body.outline.corners_mm(spec.mesh.magnet_sides), body.height_mm)
        surface.apply_transform(_placed(frame, centre))
        surfaces.append(surface)
    return surfaces


def points_in_body(
    points_mm: Float[np.ndarray, "n 3"], layout: ShellBodies, index: int, spec: ObjectSpec
) -> Bool[np.ndarray, "n"]:
    """Return whether points lie inside the prism of one rigid body."""
    x, y, z = ((points_mm - layout.centre_mm[index]) @ layout.frame[index]).T
    body = layout.bodies[index]
    corner = body.outline.corners_mm(spec.mesh.magnet_sides)
    edge = np.roll(corner, -1, axis=0) - corner
    left_of_edge = edge[:, :1] * (y - corner[:, 1:]) - edge[:, 1:] * (x - corner[:, :1])
    return (left_of_edge > 0).all(axis=0) & (abs(z) < body.height_mm / 2)


def prism_surface(corners_mm: np.ndarray, height_mm: float) -> trimesh.Trimesh:
    import trimesh

    sides = len(corners_mm)
    half = np.full((sides, 1), height_mm / 2)
    vertices = np.vstack(
        [
            np.hstack([corners_mm, half]),
            np.hstack([corners_mm, -half]),
            [[0, 0, 1], [0, 0, -1]] * half[0],
        ]
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


def _placed(frame: np.ndarray, origin_mm: np.ndarray) -> np.ndarray:
    """Homogeneous transform from a body's own frame to the object's."""
    transform = np.eye(4)
    transform[:3, :3] = frame
    transform[:3, 3] = origin_mm
    return transform
