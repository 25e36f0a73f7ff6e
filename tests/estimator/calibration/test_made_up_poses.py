"""Fits of poses: their numbers by hand on made-up cosines and presses."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration import pose_fit, validation
from estimator.calibration.pose_fit import Calibration


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
