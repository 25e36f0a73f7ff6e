"""Derivatives of energies and of gaps, against differences and determinants."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.large_strain import hyperelastic, sphere_contact
from fem.large_strain.correction import StrainCorrection, corrected_presses
from fem.large_strain.elements import pressure_modulus


@pytest.mark.parametrize("power", [-0.5, 0.3, 1.0, 2.0])
def test_divided_differences_are_quotients_and_slopes_where_values_coincide(power):
    values = np.array([[1.2, 0.7, 2.5], [1.3, 1.3, 0.4], [1.0, 1.0 + 1e-12, 1.0]])
    found = hyperelastic.divided_differences(values, power)
    for row, one in zip(found, values, strict=True):
        for a in range(3):
            for b in range(3):
                if abs(one[a] - one[b]) < 1e-9:
                    wanted = power * one[a] ** (power - 1)
                else:
                    wanted = (one[a] ** power - one[b] ** power) / (one[a] - one[b])
                assert row[a, b] == pytest.approx(wanted, rel=1e-6)


def test_the_curvature_of_a_volume_is_that_of_the_determinant():
    """det[d, a, b] is linear in each column: second differences are exact."""
    rng = np.random.default_rng(0)
    d, a, b = rng.normal(size=(3, 1, 1, 3))
    found = sphere_contact.determinant_curvature(d, a, b)[0, 0]

    def volume(flat):
        return np.linalg.det(flat.reshape(3, 3))

    flat = np.concatenate([d, a, b], axis=-1).ravel()
    unit = np.eye(9)
    for i in range(9):
        for j in range(9):
            corners = [
                volume(flat + p * unit[i] + q * unit[j])
                for p, q in ((1, 1), (1, 0), (0, 1), (0, 0))
            ]
            wanted = corners[0] - corners[1] - corners[2] + corners[3]
            assert found[i, j] == pytest.approx(wanted if i != j else 0.0, abs=1e-9)


def test_gaps_per_area_have_the_slopes_and_curvatures_of_differences():
    rng = np.random.default_rng(1)
    deformed = rng.normal(size=(2, 3, 3, 3)) + 3 * np.eye(3)
    gap, slope, curvature = sphere_contact.gap_per_area(deformed, 4.0)
    distance = np.linalg.norm(deformed[:, :, 0], axis=-1)
    height = (1 - (4.0 / distance) ** 3) / 3
    assert_allclose(gap, -height * np.linalg.det(deformed))
    way = rng.normal(size=deformed.shape)
    step = 1e-5
    ahead, behind = (
        sphere_contact.gap_per_area(deformed + sign * step * way, 4.0) for sign in (1, -1)
    )
    assert_allclose(
        np.sum(slope * way, axis=(2, 3)), (ahead[0] - behind[0]) / (2 * step), rtol=1e-6
    )
    flat = way.reshape(2, 3, 9)
    bent = np.einsum("fqmn,fqn->fqm", curvature, flat).reshape(slope.shape)
    assert_allclose(bent, (ahead[1] - behind[1]) / (2 * step), rtol=1e-5, atol=1e-6)


def test_the_modulus_of_a_pressure_is_the_curvature_of_the_volume():
    rng = np.random.default_rng(2)
    deformation = np.eye(3) + 0.3 * rng.normal(size=(3, 3))
    found = pressure_modulus(deformation[None], np.array([2.5]))[0]
    step = 1e-4
    for i, j, k, l in ((0, 0, 1, 1), (0, 1, 1, 0), (2, 0, 0, 1), (1, 2, 2, 1), (0, 0, 0, 1)):
        one, two = np.zeros((2, 3, 3))
        one[i, j], two[k, l] = step, step
        dets = [
            np.linalg.det(deformation + p * one + q * two)
            for p, q in ((1, 1), (1, -1), (-1, 1), (-1, -1))
        ]
        wanted = 2.5 * (dets[0] - dets[1] - dets[2] + dets[3]) / (4 * step**2)
        assert found[i, j, k, l] == pytest.approx(wanted, abs=1e-6)


def test_a_correction_scales_forces_shifts_and_turns_with_the_depth():
    """Half a shell deep: share 0.5; magnets' own shifts and turns by hand."""
    correction = StrainCorrection.__new__(StrainCorrection)
    correction.__dict__.update(
        force=(0.4, 0.0), shift=(0.2, 0.5), rotation=(-0.1,), thickness_mm=8.0
    )
    motion = np.zeros((1, 1, 2, 6))
    motion[0, 0, 0] = [0.1, 0.0, -0.2, 0.0, 0.3, 0.0]
    motion[0, 0, 1] = [0.0, 0.5, 0.0, 0.2, 0.0, 0.0]
    force, moved = corrected_presses(
        correction, np.array([4.0]), np.array([[10.0]]), motion, np.array([True, False]),
        np.array([0.0, 0.0, 1.0]),
    )  # fmt: skip
    assert_allclose(force, 10 * (1 + 0.5 * 0.4))
    crossed = np.cross(motion[0, 0, :, 3:], motion[0, 0, :, :3])
    assert_allclose(moved[0, 0, :, :3], motion[0, 0, :, :3] * 1.1 + 0.5 * crossed)
    assert_allclose(moved[0, 0, :, 3:], motion[0, 0, :, 3:] * 0.95)
