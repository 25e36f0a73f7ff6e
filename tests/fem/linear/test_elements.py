"""The elements: energy of a linear field; orders and locking of those other than Taylor–Hood."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.linear.elements import assemble, element_space
from fem.linear.material import lame_constants
from tests.support.mechanics.elasticity_cases import (
    ELEMENTS,
    GRADIENT,
    SIZE_MM,
    errors_on,
    octant_displacement,
)
from tests.support.mechanics.fem_cases import box_mesh


@pytest.fixture(scope="module", params=ELEMENTS)
def jiggled(request):
    return element_space(box_mesh((5, 6, 4), SIZE_MM, jiggle=0.2), request.param)


def energy(operators, u):
    return u.ravel() @ operators.stiffness @ u.ravel()


def test_a_linear_field_costs_the_energy_of_its_strain(jiggled):
    material = lame_constants(0.3, 0.4999)
    operators = assemble(jiggled, material)
    u = GRADIENT @ jiggled.nodes_mm.T
    expected = energy_of_gradient(material, mixed=len(jiggled.pressure_nodes) > 0)
    assert_allclose(energy(operators, u), expected, rtol=1e-12)
    if len(jiggled.pressure_nodes):
        div = -np.sum(operators.divergence @ u.ravel())
        assert_allclose(div, np.trace(GRADIENT) * np.prod(SIZE_MM), rtol=1e-12)


def energy_of_gradient(material, mixed):
    """∫ 2μ ε:ε, and λ (div u)² where no pressure carries it."""
    strain = (GRADIENT + GRADIENT.T) / 2
    density = 2 * material.shear_modulus_mpa * np.sum(strain**2)
    if not mixed:
        density += np.trace(GRADIENT) ** 2 / material.inverse_lambda_per_mpa
    return density * np.prod(SIZE_MM)


RATES = {
    ("p2-p0", 0.3): ([2, 1], 0.22, [1.8e-3, 0.1]),
    ("p2-p0", 0.4999): ([2, 1], 0.33, [2.6e-3, 0.12]),
    ("p2", -0.2): ([3, 2], 0.1, [2e-4, 0.011]),
}
"""Orders for u in L2 and its gradient; how far off they may be; bounds on 8³ bricks.

The constant pressure of P2/P0 costs an order, which it nears from below (1.68 to 1.88 here)."""


@pytest.mark.parametrize(("element", "poisson_ratio"), RATES)
def test_errors_fall_at_the_rates_of_the_element(element, poisson_ratio):
    cells = np.array([3, 5, 8])
    errors = np.array([errors_on(element, n, poisson_ratio) for n in cells])
    rates = -np.diff(np.log(errors), axis=0) / np.diff(np.log(cells))[:, None]
    orders, tolerance, bounds = RATES[element, poisson_ratio]
    assert_allclose(rates, [orders] * 2, rtol=0, atol=tolerance)
    assert (errors[-1] < bounds).all()


def test_lame_s_hollow_sphere_with_constant_pressures():
    assert_allclose(octant_displacement(0.4999, 5, 4, "p2-p0"), 1, rtol=5e-3)


@pytest.mark.parametrize("poisson_ratio", [-0.2, 0.0])
def test_lame_s_hollow_sphere_of_a_foam(poisson_ratio):
    """What is left is the facets' (0.5 % on facets half as long)."""
    assert_allclose(octant_displacement(poisson_ratio, 4, 4, "p2"), 1, rtol=0.02)


def test_mixed_and_plain_quadratic_elements_agree_where_both_are_right():
    mixed, plain = (octant_displacement(0.05, 4, 4, name) for name in ("taylor-hood", "p2"))
    assert_allclose(mixed, plain, rtol=1e-3)


@pytest.mark.parametrize("poisson_ratio", [0.3, 0.4999])
def test_the_sphere_s_error_is_that_of_its_flat_facets(poisson_ratio):
    """Halving the facets divides it by about four."""
    coarse, fine = (octant_displacement(poisson_ratio, n, n).mean() - 1 for n in (3, 4))
    assert 3.2 < coarse / fine < 5
