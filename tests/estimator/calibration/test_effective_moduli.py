"""Moduli at which predicted sizes agree with recorded ones, on made-up sizes."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration import validation


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
