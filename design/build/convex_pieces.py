"""Convex pieces of a closed surface, for the collisions of a simulator."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.meshes import distance_mm, manifold_of

if TYPE_CHECKING:
    import trimesh
    from manifold3d import Manifold

_SPACING_MM = 1.0
"""Distance of points at which hulls are compared with the surface: between two points of a flat hull
the distance to a surface changes by half of this at most, of a smooth one by far less."""
_NOTHING_MM = 1e-6
"""Distances below this are rounding of booleans."""


@dataclass(frozen=True)
class ConvexPieces:
    """Convex surfaces that together hold a body, and how far (mm) they reach beyond its surface."""

    pieces: tuple[trimesh.Trimesh, ...]
    error_mm: float


def convex_pieces(surface: trimesh.Trimesh, tolerance_mm: float, most: int) -> ConvexPieces:
    """Return convex pieces whose union holds a closed surface, cut until they are near enough.

    The piece that reaches farthest beyond the surface is cut there, along the axis that leaves the
    smallest hulls, until none reaches farther than `tolerance_mm` or there are `most` pieces.
    """
    whole = manifold_of(surface)
    solids = whole.decompose()
    errors = [_farthest(whole, surface, solid) for solid in solids]
    while len(solids) < most:
        worst = max(range(len(solids)), key=lambda number: errors[number][0])
        error, place = errors[worst]
        if error <= tolerance_mm:
            break
        parts = _cut_at(solids[worst], place)
        solids[worst : worst + 1] = parts
        errors[worst : worst + 1] = [_farthest(whole, surface, part) for part in parts]
    hulls = tuple(_surface_of(solid.hull()) for solid in solids)
    return ConvexPieces(hulls, max(error for error, _ in errors))


def _farthest(
    whole: Manifold, surface: trimesh.Trimesh, solid: Manifold
) -> tuple[float, Float[np.ndarray, "3"]]:
    """Return how far a solid's hull reaches beyond the whole surface, and where (mm)."""
    beyond = solid.hull() - whole
    if beyond.is_empty():
        return 0.0, np.zeros(3)
    points = np.asarray(
        beyond.refine_to_length(_SPACING_MM).to_mesh().vert_properties[:, :3], float
    )
    distance = distance_mm(surface, points)
    farthest = int(np.argmax(distance))
    error = float(distance[farthest])
    return (error if error > _NOTHING_MM else 0.0), points[farthest]


def _cut_at(solid: Manifold, place_mm: Float[np.ndarray, "3"]) -> list[Manifold]:
    """Return both sides of the cut through a place, along the axis that leaves the smallest hulls."""
    cuts = []
    for normal in np.eye(3):
        sides = solid.split_by_plane(tuple(normal), float(place_mm @ normal))
        parts = [part for side in sides for part in side.decompose() if part.volume() > 0]
        if len(parts) > 1:
            cuts.append((sum(part.hull().volume() for part in parts), len(cuts), parts))
    return min(cuts)[2]


def _surface_of(solid: Manifold) -> trimesh.Trimesh:
    import trimesh

    mesh = solid.to_mesh()
    return trimesh.Trimesh(np.asarray(mesh.vert_properties[:, :3], float), mesh.tri_verts)
