"""Sensors in the shell, chips off nominal, and the chain's symmetries."""

from dataclasses import replace

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.layout.places.positions import magnet_layout, sensor_layout, shell_body_layout
from design.spec.object import ObjectSpec
from estimator.field.environment import Environment, Plate
from estimator.field.models import FieldModel, field_model
from estimator.field.sources import magnet_source
from estimator.signals.field_setup import counts, scene, sensed_field, zero_motion
from estimator.signals.hall import chip_errors
from estimator.signals.presses import press_signals, rest_counts
from instobj.field import polarization
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

IN_CORE = {"positions_mm": [[8, 8], [-8, 8], [-8, -8], [8, -8]]}
AROUND = {"earth_ut": [30, 0, -40]}
REVERSE = coarse_spec(arrangement="sensors-in-shell", magnets=IN_CORE, environment=AROUND)
POLARIZATION_T = 1.43 / (1 + 0.05 * 0.7145899)  # Ø6 × 1 mm: 1 less Nagaoka's coefficient


@pytest.fixture(scope="module")
def reverse_presses():
    return synthetic_presses(REVERSE)


@pytest.fixture(scope="module")
def reverse_signals(reverse_presses):
    return press_signals(REVERSE, *reverse_presses)


def oracle_counts(motion):
    """Counts (sensor, axis) by magpylib's own moved and turned sensors."""
    magnets, sensors = magnet_layout(REVERSE), sensor_layout(REVERSE)
    bodies = []
    for centre, axis in zip(magnets.centre_mm, magnets.axis, strict=True):
        body = magpylib.magnet.Cylinder(polarization=(0, 0, POLARIZATION_T), dimension=(6e-3, 1e-3))
        body.rotate(Rotation.align_vectors([axis], [[0, 0, 1]])[0])
        body.position = centre / 1e3
        bodies.append(body)
    readings = []
    for place, axes, (*shift, rx, ry, rz) in zip(
        sensors.position_mm, sensors.axes, motion, strict=True
    ):
        chip = Rotation.from_rotvec([rx, ry, rz]) * Rotation.from_matrix(axes.T)
        sensor = magpylib.Sensor(position=(place + shift) / 1e3, orientation=chip)
        earth = chip.inv().apply(50e-6 * np.array([0.6, 0, -0.8]))
        readings.append(820e3 * (magpylib.getB(bodies, sensor, sumup=True) + earth))
    return np.array(readings)


def test_moved_sensors_read_what_magpylibs_moved_sensors_read(reverse_presses, reverse_signals):
    rest = oracle_counts(np.zeros((15, 6)))
    assert_allclose(reverse_signals.baseline_counts, rest, rtol=0, atol=1e-3 * abs(rest).max())
    for face, place, step in ((0, 11, 5), (2, 63, 4), (4, 40, 5)):
        delta = oracle_counts(reverse_presses[1].motion[face, place, step]) - rest
        found = reverse_signals.delta_counts[face, place, step]
        assert_allclose(found, delta, rtol=0, atol=3e-3 * abs(delta).max())


def test_only_relative_motion_counts():
    """Sensors moved rigidly one way see what they see when the magnets move the other way."""
    place = replace(scene(coarse_spec()), sensors_move=True)
    magnets, turn = place.magnets, Rotation.from_rotvec([0.03, -0.05, 0.02])
    shift, sensor = np.array([0.4, -0.3, 0.5]), 7
    model = field_model(magnet_source(coarse_spec().magnets), 6.0)
    motion = np.zeros((1, 15, 6))
    motion[0, sensor] = [*shift, *turn.as_rotvec()]
    moved_sensor = sensed_field(place, motion, model)[0, sensor]
    pivot = place.sensors.position_mm[sensor]
    back = replace(
        magnets,
        centre_mm=turn.inv().apply(magnets.centre_mm - pivot - shift) + pivot,
        axis=turn.inv().apply(np.array(magnets.axis)),
    )
    moved_magnets = replace(place, magnets=back)
    assert_allclose(
        moved_sensor, sensed_field(moved_magnets, zero_motion(place), model)[0, sensor], rtol=1e-10
    )


def test_bodies_in_the_shell_are_the_boards_and_magnets_rest_in_the_core():
    boards, magnets = shell_body_layout(REVERSE), magnet_layout(REVERSE)
    assert (len(boards.face), len(magnets.face)) == (15, 20)
    assert_allclose(boards.volume_mm3, 6.6 * 6.2 * 1.6)
    assert_allclose(boards.centre_mm, sensor_layout(REVERSE).position_mm, atol=1e-12)
    assert_allclose(abs(boards.centre_mm).max(axis=1), 21 - 3 + 0.8)
    assert_allclose(abs(magnets.centre_mm).max(axis=1), 13 - 0.5)
    axes = sensor_layout(REVERSE).axes
    assert_allclose(axes, sensor_layout(coarse_spec()).axes, atol=1e-12)


def test_what_moves_on_one_face_alone_leaves_the_others_alone_only_in_the_reverse():
    """The paper's argument: magnets that rest keep the field of the other faces."""
    for spec, quiet in ((REVERSE, True), (coarse_spec(), False)):
        forces, motions = synthetic_presses(spec)
        own = (shell_body_layout(spec).face == 3)[:, None]
        signals = press_signals(spec, forces, replace(motions, motion=motions.motion * own))
        others = sensor_layout(spec).face != 3
        assert bool(abs(signals.delta_counts[2][:, :, others]).max() < 1e-6) is quiet
        assert abs(signals.delta_counts[2][:, :, ~others]).max() > 500


def turned_scene(place, turn, mirror=1.0):
    """The whole scene turned about the origin, or mirrored (x → −x) and then turned.

    B and axes of magnets are axial vectors: a mirror keeps their components along its normal.
    """
    flip = np.array([mirror, 1.0, 1.0])
    polar = lambda v: turn.apply(v * flip)  # noqa: E731
    axial = lambda v: turn.apply(v * flip * mirror)  # noqa: E731
    plates = tuple(
        Plate(polar(p.position_mm), polar(p.normal), p.strength) for p in place.environment.plates
    )
    magnets = replace(
        place.magnets,
        centre_mm=polar(place.magnets.centre_mm),
        axis=axial(place.magnets.axis),
        side=axial(place.magnets.side),
    )
    axes = np.stack([axial(place.sensors.axes[:, k]) for k in range(3)], axis=1)
    sensors = replace(place.sensors, position_mm=polar(place.sensors.position_mm), axes=axes)
    uniform = axial(place.environment.uniform_t)
    around = Environment(uniform, (), plates)
    turned = replace(place, magnets=magnets, sensors=sensors, environment=around)
    return turned, lambda motion: np.concatenate(
        [polar(motion[..., :3].reshape(-1, 3)), axial(motion[..., 3:].reshape(-1, 3))], axis=1
    ).reshape(motion.shape)


@pytest.mark.parametrize("mirror", [1.0, -1.0], ids=["turned", "mirrored and turned"])
@pytest.mark.parametrize("shape", ["disk", "block"])
@pytest.mark.parametrize("arrangement", ["sensors-in-core", "sensors-in-shell"])
def test_counts_follow_an_object_that_is_turned_or_mirrored(mirror, shape, arrangement):
    """Everything turned alike, plates and Earth's field too, reads the same counts."""
    around = {**AROUND, "steel_plates": [{"position_mm": [0, 28, 0], "normal": [0.2, -1, 0.1]}]}
    spec = coarse_spec(
        arrangement=arrangement,
        magnets={**IN_CORE, "shape": shape, "size_mm": [6.0, 3.5]},
        environment=around,
    )
    place = scene(spec)
    motion = synthetic_presses(spec)[1].motion[2, ::9, -1]
    model = field_model(magnet_source(spec.magnets), 6.0)
    turned, follow = turned_scene(place, Rotation.from_rotvec([0.7, -1.2, 2.0]), mirror)
    still = counts(place, sensed_field(place, motion, model), spec)
    found = counts(turned, sensed_field(turned, follow(motion), model), spec)
    assert_allclose(found, still, atol=1e-7 * abs(still).max())
    untouched = counts(turned, sensed_field(turned, motion, model), spec)
    assert abs(untouched - still).max() > 1e-3 * abs(still).max()


def test_chips_within_their_tolerances_have_the_stated_spread():
    sensors = ObjectSpec.model_validate(
        {
            "name": "c",
            "sensors": {
                "chip_spread": [0.03, 0.01],
            },
        }
    ).sensors
    chips = chip_errors(sensors, 4000, seed=3)
    diagonal = np.eye(3, dtype=bool)
    assert_allclose((chips.matrix - np.eye(3))[:, diagonal].std(), 0.03, rtol=0.03)
    assert_allclose(chips.matrix[:, ~diagonal].std(), 0.01, rtol=0.03)
    nominal = chip_errors(ObjectSpec(name="c").sensors, 15, seed=3)
    assert_allclose(nominal.matrix, np.tile(np.eye(3), (15, 1, 1)), rtol=0)
    assert_allclose(nominal.offset_mt, 0, rtol=0)


def test_real_chips_change_counts_as_their_matrix_says():
    off = {"chip_spread": [0.05, 0.02]}
    real, ideal = coarse_spec(sensors=off), coarse_spec()
    chips = chip_errors(real.sensors, 15, real.seed)
    nominal = rest_counts(ideal)
    expected = np.einsum("sab,sb->sa", chips.matrix, nominal)
    assert_allclose(rest_counts(real), expected, atol=1e-8)
    presses = synthetic_presses(ideal)
    delta = press_signals(ideal, *presses).delta_counts[3, 10, 4]
    found = press_signals(real, *presses).delta_counts[3, 10, 4]
    assert_allclose(found, np.einsum("sab,sb->sa", chips.matrix, delta), atol=1e-8)


@pytest.mark.parametrize("gap_mm", [1.0, 5.0])
def test_block_magnets_that_turn_take_their_sides_along(gap_mm):
    """One oblong block turned about its own axis by 90°, in a press."""
    spec = coarse_spec(magnets={"shape": "block", "size_mm": [6.0, 3.0], "positions_mm": [[0, 0]]})
    place = scene(spec)
    turned = replace(
        place, magnets=replace(place.magnets, side=np.cross(place.magnets.axis, place.magnets.side))
    )
    motion = np.zeros((1, 5, 6))
    motion[0, :, 3:] = np.pi / 2 * place.magnets.axis
    model = FieldModel(magnet_source(spec.magnets), "exact" if gap_mm < 2 else "charges", charges=6)
    assert_allclose(
        sensed_field(place, motion, model),
        sensed_field(turned, zero_motion(place), model),
        atol=1e-15,
    )
    assert (
        abs(
            sensed_field(place, motion, model) - sensed_field(place, zero_motion(place), model)
        ).max()
        > 1e-5
    )


def test_a_moving_sensor_feels_a_stray_magnet_where_it_is():
    stray = {"position_mm": [60, -10, 20], "size_mm": [12, 6], "remanence_t": [0, 0, 1.3]}
    spec = REVERSE.changed(environment=REVERSE.environment.changed(magnets=[stray]))
    place, bare = scene(spec), scene(REVERSE)
    model = FieldModel(magnet_source(spec.magnets), "exact")
    motion = np.zeros((4, place.bodies, 6))
    motion[1:, :, 2] = [[0.3], [-0.5], [1.0]]
    added = sensed_field(place, motion, model) - sensed_field(bare, motion, model)
    magnet = magpylib.magnet.Cylinder(
        polarization=(0, 0, float(polarization(1.3, (12.0, 6.0)))),
        dimension=(12e-3, 6e-3),
        position=(60e-3, -10e-3, 20e-3),
    )
    points = place.sensors.position_mm + motion[:, :, :3]
    assert_allclose(added, magnet.getB(points / 1e3), rtol=1e-6, atol=1e-12)


def test_few_presses_read_as_many():
    spec = coarse_spec(environment={"magnets": [{"position_mm": [60, 0, 0]}], **AROUND})
    place, model = scene(spec), FieldModel(magnet_source(spec.magnets), "multipole", 9)
    scale = [0.3, 0.3, 0.3, 0.05, 0.05, 0.05]
    motion = np.random.default_rng(3).normal(size=(200, place.bodies, 6)) * scale
    many = sensed_field(place, motion, model)
    few = np.concatenate([sensed_field(place, part, model) for part in np.split(motion, 20)])
    assert_allclose(few, many, rtol=1e-12)
