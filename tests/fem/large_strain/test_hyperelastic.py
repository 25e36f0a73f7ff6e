"""Strain energies: derivatives by finite differences, small strain, homogeneous closed forms."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.errors import InputError
from fem.large_strain.hyperelastic import (
    first_piola_stress,
    inverse_transpose,
    neo_hookean,
    ogden,
    tangent_modulus,
    yeoh,
)
from tests.support.mechanics.large_strain_cases import MATERIALS, energy_density

STEP = 1e-5


def deformations():
    """Random ones with J > 0, then equal and nearly equal principal stretches."""
    gradient = np.eye(3) + 0.3 * np.random.default_rng(5).standard_normal((20, 3, 3))
    random = gradient[np.linalg.det(gradient) > 0.2]
    special = [np.eye(3), np.diag([1.2, 1.2, 0.9]), np.diag([1.1, 1.1 + 1e-7, 0.8])]
    return np.concatenate([random, special])


def differences(function, at):
    """Central differences of a function of F by its nine entries, as the last two axes."""
    columns = []
    for i in range(3):
        for j in range(3):
            change = np.zeros((3, 3))
            change[i, j] = STEP
            columns.append((function(at + change) - function(at - change)) / (2 * STEP))
    table = np.stack(columns, axis=-1)
    return table.reshape(*table.shape[:-1], 3, 3)


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
def test_stress_and_modulus_are_derivatives_of_the_energy(material):
    at = deformations()
    by_energy = differences(lambda f: energy_density(material, f), at)
    by_stress = differences(lambda f: first_piola_stress(material, f), at)
    assert_allclose(first_piola_stress(material, at), by_energy, rtol=1e-6, atol=1e-8)
    assert_allclose(tangent_modulus(material, at), by_stress, rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
def test_the_undeformed_state_is_free_of_stress_and_linear_elastic_about_it(material):
    """∂P/∂F at F = 1 is μ (δ_ik δ_jl + δ_il δ_jk), without any λ."""
    unit = np.eye(3)
    expected = np.einsum("ik,jl->ijkl", unit, unit) + np.einsum("il,jk->ijkl", unit, unit)
    assert_allclose(energy_density(material, unit[None]), [0], atol=1e-15)
    assert_allclose(first_piola_stress(material, unit[None]), np.zeros((1, 3, 3)), atol=1e-15)
    modulus = tangent_modulus(material, unit[None])[0]
    assert_allclose(modulus, material.shear_modulus_mpa * expected, atol=1e-14)


@pytest.mark.parametrize("material", MATERIALS, ids=lambda m: m.name)
def test_energy_is_objective_and_isotropic(material):
    left, right = Rotation.from_rotvec([[0.4, -1.1, 0.3], [2.0, 0.5, -0.7]]).as_matrix()
    at = deformations()
    energy = energy_density(material, left @ at @ right)
    assert_allclose(energy, energy_density(material, at), rtol=1e-11, atol=1e-15)
    turned = first_piola_stress(material, left @ at @ right)
    assert_allclose(turned, left @ first_piola_stress(material, at) @ right, rtol=1e-9, atol=1e-11)
    assert_allclose(first_piola_stress(material, left[None]), np.zeros((1, 3, 3)), atol=1e-14)


def test_moduli_agree_with_small_strain():
    assert_allclose(neo_hookean(0.3, 0.4999).shear_modulus_mpa, 0.3 / (2 * 1.4999), rtol=1e-14)
    assert_allclose(yeoh(0.05, -0.01, 0.003).shear_modulus_mpa, 0.1, rtol=1e-14)
    assert_allclose(ogden((0.1, -0.03), (1.5, -2.0)).shear_modulus_mpa, 0.105, rtol=1e-14)


def test_neo_hookean_is_yeoh_of_one_term_and_ogden_of_exponent_two():
    at = deformations()
    for other in (yeoh(0.05), ogden((0.1,), (2.0,))):
        same = neo_hookean(0.3, 0.5)
        assert_allclose(energy_density(other, at), energy_density(same, at), rtol=1e-12, atol=1e-15)
        assert_allclose(
            tangent_modulus(other, at), tangent_modulus(same, at), rtol=1e-9, atol=1e-12
        )


def test_inverse_transpose_is_that_of_the_general_solver():
    at = deformations()
    assert_allclose(inverse_transpose(at), np.swapaxes(np.linalg.inv(at), 1, 2), rtol=1e-12)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: yeoh(-0.05), "shear modulus"),
        (lambda: ogden((0.1,), (-2.0,)), "shear modulus"),
        (lambda: ogden((0.1, 0.2), (2.0,)), "as many moduli as exponents"),
        (lambda: ogden((0.1,), (0.0,)), "none of them zero"),
        (lambda: ogden((), ()), "as many moduli as exponents"),
    ],
)
def test_unstable_or_incomplete_constants_are_refused(make, words):
    with pytest.raises(InputError, match=words):
        make()
