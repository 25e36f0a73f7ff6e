"""Interfaces and conventions judged on presses that are made up: forces, travels, cosines, labels."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import RecordedPresses, own_channels
from estimator.calibration.validation import Agreement
from fem.presses.joint import JointPress
from studies.loose_core.response import LooseShell
from studies.recorded import convention_search as conventions
from studies.recorded import interface_fits as interfaces
from studies.recorded.interface_fits import DEPTHS_MM, Preference

SPEC = ObjectSpec(name="cube")
CASES = (((2, 1.0, 2.0), (4, 3.0, -1.0)), ((3, 5.0, 6.0),), ((3, -2.0, 1.0),))


def presses():
    """Two of the first case, one of each other; 3 N on each of the faces that they press."""
    force = np.zeros((4, 6))
    force[:2, 1], force[:2, 3], force[2:, 2] = 2.0, 4.0, 3.0
    counts = np.random.default_rng(0).normal(size=(4, 45))
    return RecordedPresses(
        counts, force, np.array([0, 0, 1, 2]), np.zeros(4, int), np.full(4, 9), CASES, np.ones(3)
    )


def made_path(softness):
    """A stand-in for `press_path`: a tip bears softness times its depth, more on faces of higher
    number; bodies move as the force."""

    def press_path(spec, response, tips, depths_mm):
        found = []
        for depths in depths_mm:
            press = object.__new__(JointPress)
            force = softness * depths * np.array([tip.face for tip in tips]) / 3
            motion = force.sum() * np.ones((2, 6)) * (1 + tips[0].x_mm + 10 * tips[0].y_mm)
            press.__dict__.update(tips=tuple(tips), depth_mm=depths, force_n=force, motion=motion)
            found.append(press)
        return tuple(found)

    return press_path


def test_an_interface_is_told_by_its_force_at_2_mm_and_the_travel_to_the_recorded_force(
    monkeypatch,
):
    """1.5 N per mm of every pressed face: 3 N at 2 mm in all three cases, and 3 N are borne there."""
    stand_in = SimpleNamespace(scene=None)
    monkeypatch.setattr(interfaces, "press_path", made_path(1.5))
    monkeypatch.setattr(interfaces, "designed", lambda spec: stand_in)
    monkeypatch.setattr(interfaces, "min_distance_mm", lambda scene, motion: float(len(motion)))
    monkeypatch.setattr(interfaces, "magnets_model", lambda magnets, nearest: nearest)
    monkeypatch.setattr(interfaces, "_own_cosine", lambda spec, presses, predictions: np.eye(4, 3))
    asked, judged = [], object.__new__(Agreement)

    def predict(spec, design, moving, rest, model):
        assert model == len(CASES) * len(DEPTHS_MM)
        assert_array_equal(rest, np.zeros((2, 6)))
        return moving

    monkeypatch.setattr(interfaces, "predict", predict)
    monkeypatch.setattr(
        interfaces,
        "agreement",
        lambda spec, presses, found, face, seed: asked.append(face) or judged,
    )
    made, shell = interfaces.interface_agreement.__wrapped__, object.__new__(LooseShell)
    shell.__dict__["bonded"] = None
    found = made(SPEC, shell, presses(), "bonded", None)
    assert asked == [2, 3, 4, None]
    assert found.name == "bonded"
    assert_allclose([found.force_at_2_mm, found.travel_mm], [3, 2])
    assert_array_equal(found.cosine, np.eye(4, 3))
    monkeypatch.setattr(interfaces, "press_path", made_path(3.0))
    stiff = made(SPEC, shell, presses(), "bonded", None)
    assert_allclose([stiff.force_at_2_mm, stiff.travel_mm], [6, 1])


def test_cosines_are_over_the_live_channels_of_the_pressed_faces():
    given = presses()
    given.face_force_n[:] /= 8  # a face counts as pressed from any force on
    given.signal_counts[1, own_channels(SPEC, 4)[2]] = np.nan
    predicted = np.random.default_rng(1).normal(size=(4, 3, 45))
    found = interfaces._own_cosine.__wrapped__(SPEC, given, SimpleNamespace(counts=predicted))
    for row, faces in ((0, (2, 4)), (1, (2, 4)), (2, (3,)), (3, (3,))):
        own = np.concatenate([own_channels(SPEC, face) for face in faces])
        own = own[np.isfinite(given.signal_counts[row, own])]
        assert len(own) == (17 if row == 1 else 9 * len(faces))
        a, b = given.signal_counts[row, own], predicted[row][:, own]
        assert_allclose(found[row], b @ a / np.linalg.norm(a) / np.linalg.norm(b, axis=1))


@pytest.mark.parametrize(
    ("places", "cases", "tried", "p"),
    [(0.02, 0.05, 3, 0.15), (0.3, 0.1, 5, 1.0), (0.02, 0.01, 1, 0.02)],
)
def test_a_preference_s_p_is_the_larger_times_the_interfaces_tried(places, cases, tried, p):
    assert_allclose(Preference("a", "b", 0.1, 0.1, places, cases, 3, 4).p_of(tried), p)


def test_predicted_changes_are_of_labels_turned_about_the_middle(monkeypatch):
    """Bodies move by 1 + x + 10 y of the first tip, in proportion to the force: the counts, here the
    motions themselves less those at rest, tell under which symmetry a case was pressed."""
    monkeypatch.setattr(conventions, "press_path", made_path(1.5))
    monkeypatch.setattr(conventions, "designed", lambda spec: SimpleNamespace(scene=None))
    monkeypatch.setattr(conventions, "min_distance_mm", lambda scene, motion: 5.0)
    asked = []
    monkeypatch.setattr(
        conventions, "magnets_model", lambda magnets, nearest: asked.append(nearest) or nearest
    )
    monkeypatch.setattr(
        conventions,
        "counts_of",
        lambda spec, scene, motion, model: np.nan_to_num(motion).sum(axis=2)[..., None] + 7.0,
    )
    given = presses()
    found = conventions.predicted_changes.__wrapped__(SPEC, None, given)
    assert asked == [5.0]
    assert found.shape == (8, 4, 3, 2)
    for number, symmetry in enumerate(conventions.SYMMETRIES):
        for press, case in enumerate(given.case.tolist()):
            x, y = symmetry @ CASES[case][0][1:]
            faces = len(CASES[case])
            assert_allclose(found[number, press, case], 6 * 3 * faces * (1 + x + 10 * y), rtol=4e-3)
    assert not found[:, 0, 1:].any()
    assert not found[:, 2:, 0].any()
