"""Net wrench, equilibrium and asymmetry of grasps worked out by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.grasps.balance import (
    asymmetry,
    drawn_in_balance,
    equilibrium_misfit,
    equilibrium_p,
    grasp_axis,
    net_wrench,
    side_forces_n,
    wrench_covariance,
)
from estimator.grasps.damage import DamageLimit, damage_probability
from tests.estimator.grasps.grasps_by_hand import HALF_MM, placed


def test_equal_jaws_leave_no_wrench():
    wrench = net_wrench(placed([3, 5], [[1, 2], [1, -2]], [7, 7], np.zeros((2, 2))))
    assert_allclose(wrench, np.zeros(6), atol=1e-12)


def test_a_push_beside_the_middle_turns():
    # face 3 looks along +x, its x is −z, its y is +y: pushed by 4 N at y = 3 towards −x
    wrench = net_wrench(placed([3], [[0, 3]], [4], [[0, 0]]))
    assert_allclose(wrench, [-4, 0, 0, 0, 0, 12], atol=1e-12)


def test_a_tangential_force_acts_at_the_surface():
    # 2 N along y at x = +20 mm turn about z by 40 N mm
    wrench = net_wrench(placed([3], [[0, 0]], [4], [[0, 2]]))
    assert_allclose(wrench, [-4, 2, 0, 0, 0, 2 * HALF_MM], atol=1e-12)


def test_the_covariance_is_that_of_drawn_contacts():
    rng = np.random.default_rng(1)
    root = 0.1 * rng.normal(size=(2, 5, 5))  # places and forces err together
    pair = placed([3, 1], [[4, 3], [-6, 2]], [8, 5], [[1, 0.5], [0.2, -0.7]])
    pair = replace(pair, covariance=root @ root.transpose(0, 2, 1))
    drawn = [*map(net_wrench, pair.drawn(rng.standard_normal((4000, 2, 5)), np.zeros(4000)))]
    covariance = wrench_covariance(pair, 0.5)
    sigma = np.sqrt(np.diag(covariance))
    assert_allclose(np.std(drawn, axis=0), sigma, rtol=0.06)
    scaled = np.cov(np.array(drawn).T) / np.outer(sigma, sigma)
    assert_allclose(scaled, covariance / np.outer(sigma, sigma), atol=0.06)


def test_an_unread_tangential_force_may_lie_anywhere_in_the_friction_disc():
    covariance = wrench_covariance(placed([3], [[0, 0]], [6]), 0.5)
    turn, size = np.random.default_rng(2).uniform(0, 1, (2, 20000))
    disc = 0.5 * 6 * np.sqrt(size) * np.cos(2 * np.pi * turn)
    assert_allclose(np.diag(covariance)[:3], [0, np.var(disc), np.var(disc)], rtol=0.03)


@pytest.mark.parametrize("weight_n", [0.0, 3.0])
def test_grasps_in_equilibrium_are_rarely_called_out_of_it(weight_n):
    rng = np.random.default_rng(3)
    root = rng.normal(size=(3, 3))
    covariance = 0.02 * (root @ root.T + 0.5 * np.eye(3))
    noise = rng.multivariate_normal(np.zeros(3), covariance, 2000)
    down = np.array([0.6, 0.0, -0.8])
    p = [
        equilibrium_p(equilibrium_misfit(-weight_n * down + own, covariance, weight_n), weight_n)
        for own in noise
    ]
    assert np.mean(np.array(p) < 0.05) == pytest.approx(0.05, abs=0.015)


def test_a_wrong_weight_is_noticed():
    covariance = 0.01 * np.eye(3)
    assert_allclose(equilibrium_misfit(np.array([0, 0, 3.0]), covariance, 2.0), 100.0, rtol=1e-6)
    assert equilibrium_p(100.0, 2.0) < 1e-6


def test_the_best_direction_of_the_weight_is_found():
    rng = np.random.default_rng(4)
    root = rng.normal(size=(3, 3))
    covariance, force = root @ root.T + 0.1 * np.eye(3), np.array([1.0, -2.0, 0.5])
    z = rng.normal(size=(200_000, 3))
    left = force + 2.5 * z / np.linalg.norm(z, axis=1, keepdims=True)
    tried = np.einsum("ni,ij,nj->n", left, np.linalg.inv(covariance), left).min()
    found = equilibrium_misfit(force, covariance, 2.5)
    assert found <= tried + 1e-9
    assert_allclose(found, tried, atol=0.01)


def test_a_force_along_no_axis_of_the_softest_direction_is_balanced():
    covariance = np.diag([1.0, 0.1, 0.1])
    found = equilibrium_misfit(np.array([0.0, 0.5, 0.0]), covariance, 2.0)
    assert np.isfinite(found)
    assert found < equilibrium_misfit(np.array([0.0, 5.0, 0.0]), covariance, 2.0)


def test_sides_and_asymmetry():
    contacts = placed([3, 3, 5, 1], [[0, 5], [0, -5], [0, 0], [0, 0]], [4, 5, 6, 1])
    axis = grasp_axis(contacts)
    assert_allclose(axis, [1, 0, 0], atol=0.05)
    ahead, back = side_forces_n(contacts, np.array([1.0, 0, 0]))
    assert (ahead, back) == pytest.approx((6, 9))
    assert asymmetry(contacts, np.array([1.0, 0, 0])) == pytest.approx(-0.2)


def test_one_jaw_alone_is_wholly_asymmetric():
    assert asymmetry(placed([3], [[0, 0]], [4]), np.array([1.0, 0, 0])) == -1


FRUIT = DamageLimit("fruit", "force_n", 7.2, 0.15, "made up")
UNKNOWN_WAY = np.full(3, np.nan)


def said_and_true(rng, sigma_n, pull_n, weight_n, balanced):
    """Chance that a grasp damages the fruit as read, and with the forces as they are."""
    half = pull_n / 2
    squeeze_n = rng.uniform(5.5, 9)
    true = np.array([squeeze_n + half, squeeze_n - half])
    read = placed([3, 5], [[0, 0], [0, 0]], true + sigma_n * rng.standard_normal(2), sigma=sigma_n)
    numbers = rng.standard_normal((2, 40, 3))
    drawn = read.drawn(np.pad(numbers[0, :, :2, None], ((0, 0), (0, 0), (4, 0))), np.zeros(40))
    if balanced:
        drawn = drawn_in_balance(read, drawn, numbers[1], 0.5, weight_n, UNKNOWN_WAY)
    chance, _ = damage_probability(FRUIT, np.array([one.force_n[:, 2] for one in drawn]), 5.0)
    return chance.mean(), float(FRUIT.probability(true.max(keepdims=True))[0])


@pytest.mark.parametrize(("pull_n", "weight_n"), [(0.0, 0.0), (1.5, 2.0)])
def test_chances_of_damage_by_forces_that_balance_come_true(pull_n, weight_n):
    """Forces of each jaw alone are too high: the larger of two noisy ones is taken, and drawn about again."""
    excess = {}
    for balanced in (False, True):
        rng = np.random.default_rng(7)
        rows = [said_and_true(rng, 0.5, pull_n, weight_n, balanced) for _ in range(500)]
        excess[balanced] = np.mean([said - true for said, true in rows])
    assert abs(excess[True]) < 0.025
    if not weight_n:
        assert excess[False] > 0.08


def test_a_sum_that_does_not_balance_moves_no_contact():
    rng = np.random.default_rng(8)
    one_side = placed([3, 3], [[4, 0], [-4, 0]], [6.0, 5.0], sigma=0.3)
    numbers = rng.standard_normal((40, 2, 5))
    drawn = one_side.drawn(numbers, np.zeros(40))
    corrected = drawn_in_balance(
        one_side, drawn, rng.standard_normal((40, 3)), 0.5, 0.0, UNKNOWN_WAY
    )
    read_n, corrected_n = (
        np.array([one.force_n[:, 2] for one in some]) for some in (drawn, corrected)
    )
    assert_allclose(corrected_n.mean(axis=0), read_n.mean(axis=0), atol=0.03)
    assert_allclose(corrected_n.std(axis=0), read_n.std(axis=0), rtol=0.05)


def test_exact_forces_stay_as_they_are():
    exact = placed([3, 5], [[0, 0], [0, 0]], [6.0, 5.0])
    (draw,) = drawn_in_balance(exact, [exact], np.zeros((1, 3)), 0.5, 0.0, UNKNOWN_WAY)
    assert draw.force_n[:, 2].tolist() == [6.0, 5.0]
