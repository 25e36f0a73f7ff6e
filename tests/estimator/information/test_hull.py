"""Volumes of convex hulls: exact, by Monte Carlo along directions, and their normal mean."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.optimize import linprog
from scipy.special import digamma

from design.errors import InputError
from estimator.information.hull import (
    exact_hull_volume,
    hull_extents,
    ln_ball_volume,
    ln_hull_factor,
    monte_carlo_hull_volume,
)


def ln_sample_covariance_factor(frames, channels):
    """Mean of −ln √det of the sample covariance of N standard normal points (Bartlett)."""
    freedom = frames - 1 - np.arange(channels)
    return float(-0.5 * np.sum(digamma(freedom / 2) + np.log(2 / (frames - 1))))


def test_hull_volume_of_a_sheared_box_is_its_determinant():
    corners = np.array(np.meshgrid(*[[0.0, 1.0]] * 5)).reshape(5, -1).T
    shear = np.diag([2.0, 300.0, 0.5, 1.0, 4.0]) + np.triu(np.full((5, 5), 0.3), 1)
    assert_allclose(exact_hull_volume(corners @ shear).volume, abs(np.linalg.det(shear)), rtol=1e-9)


def test_an_exact_hull_takes_a_hundred_frames():
    frames = np.random.default_rng(1).standard_normal((101, 2))
    assert exact_hull_volume(frames[:100]).volume > 1
    with pytest.raises(InputError, match="limited to 100 frames; got 101"):
        exact_hull_volume(frames)


def test_gaussian_factor_matches_known_and_sampled_hulls():
    assert_allclose(np.exp(ln_hull_factor(3, 1)), 3 / np.sqrt(np.pi), rtol=1e-9)
    rng = np.random.default_rng(2)
    for frames, channels in ((12, 2), (30, 3), (25, 6)):
        volumes = [
            exact_hull_volume(rng.standard_normal((frames, channels))).volume for _ in range(400)
        ]
        spread = np.std(volumes) / np.mean(volumes) / 20
        assert_allclose(np.exp(ln_hull_factor(frames, channels)), np.mean(volumes), rtol=4 * spread)


def test_gaussian_factor_agrees_with_values_found_for_simulated_presses():
    """ln c against sample covariances, as measured on simulated presses, N from 40 to 1000."""
    measured = {40: 4.66, 60: 5.69, 100: 6.74, 200: 8.02, 400: 9.01, 1000: 10.15}
    for frames, value in measured.items():
        found = ln_hull_factor(frames, 9) + ln_sample_covariance_factor(frames, 9)
        assert_allclose(found, value, atol=0.15)


def skewed_frames(frames, channels, seed=6):
    """A noisy bent curve, far from normal, with very different sizes of the channels."""
    rng = np.random.default_rng(seed)
    t = (1 - np.cos(np.linspace(0, 2 * np.pi, frames))) / 2
    bend = np.stack([t ** (1 + k / 3) for k in range(channels)], axis=1)
    size = 10.0 ** np.linspace(-1, 3, channels)
    return size * (4 * bend + rng.standard_normal((frames, channels)))


def test_extents_are_those_of_a_linear_program_along_every_direction():
    rng = np.random.default_rng(8)
    points = rng.standard_normal((200, 5)) ** 3
    points -= points.mean(axis=0)
    u = rng.standard_normal((12, 5))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    # max n·u over the planes n·p ≤ 1 is the inverse of the extent
    best = [linprog(-row, A_ub=points, b_ub=np.ones(200), bounds=(None, None)) for row in u]
    assert_allclose(hull_extents(points, u), [-1 / result.fun for result in best], rtol=1e-7)


def test_extents_of_a_cross_polytope_are_one_over_the_sum_of_components():
    u = np.array([[0.6, -0.8, 0.0], [1 / 3, 2 / 3, -2 / 3]])
    points = np.concatenate([np.eye(3), -np.eye(3)])
    assert_allclose(hull_extents(points, u), 1 / abs(u).sum(axis=1), rtol=1e-9)


def test_monte_carlo_is_unbiased_and_its_standard_error_is_the_spread():
    samples = skewed_frames(60, 7)
    exact = exact_hull_volume(samples).volume
    found = [monte_carlo_hull_volume(samples, np.random.default_rng(100 + i)) for i in range(40)]
    volume = np.array([hull.volume for hull in found]) / exact
    error = np.array([hull.standard_error for hull in found]) / exact
    assert_allclose(volume.mean(), 1, atol=4 * volume.std() / np.sqrt(40))
    assert 0.01 < volume.std() < 0.15
    assert_allclose(np.sqrt(np.mean(error**2)), volume.std(), rtol=0.4)
    more = monte_carlo_hull_volume(samples, np.random.default_rng(5), directions=6000)
    assert_allclose(more.volume, exact, rtol=4 * more.standard_error / exact)
    assert more.standard_error < 0.35 * np.mean(error) * exact


def test_monte_carlo_scales_with_every_channel():
    samples = skewed_frames(80, 4)
    gain = np.array([2.0, 0.1, 30.0, 1.0])
    one, other = (
        monte_carlo_hull_volume(frames, np.random.default_rng(1))
        for frames in (samples, samples * gain)
    )
    assert_allclose(other.volume / one.volume, np.prod(gain), rtol=1e-6)


def test_ball_volumes():
    assert_allclose(np.exp([ln_ball_volume(d) for d in (1, 2, 3)]), [2, np.pi, 4 * np.pi / 3])


@pytest.mark.parametrize("volume", [exact_hull_volume, monte_carlo_hull_volume])
def test_degenerate_and_too_few_frames_are_explained(volume):
    more = (np.random.default_rng(1),) if volume is monte_carlo_hull_volume else ()
    line = np.linspace(0, 1, 40)[:, None] * np.arange(1.0, 10)
    with pytest.raises(InputError, match=r"1 of 9 dimensions.*sensors.noise_counts"):
        volume(line, *more)
    with pytest.raises(InputError, match="more than 10 frames; got 10"):
        volume(np.random.default_rng(4).normal(size=(10, 9)), *more)


def test_too_many_frames_for_the_exact_hull_are_refused():
    with pytest.raises(InputError, match=r"limited to 100 frames; got 101.*monte-carlo"):
        exact_hull_volume(np.random.default_rng(4).normal(size=(101, 9)))


def test_the_standard_error_of_two_directions_is_half_of_what_they_differ_by():
    samples = np.random.default_rng(3).normal(size=(60, 2))
    rng = np.random.default_rng(5)
    volume, error = vars(monte_carlo_hull_volume(samples, rng, directions=2)).values()
    u = np.random.default_rng(5).standard_normal((2, 2))
    about = samples - samples.mean(axis=0)
    lower = np.linalg.cholesky(np.cov(about.T, bias=True))
    white, unit = np.linalg.solve(lower, about.T).T, u / np.linalg.norm(u, axis=1, keepdims=True)
    areas = np.pi * np.prod(np.diag(lower)) * hull_extents(white, unit) ** 2
    assert volume == pytest.approx(areas.mean(), rel=1e-6)
    assert error == pytest.approx(abs(areas[1] - areas[0]) / 2, rel=1e-6)
