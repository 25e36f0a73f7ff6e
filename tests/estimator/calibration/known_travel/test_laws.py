"""Figures of presses of known travel and what suspects gain, by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel import agreement
from studies.recorded import travel_suspects as suspects


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
