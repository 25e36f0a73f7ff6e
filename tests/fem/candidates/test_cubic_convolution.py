"""Keys' cubic convolution against its formula: weights, parabolas up to the border, refusals."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from fem.candidates.cubic_convolution import axis_weights

NODES = np.linspace(-3.0, 4.0, 8)


def keys(s):
    """Keys (1981), equation 15, a = −1/2."""
    s = abs(s)
    if s < 1:
        return 1.5 * s**3 - 2.5 * s**2 + 1
    return -0.5 * s**3 + 2.5 * s**2 - 4 * s + 2 if s < 2 else 0.0


def interpolated(values, at, nodes=NODES):
    near, weight = axis_weights(nodes, np.asarray(at, float))
    return np.einsum("pk,pk->p", values[near], weight)


def test_weights_inside_are_the_kernel_at_the_distance_of_each_node():
    for place in (-1.7, 0.0, 0.25, 1.999):
        near, weight = axis_weights(NODES, np.array([place]))
        dense = np.zeros(len(NODES))
        np.add.at(dense, near[0], weight[0])
        assert_allclose(dense, [keys(place - node) for node in NODES], atol=1e-12)


def test_parabolas_are_exact_up_to_the_border_and_values_at_nodes():
    at = np.concatenate([np.linspace(-3, 4, 57), NODES])
    for coefficients in ([1.0, -2.0, 0.5], [0.0, 0.0, 1.0], [3.0, 0.0, 0.0]):
        values, wanted = (np.polynomial.polynomial.polyval(x, coefficients) for x in (NODES, at))
        assert_allclose(interpolated(values, at), wanted, atol=1e-12)
    noise = np.random.default_rng(0).normal(size=len(NODES))
    assert_allclose(interpolated(noise, NODES), noise, atol=1e-12)
    four = np.linspace(0.0, 1.5, 4)
    assert_allclose(
        interpolated(four**2, np.linspace(0, 1.5, 31), four),
        np.linspace(0, 1.5, 31) ** 2,
        atol=1e-12,
    )


def test_it_is_once_differentiable_across_nodes():
    noise = np.random.default_rng(1).normal(size=len(NODES))
    step = 1e-5
    for node in NODES[1:-1]:
        below, here, above = interpolated(noise, [node - step, node, node + step])
        assert (here - below) / step == pytest.approx((above - here) / step, abs=1e-3)


def test_too_few_nodes_and_points_beyond_them_are_refused():
    with pytest.raises(InputError, match="needs four nodes an axis; got 3"):
        axis_weights(NODES[:3], np.array([-2.5]))
    axis_weights(NODES, np.array([-3.0 - 5e-10, 4.0 + 5e-10]))
    for beyond in (-3.0 - 2e-9, 4.0 + 2e-9):
        with pytest.raises(InputError, match=r"lies outside the lattice \(-3 to 4 mm\)"):
            axis_weights(NODES, np.array([0.0, beyond]))
