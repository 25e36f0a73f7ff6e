"""Slip in raw channels, on grasp-and-pull recordings by a model of their own (`pulled`).

The published recordings of eFlesh, 137 grasps that are pulled, were not at hand: as many are simulated.
"""

from functools import lru_cache

import numpy as np
import pytest
from scipy.stats import binomtest

from estimator.grasps.channel_slip import slips_in_channels
from tests.support.mechanics.inverted import inverted, noisy_counts
from tests.support.recordings.pulled import FRAMES, RATE_HZ, pulled

RECORDINGS, FIRST_SEED = 137, 5000
TIME_S = np.arange(FRAMES) / RATE_HZ


@lru_cache(maxsize=1)
def judged():
    """Recordings and the one hold of each."""
    recordings = [pulled(FIRST_SEED + number) for number in range(RECORDINGS)]
    holds = [slips_in_channels(recording.values, TIME_S) for recording in recordings]
    assert all(len(hold) == 1 for hold in holds)
    return recordings, [hold[0] for hold in holds]


def truth_and_bends():
    recordings, holds = judged()
    return np.array([r.slipped for r in recordings]), np.array([hold.bend for hold in holds])


def left_out_accuracy(slipped, bend):
    """Share judged right by the limit that separates all other recordings best."""
    right = []
    for number in range(len(bend)):
        others = np.arange(len(bend)) != number
        limits = np.sort(bend[others])
        limits = (limits[1:] + limits[:-1]) / 2
        agree = np.mean((bend[others] > limits[:, None]) == slipped[others], axis=1)
        # of equally good limits the middle one
        best = np.median(limits[agree == agree.max()])
        right.append((bend[number] > best) == slipped[number])
    return np.array(right)


def test_slips_are_told_from_pulls_that_stick_with_each_sequence_left_out():
    right = left_out_accuracy(*truth_and_bends())
    low, _ = binomtest(int(right.sum()), len(right)).proportion_ci(0.95)
    assert right.mean() >= 0.95
    assert low >= 0.9


def test_the_shipped_limit_calls_few_pulls_a_slip():
    slipped, bend = truth_and_bends()
    assert np.mean(bend[~slipped] > 1) <= 0.05
    assert np.mean(bend[slipped] > 1) >= 0.9


def test_exchanged_labels_are_not_learnt():
    """The baseline without the channels is the larger class."""
    slipped, bend = truth_and_bends()
    rng = np.random.default_rng(1)
    null = [left_out_accuracy(rng.permutation(slipped), bend).mean() for _ in range(20)]
    assert np.mean(null) <= max(slipped.mean(), 1 - slipped.mean()) + 0.02
    assert max(null) < 0.75


def test_onsets_are_within_a_tenth_of_a_second():
    recordings, holds = judged()
    late = np.array([
        hold.onset / RATE_HZ - recording.onset_s
        for recording, hold in zip(recordings, holds, strict=True)
        if recording.slipped and hold.slipped
    ])  # fmt: skip
    assert np.median(abs(late)) <= 0.03
    assert np.mean(abs(late) <= 0.1) >= 0.8


def test_units_offsets_and_order_of_channels_do_not_matter():
    recording = pulled(FIRST_SEED)
    (plain,) = slips_in_channels(recording.values, TIME_S)
    scale = np.random.default_rng(2).uniform(0.1, 50, 15)
    (scaled,) = slips_in_channels((recording.values * scale + 1e3)[:, ::-1], TIME_S)
    assert scaled.bend == pytest.approx(plain.bend, rel=1e-6)
    assert (scaled.start, scaled.end) == (plain.start, plain.end)


def test_many_channels_of_noise_are_no_slip():
    """Thirty chips that do not answer beside five that do, and a hold cut short."""
    rng, slipped = np.random.default_rng(4), []
    for seed in range(30):
        values = pulled(FIRST_SEED + seed, slips=False).values
        values = np.hstack([values, rng.normal(0, 1, (FRAMES, 90))])
        for last in (FRAMES, 78):
            slipped += [hold.slipped for hold in slips_in_channels(values[:last], TIME_S[:last])]
    assert len(slipped) == 60
    assert np.mean(slipped) <= 0.05


def test_nothing_is_found_at_rest_and_nothing_said_of_a_touch():
    rng = np.random.default_rng(3)
    rest = rng.normal(0, 1, (FRAMES, 15))
    assert slips_in_channels(rest, TIME_S) == []
    assert slips_in_channels(rest[:30], TIME_S[:30]) == []
    assert slips_in_channels(np.full((FRAMES, 15), np.nan), TIME_S) == []
    rest[60:75] += 40
    (touch,) = slips_in_channels(rest, TIME_S)
    assert np.isnan(touch.bend)
    assert not touch.slipped


def test_jaws_of_another_object_that_only_squeeze_do_not_slip():
    """Five faces of analytic presses, forces that swing by 2 %."""
    estimator, slipped = inverted(), []
    for seed in range(40):
        rng = np.random.default_rng([seed, 3])
        frame = np.arange(90)
        force = rng.uniform(3, 6) * np.interp(frame, [0, 22, 32, 82, 88], [0, 0, 1, 1, 0])
        force *= 1 + 0.02 * np.sin(frame / rng.uniform(2, 8))
        face, contact = np.full((90, 6), -1), np.zeros((90, 6, 3))
        place = rng.uniform(-6, 6, 2)
        for slot, (row, side) in enumerate(((2, 1), (4, -1))):
            face[:, slot] = np.where(force > 0, row, -1)
            contact[:, slot, :2] = place * [1, side]
            contact[:, slot, 2] = force
        counts = noisy_counts(estimator, face, contact, rng, turned=False).reshape(90, -1)
        slipped += [hold.slipped for hold in slips_in_channels(counts, frame / 10.5)]
    assert len(slipped) >= 30  # the weakest squeezes at the edges hardly leave the noise
    assert np.mean(slipped) <= 0.05
