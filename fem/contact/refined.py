"""Surface compliance finer than the mesh: finite elements for what is wide, a half-space for the rest.

A contact smaller than a few triangles of the surface would depend on where their vertices lie. A
cell of uniform pressure is therefore split in two: hat functions around it, of the same force about
the same place, whose response the finite elements know, and the difference to them, which is felt
about one triangle deep and takes a half-space's compliance (as near forces in particle–mesh methods):
    C = Pᵀ (C_fem − H_hats) P + H_cells,      P = (2 − W⁻¹ M) B,      H of `fem.contact.half_space`.
What a magnet close under the face takes back of the half-space's part is `fem.contact.rigid_base`.
B shares a cell's force by barycentric weights; M is the mass matrix of the hats, W its row sums, and
2 − W⁻¹ M narrows what B has spread. Sphere of R 5 mm on a bonded layer of 8 mm, ν = 0.5, surface
edges of 2 and 1 mm: within 2 % of published forces at 0.25 to 2 mm depth. `fem.presses.table` has the
scatter on the real object.

Next to a flat face's border the body is a quarter-space, which gives way more. There H takes the same
patches once more beyond the border, mirrored, times ψ = 1.29 − (0.08 − 0.5 ν)/(1 − ν) (Guilbault, J.
Tribol. 133 (2011) 031402); at a corner those of both borders and of what is mirrored twice, times ψ².
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from scipy.spatial import Delaunay, KDTree

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frame
from design.layout.dents import sunk_mm
from design.spec.object import ObjectSpec
from fem.contact.half_space import HAT_OWN, Patches, chosen, normal_compliance
from fem.contact.indenter import Border
from fem.contact.pad import pad_compliance
from fem.contact.rigid_base import LEAST_WEIGHT, RigidBase, rigid_bases
from fem.linear.response import FaceSurface, ResponseOperator

_FAR_MM = 1e3
"""Place of cells that miss the face, and of a border where the body goes on."""
_NEAR_FACETS = 12
"""Triangles of nearest centroids, of which one holds a point."""
_BORDER_REACH_MM = 2.5
"""Cells this near to a border take a quarter-space's compliance."""


@dataclass(frozen=True)
class RefinedFace:
    """One face with the part of its compliance that finite elements keep, C_fem − H_hats, Young's
    modulus (MPa) and Poisson's ratio at it, and the rigid bodies under it."""

    frame: FaceFrame
    surface: FaceSurface
    index: int
    hats: Patches
    wide_compliance: Float[np.ndarray, "vertex vertex"]
    narrowing: sp.csc_matrix
    triangulation: Delaunay
    elastic: tuple[float, float]
    bases: tuple[RigidBase, ...] = ()

    @cached_property
    def border(self) -> Border | None:
        """Return where the body ends (`FaceFrame.ends`), as the shell stands, in the face's x and y."""
        if not any(self.frame.ends):
            return None
        low = np.where(self.frame.ends, self.surface.xy_mm.min(axis=0), -_FAR_MM)
        high = np.where(self.frame.ends, self.surface.xy_mm.max(axis=0), _FAR_MM)
        return Border(low, high, self.frame.round)

    @cached_property
    def facets(self) -> tuple[KDTree, Float[np.ndarray, "triangle 2 3"]]:
        """Centroids of a curved face's triangles, and what a vector from a triangle's first corner has of
        the edges to the other two."""
        corner = self.surface.points_mm[self.surface.triangles]
        edges = corner[:, 1:] - corner[:, :1]
        # rows of (E Eᵀ)⁻¹ E: shares of the edges E in a vector, by least squares off the triangle's plane
        shares = np.linalg.solve(edges @ edges.transpose(0, 2, 1), edges)
        return KDTree(corner.mean(axis=1)), shares

    @cached_property
    def narrowing_by_vertex(
        self,
    ) -> tuple[Int[np.ndarray, "vertex neighbour"], Float[np.ndarray, "vertex neighbour"]]:
        """Columns of `narrowing`, all as long as the longest: the others end on themselves with 0."""
        length = np.diff(self.narrowing.indptr)
        neighbours = np.repeat(np.arange(len(length))[:, None], length.max(), axis=1)
        weights = np.zeros(neighbours.shape)
        has_neighbour = np.arange(length.max()) < length[:, None]
        neighbours[has_neighbour], weights[has_neighbour] = (
            self.narrowing.indices,
            self.narrowing.data,
        )
        return neighbours, weights


@dataclass(frozen=True)
class Spread:
    """Cells of unit pressure on one face, and the pressures of hats that stand for them.

    `patches` lie on the face, `in_plane` are the same in the plane that touches it where the indenter
    lands. `matrix` (row, cell) is for the face's vertices `rows`; `height_mm` is the face's own over that
    plane, `cosine` that of how it leans there; both are NaN off the patch. `above_mm` is how
    far a slipped or dented face lies above the one at rest.
    """

    face: RefinedFace
    patches: Patches
    in_plane: Patches
    rows: Int[np.ndarray, "row"]
    matrix: Float[np.ndarray, "row cell"]
    height_mm: Float[np.ndarray, "cell"]
    cosine: Float[np.ndarray, "cell"]
    above_mm: Float[np.ndarray, "cell"]


def refined_face(response: ResponseOperator, index: int, spec: ObjectSpec) -> RefinedFace:
    """Prepare the index-th face of a response."""
    surface, loads = with_dents(spec, response, index), response.face_loads(index)
    hats = hat_patches(surface)
    wide = np.asarray(response.compliance[loads, loads]) - cells_compliance(hats, spec)
    frame, around = face_frame(spec, surface.number), Delaunay(surface.xy_mm)
    without = response.magnet_loads.start == len(response.compliance)
    bases = () if without else rigid_bases(spec, frame, surface, hats)
    elastic = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    return RefinedFace(
        frame, surface, index, hats, wide, hat_narrowing(surface), around, elastic, bases
    )


def with_dents(spec: ObjectSpec, response: ResponseOperator, index: int) -> FaceSurface:
    """The index-th face, lower where seals have sunk; a shell without magnets has no seals.

    To first order in the dents: the indenter meets the dented surface, whose compliance is still
    that of the flat one. docs/measured/robustness.md says how wrong that is.
    """
    surface = response.surfaces[index]
    if response.magnet_loads.start == len(response.compliance):
        return surface
    sunk = sunk_mm(spec, surface.number, surface.xy_mm)
    return replace(surface, height_mm=-sunk) if sunk.any() else surface


def spread_cells(face: RefinedFace, patches: Patches, place_mm: Float[np.ndarray, "2"]) -> Spread:
    """Share every cell's force among the hats around it.

    `patches` lie in the plane that touches the face at `place_mm`, called by the place's own x, y.
    """
    on_face, height, cosine = _project_onto_face(face.frame, patches.centre_mm, place_mm)
    missed = ~np.isfinite(height)
    points = np.where(missed[:, None], 0, on_face)
    if face.frame.flat:
        vertices, share = barycentric(face.triangulation, points[:, :2])
    else:
        vertices, share = facet_shares(face, points)
    area = patches.area_mm2 / np.where(missed, 1, cosine)
    force = share * (area * ~missed)[:, None] / face.hats.area_mm2[vertices]
    rows, matrix = _narrowed(face, vertices, force)
    above = np.zeros(len(vertices))
    if face.surface.height_mm is not None:
        above = np.sum(share * face.surface.height_mm[vertices], axis=1)
    beside = np.column_stack([patches.centre_mm, np.full(len(vertices), _FAR_MM)])
    lying = replace(patches, area_mm2=area, centre_mm=np.where(missed[:, None], beside, on_face))
    return Spread(face, lying, patches, rows, matrix, height + above, cosine, above)


def _narrowed(
    face: RefinedFace, vertices: Int[np.ndarray, "cell 3"], force: Float[np.ndarray, "cell 3"]
) -> tuple[Int[np.ndarray, "row"], Float[np.ndarray, "row cell"]]:
    """Rows and entries of the narrowing times the cells' shares; SciPy's sparse matrices take three
    times as long for these few."""
    neighbours, weights = face.narrowing_by_vertex
    row = neighbours[vertices]
    reached = np.zeros(len(neighbours), bool)
    reached[row] = True
    (rows,) = np.nonzero(reached)
    place = np.cumsum(reached) - 1
    cells = len(vertices)
    slot = place[row] * cells + np.arange(cells)[:, None, None]
    entry = weights[vertices] * force[..., None]
    return rows, np.bincount(slot.ravel(), entry.ravel(), len(rows) * cells).reshape(-1, cells)


def _project_onto_face(
    frame: FaceFrame, xy_mm: np.ndarray, place_mm: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points of the touching plane on the face (in its frame), how much higher, how it leans."""
    flat = np.column_stack([xy_mm, np.zeros(len(xy_mm))])
    if frame.flat:
        return flat, np.zeros(len(flat)), np.ones(len(flat))
    tangent = frame.tangent(place_mm)
    points = tangent.to_object(flat)
    on_face = frame.project_along(points, tangent.normal)
    on_face[~frame.touched(on_face[:, :2])] = np.nan
    height = (on_face - frame.plane_coordinates(points)) @ (tangent.normal @ frame.axes)
    return on_face, height, frame.axes_at(on_face[:, :2])[..., 2] @ tangent.normal


def wide_block(spread: Spread) -> Float[np.ndarray, "cell cell"]:
    """Pᵀ (C_fem − H_hats) P, less what rigid bodies take back: what H of the cells is added to."""
    inner = spread.face.wide_compliance.take(spread.rows, axis=0).take(spread.rows, axis=1)
    wide = spread.matrix.T @ inner @ spread.matrix
    for base in spread.face.bases:
        take_back(wide, spread, base)
    if spread.face.border is not None:
        add_border(wide, spread, spread.face.border)
    return wide


def add_border(wide: Float[np.ndarray, "cell cell"], spread: Spread, border: Border) -> None:
    """Add H_cells − Pᵀ H_hats P between the cells next to a border and their mirror images."""
    constants = spread.face.elastic
    poisson_ratio = constants[1]
    # Guilbault (2011): how much more than its mirror image a free border gives way
    more = 1.29 - (0.08 - 0.5 * poisson_ratio) / (1 - poisson_ratio)
    inside = -border.side_distances_mm(spread.patches.centre_mm[:, :2])
    for sides in border.near_sides(inside, _BORDER_REACH_MM):
        (cells,) = np.nonzero((inside[:, sides] < _BORDER_REACH_MM).all(axis=1))
        matrix = spread.matrix[:, cells]
        (used,) = np.nonzero(matrix.any(axis=1))
        matrix, hats = matrix[used], chosen(spread.face.hats, spread.rows[used])
        patches = chosen(spread.patches, cells)
        near, far = (
            normal_compliance(
                group, replace(group, centre_mm=border.mirrored(group.centre_mm, sides)), *constants
            )
            for group in (patches, hats)
        )
        wide[np.ix_(cells, cells)] += more ** len(sides) * (near - matrix.T @ far @ matrix)


def take_back(wide: Float[np.ndarray, "cell cell"], spread: Spread, base: RigidBase) -> None:
    """Add D (Pᵀ G_hats P − G_cells) D: D are the cells' weights, G is what the body takes back.

    Weights are the cells' alone, so that hats still stand for each cell's force and place.
    """
    points = spread.patches.centre_mm
    if spread.face.surface.slip_mm is None:  # dents are nearer the body; it slips with its face
        points = points + np.outer(spread.above_mm, [0.0, 0.0, 1.0])
    weight, depth = base.weights(points)
    (cells,) = np.nonzero(weight > LEAST_WEIGHT)
    if not len(cells):
        return
    matrix = spread.matrix[:, cells] * weight[cells]
    (used,) = np.nonzero(matrix.any(axis=1))
    matrix = matrix[used]
    hats = base.taken_back(chosen(spread.face.hats, spread.rows[used]), depth)
    near = base.taken_back_wherever(spread.in_plane, depth).take(cells, axis=0).take(cells, axis=1)
    # areas on the face are larger than in the plane, as in `place_compliance`
    share = weight[cells] * spread.patches.area_mm2[cells] / spread.in_plane.area_mm2[cells]
    wide[np.ix_(cells, cells)] += matrix.T @ hats @ matrix - near * np.multiply.outer(share, share)


def place_compliance(
    spread: Spread, near: Float[np.ndarray, "cell cell"]
) -> Float[np.ndarray, "cell cell"]:
    """Compliance of one indenter's cells; `near` is `near_compliance` in the touching plane."""
    if spread.face.frame.flat:
        return wide_block(spread) + near
    lean = 1 / np.nan_to_num(spread.cosine, nan=1.0)
    return wide_block(spread) + near * np.multiply.outer(lean, lean)


def cells_compliance(patches: Patches, spec: ObjectSpec) -> Float[np.ndarray, "cell cell"]:
    """H of the cells: on a half-space of what lies under the surface."""
    constants = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    return normal_compliance(patches, patches, *constants)


def near_compliance(patches: Patches, spec: ObjectSpec) -> Float[np.ndarray, "cell cell"]:
    """H of an indenter's cells, and what its pad gives way."""
    return cells_compliance(patches, spec) + pad_compliance(patches, spec.indenter)


def joint_compliance(
    response: ResponseOperator, spreads: Sequence[Spread], spec: ObjectSpec
) -> Float[np.ndarray, "cell cell"]:
    """Compliance between all cells of several indenters, on one face or on several."""
    constants = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    rows = []
    for a in spreads:
        row = []
        for b in spreads:
            if a is b:
                block = wide_block(a) + near_compliance(a.patches, spec)
            elif a.face.index == b.face.index:
                inner = a.face.wide_compliance[np.ix_(a.rows, b.rows)]
                near = normal_compliance(a.patches, b.patches, *constants)
                block = a.matrix.T @ inner @ b.matrix + near
            else:
                first, second = (response.face_loads(s.face.index).start for s in (a, b))
                inner = np.asarray(response.compliance[np.ix_(first + a.rows, second + b.rows)])
                block = a.matrix.T @ inner @ b.matrix
            row.append(block)
        rows.append(np.hstack(row))
    matrix = np.vstack(rows)
    return (matrix + matrix.T) / 2


def hat_patches(surface: FaceSurface) -> Patches:
    """Area, centroid and variance of the hat function of every vertex."""
    corner = surface.points_mm[surface.triangles]
    area = triangle_areas_mm2(surface)
    count = len(surface.xy_mm)
    weights, first, second = np.zeros(count), np.zeros((count, 3)), np.zeros(count)
    total, squares = corner.sum(axis=1), np.sum(corner**2, axis=(1, 2))
    for k in range(3):
        vertex = corner[:, k]
        np.add.at(weights, surface.triangles[:, k], area / 3)
        np.add.at(first, surface.triangles[:, k], area[:, None] / 12 * (total + vertex))
        # ∫ λ_k |x|² = A/60 (Σ_ab x_a·x_b (1 + δ_ab) + 2 vertex·Σ x + 2 vertex²), by ∫ λ_k λ_a λ_b
        moment = np.sum(total**2, axis=1) + squares + 2 * np.sum(vertex * (total + vertex), axis=1)
        np.add.at(second, surface.triangles[:, k], area / 60 * moment)
    centre = first / weights[:, None]
    return Patches(weights, centre, (second / weights - np.sum(centre**2, axis=1)) / 2, HAT_OWN)


def hat_narrowing(surface: FaceSurface) -> sp.csc_matrix:
    """2 − W⁻¹ M: keeps every force and its place, and takes back one smoothing by the hats."""
    corner = surface.triangles
    count = len(surface.xy_mm)
    area = triangle_areas_mm2(surface)
    values = area[:, None] * ((np.ones((3, 3)) + np.eye(3)) / 12).ravel()
    entries = (values.ravel(), (np.repeat(corner, 3, axis=1).ravel(), np.tile(corner, 3).ravel()))
    mass = sp.csc_matrix(entries, shape=(count, count))
    return sp.csc_matrix(
        2 * sp.eye(count) - sp.diags(1 / np.asarray(mass.sum(axis=1)).ravel()) @ mass
    )


def triangle_areas_mm2(surface: FaceSurface) -> Float[np.ndarray, "triangle"]:
    """Areas of a face's triangles."""
    a, b, c = (surface.points_mm[surface.triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def facet_shares(
    face: RefinedFace, points_mm: Float[np.ndarray, "n 3"]
) -> tuple[Int[np.ndarray, "n 3"], Float[np.ndarray, "n 3"]]:
    """Vertices and weights of points of a curved face, in its own triangles: seen from above those of a
    steep part are slivers, and others would join vertices far apart. Beyond the border the nearest edge's.
    """
    tree, shares = face.facets
    _, near = tree.query(points_mm, min(_NEAR_FACETS, len(shares)))
    first = face.surface.points_mm[face.surface.triangles[near, 0]]
    # n point, k triangle near it, e of two edges, c coordinate
    edge_share = np.einsum("nkec,nkc->nke", shares[near], points_mm[:, None] - first)
    share = np.concatenate([1 - edge_share.sum(axis=2, keepdims=True), edge_share], axis=2)
    best = share.min(axis=2).argmax(axis=1)
    share = np.take_along_axis(share, best[:, None, None], axis=1)[:, 0].clip(min=0)
    triangle = np.take_along_axis(np.asarray(near), best[:, None], axis=1)[:, 0]
    return face.surface.triangles[triangle], share / share.sum(axis=1, keepdims=True)


def barycentric(triangulation: Delaunay, xy_mm: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Three vertices around every point and their weights; beyond the border the nearest vertex."""
    simplex = triangulation.find_simplex(xy_mm)
    transform = triangulation.transform[simplex]
    # Barycentric coordinates by SciPy's affine maps: T⁻¹ (x − r); n point, i of two corners, j x
    # or y
    local = np.einsum("nij,nj->ni", transform[:, :2], xy_mm - transform[:, 2])
    share = np.column_stack([local, 1 - local.sum(axis=1)])
    vertices = triangulation.simplices[simplex].copy()
    outside = np.flatnonzero(simplex < 0)
    for point in outside:
        distance = np.linalg.norm(triangulation.points - xy_mm[point], axis=1)
        vertices[point], share[point] = int(np.argmin(distance)), [1.0, 0.0, 0.0]
    return vertices, share
