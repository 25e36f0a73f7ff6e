"""Cramér–Rao bounds: attained by maximum likelihood, invariant, honest about blindness."""

import re

import numpy as np
from numpy.testing import assert_allclose

from design.spec.object import SensorSpec
from estimator.information.fisher import (
    cramer_rao_bounds,
    detectable_force_n,
    disturbance_counts,
    position_and_force_bounds,
)
from estimator.signals.interpolation import Traces

SIGMA = disturbance_counts(SensorSpec(), "fresh", 9)


def random_jacobian(presses=1, seed=1):
    scale = np.array([120.0, 60.0, 40.0])
    return np.random.default_rng(seed).normal(size=(presses, 9, 3)) * scale


def test_disturbances_add_zeroing_or_drift_in_quadrature():
    assert_allclose(SIGMA[:3], [np.hypot(22, 10)] * 2 + [np.hypot(11, 10)])
    drifted = disturbance_counts(SensorSpec(), "drifted", 45)
    assert_allclose(drifted[-3:], [np.hypot(22, 60)] * 2 + [np.hypot(11, 60)])
    assert drifted.shape == (45,)


def test_bound_is_attained_by_maximum_likelihood_on_a_linear_sensor():
    jacobian, truth = random_jacobian()[0], np.array([1.3, -0.4, 6.0])
    rng = np.random.default_rng(2)
    frames = jacobian @ truth + rng.standard_normal((20000, 9)) * SIGMA
    whitened = jacobian / SIGMA[:, None]
    estimate = np.linalg.lstsq(whitened, (frames / SIGMA).T, rcond=None)[0].T
    error = estimate - truth
    bounds = cramer_rao_bounds(jacobian[None], SIGMA)
    position = np.sqrt(np.mean(error[:, 0] ** 2 + error[:, 1] ** 2))
    bounds_here = [bounds.position_mm[0], bounds.force_n[0]]
    assert_allclose(bounds_here, [position, error[:, 2].std()], rtol=0.02)
    angle = np.linspace(0, np.pi, 181)
    spread = (error[:, :2] @ [np.cos(angle), np.sin(angle)]).std(axis=0)
    u = np.array([np.cos(angle), np.sin(angle)])[:, np.argmax(spread)]
    assert abs(u @ bounds.weakest_direction[0]) > 0.999


def test_bounds_do_not_depend_on_how_the_plane_is_turned_and_scale_with_units():
    jacobian = random_jacobian(5)
    bounds = cramer_rao_bounds(jacobian, SIGMA)
    c, s = np.cos(0.7), np.sin(0.7)
    turned = jacobian @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert_allclose(cramer_rao_bounds(turned, SIGMA).position_mm, bounds.position_mm, rtol=1e-10)
    per_cm_and_kn = cramer_rao_bounds(jacobian * [10, 10, 1000], SIGMA)
    assert_allclose(per_cm_and_kn.position_mm, bounds.position_mm / 10, rtol=1e-10)
    assert_allclose(per_cm_and_kn.force_n, bounds.force_n / 1000, rtol=1e-10)
    assert (bounds.rank == 3).all()
    assert bounds.status(2) == "ok"


def test_unknown_parameters_cost_information():
    jacobian = random_jacobian()
    known = SIGMA[:, None] / jacobian[0]
    alone = 1 / np.sqrt(np.sum(known**-2.0, axis=0))
    bounds = cramer_rao_bounds(jacobian, SIGMA)
    assert bounds.force_n[0] > alone[2]
    more = cramer_rao_bounds(np.repeat(jacobian, 4, axis=1), np.repeat(SIGMA, 4))
    assert_allclose(more.position_mm, bounds.position_mm / 2, rtol=1e-10)


def test_blind_directions_are_infinite_and_named():
    jacobian = random_jacobian(4)
    jacobian[0, :, 1] = 0.0
    jacobian[1, :, 0] = 2 * jacobian[1, :, 2]
    jacobian[2, :, 2] = 0.0
    bounds = cramer_rao_bounds(jacobian, SIGMA)
    assert np.isinf(bounds.position_mm[:2]).all()
    assert np.isfinite(bounds.position_mm[2:]).all()
    assert np.isinf(bounds.force_n).tolist() == [False, True, True, False]
    assert bounds.rank.tolist() == [2, 2, 2, 3]
    assert_allclose(abs(bounds.blind_direction[0]), [0, 1, 0], atol=1e-9)
    assert_allclose(abs(bounds.weakest_direction[0]), [0, 1], atol=1e-9)
    direction = bounds.blind_direction[1] / bounds.blind_direction[1, 0]
    assert_allclose(direction, [1, 0, -2], atol=1e-9)
    assert re.fullmatch(r"blind to 1 of 3 parameters: along \(y [+-]1\)", bounds.status(0))
    assert np.isnan(bounds.blind_direction[3]).all()
    reduced = cramer_rao_bounds(jacobian[3:] * [0, 0, 1], SIGMA)
    assert reduced.rank[0] == 1
    assert_allclose(reduced.force_n[0], 1 / np.linalg.norm(jacobian[3, :, 2] / SIGMA), rtol=1e-9)


def test_detectable_force_is_where_the_distance_from_rest_is_five():
    force = np.array([[0.0, 1, 2, 5, 12], [0.0, 0.5, 1, 2, 3]])
    slope = np.array([9.0, -12, 3, 0, 6, 0, 0, 15, 0])
    counts = force[..., None] * slope * np.array([1.0, 0.1])[:, None, None]
    traces = Traces(np.arange(5.0), force, counts, np.zeros((2, 5), bool))
    found = detectable_force_n(traces, SIGMA)
    assert_allclose(found[0], 5 / np.linalg.norm(slope / SIGMA), rtol=1e-3)
    assert np.isinf(found[1])
    assert_allclose(detectable_force_n(traces, SIGMA, distance=2.5)[0], found[0] / 2, rtol=1e-3)


def test_between_two_forces_the_distance_is_taken_as_linear():
    """Of signals that grow as the square of the force: short by 1/8 of (3 %)² at most."""
    force = np.linspace(0, 12, 200)[None]
    slope = np.array([9.0, -12, 3, 0, 6, 0, 0, 15, 0])
    traces = Traces(
        np.arange(200.0), force, force[..., None] ** 2 * slope, np.zeros((1, 200), bool)
    )
    per_n2 = np.linalg.norm(slope / SIGMA)
    exact = np.linspace(0.9, 8.0, 60)
    found = [detectable_force_n(traces, SIGMA, distance=per_n2 * f**2)[0] for f in exact]
    off = np.array(found) / exact - 1
    assert off.max() < 2e-5
    assert -(0.03**2) / 8 * 1.2 < off.min() < -5e-5


def test_tangential_forces_cost_information_and_get_a_bound_of_their_own():
    jacobian = np.random.default_rng(3).normal(size=(4, 9, 5)) * [120, 60, 40, 90, 30]
    five, three = cramer_rao_bounds(jacobian, SIGMA), cramer_rao_bounds(jacobian[:, :, :3], SIGMA)
    assert (five.position_mm > three.position_mm).all()
    assert (five.force_n > three.force_n).all()
    assert np.isnan(three.tangential_force_n).all()
    whitened = jacobian / SIGMA[:, None]
    covariance = np.linalg.inv(whitened.swapaxes(1, 2) @ whitened)
    expected = np.sqrt(covariance[:, 3, 3] + covariance[:, 4, 4])
    assert_allclose(five.tangential_force_n, expected, rtol=1e-9)
    assert five.status(0) == "ok"
    jacobian[2, :, 4] = -0.5 * jacobian[2, :, 0]
    blind = cramer_rao_bounds(jacobian, SIGMA)
    assert blind.rank.tolist() == [5, 5, 4, 5]
    assert np.isinf([blind.position_mm[2], blind.tangential_force_n[2]]).all()
    assert np.isfinite(blind.force_n[2])
    direction = blind.blind_direction[2] / blind.blind_direction[2, 0]
    assert_allclose(direction, [1, 0, 0, 0, 2], atol=1e-9)
    assert "blind to 1 of 5 parameters" in blind.status(2)


def test_fewer_channels_than_parameters_are_blind_not_certain():
    jacobian = random_jacobian(2)[:, :2]
    bounds = cramer_rao_bounds(jacobian, SIGMA[:2])
    assert bounds.rank.tolist() == [2, 2]
    assert np.isinf(bounds.position_mm).all()
    assert_allclose(jacobian @ bounds.blind_direction[:, :, None], 0, atol=1e-9)


def test_bounds_of_place_and_force_alone_are_those_of_all_bounds():
    jacobian = random_jacobian(40, seed=6)
    jacobian[0, :, 1] = 2 * jacobian[0, :, 0] + 1e-3 * jacobian[0, :, 1]  # nearly blind
    jacobian[1, :, 1] = jacobian[1, :, 0]
    jacobian[2, :, 2] = 0
    jacobian[3] = 0
    every = cramer_rao_bounds(jacobian, SIGMA)
    position, force = position_and_force_bounds(jacobian, SIGMA)
    assert_allclose(position, every.position_mm, rtol=1e-10)  # one is nearly blind
    assert_allclose(force, every.force_n, rtol=1e-10)
    assert np.isinf(position[[1, 3]]).all()
    assert np.isinf(force[[2, 3]]).all()
    assert np.isfinite(position[2])
    few = position_and_force_bounds(jacobian[4:, :2], SIGMA[:2])
    assert_allclose(few[0], cramer_rao_bounds(jacobian[4:, :2], SIGMA[:2]).position_mm)
