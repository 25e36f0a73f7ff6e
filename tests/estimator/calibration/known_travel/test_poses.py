"""Poses of objects under a machine, by the machine's own steps."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.known_travel.model import SYMMETRIES, Pose, Twin


@pytest.mark.parametrize("symmetry", range(8))
def test_a_machine_that_goes_to_a_place_of_the_object_finds_that_place(symmetry):
    """Place → the machine's axes by one of the symmetries, turned about z, moved to the object."""
    place = np.array([[3.0, -1.0], [0.5, 2.0]])
    angle = np.deg2rad(30)
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    xy = [10.0, -4.0] + place @ SYMMETRIES[symmetry].T @ turn.T
    tip = np.column_stack([xy, [6.5, 7.5]])
    found, travel = Pose(np.array([10.0, -4.0]), angle, 7.0, symmetry).locate_tips(tip)
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


def test_values_of_a_fit_move_pose_seats_tilts_and_strength():
    pose = Pose(np.array([1.0, 2.0]), 0.1, 5.0, 3)
    start = Twin(pose, np.ones((2, 3)), np.zeros((2, 2)), 1.1)
    values = {"shift_mm": np.array([0.5, -0.5]), "turn_rad": np.array(0.01)}
    values["contact_mm"] = np.array(0.2)
    moved = start.moved(values)
    assert_allclose(moved.pose.shift_mm, [1.5, 1.5])
    assert (moved.pose.turn_rad, moved.pose.contact_mm) == pytest.approx((0.11, 5.2))
    assert (moved.pose.symmetry, moved.strength) == (3, 1.1)
    values |= {"magnet_mm": np.arange(6.0).reshape(2, 3), "tilt_rad": np.arange(4.0).reshape(2, 2)}
    moved = start.moved(values | {"ln_strength": np.log(2)})
    assert_allclose(moved.magnet_mm, 1 + np.arange(6).reshape(2, 3))
    assert_allclose(moved.tilt_rad, np.arange(4).reshape(2, 2))
    assert moved.strength == pytest.approx(2.2)
