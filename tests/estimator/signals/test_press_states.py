"""States beside a press: motions that are linear in force and place come back exactly."""

import numpy as np
from numpy.testing import assert_allclose

from estimator.signals.interpolation import Traces
from estimator.signals.press_states import ASIDE_MM, SIDES_MM, PressStates

PER_N = np.array([[0.1, -0.2, 0.3, 0.01, 0.02, -0.03], [0.0, 0.4, -0.1, 0.05, 0.0, 0.02]])
PER_N_MM = np.random.default_rng(1).normal(size=(2, 12)) * 0.01
REST = np.arange(12.0).reshape(2, 6) / 100
NODES_N = np.array([[0.0, 1, 2, 4, 8], [0.0, 0.5, 1, 2, 5]])
FORCE_N = np.array([3.0, 4.0])


def states(force_n=FORCE_N):
    """Two presses whose two bodies move in proportion to the force, more so to one side."""
    traces = []
    for side in SIDES_MM:
        slope = PER_N.ravel() + np.asarray(side) @ PER_N_MM
        counts = NODES_N[..., None] * slope
        traces.append(Traces(np.arange(5.0), NODES_N, counts, np.zeros((2, 5), bool)))
    return PressStates(tuple(traces), force_n, REST)


def test_sides_are_the_place_and_a_step_to_each_side_of_it():
    step = ASIDE_MM
    assert_allclose(SIDES_MM, [[0, 0], [step, 0], [-step, 0], [0, step], [0, -step]])


def test_states_are_at_the_place_beside_it_and_at_more_and_less_force():
    found = states().motion(1.0)
    assert found.shape == (7, 2, 2, 6)
    assert_allclose(found[0], REST + FORCE_N[:, None, None] * PER_N)
    aside = FORCE_N[:, None] * (ASIDE_MM * PER_N_MM[0])
    assert_allclose((found[1] - found[0]).reshape(2, 12), aside, atol=1e-12)
    assert_allclose((found[2] - found[0]).reshape(2, 12), -aside, atol=1e-12)
    more, less = (found[k] - found[0] for k in (5, 6))
    assert_allclose(more, -less, atol=1e-12)
    assert (more[:, 0, 0] > 0).all()


def test_slopes_are_those_by_place_and_force():
    made = states()
    values = made.motion(1.0).reshape(7, 2, 12)
    found = made.differentiate(values)
    for axis in (0, 1):
        assert_allclose(found[..., axis], FORCE_N[:, None] * PER_N_MM[axis], atol=1e-9)
        slope = made.slope_per_mm(made.motion(1.0))[axis].reshape(2, 12)
        assert_allclose(slope, FORCE_N[:, None] * PER_N_MM[axis], atol=1e-9)
    assert_allclose(found[..., 2], np.tile(PER_N.ravel(), (2, 1)), atol=1e-9)


def test_in_a_stiffer_silicone_a_force_moves_what_a_smaller_one_does():
    stiff = states().motion(2.0)
    half = states(FORCE_N / 2).motion(1.0)
    assert_allclose(stiff, half)
    assert_allclose(states().design_motion, states().motion(1.0))


def test_presses_whose_states_lie_beyond_the_deepest_are_told():
    assert states(np.array([7.0, 4.0])).simulated(1.0).tolist() == [True, True]
    assert states(np.array([8.0, 4.0])).simulated(1.0).tolist() == [False, True]
    assert states(np.array([7.0, 4.0])).simulated(0.7).tolist() == [False, False]
