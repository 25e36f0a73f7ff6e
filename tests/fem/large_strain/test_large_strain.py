"""Large deformation: element, tangent, contact, rigid magnets, and the limit of small strain."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from fem.large_strain import newton as large_strain_newton
from fem.large_strain.elements import (
    InvertedElementError,
    deformation_gradients,
    finite_strain_elements,
    internal_forces,
    tangent_blocks,
)
from fem.large_strain.hyperelastic import first_piola_stress
from fem.large_strain.newton import (
    StepDivergedError,
    advanced,
    equilibrium,
    motion_basis,
    residual,
    undeformed,
)
from fem.large_strain.sphere_contact import contact_state, contact_stiffness, normal_force_n
from fem.linear.elements import assemble, taylor_hood
from fem.linear.material import lame_constants
from tests.support.mechanics.fem_cases import box_mesh
from tests.support.mechanics.large_strain_cases import (
    BLOCK_MM,
    E_MPA,
    MATERIALS,
    NU,
    block,
    potential_energy_n_mm,
    stretch,
    tangent_matrix,
)

LAME = lame_constants(E_MPA, NU)
NEO_HOOKEAN, YEOH, OGDEN = MATERIALS


@pytest.fixture(scope="module")
def space():
    return taylor_hood(box_mesh((3, 2, 2), (1.0, 1.2, 0.9), jiggle=0.2))


@pytest.fixture(scope="module")
def pressed():
    """The block with its magnet, pressed 0.9 mm by a tip of 5 mm."""
    setup = block()
    state = undeformed(setup.problem)
    for depth in (0.3, 0.6, 0.9):
        state = equilibrium(setup.problem, state, setup.centre(depth))
    return setup, state


def uniaxial_stress(material, stretch_ratio):
    """Nominal stress of an incompressible bar."""
    s = stretch_ratio
    excess = s**2 + 2 / s - 3
    yeoh = sum(
        k * c * excess ** (k - 1)
        for k, c in enumerate(material.invariant_coefficients_mpa, start=1)
    )
    ogden = sum(mu * (s ** (a - 1) - s ** (-a / 2 - 1)) for mu, a in material.ogden_terms)
    return 2 * (s - s**-2) * yeoh + ogden


def shear_stress(material, shear):
    """Nominal shear stress dW/dγ in simple shear."""
    ratio, slope = shear / 2 + np.sqrt(1 + shear**2 / 4), 1 / np.sqrt(4 + shear**2)
    yeoh = sum(
        k * c * shear ** (2 * k - 2)
        for k, c in enumerate(material.invariant_coefficients_mpa, start=1)
    )
    ogden = sum(mu * (ratio**a - ratio**-a) * slope for mu, a in material.ogden_terms)
    return 2 * shear * yeoh + ogden


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
@pytest.mark.parametrize("ratio", [1.6, 0.65])
def test_uniaxial_stretch_follows_the_closed_form(space, material, ratio):
    """A distorted mesh, mirror planes at x = 0 and y = 0; reaction at the end over the area."""
    x, y, z = space.nodes_mm.T
    free = np.stack([x > 1e-9, y > 1e-9, (z > 1e-9) & (z < 0.9 - 1e-9)])
    prescribed = np.stack([0 * x, 0 * y, (ratio - 1) * z])
    inverse_lambda = 1e-6 / material.shear_modulus_mpa
    u, _, forces = stretch(space, material, inverse_lambda, free, prescribed, 6)
    end = forces.nodal_n.reshape(3, -1)[2, z > 0.9 - 1e-9].sum()
    assert_allclose(end / 1.2, uniaxial_stress(material, ratio), rtol=2e-5)
    assert_allclose(u.reshape(3, -1)[0], (ratio**-0.5 - 1) * x, rtol=0, atol=1e-5)


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
def test_simple_shear_follows_the_closed_form(space, material):
    shear, (x, y, z) = 0.7, space.nodes_mm.T
    inner = (x > 1e-9) & (x < 1 - 1e-9) & (y > 1e-9) & (y < 1.2 - 1e-9)
    inner &= (z > 1e-9) & (z < 0.9 - 1e-9)
    prescribed = np.stack([shear * y, 0 * y, 0 * y])
    _, p, forces = stretch(space, material, 1e-4, np.stack([inner] * 3), prescribed, 3)
    elements = finite_strain_elements(space)
    assert_allclose(p, np.full(elements.pressure_count, p[0]), rtol=0, atol=1e-9)
    deformation = np.eye(3) + shear * np.outer([1, 0, 0], [0, 1, 0])
    expected = shear_stress(material, shear)
    assert_allclose(first_piola_stress(material, deformation[None])[0, 0, 1], expected, rtol=1e-10)
    work = forces.nodal_n @ np.concatenate([y, 0 * y, 0 * y])  # ∫ P : ∇(y, 0, 0)
    assert_allclose(work / elements.weights_mm3.sum(), expected, rtol=1e-9)


def test_a_rigid_rotation_costs_no_force_where_small_strain_sees_one(space):
    turn = Rotation.from_rotvec([0.5, -0.8, 1.1]).as_matrix() - np.eye(3)
    u = (turn @ space.nodes_mm.T).ravel()
    elements = finite_strain_elements(space)
    for material in MATERIALS:
        forces = internal_forces(elements, material, 1e-4, u, np.zeros(elements.pressure_count))
        assert abs(forces.nodal_n).max() < 1e-14
        assert abs(forces.volume_mm3).max() < 1e-14
    assert abs(assemble(space, LAME).stiffness @ u).max() > 1e-3


def test_the_tangent_at_rest_is_the_linear_operator(space):
    elements, operators = finite_strain_elements(space), assemble(space, LAME)
    rest = np.zeros(3 * space.node_count), np.zeros(elements.pressure_count)
    for material in MATERIALS:
        blocks = tangent_blocks(elements, material, *rest)
        scale = material.shear_modulus_mpa / LAME.shear_modulus_mpa
        assert abs(blocks.stiffness - scale * operators.stiffness).max() < 1e-15
        expected = operators.divergence[space.pressure_nodes]
        assert abs(blocks.divergence - expected).max() < 1e-16


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
def test_element_forces_and_tangent_are_derivatives_of_the_potential(space, material):
    random = np.random.default_rng(3)
    elements = finite_strain_elements(space)
    mass = assemble(space, LAME).compressibility[space.pressure_nodes][:, space.pressure_nodes]
    gradient = 0.15 * random.standard_normal((3, 3))
    u = (gradient @ space.nodes_mm.T).ravel()
    u += 0.01 * random.standard_normal(len(u))
    p = 0.05 * random.standard_normal(elements.pressure_count)
    du, dp = random.standard_normal(len(u)), random.standard_normal(len(p))

    def at(step):
        moved = (elements, material, LAME.inverse_lambda_per_mpa, u + step * du, p + step * dp)
        return potential_energy_n_mm(*moved), internal_forces(*moved)

    step = 1e-6
    (above, forces_above), (below, forces_below) = at(step), at(-step)
    forces, blocks = at(0)[1], tangent_blocks(elements, material, u, p)
    slope = forces.nodal_n @ du + forces.volume_mm3 @ dp
    assert_allclose((above - below) / (2 * step), slope, rtol=1e-6)
    nodal = (forces_above.nodal_n - forces_below.nodal_n) / (2 * step)
    volume = (forces_above.volume_mm3 - forces_below.volume_mm3) / (2 * step)
    assert_allclose(blocks.stiffness @ du + blocks.divergence.T @ dp, nodal, rtol=0, atol=1e-7)
    assert_allclose(blocks.divergence @ du - mass @ dp, volume, rtol=0, atol=1e-8)


def test_an_element_turned_inside_out_is_told(space):
    elements = finite_strain_elements(space)
    mirrored = np.concatenate([-2 * space.nodes_mm[:, 0], np.zeros(2 * space.node_count)])
    with pytest.raises(InvertedElementError, match="inside out"):
        deformation_gradients(elements, mirrored)


def test_contact_derivatives_by_finite_differences(pressed):
    setup, state = pressed
    face, centre = setup.problem.face, setup.centre(1.0)
    random = np.random.default_rng(4)
    direction = random.standard_normal(len(state.displacement_mm))
    pressure = random.uniform(0, 1, len(face.weights_mm2))

    def at(step):
        return contact_state(face, state.displacement_mm + step * direction, centre, 5.0)

    step, now = 1e-5, at(0)
    gap = (at(step).gap_mm3 - at(-step).gap_mm3) / (2 * step)
    assert_allclose(now.gradient @ direction, gap, rtol=0, atol=1e-8)
    force = -(at(step).gradient - at(-step).gradient).T @ pressure / (2 * step)
    stiffness = contact_stiffness(face, now, pressure) @ direction
    assert_allclose(stiffness, force, rtol=0, atol=1e-7 * abs(force).max())


def test_the_gap_of_a_flat_face_is_the_volume_below_the_sphere():
    """∑ gap_i of a flat face: a cone's solid-angle share of the sphere, taken from its volume."""
    setup = block(cells=(12, 10, 2), magnet=False)
    face = setup.problem.face
    centre = setup.centre(-0.4)
    gaps = contact_state(face, np.zeros(3 * face.node_count), centre, 5.0).gap_mm3
    points, area = face.frame_mm[:, :, 0], face.area_mm2
    offset = points - centre
    distance = np.linalg.norm(offset, axis=-1)
    height = (1 - (5.0 / distance) ** 3) / 3 * 5.4
    known = np.where(face.candidate >= 0, 1.0, 0.0)
    shares = np.einsum("fqh,fh->fq", face.hats, known)
    assert_allclose(gaps.sum(), (height * shares * area).sum(), rtol=1e-12)
    assert (gaps > 0).all()
    nearest = np.argmin(gaps / face.weights_mm2)
    assert 0.4 < gaps[nearest] / face.weights_mm2[nearest] < 0.5


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


@pytest.mark.parametrize(
    ("part", "direction"),
    [
        ("_rotation_stiffness", rotation_of_the_magnet),
        ("contact_stiffness", shift_of_the_top),
    ],
)
def test_the_second_derivative_check_sees_a_missing_part(pressed, monkeypatch, part, direction):
    setup, state = pressed
    before = getattr(large_strain_newton, part)
    monkeypatch.setattr(large_strain_newton, part, lambda *a: 0 * before(*a))
    assert curvature_mismatch(setup, state, direction(setup.problem)) > 1e-3


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
    misfit = large_strain_newton._misfit
    monkeypatch.setattr(
        large_strain_newton, "_misfit", lambda *a: seen.append(misfit(*a)) or seen[-1]
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
    monkeypatch.setattr(large_strain_newton, "_MAX_ITERATIONS", 2)
    with pytest.raises(StepDivergedError, match="no equilibrium after 2 iterations"):
        equilibrium(setup.problem, undeformed(setup.problem), setup.centre(2.0))


def test_only_facets_at_candidates_are_integrated():
    setup = block()
    face = setup.problem.face
    assert (face.candidate >= 0).any(axis=1).all()
    assert_allclose(face.weights_mm2, setup.weights, rtol=1e-12)


def test_volume_counts_by_the_share_of_a_vertex_that_is_lost(pressed):
    """Allowed is a millionth of a vertex's own volume: a quarter of the elements around it."""
    setup, state = pressed
    forces = large_strain_newton._forces(setup.problem, state, setup.centre(0.9))
    assert large_strain_newton._misfit(setup.problem, state, forces) < 1
    mesh, vertex = box_mesh((8, 7, 4), BLOCK_MM, jiggle=0.1), 5
    assert setup.space.pressure_nodes[vertex] == vertex
    edges = mesh.p[:, mesh.t[1:]] - mesh.p[:, mesh.t[:1]]
    volume = abs(np.linalg.det(edges.transpose(2, 0, 1))) / 6
    assert_allclose(volume.sum(), np.prod(BLOCK_MM))
    own = volume[(mesh.t == vertex).any(axis=0)].sum() / 4
    lost = np.zeros_like(forces.internal.volume_mm3)
    lost[vertex] = 3e-6 * own
    worse = replace(forces, internal=replace(forces.internal, volume_mm3=lost))
    assert_allclose(large_strain_newton._misfit(setup.problem, state, worse), 3, rtol=1e-6)
