"""The sweep of weak areas: every case can be placed and checked; bins of distances."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from design.spec_io import check
from instobj.experiments.weak_areas import CASES, placed_case, reach_rows


def test_a_case_keeps_the_silicone_and_spreads_its_magnets():
    spec = ObjectSpec.model_validate({"name": "a", "silicone": {"youngs_modulus_mpa": 0.3}})
    (wide, near) = (
        next(c for c in CASES if (c.kind, c.magnets, c.spacing) == ("box", 5, spacing))
        for spacing in (1.0, 0.7)
    )
    placed, closer = placed_case(spec, wide), placed_case(spec, near)
    assert placed is not None
    assert closer is not None
    assert check(closer).silicone.youngs_modulus_mpa == 0.3
    assert_allclose(
        closer.magnets.positions_mm, 0.7 * np.array(placed.magnets.positions_mm), atol=0.01
    )


def test_a_bin_holds_medians_of_objects_with_enough_locations():
    away = np.array([1.0] * 6 + [6.0] * 4)
    many = (away, np.array([1.0] * 6 + [3.0] * 4))
    other = (np.full(9, 6.0), np.full(9, 5.0))
    near, far = reach_rows([many, other])
    assert (near["objects"], near["median"]) == (1, 1.0)
    assert (far["from_mm"], far["objects"], far["locations"], far["median"]) == (5.0, 1, 13, 5.0)


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES, ids=str)
def test_every_case_fits(case):
    placed = placed_case(ObjectSpec(name="a"), case)
    assert placed is not None
    check(placed)
