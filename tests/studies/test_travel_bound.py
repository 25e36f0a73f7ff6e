"""Slopes, drift, bound and scatter of repeated presses, each by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import spearmanr

from estimator.calibration.known_travel.fit import Fitted
from estimator.recordings.formats.travel import TravelRecording
from studies.recorded.travel_bound import (
    attainable_correlation,
    bound_test,
    drift_of_rounds,
    place_scatter_mm,
    places_bound_mm,
    recorded_slopes,
)
from tests.support.recordings.made_travel import RESTING_MT, TWIN, Made, recording

LATTICE = np.array([(1.5 * i, 1.5 * j) for i in range(-6, 7) for j in range(-6, 7)])


def test_slopes_of_a_quadratic_surface_are_exact_and_the_border_has_none():
    x, y = LATTICE.T
    level = np.column_stack([1 + 2 * x - y + x * y, x**2 - 3 * y**2])
    found = recorded_slopes(LATTICE, level)
    inside = (abs(LATTICE) < 8.9).all(axis=1)
    assert np.isfinite(found[inside]).all()
    assert np.isnan(found[~inside]).all()
    wanted = np.stack([np.column_stack([2 + y, -1 + x]), np.column_stack([2 * x, -6 * y])], axis=1)
    assert_allclose(found[inside], wanted[inside], atol=1e-9)


def test_slopes_come_from_places_within_4_5_mm_and_from_twelve_at_least():
    far = LATTICE.copy()
    level = np.where(np.linalg.norm(far, axis=1) < 4.4, far[:, 0], 1e3)[:, None]
    middle = np.flatnonzero((far == 0).all(axis=1))[0]
    assert_allclose(recorded_slopes(far, level)[middle, 0], [1.0, 0.0], atol=1e-9)
    for count, told in ((11, False), (12, True)):
        near = np.array([(np.cos(a), np.sin(a)) for a in np.arange(count - 1) * 2.4])
        places = np.vstack([[0.0, 0.0], near * np.linspace(1, 3, count - 1)[:, None]])
        found = recorded_slopes(places, places[:, :1])[0, 0]
        assert np.isfinite(found).all() == told
    half = LATTICE[LATTICE[:, 0] >= 0]
    border = np.flatnonzero((half == [0, 0]).all(axis=1))[0]
    assert np.isnan(recorded_slopes(half, half[:, :1])[border]).all()


def test_bound_and_scatter_follow_from_slopes_and_noise():
    """Two channels, of which each sees one direction: σ/slope, added up."""
    slope = np.array([[2.0, 0.0], [0.0, 5.0]])
    precision = np.diag([1 / 0.3**2, 1 / 0.4**2])
    assert places_bound_mm(slope[None], precision)[0] == pytest.approx(np.hypot(0.3 / 2, 0.4 / 5))
    assert np.isnan(places_bound_mm(np.full((1, 2, 2), np.nan), precision)[0])
    left = np.array([[0.2, 0.0], [-0.2, 0.5], [0.0, -0.5]])
    wanted = np.sqrt((2 * 0.1**2 + 2 * 0.1**2) / 2)
    assert place_scatter_mm(slope, precision, left) == pytest.approx(wanted)
    assert np.isnan(place_scatter_mm(np.full((2, 2), np.nan), precision, left))


def test_drift_is_what_all_places_share_from_round_to_round():
    rng = np.random.default_rng(0)
    groups = [np.array([0, 2, 4]), np.array([1, 3, 5])]
    place = np.array([0.0, 9.0, 0.0, 9.0, 0.0, 9.0])[:, None] * [1.0, 2.0]
    drift = np.repeat([-1.0, 0.0, 1.0], 2)[:, None] * [0.5, -0.25]
    found = drift_of_rounds(rng.normal() + place + drift, groups, 6)
    assert_allclose(found, drift, atol=1e-12)


def test_few_repeats_blur_a_right_bound_and_many_show_it():
    rng = np.random.default_rng(1)
    slopes = np.eye(2) * np.linspace(0.5, 3.0, 40)[:, None, None]
    few, many = (
        attainable_correlation(slopes, np.eye(2), n * 20, rng) for n in ([3, 3], [200, 600])
    )
    assert 0.5 < few < 0.95
    assert many > 0.97


def test_bound_and_scatter_are_of_the_noise_of_the_repeats_without_their_drift():
    """81 places 1.5 mm apart with three repeats, one of them with four, one place with two alone."""
    axis = np.arange(-6, 6.1, 1.5)
    xy = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    xy = xy + np.random.default_rng(2).uniform(-0.2, 0.2, xy.shape)
    place = np.sort(np.concatenate([np.repeat(np.arange(81), 3), [30, 81, 81]]))
    travel = np.linspace(1, 3, 82)[place]
    repeats = recording(np.vstack([xy, [[0.4, 0.4]]])[place], travel, place, 0.05)
    number = np.concatenate([np.arange(n) for n in np.bincount(place)])
    drift = np.array([0.5, -0.25, 0.1, 3.0])[number, None, None] * np.ones((3, 3))
    repeats = TravelRecording(repeats.time_s, repeats.tip_mm, repeats.field_mt + drift, place)
    found = bound_test.__wrapped__(Made(), Fitted(TWIN, RESTING_MT, 0.0), repeats)

    kept, number = place < 81, np.where(place < 81, number, -1)
    flat = repeats.field_mt.reshape(-1, 9).copy()
    whole = flat.mean(axis=0)
    for turn in range(4):
        flat[number == turn] += whole - flat[number == turn].mean(axis=0)
    level = np.array([flat[place == k].mean(axis=0) for k in range(81)])
    left = flat[kept] - level[place[kept]]
    precision = np.linalg.inv(left.T @ left / (kept.sum() - 81))
    recorded = recorded_slopes(xy, level)
    inside = np.flatnonzero(np.isfinite(recorded[:, 0, 0]) & (xy[:, 0] > -4.0))
    assert len(inside) > 40
    assert_allclose(found.xy_mm, xy[inside], atol=1e-9)
    x, y, by = *xy[inside].T, 0.6 * np.linspace(1, 3, 82)[inside]
    one, zero = np.ones(len(x)), np.zeros(len(x))
    by_x = [1 + 0.1 * y, zero, 0.3 * by, 0.4 * x, zero, 0.1 * one, zero, zero, -0.1 * one]
    by_y = [0.1 * x, 2 - 0.1 * y, zero, zero, zero, -one, by, zero, zero]
    slopes = np.stack([np.stack(by_x, axis=1), np.stack(by_y, axis=1)], axis=2)
    white = np.linalg.cholesky(precision)
    bounds, scatter = [], []
    for k, slope in zip(inside, slopes, strict=True):
        bounds.append(np.linalg.norm(np.linalg.pinv(white.T @ slope)))
        read = np.linalg.pinv(white.T @ recorded[k]) @ white.T @ left[place[kept] == k].T
        scatter.append(np.sqrt(np.var(read, axis=1, ddof=1).sum()))
    assert_allclose(found.bound_mm, bounds)
    assert_allclose(found.scatter_mm, scatter)
    of_slopes = [np.linalg.norm(np.linalg.pinv(white.T @ recorded[k])) for k in inside]
    assert_allclose(found.slopes_bound_mm, of_slopes)
    ratio = np.log(np.array(scatter) / bounds)
    assert_allclose(
        [found.size_ratio, found.size_spread], np.exp([np.median(ratio), np.std(ratio)])
    )
    assert_allclose(found.rank_correlation, spearmanr(bounds, scatter).statistic)
    assert_allclose(found.slopes_rank_correlation, spearmanr(bounds, of_slopes).statistic)
    assert found.null == pytest.approx(1.96 / np.sqrt(len(x) - 1), rel=0.2)
    repeated = [4 if k == 30 else 3 for k in inside]
    drawn = attainable_correlation(slopes, precision, repeated, np.random.default_rng(9))
    assert found.attainable == pytest.approx(drawn, abs=0.15)
