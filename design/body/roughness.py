"""Grooves and ridges that are finer than the grid on which a body's surface is sampled."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.body.meshes import first_hits_mm
from design.body.sampled import sampled_frame

if TYPE_CHECKING:
    import trimesh

    from design.body.kinds.base import BodyKind
    from design.body.surface_chart import FaceFrame

TOLD_MM = 0.2
"""Distance by which a sampled surface may be off without a word: that of a printed layer."""
_EDGE_MM, _MOST_EDGES = 1.0, 100
"""Longest edge of the triangles whose corners are compared, and edges along a body at least."""
_FACING = 0.05
"""Cosine beyond which a triangle faces as its patch does: steeper ones are walls of grooves."""
_SAME_MM = 0.01
"""Distance within which a ray from outside meets a corner: it is seen, not under an overhang."""


@dataclass(frozen=True)
class Roughness:
    """Points of a face's real surface, in the object's frame, where the sampled one is off by more than
    `TOLD_MM`, and by how much."""

    points_mm: Float[np.ndarray, "n 3"]
    off_mm: Float[np.ndarray, "n"]


def roughness(body: BodyKind, number: int) -> Roughness:
    """Return how far the sampled surface of a face is off the triangles that it was sampled from.

    Measured along the face's normal and turned onto the sampled surface's own, at the corners of
    triangles of 1 mm that are seen from outside. A groove of any width has corners on its floor.
    """
    return _roughness(body.outside, number)


@lru_cache(maxsize=64)
def _roughness(body: BodyKind, number: int) -> Roughness:
    frame = sampled_frame(body, number, 0.0)
    surface = body.outer_surface()
    points = _corners_facing(surface, frame)
    x, y, z = ((points - frame.centre_mm) @ frame.axes).T
    inside = np.hypot(x / frame.half_extents_mm[0], y / frame.half_extents_mm[1]) < 1
    points, z = points[inside], z[inside]
    height, slope = frame.relief.evaluate(np.column_stack([x, y])[inside])
    # a height along the frame's normal, times the cosine of the slope, is a distance to the surface
    off = abs(height - z) / np.sqrt(1 + np.sum(slope**2, axis=1))
    points, off = points[off > TOLD_MM], off[off > TOLD_MM]
    is_visible = _seen(surface, points, frame)
    return Roughness(points[is_visible], off[is_visible])


def _corners_facing(surface: trimesh.Trimesh, frame: FaceFrame) -> Float[np.ndarray, "n 3"]:
    """Return corners of the small triangles that face as the frame does."""
    from trimesh.remesh import subdivide_to_size

    faces = np.asarray(surface.faces)[np.asarray(surface.face_normals) @ frame.normal > _FACING]
    edge = max(_EDGE_MM, float(max(surface.extents)) / _MOST_EDGES)
    corners, small = subdivide_to_size(surface.vertices, faces, edge, max_iter=30)[:2]
    return corners[np.unique(small)]


def _seen(
    surface: trimesh.Trimesh, points_mm: Float[np.ndarray, "n 3"], frame: FaceFrame
) -> Bool[np.ndarray, "n"]:
    """Return which points the first surface is that a line from outside, along the normal, meets."""
    above = float(np.linalg.norm(surface.extents)) * frame.normal
    hits, _ = first_hits_mm(surface, points_mm + above, points_mm - above)
    return np.linalg.norm(hits - points_mm, axis=1) < _SAME_MM
