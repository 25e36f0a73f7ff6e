"""Drift while contacts are held, told apart from what the contacts change by."""

import numpy as np
import pytest

from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.holds import HeldDrift
from tests.support.mechanics.inverted import SPEC, contacts, inverted, motion_of
from tests.support.turned_frames import magnets_field_t, read_out

RATE, NOISE = 4.0, 20.0
"""Drift of 60 counts in 15 minutes (counts²/s), and noise of a frame (counts)."""
PATTERN = np.random.default_rng(0).standard_normal((3, 30))
"""Counts by what a contact may change."""


def followed(force, rng, step_s=1.0):
    """Drift found (frame, channel) and drift that is, under a pattern of so many counts at each time; and
    whether it was taken for steady in the end."""
    along = 100 * PATTERN[0] / np.linalg.norm(PATTERN[0])
    walk = np.cumsum(np.sqrt(RATE * step_s) * rng.standard_normal((len(force), 30)), axis=0)
    held = HeldDrift(NOISE**2 * np.eye(30), RATE, unknown_counts2=0.0)
    held.begin(np.array([3]), along, 8, PATTERN)
    zero, zeros = np.zeros(30), []
    for drift, factor in zip(walk, force, strict=True):
        raw = drift + factor * along + NOISE * rng.standard_normal(30)
        held.drift_for(step_s)
        if held.is_of(np.array([3])):
            zero = zero + held.follow(raw - zero)
        zeros.append(zero)
    return np.array(zeros), walk, held


def test_half_an_hour_of_drift_is_followed_and_its_error_known():
    zeros, walk, held = followed(np.ones(1800), np.random.default_rng(1))
    error = (zeros - walk)[-300:]
    assert held.steady
    assert np.sqrt(np.mean(walk[-1] ** 2)) > 60
    assert np.sqrt(np.mean(error**2)) == pytest.approx(np.sqrt(held.unknown_counts2), rel=0.25)


@pytest.mark.parametrize(("seconds", "share"), [(1, 0.8), (20, 0.8), (200, 2.5)])
def test_what_grows_along_the_contact_s_pattern_is_no_drift(seconds, share):
    """Force or creep by that share of the press, seven times what drift does along it within so long."""
    ramp = 1 + share * np.clip((np.arange(400) - 60) / seconds, 0, 1)
    zeros, walk, held = followed(ramp, np.random.default_rng(seconds))
    assert not held.steady
    along = (zeros - walk)[-1] @ PATTERN[0] / np.linalg.norm(PATTERN[0])
    assert abs(along) < 0.5 * 100 * share


def test_frames_misread_now_and_then_end_no_hold():
    _, _, held = followed(np.ones(20), np.random.default_rng(2))
    assert not any(held.is_of(np.array([3, 4])) for _ in range(10))
    assert held.is_of(np.array([3]))
    assert not any(held.is_of(np.array([3, 4])) for _ in range(11))
    assert not held.steady


@pytest.mark.parametrize("number", [1, 2])
def test_a_hold_of_drifting_channels_keeps_its_force_and_is_explained(number):
    """Ten minutes of the second forward model's frames, up to four seconds apart; then it is let go."""
    rng = np.random.default_rng(50 + number)
    force_n = contacts(rng, 1, number, (6.0, 6.0))
    motion = np.stack([np.zeros((25, 6)), motion_of(*force_n)[0]])
    pressed = np.repeat([0, 1, 0], [25, 185, 15])
    step_s = np.repeat([0.4, 4.0], [75, 150])
    drift = np.cumsum(2.0 * np.sqrt(step_s)[:, None] * rng.standard_normal((225, 45)), axis=0)
    raw = read_out(SPEC, magnets_field_t(SPEC, motion)[pressed], rng) + np.round(drift)
    reader = LiveContacts(inverted())
    found = [
        reader.feed(row.reshape(5, 3, 3), at)
        for at, row in zip(np.cumsum(step_s).tolist(), raw, strict=True)
    ]
    read = np.array([0 if one is None else np.nansum(one.force_n) for one in found])
    early, late = read[30:70], read[170:210]
    assert abs(late.mean() / early.mean() - 1) < 0.05
    assert all(one.explained[0] for one in found[26:])
    assert np.mean([one.number[0] == number for one in found[170:210]]) > 0.95
    # that the force stayed is believed, not seen: its interval holds what drift may have hidden
    assert np.nanmin(found[205].force_halfwidth_n) > 1.5 * np.nanmin(found[30].force_halfwidth_n)
    assert found[-1].number[0] == 0
