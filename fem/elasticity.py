"""Herrmann's mixed elasticity on Taylor–Hood tetrahedra (P2 displacement, P1 pressure).

Find u, p with, for all v, q,
    ∫ 2μ ε(u):ε(v) − ∫ p div v = ∫ f·v,      −∫ q div u − (1/λ) ∫ p q = 0,
so that p = −λ div u (Herrmann, AIAA J. 3 (1965) 1896). Stable up to ν = 0.5; plain linear
elements lock (−49 % compliance at ν = 0.49 on the paper's shell).

Displacement unknowns are ordered by component: all u_x, then all u_y, then all u_z.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from skfem import Basis, BilinearForm, ElementTetP1, ElementTetP2, MeshTet

from fem.material import LameConstants
from fem.sparse import block_matrix, columns_of


@dataclass(frozen=True)
class TaylorHood:
    """Scalar P2 basis of a displacement component and P1 basis of the pressure, on the silicone."""

    displacement: Basis
    pressure: Basis

    @property
    def node_count(self) -> int:
        """Nodes of the whole mesh, those that no silicone element touches included."""
        return int(self.displacement.N)

    @property
    def nodes_mm(self) -> Float[np.ndarray, "node 3"]:
        return self.displacement.doflocs.T

    @property
    def elastic_nodes(self) -> Bool[np.ndarray, "node"]:
        """Nodes that some silicone element touches."""
        touched = np.zeros(self.node_count, bool)
        touched[np.unique(self.displacement.element_dofs)] = True
        return touched

    @property
    def pressure_nodes(self) -> Int[np.ndarray, "pressure"]:
        return np.unique(self.pressure.element_dofs)


@dataclass(frozen=True)
class MixedOperators:
    """K = ∫ 2μ ε:ε, B = −∫ q div v, C = (1/λ) ∫ p q on all nodes (unconstrained)."""

    stiffness: sp.csr_matrix
    divergence: sp.csr_matrix
    compressibility: sp.csr_matrix


def taylor_hood(mesh: MeshTet, elements: Int[np.ndarray, "tet"] | None = None) -> TaylorHood:
    """Bases on the given elements (all by default)."""
    return TaylorHood(
        Basis(mesh, ElementTetP2(), elements=elements, intorder=2),
        Basis(mesh, ElementTetP1(), elements=elements, intorder=2),
    )


def assemble(space: TaylorHood, material: LameConstants) -> MixedOperators:
    """Assemble the three operators.

    2 ε(u):ε(v) = ∇u:∇v + ∇uᵀ:∇v is built from the six scalar forms ∫ ∂_a u ∂_b v (a ≤ b), which
    costs a third of assembling the vector element.
    """
    gradient = {}
    for a in range(3):
        for b in range(a, 3):
            gradient[a, b] = _gradient_product(a, b).assemble(space.displacement)
            gradient[b, a] = gradient[a, b].T
    laplacian = gradient[0, 0] + gradient[1, 1] + gradient[2, 2]
    blocks = [
        [gradient[i, j] + laplacian if i == j else gradient[i, j] for j in range(3)]
        for i in range(3)
    ]
    divergence = columns_of(
        [_divergence(a).assemble(space.displacement, space.pressure) for a in range(3)]
    )
    mass = _mass.assemble(space.pressure)
    return MixedOperators(
        material.shear_modulus_mpa * block_matrix(blocks),
        divergence,
        sp.csr_matrix(material.inverse_lambda_per_mpa * mass),
    )


def saddle_point_matrix(
    operators: MixedOperators, motion_basis: sp.csr_matrix, pressure_nodes: Int[np.ndarray, "p"]
) -> sp.csr_matrix:
    """[[TᵀKT, TᵀBᵀ], [BT, −C]] with nodal displacements u = T q.

    Symmetric indefinite with exactly one negative eigenvalue per pressure unknown.
    """
    t = motion_basis
    stiffness = t.T @ operators.stiffness @ t
    divergence = operators.divergence[pressure_nodes] @ t
    compressibility = operators.compressibility[pressure_nodes][:, pressure_nodes]
    return block_matrix([[stiffness, divergence.T], [divergence, -compressibility]])


def free_motion_basis(free: Bool[np.ndarray, "node"]) -> sp.csr_matrix:
    """T that leaves the three displacements of the free nodes and holds all others at zero."""
    nodes = np.flatnonzero(free)
    selection = sp.csr_matrix(
        (np.ones(len(nodes)), (nodes, np.arange(len(nodes)))), shape=(len(free), len(nodes))
    )
    return sp.csr_matrix(sp.block_diag([selection] * 3))


def _gradient_product(a: int, b: int) -> BilinearForm:
    return BilinearForm(lambda u, v, _: u.grad[a] * v.grad[b])


def _divergence(a: int) -> BilinearForm:
    return BilinearForm(lambda u, q, _: -u.grad[a] * q)


@BilinearForm
def _mass(p, q, _):
    return p * q
