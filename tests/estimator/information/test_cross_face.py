"""Cross-face disturbance: relations, a worked case, and what must leave it unchanged."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.information.cross_face import cross_face_disturbance
from estimator.information.sensitivity import own_channels
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses


@pytest.fixture(scope="module")
def spec():
    return coarse_spec()


@pytest.fixture(scope="module")
def signals(spec):
    return press_signals(spec, *synthetic_presses(spec))


def test_each_face_has_one_opposite_but_the_top(spec, signals):
    cross = cross_face_disturbance(spec, signals)
    pairs = list(zip(cross.pressed.tolist(), cross.read.tolist(), strict=True))
    opposite = {pair for pair, r in zip(pairs, cross.relation, strict=True) if r == "opposite"}
    assert opposite == {(2, 4), (4, 2), (3, 5), (5, 3)}
    assert len(set(pairs)) == 20


def test_a_copied_own_press_is_read_as_its_own_force(spec, signals):
    """Give face 4's channels, in presses of face 1, the signals of presses on face 4 itself."""
    own = own_channels(signals, spec.sensors, 4)
    delta = signals.delta_counts.reshape(*signals.delta_counts.shape[:3], -1).copy()
    delta[0][..., own] = delta[3][..., own]
    force = signals.force_n.copy()
    force[0] = force[3]
    planted = replace(
        signals, delta_counts=delta.reshape(signals.delta_counts.shape), force_n=force
    )
    cross = cross_face_disturbance(spec, planted, force_n=6.0)
    row = int(np.flatnonzero((cross.pressed == 1) & (cross.read == 4))[0])
    np.testing.assert_allclose(cross.false_force_n[row], 6.0, rtol=0.03)


def test_the_summary_tells_the_tails_beside_the_median(spec, signals):
    cross = cross_face_disturbance(spec, signals)
    rows = [relation == "adjacent" for relation in cross.relation]
    size, force = (
        np.sort(cross.size_sigma[rows].ravel()),
        np.sort(cross.false_force_n[rows].ravel()),
    )
    found = cross.summary("adjacent")
    below = int(np.ceil(0.95 * (len(size) - 1)))
    assert size[below - 1] <= found["percentile_95_sigma"] <= size[below]
    assert force[below - 1] <= found["percentile_95_false_force_n"] <= force[below]
    assert found["median_sigma"] < found["percentile_95_sigma"] < found["largest_sigma"]


def test_no_change_elsewhere_is_no_false_force(spec, signals):
    delta = signals.delta_counts.copy()
    for face in range(1, 6):
        own = own_channels(signals, spec.sensors, face)
        others = np.setdiff1d(np.arange(signals.baseline_counts.size), own)
        delta[face - 1].reshape(*delta.shape[1:3], -1)[..., others] = 0
    cross = cross_face_disturbance(spec, replace(signals, delta_counts=delta))
    assert not cross.size_sigma.any()
    assert not cross.false_force_n.any()


def test_size_is_in_units_of_a_fresh_zero(spec, signals):
    cross = cross_face_disturbance(spec, signals)
    quiet = spec.sensors.model_copy(
        update={"noise_counts": (11.0, 11.0, 5.5), "zeroing_counts": 5.0}
    )
    halved = cross_face_disturbance(spec.model_copy(update={"sensors": quiet}), signals)
    np.testing.assert_allclose(halved.size_sigma, 2 * cross.size_sigma, rtol=1e-9)
    np.testing.assert_allclose(halved.false_force_n, cross.false_force_n, rtol=1e-9)
