"""False forces of jaws, and shifts of the zero, of an object whose magnets hang on springs."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from estimator.field.forces import resting_loads
from estimator.information.false_force import false_force_n, jaw_effects, resting_shift
from estimator.signals.surroundings import longest, pull, surroundings, with_jaw
from fem.linear.response import FaceSurface, ResponseOperator
from tests.support.mechanics.odd_presses import SPEC, signals

SPRING_MM_PER_N = 0.1


def on_springs(mm_per_n=SPRING_MM_PER_N):
    """Every magnet moves along its own force; faces of one triangle that feel nothing of it."""
    corners = np.array([[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]])
    faces = tuple(FaceSurface(n, corners, np.array([[0, 1, 2]])) for n in range(1, 6))
    springs = np.tile([mm_per_n] * 3 + [0.0] * 3, len(magnet_layout(SPEC).face))
    return ResponseOperator(faces, np.diag(np.concatenate([np.ones(15), springs])), 15, 0)


def test_a_press_is_taken_for_itself_and_half_of_two_for_what_lies_between():
    delta, force = signals().delta_counts[1, 7], signals().force_n[1, 7]
    for step in (0, 2):
        assert_allclose(false_force_n(SPEC, signals(), delta[step]), force[step])
    between = (delta[1] + delta[2]) / 2
    assert_allclose(false_force_n(SPEC, signals(), between), (force[1] + force[2]) / 2)
    assert false_force_n(SPEC, signals(), 0 * delta[0]) == 0


def test_a_false_force_ends_at_the_deepest_press():
    """Five times the counts of a jaw gave the same false force in a box: nothing deeper is known."""
    deepest, force_n = signals().delta_counts[1, 7, -1], signals().force_n[1, 7, -1]
    assert_allclose(false_force_n(SPEC, signals(), 1.5 * deepest), force_n)


def test_jaws_of_steel_pull_and_press_and_those_of_aluminium_and_plastic_do_not():
    effects = jaw_effects(SPEC, on_springs(), signals())
    steel, away, aluminium, plastic = effects
    assert [jaw.material for jaw in effects] == ["steel", "steel", "aluminium", "plastic"]
    pulls = [longest(pull(with_jaw(SPEC, frame, 0.0))) for frame in face_frames(SPEC)]
    assert_allclose(steel.pull_n, max(pulls))
    assert_allclose(steel.moved_mm, SPRING_MM_PER_N * max(pulls))
    assert steel.false_force_n > 1
    assert steel.counts > 4 * away.counts > 4 * 50
    assert aluminium.counts < 0.1
    assert aluminium.false_force_n < 0.01
    assert (plastic.counts, plastic.pull_n, plastic.moved_mm, plastic.false_force_n) == (0, 0, 0, 0)


def test_counts_hold_the_steels_field_and_the_motion_by_its_pull():
    stiff = jaw_effects(SPEC, on_springs(0.0), signals())[0]
    assert_allclose(stiff.counts, surroundings(SPEC, (0.0,)).jaw_counts[:, 0].max())
    # Towards steel magnets leave the sensors: what the motion adds goes with the springs.
    soft, softer = (jaw_effects(SPEC, on_springs(s), signals())[0].counts for s in (0.01, 0.02))
    assert abs(soft - stiff.counts) > 0.5
    assert_allclose(softer - stiff.counts, 2 * (soft - stiff.counts), rtol=0.1)


def test_magnets_that_push_each_other_shift_the_zero():
    shift, twice = resting_shift(SPEC, on_springs()), resting_shift(SPEC, on_springs(0.2))
    assert_allclose(shift.force_n, longest(resting_loads(SPEC)))
    assert_allclose(shift.moved_mm, SPRING_MM_PER_N * shift.force_n)
    assert shift.counts > 0.5
    assert_allclose(twice.counts, 2 * shift.counts, rtol=0.02)


@pytest.mark.parametrize(("depth_mm", "growth"), [(2.484, 0.017), (2.47, 0.032)])
def test_a_pull_grows_by_little_as_magnets_give_way_to_it(depth_mm, growth):
    """The paper's cube: 16 µm on its touching jaw, 30 µm if nothing held the silicone back."""
    pulls = []
    for depth in (2.5, depth_mm):
        spec = ObjectSpec.model_validate({"name": "cube", "magnets": {"depth_mm": depth}})
        pulls.append(longest(pull(with_jaw(spec, face_frames(spec)[0], 0.0))))
    assert_allclose(pulls[1] / pulls[0] - 1, growth, atol=0.003)
