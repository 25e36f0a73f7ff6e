"""Interruptions, time axes, rest levels, press numbers and lags, by hand on a few frames."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.recordings import presses


def test_a_stretch_ends_at_a_pause_a_step_back_and_another_case():
    time_s = np.array([0.0, 5.0, 10.1, 11.0, 10.5, 11.0])
    case = np.array([[1.0], [1], [1], [1], [1], [2]])
    assert presses.stretches(time_s, case).tolist() == [0, 0, 1, 1, 2, 3]
    assert presses.stretches(np.zeros(0), case).tolist() == [0, 0, 0, 0, 0, 1]


def test_stamps_that_grow_are_kept_and_repeated_ones_are_spread():
    growing = np.array([0.0, 0.1, 0.2, 0.4])
    times, rate = presses.frame_times_s(growing, np.zeros(4, int), 50.0)
    assert_array_equal(times, growing)
    assert rate == pytest.approx(10.0)
    whole = np.array([0.0, 0, 1, 1, 2, 2, 10, 10, 11, 11])
    stretch = np.array([0] * 6 + [1] * 4)
    times, rate = presses.frame_times_s(whole, stretch, 50.0)
    # slopes: Σ (k − k̄)(t − t̄) = 8 and 2 over Σ (k − k̄)² = 17.5 and 5
    period = (8 + 2) / (17.5 + 5)
    assert rate == pytest.approx(1 / period)
    assert_allclose(times[:6], 1 + (np.arange(6) - 2.5) * period)
    assert_allclose(times[6:], 10.5 + (np.arange(4) - 1.5) * period)
    pushed, _ = presses.frame_times_s(np.zeros(6), np.repeat([0, 1], [4, 2]), 4.0)
    assert_allclose(pushed, -0.375 + 0.25 * np.arange(6), atol=1e-12)
    times, rate = presses.frame_times_s(np.array([3.0]), np.zeros(3, int), 50.0)
    assert (times.tolist(), rate) == ([0.0, 0.02, 0.04], 50.0)


def test_rest_is_the_lowest_level_the_labelled_or_the_longest():
    force = np.concatenate([np.full(20, 2.0), np.full(10, 7.0)])
    none, labelled = np.zeros(30, bool), np.arange(30) < 20
    high = np.arange(30) >= 20
    tared = presses.tared(force[:, None], none, 0.2, True)[:, 0]
    assert_allclose(tared, force - 2)
    assert_allclose(presses.tared(force[:, None], labelled, 0.2, False)[:, 0], force - 2)
    assert_allclose(presses.tared(force[:, None], high, 0.2, False)[:, 0], 7 - force)
    assert_allclose(presses.tared(force[:, None], none, 0.2, False)[:, 0], force - 2)
    assert_allclose(
        presses.tared(force[::-1][:, None] * -1, none, 0.2, False)[:, 0], force[::-1] - 2
    )


def test_presses_part_in_the_middle_of_the_rest_between_them():
    force = np.zeros(40)
    force[5:10], force[19:24], force[30:34] = 1.0, 1.0, 1.0
    found = presses.number_presses(force[:, None], np.zeros(40, int), 0.1)
    assert np.flatnonzero(np.diff(found)).tolist() == [14]
    assert found.max() == 1
    two = presses.number_presses(force[:, None], np.repeat([0, 1], 20), 0.1)
    assert np.flatnonzero(np.diff(two)).tolist() == [19]
    held = force.copy()
    held[10:19] = 0.2
    assert presses.number_presses(held[:, None], np.zeros(40, int), 0.1).max() == 0
    assert presses.force_excursions(force, 0.1) == [(5, 10), (19, 24)]
    assert presses.runs(np.array([1, 1, 2, 1])) == [(0, 2), (2, 3), (3, 4)]


def test_the_lag_at_which_a_cubic_explains_most_is_found_for_each_press():
    time = np.arange(200)
    force = 5 * np.clip(np.sin(2 * np.pi * time / 100), 0, None) ** 2
    counts = np.zeros((200, 5, 1, 3))
    counts[:, 1, 0, 0] = 40 * np.roll(force, -4) - 2 * np.roll(force, -4) ** 2
    counts[:, 1, 0, 1] = np.nan
    press = np.repeat([0, 1], 100)
    face = np.full((200, 1), 2)
    report = presses.estimate_lag(counts, force[:, None], face, press, press)
    assert (report.frames, report.per_press, report.share_within_2) == (4, (4, 4), 1.0)
    assert report.corrected
    assert report.residual_corrected < 1e-3
    assert report.residual_uncorrected == pytest.approx(0.1, abs=0.09)
    away = presses.estimate_lag(counts, force[:, None], 0 * face, press, press)
    assert away == presses.LagReport(0, (), 0.0, 1.0, 1.0, False)
    still = presses.estimate_lag(counts, 0.1 * force[:, None], face, press, press)
    assert still.per_press == ()
    few = slice(0, 75)
    short = presses.estimate_lag(counts[few], force[few, None], face[few], press[few], press[few])
    assert short.per_press == ()


def test_the_zero_of_a_noisy_load_cell_lies_in_the_middle_of_its_rest():
    rng = np.random.default_rng(0)
    force = np.where(np.arange(2000) % 100 < 60, 0.0, 5.0) + 3.0 + 0.12 * rng.standard_normal(2000)
    rest = np.zeros(2000, bool)
    found = presses.tared(force[:, None], rest, 0.15, signed=True)[:, 0]
    assert np.mean(found[np.arange(2000) % 100 < 60]) == pytest.approx(0.0, abs=0.02)


@pytest.mark.parametrize(("noise_n", "limit_n"), [(0.01, 0.15), (0.07, 0.21), (0.2, 0.3)])
def test_rest_reaches_as_far_as_the_noise_of_the_load_cell_but_not_into_contact(noise_n, limit_n):
    force = np.where(np.arange(4000) % 100 < 70, 0.0, 5.0)[:, None] * np.ones(2)
    force[:, 1] += noise_n * np.random.default_rng(0).standard_normal(4000)
    assert presses.rest_limit_n(force) == pytest.approx(limit_n, rel=0.1)


def test_strokes_too_short_for_a_lag_tell_it_together():
    """Thirty frames each, three of which make one that is long enough; places stay apart."""
    time = np.arange(330)
    force = 5 * np.clip(np.sin(2 * np.pi * time / 30), 0, None)
    counts = np.zeros((330, 5, 1, 3))
    counts[:, 1, 0] = 40 * np.roll(force, -2)[:, None]
    press, place = time // 30, (time >= 180).astype(int)
    face = np.full((330, 1), 2)
    report = presses.estimate_lag(counts, force[:, None], face, press, place)
    assert (report.frames, report.per_press, report.corrected) == (2, (2, 2, 2), True)
    alone = presses.estimate_lag(counts, force[:, None], face, press, press)
    assert alone.per_press == ()


def test_shifted_forces_stay_in_their_stretch():
    force = np.arange(6.0)[:, None]
    stretch = np.array([0, 0, 0, 1, 1, 1])
    assert_array_equal(
        presses.shifted_forces(force, stretch, 1)[:, 0], [1, 2, np.nan, 4, 5, np.nan]
    )
    assert_array_equal(
        presses.shifted_forces(force, stretch, -1)[:, 0], [np.nan, 0, 1, np.nan, 3, 4]
    )
    shear = np.stack([force, 10 * force], axis=2)
    rest = np.array([True, True, False, False, False, False])
    shifted = presses.shifted_shear(shear, stretch, 0, rest)
    assert_array_equal(shifted[:, 0, 0], np.arange(6) - 0.5)
    assert_array_equal(shifted[:, 0, 1], 10 * np.arange(6) - 5.0)
    unshifted = presses.shifted_shear(shear, stretch, 0, ~rest & rest)
    assert_array_equal(unshifted[:, 0, 0], np.arange(6))


def test_rest_is_within_the_rest_force_of_every_cell():
    force = np.array([[0.1, -0.19], [0.2, 0.0], [0.0, -0.3]])
    assert presses.is_at_rest(force, 0.2).tolist() == [True, False, False]


def test_short_presses_join_the_next_until_they_are_long_enough_for_a_lag():
    """More than 75 frames are; a new stretch begins anew."""
    press = np.repeat(np.arange(6), [40, 35, 1, 76, 10, 90])
    stretch = np.repeat([0, 1], [40 + 35 + 1 + 76 + 10, 90])
    assert presses.long_presses(press, stretch) == [(0, 76), (76, 152), (152, 162), (162, 252)]
    lone = np.repeat([0, 1], [75, 5])
    assert presses.long_presses(lone, 0 * lone) == [(0, 80)]


def test_the_share_that_a_cubic_leaves_is_that_of_polyfit():
    rng = np.random.default_rng(3)
    force, counts = rng.random(120), rng.normal(size=(120, 2))
    found = presses.residual_by_lag(counts, force)
    seen = counts[10:95]
    total = np.sum((seen - seen.mean(axis=0)) ** 2)
    for lag, share in zip(range(-10, 26), found, strict=True):
        shifted = force[10 + lag : 95 + lag]
        fitted = np.stack([np.polyval(np.polyfit(shifted, one, 3), shifted) for one in seen.T], 1)
        assert share == pytest.approx(np.sum((seen - fitted) ** 2) / total, abs=1e-9)
    assert np.isnan(presses.residual_by_lag(np.ones((120, 2)), force)).all()


def test_a_lag_is_corrected_where_half_of_the_presses_agree_and_a_fifth_is_gained():
    """Press by press the least of these curves lies at lags 4, 4, 9 and 12; zero is at index 10."""
    curves = {}

    def by_lag(counts, force):
        return curves["rows"].pop(0)

    def report(bests, gained):
        rows = np.ones((len(bests), 36))
        for row, best in zip(rows, bests, strict=True):
            row[10 + best] = 0.5
        rows[:, 10 + bests[0]] -= 0.5 - gained
        curves["rows"] = list(rows)
        frames = 100 * len(bests)
        press = np.repeat(np.arange(len(bests)), 100)
        force = np.tile(np.linspace(0, 5, 100), len(bests))[:, None]
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(presses, "residual_by_lag", by_lag)
            return presses.estimate_lag(
                np.ones((frames, 5, 1, 3)), force, np.ones((frames, 1), int), press, press
            )

    half = report([4, 4, 9, 12], 0.1)
    assert (half.frames, half.share_within_2, half.corrected) == (4, 0.5, True)
    assert half.per_press == (4, 4, 9, 12)
    assert not report([4, 9, 12, 15], 0.1).corrected
    near = report([4, 6, 2, 7], 0.1)
    assert near.share_within_2 == 0.75


def test_rest_is_the_lower_extreme_where_both_last_as_long():
    force = np.concatenate([np.full(40, 1.0), np.linspace(1.5, 6.5, 9), np.full(40, 7.0)])
    none = np.zeros(len(force), bool)
    assert_allclose(presses.tared(force[:, None], none, 0.2, False)[:, 0], force - 1)
    longer = np.append(force, 7.0)
    assert_allclose(
        presses.tared(longer[:, None], np.zeros(90, bool), 0.2, False)[:, 0], 7 - longer
    )
