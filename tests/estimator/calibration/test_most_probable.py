"""The one solver of unknowns with priors, against the posterior of a linear model in closed form."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.most_probable import Unknown, most_probable

RNG = np.random.default_rng(4)
SLOPES = {"gain": RNG.normal(size=(20, 2)), "seat": RNG.normal(size=(20, 3))}
SEEN = SLOPES["gain"] @ [0.3, -0.2] + SLOPES["seat"] @ [1.0, 2.0, -1.5] + RNG.normal(0, 0.5, 20)
UNKNOWNS = {
    "gain": Unknown(0.1, (2, 1)),
    "seat": Unknown(3.0, (3,), mean=np.array([1.0, 1.0, -1.0])),
}


def misfit(values):
    return (SEEN - sum(SLOPES[name] @ values[name].ravel() for name in SLOPES)) / 0.5


def test_values_and_deviations_are_those_of_the_linear_posterior():
    found = most_probable(misfit, UNKNOWNS)
    slopes = np.hstack(list(SLOPES.values())) / 0.5
    prior = np.array([0.1, 0.1, 3.0, 3.0, 3.0])
    mean = np.array([0.0, 0, 1, 1, -1])
    covariance = np.linalg.inv(slopes.T @ slopes + np.diag(1 / prior**2))
    wanted = covariance @ (slopes.T @ (SEEN / 0.5) + mean / prior**2)
    assert_allclose(found.values["gain"][:, 0], wanted[:2], rtol=1e-5)
    assert_allclose(found.values["seat"], wanted[2:], rtol=1e-5)
    assert_allclose(found.covariance("seat"), covariance[2:, 2:], rtol=1e-5)
    assert_allclose(found.sd("gain")[:, 0], np.sqrt(np.diag(covariance)[:2]), rtol=1e-5)


def test_a_step_without_a_prior_is_free_and_a_bound_holds():
    free = most_probable(misfit, UNKNOWNS | {"gain": Unknown(0.1, (2, 1), has_prior=False)})
    held = most_probable(misfit, UNKNOWNS | {"gain": Unknown(0.1, (2, 1), bound=0.05)})
    assert (
        abs(free.values["gain"]).min()
        > 1.5 * abs(most_probable(misfit, UNKNOWNS).values["gain"]).min()
    )
    assert abs(held.values["gain"]).max() == pytest.approx(0.05, abs=1e-3)
