"""Signals between places and forces against direct evaluation, and their derivatives."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.interpolate import PchipInterpolator

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from estimator.signals.interpolation import (
    Traces,
    among_pressed,
    corrected_traces,
    counts_at_force,
    depth_at_force,
    force_at_depth,
    grows_by_step,
    press_traces,
    signal_gradient,
    unresolved_presses,
)
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, force_n, synthetic_presses

SPEC = coarse_spec(press={"depths_mm": (0.25, 0.5, 0.75, 1, 1.5, 2, 2.5, 3, 3.5, 4)})


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


def direct_signals(x_mm, y_mm, depths_mm):
    """Signals simulated at the places and depths themselves, on a lattice x × y."""
    fine = SPEC.model_copy(update={"press": SPEC.press.model_copy(update={"depths_mm": depths_mm})})
    lattice = PlaceGrid(np.asarray(x_mm), np.asarray(y_mm))
    return press_signals(fine, *synthetic_presses(fine, lattice))


def presses_between(count=40):
    rng = np.random.default_rng(1)
    return rng.integers(1, 6, count), rng.uniform(-5.9, 5.9, count), rng.uniform(-7.4, 7.4, count)


def test_lattice_places_are_reproduced(signals):
    x, y = signals.lattice.xy_mm[37]
    traces = press_traces(signals, np.array([4]), np.array([x]), np.array([y]))
    assert_allclose(traces.force_n[0, 1:], signals.force_n[3, 37], rtol=1e-12)
    assert_allclose(traces.counts[0, 1:].reshape(-1, 15, 3), signals.delta_counts[3, 37], atol=1e-9)
    assert_allclose(traces.counts[0, 0], 0, atol=1e-12)


def test_places_between_are_within_the_stated_error(signals):
    direct = direct_signals([-4.3, -0.7, 2.9], [-6.6, 0.4, 3.7], SPEC.press.depths_mm)
    x, y = direct.lattice.xy_mm.T
    for face in (1, 4):
        traces = press_traces(signals, np.full(9, face), x, y)
        assert_allclose(traces.force_n[:, 1:], direct.force_n[face - 1], rtol=1e-3)
        expected = direct.delta_counts[face - 1].reshape(9, 10, 45)
        error = abs(traces.counts[:, 1:] - expected).max()
        assert error < 3e-3 * abs(signals.delta_counts[face - 1]).max()
        swapped = press_traces(signals, np.full(9, face), y * 0.8, x)
        assert abs(swapped.counts[:, 1:] - expected).max() > 30 * error


def test_forces_between_depths_are_within_the_stated_error(signals):
    depths = (0.15, 0.4, 0.9, 1.7, 2.2, 3.8)
    direct = direct_signals([-2.3, 1.1], [0.4, 5.0], depths)
    x, y = direct.lattice.xy_mm.T
    traces = press_traces(signals, np.full(4, 2), x, y)
    found = counts_at_force(traces, direct.force_n[1])
    expected = direct.delta_counts[1].reshape(4, 6, 45)
    assert_allclose(found.counts, expected, atol=5e-3 * abs(signals.delta_counts[1]).max())
    assert_allclose(depth_at_force(traces, direct.force_n[1]), np.tile(depths, (4, 1)), rtol=0.01)
    expected_force = force_n(2, direct.lattice.xy_mm, 2.2)
    assert_allclose(force_at_depth(traces, 2.2), expected_force, rtol=3e-3)


def test_derivatives_are_those_of_the_interpolant_and_of_the_physics(signals):
    face, x, y = presses_between()
    force = np.linspace(0.5, 8, len(face))
    gradient = signal_gradient(signals, face, x, y, force)
    assert_allclose(gradient.jacobian[..., 2], gradient.d_force, rtol=0)

    def counts(dx=0.0, dy=0.0, df=0.0):
        traces = press_traces(signals, face, x + dx, y + dy)
        return counts_at_force(traces, (force + df)[:, None]).counts[:, 0]

    step = 1e-5
    for found, change in (
        (gradient.d_x, {"dx": step}),
        (gradient.d_y, {"dy": step}),
        (gradient.d_force, {"df": step}),
    ):
        minus = {key: -value for key, value in change.items()}
        central = (counts(**change) - counts(**minus)) / (2 * step)
        assert_allclose(found, central, atol=1e-5 * abs(central).max())
    assert_allclose(gradient.counts, counts(), rtol=1e-12)
    # of the physics: against presses simulated 0.1 mm to either side, at constant force
    direct = direct_signals([0.9, 1.1], [2.2, 2.4], SPEC.press.depths_mm)
    at = np.full((4, 1), 7.0)
    x4, y4 = direct.lattice.xy_mm.T
    side = [
        PchipInterpolator(np.r_[0, f], np.concatenate([np.zeros((1, 45)), c.reshape(10, 45)]))(7.0)
        for f, c in zip(direct.force_n[2], direct.delta_counts[2], strict=True)
    ]
    centre = signal_gradient(signals, np.array([3]), np.array([1.0]), np.array([2.3]), at[0])
    slope = (side[2] + side[3] - side[0] - side[1]) / 0.4
    assert_allclose(centre.d_x[0], slope, atol=0.02 * abs(slope).max())
    # at constant depth the derivative would be another one: force changes with the place too
    assert abs(x4).max() < 2
    assert abs(y4).max() < 3


def test_forces_beyond_the_deepest_press_raise_or_are_flagged(signals):
    traces = press_traces(signals, np.array([1, 5]), np.array([0.3, -2.0]), np.array([1.0, 4.0]))
    reach = traces.force_n[:, -1]
    asked = np.stack([[1.0, reach[0] + 2], [2.0, 3.0]])
    with pytest.raises(InputError, match=r"a force of .* N was asked for .* reaches"):
        counts_at_force(traces, asked)
    held = counts_at_force(traces, asked, beyond="clamp")
    assert held.clamped.tolist() == [[False, True], [False, False]]
    assert_allclose(held.force_n, [[1.0, reach[0]], [2.0, 3.0]])
    assert_allclose(held.counts[0, 1], traces.counts[0, -1], rtol=1e-12)
    with pytest.raises(InputError, match="at least 0 N"):
        counts_at_force(traces, asked * -1)
    with pytest.raises(InputError, match=r"at least 0 N; got -0\.1"):
        counts_at_force(traces, np.array([[1.0, 2.0], [-0.1, 2.0]]))
    assert_allclose(counts_at_force(traces, np.zeros((2, 1))).counts, 0)


def test_places_off_the_lattice_and_unknown_faces_are_refused(signals):
    with pytest.raises(InputError, match=r"y = 9 mm lies outside .*lateral_jitter_mm"):
        press_traces(signals, np.array([1]), np.array([0.0]), np.array([9.0]))
    with pytest.raises(InputError, match="face 6 was not pressed"):
        press_traces(signals, np.array([6]), np.array([0.0]), np.array([0.0]))


def test_unresolved_shallow_press_goes_on_the_chord_and_is_marked(signals):
    force, delta = signals.force_n.copy(), signals.delta_counts.copy()
    force[2, 40, 0], delta[2, 40, 0] = 0.0, 0.0
    holed = replace(signals, force_n=force, delta_counts=delta)
    assert np.argwhere(unresolved_presses(holed)).tolist() == [[2, 40, 0]]
    x, y = (signals.lattice.xy_mm[40:41, i] for i in (0, 1))
    traces = press_traces(holed, np.array([3]), x, y)
    assert np.flatnonzero(traces.corrected[0]).tolist() == [1]
    assert_allclose(traces.force_n[0, 1], signals.force_n[2, 40, 1] / 2, rtol=1e-9)
    assert_allclose(traces.counts[0, 1], signals.delta_counts[2, 40, 1].ravel() / 2, rtol=1e-6)
    force[2, 40, -1] = force[2, 40, -2]
    with pytest.raises(InputError, match="the force on face 3 does not grow with depth"):
        press_traces(replace(signals, force_n=force), np.array([3]), x, y)


@pytest.mark.parametrize("nodes", [2, 3, 6])
def test_monotone_cubic_matches_scipy_and_its_complex_step(nodes):
    rng = np.random.default_rng(nodes)
    x = np.cumsum(rng.uniform(0.1, 2, (3, nodes)), axis=1)
    values = rng.normal(size=(3, nodes, 4)).cumsum(axis=1)
    at = np.sort(rng.uniform(x[:, :1], x[:, -1:], (3, 30)), axis=1)
    found = monotone_cubic(x, values, at)
    slope = np.imag(monotone_cubic(x, values, at + 1e-30j)) / 1e-30
    for i in range(3):
        reference = PchipInterpolator(x[i], values[i])
        assert_allclose(found[i], reference(at[i]), atol=1e-12)
        assert_allclose(slope[i], reference.derivative()(at[i]), atol=1e-11)


def test_places_are_among_the_pressed_in_cells_with_four_pressed_corners_and_on_their_edges():
    """Nodes at 0, 1, 3, 4 and 0, 2, 3; the corner (4, 3) was not pressed."""
    lattice = PlaceGrid(np.array([0.0, 1, 3, 4]), np.array([0.0, 2, 3]))
    pressed = np.ones(12, bool)
    pressed[11] = False
    places = {
        (0.0, 0.0): True, (4.0, 0.0): True, (0.0, 3.0): True, (2.0, 2.5): True, (3.5, 1.9): True,
        (3.5, 2.0): True, (3.0, 3.0): True, (3.0, 2.5): True, (3.5, 2.1): False,
        (3.1, 2.5): False, (4.0, 3.0): False, (4.0, 2.0): True,
    }  # fmt: skip
    x, y = np.array(list(places)).T
    assert among_pressed(lattice, pressed, x, y).tolist() == list(places.values())
    lone = np.zeros(12, bool)
    lone[[0, 1, 3, 4]] = True
    found = among_pressed(lattice, lone, np.array([0.5, 1.0, 1.1]), np.array([1.0, 2.0, 1.0]))
    assert found.tolist() == [True, True, False]


def test_a_force_grows_where_it_exceeds_all_before_it_by_a_micronewton():
    force = np.array([1e-6, 2.1e-6, 3.0, 2.0, 3.0, 3.1, -1.0])
    assert grows_by_step(force).tolist() == [False, True, True, False, False, True, False]
    assert grows_by_step(np.array([-2.0, -1.0, 0.5])).tolist() == [False, False, True]


def test_half_of_the_presses_of_a_place_must_grow_and_the_deepest_one():
    def traces(force):
        force = np.array([[0.0, *force]])
        return Traces(np.arange(force.shape[1]) + 0.0, force, force[..., None], force > 99)

    fine = corrected_traces(traces([1.0, 0.5, 2.0]), np.array([3]))
    assert_allclose(fine.force_n, [[0, 1, 1.5, 2]])
    assert fine.corrected.tolist() == [[False, False, True, False]]
    for force in ([1.0, 0.5, 0.4], [1.0, 2.0, 1.9], [0.0, 0.0, 1.0]):
        with pytest.raises(InputError, match="face 3 does not grow with depth"):
            corrected_traces(traces(force), np.array([3]))


def test_forces_up_to_a_billionth_beyond_the_deepest_press_are_no_clamped_ones():
    force = np.array([[0.0, 1.0, 2.0]])
    made = Traces(np.arange(3.0), force, force[..., None], force > 9)
    found = counts_at_force(made, np.array([[2.0, 2.0 + 1e-9, 2.0 + 1e-8]]), "clamp")
    assert found.clamped.tolist() == [[False, False, True]]
    assert found.force_n.max() == 2.0


def test_depth_and_force_of_a_sphere_s_press_are_each_other_s_inverse():
    """Force as depth to the power of 1.5: exact on the way there and back."""
    depth = np.array([0.0, 0.5, 1.0, 2.0, 4.0])
    force = np.stack([depth**1.5, 2 * depth**1.5])
    made = Traces(depth, force, force[..., None], force > 99)
    assert_allclose(force_at_depth(made, 1.5), [1.5**1.5, 2 * 1.5**1.5])
    found = depth_at_force(made, np.array([[1.5**1.5, 99.0], [1.0, 0.0]]))
    assert_allclose(found, [[1.5, 4.0], [0.5 ** (2 / 3), 0.0]], atol=1e-9)
