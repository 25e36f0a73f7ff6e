"""Means of holds against a loop over frames; chosen frames are valid and in order."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from estimator.frames.windows import all_counts, chosen_rows, window_means
from tests.support.recordings.synthetic_frames import synthetic_frames


def some_frames():
    frames = synthetic_frames(presses=2, rest=2, loaded=3)
    rng = np.random.default_rng(0)
    counts = rng.normal(size=frames.signal_counts.shape)
    counts[7, 0, 0, 0] = np.nan
    return replace(frames, signal_counts=counts, valid=rng.random(len(frames)) > 0.3)


def test_a_window_holds_the_frames_of_the_same_press_alone():
    frames = some_frames()
    counts = all_counts(frames)
    assert counts.shape == (len(frames), frames.signal_counts[0].size)
    for most in (1, 2, 4, 1000):
        means, number = window_means(frames, most)
        for row in range(len(frames)):
            first = row
            while (
                first > 0
                and row - first + 1 < most
                and frames.press_id[first - 1] == frames.press_id[row]
            ):
                first -= 1
            assert number[row] == row - first + 1
            assert_allclose(means[row], counts[first : row + 1].mean(axis=0), atol=1e-12)


def test_so_many_valid_frames_are_chosen_in_order_and_repeatably():
    frames = some_frames()
    valid = np.flatnonzero(frames.valid)
    assert_array_equal(chosen_rows(frames, len(valid)), valid)
    few = chosen_rows(frames, 10, seed=3)
    assert len(np.unique(few)) == len(few) == 10
    assert np.isin(few, valid).all()
    assert (np.diff(few) > 0).all()
    assert_array_equal(few, chosen_rows(frames, 10, seed=3))
    assert (few != chosen_rows(frames, 10, seed=4)).any()
    assert (few != valid[:10]).any()
