"""Shares of force gathered on the likeliest pixels nearby, those of distant tips left alone."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.networks.network import GATHER_MM, HeadsNetwork

GRID_MM = (np.arange(10) - 4.5) * 3
STRONG, BESIDE, WEAK = (2, 4), (3, 4), (7, 5)
SHARES = {STRONG: 0.4, BESIDE: 0.16, WEAK: 0.44}
"""Two tips 15 mm apart: the first most likely at one pixel, perhaps at the next."""


def gathered(sharpness, near=None, faint=1e-6):
    network = HeadsNetwork(np.ones(9), GRID_MM, GRID_MM, (4,), 10.0)
    network.sharpness.fill_(sharpness)
    network.faint.fill_(faint)
    if near is not None:
        network.near.copy_(near)
    share = torch.full((10, 10), 1e-9)
    for pixel, value in SHARES.items():
        share[pixel] = value
    share = (share / share.sum()).reshape(1, -1)
    return network.gathered(share, torch.log(share)).reshape(10, 10).numpy()


@pytest.mark.parametrize("sharpness", [1.0, 4.0, 16.0])
def test_every_tip_keeps_its_share(sharpness):
    found = gathered(sharpness)
    assert_allclose(found.sum(), 1, atol=1e-5)
    assert_allclose(found[STRONG] + found[BESIDE], 0.56, atol=1e-4)
    assert_allclose(found[WEAK], 0.44, atol=1e-4)


@pytest.mark.parametrize(("sharpness", "left"), [(1.0, 0.16 / 0.56), (4.0, 1 / (1 + 2.5**4))])
def test_the_likelier_of_two_neighbours_takes_more(sharpness, left):
    assert_allclose(gathered(sharpness)[BESIDE], 0.56 * left, rtol=1e-3)


def test_neighbours_are_told_by_distance_not_by_pixels():
    coarse = HeadsNetwork(np.ones(9), 2 * GRID_MM, GRID_MM, (4,), 10.0)
    near = coarse.near.reshape(10, 10, 10, 10)[4, 4]
    x, y = np.meshgrid(2 * (GRID_MM - GRID_MM[4]), GRID_MM - GRID_MM[4], indexing="ij")
    np.testing.assert_array_equal(near.numpy() == 1, np.hypot(x, y) <= GATHER_MM)
