"""Bases of the laws of force and field, and figures of presses, by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.integrate import quad

from estimator.calibration.known_travel import agreement
from studies.recorded import cycle_laws as cycles
from studies.recorded import travel_suspects as suspects

TIME = np.arange(0, 12, 0.1)


def made(travel, load=None, cycle=None):
    load = travel if load is None else load
    number = np.zeros(len(travel), int) if cycle is None else cycle
    time = np.arange(len(travel)) * 0.1
    return cycles.Cycles(time, travel, load, load[:, None], number, "z")


def test_what_relaxes_is_the_integral_of_past_changes():
    """∫ exp(−(t − s)/θ) de(s) of e = t² is ∫ exp(−(t − s)/θ) 2 s ds; steps of 0.1 s are 2 % off."""
    time_s = 3.0
    found = cycles.relaxing_travel((TIME**2)[:, None], time_s)[:, 0]
    for k in (30, 90):
        wanted = quad(lambda s, t=TIME[k]: np.exp(-(t - s) / time_s) * 2 * s, 0, TIME[k])[0]
        assert found[k] == pytest.approx(wanted, rel=0.04)
    exact = [sum(np.exp(-0.1 * (k - j) / time_s) * 2.0 for j in range(1, k + 1)) for k in range(5)]
    assert_allclose(cycles.relaxing_travel(2.0 * np.arange(5)[:, None], time_s)[:, 0], exact)


def test_bases_are_spheres_behind_their_contact_and_chebyshev_powers():
    travel = np.array([0.0, 1.0, 2.0, 5.0])
    assert_allclose(cycles.sphere_basis(travel, 1.0)[:, 0], [0, 0, 1, 8])
    assert_allclose(cycles.contact_basis(made(travel)), np.arange(26) * 0.1)
    share = np.array([0.0, 0.3, 1.0])
    wanted = [np.cos(k * np.arccos(2 * share - 1)) for k in range(8)]
    assert_allclose(cycles.power_basis(share), np.stack(wanted, axis=1), atol=1e-9)
    assert_allclose(cycles.LAGS_S, [-0.5, -0.4, -0.3, -0.2, -0.1, 0, *(0.1 * np.arange(1, 11))])


def test_late_travel_is_that_of_some_time_ago():
    travel = np.array([0.0, 1, 3, 4, 2, 0])
    assert_allclose(cycles.late_travel(made(travel), 0.1), [0, 0, 1, 3, 4, 2])
    assert_allclose(cycles.late_travel(made(travel), -0.2), [3, 4, 2, 0, 0, 0])
    assert_allclose(cycles.late_travel(made(travel), 0.05), [0, 0.5, 2, 3.5, 3, 1])


def test_the_share_of_work_lost_is_that_of_the_loop():
    """There along the diagonal, back at half the load: 8 is done, 4 is given back."""
    travel = np.array([0.0, 2, 4, 4, 2, 0])
    load = np.array([0.0, 2, 4, 2, 1, 0])
    found = cycles.loop_shares(
        made(np.tile(travel, 2), np.tile(load, 2), np.repeat([0, 1], 6)), 0.0
    )
    assert_allclose(found, 0.5)
    elastic = cycles.loop_shares(made(travel, travel), 0.0)
    assert_allclose(elastic, 0.0, atol=1e-12)


def test_later_cycles_judge_the_basis_that_fits_earlier_ones_best():
    number = np.repeat(np.arange(5), 10)
    x = np.tile(np.linspace(0, 1, 10), 5)
    values = np.where(number < 2, 2 * x, 2 * x + 0.1)[:, None]
    given = made(x, 2 * x, number)
    fitted, judged = cycles.cycle_halves(given)
    assert_array_equal(fitted, number < 2)
    assert_array_equal(judged, number >= 2)
    before = replace(given, cycle=number - 1)
    assert_array_equal(cycles.cycle_halves(before)[0], (number >= 1) & (number < 3))
    line, parabola = x[:, None], x[:, None] ** 2
    found = cycles.judged_share(given, [parabola, line], values)
    about = np.sum((values[20:] - values[20:].mean()) ** 2)
    assert found == pytest.approx(1 - 30 * 0.01 / about)
    assert cycles.squares_left(given, line, values) == pytest.approx(0.0, abs=1e-12)
    law = (parabola[:20] * values[:20]).sum() / (parabola[:20] ** 2).sum()
    wanted = np.sum((values[:20] - law * parabola[:20]) ** 2)
    assert cycles.squares_left(given, parabola, values) == pytest.approx(wanted)


def test_ways_are_exchanged_at_the_nearest_travel():
    travel = np.array([0.0, 1.0, 3.0, 4.0, 2.9, 1.2, 0.1])
    assert cycles.mirrored_ways(made(travel)).tolist() == [6, 5, 4, 3, 2, 1, 0]
    two = made(np.tile(travel, 2), cycle=np.repeat([0, 1], 7))
    assert cycles.mirrored_ways(two).tolist() == [6, 5, 4, 3, 2, 1, 0, 13, 12, 11, 10, 9, 8, 7]


def test_a_gain_is_the_share_of_squares_and_its_range_is_over_places():
    """Two places whose gains are 0.5 and 0.1 of sizes 10 and 10; drawn anew they mix."""
    alone = np.array([10.0, 10.0, 10.0, 10.0])
    left = np.array([5.0, 5.0, 9.0, 9.0])
    gained, low, high = suspects.gain_of_suspect(
        alone, left, np.full(4, 10.0), np.array([4, 4, 9, 9]), np.random.default_rng(0)
    )
    assert gained == pytest.approx(0.3)
    assert (low, high) == (pytest.approx(0.1), pytest.approx(0.5))
    assert_allclose(suspects.squares_left(np.arange(12.0).reshape(2, 2, 3)), [55, 451])


def test_figures_of_presses_by_hand():
    recorded = np.array([[[3.0, 0.0, 0.02]], [[0.0, 4.0, 0.0]]])
    predicted = np.array([[[3.0, 4.0, -1.0]], [[0.0, 2.0, 0.0]]])
    found = agreement.figures(predicted, recorded)
    first = (9 - 0.02) / np.sqrt(9.0004 * 26)
    assert found.cosine == pytest.approx((first + 1) / 2)
    left = 16 + 1.02**2 + 4
    assert found.explained == pytest.approx(1 - left / (25 + 0.0004))
    about = np.sum((recorded - recorded.mean(axis=0)) ** 2)
    assert found.between == pytest.approx(1 - left / about)
    assert (found.presses, found.signs) == (2, 1.0)
    assert found.size == pytest.approx((9 - 0.02 + 8) / (26 + 4))
    nothing = agreement.figures(0 * predicted, recorded)
    assert (nothing.cosine, nothing.size) == (0.0, 0.0)


def test_orders_of_chips_are_all_others_of_five_and_a_draw_of_more():
    assert len(agreement.chip_orders(3)) == 5
    assert (0, 1, 2) not in agreement.chip_orders(3)
    assert len(agreement.chip_orders(5)) == 119
    drawn = agreement.chip_orders(6)
    assert len(drawn) == 120
    assert all(sorted(order) == list(range(6)) for order in drawn)


def test_the_true_order_of_chips_is_best_where_no_other_reaches_its_cosine():
    def of(cosine):
        return agreement.TravelFigures(3, cosine, 0.5, 0.4, 0.9, 1.0)

    others = [of(0.2), of(0.8), of(0.5), of(0.8)]
    found = agreement.TravelAgreement(
        of(0.8), 1.0, of(0.9), {}, [of(0.1), of(0.3), of(0.2)], others, {}
    )
    assert found.order_of_chips == 3
    nulls = found.summary()["nulls, median and best"]
    assert nulls["places exchanged"]["cosine"] == [0.2, 0.3]
    assert nulls["chips permuted"]["cosine"] == [0.65, 0.8]
    assert found.summary()["order of chips"] == 3
