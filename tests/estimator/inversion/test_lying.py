"""Chips that lie: found by the frames that nothing else explains."""

import numpy as np
import pytest

from estimator.inversion.model.forward import NONE
from estimator.inversion.tracking import Tracker
from estimator.signals.presses import rest_counts
from tests.support.mechanics.inverted import SPEC, contacts, inverted, noisy_counts

FRAMES = 8
RESTING = rest_counts(SPEC).ravel()
SATURATED = 32767 - RESTING


@pytest.fixture(scope="module")
def pressed():
    rng = np.random.default_rng(1)
    face, contact = contacts(rng, FRAMES, 1)
    return face, contact, noisy_counts(inverted(), face, contact, rng)


def test_one_chip_that_lies_is_left_out_and_the_press_is_read(pressed):
    face, contact, counts = pressed
    channel = int(np.argmax(np.abs(RESTING)))
    wrong = counts.copy()
    wrong[:, channel] = -RESTING[channel]
    found, _ = inverted().read(wrong)
    assert np.mean(found.chip_out == channel // 3) >= 0.9
    assert found.explained.mean() >= 0.9
    right = (found.number == 1) & (found.face[:, 0] == face[:, 0] + 1)
    assert right.mean() >= 0.75
    away = np.linalg.norm(found.xy_mm[right, 0] - contact[right, 0, :2], axis=1)
    assert np.median(away) < 0.8


def test_sound_frames_keep_all_chips(pressed):
    found, second = inverted().read(pressed[2])
    assert (found.chip_out == NONE).all()
    assert (second.chip_out == NONE).all()


def test_sound_frames_beside_wrong_ones_keep_all_chips(pressed):
    counts = pressed[2].copy()
    counts[::4, 16] = SATURATED[16]
    found, _ = inverted().read(counts)
    wrong = np.arange(FRAMES) % 4 == 0
    assert (found.chip_out[~wrong] == NONE).all()
    assert (found.chip_out[wrong] == 5).all()


def test_a_tracker_leaves_a_lying_chip_out_at_once():
    """0.2 s at 10 frames a second, and goes on reading the press."""
    face, contact = np.full((16, 6), NONE), np.zeros((16, 6, 3))
    face[3:, 0], contact[3:, 0] = 2, [3.0, -4.0, 7.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(4), turned=False)
    counts[8:, 20] = SATURATED[20]
    tracker = Tracker(inverted())
    followed = [tracker.feed(one) for one in counts]
    assert [int(one.chip_out[0]) for one in followed] == [NONE] * 8 + [6] * 8
    assert all(one.explained[0] and one.number[0] == 1 for one in followed[8:])
    assert np.linalg.norm(followed[-1].xy_mm[0, 0] - contact[-1, 0, :2]) < 1.5


def test_a_tracker_believes_the_chip_again_when_another_lies():
    """Frames without the first are explained no more: the second is looked for among all."""
    face, contact = np.full((24, 6), NONE), np.zeros((24, 6, 3))
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(5), turned=False)
    counts[2:10, 20] = SATURATED[20]
    counts[12:, 31] = SATURATED[31]
    tracker = Tracker(inverted())
    out = [int(tracker.feed(one).chip_out[0]) for one in counts]
    assert out[5] == 6
    assert out[-1] == 10


def test_one_wrong_reading_costs_one_frame_its_chip_and_no_contact():
    """A frame later the chip agrees again; after eight such frames it is believed."""
    face, contact = np.full((30, 6), NONE), np.zeros((30, 6, 3))
    face[:, 0], contact[:, 0] = 2, [3.0, -4.0, 7.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(6), turned=False)
    counts[12, 20] += 4096
    tracker = Tracker(inverted())
    followed = [tracker.feed(one) for one in counts]
    out = [int(one.chip_out[0]) for one in followed]
    assert out[:12] == [NONE] * 12
    assert out[12] == 6
    assert out[22:] == [NONE] * 8
    assert all(one.explained[0] and one.number[0] == 1 for one in followed[2:])


def test_regions_of_frames_that_nothing_explains_are_as_wide_as_their_misfit():
    face, contact = contacts(np.random.default_rng(8), 3, 1, (5.0, 8.0))
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(9))
    sound, _ = inverted().read(counts)
    wrong = counts + np.random.default_rng(10).normal(0, 300, counts.shape)
    found, _ = inverted().read(wrong)
    assert not found.explained.any()
    assert np.nanmedian(found.position_radius_mm) > 3 * np.nanmedian(sound.position_radius_mm)
