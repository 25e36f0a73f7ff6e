"""Interface of silicone and rigid core, and motions prescribed there.

Bonded, the silicone follows the core. Frictionless, it slides along each flat wall and only the
normal displacement is held: two of the three along an edge between walls, all at a corner. Below
the core's end the cavity's walls are free, and so is the rim round the open face unless it is held.

A prescribed motion G s of the interface (s: its amplitudes) is lifted into the body, u = T q + G s:
    [[TᵀKT, TᵀBᵀ], [BT, −C]] (q, p) = (loads, 0) − (TᵀKG, BG) s,
and the forces conjugate to s, which the core exerts on the silicone, are Gᵀ(K u + Bᵀ p).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from skfem import FacetBasis, LinearForm

from design.layout.blocks import core_keys
from design.layout.body import body_of
from design.spec.object import ObjectSpec
from fem.linear.elements import DisplacementSpace, MixedOperators
from fem.linear.sparse import columns_of, rows_of, shape_of
from fem.mesh.surfaces import surface_tolerance_mm

WALLS = ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1))
"""The core's walls in the cavity: axis and sign of the outward normal."""


@dataclass(frozen=True)
class CoreContact:
    """Pressure and opening between a frictionless core and the silicone, at the walls' vertices.

    A vertex on an edge of the core counts once for each wall. `force_per_load` (i, load) is the
    core's force ∫ φ_i p dA (N, positive in compression) while nothing opens; `stiffness` (i, i) is
    the rise of these forces with openings g_i φ_i (N/mm). By reciprocity the openings move the
    loads by −`force_per_load`ᵀ g.
    """

    points_mm: Float[np.ndarray, "i 3"]
    normal: Float[np.ndarray, "i 3"]
    weights_mm2: Float[np.ndarray, "i"]
    force_per_load: Float[np.ndarray, "i load"]
    stiffness: Float[np.ndarray, "i i"]


@dataclass(frozen=True)
class CoreState:
    """Load (N) on the vertices of a frictionless core, and how far the shell has left them (mm)."""

    force_n: Float[np.ndarray, "i"]
    opening_mm: Float[np.ndarray, "i"]


@dataclass(frozen=True)
class WallOpenings:
    """Openings φ_i n of P1 hats at the vertices of the core's walls, as nodal displacements."""

    displacement: sp.csr_matrix
    vertices: Int[np.ndarray, "i"]
    normal: Float[np.ndarray, "i 3"]
    weights_mm2: Float[np.ndarray, "i"]


def held_components(
    nodes_mm: Float[np.ndarray, "node 3"], spec: ObjectSpec
) -> Bool[np.ndarray, "3 node"]:
    """Displacement components that the core holds, and the plate where the rim is held."""
    if spec.mechanics.interface == "bonded":
        held = np.tile(touches_core(nodes_mm, spec), (3, 1))
    else:
        held = np.zeros((3, len(nodes_mm)), bool)
        for axis, sign in WALLS:
            held[axis] |= nodes_on_wall(nodes_mm, axis, sign, spec)
    if spec.mechanics.slip.rim == "held":
        held |= nodes_on_rim(nodes_mm, spec)
    return held


def touches_core(
    nodes_mm: Float[np.ndarray, "node 3"], spec: ObjectSpec
) -> Bool[np.ndarray, "node"]:
    """Nodes where the core and its keys fill the cavity; the walls beyond it are free."""
    near = surface_tolerance_mm(spec)
    touching = body_of(spec).core_distance_mm(nodes_mm) < near
    for key in core_keys(spec):
        touching |= key.holds(nodes_mm, near)
    return touching


def nodes_on_wall(
    nodes_mm: Float[np.ndarray, "node 3"], axis: int, sign: int, spec: ObjectSpec
) -> Bool[np.ndarray, "node"]:
    """Nodes on one wall of the core, its edges included."""
    height = sign * nodes_mm[:, axis] - spec.core_size_mm[axis] / 2
    return touches_core(nodes_mm, spec) & (abs(height) < surface_tolerance_mm(spec))


def nodes_on_rim(
    nodes_mm: Float[np.ndarray, "node 3"], spec: ObjectSpec
) -> Bool[np.ndarray, "node"]:
    """Nodes of the flat ring round the open face."""
    height = nodes_mm[:, 2] + spec.body.size_mm[2] / 2
    return abs(height) < surface_tolerance_mm(spec)


def rigid_interface_motions(
    nodes_mm: Float[np.ndarray, "node 3"], spec: ObjectSpec
) -> sp.csr_matrix:
    """G of the core's rigid motions: three shifts, then rotations about the origin (3·node, 6)."""
    node = np.flatnonzero(touches_core(nodes_mm, spec))
    lifting = np.zeros((3, len(node), 6))
    for axis, unit in enumerate(np.eye(3)):
        lifting[axis, :, axis] = 1
        lifting[:, :, 3 + axis] = np.cross(unit, nodes_mm[node]).T
    rows = (np.arange(3)[:, None] * len(nodes_mm) + node).ravel()
    columns = np.tile(np.arange(6), len(rows))
    shape = (3 * len(nodes_mm), 6)
    return sp.csr_matrix((lifting.ravel(), (np.repeat(rows, 6), columns)), shape=shape)


def prescribed_loads(
    operators: MixedOperators,
    motion_basis: sp.csr_matrix,
    pressure_nodes: Int[np.ndarray, "p"],
    lifting: sp.csr_matrix,
) -> sp.csr_matrix:
    """−(TᵀKG, BG): what a prescribed motion G s puts on the right side, per unit of s."""
    forces = motion_basis.T @ (operators.stiffness @ lifting)
    volumes = operators.divergence[pressure_nodes] @ lifting
    return sp.csr_matrix(-rows_of([forces, volumes]))


def wall_openings(space: DisplacementSpace, spec: ObjectSpec) -> WallOpenings:
    """P1 openings of every wall of the core."""
    parts, vertices, normals, weights = [], [], [], []
    for axis, sign in WALLS:
        here = nodes_on_wall(space.nodes_mm, axis, sign, spec)
        hats, corners = vertex_hats(space, here)
        area = wall_areas_mm2(space, here)
        blocks = [sign * hats if a == axis else sp.csr_matrix(shape_of(hats)) for a in range(3)]
        parts.append(rows_of(blocks))
        vertices.append(corners)
        normals.append(np.tile(sign * np.eye(3)[axis], (len(corners), 1)))
        weights.append(hats.T @ area)
    return WallOpenings(
        columns_of(parts),
        np.concatenate(vertices),
        np.concatenate(normals),
        np.concatenate(weights),
    )


def vertex_hats(
    space: DisplacementSpace, here: Bool[np.ndarray, "node"]
) -> tuple[sp.csr_matrix, Int[np.ndarray, "vertex"]]:
    """Nodal values (node, vertex) of the P1 hats at the vertices of some walls, and the vertices."""
    count = len(space.mesh.p.T)
    vertices = np.flatnonzero(here[:count])
    column = np.full(count, -1)
    column[vertices] = np.arange(len(vertices))
    rows, columns, values = [vertices], [column[vertices]], [np.ones(len(vertices))]
    if space.node_count > count:  # midside nodes of quadratic elements follow the vertices
        ends = np.asarray(space.mesh.edges)
        for end in ends:
            edge = np.flatnonzero(here[count:] & here[ends[0]] & here[ends[1]])
            rows.append(count + edge)
            columns.append(column[end[edge]])
            values.append(np.full(len(edge), 0.5))
    entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return sp.csr_matrix(entries, shape=(space.node_count, len(vertices))), vertices


def wall_areas_mm2(
    space: DisplacementSpace, here: Bool[np.ndarray, "node"]
) -> Float[np.ndarray, "node"]:
    """Integral of every node's shape function over a wall."""
    return _value.assemble(_wall_facets(space, here))


def _wall_facets(space: DisplacementSpace, here: np.ndarray) -> FacetBasis:
    mesh = space.mesh
    boundary = mesh.boundary_facets()
    inside = here[np.asarray(mesh.facets)[:, boundary]].all(axis=0)
    return FacetBasis(mesh, space.displacement.elem, facets=boundary[inside], intorder=2)


@LinearForm
def _value(v, _):
    return v
