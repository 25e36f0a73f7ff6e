"""Scores of all places: consistency with their parts, areas, files and time."""

from dataclasses import fields, replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError, StoreError
from design.layout.places.contact_grid import contact_grid, grid_places_in_lattice
from estimator.information.ellipses import position_covariances_mm2
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.scores import (
    load_scores_csv,
    save_scores_csv,
    score_places,
    weakest_place,
)
from estimator.information.sensitivity import channel_noise, covariance_sensitivity, periodic_press
from estimator.signals.interpolation import press_traces, signal_gradient
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(score={"force_n": 14.0, "channels": "own"}, limits={"use": "bench"})
"""Standing still, read as the paper reads: what is added, the tests add."""


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


@pytest.fixture(scope="module")
def scores(signals):
    return score_places(SPEC, signals)


def test_bounds_are_those_of_the_own_channels_at_the_score_force(signals, scores):
    face, place = 4, 13
    lattice = grid_places_in_lattice(SPEC)[place]
    x, y = signals.lattice.xy_mm[lattice]
    force = scores.force_at_score_n[face - 1, place]
    at = (np.array([face]), np.array([x]), np.array([y]), np.array([force]))
    jacobian = signal_gradient(signals, *at).jacobian
    sigma = disturbance_counts(SPEC.sensors, "drifted", 9)
    own = cramer_rao_bounds(jacobian[:, 27:36], sigma)
    assert_allclose(scores.position_bound_drifted_mm[face - 1, place], own.position_mm[0])
    assert_allclose(scores.force_bound_drifted_n[face - 1, place], own.force_n[0])
    neighbour = cramer_rao_bounds(jacobian[:, 18:27], sigma)
    assert neighbour.position_mm[0] > 1.5 * own.position_mm[0]


def test_the_ellipse_of_a_place_has_its_bound_and_its_weakest_direction(signals, scores):
    covariance = position_covariances_mm2(SPEC, signals, scores)
    bound = np.sqrt(np.trace(covariance, axis1=2, axis2=3))
    assert_allclose(bound, scores.position_bound_mm)
    weakest = np.linalg.eigh(covariance)[1][..., 1]
    angle = np.deg2rad(scores.weakest_direction_deg)
    told = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    assert_allclose(abs((weakest * told).sum(axis=-1)), 1, atol=1e-6)


def test_drift_and_fewer_channels_make_bounds_worse(signals, scores):
    assert (scores.position_bound_drifted_mm > scores.position_bound_mm).all()
    assert (scores.detectable_force_drifted_n > scores.detectable_force_n).all()
    every = score_places(SPEC.changed(score=SPEC.score.changed(channels="all")), signals)
    assert (every.position_bound_mm < scores.position_bound_mm).all()
    assert (every.force_bound_n < scores.force_bound_n).all()
    assert_allclose(every.delta_raw, scores.delta_raw)


def test_channels_that_are_not_finite_are_named(signals):
    delta = signals.delta_counts.copy()
    delta[2, 5:8, 1, 4, 1] = np.nan
    with pytest.raises(InputError, match=r"not finite on F2-Y2 .*3 presses"):
        score_places(SPEC, replace(signals, delta_counts=delta))
    force = signals.force_n.copy()
    force[0, 0, 0] = np.inf
    with pytest.raises(InputError, match="force of 1 presses is not finite"):
        score_places(SPEC, replace(signals, force_n=force))


def test_places_that_do_not_reach_the_force_are_judged_at_their_largest_and_flagged(
    signals, scores
):
    reach = signals.force_n[:, grid_places_in_lattice(SPEC), -1]
    assert_allclose(scores.force_at_score_n, np.minimum(reach, 14.0), rtol=1e-9)
    np.testing.assert_array_equal(scores.reaches_score_force, reach >= 14.0)
    harder = coarse_spec(score={"force_n": 25.0})
    few = score_places(harder, signals)
    assert 0 < few.reaches_score_force.sum() < few.reaches_score_force.size
    assert_allclose(few.depth_at_score_mm[~few.reaches_score_force], 4.0, rtol=1e-9)
    assert_allclose(few.stiffness_n_per_mm * few.depth_at_score_mm, few.force_at_score_n)


def test_weakest_place_has_the_largest_bound(scores):
    weakest = weakest_place(scores)
    bound = scores.position_bound_mm
    assert weakest.position_bound_mm == bound.max() == bound[weakest.face - 1, weakest.place]
    assert_allclose([weakest.x_mm, weakest.y_mm], scores.grid.xy_mm[weakest.place])
    assert 0 <= weakest.direction_deg <= 180


def test_scores_survive_their_table(scores, tmp_path):
    blind = scores.force_bound_n.copy()
    blind[1, 3] = np.inf
    scores = replace(scores, force_bound_n=blind)
    save_scores_csv(scores, tmp_path / "scores.csv")
    back = load_scores_csv(tmp_path / "scores.csv")
    for field in fields(scores)[2:]:
        np.testing.assert_array_equal(getattr(back, field.name), getattr(scores, field.name))
    np.testing.assert_array_equal(back.grid.xy_mm, scores.grid.xy_mm)
    lines = (tmp_path / "scores.csv").read_text().splitlines()
    assert len(lines) == 101
    assert "delta_raw [counts^d/N]" in lines[0].split(",")
    (tmp_path / "cut.csv").write_text("\n".join(lines[:-3]))
    with pytest.raises(StoreError, match="not a table of scores"):
        load_scores_csv(tmp_path / "cut.csv")
    with pytest.raises(StoreError, match="not a table of scores"):
        load_scores_csv(tmp_path / "none.csv")


def test_scaled_sensitivity_counts_three_sigma_on_either_side_of_a_channels_range(signals, scores):
    """Channels are divided by what they read from one end to the other, noise of ±3σ included."""
    face = 3
    grid = contact_grid(SPEC)
    force = scores.force_at_score_n[face - 1]
    where = (np.full(len(grid), face), grid.xy_mm[:, 0], grid.xy_mm[:, 1])
    own = press_traces(signals, *where).select_channels(np.arange(18, 27))
    press = periodic_press(own, force, 64)
    noise = channel_noise(SPEC.sensors, 45)[18:27]
    highest = press.max(axis=(0, 1)) + 3 * noise
    lowest = press.min(axis=(0, 1)) - 3 * noise
    raw = covariance_sensitivity(press, force, noise)
    expected = raw.scaled(highest - lowest).delta
    assert_allclose(scores.delta_scaled[face - 1], expected, rtol=1e-3)


def test_a_place_whose_deepest_press_just_reaches_the_force_reaches_it(signals):
    largest = signals.force_n[0, grid_places_in_lattice(SPEC)[0], -1]
    exact = score_places(coarse_spec(score={"force_n": float(largest)}), signals)
    assert exact.reaches_score_force[0, 0]
    beyond = score_places(coarse_spec(score={"force_n": float(largest) * 1.001}), signals)
    assert not beyond.reaches_score_force[0, 0]


def _partly_reached(presses):
    """A force that some locations reach and others do not, and the signals."""
    signals = press_signals(coarse_spec(), *presses)
    deepest = np.sort(signals.force_n[..., -1].ravel())
    between = float(deepest[0] + deepest[-1]) / 2
    return coarse_spec(score={"force_n": between}), signals


def test_a_force_that_a_press_never_reaches_is_not_judged_under_its_name():
    presses = synthetic_presses(coarse_spec())
    spec, signals = _partly_reached(presses)
    scores = score_places(spec, signals)
    out = scores.places & ~scores.judged
    assert out.any()
    assert scores.judged.any()
    for values in (scores.position_bound_mm, scores.force_bound_n, scores.delta_raw):
        assert np.isnan(values[out]).all()
        assert not np.isnan(values[scores.judged]).any()
    assert (
        f"{out.sum()} of {scores.places.sum()} contact locations are not judged" in scores.unreached
    )
    assert np.isfinite(weakest_place(scores).position_bound_mm)


def test_a_force_that_no_press_reaches_is_refused_with_the_largest():
    signals = press_signals(coarse_spec(), *synthetic_presses(coarse_spec()))
    deepest = float(np.nanmax(signals.force_n))
    with pytest.raises(InputError, match=f"gets to {deepest:.3g} N"):
        score_places(coarse_spec(score={"force_n": 1.01 * deepest}), signals)
    assert not score_places(coarse_spec(score={"force_n": 0.01}), signals).unreached
