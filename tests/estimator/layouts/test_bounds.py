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


def test_single_precision_rounds_by_the_share_that_is_left_of_the_information():
    """Columns of random directions, up to a thousandth alike; sums in both orders, and double precision."""
    generator = torch.Generator().manual_seed(1)
    jacobian = torch.randn(27, 40, 3, 50, generator=generator, dtype=torch.float64)
    apart = 10 ** (-3 * torch.rand(2, 40, 50, generator=generator, dtype=torch.float64))
    for column, like in ((0, 2), (1, 0)):
        own, other = jacobian[:, :, column], jacobian[:, :, like]
        jacobian[:, :, column] = torch.lerp(other, own, apart[column])
    jacobian = jacobian.float()
    information = torch.einsum("clip,cljp->lpij", jacobian.double(), jacobian.double())
    # what the force does not explain of x and y, over all: Schur complement
    left = torch.linalg.det(information) / information[..., 2, 2]
    share = left / (information[..., 0, 0] * information[..., 1, 1])
    usual = share > 1e-5
    allowed = 8 * 2.0**-24 / share[usual]
    assert 100 < int((allowed > 1e-4).sum()) < int(usual.sum())
    once, turned, double = (bounds(one) for one in (jacobian, jacobian.flip(0), jacobian.double()))
    for k in range(2):
        for other in (turned[k], double[k]):
            error = (once[k] / other - 1).abs()[usual]
            assert (error <= allowed).all()
            assert (error > 1e-5).sum() > 100, "five digits are not held where much cancels"


@pytest.mark.parametrize("percent", [0.0, 5.0, 50.0, 62.5, 95.0, 100.0])
@pytest.mark.parametrize("count", [2, 5, 8])
def test_percentiles_are_those_of_numpy(percent, count):
    values = np.sort(np.random.default_rng(count).random((3, count)), axis=1)
    found = percentile(torch.as_tensor(values), percent)
    assert_allclose(found, np.percentile(values, percent, axis=1))
