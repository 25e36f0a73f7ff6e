"""Drift while contacts are held, apart from what the contacts change by."""

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


def followed(force, rng, step_s=1.0, before_s=0, missing=slice(0)):
    """Drift that was followed (frame, channel) and drift that is, under a pattern of so many counts at each
    time; and whether it was taken for steady in the end. Contacts changed for some time `before_s`; the first
    channel has no reading in the frames `missing`."""
    pattern_counts = 100 * PATTERN[0] / np.linalg.norm(PATTERN[0])
    held = HeldDrift(NOISE**2 * np.eye(30), RATE)
    for second in range(before_s):
        held.drift_for(1.0)
        assert not held.is_of(np.array([1 + second // 2 % 2]))
    earlier_drift = np.sqrt(RATE * before_s) * rng.standard_normal(30)
    steps = np.sqrt(RATE * step_s) * rng.standard_normal((len(force), 30))
    walk = earlier_drift + np.cumsum(steps, axis=0)
    held.begin(np.array([3]), pattern_counts + earlier_drift, 8, PATTERN)
    zero, zeros = np.zeros(30), []
    for number, (drift, factor) in enumerate(zip(walk, force, strict=True)):
        raw = drift + factor * pattern_counts + NOISE * rng.standard_normal(30)
        if number in range(len(force))[missing]:
            raw[0] = np.nan
        held.drift_for(step_s)
        if held.is_of(np.array([3])):
            zero = zero + held.follow(raw - zero)
        zeros.append(zero)
    return np.array(zeros), walk, held


@pytest.mark.parametrize("before_s", [0, 240])
def test_half_an_hour_of_drift_is_followed_and_its_error_known(before_s):
    """Also where contacts changed for minutes first: what drifted then is within what is held."""
    zeros, walk, held = followed(np.ones(1800), np.random.default_rng(1), before_s=before_s)
    error = (zeros - walk)[-300:]
    assert held.steady
    assert np.sqrt(np.mean((walk[-1] - walk[0]) ** 2)) > 60
    assert np.sqrt(np.mean(error**2)) == pytest.approx(np.sqrt(held.unknown_counts2), rel=0.25)


@pytest.mark.parametrize("rate", [0.0, RATE])
def test_nothing_is_known_after_a_pause_even_where_nothing_drifts(rate):
    held = HeldDrift(np.eye(30), rate)
    held.drift_for(2.0)
    assert held.unknown_counts2 == 2 * rate
    held.begin(np.array([3]), PATTERN[0], 8, PATTERN)
    held.drift_for(np.inf)
    assert held.unknown_counts2 == np.inf
    assert not held.steady
    held.begin(np.array([3]), PATTERN[0], 8, PATTERN)
    held.drift_for(1.0)
    assert np.isfinite(held.follow(PATTERN[0])).all()


def test_a_channel_without_a_reading_is_followed_at_once_when_it_is_back():
    """Its drift of 300 s, some 35 counts, stays unknown meanwhile, and the zero takes it up in ten frames."""
    left = []
    for seed in range(20):
        zeros, walk, held = followed(
            np.ones(340), np.random.default_rng(seed), missing=slice(20, 330)
        )
        assert held.steady
        assert held.unknown_counts2 < 150
        left.append((zeros - walk)[[329, 335], 0])
    before, after = np.sqrt(np.mean(np.square(left), axis=0))
    assert before > 25
    assert after < 16


@pytest.mark.parametrize("other", [False, True])
def test_a_contact_that_jumps_ends_the_hold_and_is_no_drift(other):
    """Eight times the noise in every channel, in directions that the contact's patterns do not hold."""
    rng = np.random.default_rng(3)
    zeros, walk, held = followed(np.ones(60), rng)
    jump = 8 * NOISE * rng.standard_normal(30) * other
    pattern_counts = 100 * PATTERN[0] / np.linalg.norm(PATTERN[0])
    moved = held.follow(
        walk[-1] + pattern_counts + jump + NOISE * rng.standard_normal(30) - zeros[-1]
    )
    assert held.steady == (not other)
    assert np.any(moved) == (not other)


@pytest.mark.parametrize(("seconds", "share"), [(1, 0.8), (20, 0.8), (200, 2.5)])
def test_what_grows_along_the_contact_s_pattern_is_no_drift(seconds, share):
    """Force or creep by that share of the press, seven times what drift does along it within so long."""
    ramp = 1 + share * np.clip((np.arange(400) - 60) / seconds, 0, 1)
    zeros, walk, held = followed(ramp, np.random.default_rng(seconds))
    assert not held.steady
    wrong_counts = (zeros - walk)[-1] @ PATTERN[0] / np.linalg.norm(PATTERN[0])
    assert abs(wrong_counts) < 0.5 * 100 * share


def test_frames_misread_now_and_then_end_no_hold():
    _, _, held = followed(np.ones(20), np.random.default_rng(2))
    assert not any(held.is_of(np.array([3, 4])) for _ in range(10))
    assert held.is_of(np.array([3]))
    assert not any(held.is_of(np.array([3, 4])) for _ in range(11))
    assert not held.steady


def test_a_hold_of_two_contacts_on_drifting_channels_keeps_its_force_and_is_explained():
    """Ten minutes of the second forward model's frames, up to four seconds apart; then it is let go."""
    rng = np.random.default_rng(52)
    force_n = contacts(rng, 1, 2, (6.0, 6.0))
    motion = np.stack([np.zeros((25, 6)), motion_of(*force_n)[0]])
    pressed = np.repeat([0, 1, 0], [25, 185, 15])
    step_s = np.repeat([0.4, 4.0], [75, 150])
    drift = np.cumsum(2.0 * np.sqrt(step_s)[:, None] * rng.standard_normal((225, 45)), axis=0)
    raw = read_out(SPEC, magnets_field_t(SPEC, motion)[pressed], rng) + np.round(drift)
    reader = LiveContacts(inverted())
    read = [
        reader.feed(row.reshape(5, 3, 3), at)
        for at, row in zip(np.cumsum(step_s).tolist(), raw, strict=True)
    ]
    force = np.array([0 if sets is None else np.nansum(sets.force_n) for sets in read])
    early, late = force[30:70], force[170:210]
    assert abs(late.mean() / early.mean() - 1) < 0.05
    assert all(sets.explained[0] for sets in read[26:])
    assert np.mean([sets.number[0] == 2 for sets in read[170:210]]) > 0.95
    # that the force stayed is believed, not seen: its interval holds what drift may have hidden
    assert np.nanmin(read[205].force_halfwidth_n) > 1.5 * np.nanmin(read[30].force_halfwidth_n)
    assert read[-1].number[0] == 0


def test_what_drifted_in_minutes_of_changing_contacts_is_not_believed_away_in_a_hold():
    """Contacts change for three minutes, every nine seconds; the last is held."""
    rng = np.random.default_rng(60)
    motion = [motion_of(*contacts(rng, 1, 1, (6.0, 6.0)))[0] for _ in range(20)]
    pressed = np.concatenate([np.zeros(25, int), np.repeat(np.arange(1, 21), [3] * 19 + [40])])
    step_s = np.repeat([0.4, 3.0], [25, 97])
    drift = np.cumsum(2.0 * np.sqrt(step_s)[:, None] * rng.standard_normal((122, 45)), axis=0)
    field_t = magnets_field_t(SPEC, np.stack([np.zeros((25, 6)), *motion]))[pressed]
    raw, reader = read_out(SPEC, field_t, rng) + np.round(drift), LiveContacts(inverted())
    read = [
        reader.feed(row.reshape(5, 3, 3), time_s)
        for time_s, row in zip(np.cumsum(step_s).tolist(), raw, strict=True)
    ]
    assert all(sets.explained[0] and sets.number[0] == 1 for sets in read[-25:])


@pytest.mark.parametrize("force_n", [4.0, 8.0, 11.0])
def test_a_contact_that_is_replaced_within_a_frame_is_not_let_go(force_n):
    """Another of equal force presses elsewhere, at four pairs of places; let go, it leaves the zero."""
    rng = np.random.default_rng(int(force_n))
    for _ in range(4):
        motion = motion_of(*contacts(rng, 2, 1, (force_n, force_n)))
        state = np.repeat([0, 1, 2, 0], [12, 12, 15, 12])
        field_t = magnets_field_t(SPEC, np.concatenate([np.zeros((1, 25, 6)), motion]))
        raw, reader = read_out(SPEC, field_t[state], rng), LiveContacts(inverted())
        zeros, read = [], []
        for number, row in enumerate(raw):
            read.append(reader.feed(row.reshape(5, 3, 3), 0.1 * number))
            zeros.append(reader.level.level)
        # noise makes zeros of rest differ by 60 counts in all; one in a press is off by 200 and more
        assert np.linalg.norm(zeros[38] - zeros[23]) < 30
        assert read[-1].number[0] == 0
        assert np.linalg.norm(zeros[-1] - raw[:12].mean(axis=0)) < 120
