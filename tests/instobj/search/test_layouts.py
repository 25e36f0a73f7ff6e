"""Layouts that the search page shows: which part of the start each part was, and where it lies."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec_io import parse_spec
from instobj.search.outcome.history import History
from instobj.search.outcome.layouts import ShownLayout, layouts_scene, shown_layouts
from instobj.search.verdict import Promoted, Promotion
from tests.support.archives import unpack
from tests.support.objects.made_histories import history_of_three, made_up_layouts
from tests.support.objects.search_cases import OBJECTIVES, made_up_scores, made_up_space, searched


def test_parts_lie_where_the_specification_has_them_and_know_what_they_were():
    layouts = made_up_layouts()
    content, _ = unpack(layouts_scene(layouts, history_of_three()))
    start, found = content["layouts"]
    for shown, spec in ((start, layouts[0].spec), (found, layouts[1].spec)):
        at, north = magnet_layout(spec).centre_mm, magnet_layout(spec).axis
        assert_allclose([one["at"] for one in shown["magnets"]], at, atol=1e-4)
        axes = np.array([one["axes"] for one in shown["magnets"]]).reshape(-1, 3, 3)
        assert_allclose(axes[:, :, 2], north, atol=1e-4)
        assert_allclose(np.linalg.det(axes), 1, atol=1e-3)
        assert len(shown["chips"]) == len(shown["boards"]) == len(sensor_layout(spec).face)
    assert start["magnet_from"] == list(range(25))
    nearest = [1, 0, 2]  # of the start's magnets, on each face
    assert found["magnet_from"] == [5 * face + k for face in range(5) for k in nearest]
    assert start["scores"] == [2.0, None], "JSON has no infinity"
    assert content["trials"] == [[1.0, 3.0], [2.0, 1.0]], "trials within all limits"


def test_the_leaders_come_first_and_the_rest_of_the_front_after_them(tmp_path):
    space = made_up_space(objectives=list(OBJECTIVES), trials=48)
    kept = searched(tmp_path / "trials.jsonl", score=made_up_scores,
                    objectives=list(OBJECTIVES), trials=48)  # fmt: skip
    trials = kept.finished
    values = np.array([trial.values for trial in trials])
    history = History(
        OBJECTIVES, values, np.ones(len(trials), bool), np.array([9.0, 9.0]),
        np.arange(1, 1 + len(trials)),
    )  # fmt: skip
    best = Promoted(f"trial {trials[5].number}", trials[5].number, space.spec, {})
    start = Promoted("start", None, space.spec, {})
    found = Promotion(start, (best,), (best,), {}, (), (1, 1))
    shown = shown_layouts(space, kept, found, history)
    assert [one.label for one in shown[:2]] == ["start", best.label]
    assert shown[1].scores == pytest.approx(tuple(values[5]))
    front = shown[2:]
    assert len(front) >= 2
    for one in front:
        beaten = (values <= one.scores).all(axis=1) & (values < one.scores).any(axis=1)
        assert not beaten.any(), "none is better in both"
        number = int(one.label.removeprefix("trial "))
        (trial,) = (trial for trial in trials if trial.number == number)
        assert one.spec.magnets.count == trial.params["magnet_count"]


def test_a_body_that_is_no_box_is_shown_with_its_own_surface():
    body = {"kind": "cylinder", "size_mm": [42.0, 42.0, 60.0], "open_faces": [6]}
    handle = parse_spec({"name": "h", "body": body, "sensors": {"radius_mm": 7.0}}, "h")
    layouts = [ShownLayout("start", handle, (1.0, 1.0))]
    content, arrays = unpack(layouts_scene(layouts, history_of_three()))
    points = arrays["body_mm"]
    assert_allclose(np.ptp(points, axis=0), [42.0, 42.0, 60.0], atol=0.1)
    assert np.hypot(points[:, 0], points[:, 1]).max() < 21.1, "no corners of a box"
    assert np.hypot(arrays["core_mm"][:, 0], arrays["core_mm"][:, 1]).max() < 21 - 8 + 0.1
    assert content["layouts"][0]["body"]["half"] == [1.0, 1.0, 1.0], "in mm as it is"
    _, none = unpack(layouts_scene(made_up_layouts(), history_of_three()))
    assert none == {}, "boxes may grow, and are drawn by their edges"
