"""Slip of the core in signals: both models agree where they must; false readings by hand."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.places.positions import magnet_layout
from estimator.information.fisher import disturbance_counts
from estimator.information.slip_cost import false_reading, slip_cost
from estimator.signals.field_setup import scene
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import press_signals, rest_counts
from estimator.tolerances.assembly import undisturbed
from estimator.tolerances.virtual_object import twin_signals
from fem.linear.core_slip import shell_motion, superposed
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SLIP = {"shift_mm": (0.7, -0.5, 0.3), "rotation_deg": (2.0, -1.5, 3.0)}


def slipped_spec():
    return coarse_spec(mechanics={"slip": SLIP})


def rigid_rest(spec):
    """Motions of all magnets with a shell that follows its core rigidly."""
    turn, shift = shell_motion(spec)
    centre = magnet_layout(spec).centre_mm
    rotation = np.tile(turn.as_rotvec(), (len(centre), 1))
    return np.hstack([turn.apply(np.array(centre)) + shift - centre, rotation])


@pytest.fixture(scope="module")
def calibrated():
    spec = coarse_spec()
    return press_signals(spec, *synthetic_presses(spec))


@pytest.fixture(scope="module")
def sensors_only():
    spec = slipped_spec()
    moved = undisturbed(scene(spec, core_slipped=True))
    return twin_signals(spec, moved, *synthetic_presses(spec))


def signals_of_the_moved_shell(motion_of_press):
    spec = slipped_spec()
    forces, motions = synthetic_presses(spec)
    rest = rigid_rest(spec)
    moved = replace(motions, motion=motion_of_press(rest, motions.motion), rest=rest)
    return press_signals(spec, forces, moved)


def assert_same_signals(a, b):
    size = abs(b.delta_counts).max()
    assert_allclose(a.baseline_counts, b.baseline_counts, rtol=0, atol=1e-6)
    assert_allclose(a.delta_counts, b.delta_counts, rtol=0, atol=1e-9 * size + 1e-6)


def test_moving_the_sensors_is_moving_the_shell_back(sensors_only, calibrated):
    """With the same presses of a rigidly moved shell, the sensors cannot tell which one moved."""
    assert_same_signals(signals_of_the_moved_shell(superposed), sensors_only)
    change = sensors_only.baseline_counts - calibrated.baseline_counts
    assert abs(change).max() > 300


def test_the_check_at_rest_sees_the_slip(sensors_only):
    exact = rest_counts(slipped_spec())
    assert_allclose(sensors_only.baseline_counts, exact, rtol=0, atol=2e-3 * abs(exact).max())


def test_false_readings_of_a_known_residual():
    """r = J θ is read as θ, whatever the sigmas; what no signal tells is left alone."""
    rng = np.random.default_rng(3)
    jacobian = rng.normal(0, 40, (2, 9, 3))
    jacobian[1, :, 1] = 0
    theta = np.array([[0.3, -0.4, 1.5], [0.6, 0.0, -2.0]])
    residual = np.einsum("pck,pk->pc", jacobian, theta)
    place, force = false_reading(jacobian, residual, rng.uniform(5, 30, 9))
    assert_allclose(place, [0.5, 0.6], rtol=1e-9)
    assert_allclose(force, [1.5, 2.0], rtol=1e-9)


def test_no_slip_costs_nothing(calibrated):
    cost = slip_cost(coarse_spec(), calibrated, calibrated)
    assert_allclose(cost.cosine, 1, rtol=0, atol=1e-12)
    assert_allclose(cost.size_ratio, 1, rtol=0, atol=1e-12)
    for name in ("baseline_counts", "false_place_mm", "false_force_n", "rezeroed_place_mm"):
        assert_allclose(getattr(cost, name), 0, rtol=0, atol=1e-9)


def test_a_changed_zero_is_read_as_the_likelihood_says_and_re_zeroing_takes_it_away(calibrated):
    """A shift of the resting counts along ∂S/∂F alone: a false force, no false place."""
    spec = coarse_spec()
    grid_place, face = 7, 3
    x, y = [(ix - 1.5) * 3.0 for ix in range(4)], [(iy - 2) * 3.0 for iy in range(5)]
    at = (np.array([face]), np.array([x[grid_place // 5]]), np.array([y[grid_place % 5]]))
    cost = slip_cost(spec, calibrated, calibrated)
    force = cost.force_n[face - 1, grid_place]
    slope = signal_gradient(calibrated, *at, np.array([force])).d_force[0]
    moved = replace(
        calibrated, baseline_counts=calibrated.baseline_counts + 0.8 * slope.reshape(-1, 3)
    )
    cost = slip_cost(spec, calibrated, moved)
    assert_allclose(cost.false_force_n[face - 1, grid_place], 0.8, rtol=1e-9)
    assert_allclose(cost.false_place_mm[face - 1, grid_place], 0, rtol=0, atol=1e-9)
    assert_allclose(cost.rezeroed_force_n, 0, rtol=0, atol=1e-9)
    noise = np.tile(spec.sensors.noise_counts, 15)
    size = np.linalg.norm((0.8 * slope / noise).reshape(-1, 3), axis=1)
    assert_allclose(cost.baseline_sigma, size, rtol=1e-9)


def test_a_slip_misleads_the_calibrated_estimator(calibrated, sensors_only):
    cost = slip_cost(coarse_spec(), calibrated, sensors_only)
    sigma = disturbance_counts(coarse_spec().sensors, "fresh", 9)
    assert sigma.min() > 10
    assert np.median(cost.false_place_mm) > 5 * np.median(cost.rezeroed_place_mm)
    assert 0.05 < np.median(cost.rezeroed_place_mm) < 3
    assert cost.cosine.max() < 1
    assert cost.cosine.min() > 0


def test_forces_are_those_that_both_objects_reach(calibrated):
    """One of the two is softer on some faces and harder on the others."""
    spec = coarse_spec(score={"force_n": 500.0})
    share = np.array([0.6, 1.5, 0.8, 1.2, 0.7])[:, None]
    force = calibrated.force_n * share[..., None]
    other = replace(calibrated, force_n=force)
    whole = slip_cost(spec, calibrated, calibrated).force_n
    assert np.nanmax(whole) < 500
    for before, after in ((calibrated, other), (other, calibrated)):
        found = slip_cost(spec, before, after)
        assert_allclose(found.force_n, whole * np.minimum(share, 1))
