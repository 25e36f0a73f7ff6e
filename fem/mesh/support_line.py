"""Edges of the mesh along the line where the core's support ends, by exact edge bisection.

The mesher follows the support rings' surfaces to within its envelope, but promises no edge along
the line and no longest edge. Bisection moves no vertex and adds both.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Float, Int

from design.layout.body import body_of
from design.spec.object import ObjectSpec
from fem.mesh.entities import tet_mesh
from fem.mesh.surfaces import surface_tolerance_mm

LONGEST_EDGE = 4 / 3
"""Longest edge on the line, in `mesh.edge_mm`: where the mesher itself would split an edge."""


def with_support_lines(
    points_mm: Float[np.ndarray, "vertex 3"],
    tets: Int[np.ndarray, "tet 4"],
    spec: ObjectSpec,
) -> tuple[Float[np.ndarray, "finer 3"], Int[np.ndarray, "finer_tet 4"]]:
    """Bisect edges until no triangle of the cavity's wall lies on both sides of a support's end.

    Vertices of the wall within `surface_tolerance_mm` of the line count as on it, as they do where
    the core holds nodes. Edges on the line end up no longer than `LONGEST_EDGE` × `mesh.edge_mm`.
    """
    near_mm, longest_mm = surface_tolerance_mm(spec), LONGEST_EDGE * spec.mesh.edge_mm
    for normal, level_mm in body_of(spec).support_ends:
        while True:
            edges = _wall_edges(points_mm, tets, spec, normal, level_mm)
            height = points_mm[edges] @ normal - level_mm
            height[abs(height) < near_mm] = 0
            across = height.prod(axis=1) < 0
            length = np.linalg.norm(np.diff(points_mm[edges], axis=1)[:, 0], axis=1)
            split = across | ((height == 0).all(axis=1) & (length > longest_mm))
            if not split.any():
                break
            share = np.where(across, height[:, 0] / np.where(across, np.ptp(height, 1), 1), 0.5)
            points_mm, tets = bisect_edges(points_mm, tets, edges[split], abs(share[split]))
    return points_mm, tets


def bisect_edges(
    points_mm: Float[np.ndarray, "vertex 3"],
    tets: Int[np.ndarray, "tet 4"],
    edges: Int[np.ndarray, "edge 2"],
    share: Float[np.ndarray, "edge"],
) -> tuple[Float[np.ndarray, "finer 3"], Int[np.ndarray, "finer_tet 4"]]:
    """A new vertex on every edge, `share` of the way along it; every tetrahedron there in two."""
    start, end = np.moveaxis(points_mm[edges], 1, 0)
    middle = start + share[:, None] * (end - start)
    for new, (a, b) in enumerate(edges, len(points_mm)):
        shared = (tets == a).any(axis=1) & (tets == b).any(axis=1)
        halves = [np.where(tets[shared] == old, new, tets[shared]) for old in (a, b)]
        tets = np.concatenate([tets[~shared], *halves])
    return np.concatenate([points_mm, middle]), tets


def _wall_edges(
    points_mm: np.ndarray,
    tets: np.ndarray,
    spec: ObjectSpec,
    normal: np.ndarray,
    level_mm: float,
) -> Int[np.ndarray, "edge 2"]:
    """Edges of the triangles on the cavity's wall, the core's and its continuation past the end."""
    mesh = tet_mesh(points_mm, tets)
    beyond = np.clip(points_mm @ normal - level_mm, 0, None)
    on_wall = abs(
        body_of(spec).core_distance_mm(points_mm - beyond[:, None] * normal)
    ) < surface_tolerance_mm(spec)
    triangles = np.asarray(mesh.facets)[:, mesh.boundary_facets()].T
    triangles = triangles[on_wall[triangles].all(axis=1)]
    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    return np.unique(np.sort(sides, axis=1), axis=0)
