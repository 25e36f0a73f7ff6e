"""What is cut from a magnet template: holes through it all, marks beside them, a corner."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.pockets import Body, Outline, Pocket, tilted_frame
from design.layout.template_marks import (
    CORNER_MM,
    MARK_GAP_MM,
    MARK_LENGTH_MM,
    mark_place,
    mark_places,
    pockets_by_face,
    thinnest_mark_wall_mm,
)
from design.solids.magnet_template import PLATE_MM, corner_cut, hole_solid
from design.solids.primitives import OVERSHOOT_MM
from design.spec.object import ObjectSpec


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
    assert bounds(hole_solid(made, 0.1)) == pytest.approx(wanted, abs=1e-6)


def test_the_corner_is_a_triangle_through_the_plate():
    half = (18.0, 16.0)
    solid, reach = corner_cut(half), CORNER_MM + 2 * OVERSHOOT_MM
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


def edge_points(place, half):
    """Along the border of one bar of a mark."""
    along = np.linspace(-1, 1, 61)
    ones = np.ones(61)
    rows = [(ones, along), (-ones, along), (along, ones), (along, -ones)]
    return place + np.concatenate([np.column_stack(row) for row in rows]) * half


def thinnest_by_hand(centres, places, half, radius):
    """Between a plate's holes, + marks, edges and cut corner; of points along the bars' borders."""
    crosses = [
        np.vstack([edge_points(p, bar) for bar in ((1.5, 0.45), (0.45, 1.5))]) for p in places
    ]
    every = np.vstack(crosses)
    found = [
        *(half - abs(every).max(axis=0)),
        (half.sum() - 4.0 - every.sum(axis=1)).min() / 2**0.5,
    ]
    for k, cross in enumerate(crosses):
        found.append(np.linalg.norm(cross[:, None] - centres, axis=2).min() - radius)
        found += [np.linalg.norm(cross[:, None] - other, axis=2).min() for other in crosses[:k]]
    return min(found)


def test_marks_make_room_for_each_other_where_magnets_stand_close():
    """Of `instobj new` for a box of 21.9 × 34.4 × 32.6 mm with five magnets: two marks were 0.3 mm apart."""
    centres = np.array([[0, 0], [6.19, 4.16], [-6.19, 4.16], [-6.19, -4.16], [6.19, -4.16]])
    spec = ObjectSpec.model_validate(
        {
            "name": "box",
            "body": {"kind": "box", "size_mm": [21.9, 34.4, 32.6], "sensed_faces": [2]},
            "shell": {"thickness_mm": 5.0, "pocket_diameter_mm": 4.0, "pocket_depth_mm": 2.5},
            "magnets": {"diameter_mm": 4.0, "positions_mm": centres.tolist()},
        }
    )
    ((frame, pockets),) = pockets_by_face(spec)
    half, radius = np.array(frame.half_extents_mm), 2.0 + spec.printer.clearance_mm
    alone = np.array([mark_place(pockets, k, frame.half_extents_mm) for k in range(5)])
    assert thinnest_by_hand(centres, alone, half, radius) < 0.3
    places = mark_places(spec, pockets, frame.half_extents_mm)
    wall = thinnest_by_hand(centres, places, half, radius)
    assert wall > spec.printer.wall_mm
    assert thinnest_mark_wall_mm(spec) == pytest.approx(wall, abs=2e-3)
    nearest = np.linalg.norm(places[:, None] - centres, axis=2).argmin(axis=1)
    assert nearest.tolist() == [0, 1, 2, 3, 4], "a mark stands beside its own hole"
