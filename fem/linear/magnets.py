"""Magnets in the silicone: rigid bodies tied to it.

A magnet's nodes move by u = c + ω × r; its six motions are unknowns of the system.
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from skfem import Basis

from fem.linear.elements import DisplacementSpace, free_motion_basis
from fem.linear.sparse import columns_of
from fem.mesh.tetrahedra import TetMesh

_LEVI_CIVITA = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
"""Even permutations of (x, y, z): the indices of a cross product."""


def rigid_motion_basis(
    nodes_mm: Float[np.ndarray, "node 3"],
    free: Bool[np.ndarray, "*component node"],
    owner: Int[np.ndarray, "node"],
    centres_mm: Float[np.ndarray, "magnet 3"],
) -> sp.csr_matrix:
    """T with u = T q: displacements of the free nodes, then (c, ω) of each magnet.

    `owner` is the magnet that a node belongs to, negative where none. Shape (3·node, unknown).
    """
    count = len(nodes_mm)
    rows, columns, values = [], [], []
    for magnet, centre in enumerate(centres_mm):
        node = np.flatnonzero(owner == magnet)
        arm = (nodes_mm[node] - centre).T
        first = 6 * magnet
        for i, j, k in _LEVI_CIVITA:  # u_i = c_i + ω_j r_k − ω_k r_j
            for column, value in ((i, np.ones(len(node))), (3 + j, arm[k]), (3 + k, -arm[j])):
                rows.append(i * count + node)
                columns.append(np.full(len(node), first + column))
                values.append(value)
    rigid = sp.csr_matrix(
        (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
        shape=(3 * count, 6 * len(centres_mm)),
    )
    return columns_of([free_motion_basis(free), rigid])


def magnet_of_nodes(mesh: TetMesh, space: DisplacementSpace) -> Int[np.ndarray, "node"]:
    """The magnet that each node belongs to (its surface included), −1 for none."""
    all_dofs = Basis(space.mesh, space.displacement.elem, intorder=1).element_dofs
    owner = np.full(space.node_count, -1)
    for magnet in range(mesh.magnets):
        owner[np.unique(all_dofs[:, mesh.magnet == magnet])] = magnet
    return owner
