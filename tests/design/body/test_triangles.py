"""Blocks by hand; closed surfaces of curved bodies keep volume and stay within half the envelope."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.spatial.transform import Rotation

from design.body.triangles import (
    Block,
    ball,
    block_surface,
    box_between,
    cylinder_between,
    largest_edge_mm,
    sections_of_circle,
)
from design.layout.boards import gap_mm

TURNED = Block(
    np.array([1.0, 2.0, 3.0]),
    Rotation.from_euler("z", 90, degrees=True).as_matrix(),
    np.array([1.0, 2.0, 3.0]),
)
"""Its first axis is +y, its second −x."""


def test_a_block_has_its_corners_volume_and_surface():
    assert TURNED.volume_mm3 == 48
    corners = TURNED.corners_mm
    assert_allclose(corners[:4, 2], 0)
    assert_allclose(corners[4:, 2], 6)
    assert_allclose(np.ptp(corners, axis=0), [4, 2, 6])
    assert_allclose(corners.mean(axis=0), [1, 2, 3])
    assert_allclose(corners[0], [3, 1, 0], atol=1e-12)
    surface = block_surface(TURNED)
    assert_allclose(surface.volume, 48)
    assert_allclose(surface.bounds, [[-1, 1, 0], [3, 3, 6]], atol=1e-12)


def test_points_are_held_by_a_block_or_so_far_from_it():
    points = np.array([[1.0, 2, 3], [3, 3, 6], [3.5, 3, 6], [6, 7, 6], [1, 2, -2]])
    assert_allclose(TURNED.distance_mm(points), [0, 0, 0.5, 5, 2], atol=1e-12)
    assert_array_equal(TURNED.holds(points, 1e-9), [True, True, False, False, False])
    assert_array_equal(TURNED.holds(points, 0.51), [True, True, True, False, False])
    assert_array_equal(TURNED.holds(points[:1]), [True])


def test_gaps_of_blocks_are_those_of_faces_edges_and_corners():
    cube = Block(np.zeros(3), np.eye(3), np.ones(3))

    def at(x, y, z, turn=(0, 0, 0)):
        axes = Rotation.from_euler("xyz", turn, degrees=True).as_matrix()
        return Block(np.array([x, y, z], float), axes, np.ones(3))

    assert gap_mm(cube, at(0, 5, 0)) == pytest.approx(3)
    assert gap_mm(cube, at(1.5, 0, 0)) == pytest.approx(-0.5)
    assert gap_mm(cube, at(5, 0, 0, (0, 0, 45))) == pytest.approx(4 - np.sqrt(2))
    crossed = gap_mm(at(0, 0, 0, (45, 0, 0)), at(0, 0, 4, (0, 45, 0)))
    assert crossed == pytest.approx(4 - 2 * np.sqrt(2)), "edge over edge"
    oblong = Block(np.zeros(3), np.eye(3), np.array([1.0, 2.0, 3.0]))
    assert gap_mm(oblong, at(0, 0, 6)) == pytest.approx(2)
    assert gap_mm(at(0, 5, 0), oblong) == pytest.approx(2)


def test_a_box_reaches_from_corner_to_corner():
    box = box_between((1.0, 2.0, 3.0), (2.0, 5.0, 8.0))
    assert_allclose(box.bounds, [[1, 2, 3], [2, 5, 8]])
    assert_allclose(box.volume, 15)


@pytest.mark.parametrize(("radius", "envelope"), [(20.0, 0.03), (5.0, 0.2), (60.0, 0.01)])
def test_curved_surfaces_keep_their_volume_within_half_of_the_envelope(radius, envelope):
    edge = largest_edge_mm(radius, envelope)
    assert radius - np.sqrt(radius**2 - edge**2 / 4) == pytest.approx(envelope / 2, rel=0.02)
    sections = sections_of_circle(radius, envelope)
    assert 2 * np.pi * radius / sections <= edge
    assert 2 * np.pi * radius / (sections - 1) > edge or sections == 24
    bar = cylinder_between(radius, -3.0, 5.0, envelope)
    assert_allclose(bar.volume, np.pi * radius**2 * 8, rtol=1e-9)
    assert_allclose(bar.bounds[:, 2], [-3, 5])
    sphere = ball(radius, np.array([1.0, 2.0, 3.0]), envelope)
    assert_allclose(sphere.volume, 4 / 3 * np.pi * radius**3, rtol=1e-9)
    assert_allclose(sphere.center_mass, [1, 2, 3], atol=1e-6)
    off = np.linalg.norm(sphere.triangles_center - [1, 2, 3], axis=1) - radius
    assert -envelope < off.min() < -envelope / 8


def test_a_coarse_circle_has_24_edges():
    assert sections_of_circle(1.0, 0.5) == 24
