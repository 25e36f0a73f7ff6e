"""A planted convention is found on one recording and holds on the other; nothing is found in noise."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.recorded_presses import RecordedPresses, own_channels
from studies.recorded.convention_search import (
    CANDIDATES,
    ORDERS,
    SYMMETRIES,
    TURNS,
    cosines,
    search,
    search_face,
)

CASE = np.repeat(np.arange(8), 3)
RECORDING = (CASE >= 5).astype(int)


def predicted(rng):
    """Every case under every symmetry has a pattern of its own."""
    patterns = rng.standard_normal((len(SYMMETRIES), 8, 3, 3))
    return np.repeat(patterns[:, None], len(CASE), axis=1)


def test_candidates_are_all_different_and_the_first_are_as_documented():
    assert len({np.array2string(turn) for turn in TURNS}) == 24
    assert len({np.array2string(matrix) for matrix in SYMMETRIES}) == 8
    assert_allclose(TURNS[0], np.eye(3))
    assert ORDERS[0] == (0, 1, 2)


def test_a_search_in_noise_looks_good_where_it_was_chosen_alone():
    rng = np.random.default_rng(3)
    every = cosines(rng.standard_normal((len(CASE), 3, 3)), predicted(rng))
    found = search(every, CASE, RECORDING, 1, 39, 1)
    assert found.chosen_on > found.judged + 0.2
    assert found.p > 0.05


def test_symmetries_are_the_turns_and_mirrors_of_a_square():
    turn = np.array([[0, -1], [1, 0]])
    for number, matrix in enumerate(SYMMETRIES):
        assert_allclose(matrix @ matrix.T, np.eye(2))
        if number < 4:
            assert_allclose(matrix, np.linalg.matrix_power(turn, number))
        else:
            assert round(np.linalg.det(matrix)) == -1
    for matrix in TURNS:
        assert_allclose(matrix @ matrix.T, np.eye(3))
        assert round(np.linalg.det(matrix)) == 1
    assert CANDIDATES == 8 * 6 * 24


def of_face_two(signal):
    """Presses of face 2 at eight places, on two recordings."""
    cases = tuple(((2, float(k), 0.0),) for k in range(8))
    force = np.zeros((len(CASE), 6))
    force[:, 1] = 5.0
    return RecordedPresses(signal, force, CASE, RECORDING, np.full(len(CASE), 9), cases, np.ones(3))


@pytest.mark.parametrize("dead", [[4], [3, 4, 5]], ids=["an axis", "a chip"])
def test_chips_with_a_dead_axis_count_nothing(dead):
    """In the recording and in what is predicted: the others alone tell the planted convention."""
    rng = np.random.default_rng(5)
    spec = ObjectSpec(name="cube")
    model = rng.standard_normal((len(SYMMETRIES), len(CASE), 8, 45))
    own = own_channels(spec, 2)
    order, turn = ORDERS[3], TURNS[9]
    true = model[5, np.arange(len(CASE)), CASE][:, own].reshape(-1, 3, 3)
    signal = model[0, np.arange(len(CASE)), CASE].copy()
    signal[:, own[np.reshape(np.arange(9), (3, 3))[list(order)].ravel()]] = np.einsum(
        "ab,pcb->pca", turn, true
    ).reshape(-1, 9)
    signal[:, own[dead]] = np.nan
    found = search_face(spec, of_face_two(signal), model, 2, 0, 9)
    assert found.candidate == (5, 3, 9)
    assert_allclose([found.chosen_on, found.judged], 1)
    other = signal.copy()
    other[:, own[3:6]] = rng.standard_normal((len(CASE), 3))
    other[::2, own[dead]] = np.nan
    assert search_face(spec, of_face_two(other), model, 2, 0, 9) == found


def test_conventions_are_those_of_three_chips():
    spec = ObjectSpec(name="cube", sensors={"count_per_face": 2})
    with pytest.raises(InputError, match="face 2 has 6 channels"):
        search_face(
            spec, of_face_two(np.zeros((len(CASE), 30))), np.zeros((8, len(CASE), 8, 30)), 2, 0, 9
        )


def test_a_face_whose_chips_all_have_a_dead_axis_is_refused():
    signal = np.ones((len(CASE), 45))
    signal[:, own_channels(ObjectSpec(name="cube"), 2)[[0, 4, 8]]] = np.nan
    model = np.zeros((8, len(CASE), 8, 45))
    with pytest.raises(InputError, match="no chip of face 2 answers on all three axes"):
        search_face(ObjectSpec(name="cube"), of_face_two(signal), model, 2, 0, 9)
