"""The press that stands for a contact case in a fit of the pose."""

import numpy as np
from numpy.testing import assert_allclose, assert_array_equal

from estimator.calibration.pose_fit import Problem, means_of_cases
from estimator.calibration.recorded_presses import RecordedPresses


def test_the_typical_press_of_a_case_is_that_of_the_median_force():
    force = np.zeros((6, 5))
    force[:, 2] = [5.0, 1.0, 4.0, 2.0, 3.0, 9.0]
    signal = np.arange(18.0).reshape(6, 3)
    case, one = np.array([0, 0, 0, 0, 0, 1]), np.zeros(6, int)
    cases = (((3, 0.0, 0.0),), ((3, 3.0, 0.0),))
    problem = object.__new__(Problem)  # only its presses are asked
    presses = RecordedPresses(signal, force, case, one, one + 20, cases, np.ones(3))
    object.__setattr__(problem, "presses", presses)
    typical, recorded, _ = means_of_cases(problem, np.arange(6))
    assert_array_equal(typical, [4, 5])
    assert_allclose(recorded, [signal[:5].mean(axis=0), signal[5]])
