"""How many virtual objects leave the range of a chip: against magpylib in every press of the table."""

from dataclasses import replace

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.spec.object import ObjectSpec
from estimator.field.sources import magnet_sources
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import designed, draw
from estimator.tolerances.saturation import KEPT_BY, saturation
from estimator.tolerances.virtual_object import twin_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

NO_TOLERANCES = dict.fromkeys(ObjectSpec(name="x").tolerances.model_dump(), 0.0)
RANGE_MT = 6.3
NEAR = {"depth_below_core_face_mm": 0.3, "chip": "outward", "range_mt": RANGE_MT}
"""Chips 5.8 mm under the magnets, in a narrow range: of some objects one is beyond it at rest."""
SEATS_ALONE = NO_TOLERANCES | {"core_shift_mm": 0.3, "magnet_seat_mm": 0.1}
OBJECTS = 12


def spec_with(tolerances):
    return coarse_spec(
        contact_grid={"count": (4, 4), "pitch_mm": 6.0},
        press={"depths_mm": (1.0, 2.0, 3.0)},
        sensors=NEAR,
        tolerances=tolerances,
    )


def found_of(spec, objects=OBJECTS, **also):
    forces, motions = synthetic_presses(spec)
    return saturation(spec, press_signals(spec, forces, motions), motions, objects, **also)


def counts_by_magpylib(spec, scene, motion, face=None):
    """Counts (press, sensor, axis) with cylinders moved and turned, of one face's sensors or of all."""
    read = np.flatnonzero((scene.sensors.face == face) | (face is None))
    turn = Rotation.from_rotvec(motion[..., 3:].reshape(-1, 3))
    axis = turn.apply(np.tile(scene.magnets.axis, (len(motion), 1)))
    x = np.cross(axis, [0.3, 0.5, 0.8])
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    frames = Rotation.from_matrix(np.stack([x, np.cross(axis, x), axis], axis=2))
    centre = (scene.magnets.centre_mm + motion[..., :3]).reshape(-1, 3)
    magnet_t = magnet_sources(spec.magnets)[0].polarization_t
    strength = magnet_t * np.tile(scene.magnets.strength, len(motion))
    cylinder = magpylib.magnet.Cylinder(
        polarization=(0, 0, 1),
        dimension=(1e-3 * spec.magnets.diameter_mm, 1e-3 * spec.magnets.height_mm),
    )
    found = []
    for sensor in read:
        local_mm = frames.inv().apply(scene.sensors.position_mm[sensor] - centre)
        field_t = strength[:, None] * frames.apply(cylinder.getB(1e-3 * local_mm))
        field_t = field_t.reshape(len(motion), -1, 3).sum(axis=1) + scene.environment.uniform_t
        chip_mt = 1e3 * field_t @ scene.sensors.axes[sensor].T @ scene.chips.matrix[sensor].T
        found.append(chip_mt + scene.chips.offset_mt[sensor])
    return spec.sensors.counts_per_mt * np.stack(found, axis=1)


@pytest.fixture(scope="module")
def by_magpylib():
    """Largest counts (object, depth) over every press of the table; objects drawn as the stage does."""
    spec = spec_with(SEATS_ALONE)
    _, motions = synthetic_presses(spec)
    rng, design = np.random.default_rng((spec.seed, 9)), designed(spec)
    largest = np.zeros((OBJECTS, 4))
    for row in largest:
        scene = draw(spec, design, rng).scene
        row[0] = abs(counts_by_magpylib(spec, scene, np.zeros((1, 25, 6)))).max()
        for face, table in zip(motions.faces.tolist(), motions.motion, strict=True):
            # a press moves the magnets of its own face most: other faces' chips read it less
            own = abs(counts_by_magpylib(spec, scene, table[::2].reshape(-1, 25, 6), face))
            own = own.reshape(-1, 3, own[0].size).max(axis=(0, 2))
            row[1:] = np.maximum(row[1:], own)
    return spec, np.maximum.accumulate(largest, axis=1) / (RANGE_MT * spec.sensors.counts_per_mt)


def test_shares_are_those_of_every_press_by_magpylib(by_magpylib):
    spec, used = by_magpylib
    found = found_of(spec)
    assert found.depth_mm == (0.0, 1.0, 2.0, 3.0)
    # every second place: a margin lies at most 2 % of the range above that of all of them
    assert_allclose(
        1 - np.quantile(used, KEPT_BY, axis=0, method="higher"), found.margin, atol=0.02
    )
    assert_allclose(found.out_share[0], np.mean(used[:, 0] > 1))
    assert 0 < found.out_share[0] < 1
    assert np.all(found.out_share >= np.mean(used > 1, axis=0) - 1e-9)
    assert found.out_share[-1] <= np.mean(used[:, -1] > 0.98)


def test_the_deepest_press_alone_says_the_same_of_it():
    spec = spec_with(SEATS_ALONE)
    found, deepest = found_of(spec), found_of(spec, deepest_alone=True)
    assert deepest.depth_mm == (0.0, 3.0)
    assert deepest.margin == (found.margin[0], found.margin[-1])
    assert deepest.out_share == (found.out_share[0], found.out_share[-1])


def test_objects_without_tolerances_are_the_design():
    spec = spec_with(NO_TOLERANCES)
    forces, motions = synthetic_presses(spec)
    signals = press_signals(spec, forces, motions)
    found = saturation(spec, signals, motions, 2)
    pressed = abs(signals.baseline_counts + signals.delta_counts)
    largest = [abs(signals.baseline_counts).max(), *pressed.max(axis=(0, 1, 3, 4))]
    used = np.maximum.accumulate(largest) / (RANGE_MT * spec.sensors.counts_per_mt)
    assert_allclose(1 - np.array(found.margin), used, rtol=2e-3)
    assert found.out_share == tuple(np.float64(used > 1).tolist())


def test_a_magnet_aside_moves_as_in_the_virtual_object():
    """Its own motion is that of a press as far aside the other way (`virtual_object`)."""
    spec = spec_with(NO_TOLERANCES | {"magnet_seat_mm": 0.6})
    forces, motions = synthetic_presses(spec)
    rng, used = np.random.default_rng((spec.seed, 9)), []
    for _ in range(3):
        twin = twin_signals(spec, draw(spec, designed(spec), rng), forces, motions)
        used.append(abs(twin.baseline_counts + twin.delta_counts).max())
    found = found_of(spec, 3)
    wanted = 1 - max(used) / (RANGE_MT * spec.sensors.counts_per_mt)
    # with the design's motions it would be 0.003 off
    assert_allclose(found.margin[-1], wanted, atol=0.001)


def test_what_leaves_the_range_in_a_press_is_out_in_deeper_ones_too():
    """A table whose first press moves most: what comes after has been pressed as deep."""
    spec = spec_with(SEATS_ALONE)
    forces, motions = synthetic_presses(spec)
    eased = replace(motions, motion=motions.motion[:, :, ::-1].copy())
    found = saturation(spec, press_signals(spec, forces, eased), eased, OBJECTS)
    assert found.margin[0] > found.margin[1]
    assert found.margin[1:] == (found.margin[1],) * 3
    assert found.out_share[1:] == (found.out_share[1],) * 3
