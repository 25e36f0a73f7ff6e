"""Response of a shell to displacements of its inner walls, as one dense matrix.

The bonded system is condensed once more: every vertex of the core's walls is displaced along x, y
and z as a P1 hat (`fem.linear.core_interface`). With pressures p of the loads and displacements u,
    motions of the loads = C p − Fᵀ u,      forces of the core on the silicone r = F p + K u.
C is the bonded response, so that u = 0 gives exactly the bonded object.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int

from design.errors import InputError
from design.layout.blocks import core_keys
from design.layout.body import body_of
from design.spec.object import ObjectSpec
from fem.linear.core_interface import (
    WALLS,
    nodes_on_wall,
    prescribed_loads,
    touches_core,
    vertex_hats,
    wall_areas_mm2,
)
from fem.linear.elements import DisplacementSpace
from fem.linear.factorization import compliance_of_loads
from fem.linear.response import ResponseOperator, elastic_system, require_inertia, system_loads
from fem.linear.sparse import columns_of, shape_of
from fem.mesh.tetrahedra import TetMesh


@dataclass(frozen=True)
class CoreWalls:
    """Where the core can touch the shell: one site for each vertex of the walls and each wall there.

    `vertex` is the site's row in `points_mm`, `normal` points out of the core, `weights_mm2` is
    ∫ φ dA on the wall.
    """

    points_mm: Float[np.ndarray, "vertex 3"]
    vertex: Int[np.ndarray, "site"]
    normal: Float[np.ndarray, "site 3"]
    weights_mm2: Float[np.ndarray, "site"]

    @property
    def outward(self) -> Float[np.ndarray, "site 3"]:
        """By how much every site moves when all walls do by 1 along their normals: along an edge of
        the core by both."""
        total = np.zeros_like(self.points_mm)
        np.add.at(total, self.vertex, self.normal)
        return total[self.vertex]


@dataclass(frozen=True)
class LooseShell:
    """The bonded response and what displaced inner walls add; unknowns run x, y, z of each vertex.

    `force_per_load` (unknown, load) is F, N per MPa at a face's vertex; `stiffness` is K, N/mm.
    """

    bonded: ResponseOperator
    walls: CoreWalls
    force_per_load: Float[np.ndarray, "unknown load"]
    stiffness: Float[np.ndarray, "unknown unknown"]


def loose_shell(mesh: TetMesh, spec: ObjectSpec) -> LooseShell:
    """Assemble, hold on the core, factor once and condense onto loads and inner walls.

    Raises
    ------
    InputError
        A core that is no box, or has keys.
    SingularSystemError
        The matrix could not be factored.
    """
    require_plain_core(spec)
    bonded = spec.changed(mechanics={"interface": "bonded"})
    system = elastic_system(mesh, bonded)
    surfaces, loads = system_loads(mesh, system, bonded)
    walls, lifting = _core_walls(system.space, bonded)
    operators, pressure_nodes = system.operators, system.space.pressure_nodes
    prescribed = prescribed_loads(operators, system.motion_basis, pressure_nodes, lifting)
    condensed = compliance_of_loads(system.matrix, columns_of([loads, prescribed]))
    unknowns, motions = shape_of(system.matrix)[0], shape_of(system.motion_basis)[1]
    require_inertia(condensed.negative_pivots, unknowns - motions)
    count, matrix = shape_of(loads)[1], condensed.matrix
    stiffness = (lifting.T @ (operators.stiffness @ lifting)).toarray() - matrix[count:, count:]
    compliance = np.ascontiguousarray(matrix[:count, :count])
    response = ResponseOperator(surfaces, compliance, unknowns, condensed.negative_pivots)
    return LooseShell(response, walls, -matrix[count:, :count], (stiffness + stiffness.T) / 2)


def require_plain_core(spec: ObjectSpec) -> None:
    """Raise InputError where the core is more than a box in its cavity."""
    if not body_of(spec).cuboid or core_keys(spec):
        raise InputError(
            "a core that is pushed in is known as a plain box; this one has keys or belongs to a "
            f"body of kind {spec.body.kind!r}. Leave core.keys out, or keep the bonded core"
        )


def _core_walls(space: DisplacementSpace, spec: ObjectSpec) -> tuple[CoreWalls, sp.csr_matrix]:
    """Sites, and the nodal displacements (3·node, 3·vertex) of P1 hats at their vertices."""
    hats, vertices = vertex_hats(space, touches_core(space.nodes_mm, spec))
    row = np.full(space.node_count, -1)
    row[vertices] = np.arange(len(vertices))
    vertex, normal, weights = [], [], []
    for axis, sign in WALLS:
        here = nodes_on_wall(space.nodes_mm, axis, sign, spec)
        of_wall, corners = vertex_hats(space, here)
        vertex.append(row[corners])
        normal.append(np.tile(sign * np.eye(3)[axis], (len(corners), 1)))
        weights.append(of_wall.T @ wall_areas_mm2(space, here))
    walls = CoreWalls(
        space.nodes_mm[vertices],
        np.concatenate(vertex),
        np.concatenate(normal),
        np.concatenate(weights),
    )
    lifting = sp.csr_matrix(
        sp.kron(sp.eye(3), hats)
    )  # by component; columns to x, y, z of a vertex
    order = np.arange(3 * len(vertices)).reshape(3, -1).T.ravel()
    return walls, sp.csr_matrix(lifting[:, order])
