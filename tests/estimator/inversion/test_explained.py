"""p values: even for an exact object and for one that is not the drawing, small where nothing explains."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import kstest

from estimator.inversion.explained import ErrorShare
from estimator.inversion.problems import Observations
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import contacts, expected_counts, inverted, noisy_counts

BELIEVED = 0.17


def doubting():
    """A reader that believes its model wrong by 17 % of the signals."""
    told = replace(inverted().disturbances, model_error=np.full(45, BELIEVED))
    return replace(inverted(), disturbances=told)


def frames_of(number, error, seed, frames=120):
    """Frames of contacts whose signals are wrong by a share of what each chip shows."""
    rng = np.random.default_rng(seed)
    face, contact = contacts(rng, frames, number)
    counts = noisy_counts(inverted(), face, contact, rng)
    change = expected_counts(inverted().model, face, contact).reshape(frames, 15, 3)
    size = np.linalg.norm(change, axis=2, keepdims=True) / np.sqrt(3)
    wrong = error * (size * rng.standard_normal(change.shape)).reshape(frames, 45)
    return counts + wrong


@pytest.mark.parametrize(("number", "error"), [(1, 0.06), (2, 0.0), (3, 0.06)])
def test_p_values_are_even_whatever_share_of_the_error_is_there(number, error):
    found, _ = doubting().read(frames_of(number, error, number))
    assert 0.4 < np.median(found.p_value) < 0.6
    assert kstest(found.p_value, "uniform").pvalue > 1e-3
    assert found.explained.mean() > 0.97


def test_few_frames_keep_the_whole_error():
    reader = doubting()
    counts = frames_of(2, 0.0, 7, 19)
    alone = np.concatenate([reader.read(one[None])[0].p_value for one in counts])
    assert_allclose(reader.read(counts)[0].p_value, alone, rtol=1e-3, atol=1e-6)
    assert np.median(alone) > 0.7, "else nothing is to be learnt"


def test_an_error_beyond_the_believed_one_explains_nothing():
    """Signals are wrong by twice their size; it is not learnt away: no share exceeds the whole."""
    found, _ = doubting().read(frames_of(1, 2.0, 8, 8))
    assert np.median(found.p_value) < 1e-3


def test_what_disturbs_some_frames_is_not_learnt_from_them():
    counts = frames_of(1, 0.0, 9, 60)
    counts[::6, 10:13] += 600.0
    found, _ = doubting().read(counts)
    sound = np.ones(len(counts), bool)
    sound[::6] = False
    assert found.explained[sound].mean() > 0.97
    assert found.explained[~sound].mean() < 0.2


def test_a_tracker_learns_as_it_goes():
    """One long press: p values crowd high until twenty pressed frames were learnt from."""
    face, contact = np.full((160, 6), -1), np.zeros((160, 6, 3))
    face[:, 0], contact[:, 0] = 2, [3.0, -4.0, 7.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(3), turned=False)
    tracker = Tracker(doubting())
    p = np.array([tracker.feed(one).p_value[0] for one in counts])
    assert np.median(p[:90]) > 0.75
    assert 0.3 < np.median(p[110:]) < 0.7


def test_a_share_is_where_half_of_the_p_values_are_above_a_half():
    share = ErrorShare(inverted().model, inverted().priors)
    assert share.share == 1.0
    share.p_values.extend(np.tile([0.1, 0.2, 0.4, 0.6, 0.8, 0.9, 1.0], (30, 1)))
    assert share.share == pytest.approx((0.2 + 0.35) / 2)
    share.p_values.extend(np.full((100, 7), 0.7))
    assert share.share == 0.0
    share.p_values.extend(np.full((100, 7), 0.2))
    assert share.share == 1.0


def test_a_share_of_the_error_widens_frames_by_its_square():
    still, strict = np.full((1, 3), 3.0), np.full((1, 3), 5.0)
    seen = Observations(np.zeros((1, 3)), 2 * strict, still, strict)
    assert_allclose(seen.with_error_share(0.5).sigma, np.sqrt(9 + 16 / 4))
    assert_allclose(seen.with_error_share(1.0).sigma, strict)
    assert_allclose(seen.with_error_share(0.0).sigma, still)
