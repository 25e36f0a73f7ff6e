"""Presses of candidates as numbers: which places are filled in, and mixed presses at a force."""

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import PlaceGrid
from fem.candidates.motions import CandidateMotions, FaceCandidates, InterpolationError
from fem.candidates.presses import filled_candidates, values_on_grid, with_error
from tests.support.mechanics.candidate_cases import no_influence


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


def test_the_error_of_interpolation_is_of_the_pressed_face_s_own_points_by_hand():
    """All candidates shift by 1 mm and turn by 2 rad; what is true differs at two of three points."""
    axis = np.arange(4.0) - 1
    lattices = tuple(FaceCandidates(face, axis, axis, 2 + np.arange(4.0)) for face in (1, 3))
    motion = np.zeros((128, 2, 2, 6), np.float32)
    motion[:, :, 0, 0], motion[:, :, 1, 4] = 0.5, 4.0
    presses = np.broadcast_to(np.float32([2.0, 0.5]), (2, 1, 1, 2))
    places = PlaceGrid(np.zeros(1), np.zeros(1))
    none = InterpolationError(0.0, 0.0, 0.0, 0.0)
    one = np.ones((2, 1, 1))
    faces, deepest = np.array([1, 3]), np.ones((2, 1))
    table = CandidateMotions(
        faces,
        places,
        one,
        one,
        deepest,
        lattices,
        motion,
        presses,
        none,
        0.0,
        np.zeros((128, 2, 5), np.float32),
        no_influence(lattices[0].depth_mm),
    )
    miss = np.array([[0, 0.3, 0, 0, 0, 0.1], [0, 0, 0.4, 0.2, 0, 0], [0, 0, 0, 0, 0, 0]])
    true = [np.full((3, 2, 6), 50.0, np.float32) for _ in range(2)]  # of presses of the other face
    for point, row in enumerate((0, 0, 1)):
        true[row][point] = motion[0, 0] + miss[point] * np.array([[0.25], [1.0]])
    points = [np.array([[0.2, -0.3, 2.5], [1.1, 0.4, 3.2]]), np.array([[-0.5, 0.6, 2.7]])]
    error = with_error(table, points, true).error
    assert_allclose(error.displacement_rms, np.sqrt((0.09 + 0.16) / (1.09 + 1.16 + 1)))
    assert_allclose(error.displacement_worst, 0.4 / np.sqrt(1.16))
    assert_allclose(error.rotation_rms, np.sqrt((0.01 + 0.04) / (4.01 + 4.04 + 4)))
    assert_allclose(error.rotation_worst, 0.2 / np.sqrt(4.04))
