"""Walls between sensor recesses: by hand, against the solid core, and where recesses meet."""

import pytest
from numpy.testing import assert_allclose

from design.layout.boards import mounted_sensors, sensor_recesses, smallest_recess_wall_mm
from design.solids.core import make_core
from design.spec.object import CoreSpec, ObjectSpec, SensorSpec
from tests.support.objects.body_cases import body_spec

FAR = [[[8.585, 0.0]]] * 4 + [[[0.0, -8.585]]]


def one_sensor(places, **core):
    return ObjectSpec(name="x", sensors=SensorSpec(positions_mm=places), core=CoreSpec(**core))


def test_two_recesses_on_one_face_by_hand():
    """Radial boxes at 0° and 90°: 4.5 mm from the centre to each, 3.5 half wide."""
    places = [[[8.585, 0.0], [0.0, 8.585]]] * 5
    assert_allclose(smallest_recess_wall_mm(one_sensor(places)), 4.5 - 3.5, rtol=1e-12)
    turned = [[[5.0, 0.0], [-5.0, 0.0]]] * 5
    by_hand = 2 * (5.0 - (8.585 - 4.5))
    assert_allclose(smallest_recess_wall_mm(one_sensor(turned)), by_hand, rtol=1e-12)


def test_recesses_round_an_edge_by_hand():
    """Face 1 at +x and face 3 at −x (its x is −z) look at each other round one edge of the core."""
    places = [[[8.585, 0.0]], [[0.0, 8.585]], [[-8.585, 0.0]], [[0.0, 8.585]], [[8.585, 0.0]]]
    spec = one_sensor(places)
    outer = 13 - 11.0  # from either recess to the edge: both are 3 mm deep
    assert_allclose(smallest_recess_wall_mm(spec), outer - 3.0, rtol=1e-12)
    shallow = one_sensor(places, recess_depth_mm=2.3)
    assert_allclose(smallest_recess_wall_mm(shallow), outer - 2.3, rtol=1e-12)


@pytest.mark.parametrize("places", [FAR, [[[6.5, 3.0], [-5.0, -5.5]]] * 5])
def test_recesses_are_those_cut_from_the_core(places):
    """Where no two meet, they take their own volume out of it, at their own centres."""
    spec = one_sensor(places)
    without = one_sensor(places, recess_depth_mm=2.301)
    assert smallest_recess_wall_mm(spec) > 0
    recesses = sensor_recesses(spec)
    area = 7.0 * 6.5
    hub = make_core(without).Volume() - make_core(spec).Volume()
    assert_allclose(hub, len(recesses) * area * (3.0 - 2.301), rtol=1e-6)


@pytest.mark.parametrize("body", ["capsule", "ellipsoid", "sphere"])
def test_recesses_of_a_curved_core_turn_with_their_boards(body):
    """In the axes of its recess every corner of a board lies within it, below the core's surface."""
    spec = body_spec(body)
    for recess, mounted in zip(sensor_recesses(spec), mounted_sensors(spec), strict=True):
        local = (mounted.board.corners_mm - recess.centre_mm) @ recess.axes
        assert abs(local[:, 2]).max() <= recess.half_mm[2] + 1e-9
        turned = recess.axes.T @ mounted.board.axes
        assert_allclose(abs(turned[2]), [0.0, 0.0, 1.0], rtol=0, atol=1e-9)
