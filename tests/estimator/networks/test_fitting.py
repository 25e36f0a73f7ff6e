"""The rate at which networks learn."""

import numpy as np
from numpy.testing import assert_allclose

from estimator.networks.training.fitting import Schedule, rate_factor


def test_the_learning_rate_warms_up_then_falls_by_half_a_cosine_to_one_percent():
    schedule = Schedule(20, 64, 1e-3, 0.0, 20, None, seed=0)
    rates = np.array([rate_factor(epoch, schedule) for epoch in np.linspace(0, 20, 81)])
    top = int(np.argmax(rates))
    assert_allclose(rates[top], 1.0)
    assert_allclose(np.diff(rates[1 : top + 1], 2), 0.0, atol=1e-12)
    falling = rates[top:]
    assert_allclose(falling[-1], 0.01)
    assert_allclose(falling + falling[::-1], 1.01)  # half a cosine is odd about its middle
    assert np.all(np.diff(falling) < 0)
