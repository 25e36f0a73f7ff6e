"""Searches and fits of conventions and poses: their numbers by hand on made-up cosines and presses."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration import pose_fit, validation
from estimator.calibration.pose_fit import Calibration
from studies.recorded import convention_search as conventions
from studies.recorded import resting_conventions
from studies.recorded.convention_search import TURNS, search, share_as_high


def test_a_p_is_the_share_of_the_null_and_itself_that_reaches_a_value():
    null = [0.1, 0.5, 0.5 - 1e-13, 0.9]
    assert share_as_high(null, 0.5) == pytest.approx(4 / 5)
    assert share_as_high(null, 0.50001) == pytest.approx(2 / 5)
    assert share_as_high(null, 0.95) == pytest.approx(1 / 5)


def test_a_candidate_is_chosen_on_one_recording_and_judged_on_the_others():
    """Two cases; the candidate (1, 0, 2) is best on recording 0 and reaches 0.7 on recording 1."""
    rng = np.random.default_rng(0)
    every = rng.uniform(-0.1, 0.1, (2, 2, len(TURNS), 4, 2))
    case, recording = np.array([0, 1, 0, 1]), np.array([0, 0, 1, 1])
    rows = np.arange(4)
    every[1, 0, 2, rows, case] = [0.9, 0.7, 0.8, 0.6]
    every[0, 0, unturned(), rows, case] = [0.2, 0.3, 0.4, 0.1]
    found = search(every, case, recording, 0, 50, seed=3)
    assert found.candidate == (1, 0, 2)
    assert_allclose([found.chosen_on, found.judged], [0.8, 0.7])
    assert_allclose([found.documented_chosen_on, found.documented], [0.25, 0.25])
    assert 0 <= found.null_median <= 0.7
    assert found.p <= 1
    other = search(every, case, recording, 1, 50, seed=3)
    assert_allclose([other.chosen_on, other.judged], [0.7, 0.8])
    again = search(every, case, recording, 0, 50, seed=3)
    assert again == found


def unturned():
    return conventions.unturned_labels()


def test_cases_are_exchanged_within_their_recording():
    case = np.array([0, 0, 1, 2, 3, 3, 4])
    recording = np.array([0, 0, 0, 1, 1, 1, 1])
    seen = set()
    for seed in range(30):
        found = conventions.exchanged_places(case, recording, np.random.default_rng(seed))
        assert set(found[:3]) == {0, 1}
        assert set(found[3:]) == {2, 3, 4}
        assert found[0] == found[1]
        assert found[4] == found[5]
        seen.add(tuple(found))
    assert len(seen) > 5


def test_cosines_of_candidates_are_those_of_turned_labels():
    """Chips in another order and turned: the candidate that undoes both has the cosine 1."""
    rng = np.random.default_rng(1)
    model = rng.normal(size=(2, 3, 2, 3, 3))
    order, turn = conventions.ORDERS[4], TURNS[9]
    recorded = np.einsum("pkc,bc->pkb", model[1, :, 0], turn)
    shown = np.empty_like(recorded)
    shown[:, list(order)] = recorded
    found = conventions.cosines(shown, model)
    assert found.shape == (2, 6, 24, 3, 2)
    best = np.unravel_index(found[..., 0].mean(axis=-1).argmax(), found.shape[:3])
    assert best[0] == 1
    assert found[*best, :, 0] == pytest.approx(1.0)
    plain = np.einsum("pkc,pkc->p", shown, model[0, :, 1])
    size = np.linalg.norm(shown, axis=(1, 2)) * np.linalg.norm(model[0, :, 1], axis=(1, 2))
    assert_allclose(found[0, 0, unturned(), :, 1], plain / size)


def test_resting_cosines_count_chips_that_answer_on_all_axes():
    """Two faces of two chips; one chip misses an axis, and its power does not count."""
    rng = np.random.default_rng(2)
    predicted, levels = rng.normal(size=(2, 12))
    levels[4] = np.nan
    boards = np.array([[0, 1], [1, 0]])
    found = resting_conventions.resting_cosines(predicted, levels, 2, boards)
    assert found.shape == (2, 2, 24)
    seen, model = levels.reshape(2, 2, 3), predicted.reshape(2, 2, 3)
    live = np.array([[True, False], [True, True]])
    size = np.linalg.norm(seen[live])

    def by_hand(board, order):
        """Face f of the levels at the place of board f of the model, its chips in the order."""
        dots, power = 0.0, 0.0
        for face in range(2):
            for chip in range(2):
                if live[face, order[chip]]:
                    one = model[board[face], chip]
                    dots += seen[face, order[chip]] @ one
                    power += one @ one
        return dots / (size * np.sqrt(power))

    straight = unturned()
    for row, board in enumerate(boards):
        for column, order in enumerate(([0, 1], [1, 0])):
            assert found[row, column, straight] == pytest.approx(by_hand(board, order))


def test_nuisances_that_are_not_freed_are_as_designed_and_scales_are_logarithms():
    values = {"rotation_deg": np.array([3.0, 0, -3]), "ln_remanence": np.array(0.02)}
    found = Calibration.from_values(values)
    assert (found.shift_mm, found.rotation_deg) == ((0.0, 0.0, 0.0), (3.0, 0.0, -3.0))
    assert found.remanence_scale == pytest.approx(np.exp(0.02))
    assert found.modulus_scale == 1.0


def presses(case):
    class Presses(SimpleNamespace):
        def __len__(self):
            return len(self.case)

    return Presses(case=np.array(case), cases=[()] * (max(case) + 1))


def test_folds_are_cases_or_every_other_press_of_each():
    given = presses([0, 1, 0, 0, 1, 2])
    by_case = pose_fit.folds_by_case.__wrapped__(given)
    assert [fold.tolist() for fold in by_case] == [[0, 2, 3], [1, 4], [5]]
    halves = pose_fit.folds_by_press.__wrapped__(given)
    assert [fold.tolist() for fold in halves] == [[0, 1, 3, 5], [2, 4]]


def test_cosines_of_rows_and_of_nothing():
    one, other = np.array([[3.0, 4.0], [0, 0]]), np.array([[4.0, 3.0], [1, 1]])
    assert_allclose(pose_fit.case_cosines(one, other), [24 / 25, 0])


def test_what_a_model_leaves_is_a_root_share_of_all_recorded_squares(monkeypatch):
    """Two presses of two channels, one of which is silent; the own cosine is made up."""
    recorded = np.array([[3.0, np.nan], [0.0, 4.0]])
    given = SimpleNamespace(signal_counts=recorded, case=np.array([0, 1]))
    predicted = np.array([[2.0, 9.0], [1.0, 4.0]])
    problem = SimpleNamespace(
        presses=given, design="design", predicted=lambda assembly, test, case: predicted[test]
    )
    monkeypatch.setattr(pose_fit, "mean_own_cosine", lambda problem, recorded, predicted: 0.25)
    found = pose_fit.judged_pose.__wrapped__(
        problem, [np.array([1]), np.array([0])], given.case, {}
    )
    assert found.own_cosine == 0.25
    assert found.left_share == pytest.approx(np.sqrt((1 + 1) / 25))
    assert found.all_cosine == pytest.approx((1 + 4 / np.sqrt(17)) / 2)


def test_effective_moduli_are_read_off_falling_sizes_and_bounded_by_the_table():
    ratios = validation.MODULUS_RATIOS
    sizes = (10 / ratios)[:, None, None] * np.ones((1, 4, 1))
    wanted = np.array([10.0, 10 / ratios[3], 10 / ratios[0] * 1.01, 10 / ratios[-1] * 0.99])
    found, bounded = validation.effective_ratios(wanted, sizes)
    assert_allclose(found[:, 0], [1.0, ratios[3], ratios[0], ratios[-1]])
    assert bounded[:, 0].tolist() == [True, True, False, False]
    rising = sizes.copy()
    rising[5] = 99.0  # noise: a size that does not fall counts as the least before it
    again, _ = validation.effective_ratios(wanted[:1], rising[:, :1])
    assert again[0, 0] == pytest.approx(1.0, rel=0.2)
