"""Slopes, drift, bound and scatter of repeated presses, each by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel.bound import (
    attainable_correlation,
    drift_of_rounds,
    place_scatter_mm,
    places_bound_mm,
    recorded_slopes,
)

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
