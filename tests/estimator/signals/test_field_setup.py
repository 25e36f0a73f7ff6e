"""Magnets, sensors and surroundings together: each part of the field in its own direction."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.spec.object import ObjectSpec
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.signals.field_setup import KnownField, counts, scene, sensed_field, zero_motion

SPEC = ObjectSpec.model_validate(
    {"name": "cube", "magnets": {"positions_mm": [[2.0, -1.0], [-8.0, 5.0]]}}
)
PLACE = scene(SPEC)
MODEL = FieldModel(magnet_source(SPEC.magnets), "exact")


def field(place, motion):
    return sensed_field(place, motion, MODEL)


def test_a_uniform_field_is_added_in_its_own_direction():
    uniform = np.array([10e-6, -20e-6, 35e-6])
    around = replace(PLACE.environment, uniform_t=uniform)
    rest = zero_motion(PLACE)
    more = field(replace(PLACE, environment=around), rest) - field(PLACE, rest)
    assert_allclose(more, np.broadcast_to(uniform, more.shape), atol=1e-12)


@pytest.mark.parametrize(
    "turn", [(0.02, 0.0, 0.0), (0.0, 0.03, 0.0), (0.0, 0.0, -0.05), (0.01, -0.02, 0.03)]
)
def test_magnets_that_move_are_those_of_another_layout(turn):
    magnets = PLACE.magnets
    motion = np.zeros((1, PLACE.bodies, 6))
    motion[0, 3] = 0.2, -0.1, 0.3, *turn
    moved = Rotation.from_rotvec(turn)
    centre, axis = np.array(magnets.centre_mm), np.array(magnets.axis)
    centre[3] += [0.2, -0.1, 0.3]
    axis[3] = moved.apply(axis[3])
    other = replace(PLACE, magnets=replace(magnets, centre_mm=centre, axis=axis))
    assert_allclose(field(PLACE, motion), field(other, zero_motion(PLACE)), rtol=1e-9, atol=1e-15)


def test_counts_are_along_the_chips_own_axes_with_their_errors():
    place = PLACE.chips
    matrix, offset = np.array(place.matrix), np.array(place.offset_mt)
    matrix[4] = [[1.1, 0.02, 0.0], [0.0, 0.9, 0.0], [-0.03, 0.0, 1.0]]
    offset[4] = 0.1, -0.2, 0.3
    made = replace(PLACE, chips=replace(place, matrix=matrix, offset_mt=offset))
    flux = np.random.default_rng(1).normal(size=(len(matrix), 3)) * 1e-3
    along = np.einsum("sab,sb->sa", np.array(PLACE.sensors.axes), flux)
    wanted = 820 * 1e3 * along
    wanted[4] = 820 * (matrix[4] @ (1e3 * along[4]) + offset[4])
    assert_allclose(counts(made, flux, SPEC), wanted)


def test_bodies_are_magnets_or_boards():
    assert PLACE.bodies == 10
    assert replace(PLACE, sensors_move=True).bodies == 15


def _changed(place, **arrays):
    return replace(place, magnets=replace(place.magnets, **arrays))


def test_scenes_that_differ_in_few_magnets_cost_those_alone(monkeypatch):
    motion = np.random.default_rng(2).normal(size=(7, PLACE.bodies, 6)) * 0.02
    known = KnownField(PLACE, motion, field(PLACE, motion))
    centre, strength = np.array(PLACE.magnets.centre_mm), np.array(PLACE.magnets.strength)
    centre[3, 0] += 0.2
    strength[6] = 1.1
    moved = motion.copy()
    moved[:, 1, 2] += 0.1
    turned = np.roll(PLACE.sensors.axes, 1, axis=1)
    cases = {
        2: (_changed(PLACE, centre_mm=centre, strength=strength), motion),
        1: (PLACE, moved),
        0: (replace(PLACE, sensors=replace(PLACE.sensors, axes=turned)), motion),
    }
    exact = {count: field(*case) for count, case in cases.items()}
    asked = []

    def counted(place, motion, model):
        asked.append(motion.shape[1])
        return sensed_field(place, motion, model)

    monkeypatch.setattr("estimator.signals.field_setup.sensed_field", counted)
    for count, case in cases.items():
        asked.clear()
        found = known.field_of(*case, MODEL)
        assert asked == [count] * 2 * (count > 0)
        assert_allclose(found, exact[count], rtol=0, atol=1e-15 * abs(exact[count]).max() * 50)
        assert (abs(exact[count] - known.field_t).max() > 0) == (count > 0)
        asked.clear()
        np.testing.assert_array_equal(known.field_of(*case, MODEL), found)
        assert asked == [count] * (count > 0), "what they were is kept"


def test_what_changes_for_all_magnets_is_computed_anew():
    motion = np.zeros((2, PLACE.bodies, 6))
    known = KnownField(PLACE, motion, field(PLACE, motion))
    uniform = replace(PLACE.environment, uniform_t=np.array([1e-5, 0, 0]))
    position = PLACE.sensors.position_mm + 0.1
    others = [
        (replace(PLACE, environment=uniform), motion),
        (replace(PLACE, sensors=replace(PLACE.sensors, position_mm=position)), motion),
        (_changed(PLACE, strength=1.1 * PLACE.magnets.strength), motion),
        (PLACE, np.zeros((3, PLACE.bodies, 6))),
    ]
    for place, moved in others:
        np.testing.assert_array_equal(known.field_of(place, moved, MODEL), field(place, moved))
