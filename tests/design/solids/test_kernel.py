"""CadQuery without what it loads at once and nothing here asks for."""

import pytest

from design.solids.kernel import cq


def test_what_was_left_out_comes_where_cadquery_asks_for_it():
    box = cq.Workplane().box(1, 2, 3)
    assert box.val().toVtkPolyData(0.1).GetNumberOfCells() >= 12
    both = cq.Assembly(box, name="below").add(box, name="above")
    both.constrain("below@faces@>Z", "above@faces@<Z", "Plane").solve()
    assert both.objects["above"].loc.toTuple()[0] == pytest.approx((0, 0, 3), abs=1e-4)
