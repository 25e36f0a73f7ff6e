"""Loading rate, creep, steadiness and slip of forces and places made by formula."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.grasps.holding import (
    common_onset_s,
    contact_slip,
    creep_per_decade,
    loading_rate_n_per_s,
    unsteadiness,
)

TIME_S = np.arange(60) / 10.0


def test_the_loading_rate_is_the_steepest_slope():
    force = np.interp(TIME_S, [0, 1, 2, 3], [0, 2, 9, 9])
    assert loading_rate_n_per_s(TIME_S, force) == pytest.approx(7.0)
    assert np.isnan(loading_rate_n_per_s(TIME_S[:2], force[:2]))


def test_creep_is_the_loss_per_tenfold_time():
    time_s = np.linspace(0, 100, 2000)
    force = np.full(2000, 10.0)
    force[1:] -= 0.5 * np.log10(time_s[1:])
    assert creep_per_decade(time_s, force) == pytest.approx(-0.5 / force.mean(), rel=1e-3)
    assert_allclose(creep_per_decade(TIME_S, np.full(60, 4.0)), 0.0, atol=1e-12)
    assert np.isnan(creep_per_decade(TIME_S[:3], np.ones(3)))


def test_unsteadiness_of_a_sine():
    force = 5 + np.sqrt(2) * np.sin(2 * np.pi * np.arange(100) / 100)
    assert unsteadiness(force) == pytest.approx(0.2)


def sliding(onset_s, speed, noise=0.02, seed=0):
    way = speed * np.clip(TIME_S - onset_s, 0, None)
    noise_mm = noise * np.random.default_rng(seed).standard_normal((60, 2))
    return np.column_stack([way, 0.0 * way]) + noise_mm


def test_slip_is_found_within_half_a_millimetre_and_in_time():
    for seed in range(40):
        slip = contact_slip(TIME_S, sliding(3.0, 6.0, seed=seed))
        assert slip.slipped
        assert slip.onset_s == pytest.approx(3.0, abs=0.05)
        assert slip.distance_mm == pytest.approx(6.0 * 2.8, abs=0.5)


def test_slips_that_end_are_timed_to_half_a_frame():
    """At any phase of the frames, from a creep to a jump between two frames."""
    rng, late = np.random.default_rng(3), []
    for _ in range(200):
        onset, speed, way = rng.uniform(2, 4), np.exp(rng.uniform(0, 4)), rng.uniform(1, 3)
        moved = np.clip(speed * (TIME_S - onset), 0, way)
        noise = 0.05 * rng.standard_normal((60, 2))
        slip = contact_slip(TIME_S, moved[:, None] * [0.6, 0.8] + noise)
        assert slip.distance_mm == pytest.approx(moved[-2], abs=0.3)
        late.append(abs(slip.onset_s - onset))
    assert np.mean(np.array(late) <= 0.05) >= 0.9


def test_faces_that_slide_together_are_timed_better_than_one_of_them():
    rng, alone, together = np.random.default_rng(4), [], []
    for _ in range(150):
        onset, speed, way = rng.uniform(2, 4), np.exp(rng.uniform(2.3, 3.7)), rng.uniform(1, 3)
        moved = np.clip(speed * (TIME_S - onset), 0, way)[:, None] * [0.6, 0.8]
        faces = [moved + 0.2 * rng.standard_normal((60, 2)) for _ in range(2)]
        alone.append(contact_slip(TIME_S, faces[0]).onset_s - onset)
        together.append(common_onset_s(TIME_S, faces) - onset)
    assert np.mean(np.isfinite(together)) > 0.97
    assert np.nanstd(together) < 0.85 * np.nanstd(alone)


def test_faces_that_slide_one_after_the_other_have_no_common_onset():
    faces = [sliding(2.0, 6.0), sliding(4.0, 6.0, seed=1)]
    assert np.isnan(common_onset_s(TIME_S, faces))
    assert np.isnan(common_onset_s(TIME_S, faces[:1]))
    assert np.isnan(common_onset_s(TIME_S[:4], [face[:4] for face in faces]))


def test_a_contact_that_stays_does_not_slip():
    slipped = [contact_slip(TIME_S, sliding(0, 0, 0.4, seed)).slipped for seed in range(200)]
    assert np.mean(slipped) <= 0.05


def test_a_contact_that_jumps_and_comes_back_has_not_slipped():
    centre = sliding(0, 0)
    centre[20:25] += 3.0
    assert not contact_slip(TIME_S, centre).slipped


def test_frames_without_a_contact_are_passed_over_and_few_say_nothing():
    centre = sliding(3.0, 6.0)
    centre[5:9] = np.nan
    assert contact_slip(TIME_S, centre).slipped
    assert np.isnan(contact_slip(TIME_S[:4], centre[:4]).distance_mm)
