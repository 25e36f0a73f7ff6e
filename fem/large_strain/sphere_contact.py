"""Frictionless contact of a rigid sphere with a face that deforms largely.

The weak gap of a hat function φ_i is the volume between the deformed face and the sphere, seen
from its centre c and weighted by φ_i: with d = x − c and tangents a, b of the deformed face,
    gap_i = −∫ φ_i h(|d|) d·(a × b) dA,      h(r) = (1 − R³/r³)/3,
about ∫ φ_i (r − R) over the deformed area. Its pressures are true ones (per deformed area); for
small displacements all this becomes `contact.complementarity`. Measuring gaps over the undeformed area would
let nodes between those of φ slide together as soon as the pressure nears twice the shear modulus.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from skfem import ElementTetP1, ElementTetP2, FacetBasis, MeshTet

from design.body.surface_chart import FaceFrame
from fem.linear.sparse import columns_of

_QUADRATURE_ORDER = 6
"""Degree of polynomials that the quadrature over a facet integrates exactly."""
_LEVI_CIVITA = np.zeros((3, 3, 3))
for _i, _j, _k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    _LEVI_CIVITA[_i, _j, _k], _LEVI_CIVITA[_i, _k, _j] = 1.0, -1.0


@dataclass(frozen=True)
class ContactFace:
    """Quadrature of the part of a face that a sphere may touch, and its candidate pressures.

    `frame_mm` holds the place, then two unit tangents, undeformed; `shapes` are the displacement's
    shape functions, then their slopes along the tangents. `candidate` numbers the hats of a
    facet's element, −1 where none. `area_mm2` and `weights_mm2` (∫ φ_i dA) are undeformed.
    """

    normal: Float[np.ndarray, "3"]
    frame_mm: Float[np.ndarray, "facet q 3 3"]
    area_mm2: Float[np.ndarray, "facet q"]
    nodes: Int[np.ndarray, "facet 10"]
    shapes: Float[np.ndarray, "facet q 3 10"]
    candidate: Int[np.ndarray, "facet 4"]
    hats: Float[np.ndarray, "facet q 4"]
    node_count: int
    weights_mm2: Float[np.ndarray, "candidate"]


@dataclass(frozen=True)
class ContactState:
    """Weak gaps (mm³) and their gradient (candidate, 3·node) (mm²).

    `curvature` is the second derivative of the gap per area by the deformed `frame_mm`.
    """

    gap_mm3: Float[np.ndarray, "candidate"]
    gradient: sp.csr_matrix
    curvature: Float[np.ndarray, "facet q 9 9"]


def contact_face(
    mesh: MeshTet,
    facets: Int[np.ndarray, "facet"],
    vertices: Int[np.ndarray, "candidate"],
    frame: FaceFrame,
) -> ContactFace:
    """Quadrature over the flat boundary facets that touch any of the candidate vertices.

    The face counts as exactly flat, as in the linear model: a mesh that follows it to within some
    hundredths of a millimetre leaves no bumps.
    """
    number = np.full(mesh.nvertices, -1)
    number[vertices] = np.arange(len(vertices))
    facets = facets[(number[np.asarray(mesh.facets)[:, facets]] >= 0).any(axis=0)]
    quadratic = FacetBasis(mesh, ElementTetP2(), facets=facets, intorder=_QUADRATURE_ORDER)
    linear = FacetBasis(mesh, ElementTetP1(), facets=facets, intorder=_QUADRATURE_ORDER)
    hats = np.stack([np.asarray(f[0]) for f in linear.basis], axis=-1)
    candidate = number[linear.element_dofs.T]
    area = np.asarray(quadratic.dx)
    return ContactFace(
        frame.normal,
        _undeformed_frames(quadratic, frame),
        area,
        quadratic.element_dofs.T.copy(),
        _shapes_and_slopes(quadratic, frame),
        candidate,
        hats,
        int(quadratic.N),
        # f facet, q quadrature point, h hat (vertex): weights ∫ hat dA
        _scatter_hats(candidate, np.einsum("fqh,fq->fh", hats, area), len(vertices)),
    )


def contact_state(
    face: ContactFace,
    displacement_mm: Float[np.ndarray, "component_node"],
    sphere_centre_mm: Float[np.ndarray, "3"],
    radius_mm: float,
) -> ContactState:
    """Gaps of the deformed face to the sphere."""
    local = displacement_mm.reshape(3, -1)[:, face.nodes]
    # Place and two tangents (m) after the displacement of nodes a: f facet, q point, i coordinate
    deformed = face.frame_mm + np.einsum("fqma,ifa->fqmi", face.shapes, local)
    deformed[:, :, 0] -= sphere_centre_mm
    gap, slope, curvature = gap_per_area(deformed, radius_mm)
    tested = face.hats * face.area_mm2[..., None]
    # ∂(∫ hat_h gap)/∂u_ia by the chain rule through place and tangents m
    per_node = np.einsum("fqh,fqmi,fqma->ifha", tested, slope, face.shapes, optimize=True)
    return ContactState(
        _scatter_hats(face.candidate, np.einsum("fqh,fq->fh", tested, gap), len(face.weights_mm2)),
        _gradient_matrix(face, per_node),
        curvature,
    )


def contact_stiffness(
    face: ContactFace, state: ContactState, pressure_mpa: Float[np.ndarray, "candidate"]
) -> sp.csr_matrix:
    """Second derivative of −Σ p_i gap_i by the displacements (3·node, 3·node), N/mm."""
    scale = -_pressure_at_points(face, pressure_mpa) * face.area_mm2
    curvature = state.curvature.reshape(*scale.shape, 3, 3, 3, 3)
    # Same, twice: m, i and n, j are the two places or tangents and their coordinates, a and b nodes
    local = np.einsum(
        "fq,fqminj,fqma,fqnb->fiajb", scale, curvature, face.shapes, face.shapes, optimize=True
    )
    count = face.node_count
    dofs = (face.nodes[:, None, :] + count * np.arange(3)[:, None]).reshape(len(face.nodes), 30)
    rows, columns = np.repeat(dofs, 30, axis=1), np.tile(dofs, (1, 30))
    matrix = sp.csr_matrix(
        (local.ravel(), (rows.ravel(), columns.ravel())), shape=(3 * count, 3 * count)
    )
    matrix.eliminate_zeros()
    return matrix


def normal_force_n(
    face: ContactFace, state: ContactState, pressure_mpa: Float[np.ndarray, "candidate"]
) -> float:
    """Force of the sphere on the face, along the face's inward normal."""
    force = (state.gradient.T @ pressure_mpa).reshape(3, -1).sum(axis=1)
    return float(-force @ face.normal)


def _undeformed_frames(basis: FacetBasis, frame: FaceFrame) -> np.ndarray:
    points = np.moveaxis(np.asarray(basis.global_coordinates()), 0, -1)
    local = frame.from_object(points)
    local[..., 2] = 0
    place = frame.to_object(local)
    tangents = np.broadcast_to([frame.x, frame.y], (*place.shape[:2], 2, 3))
    return np.concatenate([place[:, :, None], tangents], axis=2)


def _shapes_and_slopes(basis: FacetBasis, frame: FaceFrame) -> np.ndarray:
    tangents = np.stack([frame.x, frame.y])
    functions = []
    for shape, *_ in basis.basis:
        # Slopes of shapes along the face's two tangents m: i coordinate, f facet, q quadrature point
        slopes = np.einsum("mi,ifq->fqm", tangents, np.asarray(shape.grad))
        functions.append(np.concatenate([np.asarray(shape)[..., None], slopes], axis=-1))
    return np.stack(functions, axis=-1)


def gap_per_area(
    deformed: np.ndarray, radius_mm: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """−h(|d|) det[d, a, b], with its first (3, 3) and second (9, 9) derivatives by (d, a, b)."""
    d, a, b = (deformed[:, :, k] for k in range(3))
    distance = np.linalg.norm(d, axis=-1)
    normal = d / distance[..., None]
    cubed = (radius_mm / distance) ** 3
    height = (1 - cubed) / 3
    # det[d, a, b] = d · (a × b): three times the volume between the sphere's centre and the facet, per area
    volume = np.einsum("fqi,fqi->fq", d, np.cross(a, b))
    volume_slope = np.stack([np.cross(a, b), np.cross(b, d), np.cross(d, a)], axis=2)
    height_slope = np.zeros_like(deformed)
    height_slope[:, :, 0] = (cubed / distance)[..., None] * normal
    slope = height[..., None, None] * volume_slope + volume[..., None, None] * height_slope
    flat = (*distance.shape, 9)
    # Product rule: second derivative of h · v with h = h(|d|) and v = det[d, a, b]
    mixed = np.einsum("fqm,fqn->fqmn", height_slope.reshape(flat), volume_slope.reshape(flat))
    curvature = mixed + np.swapaxes(mixed, 2, 3)
    curvature += height[..., None, None] * determinant_curvature(d, a, b)
    bend = np.eye(3) - 5 * np.einsum("fqi,fqj->fqij", normal, normal)
    curvature[:, :, :3, :3] += (volume * cubed / distance**2)[..., None, None] * bend
    return -height * volume, -slope, -curvature


def determinant_curvature(d: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Second derivative of det[d, a, b] by (d, a, b): ε_ijk of the third where two differ."""
    table = np.zeros((*d.shape[:2], 9, 9))
    for first, second, third in ((0, 1, b), (1, 2, d), (2, 0, a)):
        # ε_ijk of the third vector (k): ∂²det/∂(first)_i ∂(second)_j
        block = np.einsum("ijk,fqk->fqij", _LEVI_CIVITA, third)
        rows, columns = slice(3 * first, 3 * first + 3), slice(3 * second, 3 * second + 3)
        table[:, :, rows, columns] = block
        table[:, :, columns, rows] = np.swapaxes(block, 2, 3)
    return table


def _pressure_at_points(face: ContactFace, pressure_mpa: np.ndarray) -> np.ndarray:
    nodal = np.where(face.candidate >= 0, pressure_mpa[face.candidate], 0)
    # Pressure at quadrature points from its nodal values: h vertex of facet f
    return np.einsum("fqh,fh->fq", face.hats, nodal)


def _scatter_hats(candidate: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    has_candidate = candidate >= 0
    return np.bincount(candidate[has_candidate], values[has_candidate], count)


def _gradient_matrix(face: ContactFace, slope: np.ndarray) -> sp.csr_matrix:
    """(candidate, 3·node) from (component, facet, hat, node) of every facet."""
    has_candidate = face.candidate >= 0
    rows = np.repeat(face.candidate[has_candidate], 10)
    columns = np.repeat(face.nodes[:, None, :], 4, axis=1)[has_candidate].ravel()
    shape = (len(face.weights_mm2), face.node_count)
    blocks = [
        sp.csr_matrix((component[has_candidate].ravel(), (rows, columns)), shape=shape)
        for component in slope
    ]
    return columns_of(blocks)
