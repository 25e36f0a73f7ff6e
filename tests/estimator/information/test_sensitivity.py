"""Convex-hull sensitivity: exact volumes, the Gaussian factor, the equivalent against the hull."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial import ConvexHull
from scipy.stats import spearmanr

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from estimator.information.scores import COVARIANCE_SAMPLES, sensitivities
from estimator.information.sensitivity import (
    channel_noise,
    covariance_sensitivity,
    ln_ball_volume,
    ln_hull_factor,
    own_channels,
    periodic_press,
)
from estimator.signals.interpolation import press_traces
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(contact_grid={"count": (5, 5), "pitch_mm": 6.0}, seed=3)
NOISE = channel_noise(SPEC.sensors, 9)


@pytest.fixture(scope="module")
def place_traces():
    signals = press_signals(SPEC, *synthetic_presses(SPEC))
    grid = contact_grid(SPEC)
    traces = press_traces(signals, np.full(len(grid), 3), *grid.xy_mm.T)
    return traces.select_channels(own_channels(signals, SPEC.sensors, 3))


def hull_volumes(samples):
    """Of the frames of every place, by Qhull, on equal scales of the channels."""
    return [ConvexHull(frames / NOISE).volume * np.prod(NOISE) for frames in samples]


def rank_correlation_and_size(place_traces, frames, realizations):
    """Exact δ (mean over noise) against the equivalent at the same N: ranks and median ratio."""
    peak = np.full(len(place_traces.force_n), 8.0)
    press = periodic_press(place_traces, peak, frames)
    rng = np.random.default_rng(1)
    exact = [
        hull_volumes(press + NOISE * rng.standard_normal(press.shape)) for _ in range(realizations)
    ]
    equivalent = covariance_sensitivity(press, peak, NOISE, frames)
    assert equivalent.frames == frames
    mean = np.mean(exact, axis=0) / peak
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


def test_scaled_delta_is_over_the_whole_change_of_every_channel(place_traces):
    peak = np.full(len(place_traces.force_n), 6.0)
    press = periodic_press(place_traces, peak, COVARIANCE_SAMPLES)
    found = sensitivities(press, peak, NOISE)
    raw = covariance_sensitivity(press, peak, NOISE)
    assert_allclose(found["delta_scaled"], raw.scaled(np.ptp(press, axis=(0, 1)) + 6 * NOISE).delta)


@pytest.mark.slow
def test_equivalent_ranks_places_as_the_exact_hull_at_100_frames(place_traces):
    correlation, size = rank_correlation_and_size(place_traces, 100, 2)
    assert correlation >= 0.95
    assert_allclose(size, 1, atol=0.25)


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
    with pytest.raises(InputError, match="no volume"):
        covariance_sensitivity(press, peak, 0 * NOISE, 1000)


def test_gaussian_factor_matches_known_and_sampled_hulls():
    assert_allclose(np.exp(ln_hull_factor(3, 1)), 3 / np.sqrt(np.pi), rtol=1e-9)
    rng = np.random.default_rng(2)
    for frames, channels in ((12, 2), (30, 3), (25, 6)):
        volumes = [ConvexHull(rng.standard_normal((frames, channels))).volume for _ in range(400)]
        spread = np.std(volumes) / np.mean(volumes) / 20
        assert_allclose(np.exp(ln_hull_factor(frames, channels)), np.mean(volumes), rtol=4 * spread)


def test_ball_volumes():
    assert_allclose(np.exp([ln_ball_volume(d) for d in (1, 2, 3)]), [2, np.pi, 4 * np.pi / 3])


def test_scaled_delta_is_that_of_scaled_signals(place_traces):
    peak = np.full(len(place_traces.force_n), 8.0)
    press = periodic_press(place_traces, peak, 64)
    span = press.max(axis=(0, 1)) - press.min(axis=(0, 1)) + 6 * NOISE
    direct = covariance_sensitivity(press / span, peak, NOISE / span, 1000)
    scaled = covariance_sensitivity(press, peak, NOISE, 1000).scaled(span)
    assert_allclose(scaled.delta, direct.delta, rtol=1e-9)
    assert_allclose(scaled.noise_counts, direct.noise_counts)
