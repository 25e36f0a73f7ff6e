"""Order, orientation and handedness of chips, against fields by magpylib."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.layout.places.positions import sensor_layout
from estimator.bringup.asking.held_magnet import held_magnet
from estimator.bringup.diagnosis.channels import find_chips, held_readings, signed_permutations
from estimator.bringup.diagnosis.chip_fit import _orthogonal, chips_found
from estimator.field.sources import magnet_source
from tests.support.new_objects import SMALL

CHIPS = 10


def test_there_are_24_rotations_and_24_mirrored_permutations():
    every = signed_permutations()
    assert_array_equal(every[0], np.eye(3))
    assert_array_equal(np.einsum("tab,tcb->tac", every, every), np.tile(np.eye(3), (48, 1, 1)))
    assert len({tuple(one.ravel()) for one in every}) == 48
    assert np.sum(np.linalg.det(every) > 0) == 24
    assert np.linalg.det(every[:24]).min() > 0


def by_magpylib(rng, over=()):
    """Field counts (hold, site, axis) of a magnet held roughly over every site; `over` wrongly."""
    held, layout = held_magnet(SMALL, list(range(CHIPS))), sensor_layout(SMALL)
    disk, rows = magnet_source(SMALL.magnets), []
    for hold in range(CHIPS):
        pose = np.zeros((1, 8))
        pose[0, :5] = rng.normal(0, [3, 3, 2, 0.25, 0.25])
        one = held_magnet(SMALL, [hold])
        axis = one.axis(pose)[0] * (-1 if hold in over else 1)
        magnet = magpylib.magnet.Cylinder(
            polarization=(0, 0, disk.polarization_t), dimension=(disk.diameter_mm, disk.height_mm)
        )
        turn = np.cross([0, 0, 1], axis)
        angle = np.arctan2(np.linalg.norm(turn), axis[2])
        if angle > 1e-9:
            magnet.rotate_from_angax(angle, turn, degrees=False)
        magnet.position = one.centre_mm(pose)[0]
        rows.append(magnet.getB(layout.position_mm))
    return 1e3 * held.counts_per_mt * np.einsum("sac,hsc->hsa", layout.axes, np.stack(rows))


@pytest.fixture(scope="module")
def shuffled():
    """All chips exchanged and turned any of 48 ways, one hold the wrong way round, noise."""
    rng = np.random.default_rng(4)
    site, kind = rng.permutation(CHIPS), rng.integers(48, size=CHIPS)
    fields = by_magpylib(rng, over=(3,))[:, site]
    counts = np.einsum("cab,hcb->hca", signed_permutations()[kind], fields)
    counts = counts + 4 * rng.standard_normal(counts.shape)
    readings = held_readings(SMALL, counts, 2 / 42, 3.0)
    found = find_chips(SMALL, readings, range(CHIPS))
    return site, signed_permutations()[kind], readings, found


def test_chips_in_any_order_and_any_way_round_are_found(shuffled):
    site, turn, _, found = shuffled
    assert_array_equal(found.site, site)
    assert_array_equal(found.turn, turn)
    assert_array_equal(np.flatnonzero(found.model.polarity < 0), [3])


def test_turns_by_any_angle_and_gains_are_measured(shuffled):
    site, turn, readings, found = shuffled
    angle = np.deg2rad(120)
    about_z = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    changed = readings.counts.copy()
    changed[:, 6] = changed[:, 6] @ about_z.T
    changed[:, 2, 1] *= 1.2
    chips = chips_found(held_readings(SMALL, changed, 2 / 42, 3.0), found)
    assert_allclose(chips[6].turn, about_z @ turn[6], atol=0.06)
    gains = np.stack([chip.gain for chip in chips])
    assert gains[2, 1] == pytest.approx(1.2, abs=0.05)
    gains[2, 1] = 1.0
    assert_allclose(gains, 1.0, atol=0.05)
    assert [chip.site for chip in chips] == site.tolist()
    assert [chip.mirrored for chip in chips] == (np.linalg.det(turn) < 0).tolist()


def test_an_axis_that_does_not_answer_is_dead_and_the_turn_still_known(shuffled):
    _, turn, readings, found = shuffled
    silent = readings.counts.copy()
    silent[:, 5, 2] = 4 * np.random.default_rng(0).standard_normal(CHIPS)
    chips = chips_found(held_readings(SMALL, silent, 2 / 42, 3.0), found)
    assert chips[5].dead == (False, False, True)
    assert np.isnan(chips[5].gain[2])
    assert_allclose(chips[5].turn, turn[5], atol=0.06)
    assert sum(any(chip.dead) for chip in chips) == 1


def test_a_dead_axis_tells_no_handedness():
    mirrored = np.diag([-1.0, 1.0, 1.0])
    turn = _orthogonal(np.diag([0.05, 1.0, 0.9]), np.array([True, False, False]), mirrored)
    assert_allclose(turn, np.eye(3), atol=1e-9)
