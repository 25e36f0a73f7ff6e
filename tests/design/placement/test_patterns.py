"""Patterns of parts as shares of a face, by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.placement.patterns import along_longer_side, magnet_patterns, sensor_patterns


def test_one_part_stands_in_the_middle():
    assert_allclose(sensor_patterns(1)[0], [[[0, 0]]])
    assert sensor_patterns(1)[1] == []
    assert_allclose(magnet_patterns(1), [[[0, 0]], [[0, 0]]])


def test_three_sensors_stand_in_rings_a_tee_and_rows():
    (*rings, tee, turned, row, column), lopsided = sensor_patterns(3)
    assert lopsided == []
    for ring, first in zip(rings, (90, 0, 45, 75), strict=True):
        angle = np.deg2rad(first + np.array([0, 120, 240]))
        assert_allclose(ring, np.column_stack([np.cos(angle), np.sin(angle)]), atol=1e-12)
    assert_allclose(tee, [[-1, 0], [1, 0], [0, 1]])
    assert_allclose(turned, [[0, -1], [0, 1], [1, 0]])
    assert_allclose(row, [[-1, 0], [0, 0], [1, 0]])
    assert_allclose(column, [[0, -1], [0, 0], [0, 1]])


def test_of_two_sensors_patterns_with_one_in_the_middle_leave_a_half_empty_and_are_tried_last():
    even, lopsided = sensor_patterns(2)
    assert_allclose(np.mean(even, axis=1), 0, atol=1e-12)
    assert_allclose(even[-1], [[0, -1], [0, 1]])
    assert_allclose(lopsided, [[[0, 0], [0, 1]], [[0, 0], [1, 0]]])


@pytest.mark.parametrize("count", [2, 3])
def test_two_or_three_magnets_stand_in_rows(count):
    row, column = magnet_patterns(count)
    assert_allclose(row, np.column_stack([np.linspace(-1, 1, count), np.zeros(count)]))
    assert_allclose(column, row[:, ::-1])


def test_four_magnets_stand_in_the_corners_more_in_a_ring_and_odd_ones_in_the_middle():
    corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]]
    assert_allclose(magnet_patterns(4)[0], corners, atol=1e-12)
    assert_allclose(magnet_patterns(5)[0], [[0, 0], *corners], atol=1e-12)
    angle = np.deg2rad([0, 60, 120, 180, 240, 300])
    ring = np.column_stack([np.cos(angle), np.sin(angle)])
    assert_allclose(magnet_patterns(6)[0], ring, atol=1e-12)
    assert_allclose(magnet_patterns(7)[0], np.vstack([[0, 0], ring]), atol=1e-12)
    assert [len(one) for one in magnet_patterns(5)] == [5, 5, 5]


def test_a_row_runs_along_the_longer_side_of_a_face():
    upright = sensor_patterns(2)[0][0]
    long, tall, square = np.array([35.0, 25.0]), np.array([25.0, 35.0]), np.array([25.0, 25.0])
    assert np.ptp(along_longer_side(upright, long)[:, 0]) == 2
    assert np.ptp(along_longer_side(upright, tall)[:, 1]) == 2
    assert_allclose(along_longer_side(upright, square), upright)
    ring = sensor_patterns(3)[0][0]
    assert_allclose(along_longer_side(ring, long), ring)
