"""Fresh networks by their specification; ridge regression against penalized least squares."""

import numpy as np
import torch
from numpy.testing import assert_allclose

from design.spec.object import TrainingSpec
from estimator.networks.ensemble import PAPER_HIDDEN_UNITS, RIDGE, architecture_of, fit_ridge
from estimator.networks.network import HeatmapNetwork


def test_ridge_regression_minimizes_the_penalized_squares():
    """Rows of the penalty below those of the data: the same least squares."""
    rng = np.random.default_rng(0)
    counts, maps = rng.normal(size=(30, 4)) * [1, 10, 100, 5] + 3, rng.normal(size=(30, 6))
    low, span = counts.min(axis=0), np.array([2.0, 10.0, 50.0, 4.0])
    grid = np.arange(3.0), np.arange(2.0)
    member = HeatmapNetwork(low, span, *grid, (), 1.0, 0.1, 1)
    fit_ridge(member, counts, maps)
    basis = np.column_stack([counts / span, np.ones(30)])
    penalty = np.sqrt(RIDGE * np.sum(basis**2) / 5)
    rows = np.vstack([basis, penalty * np.eye(5)])
    wanted = np.linalg.lstsq(rows, np.vstack([maps, np.zeros((5, 6))]), rcond=None)[0]
    assert_allclose(member.heads.weight.detach().numpy(), wanted[:-1].T, rtol=1e-4, atol=1e-6)
    assert_allclose(member.heads.bias.detach().numpy(), wanted[-1], rtol=1e-4, atol=1e-6)
    assert member.heads.weight.dtype == torch.float32


def test_architectures_are_those_of_the_models():
    def built(**given):
        found = architecture_of(TrainingSpec(**given))
        return found.kind, found.hidden_units, found.axes, found.continuous, found.members

    assert PAPER_HIDDEN_UNITS == (600, 2000, 2000, 2000)
    assert built(model="paper") == ("heatmap", PAPER_HIDDEN_UNITS, 1, False, 1)
    assert built(model="linear", ensemble=3) == ("heatmap", (), 1, False, 3)
    assert built(hidden_units=(7, 5)) == ("heads", (7, 5), 1, False, 1)
    assert built(output="position", ensemble=2)[3:] == (True, 2)
