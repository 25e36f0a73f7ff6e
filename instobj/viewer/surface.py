"""Triangles for the page: the silicone's surface, and parts, with vertices split along sharp edges.

A vertex on a sharp edge stands once for each smooth side, so that shading stays sharp there.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

if TYPE_CHECKING:
    import trimesh

SHARP_DEG = 35.0
"""Angle between triangles from which their edge is drawn sharp."""
_MANY = 3000
"""Triangles from which a mesh is simplified."""
_SIMPLIFIED_MM = 0.03
"""Tolerance of that."""


@dataclass(frozen=True)
class Shaded:
    """Triangles whose vertices have one normal each; `source` is the vertex that each came from."""

    points_mm: Float[np.ndarray, "vertex 3"]
    triangles: Int[np.ndarray, "triangle 3"]
    source: Int[np.ndarray, "vertex"]
    normals: Float[np.ndarray, "vertex 3"]


def boundary_triangles(
    points_mm: Float[np.ndarray, "vertex 3"], tets: Int[np.ndarray, "tet 4"]
) -> Int[np.ndarray, "triangle 3"]:
    """Sides of one tetrahedron alone, counter-clockwise seen from outside."""
    sides = tets[:, [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]].reshape(-1, 3)
    _, first, count = np.unique(
        np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True
    )
    return sides[np.sort(first[count == 1])]


def shaded(
    points_mm: Float[np.ndarray, "vertex 3"], triangles: Int[np.ndarray, "triangle 3"]
) -> Shaded:
    """Split the vertices where two triangles meet at more than `SHARP_DEG`."""
    corner = points_mm[triangles]
    across = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    side = _smooth_sides(triangles, across / np.linalg.norm(across, axis=1, keepdims=True))
    pairs = np.column_stack([triangles.ravel(), np.repeat(side, 3)])
    kept, index = np.unique(pairs, axis=0, return_inverse=True)
    corners = index.reshape(-1, 3)
    normals = np.zeros((len(kept), 3))
    np.add.at(normals, corners, across[:, None])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Shaded(points_mm[kept[:, 0]], corners, kept[:, 0], normals)


def shaded_part(mesh: trimesh.Trimesh) -> Shaded:
    """A part for the page; surfaces of many triangles lose as many as 0.03 mm allow."""
    if len(mesh.faces) > _MANY:
        mesh = _simplified(mesh)
    merged = mesh.copy()
    merged.merge_vertices()
    return shaded(np.asarray(merged.vertices), np.asarray(merged.faces))


def _simplified(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    import manifold3d
    import trimesh

    merged = mesh.copy()
    merged.merge_vertices()
    solid = manifold3d.Manifold(
        manifold3d.Mesh(
            np.asarray(merged.vertices, np.float32), np.asarray(merged.faces, np.uint32)
        )
    )
    if solid.status() != manifold3d.Error.NoError:
        return mesh
    fewer = solid.simplify(_SIMPLIFIED_MM).to_mesh()
    return trimesh.Trimesh(fewer.vert_properties[:, :3], fewer.tri_verts, process=False)


def _smooth_sides(
    triangles: Int[np.ndarray, "triangle 3"], normals: Float[np.ndarray, "triangle 3"]
) -> Int[np.ndarray, "triangle"]:
    """Number of the smooth side that each triangle belongs to."""
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    owner = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort(edges.T)
    same = (edges[order][1:] == edges[order][:-1]).all(axis=1)
    a, b = owner[order][:-1][same], owner[order][1:][same]
    smooth = (normals[a] * normals[b]).sum(axis=1) > np.cos(np.deg2rad(SHARP_DEG))
    a, b = a[smooth], b[smooth]
    graph = coo_array((np.ones(len(a)), (a, b)), shape=(len(triangles),) * 2)
    return connected_components(graph, directed=False)[1]


@dataclass(frozen=True)
class Links:
    """Vertices of the picture that move with vertices of the faces: `vector` per mm inwards."""

    picture: Int[np.ndarray, "link"]
    face: Int[np.ndarray, "link"]
    vector: Float[np.ndarray, "link 3"]


def links_of(
    source: Int[np.ndarray, "vertex"],
    of_faces: Int[np.ndarray, "motion"],
    normals: Float[np.ndarray, "motion 3"],
) -> Links:
    """The smallest displacement of each vertex that has the inward motions of all faces it is on.

    On an edge between two faces that is the sum of both, where patches of a curved body overlap their
    mean.
    """
    order = np.argsort(of_faces, kind="stable")
    starts = np.searchsorted(of_faces[order], source)
    ends = np.searchsorted(of_faces[order], source, side="right")
    picture, face, vector = [], [], []
    for vertex, (start, end) in enumerate(zip(starts, ends, strict=True)):
        if start == end:
            continue
        rows = order[start:end]
        picture += [vertex] * len(rows)
        face += rows.tolist()
        vector += list(-np.linalg.pinv(normals[rows], rcond=0.1).T)
    return Links(np.array(picture), np.array(face), np.array(vector).reshape(-1, 3))
