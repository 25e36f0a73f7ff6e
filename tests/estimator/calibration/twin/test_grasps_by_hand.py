"""Twins of whole objects on a mechanics that is a sum: what cases leave out, keep and predict."""

import numpy as np
from numpy.testing import assert_allclose

from estimator.calibration.twin import grasp_twin
from estimator.calibration.twin.pressed_cases import PressedCases
from estimator.calibration.twin.unknowns import STIFFENING

NUMBERS = 3 + len(STIFFENING)
"""The third is the modulus."""


class Linear:
    """Six cases at two levels, four channels that are sums of the numbers; seven numbers of a size
    that cases tell well, the first beyond what it may be."""

    rng = np.random.default_rng(3)
    design = rng.normal(0, 40, (12, 4))
    slopes = rng.normal(0, 20, (12, 4, NUMBERS))
    noise2 = rng.uniform(1, 4, (6, 2, 4))
    true = np.array([9.0, -1.0, 0.6, 0.4, -0.8, 1.2, 0.1, -0.3])[:NUMBERS]
    strange = rng.normal(0, 25, (6, 2, 4))

    def __init__(self, seen):
        self.pressed = seen

    def expected(self, numbers):
        return self.design + self.slopes @ numbers


def seen_as(counts):
    chip = np.sqrt(np.mean(counts**2, axis=2, keepdims=True)) * np.ones(counts.shape)
    case, level = counts.shape[:2]
    return PressedCases(
        np.arange(4), np.full((case, 1), 3), np.zeros((case, 1, 2)), np.ones((case, level, 1)),
        counts, Linear.noise2, chip, np.ones(3),
    )  # fmt: skip


def test_a_case_left_out_that_is_no_object_counts_as_infinitely_wrong():
    counts = (Linear.design + Linear.slopes @ Linear.true).reshape(6, 2, 4)
    mechanics = Linear(seen_as(counts))
    mechanics.expected = lambda numbers: (
        np.where(np.arange(12)[:, None] == 5, np.nan, 1.0) * np.ones(4)
    )
    left_over = grasp_twin.left_over_of(mechanics.pressed, 0.1)
    off = counts.reshape(12, 4) - Linear.design
    residual = grasp_twin.cases_left_out.__wrapped__(mechanics, left_over, Linear.slopes, off)
    rows = np.arange(12) != 5
    assert_allclose(residual[rows], counts.reshape(12, 4)[rows] - 1)
    assert np.isneginf(residual[5]).all()
