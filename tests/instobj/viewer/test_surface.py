"""Triangles of the page: outside of the mesh, sharp edges, and which vertex moves with which."""

import numpy as np
import trimesh
from numpy.testing import assert_allclose

from instobj.viewer.surface import boundary_triangles, links_of, shaded, shaded_part


def test_the_boundary_of_two_tetrahedra_is_closed_and_looks_outwards():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]], float)
    tets = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
    assert (np.linalg.det(points[tets][:, 1:] - points[tets][:, :1]) > 0).tolist() == [True, True]
    surface = trimesh.Trimesh(points, boundary_triangles(points, tets), process=False)
    assert surface.is_watertight
    assert_allclose(surface.volume, 1 / 6 + 1 / 3)


def test_a_box_has_three_normals_at_a_corner_and_a_ball_one():
    box, ball = trimesh.creation.box((1, 2, 3)), trimesh.creation.icosphere(3)
    assert len(shaded(box.vertices, box.faces).points_mm) == 24
    round_one = shaded_part(ball)
    assert len(round_one.points_mm) == len(ball.vertices)
    assert_allclose(round_one.normals, round_one.points_mm, atol=0.02)


def test_many_triangles_lose_what_three_hundredths_of_a_millimetre_allow():
    ball = trimesh.creation.icosphere(5, 20.0)
    fewer = shaded_part(ball)
    assert len(fewer.triangles) < 0.7 * len(ball.faces)
    assert_allclose(np.linalg.norm(fewer.points_mm, axis=1), 20.0, atol=0.05)


def test_an_edge_moves_with_both_faces_and_overlapping_patches_agree():
    source, of_faces = np.array([5, 5, 8, 9]), np.array([5, 8, 5, 8])
    x, z = np.eye(3)[0], np.eye(3)[2]
    links = links_of(source, of_faces, np.array([z, x, x, x]))
    inward = np.array([0.3, 0.2, 0.1, 0.4])
    moved = np.zeros((4, 3))
    np.add.at(moved, links.picture, links.vector * inward[links.face, None])
    on_edge = [-0.1, 0, -0.3]
    assert_allclose(moved, [on_edge, on_edge, [-0.3, 0, 0], [0, 0, 0]], atol=1e-12)
