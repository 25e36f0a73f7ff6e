"""Convex-hull sensitivity: exact volumes, the Gaussian factor, the equivalent against the hull."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import spearmanr
from synthetic_presses import coarse_spec, synthetic_presses

from design.errors import InputError
from design.layouts import contact_grid
from estimator.interpolation import press_traces
from estimator.sensitivity import (
    channel_noise,
    covariance_sensitivity,
    hull_sensitivity,
    hull_volume,
    ln_hull_factor,
    ln_sample_covariance_factor,
    own_channels,
    periodic_press,
)
from estimator.signals import press_signals

SPEC = coarse_spec(contact_grid={"count": (5, 5), "pitch_mm": 6.0}, seed=3)
NOISE = channel_noise(SPEC.sensors, 9)


@pytest.fixture(scope="module")
def place_traces():
    signals = press_signals(SPEC, *synthetic_presses(SPEC))
    grid = contact_grid(SPEC)
    traces = press_traces(signals, np.full(len(grid), 3), *grid.xy_mm.T)
    return traces.of_channels(own_channels(signals, SPEC.sensors, 3))


def rank_correlation_and_size(place_traces, frames, realizations):
    """Exact δ (mean over noise) against the equivalent at the same N: ranks and median ratio."""
    peak = np.full(len(place_traces.force_n), 8.0)
    press = periodic_press(place_traces, peak, frames)
    rng = np.random.default_rng(1)
    exact = [hull_sensitivity(press, peak, NOISE, rng) for _ in range(realizations)]
    equivalent = covariance_sensitivity(press, peak, NOISE, frames)
    assert exact[0].frames == equivalent.frames == frames
    mean = np.mean([one.delta for one in exact], axis=0)
    return spearmanr(mean, equivalent.delta).statistic, np.median(mean / equivalent.delta)


def test_equivalent_ranks_places_as_the_exact_hull_at_30_frames(place_traces):
    correlation, size = rank_correlation_and_size(place_traces, 30, 10)
    assert correlation >= 0.95
    assert_allclose(size, 1, atol=0.25)
    shuffled = replace(place_traces, counts=place_traces.counts[::-1] * [1, 0, 1, 2, 1, 1, 3, 1, 1])
    peak = np.full(len(place_traces.force_n), 8.0)
    other = covariance_sensitivity(periodic_press(shuffled, peak, 30), peak, NOISE, 30).delta
    right = covariance_sensitivity(periodic_press(place_traces, peak, 30), peak, NOISE, 30).delta
    assert spearmanr(other, right).statistic < 0.9


@pytest.mark.slow
def test_equivalent_ranks_places_as_the_exact_hull_at_100_frames(place_traces):
    correlation, size = rank_correlation_and_size(place_traces, 100, 2)
    assert correlation >= 0.95
    assert_allclose(size, 1, atol=0.25)


def test_hull_volume_of_a_sheared_box_is_its_determinant():
    corners = np.array(np.meshgrid(*[[0.0, 1.0]] * 5)).reshape(5, -1).T
    shear = np.diag([2.0, 300.0, 0.5, 1.0, 4.0]) + np.triu(np.full((5, 5), 0.3), 1)
    assert_allclose(hull_volume(corners @ shear), abs(np.linalg.det(shear)), rtol=1e-9)


def test_gaussian_factor_matches_known_and_sampled_hulls():
    assert_allclose(np.exp(ln_hull_factor(3, 1)), 3 / np.sqrt(np.pi), rtol=1e-9)
    rng = np.random.default_rng(2)
    for frames, channels in ((12, 2), (30, 3), (25, 6)):
        volumes = [hull_volume(rng.standard_normal((frames, channels))) for _ in range(400)]
        spread = np.std(volumes) / np.mean(volumes) / 20
        assert_allclose(np.exp(ln_hull_factor(frames, channels)), np.mean(volumes), rtol=4 * spread)


def test_gaussian_factor_agrees_with_values_found_for_simulated_presses():
    """ln c against sample covariances, as measured on simulated presses, N from 40 to 1000."""
    measured = {40: 4.66, 60: 5.69, 100: 6.74, 200: 8.02, 400: 9.01, 1000: 10.15}
    for frames, value in measured.items():
        found = ln_hull_factor(frames, 9) + ln_sample_covariance_factor(frames, 9)
        assert_allclose(found, value, atol=0.15)


def test_delta_depends_on_frames_noise_and_force_range_as_stated(place_traces):
    peak = np.full(len(place_traces.force_n), 8.0)
    press = periodic_press(place_traces, peak, 64)
    delta = covariance_sensitivity(press, peak, NOISE, 1000).delta
    fewer = covariance_sensitivity(press, peak, NOISE, 50).delta
    ratio = np.exp(ln_hull_factor(1000, 9) - ln_hull_factor(50, 9))
    assert ratio > 50
    assert_allclose(delta / fewer, ratio, rtol=1e-9)
    assert_allclose(covariance_sensitivity(press, 2 * peak, NOISE, 1000).delta, delta / 2)
    still = covariance_sensitivity(0 * press, peak, NOISE, 1000).delta
    assert_allclose(still, np.exp(ln_hull_factor(1000, 9)) * np.prod(NOISE) / 8, rtol=1e-9)
    gain = np.array([2.0, 3, 0.5, 1, 1, 4, 1, 0.1, 7])
    scaled = covariance_sensitivity(press * gain, peak, NOISE * gain, 1000).delta
    assert_allclose(scaled, delta * np.prod(gain), rtol=1e-6)


def test_noise_free_presses_are_explained_not_crashed(place_traces):
    peak = np.full(len(place_traces.force_n), 8.0)
    press = periodic_press(place_traces, peak, 40)
    line = np.linspace(0, 1, 40)[:, None] * np.arange(1.0, 10)
    with pytest.raises(InputError, match=r"1 of 9 dimensions.*sensors.noise_counts"):
        hull_volume(line)
    with pytest.raises(InputError, match="no volume"):
        hull_sensitivity(
            press * [1, 1, 1, 1, 0, 1, 1, 1, 1], peak, 0 * NOISE, np.random.default_rng()
        )
    with pytest.raises(InputError, match="no volume"):
        covariance_sensitivity(press, peak, 0 * NOISE, 1000)


def test_too_few_and_too_many_frames_are_refused():
    rng = np.random.default_rng(4)
    with pytest.raises(InputError, match="more than 10 frames; got 10"):
        hull_volume(rng.normal(size=(10, 9)))
    with pytest.raises(InputError, match="limited to 100 frames; got 101"):
        hull_volume(rng.normal(size=(101, 9)))
