"""Edges and facets, numbered as scikit-fem numbers them."""

import numpy as np
import pytest
from skfem import MeshTet

from fem.mesh.entities import build_entities, tet_mesh
from tests.support.mechanics.fem_cases import box_mesh


@pytest.mark.parametrize("dtype", [np.int32, np.int64])
def test_edges_and_facets_are_those_of_scikit_fem(dtype):
    plain = box_mesh((3, 4, 2), (1.0, 1.0, 1.0))
    shuffled = np.random.default_rng(3).permutation(plain.p.shape[1])[plain.t].astype(dtype)
    points = np.ascontiguousarray(plain.p)
    meshes = MeshTet(points, shuffled), tet_mesh(points.T, shuffled.T)
    assert vars(meshes[1])["build_entities"] is build_entities
    for name in ("edges", "facets", "t2e", "t2f", "f2t"):
        exact, found = (np.asarray(getattr(mesh, name)) for mesh in meshes)
        np.testing.assert_array_equal(found, exact)
        assert found.dtype == exact.dtype
    np.testing.assert_array_equal(meshes[1].boundary_facets(), meshes[0].boundary_facets())


@pytest.mark.parametrize("last", [2**21 - 1, 2**21, 2**30])
@pytest.mark.parametrize(
    "corners", [[[0, 1], [2, 3]], [[0, 1, 2], [1, 2, 3], [0, 2, 3]], [[0, 1, 2, 3]]]
)
def test_vertices_of_any_number_and_corners_of_any_count(last, corners):
    near_last = last - np.array([[3, 1, 0, 2], [0, 2, 3, 9], [1, 2, 3, 0], [4, 0, 2, 1]])
    t = np.vstack([near_last, [[2, last, 5, 7], [0, 1, 2, last]]]).astype(np.int32).T
    exact, found = (build(t, corners) for build in (MeshTet.build_entities, build_entities))
    for one, other in zip(exact, found, strict=True):
        np.testing.assert_array_equal(other, one)
