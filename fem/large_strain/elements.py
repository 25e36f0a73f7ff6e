"""Internal forces and tangent of a hyperelastic solid on Taylor–Hood tetrahedra.

Stationary point of ∫ W(F) − p (J − 1) − p²/(2λ) over u and p, F = 1 + ∇u in the undeformed body:
    ∫ (∂W/∂F − p J F⁻ᵀ):∇v,      −∫ q (J − 1) − (1/λ) ∫ p q.
At F = 1, p = 0 its second derivative is Herrmann's operator of `fem.linear.elements`.
Nodal vectors are ordered as there: all u_x, then all u_y, then all u_z.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int

from design.errors import SolverError
from fem.large_strain.hyperelastic import (
    Hyperelastic,
    first_piola_stress,
    inverse_transpose,
    tangent_modulus,
)
from fem.linear.assembly import UPPER_BLOCKS, NodePattern, node_pattern, vector_matrix
from fem.linear.elements import TaylorHood
from fem.linear.sparse import columns_of

_CHUNK = 2048
"""Elements whose tangents are made at once: it bounds the memory."""


class InvertedElementError(SolverError):
    """J ≤ 0 at some quadrature point."""


@dataclass(frozen=True)
class FiniteStrainElements:
    """Quantities that do not change while the body deforms, in the quadrature of `space`.

    `pressure_nodes` count from 0 over the pressure unknowns only.
    """

    gradients: Float[np.ndarray, "tet q 10 3"]
    hats: Float[np.ndarray, "q 4"]
    weights_mm3: Float[np.ndarray, "tet q"]
    nodes: Int[np.ndarray, "tet 10"]
    pressure_nodes: Int[np.ndarray, "tet 4"]
    pattern: NodePattern

    @property
    def node_count(self) -> int:
        return self.pattern.node_count

    @property
    def pressure_count(self) -> int:
        return int(self.pressure_nodes.max()) + 1


@dataclass(frozen=True)
class InternalForces:
    """`nodal_n` of the displacements (3·node) and `volume_mm3` of the pressures, at one state."""

    nodal_n: Float[np.ndarray, "component_node"]
    volume_mm3: Float[np.ndarray, "pressure"]


@dataclass(frozen=True)
class TangentBlocks:
    """Derivative of `InternalForces`: stiffness (3·node, 3·node), divergence (pressure, 3·node)."""

    stiffness: sp.csr_matrix
    divergence: sp.csr_matrix


def finite_strain_elements(space: TaylorHood) -> FiniteStrainElements:
    """Gradients, weights and the sparsity pattern of a Taylor–Hood space."""
    basis = space.displacement
    gradients = np.stack([np.moveaxis(np.asarray(f[0].grad), 0, -1) for f in basis.basis], axis=2)
    hats = np.stack([np.asarray(f[0])[0] for f in space.pressure.basis], axis=1)
    nodes = basis.element_dofs.T.copy()
    used = np.unique(space.pressure.element_dofs)
    pressure_nodes = np.searchsorted(used, space.pressure.element_dofs.T)
    return FiniteStrainElements(
        gradients,
        hats,
        np.asarray(basis.dx),
        nodes,
        pressure_nodes,
        node_pattern(nodes, space.node_count),
    )


def deformation_gradients(
    elements: FiniteStrainElements, displacement_mm: Float[np.ndarray, "component_node"]
) -> Float[np.ndarray, "tet q 3 3"]:
    """F = 1 + ∇u at the quadrature points.

    Raises
    ------
    InvertedElementError
        det F ≤ 0 somewhere.
    """
    local = displacement_mm.reshape(3, -1)[:, elements.nodes].transpose(1, 0, 2)
    deformation = np.eye(3) + local[:, None] @ elements.gradients
    smallest = float(np.linalg.det(deformation).min())
    if not smallest > 0:
        raise InvertedElementError(f"an element is turned inside out (smallest J {smallest:.2g})")
    return deformation


def internal_forces(
    elements: FiniteStrainElements,
    material: Hyperelastic,
    inverse_lambda_per_mpa: float,
    displacement_mm: Float[np.ndarray, "component_node"],
    pressure_mpa: Float[np.ndarray, "pressure"],
) -> InternalForces:
    """First derivatives of the potential by u and p.

    Raises
    ------
    InvertedElementError
        det F ≤ 0 somewhere.
    """
    deformation = deformation_gradients(elements, displacement_mm)
    volume_ratio = np.linalg.det(deformation)
    pressure = pressure_mpa[elements.pressure_nodes] @ elements.hats.T
    stress = first_piola_stress(material, deformation)
    stress -= (pressure * volume_ratio)[..., None, None] * inverse_transpose(deformation)
    stress *= elements.weights_mm3[..., None, None]
    # ∫ P_ij ∂N_a/∂X_j: e tet, q quadrature point, i and j coordinates, a node
    local = np.einsum("eqij,eqaj->eia", stress, elements.gradients)
    nodal = [_scatter(elements.nodes, local[:, i], elements.node_count) for i in range(3)]
    misfit = -elements.weights_mm3 * (volume_ratio - 1 + inverse_lambda_per_mpa * pressure)
    volume = _scatter(elements.pressure_nodes, misfit @ elements.hats, elements.pressure_count)
    return InternalForces(np.concatenate(nodal), volume)


def tangent_blocks(
    elements: FiniteStrainElements,
    material: Hyperelastic,
    displacement_mm: Float[np.ndarray, "component_node"],
    pressure_mpa: Float[np.ndarray, "pressure"],
) -> TangentBlocks:
    """Second derivatives of the potential by (u, u) and (p, u); those by (p, p) are constant.

    Raises
    ------
    InvertedElementError
        det F ≤ 0 somewhere.
    """
    deformation = deformation_gradients(elements, displacement_mm)
    blocks = np.zeros((len(UPPER_BLOCKS), len(elements.nodes), 100))
    divergence = np.zeros((3, len(elements.nodes), 40))
    for first in range(0, len(elements.nodes), _CHUNK):
        chunk = slice(first, first + _CHUNK)
        pressure = pressure_mpa[elements.pressure_nodes[chunk]] @ elements.hats.T
        part = _chunk_tangent(elements, material, chunk, deformation[chunk], pressure)
        blocks[:, chunk], divergence[:, chunk] = part
    return TangentBlocks(
        vector_matrix(elements.pattern, blocks), _pressure_rows(elements, divergence)
    )


def _chunk_tangent(
    elements: FiniteStrainElements,
    material: Hyperelastic,
    chunk: slice,
    deformation: np.ndarray,
    pressure: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Element matrices (block, tet, 10·10) and (component, tet, 4·10) of some elements."""
    gradients, weights = elements.gradients[chunk], elements.weights_mm3[chunk]
    cofactor = inverse_transpose(deformation)
    cofactor *= np.linalg.det(deformation)[..., None, None]
    modulus = tangent_modulus(material, deformation)
    modulus -= pressure_modulus(deformation, pressure)
    modulus *= weights[..., None, None, None, None]
    count, points = weights.shape
    rows = np.swapaxes(gradients.reshape(count, points, 10, 3), 2, 3)  # (tet, q, j, a)
    test_rows = rows.reshape(count, points * 3, 10).swapaxes(1, 2).copy()
    blocks = np.empty((len(UPPER_BLOCKS), count, 100))
    for block, (i, k) in enumerate(UPPER_BLOCKS):
        trial_rows = modulus[:, :, i, :, k, :] @ rows
        blocks[block] = (test_rows @ trial_rows.reshape(count, points * 3, 10)).reshape(count, 100)
    tested = -weights[..., None] * elements.hats  # (tet, q, hat)
    slopes = cofactor @ rows  # (tet, q, i, a)
    # −∫ ψ_c ∂J/∂u_ia, ∂J/∂F = cof F: e tet, q quadrature point, c pressure hat, i coordinate, a node
    divergence = np.einsum("eqc,eqia->ieca", tested, slopes, optimize=True)
    return blocks, divergence.reshape(3, count, 40)


def pressure_modulus(deformation: np.ndarray, pressure: np.ndarray) -> np.ndarray:
    """p ∂²J/∂F² = p J (F⁻ᵀ_ij F⁻ᵀ_kl − F⁻ᵀ_il F⁻ᵀ_kj): linear in F, entries ± p F or 0."""
    table = np.zeros((*deformation.shape, 3, 3))
    scaled = pressure[..., None, None] * deformation
    for i, k, m in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        for j, l, n in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            table[..., i, j, k, l] = table[..., k, l, i, j] = scaled[..., m, n]
            table[..., i, l, k, j] = table[..., k, j, i, l] = -scaled[..., m, n]
    return table


def _scatter(nodes: np.ndarray, values: np.ndarray, count: int) -> np.ndarray:
    return np.bincount(nodes.ravel(), values.ravel(), count)


def _pressure_rows(elements: FiniteStrainElements, divergence: np.ndarray) -> sp.csr_matrix:
    """(pressure, 3·node) from the element matrices of the three components."""
    rows = np.repeat(elements.pressure_nodes, 10, axis=1).ravel()
    columns = np.tile(elements.nodes, (1, 4)).ravel()
    shape = (elements.pressure_count, elements.node_count)
    return columns_of(
        [sp.csr_matrix((values.ravel(), (rows, columns)), shape=shape) for values in divergence]
    )
