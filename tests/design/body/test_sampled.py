"""Grids round bodies that are known by their triangles."""

import numpy as np
from numpy.testing import assert_allclose

from design.body.sampled import _grid


def test_a_grid_is_centred_and_reaches_three_steps_beyond_the_box():
    points, count = _grid(np.array([10.0, 5.1, 7.0]), 2.0)
    assert count == (17, 13, 15)
    assert points.shape == (17 * 13 * 15, 3)
    assert_allclose(points.min(axis=0), [-16, -12, -14])
    assert_allclose(points.max(axis=0), [16, 12, 14])
    assert_allclose(points[1] - points[0], [0, 0, 2])
    assert_allclose(points[13 * 15] - points[0], [2, 0, 0])
