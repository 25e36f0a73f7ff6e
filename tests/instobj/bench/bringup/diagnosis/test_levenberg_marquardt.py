"""Many small fits side by side, against least squares in closed form and by scipy."""

import numpy as np
from numpy.testing import assert_allclose
from scipy.optimize import least_squares

from instobj.bench.bringup.diagnosis.levenberg_marquardt import many_most_probable


def test_linear_problems_are_solved_in_a_few_steps_and_their_cost_is_half_the_squares():
    """Damping falls five times with each step that gains: after four steps 1e-8 of the way is left."""
    rng = np.random.default_rng(1)
    slope, target = rng.normal(size=(6, 8, 3)), 1e3 * rng.normal(size=(6, 8))

    def residuals(value):
        return np.einsum("prx,px->pr", slope, value) - target

    found, cost = many_most_probable(residuals, np.zeros((6, 3)), iterations=4)
    for k in range(6):
        exact, (left,), *_ = np.linalg.lstsq(slope[k], target[k], rcond=None)
        assert_allclose(found[k], exact, rtol=1e-5)
        assert_allclose(cost[k], left / 2, rtol=1e-9)


def test_a_step_that_does_not_gain_is_not_taken_and_the_next_is_shorter():
    """Rosenbrock's valleys, from starts on both sides; scipy finds the same ends."""

    def residuals(value):
        x, y = value.T
        return np.stack([10 * (y - x**2), 1 - x], axis=1) * 100

    start = np.array([[-1.2, 1.0], [0.0, 3.0], [2.0, -2.0]])
    costs = [many_most_probable(residuals, start, iterations=n)[1] for n in (1, 2, 4, 8, 16)]
    assert (np.diff(costs, axis=0) <= 0).all()
    found, cost = many_most_probable(residuals, start, iterations=200)
    for k, one in enumerate(start):
        other = least_squares(lambda v: residuals(v[None])[0], one, method="lm")
        assert_allclose(found[k], other.x, atol=2e-3)
    assert_allclose(cost, 0, atol=0.05)


def test_it_ends_where_nothing_is_gained():
    calls = []

    def residuals(value):
        calls.append(len(value))
        return np.concatenate([value - 1.0, 0 * value], axis=1)

    found, _ = many_most_probable(residuals, np.zeros((2, 2)), iterations=50)
    assert_allclose(found, 1, atol=1e-3)
    assert len(calls) < 1 + 3 * 5
