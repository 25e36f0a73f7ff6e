"""Zero of a press by the rests before and after it."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.grasps.rests import contacts_between_rests, zero_by_rests
from tests.support.mechanics.inverted import inverted

CHANNELS = 45
PRESS = slice(25, 40)


def recording(seed, zero_counts, drift_counts=0.0, frames=65):
    """Noise about a zero that is wrong, and which frames are at rest."""
    rng = np.random.default_rng(seed)
    noise = rng.standard_normal((frames, CHANNELS)) * np.minimum(
        inverted().disturbances.noise_counts, 30.0
    )
    drift = np.linspace(0.0, 1.0, frames)[:, None] * drift_counts
    wrong = rng.standard_normal(CHANNELS) * zero_counts
    resting = np.ones(frames, bool)
    resting[PRESS] = False
    return noise + wrong + drift, wrong + drift, resting


def test_what_is_left_of_a_wrong_zero_is_as_large_as_it_says():
    missed, said = [], []
    for seed in range(40):
        counts, wrong, resting = recording(seed, 10.0)
        level, left = zero_by_rests(counts, resting, inverted().disturbances)
        missed.append((level - np.broadcast_to(wrong, level.shape))[PRESS])
        said.append(left)
    assert np.sqrt(np.mean(np.square(missed))) == pytest.approx(
        np.sqrt(np.mean(np.square(said))), rel=0.1
    )
    assert np.mean(said) < 4.0


def test_between_two_rests_the_zero_drifts_straight():
    counts, wrong, resting = recording(1, 0.0, drift_counts=300.0)
    level, _ = zero_by_rests(
        counts, resting, replace(inverted().disturbances, offset_counts=np.full(CHANNELS, 1e3))
    )
    assert np.abs(level - wrong)[PRESS].mean() < 8.0


def test_a_recording_of_one_press_without_rest_keeps_its_zero():
    counts, _, resting = recording(2, 10.0)
    level, left = zero_by_rests(counts[PRESS], resting[PRESS], inverted().disturbances)
    assert not level.any()
    np.testing.assert_array_equal(left, inverted().disturbances.offset_counts)


def test_a_channel_without_readings_stays_without():
    counts, _, resting = recording(3, 10.0)
    counts[:, 4] = np.nan
    level, _ = zero_by_rests(counts, resting, inverted().disturbances)
    assert np.isfinite(level).all()
    assert not level[:, 4].any()


def test_forces_of_a_press_are_nearer_by_the_rests_about_it():
    estimator, errors = inverted(), {"once": [], "by rests": []}
    face = np.array([[0]])
    press = estimator.model.singles(face, np.array([[[4.0, -3.0, 5.0]]]))[0, 0, 0]
    for seed in range(6):
        counts, _, resting = recording(seed, 10.0)
        counts[PRESS] += press
        for name, frames in (("once", counts[PRESS]), ("by rests", counts)):
            sets, _ = contacts_between_rests(estimator, frames)
            pressed = np.ones(len(frames), bool) if name == "once" else ~resting
            errors[name].append(np.nansum(sets.force_n[pressed], axis=1).mean() - 5.0)
    assert np.std(errors["by rests"]) < 0.8 * np.std(errors["once"])
