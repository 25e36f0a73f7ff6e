"""Presses replayed through the simulated object: those of the mechanics, and figures that can fail."""

import numpy as np
import pytest

from estimator.field.models import exact_model
from estimator.signals.field_setup import scene, sensed_field
from studies.recorded.travel_replay import SimulatedPresses, replay
from tests.support.mechanics.inverted import SPEC, presses


@pytest.fixture(scope="module")
def replayed():
    """Places (mm), travels (mm) and the field's changes (mT) of a third of the presses of face 1."""
    forces, motions, _ = presses()
    place, step = np.indices(motions.motion.shape[1:3]).reshape(2, -1)[:, ::3]
    motion = motions.motion[0, place, step]
    around, model = scene(SPEC), exact_model(SPEC.magnets)
    still, pressed = (sensed_field(around, part, model) for part in (0 * motion, motion))
    # s sensor, i chip axis, j coordinate, n press
    change = 1e3 * np.einsum("sij,nsj->nsi", around.sensors.axes, pressed - still)
    simulated = SimulatedPresses(SPEC, forces, motions)
    return simulated, forces.lattice.xy_mm[place], forces.depth_mm[step], change


def test_a_press_of_known_travel_is_felt_as_its_motions_have_it(replayed):
    simulated, xy, travel, change = replayed
    felt = simulated.change_mt(xy, travel)
    assert np.sqrt(np.mean((felt - change) ** 2) / np.mean(change**2)) < 0.01
    assert not simulated.change_mt(xy[:3], np.zeros(3)).any()


def test_a_replay_is_as_near_as_the_finite_elements_and_nearer_than_its_null(replayed):
    simulated, xy, travel, change = replayed
    rng = np.random.default_rng(0)
    recorded = change + 0.3 * change.std() * rng.standard_normal(change.shape)
    found = replay(simulated, xy, travel, change, recorded, 0)
    assert found.simulated.cosine == pytest.approx(found.finite_elements.cosine, abs=0.005)
    assert found.between.cosine > 0.999
    assert found.null_best < 0.8 * found.simulated.cosine
    turned = replay(simulated, -xy, travel, change, recorded, 0)
    assert turned.simulated.cosine < 0.8 * found.simulated.cosine
