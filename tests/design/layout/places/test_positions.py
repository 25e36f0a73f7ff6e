"""Turns of chips and slips of layouts against SciPy's rotations."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.layout.places.positions import (
    chip_on_board,
    magnet_layout,
    rotation_matrix,
    sensor_layout,
    slipped,
)
from design.spec.mechanics import SlipSpec
from design.spec.object import ObjectSpec, SensorSpec

TURNS = [
    (0.0, 0.0, 0.0),
    (90.0, 0.0, 0.0),
    (0.0, -30.0, 0.0),
    (12.0, -40.0, 75.0),
    (0.0, 0.0, 180.0),
]


@pytest.mark.parametrize("turn", TURNS)
def test_a_rotation_vector_turns_as_scipy_does(turn):
    wanted = Rotation.from_rotvec(np.deg2rad(turn)).as_matrix()
    assert_allclose(rotation_matrix(turn), wanted, atol=1e-12)


def test_a_chip_that_faces_outward_is_turned_about_its_y():
    about_y = Rotation.from_rotvec([0, np.pi, 0]).as_matrix()
    assert_allclose(chip_on_board(SensorSpec(chip="outward")), about_y, atol=1e-12)
    assert_allclose(chip_on_board(SensorSpec()), np.eye(3), atol=1e-12)


def test_a_slip_turns_what_sits_in_the_core_about_the_middle_and_shifts_it():
    slip = SlipSpec(shift_mm=(0.3, -0.5, 0.2), rotation_deg=(2.0, -1.0, 4.0))
    turn = Rotation.from_rotvec(np.deg2rad(slip.rotation_deg))
    spec = ObjectSpec(name="cube")
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    moved = slipped(sensors, slip)
    assert_allclose(moved.position_mm, turn.apply(np.array(sensors.position_mm)) + slip.shift_mm)
    for before, after in zip(sensors.axes, moved.axes, strict=True):
        assert_allclose(after, turn.apply(np.array(before)), atol=1e-12)
    moved = slipped(magnets, slip)
    assert_allclose(moved.centre_mm, turn.apply(np.array(magnets.centre_mm)) + slip.shift_mm)
    assert_allclose(moved.axis, turn.apply(np.array(magnets.axis)), atol=1e-12)
    assert_allclose(moved.side, turn.apply(np.array(magnets.side)), atol=1e-12)
