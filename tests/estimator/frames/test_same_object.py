"""Sensors that an estimator does not know are named; those that are known or silent are not."""

import numpy as np
import pytest

from design.errors import InputError
from estimator.frames.face_data import HISTORY
from estimator.frames.same_object import require_same_sensors

CHANNELS = ((2, 0, 0), (2, 0, 1), (2, 1, 2), (2 + HISTORY, 0, 0))


def readings(*alive):
    """Three frames of faces 2 and 4 with three sensors; the second frame alone has readings."""
    counts = np.full((3, 2, 3, 3), np.nan)
    for row, sensor, axis in alive:
        counts[1, row, sensor, axis] = 1.0
    return counts


def test_a_sensor_that_the_model_does_not_read_is_of_another_object():
    faces = np.array([2, 4])
    known = readings((0, 0, 2), (0, 1, 0), (1, 2, 0))
    require_same_sensors(CHANNELS, known, faces, "the recording")
    with pytest.raises(
        InputError,
        match=r"4 channels, of the sensors F2-S1, F2-S2; a\.nc also has readings of F2-S3,",
    ):
        require_same_sensors(CHANNELS, readings((0, 2, 1)), faces, "a.nc")


def test_a_sensor_that_was_left_out_in_training_may_be_alive():
    """Face 4 has three sensors, so face 2 of that object may have a third one too."""
    of_two_faces = (*CHANNELS, (4, 2, 0))
    faces = np.array([2, 4])
    require_same_sensors(of_two_faces, readings((0, 2, 1), (1, 0, 0)), faces, "the recording")
