"""Choice of the next press against conditioning of a joint normal distribution."""

import numpy as np
from numpy.testing import assert_allclose

from estimator.calibration.twin.least_known import PosteriorVariance, press_order, prior_variance
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

PLACES, SIGNALS = 5, 3


def doubt_of(seed):
    rng = np.random.default_rng(seed)
    root = rng.standard_normal((PLACES * SIGNALS, 9))
    noise = np.stack([np.diag(rng.uniform(0.2, 2.0, SIGNALS)) + 0.1 for _ in range(PLACES)])
    shape = (PLACES, SIGNALS, PLACES, SIGNALS)
    return PosteriorVariance((root @ root.T + 0.1 * np.eye(len(root))).reshape(shape), noise)


def conditioned(doubt, pressed):
    """Covariance after presses, all at a time, by the textbook's formula."""
    flat = doubt.covariance_counts2.reshape(PLACES * SIGNALS, -1)
    rows = np.concatenate([np.arange(SIGNALS) + SIGNALS * place for place in pressed])
    own = flat[np.ix_(rows, rows)].copy()
    for k, place in enumerate(pressed):
        part = slice(k * SIGNALS, (k + 1) * SIGNALS)
        own[part, part] += doubt.noise_counts2[place]
    return flat - flat[:, rows] @ np.linalg.solve(own, flat[rows])


def test_presses_one_by_one_leave_what_all_together_leave():
    doubt = doubt_of(1)
    after = doubt.condition_on(3).condition_on(0).condition_on(3)
    wanted = conditioned(doubt, [3, 0, 3])
    assert_allclose(after.covariance_counts2.reshape(wanted.shape), wanted, atol=1e-10)


def test_the_next_press_is_the_one_that_leaves_least_variance():
    for seed in range(5):
        doubt = doubt_of(seed)
        order, residual = press_order(doubt, 3)
        for k in range(3):
            free = [place for place in range(PLACES) if place not in order[:k]]
            traces = [np.trace(conditioned(doubt, [*order[:k], place])) for place in free]
            assert order[k] == free[int(np.argmin(traces))]
            assert_allclose(residual[k] ** 2 * PLACES * SIGNALS, min(traces), rtol=1e-9)


def test_every_place_is_pressed_before_any_is_pressed_again():
    order, residual = press_order(doubt_of(2), 2 * PLACES)
    assert sorted(order[:PLACES]) == sorted(order[PLACES:]) == list(range(PLACES))
    assert np.all(np.diff(residual) < 0)


def test_the_doubt_of_an_object_is_that_of_its_tolerances_and_falls_with_presses():
    spec = coarse_spec(
        contact_grid={"count": (2, 2), "pitch_mm": 8.0}, press={"depths_mm": (1.0, 3.0)}
    )
    doubt = prior_variance(spec, *synthetic_presses(spec), 3, 6.0)
    assert doubt.covariance_counts2.shape == (4, 18, 4, 18)
    flat = doubt.covariance_counts2.reshape(72, 72)
    assert_allclose(flat, flat.T, rtol=1e-9)
    assert np.linalg.eigvalsh(flat).min() > -1e-6 * np.linalg.eigvalsh(flat).max()
    zero = spec.sensors.zeroing_counts
    assert np.all(np.diagonal(doubt.noise_counts2, axis1=1, axis2=2) > zero**2)
    _, residual = press_order(doubt, 4)
    assert residual[-1] < 0.5 * doubt.rms_counts
