"""Nuisances integrated out: against the whole covariance, and against least squares that fit them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.inversion.model.whitening import whitening
from estimator.inversion.problems import Observations, empty

RNG = np.random.default_rng(1)
SIGMA, COLUMNS = RNG.uniform(0.5, 3, (4, 12)), RNG.normal(0, 2, (12, 3))
ROWS = RNG.normal(size=(4, 5, 12))
COVARIANCE = np.array([np.diag(sigma**2) + COLUMNS @ COLUMNS.T for sigma in SIGMA])


def test_whitened_products_are_those_by_the_inverse_of_the_covariance():
    white = whitening(SIGMA, COLUMNS)(ROWS)
    products = ROWS @ np.linalg.solve(COVARIANCE, ROWS.transpose(0, 2, 1))
    assert_allclose(white @ white.transpose(0, 2, 1), products, rtol=1e-10, atol=1e-10)


def test_the_spread_is_what_nuisances_add_to_the_log_determinant():
    spread = np.linalg.slogdet(COVARIANCE)[1] / 2 - np.log(SIGMA).sum(axis=1)
    assert_allclose(whitening(SIGMA, COLUMNS).log_spread(), spread)


def test_a_press_is_whitened_from_either_side_and_loses_what_nuisances_could_be():
    made = whitening(SIGMA, COLUMNS)
    press = RNG.normal(size=12)
    rows = made(ROWS)
    whole = made(np.tile(press, (4, 1, 1)))
    assert_allclose(made.transposed(rows) @ press, (rows @ whole.transpose(0, 2, 1))[..., 0])
    lost = np.sum((press / SIGMA) ** 2, axis=1) - np.sum((made.taken() @ press) ** 2, axis=1)
    assert_allclose(np.sum(whole[:, 0] ** 2, axis=1), lost)


@pytest.mark.parametrize("columns", [np.zeros((12, 0)), np.zeros((12, 2))])
def test_without_nuisances_rows_are_over_their_noise(columns):
    made = whitening(SIGMA, columns)
    assert_allclose(made(ROWS), ROWS / SIGMA[:, None])
    assert_allclose(made.log_spread(), 0, atol=1e-15)


def test_very_wide_priors_fit_the_nuisances():
    """A misfit as by least squares with the nuisances as unknowns."""
    white = whitening(SIGMA[:1], 1e5 * COLUMNS)(ROWS[:1, :1])[0, 0]
    fitted, *_ = np.linalg.lstsq(COLUMNS / SIGMA[0][:, None], ROWS[0, 0] / SIGMA[0], rcond=None)
    left = (ROWS[0, 0] - COLUMNS @ fitted) / SIGMA[0]
    assert_allclose(np.sum(white**2), np.sum(left**2), rtol=1e-6)


def test_rest_is_judged_by_its_own_noise_and_the_same_nuisances():
    still = 0.7 * SIGMA
    seen = Observations(ROWS[:, 0], SIGMA, still, SIGMA, COLUMNS)
    nothing = empty(seen, np.array([2, 0]), 1)
    for row, misfit, spread in zip((2, 0), nothing.misfit, nothing.log_spread, strict=True):
        covariance = np.diag(still[row] ** 2) + COLUMNS @ COLUMNS.T
        left = ROWS[row, 0]
        assert_allclose(misfit, 0.5 * left @ np.linalg.solve(covariance, left))
        both = (np.linalg.slogdet(one)[1] / 2 for one in (covariance, COVARIANCE[row]))
        assert_allclose(spread, next(both) - next(both))
