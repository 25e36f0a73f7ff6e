"""A magnet held over a chip: its field by magpylib, its pose and the prior of a hand."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.layout.body import core_frames
from design.layout.places.positions import sensor_layout
from estimator.field.sources import magnet_source
from instobj.bench.bringup.asking.held_magnet import held_magnet, hold_places, stated_pose
from tests.support.new_objects import SMALL

HOLD = 5
"""Over the second sensor of face 3, whose axes are none of the object's own order."""
POSE = np.array([[1.0, -2.0, 3.0, 0.2, -0.1, 5.0, -7.0, 11.0]])


def test_counts_are_those_of_magpylibs_disk_and_a_uniform_field():
    held, layout = held_magnet(SMALL, [HOLD]), sensor_layout(SMALL)
    disk = magnet_source(SMALL.magnets)
    stated_mm, axes = (of_all[HOLD] for of_all in hold_places(SMALL))
    x, y, n = axes.T
    centre = stated_mm + 1.0 * x - 2.0 * y + 3.0 * n
    assert_allclose(held.centre_mm(POSE)[0], centre)
    axis = Rotation.from_rotvec(0.2 * x - 0.1 * y).apply(-n)
    assert_allclose(held.axis(POSE)[0], axis, atol=1e-12)
    magnet = magpylib.magnet.Cylinder(
        polarization=(0, 0, disk.polarization_t), dimension=(disk.diameter_mm, disk.height_mm)
    )
    magnet.rotate(Rotation.align_vectors([axis], [[0, 0, 1.0]])[0])
    magnet.position = centre
    seat = np.zeros((10, 3))
    seat[HOLD] = [0.3, -0.2, 0.1]
    field = 1e3 * SMALL.sensors.counts_per_mt * magnet.getB(layout.position_mm + seat)
    wanted = np.einsum("sac,sc->sa", layout.axes, np.add(field, [5.0, -7.0, 11.0]))
    assert_allclose(held.counts(POSE, seat)[0], wanted, atol=1e-3 * abs(wanted).max())
    away = np.linalg.norm(layout.position_mm - centre, axis=1)
    assert_allclose(held.distance_mm(POSE)[0], away)


def test_a_magnet_stays_half_a_millimetre_and_half_its_height_above_the_core():
    held = held_magnet(SMALL, [HOLD])
    stated_mm, axes = (of_all[HOLD] for of_all in hold_places(SMALL))
    foot_mm = stated_mm - 10.0 * axes[:, 2]
    deep = stated_pose(1)
    deep[0, 2] = -50.0
    least = 0.5 + SMALL.magnets.height_mm / 2
    height = (held.centre_mm(deep)[0] - foot_mm) @ axes[:, 2]
    assert height == pytest.approx(least)
    assert deep[0, 2] == -50.0
    stated = held.centre_mm(stated_pose(1))[0]
    assert_allclose(stated, stated_mm)
    (face,) = [frame for frame in core_frames(SMALL) if frame.number == 3]
    assert (stated - face.centre_mm) @ face.normal == pytest.approx(10.0)


def test_a_hand_is_off_by_six_millimetres_half_a_radian_and_earths_field():
    held = held_magnet(SMALL, [HOLD])
    uniform = 0.05 * SMALL.sensors.counts_per_mt
    wanted = POSE / [6, 6, 6, 0.5, 0.5, uniform, uniform, uniform]
    assert_allclose(held.off_prior(POSE), wanted)
    assert stated_pose(3).shape == (3, 8)
