"""Cells, hats and weights of contact, against quadrature and hand-worked triangles."""

import numpy as np
from numpy.testing import assert_allclose
from scipy.spatial import Delaunay

from fem.contact import indenter, refined
from fem.linear.response import FaceSurface

CORNERS = np.array([[0.0, 0, 0], [3, 0, 0], [0, 2, 0], [3, 2.5, 0.5]])
SURFACE = FaceSurface(
    number=3,
    xy_mm=CORNERS[:, :2],
    triangles=np.array([[0, 1, 2], [1, 3, 2]]),
    relief_mm=CORNERS[:, 2],
)


def over_triangles(function, divisions=40):
    """∫ function(λ, x) dA over both triangles, by midpoints of small ones; λ of all four vertices."""
    total = 0.0
    for triangle in SURFACE.triangles:
        a, b, c = CORNERS[triangle]
        area = np.linalg.norm(np.cross(b - a, c - a)) / 2
        n = divisions
        i, j = np.indices((n, n)).reshape(2, -1)
        up = [(i + 1 / 3, j + 1 / 3, i + j < n), (i + 2 / 3, j + 2 / 3, i + j < n - 1)]
        for u, v, inside in up:
            share = np.zeros((inside.sum(), 4))
            u, v = u[inside] / n, v[inside] / n
            share[:, triangle] = np.column_stack([1 - u - v, u, v])
            total = total + np.sum(function(share, share @ CORNERS), axis=0) * area / n**2
    return total


def test_hats_have_the_area_centroid_and_variance_of_their_functions():
    found = refined.hat_patches(SURFACE)
    area = over_triangles(lambda share, x: share)
    assert_allclose(found.area_mm2, area, rtol=1e-3)
    first = over_triangles(lambda share, x: share[:, :, None] * x[:, None])
    centre = first / area[:, None]
    assert_allclose(found.centre_mm, centre, atol=2e-3)
    square = over_triangles(lambda share, x: share * np.sum(x**2, axis=1)[:, None])
    variance = (square / area - np.sum(centre**2, axis=1)) / 2
    assert_allclose(found.variance_mm2, variance, rtol=3e-3)
    assert_allclose(refined.triangle_areas_mm2(SURFACE).sum(), area.sum(), rtol=1e-9)


def test_narrowing_keeps_forces_and_places_and_takes_a_smoothing_back():
    """W is the row sum of the mass matrix M: 2 − W⁻¹ M has rows that sum to one."""
    found = refined.hat_narrowing(SURFACE).toarray()
    mass = over_triangles(lambda share, x: share[:, :, None] * share[:, None])
    wanted = 2 * np.eye(4) - mass / mass.sum(axis=1, keepdims=True)
    assert_allclose(found, wanted, atol=2e-3)
    assert_allclose(found.sum(axis=1), 1)


def test_points_are_weighed_by_the_corners_round_them_and_beyond_by_the_nearest_one():
    triangulation = Delaunay(CORNERS[:, :2])
    points = np.array([[1.0, 0.5], [2.8, 2.2], [-1.0, -1.0], [5.0, 0.4]])
    vertices, share = refined.barycentric(triangulation, points)
    assert_allclose(share.sum(axis=1), 1)
    found = np.einsum("pk,pkd->pd", share, CORNERS[vertices][..., :2])
    assert_allclose(found[:2], points[:2], atol=1e-12)
    assert share[:2].min() >= 0
    assert vertices[2:, 0].tolist() == [0, 1]
    assert share[2:].tolist() == [[1, 0, 0]] * 2


def test_moments_are_those_of_what_lies_below_the_tip():
    """Two cells of 2 × 1 mm at sixteen samples each: one whole, of one its left half; one empty."""
    middle = (np.arange(4) + 0.5) / 4
    local = np.stack(np.meshgrid(middle, middle, indexing="ij"), axis=-1).reshape(-1, 2) * [2, 1]
    points = local + np.array([[0.0, 0.0], [2.0, 0.0], [4.0, 0.0]])[:, None]
    height = np.ones((3, 16))
    height[1] = np.where(local[:, 0] < 1, 3.0, np.inf)
    height[2] = np.inf
    area, centre, variance, mean = indenter.cell_moments(
        points, height, np.tile([2.0, 1.0], (3, 1))
    )
    assert_allclose(area, [2.0, 1.0])
    assert_allclose(centre, [[1.0, 0.5], [2.5, 0.5]])
    assert_allclose(mean, [1.0, 3.0])
    assert_allclose(variance[0], (2**2 + 1**2) / 12 / 2)
    # samples stand for cells of 0.5 × 0.25 mm, whose own variance is the mean of both sides'
    within = (0.5**2 + 0.25**2) / 2 / 12
    seen = np.mean(np.sum((local[local[:, 0] < 1] - [0.5, 0.5]) ** 2, axis=1)) / 2
    assert_allclose(variance[1], seen + within)
