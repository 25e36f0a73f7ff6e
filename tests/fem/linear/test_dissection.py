"""Smallest separators, against all choices; trees and points that fill a tetrahedron."""

from itertools import combinations

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose

from fem.linear.dissection import first_descendants, vertex_cover
from fem.linear.layers import inner_points


@pytest.mark.parametrize("seed", range(12))
def test_a_cover_is_the_smallest_of_all_that_cover_every_edge(seed):
    rng = np.random.default_rng(seed)
    left = rng.random(9) < 0.5
    edges = np.array([pair for pair in combinations(range(9), 2) if rng.random() < 0.4])
    rows, columns = np.concatenate([edges, edges[:, ::-1]]).T
    across = left[rows] & ~left[columns]
    found = vertex_cover(rows, columns, left)
    assert (found[rows[across]] | found[columns[across]]).all()
    least = next(
        size
        for size in range(10)
        for chosen in combinations(range(9), size)
        if np.isin(np.stack([rows[across], columns[across]]), chosen).any(axis=0).all()
    )
    assert found.sum() == least


def test_a_graph_without_edges_across_needs_no_cover():
    graph = sp.csr_matrix(np.eye(4))
    left = np.array([True, True, False, False])
    assert not vertex_cover(*graph.nonzero(), left).any()


def test_subtrees_begin_at_their_first_leaf():
    """Nodes 0 and 1 are children of 2, 3 and 4 of 5, 2 and 5 of 6."""
    parent = np.array([2, 2, 6, 5, 5, 6, 7])
    assert first_descendants(parent).tolist() == [0, 1, 0, 3, 4, 3, 0]


def test_points_spread_evenly_over_a_tetrahedron():
    points = inner_points()
    assert points.shape == (56, 4)
    assert points.min() > 0
    assert_allclose(points.sum(axis=1), 1)
    assert_allclose(points.mean(axis=0), 1 / 4, atol=1e-12)
    assert len(np.unique(points.round(9), axis=0)) == 56
