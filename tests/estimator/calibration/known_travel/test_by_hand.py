"""Bound, agreement, registration and readers on a field made up: every number worked out another way."""

from dataclasses import astuple
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import spearmanr

from estimator.calibration.known_travel import agreement, bound, places
from estimator.calibration.known_travel.agreement import figures, travel_agreement
from estimator.calibration.known_travel.fit import Fitted
from estimator.calibration.known_travel.model import SYMMETRIES, Pose, TravelModel, Twin
from estimator.recordings.formats.travel import TravelRecording

POSE = Pose(np.array([10.0, -4.0]), 0.3, 7.0, 3)
TWIN = Twin(POSE, np.zeros((2, 3)), np.zeros((2, 2)))
RESTING_MT = np.array([[1.0, -2, 3], [4, 5, -6], [0.5, 0, 7]])


class Made(TravelModel):
    """Motions that are place and travel, a field that is quadratic in them."""

    def __init__(self):
        scene = SimpleNamespace(bodies=2)
        self.__dict__.update(scene=scene, asked=[])

    def covers(self, xy_mm):
        return xy_mm[:, 0] > -4.0

    def motion(self, xy_mm, travel_mm):
        self.asked.append((xy_mm, travel_mm))
        found = np.zeros((len(xy_mm), 2, 6))
        found[:, 0, :2], found[:, :, 2] = xy_mm, -0.6 * travel_mm[:, None]
        return found

    def change(self, twin, motion):
        assert twin is TWIN
        x, y, _ = motion[:, 0, :3].T
        by = -motion[:, 1, 2]
        parts = [x + 0.1 * x * y, 2 * y - 0.05 * y**2, 0.3 * by * x, 0.2 * x**2, by, 0.1 * x - y]
        return np.stack([*parts, by * y, by**2, 0.5 * by - 0.1 * x], axis=1).reshape(-1, 3, 3)


def of_machine(xy_mm, travel_mm):
    """Where a machine goes to press an object's places; against `test_poses.py`."""
    turn = np.array([[np.cos(0.3), -np.sin(0.3)], [np.sin(0.3), np.cos(0.3)]])
    xy = POSE.shift_mm + xy_mm @ SYMMETRIES[3].T @ turn.T
    return np.column_stack([xy, 7.0 - travel_mm])


def recording(xy_mm, travel_mm, place, noise_mt=0.0):
    model = Made()
    field = RESTING_MT + model.change(TWIN, model.motion(xy_mm, travel_mm))
    field = field + noise_mt * np.random.default_rng(0).standard_normal((len(xy_mm), 9, 9)).mean(
        axis=2, where=np.tri(9, dtype=bool)
    ).reshape(-1, 3, 3)
    return TravelRecording(np.arange(len(xy_mm)) * 1.0, of_machine(xy_mm, travel_mm), field, place)


def test_bound_and_scatter_are_of_the_noise_of_the_repeats_without_their_drift(monkeypatch):
    """81 places 1.5 mm apart with three repeats, one of them with four, one place with two alone."""
    axis = np.arange(-6, 6.1, 1.5)
    xy = np.stack(np.meshgrid(axis, axis, indexing="ij"), axis=-1).reshape(-1, 2)
    xy = xy + np.random.default_rng(2).uniform(-0.2, 0.2, xy.shape)
    place = np.sort(np.concatenate([np.repeat(np.arange(81), 3), [30, 81, 81]]))
    travel = np.linspace(1, 3, 82)[place]
    repeats = recording(np.vstack([xy, [[0.4, 0.4]]])[place], travel, place, 0.05)
    number = np.concatenate([np.arange(n) for n in np.bincount(place)])
    drift = np.array([0.5, -0.25, 0.1, 3.0])[number, None, None] * np.ones((3, 3))
    asked = []

    def attainable(slopes, precision, count, rng):
        asked.append((slopes, precision, count))
        return 0.75

    monkeypatch.setattr(bound, "attainable_correlation", attainable)
    monkeypatch.setattr(bound, "NULLS", 300)
    repeats = TravelRecording(repeats.time_s, repeats.tip_mm, repeats.field_mt + drift, place)
    found = bound.bound_test.__wrapped__(Made(), Fitted(TWIN, RESTING_MT, 0.0), repeats)

    kept, number = place < 81, np.where(place < 81, number, -1)
    flat = repeats.field_mt.reshape(-1, 9).copy()
    whole = flat.mean(axis=0)
    for turn in range(4):
        flat[number == turn] += whole - flat[number == turn].mean(axis=0)
    level = np.array([flat[place == k].mean(axis=0) for k in range(81)])
    left = flat[kept] - level[place[kept]]
    precision = np.linalg.inv(left.T @ left / (kept.sum() - 81))
    recorded = bound.recorded_slopes(xy, level)
    inside = np.flatnonzero(np.isfinite(recorded[:, 0, 0]) & (xy[:, 0] > -4.0))
    assert len(inside) > 40
    assert_allclose(found.xy_mm, xy[inside], atol=1e-9)
    x, y, by = *xy[inside].T, 0.6 * np.linspace(1, 3, 82)[inside]
    one, zero = np.ones(len(x)), np.zeros(len(x))
    by_x = [1 + 0.1 * y, zero, 0.3 * by, 0.4 * x, zero, 0.1 * one, zero, zero, -0.1 * one]
    by_y = [0.1 * x, 2 - 0.1 * y, zero, zero, zero, -one, by, zero, zero]
    slopes = np.stack([np.stack(by_x, axis=1), np.stack(by_y, axis=1)], axis=2)
    (given,) = asked
    assert_allclose(given[0], slopes, atol=1e-9)
    assert_allclose(given[1], precision)
    assert given[2] == [4 if k == 30 else 3 for k in inside]
    white = np.linalg.cholesky(precision)
    bounds, scatter = [], []
    for k, slope in zip(inside, slopes, strict=True):
        bounds.append(np.linalg.norm(np.linalg.pinv(white.T @ slope)))
        read = np.linalg.pinv(white.T @ recorded[k]) @ white.T @ left[place[kept] == k].T
        scatter.append(np.sqrt(np.var(read, axis=1, ddof=1).sum()))
    assert_allclose(found.bound_mm, bounds)
    assert_allclose(found.scatter_mm, scatter)
    of_slopes = [np.linalg.norm(np.linalg.pinv(white.T @ recorded[k])) for k in inside]
    assert_allclose(found.slopes_bound_mm, of_slopes)
    ratio = np.log(np.array(scatter) / bounds)
    assert_allclose(
        [found.size_ratio, found.size_spread], np.exp([np.median(ratio), np.std(ratio)])
    )
    assert_allclose(found.rank_correlation, spearmanr(bounds, scatter).statistic)
    assert_allclose(found.slopes_rank_correlation, spearmanr(bounds, of_slopes).statistic)
    assert found.null == pytest.approx(1.96 / np.sqrt(len(x) - 1), rel=0.2)
    assert found.attainable == 0.75


XY = np.random.default_rng(1).uniform(-5, 5, (12, 2))
TRAVEL = np.array([-0.5, 0.25, 0.5, 1.0, 1.25, 1.5, 1.75, 0.0, 2.0, 2.5, 2.75, 3.25])


def test_agreement_is_told_by_travel_beyond_a_depth_and_beside_exchanged_places_and_chips():
    """Travels of exactly 0, 1 and 2 mm begin the next millimetre; one press alone is not told."""
    model, place = Made(), np.arange(12)
    judged = recording(XY, TRAVEL, place, 0.5)
    registered = recording(XY[::-1], TRAVEL + 1, place, 0.5)
    fitted = Fitted(TWIN, RESTING_MT, 0.0)
    found = travel_agreement.__wrapped__(model, fitted, registered, judged, 4, beyond_mm=2.0)
    recorded = judged.field_mt - RESTING_MT
    predicted = model.change(TWIN, model.motion(XY, TRAVEL))

    def same(one, rows):
        assert_allclose(astuple(one), astuple(figures(predicted[rows], recorded[rows])))

    same(found.all, np.arange(12))
    same(found.beyond, [9, 10, 11])
    assert found.beyond_mm == 2
    assert list(found.by_travel) == ["0 to 1 mm", "1 to 2 mm", "2 to 3 mm"]
    same(found.by_travel["0 to 1 mm"], [1, 2, 7])
    same(found.by_travel["1 to 2 mm"], [3, 4, 5, 6])
    same(found.by_travel["2 to 3 mm"], [8, 9, 10])
    exchanged = [xy for xy, _ in model.asked[1:5]]
    for xy, one in zip(exchanged, found.places_exchanged, strict=True):
        assert_allclose(np.sort(xy, axis=0), np.sort(XY, axis=0))
        assert abs(xy - XY).max() > 1
        moved = model.change(TWIN, model.motion(xy, TRAVEL))
        assert_allclose(astuple(one), astuple(figures(moved, recorded)))
    orders = [(0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]
    for order, one in zip(orders, found.chips_permuted, strict=True):
        assert_allclose(astuple(one), astuple(figures(predicted[:, order], recorded)))


def test_rivals_are_fitted_to_the_registered_presses_alone():
    """One sinks all magnets by a share of the travel in twentieths, the other knows slopes."""
    model, place = Made(), np.arange(12)
    judged = recording(XY, TRAVEL, place, 0.5)
    registered = recording(XY[::-1] / 4, TRAVEL + 1, place, 0.5)
    found = agreement.rival_figures.__wrapped__(
        model, Fitted(TWIN, RESTING_MT, 0.0), registered, judged
    )
    assert list(found) == ["all magnets sink alike", "mean of the registered presses"]
    recorded, known = judged.field_mt - RESTING_MT, registered.field_mt - RESTING_MT
    shown = TRAVEL + 1

    def sunk(by_mm):
        return np.stack(
            [0 * by_mm] * 4 + [by_mm, 0 * by_mm, 0 * by_mm, by_mm**2, 0.5 * by_mm], axis=1
        )

    left = {k: np.sum((known.reshape(-1, 9) - sunk(k / 20 * shown)) ** 2) for k in range(1, 21)}
    best = min(left, key=left.get)
    assert 1 < best < 20
    alike = figures(sunk(best / 20 * TRAVEL).reshape(-1, 3, 3), recorded)
    assert_allclose(astuple(found["all magnets sink alike"]), astuple(alike))
    slope = np.linalg.lstsq(shown[:, None], known.reshape(-1, 9))[0]
    mean = figures((TRAVEL[:, None] * slope).reshape(-1, 3, 3), recorded)
    assert_allclose(astuple(found["mean of the registered presses"]), astuple(mean))
    assert list(agreement.chip_orders(3)) == [(0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]
    assert len(agreement.chip_orders(5)) == 119
    assert len(agreement.chip_orders(6)) == agreement.ORDERS_OF_CHIPS


@pytest.mark.parametrize(
    ("xy", "covered"),
    [((-3.75, 1.0), True), ((-3.81, 1.0), False), ((6.79, 1), True), ((6.81, 1), False),
     ((0, -0.79), True), ((0, -0.81), False), ((0, 8.79), True), ((0, 8.81), False)],
)  # fmt: skip
def test_the_table_covers_places_0_2_mm_within_its_border(xy, covered):
    model = object.__new__(TravelModel)
    model.__dict__.update(x_mm=np.array([-4.0, 1, 7]), y_mm=np.array([-1.0, 2, 9]))
    assert model.covers(np.array([[1.0, 2], xy])).tolist() == [True, covered]


def test_between_nodes_the_twin_reads_their_mean_by_likelihood(monkeypatch):
    """Six nearest nodes, of exp(−d²/2) each, in units of what the twin leaves and of a twentieth of
    the mean variance of that."""
    model = SimpleNamespace(
        pressed=lambda twin, tip: (
            np.stack([tip, tip * [0.5, 2, 1]], axis=1) + 0.01 * tip[:, :1, None]
        )
    )
    sizes = np.array([0.4, 0.9, 0.3, 0.7, 1.5, 0.2])
    left = np.sqrt(6) * np.vstack([np.diag(sizes), -np.diag(sizes)]).reshape(12, 2, 3)
    monkeypatch.setattr(places, "left_over", lambda model, fitted, labelled: left)
    tip = np.array([[0.3, 0.2, 0.1], [3.0, 4.0, 2.0], [1.4, 2.6, 0.9]])
    fitted = SimpleNamespace(twin=None, resting_mt=np.arange(6.0).reshape(2, 3))
    field = fitted.resting_mt + model.pressed(None, tip) + 0.3
    asked = TravelRecording(np.arange(3.0), tip, field, np.arange(3))
    found = places.places_by_twin.__wrapped__(model, fitted, range(12), asked)
    axes = np.arange(0.3, 3.31, 1.0), np.arange(0.2, 4.21, 1.0), np.arange(0.1, 2.11, 0.5)
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    variance = sizes**2 + 0.05 * np.mean(sizes**2)
    for read, seen in zip(found, field, strict=True):
        off = (seen - fitted.resting_mt - model.pressed(None, nodes)).reshape(-1, 6)
        d2 = np.sum(off**2 / variance, axis=1)
        near = np.argsort(d2)[:6]
        assert_allclose(read, np.average(nodes[near], axis=0, weights=np.exp(-d2[near] / 2)))


def test_a_process_reads_targets_of_any_size_and_middle_and_uses_all_presses_in_the_end(
    monkeypatch,
):
    """Learnt on 12 of 40 presses, conditioned on all of them: between these the curve is known."""
    monkeypatch.setattr(places, "MOST_PRESSES", 12)
    x = np.linspace(0, 9, 40)[:, None]
    asked = np.linspace(0.4, 8.7, 30)[:, None]
    y, wanted = (
        np.hstack([np.sin(at / 2), 50 + 3 * np.cos(at / 2), -7 + 0.1 * at]) for at in (x, asked)
    )
    inputs, query = np.hstack([1e3 + x, -2 * x]), np.hstack([1e3 + asked, -2 * asked])
    found = places.gaussian_process(inputs, y, query, 1)
    assert (abs(found - wanted) < [0.02, 0.06, 0.01]).all()
