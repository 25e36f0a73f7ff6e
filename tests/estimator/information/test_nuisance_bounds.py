"""Bounds of an object that is turned and warmed: against the whole covariance inverted."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.information.fisher import (
    cramer_rao_bounds,
    detectable_force_n,
    disturbance_counts,
    position_and_force_bounds,
    whitened,
)
from estimator.information.identifiability import jacobians_of
from estimator.information.nuisance_cost import EVERY, nuisance_costs
from estimator.information.scores import score_places
from estimator.signals.interpolation import Traces
from estimator.signals.live import live_jacobian
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(score={"force_n": 6.0})
SIGMA = disturbance_counts(SPEC.sensors, "fresh", 45)


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


def covariance(columns, seen=slice(None)):
    return np.diag(SIGMA[seen] ** 2) + columns[seen] @ columns[seen].T


def inverted(jacobian, columns):
    """Position and force bounds of one press, by inverting what its live channels have in common."""
    seen = jacobian.any(axis=1)
    information = jacobian[seen].T @ np.linalg.solve(covariance(columns, seen), jacobian[seen])
    variance = np.diag(np.linalg.inv(information))
    return np.sqrt(variance[0] + variance[1]), np.sqrt(variance[2])


@pytest.mark.parametrize("dead", [[], [0, 7, 20]])
@pytest.mark.parametrize("bounds", [cramer_rao_bounds, position_and_force_bounds])
def test_bounds_are_those_of_the_whole_covariance(bounds, dead):
    """With columns of a tenth and of a hundred noises; channels that stand still in some presses drop out."""
    rng = np.random.default_rng(3)
    jacobian, columns = 50 * rng.normal(size=(4, 45, 3)), rng.normal(size=(45, 4))
    columns *= [2.0, 20.0, 400.0, 2000.0]
    jacobian[1:3, dead] = 0
    found = bounds(jacobian, SIGMA, columns)
    position, force = (found.position_mm, found.force_n) if bounds is cramer_rao_bounds else found
    wanted = np.array([inverted(one, columns) for one in jacobian])
    assert_allclose(np.column_stack([position, force]), wanted, rtol=1e-8)


def test_whitened_signals_lie_as_far_apart_as_the_covariance_says():
    rng = np.random.default_rng(4)
    change, columns = 100 * rng.normal(size=(5, 45)), 300 * rng.normal(size=(45, 4))
    wanted = np.einsum("ni,ni->n", change, np.linalg.solve(covariance(columns), change.T).T)
    assert_allclose((whitened(change, SIGMA, columns) ** 2).sum(axis=1), wanted)


def test_a_force_is_detected_where_its_distance_by_the_covariance_is_five():
    rng = np.random.default_rng(5)
    slope, columns = 10 * rng.normal(size=(3, 45)), 200 * rng.normal(size=(45, 4))
    force = np.linspace(0.0, 60.0, 13) * np.ones((3, 1))
    never = np.zeros((3, 13), bool)
    traces = Traces(np.arange(13.0), force, force[..., None] * slope[:, None], never)
    found = detectable_force_n(traces, SIGMA, nuisances=columns)
    square = np.einsum("ni,ni->n", slope, np.linalg.solve(covariance(columns), slope.T).T)
    assert_allclose(found, 5 / np.sqrt(square), rtol=1e-3)


@pytest.mark.parametrize("channels", ["all", "own"])
def test_scores_and_contact_sets_of_a_turned_and_warmed_object(signals, channels):
    """A press at one place, by the covariance of the channels that are read."""
    spec = SPEC.changed(score=SPEC.score.changed(channels=channels))
    scores, columns, face, place = score_places(spec, signals), nuisance_columns(spec), 3, 7
    x, y = scores.grid.xy_mm[[place]].T
    force = scores.force_at_score_n[face - 1, [place]]
    jacobian = live_jacobian(spec, signals, np.array([face]), x, y, force)[0]
    if channels == "own":
        jacobian[: 9 * (face - 1)] = jacobian[9 * face :] = 0
    position, newton = inverted(jacobian, columns)
    assert scores.position_bound_mm[face - 1, place] == pytest.approx(position)
    assert scores.force_bound_n[face - 1, place] == pytest.approx(newton)
    of_face = jacobians_of(spec, signals, np.array([place]))[face - 1]
    white = of_face.whitened[0] if channels == "all" else of_face.face_channels[0]
    variance = np.diag(np.linalg.inv(white.T @ white))
    assert np.sqrt(variance[:2].sum()) == pytest.approx(position)
    steady = score_places(spec.changed(limits=spec.limits.changed(use="bench")), signals)
    assert (scores.position_bound_mm >= steady.position_bound_mm).all()
    assert (scores.detectable_force_n >= steady.detectable_force_n).all()
    assert (scores.position_bound_mm > 1.01 * steady.position_bound_mm).any()


@pytest.mark.parametrize("channels", ["all", "own"])
def test_costs_are_ratios_of_median_bounds(signals, channels):
    """Of scores with one nuisance left in, with all and without any."""
    spec = SPEC.changed(score=SPEC.score.changed(channels=channels))
    sizes = {
        "ambient field": {"temperature_k": 0.0},
        "temperature": {"earth_field_ut": 0.0},
        EVERY: {},
    }
    costs = nuisance_costs(spec, signals, score_places(spec, signals))
    assert [one.name for one in costs] == list(sizes)
    bench = spec.changed(limits=spec.limits.changed(use="bench"))
    steady = score_places(bench, signals)
    for cost, size in zip(costs, sizes.values(), strict=True):
        moved = score_places(spec.changed(tolerances=spec.tolerances.changed(**size)), signals)
        for ratio, name in ((cost.position, "position_bound_mm"), (cost.force, "force_bound_n")):
            wanted = np.median(getattr(moved, name)) / np.median(getattr(steady, name))
            assert ratio == pytest.approx(wanted)
            assert ratio >= 1
    assert nuisance_costs(bench, signals, steady) == ()
