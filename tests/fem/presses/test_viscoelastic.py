"""Relaxing forces against the analytic moduli of a Prony series."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad

from fem.presses.viscoelastic import relaxed_force_n

TERMS = ((0.15, 0.4), (0.25, 3.0))


def dynamic_modulus(omega, terms=TERMS):
    """Storage and loss modulus over the modulus at once."""
    storage = 1 - sum(share / (1 + (omega * tau) ** 2) for share, tau in terms)
    loss = sum(share * omega * tau / (1 + (omega * tau) ** 2) for share, tau in terms)
    return storage, loss


def swung(omega, steps=400):
    """Steady sinusoid about a mean large enough that no force is negative."""
    time = np.linspace(0, 30 + 4 * np.pi / omega, int(steps * (30 * omega / 2 / np.pi + 2)))
    return time, 5 + np.sin(omega * time)


@pytest.mark.parametrize("omega", [0.7, 3.1])
def test_a_sinusoid_sees_the_storage_and_the_loss_modulus(omega):
    time, elastic = swung(omega)
    force = relaxed_force_n(elastic, time, TERMS)
    last = time > time[-1] - 2 * np.pi / omega
    basis = np.stack([np.sin(omega * time), np.cos(omega * time), np.ones_like(time)], axis=1)
    (sine, cosine, mean), *_ = np.linalg.lstsq(basis[last], force[last])
    storage, loss = dynamic_modulus(omega)
    assert_allclose([sine, cosine], [storage, loss], rtol=1e-3)
    assert_allclose(mean, 5 * (1 - 0.4), rtol=1e-3)


def test_a_step_relaxes_to_what_the_series_leaves():
    time = np.array([0.0, 0.3, 1.1, 40.0])
    force = relaxed_force_n(np.array([[2.0], [3.0]]) * np.ones(4), time, TERMS)
    expected = 2 * (1 - 0.15 * -np.expm1(-time / 0.4) - 0.25 * -np.expm1(-time / 3.0))
    assert_allclose(force[0], expected, rtol=1e-12)
    assert_allclose(force[:, -1], [2 * 0.6, 3 * 0.6], rtol=1e-5)


def test_a_broken_line_is_integrated_exactly_at_uneven_times():
    time = np.array([0.0, 0.2, 0.9, 1.0, 2.5])
    elastic = np.array([0.0, 1.0, 4.0, 3.5, 3.0])
    slopes = np.diff(elastic) / np.diff(time)

    def modulus(age):
        return 1 - sum(fraction * -np.expm1(-age / time_s) for fraction, time_s in TERMS)

    expected = [
        sum(
            slope * quad(lambda s, at=at: modulus(at - s), start, min(end, at))[0]
            for slope, start, end in zip(slopes, time, time[1:], strict=False)
            if start < at
        )
        for at in time
    ]
    assert_allclose(relaxed_force_n(elastic, time, TERMS), expected, rtol=1e-10)


def press(seconds, frames=81):
    time = np.linspace(0, seconds, frames)
    return time, 8 * (1 - np.cos(2 * np.pi * time / seconds)) / 2


def test_unloading_is_softer_than_loading_and_the_tip_lifts_off_early():
    time, elastic = press(4.0)
    force = relaxed_force_n(elastic, time, TERMS)
    assert (force[21:40] > force[59:40:-1]).all()
    assert force.min() == 0.0
    assert (force[-4:] == 0).all()


@pytest.mark.parametrize(("seconds", "share"), [(1e-4, 1.0), (1e4, 0.6)])
def test_fast_and_slow_presses_are_elastic(seconds, share):
    time, elastic = press(seconds)
    assert_allclose(relaxed_force_n(elastic, time, TERMS), share * elastic, atol=0.01)


def test_without_terms_the_force_is_the_elastic_one():
    time, elastic = press(4.0)
    assert relaxed_force_n(elastic, time, ()) is elastic
