"""Bounds and percentiles of batches, against NumPy's inverse and percentile."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.layouts.bounds import bounds, percentile


def test_bounds_are_the_roots_of_the_inverse_informations_diagonal():
    jacobian = torch.as_tensor(np.random.default_rng(0).normal(size=(7, 2, 3, 4)))
    position, force = bounds(jacobian)
    for layout in range(2):
        for place in range(4):
            j = jacobian[:, layout, :, place].numpy()
            x, y, f = np.diag(np.linalg.inv(j.T @ j))
            assert_allclose(position[layout, place], np.sqrt(x + y))
            assert_allclose(force[layout, place], np.sqrt(f))


def test_a_direction_that_nothing_tells_is_told_to_a_thousandth_at_most():
    """x and y alike: what is left of their information is held at 1e-6 of xx yy."""
    column = torch.tensor([3.0, 4.0, 0.0], dtype=torch.float64)
    alone = torch.tensor([0.0, 0.0, 2.0], dtype=torch.float64)
    jacobian = torch.stack([column, column, alone], dim=1)[:, None, :, None]
    position, force = bounds(jacobian)
    assert_allclose(position, np.sqrt(50 / (1e-6 * 625)), rtol=1e-6)
    assert_allclose(force, np.sqrt(1e-6 * 625 / (4 * 1e-6 * 625)), rtol=1e-6)


@pytest.mark.parametrize("percent", [0.0, 5.0, 50.0, 62.5, 95.0, 100.0])
@pytest.mark.parametrize("count", [2, 5, 8])
def test_percentiles_are_those_of_numpy(percent, count):
    values = np.sort(np.random.default_rng(count).random((3, count)), axis=1)
    found = percentile(torch.as_tensor(values), percent)
    assert_allclose(found, np.percentile(values, percent, axis=1))
