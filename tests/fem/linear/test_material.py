"""Elastic constants, and the claim that ν = 0.499999 stands for 0.5."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.linear.elements import assemble, free_motion_basis, saddle_point_matrix, taylor_hood
from fem.linear.material import LameConstants, lame_constants
from fem.linear.sparse import shape_of
from tests.support.mechanics.fem_cases import box_mesh


@pytest.mark.parametrize("poisson_ratio", [-0.3, 0.0, 0.05, 0.3, 0.49, 0.4999])
def test_lame_constants_give_back_bulk_and_young_s_modulus(poisson_ratio):
    material = lame_constants(0.414, poisson_ratio)
    mu, lam = material.shear_modulus_mpa, 1 / material.inverse_lambda_per_mpa
    assert_allclose(mu * (3 * lam + 2 * mu) / (lam + mu), 0.414, rtol=1e-9)
    assert_allclose(lam + 2 * mu / 3, 0.414 / (3 * (1 - 2 * poisson_ratio)), rtol=1e-9)


@pytest.mark.parametrize(("modulus", "nu"), [(0.0, 0.4), (-1.0, 0.4), (0.3, -1.0), (0.3, 0.51)])
def test_impossible_constants_are_refused(modulus, nu):
    with pytest.raises(ValueError, match="E > 0 and −1 < ν"):
        lame_constants(modulus, nu)


def compliance_of_bonded_block(material):
    """Σ f·u of a unit downward force spread over the top of a block bonded below (dense solve)."""
    space = taylor_hood(box_mesh((4, 4, 2), (4.0, 5.0, 1.5)))
    z = space.nodes_mm[:, 2]
    basis = free_motion_basis(z > 1e-9)
    matrix = saddle_point_matrix(assemble(space, material), basis, space.pressure_nodes)
    top = (abs(z - 1.5) < 1e-9) & (np.linalg.norm(space.nodes_mm[:, :2] - [1.6, 2.9], axis=1) < 1.1)
    load = np.zeros(shape_of(matrix)[0])
    load[: shape_of(basis)[1]] = basis.T @ np.concatenate([0 * z, 0 * z, top / -top.sum()])
    return load @ np.linalg.solve(matrix.toarray(), load)


def test_the_largest_ratio_stands_for_incompressible_silicone():
    """1/λ = 0 exactly, against what ν = 0.5 is taken as: less than 1e-5 apart."""
    half = lame_constants(0.3, 0.5)
    exact = compliance_of_bonded_block(LameConstants(half.shear_modulus_mpa, 0.0))
    floored = compliance_of_bonded_block(half)
    assert 0 < floored / exact - 1 < 1e-5
    assert compliance_of_bonded_block(lame_constants(0.3, 0.499)) / exact - 1 > 1e-4
