"""Labels of contacts, worked out by hand on a few frames: carried, numbered, named, put into slots."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from estimator.recordings.contacts import (
    block_numbers,
    carried_labels,
    contact_cases,
    contact_slots,
    place_keys,
    place_text,
)

NAN = np.nan
NOWHERE = [NAN, NAN]


def tips(*frames):
    """One tip per cell."""
    return np.array(frames, float)[:, :, None]


def test_keys_are_equal_to_a_micrometre_and_without_a_face_where_no_place_is_stated():
    face = np.array([[3, 5], [3, 5], [3, 5], [0, 5]])
    places = tips(
        [[1, 2], NOWHERE], [[1.0004, 2], NOWHERE], [[1.0006, 2], NOWHERE], [NOWHERE, NOWHERE]
    )
    assert place_keys(face, places).tolist() == [
        [3, 0, 1, 2, 1e6, 1e6],
        [3, 0, 1, 2, 1e6, 1e6],
        [3, 0, 1.001, 2, 1e6, 1e6],
        [0, 0, 1e6, 1e6, 1e6, 1e6],
    ]
    assert place_keys(face[:1], tips([NOWHERE, [3, 4]])).tolist() == [[0, 5, 1e6, 1e6, 3, 4]]


def test_blocks_change_with_any_part_of_the_key():
    keys = np.array([[1.0, 2], [1, 2], [1, 3], [1, 3], [0, 3], [1, 2]])
    assert block_numbers(keys).tolist() == [0, 0, 1, 1, 2, 3]


def test_labels_are_carried_from_after_else_from_before_within_a_session():
    """Frames 1 and 4 state a place in session 1, frame 7 in session 2; session 3 states none."""
    face, places = np.zeros((11, 2), int), np.full((11, 2, 1, 2), NAN)
    for frame, number, x in ((1, 2, 1.0), (4, 3, 4.0), (7, 5, 7.0)):
        face[frame, 0], places[frame, 0, 0] = number, (x, -x)
    session = np.array([1, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3])
    carried, xy = carried_labels(face, places, session)
    assert carried[:, 0].tolist() == [2, 2, 3, 3, 3, 3, 5, 5, 5, 0, 0]
    assert_array_equal(xy[:, 0, 0, 0], [1, 1, 4, 4, 4, 4, 7, 7, 7, NAN, NAN])
    assert_array_equal(xy[:, 0, 0, 1], -xy[:, 0, 0, 0])
    assert not carried[:, 1].any()
    assert np.isnan(xy[:, 1]).all()
    assert face[0, 0] == 0  # what was given stays


def test_cases_are_numbered_by_their_places_and_rest_has_none():
    face = np.array([[5], [5], [3], [3], [5], [0]])
    places = tips([[1, 2]], [[1, 2]], [[4, 5]], [[4, 5]], [[1, 2]], [NOWHERE])
    touching = np.array([[True], [False], [True], [True], [True], [False]])
    block, place, names = contact_cases(face, places, touching)
    assert block.tolist() == [0, 0, 1, 1, 2, 3]
    assert names == (((3, 4.0, 5.0),), ((5, 1.0, 2.0),))
    assert place.tolist() == [1, -1, 0, 0, 1, -1]


def test_a_case_of_two_cells_sorts_its_tips_and_one_cell_in_touch_is_enough():
    face, places = np.array([[5, 3]]), tips([[1, 2], [4, 5]])
    _, place, names = contact_cases(face, places, np.array([[False, True]]))
    assert (place.tolist(), names) == ([0], (((3, 4.0, 5.0), (5, 1.0, 2.0)),))
    assert place_text(names[0]) == "face 3 (4, 5) + face 5 (1, 2)"
    assert place_text(()) == "no place"


def test_places_are_named_to_a_micrometre():
    _, _, names = contact_cases(np.array([[3]]), tips([[1.23449, -0.0006]]), np.array([[True]]))
    assert names == (((3, 1.234, -0.001),),)


def test_tips_share_the_force_of_their_cell_and_empty_slots_hold_nothing():
    face = np.array([[3, 5]])
    places = np.array([[[[1, 2], [3, 4]], [[5, 6], NOWHERE]]], float)
    force, shear = np.array([[8.0, 5.0]]), np.array([[[2.0, -4.0], [0.5, 1.5]]])
    number, xy, force_xyz = contact_slots(face, places, force, shear, np.array([[True, True]]))
    assert number.tolist() == [[3, 3, 5, 0]]
    assert_array_equal(xy, [[[1, 2], [3, 4], [5, 6], NOWHERE]])
    assert_array_equal(force_xyz, [[[1, -2, 4], [1, -2, 4], [0.5, 1.5, 5], [NAN] * 3]])
    number, xy, force_xyz = contact_slots(face, places, force, shear, np.array([[False, True]]))
    assert number.tolist() == [[0, 0, 5, 0]]
    assert np.isnan(xy[0, :2]).all()
    assert force_xyz[0, 2, 2] == pytest.approx(5.0)
