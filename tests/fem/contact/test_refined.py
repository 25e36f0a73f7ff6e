"""Compliance of cells on a face that leans beside the place pressed, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from fem.contact import refined
from fem.contact.refined import place_compliance, wide_block

WIDE = np.arange(16.0).reshape(4, 4) + 16 * np.eye(4)
MATRIX = np.array([[1.0, 0.5, 0.0], [0.0, 0.5, 2.0]])
NEAR = np.array([[4.0, 1.0, 0.5], [1.0, 3.0, 0.2], [0.5, 0.2, 2.0]])


def spread(flat):
    face = SimpleNamespace(
        wide_compliance=WIDE, frame=SimpleNamespace(flat=flat), bases=(), border=None
    )
    cosine = np.array([1.0, 0.8, np.nan])
    return SimpleNamespace(face=face, rows=np.array([1, 3]), matrix=MATRIX, cosine=cosine)


def test_the_wide_part_is_that_of_the_vertices_under_the_cells():
    inner = WIDE[np.ix_([1, 3], [1, 3])]
    assert_allclose(wide_block.__wrapped__(spread(True)), MATRIX.T @ inner @ MATRIX)


@pytest.mark.parametrize("flat", [True, False])
def test_cells_that_lean_are_larger_along_the_surface_by_their_cosine(monkeypatch, flat):
    """A cell beside the patch leans as if it were flat."""
    monkeypatch.setattr(refined, "wide_block", wide_block.__wrapped__)
    lean = np.ones(3) if flat else np.array([1.0, 1.25, 1.0])
    wanted = wide_block.__wrapped__(spread(flat)) + NEAR * lean[:, None] * lean
    assert_allclose(place_compliance.__wrapped__(spread(flat), NEAR), wanted)
