"""The sweep of weak areas: every case can be placed and checked; bins and growth by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from design.spec_io import check
from studies.weak_areas import CASES, growth, path_rows, placed_case


def test_a_case_keeps_the_silicone_and_spreads_its_magnets():
    spec = ObjectSpec.model_validate({"name": "a", "silicone": {"youngs_modulus_mpa": 0.3}})
    wide, narrow = (placed_case(spec, case) for case in CASES[:2])
    assert check(narrow).silicone.youngs_modulus_mpa == 0.3
    assert_allclose(np.max(wide.magnets.positions_mm), 0.66 * 24)
    assert_allclose(np.max(narrow.magnets.positions_mm), 0.462 * 24, atol=0.01)


def test_bins_hold_medians_and_the_share_within_the_limit():
    path, bound = np.array([7.0, 7.5, 7.9, 15.0]), np.array([0.5, 1.0, 2.0, np.inf])
    near, far = path_rows(path, bound, 1.5)
    assert (near["locations"], near["median_mm"], near["within_limit"]) == (3, 1.0, 2 / 3)
    assert (far["from_mm"], far["median_mm"], far["within_limit"]) == (14.0, np.inf, 0.0)


def test_a_bound_that_doubles_every_three_millimetres_is_told_so():
    path = np.linspace(8, 20, 30)
    found = growth(np.append(path, 40.0), np.append(0.1 * 2 ** (path / 3), np.inf))
    assert_allclose(found["doubles_every_mm"], 3.0)
    assert_allclose(found["bound_at_15_mm"], 3.2)
    assert_allclose(found["r_squared"], 1.0)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids=str)
def test_every_case_fits(case):
    check(placed_case(ObjectSpec(name="a"), case))
