"""What is cut from a magnet template: holes through it all, marks beside them, a corner."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.pockets import Body, Outline, Pocket, tilted_frame
from design.solids.magnet_template import (
    CORNER_MM,
    MARK_GAP_MM,
    MARK_LENGTH_MM,
    PLATE_MM,
    _corner,
    _hole,
    mark_place,
)
from design.solids.primitives import OVERSHOOT_MM


def pocket(x, y, outline, tilt=(0.0, 0.0)):
    body = Body(np.array([x, y, -2.5]), tilted_frame(*tilt), outline, 1.0, "a magnet")
    return Pocket(body, outline)


def bounds(solid):
    box = solid.BoundingBox()
    return [box.xmin, box.xmax, box.ymin, box.ymax, box.zmin, box.zmax]


@pytest.mark.parametrize("outline", [Outline((3.0, 3.0), True), Outline((2.0, 4.0), False)])
def test_a_hole_goes_through_the_plate_where_the_pocket_s_axis_leaves_the_face(outline):
    made = pocket(5.0, -3.0, outline, (0.0, 20.0))
    x, (wide, long) = 5.0 + 2.5 * np.tan(np.deg2rad(20.0)), outline.half_mm
    ends = [-OVERSHOOT_MM, PLATE_MM + OVERSHOOT_MM]
    wanted = [x - wide - 0.1, x + wide + 0.1, -3 - long - 0.1, -3 + long + 0.1, *ends]
    assert bounds(_hole(made, 0.1)) == pytest.approx(wanted, abs=1e-6)


def test_the_corner_is_a_triangle_through_the_plate():
    half = (18.0, 16.0)
    solid, reach = _corner(half), CORNER_MM + 2 * OVERSHOOT_MM
    assert solid.Volume() == pytest.approx(reach**2 / 2 * 20)
    x, y = half[0] + OVERSHOOT_MM, half[1] + OVERSHOOT_MM
    assert bounds(solid) == pytest.approx([x - reach, x, y - reach, y, -10, 10], abs=1e-6)


def test_a_mark_stands_beside_its_hole_where_most_room_is():
    disk = Outline((3.0, 3.0), True)
    away = 3.0 + MARK_GAP_MM + MARK_LENGTH_MM / 2
    room = MARK_GAP_MM + MARK_LENGTH_MM / 2
    place = mark_place((pocket(10.0, 0.0, disk),), 0, (18.0, 18.0))
    assert_allclose(np.hypot(*(place - [10, 0])), away)
    assert (18 - abs(place)).min() >= room, "as far from the edge as from its hole"
    pair = (pocket(0.0, 0.0, disk), pocket(-9.0, 0.0, disk), pocket(0.0, 9.0, disk))
    place = mark_place(pair, 0, (18.0, 18.0))
    assert_allclose(np.hypot(*place), away)
    others = np.array([[-9.0, 0.0], [0.0, 9.0]])
    assert (np.linalg.norm(place - others, axis=1) - 3).min() >= room
