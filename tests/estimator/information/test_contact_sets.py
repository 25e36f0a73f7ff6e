"""Sets of places that several tips press at once, counted by hand."""

from math import comb

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from design.errors import InputError
from design.spec.object import ContactGridSpec, IndenterSpec, ObjectSpec
from estimator.information.contact_sets import contact_sets, spread_places


def of_grid(count, radius_mm, pitch_mm=3.0):
    return ObjectSpec(
        name="grid",
        contact_grid=ContactGridSpec(count=count, pitch_mm=pitch_mm),
        indenter=IndenterSpec(radius_mm=radius_mm),
    )


def test_five_places_an_axis_are_spread_evenly():
    few = of_grid((5, 3), 1.5)
    assert_array_equal(spread_places(few), np.arange(15))
    many = spread_places(of_grid((9, 8), 1.5))
    assert_array_equal(np.unique(many // 8), [0, 2, 4, 6, 8])
    assert_array_equal(np.unique(many % 8), [0, 2, 4, 5, 7])
    assert len(many) == 25


def test_tips_side_by_side_do_not_touch():
    """15 places 3 mm apart: radii of 1.5 mm fit everywhere, a little more beside no neighbour."""
    fits, touches = of_grid((5, 3), 1.5), of_grid((5, 3), 1.51)
    neighbours = 4 * 3 + 5 * 2
    places = np.arange(15)
    assert len(contact_sets(fits, places, 2)) == comb(15, 2)
    pairs = contact_sets(touches, places, 2)
    assert len(pairs) == comb(15, 2) - neighbours
    assert (pairs[:, 0] < pairs[:, 1]).all()
    assert len(contact_sets(fits, places, 3)) == comb(15, 3)
    for one in contact_sets(touches, places, 3):
        xy = np.column_stack([one // 3, one % 3])
        away = np.abs(xy[:, None] - xy).sum(axis=-1)
        assert (away + 9 * np.eye(3) > 1).all()


def test_more_tips_than_fit_are_refused():
    with pytest.raises(InputError, match=r"4 tips of radius 4.6 mm do not fit"):
        contact_sets(of_grid((3, 3), 4.6), np.arange(9), 4)
