"""Linear elasticity on tetrahedra, nearly incompressible or not: four elements, one form.

Taylor–Hood (P2 displacement, P1 pressure): find u, p with, for all v, q,
    ∫ 2μ ε(u):ε(v) − ∫ p div v = ∫ f·v,      −∫ q div u − (1/λ) ∫ p q = 0,
so that p = −λ div u (Herrmann, AIAA J. 3 (1965) 1896). Stable up to ν = 0.5.

P2/P0 takes a constant pressure in each element, which leaves the equations at once:
    ∫ 2μ ε(u):ε(v) + λ Σ_e |e| mean(div u) mean(div v) = ∫ f·v,
symmetric positive definite, a little too soft. P1 is the same form on linear tetrahedra, whose
divergence is constant anyway: the plain linear element, which locks (−49 % compliance at ν = 0.49
on the paper's shell) and is there for teaching. P2 takes λ ∫ div u div v as it is: for foams and
lattices, down to ν = −1, where 1/λ of the mixed form has no value (ν = 0) or the wrong sign.

Displacement unknowns are ordered by component: all u_x, then all u_y, then all u_z.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal, cast

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from skfem import Basis, ElementTetP1, ElementTetP2, MeshTet

from fem.linear.assembly import (
    AffineElements,
    affine_elements,
    elastic_blocks,
    node_pattern,
    pressure_blocks,
    reference_shapes,
    vector_matrix,
)
from fem.linear.material import LameConstants
from fem.linear.sparse import block_matrix, columns_of

ElementName = Literal["taylor-hood", "p2-p0", "p2"]


@dataclass(frozen=True)
class DisplacementSpace:
    """Scalar Lagrange basis of a displacement component on the silicone; no pressure unknowns.

    With `mean_divergence` an element resists the mean of its divergence alone.
    """

    displacement: Basis
    mean_divergence: bool = field(default=True, kw_only=True)

    @property
    def mesh(self) -> MeshTet:
        """The whole mesh, elements outside the silicone included."""
        return cast(MeshTet, self.displacement.mesh)

    @property
    def node_count(self) -> int:
        """Number of nodes of the whole mesh, with the nodes that no silicone element touches."""
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
        """Vertices that carry a pressure unknown."""
        return np.zeros(0, np.int32)


@dataclass(frozen=True)
class TaylorHood(DisplacementSpace):
    """P2 displacement with a P1 basis of the pressure."""

    pressure: Basis

    @property
    def pressure_nodes(self) -> Int[np.ndarray, "pressure"]:
        return np.unique(self.pressure.element_dofs)


@dataclass(frozen=True)
class MixedOperators:
    """K, B = −∫ q div v and C = (1/λ) ∫ p q on all nodes (unconstrained).

    K = ∫ 2μ ε:ε, with the term in λ where there is no pressure; B and C then have no rows.
    """

    stiffness: sp.csr_matrix
    divergence: sp.csr_matrix
    compressibility: sp.csr_matrix


def element_space(
    mesh: MeshTet, name: ElementName, elements: Int[np.ndarray, "tet"] | None = None
) -> DisplacementSpace:
    """The space of a named element on the given elements (all by default)."""
    if name == "taylor-hood":
        return taylor_hood(mesh, elements)
    basis = Basis(mesh, ElementTetP2(), elements=elements, intorder=2)
    return DisplacementSpace(basis, mean_divergence=name != "p2")


def taylor_hood(mesh: MeshTet, elements: Int[np.ndarray, "tet"] | None = None) -> TaylorHood:
    """Bases on the given elements (all by default)."""
    return TaylorHood(
        Basis(mesh, ElementTetP2(), elements=elements, intorder=2),
        Basis(mesh, ElementTetP1(), elements=elements, intorder=2),
    )


def assemble(
    space: DisplacementSpace,
    material: LameConstants,
    stiffness_ratio: Float[np.ndarray, "tet"] | None = None,
) -> MixedOperators:
    """Assemble the three operators; `stiffness_ratio` multiplies the constants of every element.

    Raises
    ------
    ValueError
        An element without pressure unknowns and an incompressible material (1/λ = 0), or one with
        them and a ratio.
    """
    mu, kappa = material.shear_modulus_mpa, material.inverse_lambda_per_mpa
    elements = affine_elements(space.displacement)
    if stiffness_ratio is not None:
        if isinstance(space, TaylorHood):
            raise ValueError(
                "a continuous pressure cannot jump between materials. Take P2/P0 or P2"
            )
        # integrals of stress are linear in both constants: an element of r times the modulus weighs
        # as one of r times the volume
        elements = replace(elements, volumes_mm3=stiffness_ratio * elements.volumes_mm3)
    if isinstance(space, TaylorHood):
        stiffness = _stiffness(space, elements, mu, 0.0)
        return MixedOperators(
            stiffness, _divergence(space, elements), kappa * mass_matrix(space, elements)
        )
    if kappa == 0:
        raise ValueError(
            "an element without pressure unknowns cannot be incompressible (1/λ = 0). Take "
            "Taylor–Hood, or a Poisson ratio of at most 0.4999"
        )
    none = sp.csr_matrix((0, 3 * space.node_count))
    return MixedOperators(_stiffness(space, elements, mu, 1 / kappa), none, sp.csr_matrix((0, 0)))


def saddle_point_matrix(
    operators: MixedOperators, motion_basis: sp.csr_matrix, pressure_nodes: Int[np.ndarray, "p"]
) -> sp.csr_matrix:
    """[[TᵀKT, TᵀBᵀ], [BT, −C]] with nodal displacements u = T q; TᵀKT alone without pressures.

    Symmetric with exactly one negative eigenvalue per pressure unknown.
    """
    leading = _unit_columns(motion_basis)
    rest = sp.csr_matrix(motion_basis[:, len(leading) :])
    beside = sp.csr_matrix(rest.T.tocsr() @ operators.stiffness)
    tied = beside[:, leading]
    divergence = operators.divergence[pressure_nodes]
    free, mixed = divergence[:, leading], sp.csr_matrix(divergence @ rest)
    compressibility = operators.compressibility[pressure_nodes][:, pressure_nodes]
    return block_matrix(
        [
            [operators.stiffness[leading][:, leading], tied.T.tocsr(), free.T.tocsr()],
            [tied, sp.csr_matrix(beside @ rest), mixed.T.tocsr()],
            [free, mixed, -compressibility],
        ]
    )


def _unit_columns(motion_basis: sp.csr_matrix) -> Int[np.ndarray, "unit"]:
    """Rows that the first columns single out: those of K are picked, which takes a sixth of a product."""
    columns = motion_basis.tocsc()
    single = np.diff(columns.indptr) == 1
    single[single] = columns.data[columns.indptr[:-1][single]] == 1
    count = len(single) if single.all() else int(np.argmin(single))
    return columns.indices[:count]


def free_motion_basis(free: Bool[np.ndarray, "*component node"]) -> sp.csr_matrix:
    """T that leaves free displacements and holds all others at zero.

    `free` (node,) stands for all three components of a node; (3, node) is one row for each.
    """
    selections = []
    for row in np.broadcast_to(free, (3, free.shape[-1])):
        nodes = np.flatnonzero(row)
        entries = (np.ones(len(nodes)), (nodes, np.arange(len(nodes))))
        selections.append(sp.csr_matrix(entries, shape=(len(row), len(nodes))))
    return sp.csr_matrix(sp.block_diag(selections))


def _stiffness(
    space: DisplacementSpace, elements: AffineElements, shear_modulus: float, lame_lambda: float
) -> sp.csr_matrix:
    basis = space.displacement
    shapes, mean = reference_shapes(basis.elem), space.mean_divergence
    blocks = elastic_blocks(elements, shapes, shear_modulus, lame_lambda, mean)
    return vector_matrix(node_pattern(basis.element_dofs.T, space.node_count), blocks)


def _divergence(space: TaylorHood, elements: AffineElements) -> sp.csr_matrix:
    blocks = pressure_blocks(elements, space.displacement.elem, space.pressure.elem)
    nodes, tested = space.displacement.element_dofs.T, space.pressure.element_dofs.T
    rows = np.repeat(tested, nodes.shape[1], axis=1).ravel()
    columns = np.tile(nodes, (1, tested.shape[1])).ravel()
    shape = (int(space.pressure.N), space.node_count)
    return columns_of([sp.csr_matrix((b.ravel(), (rows, columns)), shape=shape) for b in blocks])


def mass_matrix(space: TaylorHood, elements: AffineElements) -> sp.csr_matrix:
    """∫ p q of P1 functions: |e| (1 + δ)/20."""
    nodes = space.pressure.element_dofs.T
    local = (np.ones((4, 4)) + np.eye(4)).ravel() / 20
    values = np.outer(elements.volumes_mm3, local).ravel()
    rows, columns = np.repeat(nodes, 4, axis=1).ravel(), np.tile(nodes, (1, 4)).ravel()
    shape = (int(space.pressure.N), int(space.pressure.N))
    return sp.csr_matrix((values, (rows, columns)), shape=shape)
