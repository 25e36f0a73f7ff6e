"""Grids and patches of bodies that are known by their triangles, by distances that are given."""

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.body import sampled
from design.body.sampled import DistanceField, grid_points
from design.body.surface_chart import STEEPEST
from design.errors import InputError
from design.layout.body import body_of
from tests.support.objects.worked_objects import worked

BALL = np.array([2.0, -1.0, 0.5])
REACHES = {1: (26.19, 23.28), 2: (20.37, 26.19), 5: (20.37, 23.28)}
"""0.97 of what half the edges of 62, 56 and 50 mm leave beside 4 mm, along x and y of each face."""


def test_a_grid_is_centred_and_reaches_three_steps_beyond_the_box():
    points, count = grid_points(np.array([10.0, 5.1, 7.0]), 2.0)
    assert count == (17, 13, 15)
    assert points.shape == (17 * 13 * 15, 3)
    assert_allclose(points.min(axis=0), [-16, -12, -14])
    assert_allclose(points.max(axis=0), [16, 12, 14])
    assert_allclose(points[1] - points[0], [0, 0, 2])
    assert_allclose(points[13 * 15] - points[0], [2, 0, 0])


def patch(monkeypatch, number, distance, inward_mm=4.0):
    """Of a body of 62 × 56 × 50 mm with a surface where `distance` of points is 0."""

    class Given(DistanceField):
        def evaluate(self, points_mm):
            return distance(points_mm)

    given = Given(np.zeros(3), 1.0, np.zeros((1, 1, 1)))
    monkeypatch.setattr(sampled, "distance_field", lambda body: given)
    return sampled.patch_frame.__wrapped__(body_of(worked("ellipsoid")), number, inward_mm)


@pytest.mark.parametrize("number", REACHES)
def test_a_flat_patch_reaches_nearly_to_the_neighbouring_sides(monkeypatch, number):
    """Planes of slope 0.2 along x, 19 mm from the middle along z or y, or flat ones along x."""
    axis = {1: [0.2, 0, 1], 2: [0.2, -1, 0], 5: [-1, 0, 0]}[number]
    frame = patch(monkeypatch, number, lambda points: (points @ axis - 19.0) / 1.1)
    assert frame.half_extents_mm == pytest.approx(REACHES[number])
    assert frame.centre_mm @ frame.normal == pytest.approx(19.0 - 1.1 * 4.0, abs=1e-4)
    xy = np.array([[15.0, -2.0], [-4.0, 14.0]])
    points = frame.to_object(np.column_stack([xy, [0.0, 0.0]]))
    assert_allclose(points @ axis, 14.6, atol=1e-4)


@pytest.mark.parametrize("number", REACHES)
def test_a_patch_of_a_ball_ends_where_it_is_steep(monkeypatch, number):
    """Ball of 20 mm off the middle; its slope is taken between places 1 mm apart."""
    frame = patch(monkeypatch, number, lambda p: np.linalg.norm(p - BALL, axis=-1) - 24.0)
    share = np.array(frame.half_extents_mm) / REACHES[number]
    assert share[0] == pytest.approx(share[1])
    turn = np.linspace(0, 2 * np.pi, 73)[:, None]
    rim = np.hstack([np.cos(turn), np.sin(turn)]) * frame.half_extents_mm
    points = frame.to_object(np.column_stack([0.9 * rim, 0 * turn]))
    assert_allclose(np.linalg.norm(points - BALL, axis=1), 20.0, atol=5e-3)
    middle = BALL - (BALL @ frame.normal) * frame.normal
    aside = np.linalg.norm(rim @ np.stack([frame.x, frame.y]) - middle, axis=1).max()
    assert aside == pytest.approx(20.0 * np.sin(np.arctan(STEEPEST)), abs=1.0)


def test_surfaces_too_small_or_too_steep_have_no_patch(monkeypatch):
    with pytest.raises(InputError, match="about face 1 is too steep or too small"):
        patch(monkeypatch, 1, lambda p: np.linalg.norm(p, axis=-1) - 7.0)
    with pytest.raises(InputError, match="about face 2 is too steep or too small"):
        patch(monkeypatch, 2, lambda p: p[:, 1] - 30.0, inward_mm=26.0)


def test_an_octant_s_triangles_measure_as_all_of_them_do():
    """Of an ellipsoid's 5120 triangles to points inside and out, on its planes and in its middle."""
    ball = trimesh.creation.icosphere(4, 1.0).apply_scale([30.0, 12.0, 20.0])
    octant = sampled.octant_of(ball)
    assert len(octant.faces) < len(ball.faces) / 2
    points = np.random.default_rng(3).uniform(0.0, 1.0, (300, 3)) * [36.0, 16.0, 25.0]
    points[:60, 0] = points[40:100, 1] = points[80:140, 2] = 0.0
    points[140] = 0.0
    whole = sampled.measured_distance_mm(ball, points)
    assert (whole < 0).sum() > 50
    assert_allclose(sampled.measured_distance_mm(octant, points), whole, rtol=0, atol=1e-12)
