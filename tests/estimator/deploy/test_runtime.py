"""Readings of a board in the order of a model's channels, and the largest values that parity is told in."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.deploy import export
from estimator.deploy.runtime import channel_readings
from estimator.frames.face_data import HISTORY


def test_channels_are_found_by_face_sensor_and_axis():
    raw = np.arange(18.0).reshape(2, 3, 3)
    channels = ((1, 0, 0), (2, 2, 1), (HISTORY + 2, 0, 2))
    assert channel_readings(raw, channels).tolist() == [0.0, 16.0, 11.0]


@pytest.mark.parametrize("channel", [(3, 0, 0), (1, 3, 0), (2, 1, 1)])
def test_channels_that_are_not_there_or_mute_are_told_by_name(channel):
    raw = np.zeros((2, 3, 3))
    raw[1, 1, 1] = np.nan
    face, sensor, axis = channel
    with pytest.raises(InputError, match=f"channel F{face}-{'XYZ'[axis]}{sensor + 1}, which"):
        channel_readings(raw, (channel,))


def test_probes_go_from_a_channel_s_noise_to_the_range_of_a_chip():
    counts = export._probe_counts(3)
    assert counts.shape == (64 * 9, 3)
    size = np.sqrt(np.mean(counts.reshape(9, -1) ** 2, axis=1))
    assert_allclose(size, 4.0 ** np.arange(9), rtol=0.2)


def test_sizes_are_the_largest_of_each_scale_s_frames():
    output = np.zeros((576, 2))
    output[3], output[64], output[575] = -5.0, [0.5, np.inf], [2.0, np.nan]
    found = export._sizes(output)
    assert found.shape == (576, 1)
    assert found[:64].tolist() == [[5.0]] * 64
    assert found[64:128].tolist() == [[0.5]] * 64
    assert found[-64:].tolist() == [[2.0]] * 64
    assert found[128] == 0
