"""Which of two interfaces recordings speak for, worked out from cosines alone."""

from itertools import product
from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose

from studies.recorded.interface_fits import preference

GAINS = np.array([0.3, 0.2, 0.1, -0.05])


class Presses:
    """Three of each of four cases."""

    case = np.repeat(np.arange(4), 3)

    def __len__(self):
        return 12


def test_a_preference_is_the_mean_gain_and_its_chance_over_signs_of_cases():
    rng = np.random.default_rng(2)
    one, other = (SimpleNamespace(name=n, cosine=rng.uniform(0, 1, (12, 4))) for n in "ab")
    rows, case = np.arange(12), Presses.case
    one.cosine[rows, case] = other.cosine[rows, case] + GAINS[case]
    told = preference.__wrapped__(Presses(), one, other, 1)
    assert_allclose(told.difference, GAINS.mean())
    assert (told.better, told.cases) == (3, 4)
    sums = [abs(np.dot(signs, GAINS)) for signs in product((1, -1), repeat=4)]
    assert told.p_cases == np.mean(np.array(sums) >= GAINS.sum() - 1e-9)
    assert 0 < told.p_places <= 1
