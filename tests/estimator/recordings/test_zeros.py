"""Zeros of presses, and the drift between them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.recordings.zeros import rest_levels

REST, LOADED, PRESSES = 25, 30, 4
NOISE = np.full((5, 1, 3), 20.0)


def stretch(gap_s=0.0):
    """Presses of 30 loaded frames behind 25 at rest, 10 a second: times, presses, and what is loaded."""
    loaded = np.tile(np.repeat([False, True], [REST, LOADED]), PRESSES)
    press = np.repeat(np.arange(PRESSES), REST + LOADED)
    return np.arange(len(press)) / 10 + gap_s * press, press, loaded


def bridged(counts, time_s, press, loaded, session=None):
    zeros = rest_levels(counts, time_s, press, loaded, ~loaded)
    session = np.zeros(len(press), int) if session is None else session
    return zeros, *zeros.bridged(press, time_s, session, NOISE)


def in_channel(values):
    """As counts of one channel, others 0."""
    counts = np.zeros((len(values), 5, 1, 3))
    counts[:, 2, 0, 1] = values
    return counts


def test_steady_drift_is_taken_off_between_two_zeros():
    time_s, press, loaded = stretch()
    drift = in_channel(3.0 * time_s)
    zeros, found, span_s = bridged(drift, time_s, press, loaded)
    before_last = press < PRESSES - 1
    left = (drift - found)[loaded & before_last]
    assert_allclose(left, 0, atol=1e-9)
    assert_allclose((drift - zeros.of_frames(press))[loaded][:, 2, 0, 1].max(), 3 * 3.95, rtol=1e-6)
    assert_allclose(
        span_s[:, 0][before_last], time_s[before_last] - 5.5 * press[before_last] - 1.45
    )
    assert_allclose(span_s[:, 1], np.where(before_last, 5.5, np.inf))
    assert_allclose(found[press == PRESSES - 1], zeros.of_frames(press)[press == PRESSES - 1])


@pytest.mark.parametrize("why", ["jump", "session", "pause"])
def test_no_drift_is_spread_over_a_jump_a_new_mounting_or_a_pause(why):
    time_s, press, loaded = stretch(gap_s=200.0 if why == "pause" else 0.0)
    step = in_channel(np.where(press >= 2, 300.0 if why == "jump" else 60.0, 0.0))
    session = np.where(press >= 2, 1, 0) if why == "session" else None
    zeros, found, span_s = bridged(step, time_s, press, loaded, session)
    assert_allclose(found, zeros.of_frames(press))
    assert np.isinf(span_s[press == 1, 1]).all() == (why != "jump")


def test_zeros_from_behind_their_press_are_not_bridged():
    time_s, press, loaded = stretch()
    loaded[: REST - 2] = True  # the first press has no rest before it
    zeros, found, span_s = bridged(in_channel(3.0 * time_s), time_s, press, loaded)
    assert zeros.before.tolist() == [False, True, True, True]
    assert_allclose(found[press == 0], zeros.of_frames(press)[press == 0])
    assert np.isinf(span_s[press == 0, 1]).all()
