"""Pockets of any tilt against points strewn over them, and ways between straight pieces."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.distance import cdist

from design.body.surface_chart import flat_frame
from design.layout.pockets import (
    Body,
    Outline,
    Pocket,
    axis_in_object_mm,
    board_frame,
    distance_of_segments_mm,
    lists_of_sensed_faces,
    neighbours,
    tilted_frame,
)
from tests.support.objects.pocket_gaps import gap_across_edge_mm
from tests.support.objects.worked_objects import worked

ROUND, FLAT = Outline((3.0, 3.0), True), Outline((2.5, 4.0), False)
TURN = np.linspace(0, 2 * np.pi, 3601)
TILTS = [(0.0, 0.0), (20.0, 0.0), (-15.0, 25.0), (8.0, -30.0), (28.0, 17.0)]


def rim(outline):
    """Points of an outline's border, in its own plane."""
    if outline.round:
        return outline.half_mm[0] * np.column_stack([np.cos(TURN), np.sin(TURN)])
    return np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * outline.half_mm


def pocket(outline, tilt, centre=(4.0, -6.0, -3.0), height=2.0):
    body = Body(np.array(centre), tilted_frame(*tilt), outline, height, "a magnet")
    return Pocket(body, outline)


@pytest.mark.parametrize("tilt", TILTS)
@pytest.mark.parametrize("outline", [ROUND, FLAT], ids=["disk", "block"])
@pytest.mark.parametrize("centre", [(4.0, -6.0, -3.0), (-5.0, 2.0, -4.5)])
def test_a_pocket_reaches_as_far_as_its_floor_and_its_mouth(tilt, outline, centre):
    made = pocket(outline, tilt, centre)
    axis, across = made.axis, rim(outline) @ made.body.frame[:, :2].T
    floor = made.body.centre_mm - axis + across
    along = -(made.body.centre_mm[2] + across[:, 2]) / axis[2]
    mouth = made.body.centre_mm + across + along[:, None] * axis
    assert_allclose(mouth[:, 2], 0, atol=1e-12)
    points = np.concatenate([floor, mouth])
    assert_allclose(made.reach_mm, abs(points[:, :2]).max(axis=0), atol=1e-5)
    assert_allclose(made.lowest_mm, floor[:, 2].min(), atol=1e-5)
    low, high = made.axis_ends_mm
    assert_allclose(low, made.body.centre_mm - axis)
    assert_allclose(high, made.body.centre_mm + along.max() * axis, atol=1e-5)
    assert_allclose(made.body.centre_mm[2] + made.mouth_mm * axis[2], 0, atol=1e-12)
    assert_allclose(made.volume_mm3, outline.area_mm2 * (1.0 + along.mean()), rtol=1e-3)


def test_tilts_turn_about_the_face_s_axes_and_boards_about_its_normal():
    assert_allclose(tilted_frame(90.0, 0.0) @ [0, 0, 1], [0, -1, 0], atol=1e-12)
    assert_allclose(tilted_frame(0.0, 90.0) @ [0, 0, 1], [1, 0, 0], atol=1e-12)
    assert_allclose(tilted_frame(0.0, 90.0) @ [0, 1, 0], [0, 1, 0], atol=1e-12)
    for azimuth in (0.0, 0.7, 3.0):
        frame = board_frame(azimuth)
        assert_allclose(frame[:, 1], [np.cos(azimuth), np.sin(azimuth), 0])
        assert_allclose(np.cross(frame[:, 0], frame[:, 1]), frame[:, 2], atol=1e-12)


def test_a_body_fills_its_outline_over_its_height():
    assert pocket(FLAT, (0.0, 0.0), height=2.5).body.volume_mm3 == 5 * 8 * 2.5
    assert pocket(ROUND, (0.0, 0.0), height=2.5).body.volume_mm3 == pytest.approx(9 * np.pi * 2.5)


def test_outlines_have_their_own_area_radius_support_and_corners():
    assert (ROUND.radius_mm, FLAT.radius_mm) == (3.0, pytest.approx(np.hypot(2.5, 4)))
    assert (ROUND.area_mm2, FLAT.area_mm2) == (pytest.approx(9 * np.pi), 40.0)
    assert ROUND.inset(0.5) == Outline((2.5, 2.5), True)
    assert FLAT.inset(0.5) == Outline((2.0, 3.5), False)
    for outline in (ROUND, FLAT):
        for way in np.array([[1.0, 0], [0, -2], [0.3, 0.4], [-5, 1]]):
            assert_allclose(outline.support_mm(way), (rim(outline) @ way).max(), atol=1e-5)
        for sides in (6, 16):
            corners = outline.corners_mm(sides)
            x, y = corners.T
            area = np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2
            assert_allclose(area, outline.area_mm2)
            assert len(corners) == (sides if outline.round else 4)


def nearest(a, b, steps=201):
    share = np.linspace(0, 1, steps)[:, None]
    p, q = a[0] + share * (a[1] - a[0]), b[0] + share * (b[1] - b[0])
    return cdist(p, q).min()


def test_straight_pieces_are_as_far_apart_as_their_nearest_points():
    """Also where an end is nearest, and where they are parallel."""
    rng = np.random.default_rng(1)
    for _ in range(40):
        a, b = rng.uniform(-1, 1, (2, 2, 3))
        assert_allclose(distance_of_segments_mm(a, b), nearest(a, b), atol=0.015)
    line = np.array([[0.0, 0, 0], [2, 0, 0]])
    for shift, wanted in (
        ((0, 3, 0), 3), ((1, 3, 0), 3), ((4, 0, 0), 2), ((-5, 0, 4), 5), ((2, 1, 0), 1),
    ):  # fmt: skip
        assert_allclose(distance_of_segments_mm(line, line + shift), wanted, atol=1e-9)
        assert_allclose(distance_of_segments_mm(line + shift, line), wanted, atol=1e-9)
        assert_allclose(distance_of_segments_mm(line, line[::-1] + shift), wanted, atol=1e-9)


def strewn(frame, made):
    """Points of a pocket's cylinder between its axis's ends, in the object's frame."""
    tangent = frame.tangent(made.body.centre_mm[:2])
    low, high = axis_in_object_mm(frame, made)
    across = rim(made.outline)[::150] @ (tangent.axes @ made.body.frame[:, :2]).T
    share = np.linspace(0, 1, 40)[:, None, None]
    return (low + share * (high - low) + across).reshape(-1, 3)


@pytest.mark.parametrize(("one", "other"), [(0, 0), (1, 2), (2, 4), (4, 3), (1, 1)])
def test_gaps_across_an_edge_are_never_above_the_true_ones(one, other):
    frames = [flat_frame(number, np.array([21.0, 22.0, 23.0])) for number in (1, 3)]
    a = pocket(ROUND, TILTS[one], (-3.0, 9.0, -3.0))
    b = pocket(ROUND, TILTS[other], (-11.0, 2.0, -3.0))
    gap = gap_across_edge_mm(frames[0], a, frames[1], b)
    points, others = strewn(frames[0], a), strewn(frames[1], b)
    true = cdist(points, others).min()
    assert gap <= true + 0.1
    assert gap > 0.7 * true
    assert gap_across_edge_mm(frames[1], b, frames[0], a) == pytest.approx(gap)


def test_neighbours_meet_at_an_edge():
    frames = tuple(flat_frame(number, np.full(3, 20.0)) for number in (1, 2, 3, 6))
    found = {(a.number, b.number) for a, b in neighbours(frames)}
    assert found == {(1, 2), (1, 3), (2, 3), (2, 6), (3, 6)}


def test_lists_of_places_begin_with_face_1_and_go_round_or_are_one_for_each_sensed_face():
    one, two, three = ((1.0, 0.0),), ((2.0, 0.0),), ((3.0, 0.0),)
    some = worked("closed box").changed(body=worked("closed box").body.changed(sensed_faces=(3, 5)))
    assert lists_of_sensed_faces(worked("closed box"), (one, two, three, one)) == (
        *(one, two, three, one),
        *(one, two),
    )
    assert lists_of_sensed_faces(some, (one, two, three)) == (three, two)
    assert lists_of_sensed_faces(some, (one, two)) == (one, two)


def test_pockets_whose_axes_nearly_meet_overlap_by_what_is_left_of_both_radii():
    """Along z and along x, both 7 mm past the other, 0.4 mm apart in y."""
    one = pocket(ROUND, (0.0, 0.0), centre=(3.0, 0.0, -13.0))
    other = pocket(ROUND, (0.0, 0.0), centre=(-3.0, 0.4, -13.0))
    top, side = (flat_frame(number, np.full(3, 10.0)) for number in (1, 3))
    assert gap_across_edge_mm(top, one, side, other) == pytest.approx(0.4 - 6.0)
