"""The picture after an evaluation: every frame at its forces, localisation errors as shares."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.networks.prediction import ContactAnswers, ContactReadings, HeldOutAnswers
from instobj.figures import predictions


def test_each_face_has_its_forces_and_its_shares_of_localisation_errors(tmp_path):
    one = ContactReadings(
        2, np.array([1.0, 4, 9]), np.array([2.0, 4, 8.5]), np.array([3.0, 1, 2]), 2
    )
    two = ContactReadings(4, np.array([5.0]), np.array([12.0]), np.array([0.5]), 1)
    figure = predictions.draw_predictions(
        [one, two], "recorded", "at new places", tmp_path / "a.png"
    )
    force, other, place, _ = figure.axes
    assert figure.get_suptitle().startswith("Recorded held-out presses")
    assert force.get_title() == "Face 2: median error 0.50 N"
    assert other.get_title() == "Face 4: median error 7.00 N"
    equal, dots = force.lines
    assert_allclose(dots.get_xydata(), [[1, 2], [4, 4], [9, 8.5]])
    assert_allclose(equal.get_xdata(), equal.get_ydata())
    assert force.get_xlim() == other.get_ylim(), "one scale for all faces"
    assert_allclose(place.lines[0].get_xydata(), [[1, 100 / 3], [2, 200 / 3], [3, 100]])
    assert place.get_title() == "3 frames of 2 presses"
    assert "50 %: 2.00 mm" in [text.get_text() for text in place.get_legend().get_texts()]


def test_three_faces_stand_beside_each_other_and_the_rest_below(tmp_path):
    faces = [
        ContactReadings(face, np.array([5.0]), np.array([5.0]), np.array([0.5 * face]), 1)
        for face in range(1, 6)
    ]
    figure = predictions.draw_predictions(faces, "simulated", "at new places", tmp_path / "a.png")
    titles = [axes.get_title()[:6] for axes in figure.axes]
    first, second = [f"Face {face}" for face in (1, 2, 3)], ["Face 4", "Face 5"]
    assert titles == [*first, *["1 fram"] * 3, *second, *["1 fram"] * 2]
    assert figure.get_size_inches() == pytest.approx([9.9, 14.4])
    assert [axes.get_xlim()[1] for axes in figure.axes[3:6]] == pytest.approx([1.05 * 2.5] * 3)
    assert [bool(axes.get_ylabel()) for axes in figure.axes] == [True, False, False] * 2 + [
        True,
        False,
    ] * 2


def test_forces_over_time_beside_the_best_baseline_and_places_on_the_face(tmp_path):
    force, place = np.array([1.0, 4.0, 2.0, 6.0]), np.zeros((4, 2))
    held_out = HeldOutAnswers(
        face=3,
        true_force_n=force,
        true_xy_mm=place,
        span_n=np.full(4, 6.0),
        press_id=np.array([2, 2, 7, 7]),
        time_s=np.arange(4.0),
        grid_x_mm=np.arange(3.0),
        grid_y_mm=np.arange(2.0),
        force_halfwidth_n=np.full(4, 1.5),
        interval_cover=0.9,
        answers=(
            ContactAnswers("model", force + 0.5, place),
            ContactAnswers("ridge", force + 3, place + 1),
            ContactAnswers("extra trees", force - 1, place + 2),
        ),
        fitted_frames={"ridge": 9, "extra trees": 9},
    )
    figure = predictions.draw_over_time([held_out], tmp_path / "a.png")
    over_time, face = figure.axes
    named = {line.get_label(): line.get_ydata() for line in over_time.lines}
    assert_allclose(named["labelled"], force)
    assert_allclose(named["model"], force + 0.5)
    assert_allclose(named["extra trees"], force - 1)
    assert "ridge" not in named, "the best baseline alone"
    assert [patch.get_label() for patch in over_time.collections] == ["model's 90 % interval"]
    assert over_time.get_title() == "Face 3: 2 of 2 held-out presses"
    assert {"extra trees", "model", "labelled"} <= {line.get_label() for line in face.lines}
