"""Chosen frames are valid and in order."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_array_equal

from estimator.frames.windows import chosen_rows
from tests.support.recordings.synthetic_frames import synthetic_frames


def some_frames():
    frames = synthetic_frames(presses=2, rest=2, loaded=3)
    return replace(frames, valid=np.random.default_rng(0).random(len(frames)) > 0.3)


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
