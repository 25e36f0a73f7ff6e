"""Levels at rest under presses: drift followed from both sides, and how far it may be off."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.recordings import drift
from estimator.recordings.drift import levels_under_presses

REST, LOADED, PRESSES, FRAME_S = 25, 30, 40, 0.1
NOISE = np.full((5, 1, 3), 20.0)
RATE = 4.0


def stretch(presses=PRESSES, gap_s=0.0):
    """Presses of 30 loaded frames behind 25 at rest, 10 a second: times, and what is loaded."""
    loaded = np.tile(np.repeat([False, True], [REST, LOADED]), presses)
    press = np.repeat(np.arange(presses), REST + LOADED)
    return np.arange(len(press)) * FRAME_S + gap_s * press, loaded


def followed(counts, time_s, loaded, session=None, noise=NOISE):
    session = np.zeros(len(time_s), int) if session is None else session
    return levels_under_presses(counts, time_s, session, loaded, ~loaded, noise)


def walking(time_s, seed=0, rate=RATE):
    """Random walks of all channels, and what is read of them."""
    rng = np.random.default_rng(seed)
    steps = rng.standard_normal((len(time_s), 5, 1, 3))
    walk = np.cumsum(np.sqrt(rate * FRAME_S) * steps, axis=0)
    return walk, walk + 20.0 * rng.standard_normal(walk.shape)


def by_least_squares(seen, time_s, used, rate):
    """Levels and their covariance from all frames at rest at once, without a filter."""
    prior = rate * np.minimum.outer(time_s, time_s) + 1e7
    rest = np.flatnonzero(used)
    gain = np.linalg.solve(prior[np.ix_(rest, rest)] + 400 * np.eye(len(rest)), prior[rest])
    mean = seen[rest].mean()
    return mean + gain.T @ (seen[rest] - mean), prior - prior[:, rest] @ gain


def test_levels_and_errors_are_those_of_least_squares_over_all_rests():
    time_s, loaded = stretch(4)
    _, counts = walking(time_s)
    found = followed(counts, time_s, loaded)
    near = np.convolve(loaded, np.ones(5), "same") > 0
    level, covariance = by_least_squares(counts[:, 2, 0, 1], time_s, ~near, found.drift_counts2_s)
    assert_allclose(found.counts[:, 2, 0, 1], level, atol=0.05)
    variance, memory = found.error.T
    assert_allclose(variance, np.diag(covariance), rtol=1e-3)
    later = np.maximum.outer(np.arange(len(time_s)), np.arange(len(time_s)))
    told = variance[later] * np.exp(-abs(memory[:, None] - memory))
    assert_allclose(told, covariance, atol=0.02)


def test_the_rate_of_the_drift_is_found_and_errors_are_as_large_as_they_say():
    time_s, loaded = stretch(100)
    walk, counts = walking(time_s)
    found = followed(counts, time_s, loaded)
    assert found.drift_counts2_s == pytest.approx(RATE, rel=0.25)
    off = np.mean((found.counts - walk)[loaded] ** 2)
    assert off == pytest.approx(found.error[loaded, 0].mean(), rel=0.25)
    loads = np.flatnonzero(loaded)
    presses = np.split(loads, np.flatnonzero(np.diff(loads) > 1) + 1)
    means = [counts[part[0] - 20 : part[0]].mean(axis=0) for part in presses]
    plain = np.mean([(mean - walk[part]) ** 2 for mean, part in zip(means, presses, strict=True)])
    assert off < 0.6 * plain


def test_steady_signals_are_averaged_over_half_a_minute():
    time_s, loaded = stretch()
    _, counts = walking(time_s, rate=0.0)
    found = followed(counts, time_s, loaded)
    assert found.counts[loaded].std() < 3.0
    assert found.drift_counts2_s <= 400 * FRAME_S / 20**2


@pytest.mark.parametrize("why", ["jump", "session"])
def test_nothing_is_carried_over_a_jump_or_a_new_mounting(why):
    time_s, loaded = stretch(4)
    second = np.arange(len(time_s)) >= 2 * (REST + LOADED)
    _, counts = walking(time_s)
    counts[:, 2, 0, 1] += np.where(second, 2000.0 if why == "jump" else 60.0, 0.0)
    session = second.astype(int) if why == "session" else None
    found = followed(counts, time_s, loaded, session)
    parts = [
        followed(counts[part], time_s[part], loaded[part]).counts[:, 2, 0, 1]
        for part in (~second, second)
    ]
    assert_allclose(found.counts[:, 2, 0, 1], np.concatenate(parts), atol=4.0)
    if why == "session":
        across = np.exp(found.error[~second, 1][-1] - found.error[second, 1][0])
        assert across < 1e-4


def test_a_noisy_load_cell_breaks_no_rest_up():
    time_s, loaded = stretch(100)
    walk, counts = walking(time_s)
    flickers = np.random.default_rng(1).random(len(time_s)) < 0.05
    found = followed(counts, time_s, loaded | flickers)
    assert found.drift_counts2_s == pytest.approx(RATE, rel=0.25)
    off = np.mean((found.counts - walk)[loaded] ** 2)
    assert off < 1.1 * np.mean((followed(counts, time_s, loaded).counts - walk)[loaded] ** 2)


def test_frames_beside_a_contact_are_not_taken_for_rest():
    time_s, loaded = stretch()
    touching = np.convolve(loaded, np.ones(3), "same") > 0
    _, counts = walking(time_s)
    counts[touching & ~loaded] += 500.0
    assert abs(followed(counts, time_s, loaded).counts).max() < 100


def test_gaps_dead_channels_and_single_presses_leave_no_gap():
    time_s, loaded = stretch(1)
    _, counts = walking(time_s)
    counts[5:9], counts[:, 0] = np.nan, np.nan
    found = followed(
        counts,
        time_s,
        loaded,
        noise=np.where(np.arange(5) > 0, 20.0, np.nan)[:, None, None] * np.ones((5, 1, 3)),
    )
    assert np.isfinite(found.counts).all()
    assert np.isfinite(found.error).all()


def test_three_loaded_frames_are_a_contact_and_two_beside_it_are_no_rest():
    loaded = np.zeros(20, bool)
    loaded[[2, 5, 6, 10, 11, 12]] = True
    assert np.flatnonzero(drift.contact_ranges(loaded)).tolist() == [10, 11, 12]
    assert np.flatnonzero(drift.rests_beside(drift.contact_ranges(loaded))).tolist() == list(
        range(8, 15)
    )


def rests(frames, seconds, lasts, levels, first):
    counts = np.array(levels)[:, None] * np.ones(3)
    return drift.RestFrames(
        counts, np.array(seconds), np.array(frames), np.array(lasts), np.array(first)
    )


def rate_of(*levels, apart_s=10.0, lasts_s=1.5, session=(0, 0), jump=False, frames=(10, 20)):
    found = rests(frames, [0.0, apart_s], [lasts_s] * 2, levels, [0, 50])
    of_frame = np.repeat(session, 50)
    jumps = np.full((1, 3), jump)
    return drift.drift_rate(found, of_frame, jumps, np.full(3, 20.0), 0.1)


def test_the_rate_of_two_rests_is_what_they_differ_by_beyond_noise_over_their_time():
    """White noise leaves 400 (1/10 + 1/20) of the squared difference; means lie a sixth of each
    rest's length nearer than their middles."""
    apart_s = 10.0 - (1.5 + 1.5) / 6
    assert rate_of(0.0, 30.0) == pytest.approx((900 - 60) / apart_s)
    assert rate_of(0.0, -30.0, apart_s=20.5) == pytest.approx((900 - 60) / 20.0)
    white = 400 * 0.1
    assert rate_of(0.0, 1.0) == pytest.approx(white / 30**2)
    assert rate_of(0.0, 60.0) == pytest.approx(white / 0.5**2)


@pytest.mark.parametrize(
    "unusable",
    [{"session": (0, 1)}, {"jump": True}, {"apart_s": 120.51}, {"apart_s": 0.4}],
)
def test_rests_that_tell_nothing_of_drift_leave_the_usual_rate(unusable):
    """Of other sessions, across a jump, two minutes apart, or one within the other."""
    assert rate_of(0.0, 30.0, **unusable) == pytest.approx(40 / 3.0**2)
    assert rate_of(0.0, 90.0, apart_s=120.5) == pytest.approx((8100 - 60) / 120)


def test_a_channel_that_differs_by_six_noises_has_not_jumped_and_by_more_it_has():
    found = rests([10, 10, 10], [0.0, 9.0, 18.0], [1.0] * 3, [0.0, 120.0, 240.1], [0, 50, 100])
    session = np.zeros(150, int)
    jumps = drift.channel_jumps(found, session, np.full(3, 20.0))
    assert jumps.tolist() == [[False] * 3, [True] * 3]
    session[100:] = 1
    assert not drift.channel_jumps(found, session, np.full(3, 20.0)).any()


def test_rests_are_the_stretches_of_five_frames_and_more_between_contacts():
    """Rest 0–9, contact, rest 13–16 (too short), contact, rest 20–29 without frame 24."""
    loaded = np.zeros(30, bool)
    loaded[10:13] = loaded[17:20] = True
    used = ~loaded
    used[24] = False
    flat = np.arange(30.0)[:, None] * [1, 10]
    flat[0, 1] = np.nan
    found = drift.rests_of(flat, 0.5 * np.arange(30), loaded, used)
    assert_allclose(found.counts, [[4.5, 50.0], [221 / 9, 2210 / 9]])
    assert_allclose(found.time_s, [2.25, 0.5 * 221 / 9])
    assert (found.frames.tolist(), found.lasts_s.tolist()) == ([10, 9], [4.5, 4.5])
    assert found.first.tolist() == [0, 20]


def test_a_rest_begins_behind_the_last_frame_of_contact_before_it():
    loaded = np.array([False, True, True, False, False, True, False])
    assert [drift.last_contact_before(loaded, before) for before in range(7)] == [
        -1,
        -1,
        1,
        2,
        2,
        2,
        5,
    ]


def test_a_level_between_two_readings_is_weighed_by_noise_and_drift():
    """Two readings of variance 4, ten frames of growth 1 between them, nothing known before.

    By Gauss: x0 and x10 each seen with variance 4, x10 − x0 of variance 10. The precision matrix is
    [[1/4 + 1/10, −1/10], [−1/10, 1/4 + 1/10]], its inverse has 3.111 on and 0.889 off the diagonal.
    """
    seen = np.full((11, 1), np.nan)
    seen[0], seen[10] = 0.0, 9.0
    grows = np.ones((11, 1))
    level, spread, memory = drift.smoothed_levels(seen, np.array([4.0]), grows)
    covariance = np.linalg.inv(np.array([[0.35, -0.1], [-0.1, 0.35]]))
    assert_allclose(level[[0, 10], 0], covariance @ [0, 9 / 4], rtol=1e-6)
    assert_allclose(spread[[0, 10], 0], np.diag(covariance), rtol=1e-6)
    assert_allclose(level[:, 0], np.linspace(level[0, 0], level[10, 0], 11), rtol=1e-6)
    assert_allclose(spread[10] * np.exp(memory[0] - memory[10]), covariance[0, 1], rtol=1e-6)
    assert memory[0] == 0
