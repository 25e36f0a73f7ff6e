"""What triangle meshes of parts tell: undercuts, patch by patch."""

import numpy as np
import trimesh
from numpy.testing import assert_allclose

from design.body.meshes import undercut

UP = np.array([0.0, 0.0, 1.0])


def stairs():
    """10 mm long: a foot 3 mm wide, a step 5 mm wide, and a top 20 mm wide."""
    blocks = []
    for low, high, left in ((0, 4, 0.0), (4, 8, 3.0), (8, 12, 8.0)):
        block = trimesh.creation.box((28.0 - left, 10.0, high - low))
        block.apply_translation(((28.0 + left) / 2, 5.0, (low + high) / 2))
        blocks.append(block)
    return trimesh.boolean.union(blocks)


def test_the_deepest_undercut_is_one_ledge_and_not_two_across_a_wall():
    mesh = stairs()
    below = mesh.triangles_center[:, 2] < 11.9
    found = undercut(mesh, UP, below)
    assert_allclose(found.area_mm2, 10 * (3 + 5))
    assert_allclose(found.depth_mm, 5)
    assert_allclose(found.place_mm[2], 8)


def test_walls_along_the_pull_are_no_undercut():
    mesh = stairs()
    upright = np.abs(mesh.face_normals[:, 2]) < 0.5
    assert undercut(mesh, UP, upright).depth_mm == 0
