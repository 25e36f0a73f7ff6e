"""Closure, ε, volume and friction of grasps whose answers are known."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.grasps.wrench_space import (
    closing_friction,
    contact_wrenches,
    friction_used,
    is_closed,
    wrench_space,
)
from tests.estimator.grasps.grasps_by_hand import HALF_MM, placed


def test_three_unit_forces_at_120_degrees_span_a_triangle():
    turn = np.deg2rad([90, 210, 330])
    space = wrench_space(np.column_stack([np.cos(turn), np.sin(turn)]))
    assert space.closed
    assert_allclose(space.epsilon, 0.5, rtol=1e-12)  # its incircle
    assert_allclose(space.volume, 3 * np.sqrt(3) / 4, rtol=1e-12)


def test_wrenches_along_all_six_axes_span_a_cross_polytope():
    space = wrench_space(np.vstack([np.eye(6), -np.eye(6)]))
    assert_allclose(space.epsilon, 1 / np.sqrt(6), rtol=1e-9)
    assert_allclose(space.volume, 2**6 / 720, rtol=1e-9)


def test_a_grasp_from_one_side_is_not_closed():
    space = wrench_space(np.array([[1.0, 0.2], [1.0, -0.2], [0.5, 0.0], [1.2, 0.0]]))
    assert not space.closed
    assert space.epsilon == 0.0


def test_a_flat_set_of_wrenches_has_no_volume():
    space = wrench_space(np.column_stack([np.linspace(-1, 1, 9), np.zeros(9)]))
    assert (space.closed, space.epsilon, space.volume) == (False, 0.0, 0.0)


def test_two_soft_fingers_close_with_friction_and_not_without():
    pair = placed([3, 5], [[0, 0], [0, 0]], [5, 5])
    for friction, closed in ((0.0, False), (0.3, True)):
        wrenches = contact_wrenches(pair.point_mm, pair.axes, friction, 2.0, HALF_MM)
        assert wrench_space(wrenches).closed is closed


def test_two_fingers_that_do_not_turn_about_their_line_leave_it_free():
    pair = placed([3, 5], [[0, 0], [0, 0]], [5, 5])
    wrenches = contact_wrenches(pair.point_mm, pair.axes, 0.5, 0.0, HALF_MM)
    assert not wrench_space(wrenches).closed


def test_a_finger_turns_by_two_thirds_of_friction_times_its_patch():
    one = placed([3], [[0, 0]], [5])
    wrenches = contact_wrenches(one.point_mm, one.axes, 0.6, 3.0, HALF_MM)
    about_normal = wrenches[:, 3:] @ one.inward[0] * HALF_MM
    assert_allclose([about_normal.min(), about_normal.max()], [-1.2, 1.2], atol=1e-12)


@pytest.mark.parametrize("offset_mm", [0.0, 6.0, 12.0])
def test_two_shifted_fingers_need_the_tangent_of_the_angle_of_their_line(offset_mm):
    # y of face 5 points the other way, so that the fingers are apart by the whole offset
    pair = placed([3, 5], [[0, offset_mm / 2], [0, offset_mm / 2]], [5, 5])
    needed = closing_friction(pair.point_mm, pair.axes, 1.0)
    assert_allclose(needed, offset_mm / (2 * HALF_MM), atol=1e-9)
    for share in (0.97, 1.03) if offset_mm else ():
        wrenches = contact_wrenches(pair.point_mm, pair.axes, share * needed, 1.0, HALF_MM)
        assert is_closed(wrenches) is wrench_space(wrenches).closed is (share > 1)


def test_fingers_on_neighbouring_faces_need_the_tangent_of_45_degrees():
    pair = placed([1, 3], [[0, 0], [0, 0]], [5, 5])
    assert_allclose(closing_friction(pair.point_mm, pair.axes, 1.0), 1.0, rtol=1e-9)


def test_two_fingers_beside_one_close_with_hardly_any_friction():
    three = placed([3, 3, 5], [[0, 8], [0, -8], [0, 0]], [5, 5, 10])
    assert closing_friction(three.point_mm, three.axes, 1.0) < 0.03


def test_three_fingers_whose_lines_do_not_meet_need_friction():
    # two push from faces 3 and 5 as far apart as 16 mm, the third from face 1 helps neither
    three = placed([3, 5, 1], [[0, 8], [0, 8], [0, 0]], [5, 5, 5])
    assert 0.2 < closing_friction(three.point_mm, three.axes, 1.0) <= 0.4 * 1.035 + 0.01


def test_fingers_that_push_the_same_way_never_close():
    pair = placed([3, 3], [[0, 8], [0, -8]], [5, 5])
    assert closing_friction(pair.point_mm, pair.axes, 1.0) == np.inf


def test_one_finger_closes_nothing():
    one = placed([3], [[0, 0]], [5])
    assert closing_friction(one.point_mm, one.axes, 1.0) == np.inf


def test_the_contact_that_pulls_most_for_its_force_tells_the_friction_used():
    pair = placed([3, 5], [[0, 0], [0, 0]], [5, 10], [[0.3, 0.4], [0.6, 0.8]])
    assert_allclose(friction_used(pair.force_n), 0.1)
    assert np.isnan(friction_used(placed([3], [[0, 0]], [5]).force_n))
