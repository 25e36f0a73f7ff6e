"""Poses of objects under a machine, by the machine's own steps; errors of places by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel import places
from estimator.calibration.known_travel.model import SYMMETRIES, Pose
from estimator.calibration.known_travel.places import PlaceErrors, _errors
from estimator.recordings.formats.travel import TravelRecording


@pytest.mark.parametrize("symmetry", range(8))
def test_a_machine_that_goes_to_a_place_of_the_object_finds_that_place(symmetry):
    """Place → the machine's axes by one of the symmetries, turned about z, moved to the object."""
    place = np.array([[3.0, -1.0], [0.5, 2.0]])
    angle = np.deg2rad(30)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    xy = [10.0, -4.0] + place @ SYMMETRIES[symmetry].T @ turn.T
    tip = np.column_stack([xy, [6.5, 7.5]])
    found, travel = Pose(np.array([10.0, -4.0]), angle, 7.0, symmetry).in_object(tip)
    assert_allclose(found, place, atol=1e-12)
    assert_allclose(travel, [0.5, -0.5], atol=1e-12)


def test_symmetries_are_four_turns_and_four_mirrors():
    sizes = [round(np.linalg.det(one)) for one in SYMMETRIES]
    assert sorted(sizes) == [-1] * 4 + [1] * 4
    assert len({one.tobytes() for one in map(np.abs, SYMMETRIES)}) == 2
    assert len({(one + 0.0).tobytes() for one in SYMMETRIES}) == 8
    for one in SYMMETRIES:
        assert_allclose(one @ one.T, np.eye(2))
    assert_allclose(SYMMETRIES[0], np.eye(2))


def test_errors_of_places_are_distances_in_the_plane_and_of_the_travel():
    true = np.zeros((3, 3))
    read = np.array([[3.0, 4.0, 0.2], [0.0, 1.0, -0.4], [0.6, 0.8, 0.9]])
    rms = np.sqrt((25 + 1 + 1) / 3), np.sqrt((0.04 + 0.16 + 0.81) / 3)
    wanted = PlaceErrors(1.0, rms[0], 0.4, rms[1])
    for name, value in vars(wanted).items():
        assert getattr(_errors(read, true), name) == pytest.approx(value), name


def test_the_twin_s_table_spans_what_is_asked_for_and_its_nearest_nodes_are_read(monkeypatch):
    """The field of a node is its place, twice over: steps of 1, 1 and 0.5 mm."""
    seen = []

    def pressed(twin, tip_mm):
        seen.append(tip_mm)
        return np.stack([tip_mm, tip_mm + 1.0], axis=1)

    tip_mm = np.array([[0.0, 1.0, -1.0], [4.0, 3.0, 1.0], [2.0, 2.0, 0.0]])
    model = SimpleNamespace(pressed=pressed)
    fitted = SimpleNamespace(twin=None, resting_mt=np.zeros((2, 3)))
    asked = TravelRecording(np.arange(3.0), tip_mm, pressed(None, tip_mm), np.arange(3))
    noise = 0.05 * np.random.default_rng(1).standard_normal((40, 2, 3))
    monkeypatch.setattr(places, "left_over", lambda model, fitted, labelled: noise)
    labelled = range(40)
    read = places._by_twin.__wrapped__(model, fitted, labelled, asked)
    x, y, z = (np.unique(column) for column in seen[-1].T)
    assert_allclose(x, [0, 1, 2, 3, 4])
    assert_allclose(y, [1, 2, 3])
    assert_allclose(z, [-1, -0.5, 0, 0.5, 1])
    assert_allclose(read, tip_mm, atol=0.02)
