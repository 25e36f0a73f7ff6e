"""An object that is zeroed, turned in Earth's field and pressed, by a second forward model."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import SPEC, contacts, inverted, motion_of, right
from tests.support.turned_frames import earth_fields_t, expected_counts, zeroed_counts

FRAMES = 60


@pytest.fixture(scope="module")
def pressed():
    """For each number of contacts: faces, contacts and motions."""
    found = {}
    for number in (0, 1, 2):
        rng = np.random.default_rng(number)
        face, contact = contacts(rng, FRAMES, number) if number else nothing(FRAMES)
        found[number] = face, contact, motion_of(face, contact)
    return found


def nothing(frames):
    return np.full((frames, 6), -1), np.zeros((frames, 6, 3))


def still_reader():
    """That takes every change for contacts, as one of an object on a bench."""
    told = replace(inverted().disturbances, nuisances=())
    return replace(inverted(), disturbances=told)


def troubled(found):
    """Frames in which contacts are read, or that nothing explains."""
    return (found.number > 0) | ~found.explained


def test_turning_at_rest_is_no_contact(pressed):
    counts = zeroed_counts(SPEC, pressed[0][2], np.random.default_rng(5))
    assert np.mean(troubled(still_reader().read(counts)[0])) > 0.5, "else turning is no trouble"
    found, _ = inverted().read(counts)
    assert np.mean(found.number > 0) <= 0.02
    assert found.explained.all()


@pytest.mark.parametrize("number", [1, 2])
def test_contacts_of_a_turned_object_are_read_as_those_of_one_that_stands_still(number, pressed):
    """The number as often within a few frames, as near, in regions as true."""
    face, contact, motion = pressed[number]
    share, away = [], []
    for reader, turned in ((still_reader(), False), (inverted(), True)):
        found, _ = reader.read(zeroed_counts(SPEC, motion, np.random.default_rng(6), turned))
        fine = right(found, face)
        share.append(fine.mean())
        one = fine & (number == 1)
        distance = np.linalg.norm(found.xy_mm[one, 0] - contact[one, 0, :2], axis=1)
        away.append(distance)
        assert np.mean(found.explained) > 0.95
        if number == 1:
            assert np.mean(distance <= found.position_radius_mm[one, 0]) > 0.75
    assert share[0] > 0.75
    # the difference of two shares of 60 frames scatters by 0.05
    assert share[1] > share[0] - 0.1
    if number == 1:
        assert np.median(away[1]) < 1.3 * np.median(away[0])


def test_a_tracked_object_that_is_turned_slowly_holds_nothing():
    """Half a turn in 30 frames, about a zero that was taken before."""
    rng = np.random.default_rng(7)
    angle = np.linspace(0, np.pi, 30)
    north = 50e-6 * np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
    change = expected_counts(SPEC, np.repeat((north - north[0])[:, None], 15, axis=1))
    noise = np.resize(SPEC.sensors.noise_counts, 45) * rng.standard_normal(change.shape)
    turned, seen_still = Tracker(inverted()), Tracker(still_reader())
    counts = np.round(change + noise)
    assert not any(troubled(turned.feed(one))[0] for one in counts)
    assert sum(troubled(seen_still.feed(one))[0] for one in counts) > 10


@pytest.mark.parametrize("number", [0, 1])
def test_the_change_of_the_field_is_told_with_its_deviation(number, pressed):
    """In µT along the object's axes, beside the true one; temperature stays what it was."""
    face, _, motion = pressed[number]
    rng = np.random.default_rng(9)
    before, now = earth_fields_t(np.random.default_rng(9), FRAMES)
    found, _ = inverted().read(zeroed_counts(SPEC, motion, rng))
    fine = right(found, face)
    error_ut = (found.since_zero[:, :3] - 1e6 * (now - before))[fine]
    sigma_ut = found.since_zero_sigma[fine, :3]
    assert sigma_ut.max() < 20.0, "a quarter of the largest change, or the test tells nothing"
    assert 0.8 < np.sqrt(np.mean((error_ut / sigma_ut) ** 2)) < 1.2
    assert np.corrcoef(found.since_zero[fine, 0], (now - before)[fine, 0])[0, 1] > 0.95
    kelvin = found.since_zero[fine, 3] / found.since_zero_sigma[fine, 3]
    assert np.sqrt(np.mean(kelvin**2)) < 1.2
    assert still_reader().read(np.zeros((1, 45)))[0].since_zero.shape == (1, 0)


@pytest.mark.parametrize("number", [0, 1])
def test_the_direction_of_the_field_follows_to_its_interval(number, pressed):
    """From a field that is known at the zero: √χ²(2 degrees of freedom, 90 %) = 2.15 deviations."""
    face, _, motion = pressed[number]
    before, now = earth_fields_t(np.random.default_rng(12), FRAMES)
    counts = zeroed_counts(SPEC, motion, np.random.default_rng(12))
    contacts, _ = inverted().read(counts)
    read_ut = 1e6 * before + contacts.since_zero[:, :3]
    cosine = (read_ut * now).sum(axis=1)
    cosine /= np.linalg.norm(read_ut, axis=1) * np.linalg.norm(now, axis=1)
    fine = right(contacts, face)
    off_rad = np.arccos(np.clip(cosine, -1, 1))[fine]
    interval_rad = 2.15 * contacts.since_zero_sigma[fine, :3].max(axis=1) / 50.0
    # nine tenths of 60 scatter by 0.04
    assert 0.8 <= np.mean(off_rad <= interval_rad) <= 1.0
    assert np.median(np.degrees(off_rad)) < 15.0


def test_both_orientations_are_anywhere():
    before, now = earth_fields_t(np.random.default_rng(8), 4000)
    assert_allclose(np.linalg.norm(before, axis=1), 50e-6)
    assert_allclose((now - before).std(axis=0), 50e-6 * np.sqrt(2 / 3), rtol=0.05)
