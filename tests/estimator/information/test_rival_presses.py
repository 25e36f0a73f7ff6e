"""Rival presses: signals and slopes of the interpolant at the lattice's places, live channels alone."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.layout.places.contact_grid import press_lattice
from estimator.information.rival_presses import place_slopes, rival_presses
from estimator.signals.hall import full_scale_counts
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec()
OWN = np.arange(18, 27)


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


def test_signals_and_slopes_are_the_interpolants(signals):
    rivals = rival_presses(SPEC, signals, 3, OWN)
    x, y = press_lattice(SPEC).xy_mm.T
    for level in (1, 4):
        force = np.full(len(x), rivals.force_n[level])
        assert rivals.is_pressed[:, level].all()
        gradient = signal_gradient(signals, np.full(len(x), 3), x, y, force)
        assert_allclose(rivals.signals[:, level], gradient.counts[:, OWN], atol=1e-6)
        size = abs(gradient.jacobian[:, OWN]).max(axis=(0, 1))
        off = (rivals.slopes[:, level] - gradient.jacobian[:, OWN]) / size
        assert np.sqrt(np.mean(off**2)) < 5e-3  # splines at equal force, not at equal depth


def test_presses_are_there_up_to_the_deepest_of_each_place(signals):
    rivals = rival_presses(SPEC, signals, 3, OWN)
    reach = signals.force_n[2, :, -1]
    assert_array_equal(
        rivals.is_pressed, rivals.force_n <= reach[:, None] * (1 + 1e-12)
    )  # up to rounding
    assert_allclose(rivals.force_n[-1], reach.max())
    assert 0 < rivals.is_pressed[:, -1].sum() < 10


def test_places_whose_force_does_not_grow_are_left_out_and_continued(signals):
    force = signals.force_n.copy()
    force[2, 7, -1] = force[2, 7, -2]
    rivals = rival_presses(SPEC, replace(signals, force_n=force), 3, OWN)
    whole = rival_presses(SPEC, signals, 3, OWN)
    assert_array_equal(rivals.xy_mm, np.delete(whole.xy_mm, 7, axis=0))
    beside = np.delete(whole.signals, 7, axis=0)
    assert_allclose(rivals.signals, beside, atol=1e-3 * abs(beside).max())
    off = (rivals.slopes - np.delete(whole.slopes, 7, axis=0)) / abs(whole.slopes).max(
        axis=(0, 1, 2)
    )
    assert abs(off).max() < 0.05


def test_channels_beyond_their_range_stand_still(signals):
    most = full_scale_counts(SPEC.sensors)
    rest = signals.baseline_counts.copy()
    largest = abs(signals.delta_counts[2, :, :, 6:9]).max(axis=(0, 1))
    sensor, axis = np.unravel_index(largest.argmax(), (3, 3))
    deepest = signals.delta_counts[2, :, :, 6 + sensor, axis]
    at = deepest.flat[abs(deepest).argmax()]
    rest[6 + sensor, axis] = np.sign(at) * (most - abs(at) / 2)
    rest[7 if sensor != 1 else 8, 0] = 1.1 * most
    clipped = rival_presses(SPEC, replace(signals, baseline_counts=rest), 3, OWN)
    channel = 3 * sensor + axis
    beyond = (
        abs(rest[6 + sensor, axis] + rival_presses(SPEC, signals, 3, OWN).signals[..., channel])
        > most
    )
    assert beyond.any()
    assert (clipped.slopes[beyond, channel] == 0).all()
    assert (clipped.slopes[~beyond, channel] != 0).any()
    dead = 3 * (1 if sensor != 1 else 2)
    assert (clipped.slopes[..., dead, :] == 0).all()
    assert (clipped.signals[..., dead] == 0).all()


def test_place_slopes_are_perpendicular_and_carry_the_information_left_by_force():
    slopes = np.random.default_rng(4).normal(size=(6, 9, 3)) * [3.0, 0.4, 2.0]
    found = place_slopes(slopes)
    covariance = np.linalg.inv(slopes.swapaxes(1, 2) @ slopes)[:, :2, :2]
    told = found.axes.swapaxes(1, 2) @ (found.axes / found.per_mm[..., None] ** 2)
    assert_allclose(told, covariance, rtol=1e-9)
    assert_allclose(
        found.patterns @ found.patterns.swapaxes(1, 2), np.tile(np.eye(2), (6, 1, 1)), atol=1e-9
    )
    assert_allclose(found.patterns @ slopes[..., 2:], 0, atol=1e-9)
    blind = place_slopes(slopes[:1] * [1.0, 0.0, 1.0])
    assert_allclose(blind.per_mm[0, 1], 0, atol=1e-9)
