"""Simulated presses worked out by hand: travel, loops, pulls and labels of made-up objects."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.spec.object import ObjectSpec
from estimator.frames import collection, collection_recipe, contact_traces, tangential
from estimator.frames.contact_traces import ContactTraces, force_at_travel, travel_at_force
from estimator.signals.interpolation import Traces

DEPTH = np.linspace(0, 4, 17)


def traces(cases=2, tips=2):
    """Forces grow as travel to the power 1.5, counts and the tips' forces in proportion to force."""
    travel = DEPTH * np.arange(1, cases + 1)[:, None]
    force = 2 * travel**1.5
    share = np.array([0.25, 0.75])[:tips]
    counts = force[..., None] * [10.0, -5.0, 3.0]
    return ContactTraces(travel, force, force[..., None] * share, counts)


def test_force_and_travel_are_each_other_s_inverse_up_to_the_deepest_press():
    made = traces()
    travel = np.array([[0.0, 0.7, 3.1, 9.0, -1.0], [0.0, 0.7, 3.1, 7.9, 9.0]])
    held = np.array([[0.0, 0.7, 3.1, 4.0, 0.0], [0.0, 0.7, 3.1, 7.9, 8.0]])
    force = force_at_travel(made, travel)
    assert_allclose(force, 2 * held**1.5, rtol=1e-9)
    assert_allclose(travel_at_force(made, force), held, atol=1e-6)
    beyond = travel_at_force(made, np.array([[999.0], [999.0]]))
    assert_allclose(beyond, [[4.0], [8.0]])


def spec(**collected):
    return ObjectSpec.model_validate({"name": "c", "collection": collected})


def test_a_press_is_felt_with_the_elastic_force_that_its_signals_keep():
    made = traces()
    turns = np.array([[0.0, 0.25, 0.5, 0.75, 1.25]] * 2)
    peak = np.array([2.0, 3.0])
    recipe = SimpleNamespace(traces=made, turns=turns, peak_mm=peak, pull=None)
    felt, counts = collection.pressed_tips.__wrapped__(spec(), recipe, slice(0, 2))
    elastic = 2 * (peak[:, None] * [0, 0.5, 1, 0.5, 0.5]) ** 1.5
    wanted = elastic
    assert_allclose(felt.sum(axis=2), wanted, rtol=1e-6)
    assert_allclose(felt[..., 0], 0.25 * wanted, rtol=1e-6)
    assert_allclose(counts, elastic[..., None] * [10.0, -5.0, 3.0], rtol=1e-6)
    second, _ = collection.pressed_tips.__wrapped__(spec(), recipe, slice(1, 2))
    assert_allclose(second[0], felt[1])


def test_a_pull_changes_the_signals_by_its_share_of_the_force_that_is_felt():
    made = traces(cases=1)
    grown = np.linspace(0, 20, 5)[None]
    flat = np.zeros((1, 5), bool)
    slopes = tuple(
        Traces(np.arange(5.0), grown, np.ones((1, 5, 3)) * slope, flat)
        for slope in ([1.0, 0, 0], [0, 2.0, 0])
    )
    pull = SimpleNamespace(slopes=slopes, share=np.array([[0.5, -0.25]]))
    pull.select = lambda part: pull
    recipe = SimpleNamespace(
        traces=made, turns=np.array([[0.25, 0.5]]), peak_mm=np.array([2.0]), pull=pull
    )
    plain = SimpleNamespace(**{**vars(recipe), "pull": None})
    felt, counts = collection.pressed_tips.__wrapped__(spec(), recipe, slice(0, 1))
    _, unpulled = collection.pressed_tips.__wrapped__(spec(), plain, slice(0, 1))
    total = felt.sum(axis=2)
    assert_allclose(counts - unpulled, total[..., None] * [0.5, -0.5, 0], rtol=1e-9)


def test_counts_of_a_pull_are_those_along_x_and_y_at_the_normal_force():
    force = np.array([[0.0, 2.0, 4.0]])
    nodes = np.zeros((1, 3), bool)
    along_x = Traces(np.arange(3.0), force, force[..., None] * [1.0, 3.0], nodes)
    along_y = Traces(np.arange(3.0), force, force[..., None] * [-2.0, 0.5], nodes)
    pulled = np.array([[[2.0, 1.0], [0.0, -1.0]]])
    found = tangential.pulled_counts((along_x, along_y), np.array([[1.0, 9.0]]), pulled)
    assert_allclose(found, [[[2 * 1 - 2, 2 * 3 + 0.5], [8.0, -2.0]]])


def test_every_period_of_every_case_is_a_press_of_its_own():
    recipe = SimpleNamespace(turns=np.array([[0.2, 0.9, 1.1, 2.0], [0.0, 0.5, 0.99, 1.0]]))
    assert collection.press_ids.__wrapped__(recipe).tolist() == [0, 0, 1, 2, 3, 3, 3, 4]


def test_values_of_tips_are_padded_and_cases_without_contact_empty():
    one = SimpleNamespace(face=np.array([3]), xy_mm=np.array([[1.0, 2.0]]))
    two = SimpleNamespace(face=np.array([3, 5]), xy_mm=np.array([[1.0, 2.0], [3.0, 4.0]]))
    recipe = SimpleNamespace(cases=[one, two], turns=np.zeros((3, 1)), traces=traces())
    assert collection.tip_values.__wrapped__(recipe, "face", 0, int).tolist() == [
        [3, 0],
        [3, 5],
        [0, 0],
    ]
    xy = collection.tip_values.__wrapped__(recipe, "xy_mm", np.nan, float)
    assert_array_equal(xy[0], [[1, 2], [np.nan, np.nan]])
    assert xy.shape == (3, 2, 2)


def test_a_squeeze_travels_by_both_jaws_and_a_probe_by_its_deepest_tip():
    def press(depth):
        return SimpleNamespace(depth_mm=np.array(depth), force_n=np.ones(3), motion=np.ones((1, 6)))

    path = [press([1.0, 1.5, 0.5]), press([2.0, 3.0, 4.0])]
    grasp = SimpleNamespace(squeezed=True, cell=np.array([0, 0, 1]))
    given = contact_traces.corrected_traces.__wrapped__
    assert given(None, grasp, path, None)[0].tolist() == [2.0, 7.0]
    probe = SimpleNamespace(squeezed=False, cell=np.array([0, 0, 1]))
    travel, force, motion = given(None, probe, path, None)
    assert travel.tolist() == [1.5, 4.0]
    assert (force.shape, motion.shape) == ((2, 3), (2, 1, 6))


def test_pulls_point_anywhere_up_to_the_largest_share(monkeypatch):
    monkeypatch.setattr(collection_recipe, "slope_traces", lambda *given: "slopes")
    monkeypatch.setattr(collection_recipe, "Pull", lambda share, slopes: share)
    case = SimpleNamespace(face=np.array([3]), xy_mm=np.zeros((1, 2)))
    given = spec(kind="continuous", tangential_share=0.4)
    share = collection_recipe.pull_of.__wrapped__(
        given, None, [case] * 400, "shear", np.random.default_rng(0)
    )
    size = np.linalg.norm(share, axis=1)
    assert (0.38 < size.max() <= 0.4, size.min() < 0.02) == (True, True)
    assert np.mean(size) == pytest.approx(0.2, abs=0.02)
    assert_allclose(share.mean(axis=0), 0, atol=0.03)
    assert_allclose(share.std(axis=0), 0.4 / np.sqrt(6), atol=0.02)
