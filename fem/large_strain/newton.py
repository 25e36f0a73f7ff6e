"""Newton's method for a sphere pressed into a hyperelastic body with rigid magnets.

Every iteration solves the linearized problem with its contact conditions exactly (a linear
complementarity problem on the condensed compliance of the face), so pressures stay ≥ 0 and no
penalty enters. Rigid magnets turn by finite rotations, R ← exp(δω) R; the tangent holds the second
derivative of that motion, which leaves it symmetric.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int
from scipy.spatial.transform import Rotation

from design.errors import SolverError
from fem.contact.complementarity import complementary_pressures
from fem.large_strain.elements import (
    FiniteStrainElements,
    InternalForces,
    InvertedElementError,
    deformation_gradients,
    internal_forces,
    tangent_blocks,
)
from fem.large_strain.hyperelastic import Hyperelastic
from fem.large_strain.sphere_contact import (
    ContactFace,
    ContactState,
    contact_state,
    contact_stiffness,
)
from fem.linear.elements import MixedOperators, free_motion_basis, saddle_point_matrix
from fem.linear.factorization import SingularSystemError, solve_symmetric
from fem.linear.magnets import rigid_motion_basis
from fem.linear.sparse import shape_of

MAX_ITERATIONS = 12
"""Newton iterations of a step; without equilibrium by then the step is shortened."""
_MAX_HALVINGS = 5
"""Halvings of a Newton step that turns elements inside out, at most."""
_TOLERANCE = 1e-6
"""Relative residual of an equilibrium."""


class StepDivergedError(SolverError):
    """Newton's method found no equilibrium at this depth from this start."""


@dataclass(frozen=True)
class PressProblem:
    """A body, its material and the part of a face that a sphere may touch.

    `owner` is the rigid magnet of a node, −1 where none; `free` excludes nodes of magnets.
    """

    elements: FiniteStrainElements
    material: Hyperelastic
    inverse_lambda_per_mpa: float
    compressibility: sp.csr_matrix
    nodes_mm: Float[np.ndarray, "node 3"]
    free: Bool[np.ndarray, "node"]
    owner: Int[np.ndarray, "node"]
    magnet_centres_mm: Float[np.ndarray, "magnet 3"]
    face: ContactFace
    radius_mm: float

    @property
    def arms_mm(self) -> Float[np.ndarray, "rigid 3"]:
        """Nodes of the magnets, from their magnet's centre, undeformed."""
        rigid = self.owner >= 0
        return self.nodes_mm[rigid] - self.magnet_centres_mm[self.owner[rigid]]


@dataclass(frozen=True)
class PressState:
    """Displacements (3·node), pressures, magnets' shifts and rotation matrices, contact pressures."""

    displacement_mm: Float[np.ndarray, "component_node"]
    pressure_mpa: Float[np.ndarray, "pressure"]
    shift_mm: Float[np.ndarray, "magnet 3"]
    rotation: Float[np.ndarray, "magnet 3 3"]
    contact_mpa: Float[np.ndarray, "candidate"]


@dataclass(frozen=True)
class _Forces:
    """First derivatives at a state: inside the body, and at the contact."""

    basis: sp.csr_matrix
    internal: InternalForces
    contact: ContactState
    gradient: sp.csr_matrix


def undeformed(problem: PressProblem) -> PressState:
    """The body at rest."""
    magnets = len(problem.magnet_centres_mm)
    return PressState(
        np.zeros(3 * problem.elements.node_count),
        np.zeros(problem.elements.pressure_count),
        np.zeros((magnets, 3)),
        np.tile(np.eye(3), (magnets, 1, 1)),
        np.zeros(len(problem.face.weights_mm2)),
    )


def equilibrium(
    problem: PressProblem, start: PressState, sphere_centre_mm: Float[np.ndarray, "3"]
) -> PressState:
    """Equilibrium with the sphere at a place, from a nearby one.

    Raises
    ------
    StepDivergedError
        None was found within the allowed iterations, or the tangent is singular.
    """
    state = start
    for _ in range(MAX_ITERATIONS):
        forces = forces_of(problem, state, sphere_centre_mm)
        if newton_misfit(problem, state, forces) < 1:
            return state
        try:
            state = _newton_step(problem, state, forces)
        except (SingularSystemError, np.linalg.LinAlgError) as error:
            raise StepDivergedError(f"the tangent is singular ({error})") from error
    raise StepDivergedError(f"no equilibrium after {MAX_ITERATIONS} iterations")


def motion_basis(problem: PressProblem, rotation: Float[np.ndarray, "magnet 3 3"]) -> sp.csr_matrix:
    """δu = T δq at these rotations: free nodes, then (δc, δω) of every magnet."""
    if not len(rotation):
        return free_motion_basis(problem.free)
    rigid = problem.owner >= 0
    nodes = problem.nodes_mm.copy()
    nodes[rigid] = problem.magnet_centres_mm[problem.owner[rigid]] + _turned(problem, rotation)
    return rigid_motion_basis(nodes, problem.free, problem.owner, problem.magnet_centres_mm)


def residual(
    problem: PressProblem, state: PressState, sphere_centre_mm: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "unknown"]:
    """Forces and moments that are not balanced (N, N·mm), then volumes not kept (mm³)."""
    forces = forces_of(problem, state, sphere_centre_mm)
    unbalanced = forces.basis.T @ forces.internal.nodal_n - forces.gradient.T @ state.contact_mpa
    return np.concatenate([unbalanced, forces.internal.volume_mm3])


def advanced(
    problem: PressProblem,
    state: PressState,
    basis: sp.csr_matrix,
    step: Float[np.ndarray, "unknown"],
    contact_mpa: Float[np.ndarray, "candidate"],
) -> PressState:
    """The state after a step of (q, p): magnets turn by the rotation exp(δω), not its linear part."""
    count, magnets = shape_of(basis)[1], len(state.shift_mm)
    motion = step[count - 6 * magnets : count].reshape(magnets, 6)
    shift = state.shift_mm + motion[:, :3]
    rotation = state.rotation
    if magnets:
        rotation = Rotation.from_rotvec(motion[:, 3:]).as_matrix() @ state.rotation
    displacement = (state.displacement_mm + basis @ step[:count]).reshape(3, -1)
    rigid = problem.owner >= 0
    turned = _turned(problem, rotation) - problem.arms_mm
    displacement[:, rigid] = (shift[problem.owner[rigid]] + turned).T
    return PressState(
        displacement.ravel(), state.pressure_mpa + step[count:], shift, rotation, contact_mpa
    )


def _turned(problem: PressProblem, rotation: np.ndarray) -> np.ndarray:
    """Arms of the magnets' nodes after rotation."""
    owner = problem.owner[problem.owner >= 0]
    # n node, j coordinate at rest, i coordinate after the rotation of its magnet
    return np.einsum("nij,nj->ni", rotation[owner], problem.arms_mm)


def forces_of(problem: PressProblem, state: PressState, sphere_centre_mm: np.ndarray) -> _Forces:
    basis = motion_basis(problem, state.rotation)
    internal = internal_forces(
        problem.elements,
        problem.material,
        problem.inverse_lambda_per_mpa,
        state.displacement_mm,
        state.pressure_mpa,
    )
    contact = contact_state(
        problem.face, state.displacement_mm, sphere_centre_mm, problem.radius_mm
    )
    return _Forces(basis, internal, contact, sp.csr_matrix(contact.gradient @ basis))


def newton_misfit(problem: PressProblem, state: PressState, forces: _Forces) -> float:
    """Largest violation of equilibrium, volume and contact, in units of what is allowed."""
    applied = forces.gradient.T @ state.contact_mpa
    unbalanced = abs(forces.basis.T @ forces.internal.nodal_n - applied).max()
    hat_volume = np.asarray(problem.compressibility.sum(axis=1)).ravel()
    hat_volume = hat_volume / problem.inverse_lambda_per_mpa
    sunk = forces.contact.gap_mm3 / problem.face.weights_mm2 / problem.radius_mm
    pressed = state.contact_mpa / problem.material.shear_modulus_mpa
    parts = (
        unbalanced / max(abs(applied).max(), np.finfo(float).tiny),
        (abs(forces.internal.volume_mm3) / hat_volume).max(),
        abs(np.minimum(sunk, pressed)).max(),
    )
    return max(parts) / _TOLERANCE


def _newton_step(problem: PressProblem, state: PressState, forces: _Forces) -> PressState:
    # One factorization answers the forces out of balance (column 0) and a unit pressure at every
    # candidate of contact (the others). Gaps are then linear in the pressures p: C p + gap, with C
    # the surface compliance of the tangent, and the complementary p belongs to this very step.
    matrix = tangent_matrix(problem, state, forces)
    motions = shape_of(forces.basis)[1]
    loads = np.zeros((shape_of(matrix)[0], 1 + len(state.contact_mpa)))
    loads[:motions, 0] = -(forces.basis.T @ forces.internal.nodal_n)
    loads[motions:, 0] = -forces.internal.volume_mm3
    loads[:motions, 1:] = forces.gradient.T.toarray()
    solution = solve_symmetric(matrix, loads)
    moved = forces.gradient @ solution[:motions]
    contact = complementary_pressures(
        (moved[:, 1:] + moved[:, 1:].T) / 2,
        forces.contact.gap_mm3 + moved[:, 0],
        state.contact_mpa > 0,
    )
    step = solution[:, 0] + solution[:, 1:] @ contact
    return _damped(problem, state, forces.basis, step, contact)


def _damped(
    problem: PressProblem,
    state: PressState,
    basis: sp.csr_matrix,
    step: np.ndarray,
    contact: np.ndarray,
) -> PressState:
    """The full step, or the longest half, quarter … that turns no element inside out."""
    for halving in range(_MAX_HALVINGS + 1):
        part = 0.5**halving
        pressures = state.contact_mpa + part * (contact - state.contact_mpa)
        trial = advanced(problem, state, basis, part * step, pressures)
        try:
            deformation_gradients(problem.elements, trial.displacement_mm)
        except InvertedElementError:
            continue
        return trial
    raise StepDivergedError("elements turn inside out")


def tangent_matrix(problem: PressProblem, state: PressState, forces: _Forces) -> sp.csr_matrix:
    blocks = tangent_blocks(
        problem.elements, problem.material, state.displacement_mm, state.pressure_mpa
    )
    stiffness = blocks.stiffness
    if state.contact_mpa.any():
        stiffness = stiffness + contact_stiffness(problem.face, forces.contact, state.contact_mpa)
    operators = MixedOperators(stiffness, blocks.divergence, problem.compressibility)
    pressures = np.arange(problem.elements.pressure_count)
    matrix = saddle_point_matrix(operators, forces.basis, pressures)
    if len(state.rotation):
        first = shape_of(forces.basis)[1] - 6 * len(state.rotation)
        size = shape_of(matrix)[0]
        matrix = matrix + _rotation_stiffness(problem, state, forces, first, size)
    return matrix


def _rotation_stiffness(
    problem: PressProblem, state: PressState, forces: _Forces, first: int, size: int
) -> sp.csr_matrix:
    """Σ ½(a fᵀ + f aᵀ) − (a·f) 1 on each magnet's rotation: f ·d²u of nodes at turned arms a."""
    rigid = problem.owner >= 0
    force = forces.internal.nodal_n.reshape(3, -1)[:, rigid].T
    arm = _turned(problem, state.rotation)
    # a fᵀ of each node n; its trace is a · f
    product = np.einsum("ni,nj->nij", arm, force)
    each = (product + np.swapaxes(product, 1, 2)) / 2
    each -= np.einsum("nkk->n", product)[:, None, None] * np.eye(3)
    total = np.zeros_like(state.rotation)
    np.add.at(total, problem.owner[rigid], each)
    start = first + 6 * np.arange(len(total)) + 3
    rows = np.broadcast_to(start[:, None, None] + np.arange(3)[:, None], total.shape)
    columns = np.broadcast_to(start[:, None, None] + np.arange(3), total.shape)
    return sp.csr_matrix((total.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size))
