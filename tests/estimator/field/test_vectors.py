"""Turned vectors, against SciPy's rotations."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from estimator.field.vectors import rotate

RNG = np.random.default_rng(8)
DIRECTIONS = RNG.standard_normal((50, 3))
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=1)[:, None]
VECTORS = RNG.standard_normal((50, 3))


@pytest.mark.parametrize("angle", [0, 1e-160, 1e-8, 0.03, 0.3, 0.4999, 0.5001, 1.6, np.pi, 7.0])
def test_vectors_turn_as_scipy_turns_them(angle):
    """By the series below 0.5 rad, by sines above."""
    turned = rotate(VECTORS, angle * DIRECTIONS)
    exact = Rotation.from_rotvec(angle * DIRECTIONS).apply(VECTORS)
    assert_allclose(turned, exact, rtol=0, atol=3e-15)


def test_one_large_turn_among_small_ones_is_exact_too():
    angle = np.where(np.arange(50) == 7, 2.5, 1e-3)[:, None]
    turned = rotate(VECTORS, angle * DIRECTIONS)
    exact = Rotation.from_rotvec(angle * DIRECTIONS).apply(VECTORS)
    assert_allclose(turned, exact, rtol=0, atol=3e-15)
