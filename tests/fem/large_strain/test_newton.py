"""Equilibrium at large strain: derivatives of the energy, convergence, balance, rigid magnets."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from fem.large_strain import newton as large_strain_newton
from fem.large_strain.elements import internal_forces
from fem.large_strain.newton import (
    StepDivergedError,
    advanced,
    equilibrium,
    motion_basis,
    residual,
    undeformed,
)
from fem.large_strain.sphere_contact import contact_state, normal_force_n
from tests.support.mechanics.fem_cases import box_mesh
from tests.support.mechanics.large_strain_cases import (
    BLOCK_MM,
    block,
    potential_energy_n_mm,
    tangent_matrix,
)


def scaled_step(problem, seed):
    """A random direction of all unknowns that turns magnets by about 0.2 rad per unit."""
    random = np.random.default_rng(seed)
    count = 3 * int(problem.free.sum()) + 6 * len(problem.magnet_centres_mm)
    motion = 0.02 * random.standard_normal(count)
    motion[-3:] *= 10
    return np.concatenate([motion, 0.02 * random.standard_normal(problem.elements.pressure_count)])


def lagrangian(problem, state, centre):
    """Stored energy less the work of the contact pressures on their gaps."""
    gap = contact_state(problem.face, state.displacement_mm, centre, problem.radius_mm).gap_mm3
    stored = potential_energy_n_mm(
        problem.elements,
        problem.material,
        problem.inverse_lambda_per_mpa,
        state.displacement_mm,
        state.pressure_mpa,
    )
    return stored - state.contact_mpa @ gap


def rotation_of_the_magnet(problem):
    """Unknowns (q, p) that turn the magnet alone, about an oblique axis."""
    step = np.zeros(3 * int(problem.free.sum()) + 6 + problem.elements.pressure_count)
    step[3 * int(problem.free.sum()) + 3 :][:3] = [0.05, -0.03, 0.02]
    return step


def shift_of_the_top(problem):
    """Unknowns (q, p) that shear the block sideways over its height, the magnet left in place."""
    height = problem.nodes_mm[problem.free, 2] / BLOCK_MM[2]
    motion = np.concatenate([0.1 * height**3, -0.06 * height**3, 0.02 * height**3])
    return np.concatenate([motion, np.zeros(6 + problem.elements.pressure_count)])


def curvature_mismatch(setup, state, step):
    """Relative error of sᵀ A s against second differences of the energy along s."""
    problem, centre = setup.problem, setup.centre(0.9)
    basis = motion_basis(problem, state.rotation)
    size = 0.02

    def along(part):
        moved = advanced(problem, state, basis, part * step, state.contact_mpa)
        return lagrangian(problem, moved, centre)

    second = (along(size) - 2 * along(0) + along(-size)) / size**2
    return abs(step @ (tangent_matrix(problem, state, centre) @ step) / second - 1)


def test_the_tangent_is_the_energy_s_second_derivative_with_turning_magnets(pressed):
    """Off equilibrium too: along R ← exp(tω) R the energy bends as the symmetric tangent says."""
    setup, state = pressed
    problem, basis = setup.problem, motion_basis(setup.problem, state.rotation)
    away = advanced(problem, state, basis, 0.2 * scaled_step(problem, 9), state.contact_mpa)
    for direction in (rotation_of_the_magnet(problem), shift_of_the_top(problem)):
        assert curvature_mismatch(setup, state, direction) < 1e-4
        assert curvature_mismatch(setup, away, direction) < 1e-4
    assert curvature_mismatch(setup, away, 0.1 * scaled_step(problem, 8)) < 1e-4


def test_the_residual_is_the_energy_s_first_derivative(pressed):
    setup, state = pressed
    problem, centre = setup.problem, setup.centre(0.8)
    basis = motion_basis(problem, state.rotation)
    step, size = scaled_step(problem, 10), 1e-4

    def along(part):
        moved = advanced(problem, state, basis, part * step, state.contact_mpa)
        return lagrangian(problem, moved, centre)

    slope = (along(size) - along(-size)) / (2 * size)
    assert_allclose(residual(problem, state, centre) @ step, slope, rtol=1e-6)


def test_the_tangent_is_symmetric(pressed):
    setup, state = pressed
    matrix = tangent_matrix(setup.problem, state, setup.centre(0.9))
    assert abs(matrix - matrix.T).max() < 1e-12 * abs(matrix).max()


def test_newton_converges_quadratically(monkeypatch):
    """The number of correct digits about doubles: four iterations from rest."""
    setup = block()
    seen = []
    misfit = large_strain_newton.newton_misfit
    monkeypatch.setattr(
        large_strain_newton, "newton_misfit", lambda *a: seen.append(misfit(*a)) or seen[-1]
    )
    equilibrium(setup.problem, undeformed(setup.problem), setup.centre(0.5))
    assert len(seen) <= 5
    assert seen[-1] < 1e-3 * seen[-2]


def test_contact_conditions_and_balance_hold(pressed):
    setup, state = pressed
    problem = setup.problem
    contact = contact_state(problem.face, state.displacement_mm, setup.centre(0.9), 5.0)
    gap = contact.gap_mm3 / problem.face.weights_mm2
    touched = state.contact_mpa > 0
    assert 3 < touched.sum() < len(touched)
    assert (state.contact_mpa >= 0).all()
    assert gap.min() > -1e-5
    assert abs(gap[touched]).max() < 1e-5
    forces = internal_forces(
        problem.elements,
        problem.material,
        problem.inverse_lambda_per_mpa,
        state.displacement_mm,
        state.pressure_mpa,
    )
    applied = (contact.gradient.T @ state.contact_mpa).reshape(3, -1).sum(axis=1)
    held = problem.nodes_mm[:, 2] < 1e-9
    reaction = forces.nodal_n.reshape(3, -1)[:, held].sum(axis=1)
    assert_allclose(reaction, -applied, rtol=0, atol=1e-5 * abs(applied).max())


def test_rigid_magnets_stay_rigid_and_turn(pressed):
    """Distances between its nodes are kept to rounding; the small-rotation tie would stretch it."""
    setup, state = pressed
    problem = setup.problem
    rigid = problem.owner >= 0
    before = problem.nodes_mm[rigid]
    after = before + state.displacement_mm.reshape(3, -1).T[rigid]

    def lengths(points):
        return np.linalg.norm(points[:, None] - points, axis=-1)

    assert_allclose(lengths(after), lengths(before), rtol=0, atol=1e-12)
    angle = Rotation.from_matrix(state.rotation[0]).magnitude()
    assert angle > 0.03
    turn = Rotation.from_matrix(state.rotation[0]).as_rotvec()
    arms = before - problem.magnet_centres_mm[0]
    stretched = arms + np.cross(turn, arms)
    assert abs(lengths(stretched) - lengths(before)).max() > 1e-4


def test_force_is_the_slope_of_the_stored_energy_over_depth(pressed):
    """Frictionless: F = dW/dδ exactly, and not the sum of pressures on the undeformed area."""
    setup, state = pressed
    problem, step = setup.problem, 0.01
    energy = []
    for depth in (0.9 - step, 0.9 + step):
        moved = equilibrium(problem, state, setup.centre(depth))
        energy.append(lagrangian(problem, moved, setup.centre(depth)))
    contact = contact_state(problem.face, state.displacement_mm, setup.centre(0.9), 5.0)
    force = normal_force_n(problem.face, contact, state.contact_mpa)
    slope = (energy[1] - energy[0]) / (2 * step)
    assert_allclose(force, slope, rtol=5e-4)
    flat = state.contact_mpa @ problem.face.weights_mm2
    assert abs(flat / slope - 1) > 5e-3


def test_without_contact_nothing_moves():
    setup = block()
    state = equilibrium(setup.problem, undeformed(setup.problem), setup.centre(-0.2))
    assert not state.displacement_mm.any()
    assert not state.contact_mpa.any()


def test_a_step_that_does_not_converge_is_told(monkeypatch):
    setup = block(magnet=False)
    monkeypatch.setattr(large_strain_newton, "MAX_ITERATIONS", 2)
    with pytest.raises(StepDivergedError, match="no equilibrium after 2 iterations"):
        equilibrium(setup.problem, undeformed(setup.problem), setup.centre(2.0))


def test_volume_counts_by_the_share_of_a_vertex_that_is_lost(pressed):
    """Allowed is a millionth of a vertex's own volume: a quarter of the elements around it."""
    setup, state = pressed
    forces = large_strain_newton.forces_of(setup.problem, state, setup.centre(0.9))
    assert large_strain_newton.newton_misfit(setup.problem, state, forces) < 1
    mesh, vertex = box_mesh((8, 7, 4), BLOCK_MM, jiggle=0.1), 5
    assert setup.space.pressure_nodes[vertex] == vertex
    edges = mesh.p[:, mesh.t[1:]] - mesh.p[:, mesh.t[:1]]
    volume = abs(np.linalg.det(edges.transpose(2, 0, 1))) / 6
    assert_allclose(volume.sum(), np.prod(BLOCK_MM))
    own = volume[(mesh.t == vertex).any(axis=0)].sum() / 4
    lost = np.zeros_like(forces.internal.volume_mm3)
    lost[vertex] = 3e-6 * own
    worse = replace(forces, internal=replace(forces.internal, volume_mm3=lost))
    assert_allclose(large_strain_newton.newton_misfit(setup.problem, state, worse), 3, rtol=1e-6)
