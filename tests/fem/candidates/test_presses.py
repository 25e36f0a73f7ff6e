"""Presses of candidates as numbers: which places are filled in, and mixed presses at a force."""

import numpy as np
from numpy.testing import assert_allclose

from fem.candidates.motions import FaceCandidates
from fem.candidates.presses import filled_candidates, values_on_grid


def lattice(face):
    axis = np.arange(5.0) - 2
    return FaceCandidates(face, axis, axis, np.array([2.0, 3.0, 4.0]))


def parabola(one):
    x, y, depth = one.xyd_mm.T
    value = 1 + 0.2 * x - 0.1 * y + 0.05 * x**2 - 0.03 * y**2 + x * y * 0.01
    return np.stack([value * depth, value + one.face, -value * depth], axis=1)


def test_candidates_in_the_corners_of_round_faces_go_on_from_the_others():
    """Parabolas exactly; two faces, of which the first has no corners, at three depths each."""
    lattices = lattice(1), lattice(2)
    x, y, _ = lattices[0].xyd_mm.T
    known = [np.hypot(x, y) < 2.5, np.ones(75, bool)]
    every = [parabola(one) for one in lattices]
    given = np.concatenate([values[here] for values, here in zip(every, known, strict=True)])
    found = filled_candidates(lattices, known)(given.astype(np.float32))
    assert found.shape == (150, 3)
    assert_allclose(found, np.concatenate(every), atol=2e-5)
    deeper = np.stack([given, 2 * given], axis=1).astype(np.float32)
    found = filled_candidates(lattices, known)(deeper)
    assert found.shape == (150, 2, 3)
    assert_allclose(found[:, 1], 2 * np.concatenate(every), atol=4e-5)


def test_where_all_candidates_are_known_nothing_is_filled_in():
    values = np.arange(12.0).reshape(4, 3)
    lattices = lattice(1), lattice(2)
    assert filled_candidates(lattices, [np.ones(75, bool)] * 2)(values) is values


def test_places_that_a_face_has_not_are_missing():
    there = np.array([True, False, True])
    found = values_on_grid(there, np.array([[1.0, 2.0], [3.0, 4.0]]))
    assert_allclose(found, [[1, 2], [np.nan, np.nan], [3, 4]])
