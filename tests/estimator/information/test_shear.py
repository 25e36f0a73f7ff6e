"""Signals of tangential forces: derivatives against whole simulations, and their bounds."""

from dataclasses import fields, replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid, grid_places_in_lattice
from design.layout.places.positions import magnet_layout
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.shear import (
    contact_jacobian,
    save_shear_scores_csv,
    score_shear,
    shear_signals,
)
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import press_signals
from fem.presses.results import MagnetMotions, PressForces, ShearMotions
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(score={"force_n": 6.0, "channels": "own"}, limits={"use": "bench"})


def synthetic_shear(spec):
    """Magnets near the place follow along the face and tilt; smooth, without symmetry."""
    grid, depth = contact_grid(spec), np.asarray(spec.press.depths_mm)
    centres = magnet_layout(spec).centre_mm
    motion = np.zeros((5, len(grid), len(depth), 2, len(centres), 6))
    for index, frame in enumerate(face_frames(spec)):
        local = frame.from_object(centres)
        away = local[:, :2] - grid.xy_mm[:, None]
        reach = 0.02 * np.exp(-np.sum(away**2, -1) / 60) * np.exp((local[:, 2] + 2.5) / 9)
        deeper = (1 + 0.1 * depth)[None, :, None, None]
        for tangent, axis in enumerate((frame.x, frame.y)):
            motion[index, :, :, tangent, :, :3] = deeper * reach[:, None, :, None] * axis
            tilt = 0.1 * np.cross(frame.normal, axis) + 0.03 * frame.normal
            motion[index, :, :, tangent, :, 3:] = deeper * reach[:, None, :, None] * tilt
    return ShearMotions(np.arange(1, 6), grid, depth, motion)


@pytest.fixture(scope="module")
def presses():
    return synthetic_presses(SPEC)


@pytest.fixture(scope="module")
def shear(presses):
    return shear_signals(SPEC, presses[1], synthetic_shear(SPEC))


@pytest.fixture(scope="module")
def signals(presses):
    return press_signals(SPEC, *presses)


def test_slopes_are_those_of_presses_simulated_with_a_small_pull(presses, shear):
    forces, motions = presses
    places, pull = grid_places_in_lattice(SPEC), 0.5 * np.array([0.3, -0.2])
    grid_motion = motions.motion[:, places]
    pulled = np.einsum("fpstmc,t->fpsmc", synthetic_shear(SPEC).motion_per_n, pull)
    cut = (motions.faces, contact_grid(SPEC), motions.depth_mm)
    force = PressForces(*cut, forces.force_n[:, places], forces.contact_area_mm2[:, places])
    ends = [
        press_signals(SPEC, force, MagnetMotions(*cut, grid_motion + side * pulled)).delta_counts
        for side in (1, -1)
    ]
    expected = (ends[0] - ends[1]) / 2
    sheared_counts = np.einsum("fpstjc,t->fpsjc", shear.counts_per_n, pull)
    scale = abs(expected).max()
    assert scale > 1
    assert_allclose(sheared_counts, expected, rtol=0, atol=2e-3 * scale)


def test_jacobian_holds_the_normal_one_and_the_slopes_at_the_score_force(signals, shear):
    face, place = 2, 7
    jacobian = contact_jacobian(SPEC, signals, shear, face)
    x, y = contact_grid(SPEC).xy_mm[place]
    at = (np.array([face]), np.array([x]), np.array([y]), np.array([6.0]))
    assert_allclose(jacobian[place, :, :3], signal_gradient(signals, *at).jacobian[0], rtol=1e-9)
    force = signals.force_n[face - 1, grid_places_in_lattice(SPEC)[place]]
    slopes = shear.counts_per_n[face - 1, place].reshape(len(force), 2, -1)
    deeper = int(np.searchsorted(force, 6.0))
    low, high = np.sort(slopes[deeper - 1 : deeper + 1], axis=0)
    found = jacobian[place, :, 3:].T
    assert_allclose(found, np.clip(found, low, high), rtol=0, atol=1e-9)


def test_slopes_of_presses_without_contact_are_taken_from_the_next_deeper_one(signals, shear):
    gone = shear.counts_per_n.copy()
    gone[:, :, 0] = 0.0
    low = SPEC.model_copy(update={"score": SPEC.score.model_copy(update={"force_n": 0.2})})
    found = contact_jacobian(low, signals, replace(shear, counts_per_n=gone), 1)
    expected = shear.counts_per_n[0, :, 1].reshape(len(found), 2, -1)
    assert_allclose(found[:, :, 3:].swapaxes(1, 2), expected, rtol=1e-9)


def test_scores_are_the_bounds_of_the_own_channels(signals, shear, tmp_path):
    scores = score_shear(SPEC, signals, shear)
    sigma = disturbance_counts(SPEC.sensors, "drifted", 9)
    own = cramer_rao_bounds(contact_jacobian(SPEC, signals, shear, 3)[:, 18:27], sigma)
    assert_allclose(scores.tangential_force_bound_drifted_n[2], own.tangential_force_n)
    assert_allclose(scores.position_bound_drifted_mm[2], own.position_mm)
    assert (scores.position_bound_mm < scores.position_bound_drifted_mm).all()
    every = SPEC.model_copy(update={"score": SPEC.score.model_copy(update={"channels": "all"})})
    more = score_shear(every, signals, shear)
    assert (more.tangential_force_bound_n < scores.tangential_force_bound_n).all()
    save_shear_scores_csv(scores, tmp_path / "s.csv")
    lines = (tmp_path / "s.csv").read_text().splitlines()
    assert len(lines) == 1 + 5 * len(scores.grid)
    assert lines[0].split(",")[4:] == [f.name for f in fields(scores)][2:]
    last = dict(zip(lines[0].split(","), lines[-1].split(","), strict=True))
    assert float(last["condition"]) == scores.condition[-1, -1]
