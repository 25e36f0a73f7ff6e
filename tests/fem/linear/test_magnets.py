"""Magnets move as rigid bodies."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.linear.elements import taylor_hood
from fem.linear.magnets import magnet_of_nodes, rigid_motion_basis
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import SILICONE, TetMesh
from tests.support.mechanics.fem_cases import box_mesh

CENTRES_MM = np.array([[1.1, 1.2, 1.3], [2.9, 2.6, 0.9]])


@pytest.fixture(scope="module")
def labelled():
    """A block of 4 × 4 × 2 mm with two clusters of elements taken as magnets."""
    mesh = box_mesh((8, 8, 4), (4.0, 4.0, 2.0), jiggle=0.1)
    centroid = mesh.p[:, mesh.t].mean(axis=1).T
    magnet = np.full(mesh.t.shape[1], SILICONE)
    for index, centre in enumerate(CENTRES_MM):
        magnet[np.linalg.norm(centroid - centre, axis=1) < 0.6] = index
    return TetMesh(mesh.p.T.copy(), mesh.t.T.astype(np.int64), magnet), taylor_hood(mesh)


def test_a_node_belongs_to_the_magnet_whose_elements_touch_it(labelled):
    mesh, space = labelled
    owner = magnet_of_nodes(mesh, space)
    for index in range(2):
        corners = {tuple(p) for p in mesh.points_mm[mesh.tets[mesh.magnet == index]].reshape(-1, 3)}
        edges = mesh.points_mm[mesh.tets[mesh.magnet == index]]
        middles = {
            tuple(np.round((e[i] + e[j]) / 2, 9)) for e in edges for i in range(4) for j in range(i)
        }
        owned = {tuple(np.round(node, 9)) for node in space.nodes_mm[owner == index]}
        assert owned == {tuple(np.round(corner, 9)) for corner in corners} | middles


def test_tied_nodes_follow_u_equals_c_plus_omega_cross_r(labelled):
    mesh, space = labelled
    owner = magnet_of_nodes(mesh, space)
    free = (owner < 0) & (space.nodes_mm[:, 2] > 1e-9)
    basis = rigid_motion_basis(space.nodes_mm, free, owner, CENTRES_MM)
    assert shape_of(basis) == (3 * space.node_count, 3 * free.sum() + 12)
    q = np.random.default_rng(2).standard_normal(shape_of(basis)[1])
    u = (basis @ q).reshape(3, -1).T
    for index, centre in enumerate(CENTRES_MM):
        c, omega = q[3 * free.sum() + 6 * index :][:3], q[3 * free.sum() + 6 * index :][3:6]
        nodes = owner == index
        assert nodes.sum() > 10
        exact = c + np.cross(omega, space.nodes_mm[nodes] - centre)
        assert_allclose(u[nodes], exact, rtol=0, atol=1e-13)
    assert_allclose(u[free], q[: 3 * free.sum()].reshape(3, -1).T, rtol=0, atol=0)
    assert (u[~free & (owner < 0)] == 0).all()
