"""Several tips at once: equal to single presses alone, coupled together, balanced in a grasp."""

import numpy as np
import pytest

from design.errors import InputError
from fem.presses.joint import Tip, press_tips
from fem.presses.table import press_places, surface_weights_mm2
from fem.presses.to_force import press_to_force


def test_a_single_tip_is_the_press_of_the_lattice(rigid_spec, rigid_response):
    xy = np.array([[4.0, -3.0]])
    press = press_tips(rigid_spec, rigid_response, [Tip(3, *xy[0])], np.array([1.5]))
    pressure = press_places(rigid_spec, rigid_response, 2, xy, np.array([1.5]))[0, 0]
    force = pressure @ surface_weights_mm2(rigid_response.surfaces[2])
    np.testing.assert_allclose(press.force_n, [force], rtol=1e-9)
    rows = rigid_response.compliance[rigid_response.magnet_loads, rigid_response.face_loads(2)]
    np.testing.assert_allclose(press.motion.ravel(), rows @ pressure, rtol=0, atol=1e-9)


def test_a_second_tip_on_the_face_carries_load_with_the_first(rigid_spec, rigid_response):
    """Tips 15 mm apart: silicone pressed out under one bulges against the other (+1 to +8 %)."""
    depth = np.array([2.0, 2.0])
    both = press_tips(rigid_spec, rigid_response, [Tip(1, -7.5, 1.0), Tip(1, 7.5, 1.0)], depth)
    alone = press_tips(rigid_spec, rigid_response, [Tip(1, -7.5, 1.0)], depth[:1])
    assert 1.01 < both.force_n[0] / alone.force_n[0] < 1.08


def test_faces_hardly_feel_each_other_but_motions_add_up(rigid_spec, rigid_response):
    tips, depth = [Tip(3, 4.5, 1.5), Tip(5, -6.0, 3.0)], np.array([2.0, 1.5])
    both = press_tips(rigid_spec, rigid_response, tips, depth)
    each = [press_tips(rigid_spec, rigid_response, [tip], depth[[i]]) for i, tip in enumerate(tips)]
    np.testing.assert_allclose(both.force_n, [p.force_n[0] for p in each], rtol=0.01)
    largest = abs(both.motion).max()
    assert abs(both.motion - each[0].motion - each[1].motion).max() < 0.01 * largest
    assert abs(both.motion - each[0].motion).max() > 0.3 * largest


def test_a_squeeze_balances_its_jaws(rigid_spec, rigid_response):
    jaws = ([Tip(3, 4.5, 1.5)], [Tip(5, -7.5, 3.0), Tip(5, 7.5, 3.0)])
    grasp = press_to_force(rigid_spec, rigid_response, jaws, 12.0)
    np.testing.assert_allclose(grasp.force_n[0], 12.0, rtol=1e-5)
    np.testing.assert_allclose(grasp.force_n[1:].sum(), 12.0, rtol=1e-5)
    np.testing.assert_allclose(grasp.depth_mm[1], grasp.depth_mm[2], rtol=0, atol=1e-12)
    assert grasp.depth_mm[0] > grasp.depth_mm[1]


@pytest.mark.parametrize(
    ("tips", "words"),
    [
        ([Tip(6, 0.0, 0.0)], "not a sensed face"),
        ([Tip(1, 21.5, 0.0)], "misses face 1"),
        ([Tip(1, 0.0, 0.0), Tip(1, 6.0, 0.0)], "overlap"),
    ],
)
def test_impossible_tips_are_refused(rigid_spec, rigid_response, tips, words):
    with pytest.raises(InputError, match=words):
        press_tips(rigid_spec, rigid_response, tips, np.full(len(tips), 1.0))


@pytest.mark.parametrize(("force", "words"), [(0.0, "positive"), (1e4, "not reached")])
def test_impossible_squeezes_are_refused(rigid_spec, rigid_response, force, words):
    with pytest.raises(InputError, match=words):
        press_to_force(rigid_spec, rigid_response, ([Tip(3, 0.0, 0.0)], [Tip(5, 0.0, 0.0)]), force)
