"""Tolerances by hand: seats, turns, temperature, first-order differences and ranges of bounds."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from estimator.tolerances import assembly, budget, selftest, virtual_object
from estimator.tolerances.budget import Spread

SPEC = ObjectSpec(name="cube")
SIZES = SPEC.tolerances.changed(magnet_seat_mm=0.2, sensor_seat_mm=0.3, sensor_rotation_deg=2.0)


def test_bodies_sit_aside_by_their_own_seats():
    numbers = {"magnet_seat": np.arange(6.0), "sensor_seat": np.arange(6.0)}
    assert_allclose(
        assembly.shift_aside_mm(SIZES, False, numbers), 0.2 * np.arange(6.0).reshape(3, 2)
    )
    assert_allclose(assembly.shift_aside_mm(SIZES, True, numbers), 0.3 * np.array([[0, 1], [3, 4]]))


def test_sensors_are_shifted_and_turned_along_the_axes_of_their_face():
    sensors = sensor_layout(SPEC)
    rng = np.random.default_rng(0)
    seat, turn = rng.normal(size=(2, 15, 3))
    numbers = {"sensor_seat": seat.ravel(), "sensor_rotation": turn.ravel()}
    found = assembly.moved_sensors(SPEC, sensors, SIZES, numbers)
    frames = {frame.number: frame.axes for frame in face_frames(SPEC)}
    for k, face in enumerate(sensors.face.tolist()):
        assert_allclose(found.position_mm[k] - sensors.position_mm[k], 0.3 * frames[face] @ seat[k])
        about = Rotation.from_rotvec(np.radians(2.0) * frames[face] @ turn[k])
        assert_allclose(found.axes[k], about.apply(np.array(sensors.axes[k])), atol=1e-12)


def outcome(baseline, delta, position, force):
    return SimpleNamespace(
        baseline=np.array(baseline), delta=(np.array(delta),),
        position_mm=np.array(position), force_n=np.array(force),
    )  # fmt: skip


def test_a_deviation_is_a_difference_of_bounds_in_their_logarithms():
    one = outcome([[3.0, 0.0, 0.0]], [[1.0, 2.0]], [2.0, np.inf], [8.0, 1.0])
    other = outcome([[1.0, 0.0, 0.5]], [[0.0, 5.0]], [1.0, 3.0], [2.0, np.inf])
    found = budget.deviation_of.__wrapped__(one, other, 10.0)
    assert found.baseline.tolist() == [[20.0, 0.0, -5.0]]
    assert found.delta[0].tolist() == [[10.0, -30.0]]
    names = list(found.__dataclass_fields__)
    assert_allclose(getattr(found, names[2]), [10 * np.log(2), 0])
    assert_allclose(getattr(found, names[3]), [10 * np.log(4), 0])


def test_spreads_add_up_as_roots_of_sums_of_squares():
    names = list(Spread.__dataclass_fields__)[1:]
    rows = [
        Spread(name, *(np.arange(len(names)) + start)) for name, start in (("a", 3.0), ("b", 4.0))
    ]
    found = budget.summed_spread(rows)
    wanted = np.hypot(np.arange(len(names)) + 3.0, np.arange(len(names)) + 4.0)
    assert_allclose([getattr(found, name) for name in names], wanted)


def test_bounds_range_from_the_fifth_to_the_95th_percentile_of_objects():
    objects = [
        SimpleNamespace(
            position_mm=np.array([k, 3.0 * k, 2.0 * k]), force_n=np.array([1.0, k, 9.0])
        )
        for k in range(1, 22)
    ]
    nominal = SimpleNamespace(
        position_mm=np.array([1.0, 5.0, 2.0]), force_n=np.array([4.0, 3.0, 8.0])
    )
    found = budget.bound_ranges.__wrapped__(nominal, objects)
    figures = [tuple(vars(one).values()) for one in found]
    assert figures[0] == (2.0, 4.0, 40.0)
    assert figures[1] == (5.0, 6.0, 60.0)
    assert figures[2] == (4.0, 2.0, 9.0)
    assert figures[3] == (8.0, 9.0, 20.0)


def test_slopes_along_an_axis_are_those_of_cubics():
    nodes = np.array([0.0, 1.0, 2.5, 4.0, 5.0])
    values = np.stack([nodes**3, 2 * nodes], axis=1)[None, :, :, None] * [1.0, -1.0]
    found = virtual_object.slope_along(values, nodes, 1)
    assert found.shape == values.shape
    assert_allclose(found[0, :, 0, 0], 3 * nodes**2, atol=1e-9)
    assert_allclose(found[0, :, 1, 1], -2.0)


@pytest.mark.parametrize("arrangement", ["sensors-in-core", "sensors-in-shell"])
def test_a_selftest_looks_at_the_object_whose_core_has_slipped(arrangement):
    """What sits in the core has shifted; what sits in the shell has not."""
    slip = SPEC.mechanics.slip.changed(shift_mm=(0.5, -0.25, 0.1))
    spec = SPEC.changed(arrangement=arrangement)
    slipped = spec.changed(mechanics=spec.mechanics.changed(slip=slip))
    straight, moved = (selftest.design_at_rest(one)[0].scene for one in (spec, slipped))
    magnets = moved.magnets.centre_mm - straight.magnets.centre_mm
    sensors = moved.sensors.position_mm - straight.sensors.position_mm
    core, shell = (sensors, magnets) if arrangement == "sensors-in-core" else (magnets, sensors)
    assert_allclose(core, np.broadcast_to((0.5, -0.25, 0.1), core.shape), atol=1e-12)
    assert_allclose(shell, 0, atol=1e-12)


def nearest_mm(motion):
    """Of every magnet's centre, moved, to every chip."""
    centre = magnet_layout(SPEC).centre_mm + motion[..., :3]
    return np.linalg.norm(centre[..., None, :] - sensor_layout(SPEC).position_mm, axis=-1).min()


def test_fields_are_good_for_magnets_a_millimetre_nearer_than_they_come(monkeypatch):
    design = assembly.designed(SPEC)
    motion = np.random.default_rng(4).uniform(-0.8, 0.8, (3, design.scene.bodies, 6))
    for module in (selftest, virtual_object):
        monkeypatch.setattr(module, "magnets_model", lambda magnets, nearest: nearest)
    at_rest_mm = selftest.design_at_rest.__wrapped__(SPEC)[1]
    assert_allclose(at_rest_mm, nearest_mm(np.zeros(6)) - 1.0, atol=1e-3)
    moved_mm = virtual_object.twin_model.__wrapped__(SPEC, design, motion)
    assert_allclose(moved_mm, nearest_mm(motion) - 1.0, atol=1e-3)
