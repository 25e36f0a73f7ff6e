"""Slips of the core, by a second forward model: noticed at rest, carried over, and not seen without one."""

import numpy as np
import pytest

from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.slip import REST_FRAMES, slip_at_rest
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import SPEC, contacts, inverted, motion_of, right
from tests.support.slipped_core import GRASP, grasps, resting_mean, shift, zeroed
from tests.support.turned_frames import foreign_magnets_t


@pytest.mark.parametrize("mm", [0.05, 0.4])
def test_presses_on_a_slipped_core_are_read_once_rest_has_shown_the_slip(mm):
    """Single presses of 4 to 8 N at 0.05 mm are believed wrong in a quarter of the frames otherwise."""
    rng = np.random.default_rng(3)
    raw, face = grasps(rng, mm)
    tracker, good = Tracker(inverted()), []
    for number, change in enumerate(zeroed(raw, rng)):
        reading = tracker.feed(change)
        if number >= REST_FRAMES:
            good.append(reading.explained[0] and right(reading, face[number : number + 1])[0])
        else:
            assert tracker.slip is None or number == REST_FRAMES - 1
    assert tracker.slip.size_mm == pytest.approx(mm, abs=0.015)
    assert np.mean(good) >= 0.97


@pytest.mark.parametrize("zero", ["rest", "first"])
def test_a_slip_within_a_grasp_is_noticed_in_the_rest_after_it(zero):
    rng = np.random.default_rng(5)
    slips_at = 2 * GRASP + 4
    raw, face = grasps(rng, 0.1, slips_at)
    reader = LiveContacts(inverted(), zero, 8)
    good = []
    for number, counts in enumerate(raw):
        reading = reader.feed(counts.reshape(5, 3, 3), number / 10)
        if number == slips_at - 1:
            assert reader.slip is None
        if number > slips_at + 16:
            assert reader.slip.size_mm == pytest.approx(0.1, abs=0.015)
            good.append(reading.explained[0] and right(reading, face[number : number + 1])[0])
    assert np.mean(good) >= 0.97
    reader.rezero()
    assert reader.condition().name == "recalibrate", "a new zero is no calibration"


def test_a_second_slip_adds_to_the_first():
    rng = np.random.default_rng(8)
    first, second = shift(rng, 0.1), shift(rng, 0.08)
    slip = slip_at_rest(inverted(), resting_mean(rng, first), REST_FRAMES)
    both = slip_at_rest(inverted(), resting_mean(rng, first + second), REST_FRAMES, 0.0, slip)
    assert both.size_mm == pytest.approx(np.linalg.norm((first + second)[:3]), abs=0.02)


def test_rest_a_press_that_is_not_quite_gone_and_a_magnet_are_no_slip():
    rng = np.random.default_rng(9)
    for _ in range(20):
        leftover = 0.05 * motion_of(*contacts(rng, 1, 2, (4.0, 12.0)))
        magnet_t = foreign_magnets_t(SPEC, rng, 1, rng.uniform(50, 120), 0.4)
        assert slip_at_rest(inverted(), resting_mean(rng), REST_FRAMES) is None
        assert slip_at_rest(inverted(), resting_mean(rng, leftover), REST_FRAMES) is None
        assert slip_at_rest(inverted(), resting_mean(rng, None, magnet_t), REST_FRAMES) is None


def test_channels_without_readings_say_nothing_of_a_slip():
    rng = np.random.default_rng(10)
    mean = resting_mean(rng, shift(rng, 0.1))
    mean[:6] = np.nan
    assert slip_at_rest(inverted(), mean, REST_FRAMES).size_mm == pytest.approx(0.1, abs=0.02)


def test_nine_readings_tell_nothing_of_a_slip():
    """Six unknowns, the field's three and a temperature explain any nine."""
    rng = np.random.default_rng(11)
    mean = resting_mean(rng, shift(rng, 0.1))
    mean[9:] = np.nan
    assert slip_at_rest(inverted(), mean, REST_FRAMES) is None


def test_presses_that_nothing_explains_are_no_slip():
    """Every magnet moves by 40 % more or less than the model says, under one to four tips."""
    rng = np.random.default_rng(12)
    for number in (1, 2, 3, 4) * 8:
        motion = motion_of(*contacts(rng, 1, number, (2.0, 12.0)))
        motion = motion * (1 + 0.4 * rng.standard_normal((1, 25, 1)))
        assert slip_at_rest(inverted(), resting_mean(rng, motion), REST_FRAMES) is None
