"""Finite-strain elements: closed forms, rotations, forces and tangent from the potential."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from fem.large_strain.elements import (
    InvertedElementError,
    deformation_gradients,
    finite_strain_elements,
    internal_forces,
    tangent_blocks,
)
from fem.large_strain.hyperelastic import first_piola_stress
from fem.linear.elements import assemble, taylor_hood
from fem.linear.material import lame_constants
from tests.support.mechanics.fem_cases import box_mesh
from tests.support.mechanics.large_strain_cases import (
    E_MPA,
    MATERIALS,
    NU,
    potential_energy_n_mm,
    stretch,
)

LAME = lame_constants(E_MPA, NU)


@pytest.fixture(scope="module")
def space():
    return taylor_hood(box_mesh((3, 2, 2), (1.0, 1.2, 0.9), jiggle=0.2))


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
