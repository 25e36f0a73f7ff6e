"""Bound below every choice of presses, against all choices of a small case."""

from itertools import combinations_with_replacement

import numpy as np
from numpy.testing import assert_allclose
from scipy.linalg import cho_solve

from benchmarks.rig.least_possible import PressChoices, choices_of, least_possible
from estimator.calibration.twin.least_known import press_order, prior_variance
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

PRESSES, UNKNOWNS = 6, 8


def choices_from(seed, strength=0.4):
    rng = np.random.default_rng(seed)
    told = strength * rng.standard_normal((PRESSES, 2, UNKNOWNS))
    return PressChoices(told, rng.standard_normal((11, UNKNOWNS)))


def variance_by_hand(choices, chosen):
    """Of the judged signals, by the textbook's formula."""
    rows = choices.told[list(chosen)].reshape(-1, UNKNOWNS)
    covariance = np.linalg.inv(np.eye(UNKNOWNS) + rows.T @ rows)
    return np.mean(np.diag(choices.judged @ covariance @ choices.judged.T))


def test_the_bound_lies_close_below_the_best_of_all_choices():
    for seed in range(5):
        choices = choices_from(seed)
        for presses in (3, 6):
            every = combinations_with_replacement(range(PRESSES), presses)
            best = np.sqrt(min(variance_by_hand(choices, chosen) for chosen in every))
            least, times = least_possible(choices, presses, 1e-3, 300)
            assert least <= best
            assert least > 0.95 * best
            assert_allclose(times.sum(), presses)
            assert least <= choices.left(times) < least * 1.0021


def test_the_bound_holds_after_a_single_round():
    choices = choices_from(1)
    best = min(
        variance_by_hand(choices, chosen)
        for chosen in combinations_with_replacement(range(PRESSES), 3)
    )
    assert least_possible(choices, 3, rounds=1)[0] <= np.sqrt(best)


def test_slopes_are_those_of_the_variance_and_greedy_takes_the_best_next_press():
    choices, times = choices_from(3), np.array([1.0, 0, 2, 0, 0, 0.5])
    variance, slopes = choices.slopes(times)
    assert_allclose(variance, choices.left(times) ** 2)
    for press in range(PRESSES):
        step = 1e-6 * (np.arange(PRESSES) == press)
        assert_allclose(
            (variance - choices.left(times + step) ** 2) / 1e-6, slopes[press], rtol=1e-4
        )
    whole = np.array([1.0, 0, 2, 0, 0, 1])
    chosen = (0, 2, 2, 5)
    gains = [
        variance_by_hand(choices, chosen) - variance_by_hand(choices, (*chosen, press))
        for press in range(PRESSES)
    ]
    assert_allclose(choices.gains_at(whole) / len(choices.judged), gains)
    done = choices.greedy(3, (4,))
    first = min(range(PRESSES), key=lambda press: variance_by_hand(choices, (4, press)))
    second = min(range(PRESSES), key=lambda press: variance_by_hand(choices, (4, first, press)))
    assert_allclose(done, np.bincount([4, first, second], minlength=PRESSES))


def test_presses_made_so_many_times_tell_so_much_more():
    made, times = choices_from(3), np.array([2.0, 0.0, 0.5, 0.0, 0.0, 0.0])
    rows = [np.sqrt(times[k]) * made.told[k] for k in (0, 2)]
    wanted = np.linalg.inv(np.eye(UNKNOWNS) + sum(part.T @ part for part in rows))
    assert_allclose(cho_solve(made.factor_of(times), np.eye(UNKNOWNS)), wanted)


def test_no_choice_of_a_third_of_a_twins_presses_tells_what_all_of_them_tell():
    spec = coarse_spec(
        contact_grid={"count": (3, 3), "pitch_mm": 6.0}, press={"depths_mm": (1.0, 3.0)}
    )
    doubt = prior_variance(spec, *synthetic_presses(spec), 3, 6.0)
    choices = choices_of(doubt)
    assert_allclose(choices.left(np.zeros(9)), doubt.rms_counts, rtol=1e-6)
    left = press_order(doubt, 9)[1]
    assert_allclose(choices.left(np.ones(9)), left[-1], rtol=1e-6)
    least, _ = least_possible(choices, 3)
    assert left[-1] < 0.95 * least
    assert least < left[2]
    assert least > 0.8 * left[2]
