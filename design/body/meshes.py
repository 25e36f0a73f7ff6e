"""Measures on closed triangle meshes: walls by rays, undercuts by normals, traps for air by height.

All lengths in mm. Meshes follow their solids within the specification's tolerance (0.05 mm by
default), and so do the figures here; walls between parallel planes come out exact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from jaxtyping import Bool, Float, Int

from design.errors import NotOneSolid

if TYPE_CHECKING:
    import trimesh
    from manifold3d import Manifold

RAYS = 5_000
"""Rays a large part gets, about; every facet gets one, and they lie 1 to 2 mm apart on wide ones."""

EDGE_MM = 0.2
"""Shorter edges say nothing of their angle."""

SLIVER_MM = 0.01
"""Nor do triangles that are less high."""

LEDGE_MM2 = 0.5
"""Area below which a ledge hooks nothing, as where a vent ends."""

_STRIP_MM, _STRIPS = 1.0, 20
"""Width and number of strips of a wall that leans, along the pull: no narrower, and not more of them."""

CRUMB_MM3 = 1.0
"""Smaller pieces that cuts leave next to a part are left out: they would come loose in the print."""

_FILM_MM = 1e-3
"""Triangles that are less high have no normal: booleans leave vertices off their plane by up to 2e-5 mm."""
_FACING = -np.cos(np.deg2rad(15))
_START_MM = 1e-4
_EQUAL_MM = 1e-6
"""Walls that differ by less are one, reported at one of its middle rays."""
_MEETS_MM = 1e-9
"""Distance at which a ray may pass a triangle's edge and meet it."""
_LEVEL_MM = 1e-3
"""Step to which heights are rounded, so that points of one level have one height."""


@dataclass(frozen=True)
class ThinnestWall:
    """Smallest thickness met and the middle of that wall."""

    thickness_mm: float
    place_mm: Float[np.ndarray, "3"]


@dataclass(frozen=True)
class Undercut:
    """Undercut, where a part drives into what it releases: area, and the way that must give way sideways.

    `depth_mm` belongs to the patch that needs most: its least width across the pull, by which the
    soft side must move to let it by, or, of a wall that leans a little, its length along the pull
    times the mean tangent of the lean, of the strip of it where that is most; `place_mm` is that
    patch's middle. Ledges below `LEDGE_MM2`, as where a vent ends, and slivers among the triangles
    hook nothing.
    """

    area_mm2: float
    depth_mm: float
    place_mm: Float[np.ndarray, "3"] | None


@dataclass(frozen=True)
class Trap:
    """A high point of the silicone, the surface's normal there, and how deep a bubble it keeps."""

    place_mm: Float[np.ndarray, "3"]
    normal: Float[np.ndarray, "3"]
    depth_mm: float


def one_closed_surface(mesh: trimesh.Trimesh, part: str) -> trimesh.Trimesh:
    """The mesh where it closes round one body, which may have voids; crumbs next to it are left out.

    Raises
    ------
    NotOneSolid
        An InputError: several pieces, none, or a surface that is not closed.
    """
    outsides = sum(piece.volume > 0 for piece in mesh.split(only_watertight=False))
    if outsides > 1 and mesh.is_watertight:
        mesh = _without_crumbs(mesh)
        outsides = sum(piece.volume > 0 for piece in mesh.split(only_watertight=False))
    if outsides != 1 or not mesh.is_watertight:
        state = "closed" if mesh.is_watertight else "not closed"
        raise NotOneSolid(
            f"{part} must be one closed body; these dimensions give {outsides} ({state}). Move its recesses, "
            "holes or pockets apart, or make them smaller",
            mesh,
        )
    return mesh


def _without_crumbs(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """Without pieces below `CRUMB_MM3`, and what they enclose; voids of other pieces stay."""
    import trimesh

    pieces = mesh.split(only_watertight=False)
    crumbs = [piece for piece in pieces if 0 < piece.volume < CRUMB_MM3]
    kept = [
        piece
        for piece in pieces
        if not any(
            (piece.bounds[0] >= crumb.bounds[0]).all()
            and (piece.bounds[1] <= crumb.bounds[1]).all()
            for crumb in crumbs
        )
    ]
    joined: Any = trimesh.util.concatenate(kept) if kept else mesh
    return joined


def thinnest_wall(mesh: trimesh.Trimesh) -> ThinnestWall | None:
    """The smallest distance, through the material, between surfaces that face apart; None if none.

    Rays start from a fine triangulation of the surface, but for films and slivers, and run along the inward
    normal; a wall is where the first surface they meet faces within 15° of the ray. Wedges are no walls,
    their edge is as thin as one likes: `sharpest_edge` finds them. Between a plane and a hole of radius r
    the result is too thick by up to 0.01 r.
    """
    from trimesh.remesh import subdivide_to_size

    edge = max(1.0, float(np.sqrt(mesh.area / (0.3 * RAYS))))
    facing_triangles = np.asarray(mesh.faces)[is_surface_triangle(mesh)]
    vertices, faces = subdivide_to_size(mesh.vertices, facing_triangles, edge, max_iter=30)[:2]
    corner = vertices[faces]
    doubled = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    normal, start = doubled / np.linalg.norm(doubled, axis=1, keepdims=True), corner.mean(axis=1)
    thickness = _thickness_mm(mesh, start, normal)
    if np.isnan(thickness).all():
        return None
    equal = np.flatnonzero(thickness <= np.nanmin(thickness) + _EQUAL_MM)
    least = int(equal[len(equal) // 2])
    value = float(thickness[least])
    return ThinnestWall(value, start[least] - value / 2 * normal[least])


def sharpest_edge(mesh: trimesh.Trimesh) -> tuple[float, Float[np.ndarray, "3"]] | None:
    """Smallest angle (degrees) of material at a convex edge of the mesh, and the edge's middle."""
    convex = np.asarray(mesh.face_adjacency_convex)
    long = np.ptp(mesh.vertices[mesh.face_adjacency_edges], axis=1).max(axis=1) > EDGE_MM
    wide = height_mm(mesh)[mesh.face_adjacency].min(axis=1) > SLIVER_MM
    chosen = np.flatnonzero(convex & long & wide)
    if not len(chosen):
        return None
    sharpest = chosen[np.argmax(mesh.face_adjacency_angles[chosen])]
    angle = 180 - float(np.degrees(mesh.face_adjacency_angles[sharpest]))
    return angle, mesh.vertices[mesh.face_adjacency_edges[sharpest]].mean(axis=0)


def undercut(
    mesh: trimesh.Trimesh, pull: Float[np.ndarray, "3"], where: Bool[np.ndarray, "face"]
) -> Undercut:
    """Faces of a part (of those in `where`) that move into their neighbour when it is pulled."""
    from trimesh.graph import connected_components

    rise = np.asarray(mesh.face_normals) @ pull
    against = where & (rise > np.sin(np.deg2rad(0.5))) & (height_mm(mesh) > SLIVER_MM)
    if not against.any():
        return Undercut(0.0, 0.0, None)
    deepest, place = 0.0, None
    for patch in connected_components(mesh.face_adjacency, nodes=np.flatnonzero(against)):
        if float(mesh.area_faces[patch].sum()) < LEDGE_MM2:
            continue
        points = mesh.triangles[patch].reshape(-1, 3)
        tangent = np.tan(np.arcsin(np.clip(rise[patch], 0, 1 - 1e-9)))
        lean = float(np.average(tangent, weights=mesh.area_faces[patch]))
        depth = least_width_mm(points, pull)
        if lean <= 1:  # a curved wall that leans a little is wider than it hooks; a ledge is not
            whole = float(np.ptp(points @ pull)) * lean
            depth = min(depth, whole)
            if depth > deepest:  # strips can only make it less
                depth = min(depth, _deepest_strip_mm(mesh, np.array(patch), pull))
        if depth > deepest:
            deepest, place = depth, points.mean(axis=0)
    return Undercut(float(mesh.area_faces[against].sum()), deepest, place)


def least_draft_deg(
    mesh: trimesh.Trimesh, pull: Float[np.ndarray, "3"], where: Bool[np.ndarray, "face"]
) -> tuple[float, Float[np.ndarray, "3"]] | None:
    """Smallest draft (degrees) among the faces in `where` that are no undercut, and a place there."""
    rise = -(np.asarray(mesh.face_normals) @ pull)
    chosen = np.flatnonzero(where & (rise > -np.sin(np.deg2rad(0.5))))
    if not len(chosen):
        return None
    rise = np.round(rise, 6) + 0.0
    least = chosen[np.argmin(rise[chosen])]
    draft = float(np.degrees(np.arcsin(np.clip(rise[least], 0.0, 1.0))))
    return draft, mesh.triangles_center[least]


def high_points(
    mesh: trimesh.Trimesh, up: Float[np.ndarray, "3"], rim_mm: float, least_mm: float = _LEVEL_MM
) -> list[Trap]:
    """Places where air stays caught: local maxima of height below the level of the open rim.

    The surface is flooded with air from the top: a bubble at a maximum grows downwards until it can
    leave over the saddle to a higher one. Those less high than `least_mm` are left out, and those
    where the surface faces down, so that the mould is not above it.
    """
    height = np.round(np.asarray(mesh.vertices) @ up / _LEVEL_MM) * _LEVEL_MM
    peaks: list[tuple[int, float]] = []
    for peak, saddle in peaks_and_saddles(height, np.asarray(mesh.edges_unique)):
        drained = height[peak] >= rim_mm - _LEVEL_MM or height[peak] - saddle < least_mm
        if not drained and float(mesh.vertex_normals[peak] @ up) > 0:
            peaks.append((peak, float(height[peak] - saddle)))
    return [
        Trap(np.array(mesh.vertices[peak]), np.array(mesh.vertex_normals[peak]), bubble)
        for peak, bubble in sorted(peaks)
    ]


def peaks_and_saddles(height: np.ndarray, edges: np.ndarray) -> list[tuple[int, float]]:
    """Vertices of local maxima, each with the height at which it joins a higher one (−inf: none)."""
    order = np.lexsort((np.arange(len(height)), -height))
    rank = np.empty(len(order), int)
    rank[order] = np.arange(len(order))
    a, b = np.sort(rank[edges], axis=1).T
    by_lower = np.lexsort((a, b))
    a, b = a[by_lower], b[by_lower]
    peak = np.arange(len(order))  # reached from each vertex by way of its highest neighbours
    first_edge = np.flatnonzero(np.diff(b, prepend=-1))
    peak[b[first_edge]] = a[first_edge]
    while (peak[peak] != peak).any():
        peak = peak[peak]
    owner = {k: k for k in np.unique(peak).tolist()}

    def root(k: int) -> int:
        while owner[k] != k:
            k = owner[k]
        return k

    died: list[tuple[int, float]] = []
    meet = np.flatnonzero(peak[a] != peak[b])
    for peak_a, peak_b, low in np.column_stack([peak[a], peak[b], b])[meet].tolist():
        first, second = sorted((root(peak_a), root(peak_b)))
        if first != second:
            owner[second] = first
            died.append((int(order[second]), float(height[order[low]])))
    return died + [(int(order[k]), -np.inf) for k, above in owner.items() if above == k]


def largest_ceiling(
    mesh: trimesh.Trimesh, up: Float[np.ndarray, "3"], rim_mm: float
) -> tuple[float, Float[np.ndarray, "3"]] | None:
    """Area (mm²) and middle of the largest flat surface that faces up, the rim left out."""
    from trimesh.graph import connected_components

    normals, centres = np.asarray(mesh.face_normals), mesh.triangles_center
    flat = (normals @ up > np.cos(np.deg2rad(1))) & (centres @ up < rim_mm - _LEVEL_MM)
    if not flat.any():
        return None
    patches = connected_components(mesh.face_adjacency, nodes=np.flatnonzero(flat))
    areas = [float(mesh.area_faces[patch].sum()) for patch in patches]
    largest = patches[int(np.argmax(areas))]
    return max(areas), mesh.triangles[largest].reshape(-1, 3).mean(axis=0)


def distance_mm(
    mesh: trimesh.Trimesh, points_mm: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """Distance of points to a closed surface, unsigned."""
    import pyvista

    surface = pyvista.PolyData.from_regular_faces(mesh.vertices, mesh.faces)
    cloud = pyvista.PolyData(np.ascontiguousarray(points_mm, float))
    return abs(np.asarray(cloud.compute_implicit_distance(surface)["implicit_distance"], float))


def boolean_of(
    operation: Literal["union", "difference", "intersection"], meshes: Sequence[trimesh.Trimesh]
) -> trimesh.Trimesh:
    """A boolean of closed surfaces: of a difference, the first without the others.

    trimesh would measure centres of mass first, which took a sixth of all the time of a mould's half.

    Raises
    ------
    ValueError
        A surface is not closed, or looks inwards.
    """
    import trimesh

    if not all(_is_closed_outwards(mesh) for mesh in meshes):
        raise ValueError("Not all meshes are volumes!")
    return getattr(trimesh.boolean, operation)(meshes, engine="manifold", check_volume=False)


def _is_closed_outwards(mesh: trimesh.Trimesh) -> bool:
    return mesh.is_watertight and mesh.is_winding_consistent and signed_mm3(mesh) > 0


def signed_mm3(piece: trimesh.Trimesh) -> float:
    """Return the volume (mm³): below 0 for a void, 0 for no triangles (where trimesh would divide by 0)."""
    # Divergence theorem: each triangle (a, b, c) and the origin span a tetrahedron of (a × b) · c / 6.
    # i triangle, j coordinate
    a, b, c = np.moveaxis(np.asarray(piece.triangles), 1, 0)
    return float(np.einsum("ij,ij->", np.cross(a, b), c)) / 6


def manifold_of(mesh: trimesh.Trimesh) -> Manifold:
    """The closed mesh for exact booleans and rays."""
    from manifold3d import Manifold, Mesh64

    vertices = np.ascontiguousarray(mesh.vertices, dtype=np.float64)
    return Manifold(Mesh64(vertices, np.ascontiguousarray(mesh.faces, dtype=np.uint64)))


def _thickness_mm(
    mesh: trimesh.Trimesh, points_mm: Float[np.ndarray, "n 3"], normals: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """Return the thickness below points of the surface, NaN where no surface faces them there."""
    starts = points_mm - _START_MM * normals
    ends = starts - float(np.linalg.norm(mesh.extents)) * normals
    hits, met = first_hits_mm(mesh, starts, ends)
    apart = np.sum(np.asarray(mesh.face_normals)[met] * normals, axis=1) <= _FACING
    return np.where(apart, np.linalg.norm(hits - points_mm, axis=1), np.nan)


def simplified(surface: trimesh.Trimesh, within_mm: float) -> trimesh.Trimesh:
    """Return a closed surface by fewer and better triangles, within a distance of it."""
    import trimesh

    simple = manifold_of(surface).simplify(within_mm).to_mesh64()
    return trimesh.Trimesh(simple.vert_properties[:, :3], simple.tri_verts.astype(np.int64))


def first_hits_mm(
    mesh: trimesh.Trimesh, starts_mm: Float[np.ndarray, "n 3"], ends_mm: Float[np.ndarray, "n 3"]
) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "n"]]:
    """Return where lines first meet the surface (NaN: nowhere), and in which triangle (then 0).

    By VTK's locator, 10 to 20 µs a ray; Manifold takes up to 1.2 ms on surfaces of 100 000 triangles.
    """
    import pyvista
    from vtkmodules.vtkCommonCore import reference
    from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

    locator = vtkStaticCellLocator()
    locator.SetDataSet(pyvista.PolyData.from_regular_faces(np.asarray(mesh.vertices), mesh.faces))
    locator.BuildLocator()
    number: Any = reference  # whose stubs know no `get`
    share, part, cell, hit, within = number(0.0), number(0), number(0), [0.0] * 3, [0.0] * 3
    hits, met = np.full((len(starts_mm), 3), np.nan), np.zeros(len(starts_mm), int)
    for k, (start, end) in enumerate(zip(starts_mm, ends_mm, strict=True)):
        if locator.IntersectWithLine(start, end, _MEETS_MM, share, hit, within, part, cell):
            hits[k], met[k] = hit, cell.get()
    return hits, met


def is_surface_triangle(mesh: trimesh.Trimesh) -> Bool[np.ndarray, "face"]:
    """Return which triangles have the surface's normal: no films, nor of slivers none of whose
    neighbours faces as they do, as slivers that are left where a surface is drawn by fewer triangles."""
    height = height_mm(mesh)
    alike = np.cos(np.asarray(mesh.face_adjacency_angles)) >= -_FACING
    has_facing = height > SLIVER_MM - _EQUAL_MM
    has_facing[np.asarray(mesh.face_adjacency)[alike]] = True
    return has_facing & (height > _FILM_MM)


def height_mm(mesh: trimesh.Trimesh) -> np.ndarray:
    """Return the height of every triangle over its longest edge."""
    corners = mesh.triangles
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    return 2 * mesh.area_faces / np.maximum(edges, 1e-12)


def _deepest_strip_mm(mesh: trimesh.Trimesh, patch: np.ndarray, pull: np.ndarray) -> float:
    """Depth by which a leaning patch stands in the way of strips along the pull, at most.

    Facets of a large ball on both sides of its seam lean by a degree or two; all of them together are
    long and wide, each strip over them is short.
    """
    from trimesh.remesh import subdivide_to_size

    way = np.cross(pull, mesh.area_faces[patch] @ np.asarray(mesh.face_normals)[patch])
    way /= max(float(np.linalg.norm(way)), 1e-12)
    faces = np.asarray(mesh.faces)[patch]
    across = np.ptp(mesh.vertices[faces].reshape(-1, 3) @ way)
    strip = max(_STRIP_MM, float(across) / _STRIPS)
    vertices, small = subdivide_to_size(mesh.vertices, faces, strip / 3, max_iter=30)[:2]
    corner = vertices[small]
    normal = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]) / 2
    place = corner.mean(axis=1) @ way
    return float(
        np.bincount(((place - place.min()) / strip).astype(int), normal @ pull).max() / strip
    )


def least_width_mm(points: np.ndarray, pull: np.ndarray) -> float:
    """Smallest extent of points over all directions across the pull, in steps of 2.5°."""
    across = np.linalg.svd(np.asarray(pull, float)[None])[2][1:]
    angle = np.deg2rad(np.arange(0, 180, 2.5))
    directions = np.column_stack([np.cos(angle), np.sin(angle)]) @ across
    return float(np.ptp(points @ directions.T, axis=0).min())
