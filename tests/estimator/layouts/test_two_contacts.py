"""Bounds of two contacts in batches: against exact fields and the inverse of their information."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.information.fisher import disturbance_counts
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.two_contacts import grasps_mm, pairs_all_mm, pairs_own_mm
from estimator.signals.field_setup import sensed_field
from estimator.signals.hall import counts_of_field
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import Signals
from tests.support.mechanics.candidate_cases import FACE, layout_scene, random_layouts

OPPOSITE = 5
COUNT = 3
TOLERANCE = 0.05
"""Of a layout's median and 95th percentile; measured 3 %, from the short series and basis."""


@pytest.fixture(scope="module")
def other(spec, motions):
    return layout_scorer(spec, press_basis(spec, motions, OPPOSITE))


@pytest.fixture(scope="module")
def exact(spec, motions):
    """Whitened derivatives (layout; face → place, face read, channel, 3) with exact fields of all
    magnets, the opposite face's too."""
    layouts = random_layouts(COUNT, seed=4)
    return [
        {face: exact_jacobian(spec, motions, face, layouts, row) for face in (FACE, OPPOSITE)}
        for row in range(COUNT)
    ]


def exact_jacobian(spec, motions, pressed, layouts, row):
    parts = [
        np.asarray(getattr(layouts, name)[row], float)
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    ]
    motion = layout_scene(spec, motions, pressed, *parts)[1]
    model, delta = FieldModel(magnet_source(spec.magnets), "exact"), []
    for frame in face_frames(spec):
        scene = layout_scene(spec, motions, frame.number, *parts)[0]
        states = np.concatenate([motion.reshape(-1, *motion.shape[-2:]), 0 * motion[0, :1]])
        field = 1e3 * sensed_field(scene, states, model)
        counts = counts_of_field(field, scene.sensors.axes, spec.sensors)
        delta.append((counts[:-1] - counts[-1]).reshape(*motion.shape[:2], -1, 3))
    delta = np.concatenate(delta, axis=2)
    every = np.zeros((len(motions.faces), *delta.shape))
    every[motions.faces.tolist().index(pressed)] = delta
    depth = np.array([1.0, 2.0])
    signals = Signals(
        motions.faces, motions.places, depth, motions.force_n, every, np.zeros(delta.shape[2:])
    )
    xy = contact_grid(spec).xy_mm
    force = np.full(len(xy), spec.score.force_n)
    found = signal_gradient(signals, np.full(len(xy), pressed), xy[:, 0], xy[:, 1], force)
    white = (
        found.jacobian / disturbance_counts(spec.sensors, "fresh", found.counts.shape[1])[:, None]
    )
    return white.reshape(len(xy), len(face_frames(spec)), -1, 3)


def worse_mm(pairs):
    """Position bound of the worse of two contacts, by the inverse of their 6 × 6 information."""
    found = []
    for a, b in pairs:
        joint = np.concatenate([a, b], axis=1)
        variance = np.diagonal(np.linalg.inv(joint.T @ joint))
        found.append(np.sqrt(max(variance[:2].sum(), variance[3:5].sum())))
    return np.array(found)


def pairs_of(spec, one):
    xy = contact_grid(spec).xy_mm
    apart = 2 * spec.indenter.radius_mm
    every = combinations(range(len(xy)), 2)
    return [(one[a], one[b]) for a, b in every if np.linalg.norm(xy[a] - xy[b]) >= apart]


def row_of(spec, face):
    return [frame.number for frame in face_frames(spec)].index(face)


def wanted_own(spec, one):
    return worse_mm(pairs_of(spec, one[FACE][:, row_of(spec, FACE)]))


def wanted_all(spec, one):
    return worse_mm(pairs_of(spec, one[FACE].reshape(len(one[FACE]), -1, 3)))


def wanted_grasps(spec, one):
    a, b = (one[face].reshape(len(one[face]), -1, 3) for face in (FACE, OPPOSITE))
    return worse_mm([(first, second) for first in a for second in b])


def found_own(scorer, other, layouts):
    return pairs_own_mm(scorer, layouts)


def found_all(scorer, other, layouts):
    return pairs_all_mm(scorer, layouts)


def found_grasps(scorer, other, layouts):
    return grasps_mm((scorer, other), (layouts, layouts))


CASES = {
    "two on a face, own channels": (found_own, wanted_own),
    "two on a face, all channels": (found_all, wanted_all),
    "one on each of two faces": (found_grasps, wanted_grasps),
}


def worst_error(case, spec, scorer, other, exact):
    found, wanted = CASES[case]
    got = found(scorer, other, random_layouts(COUNT, seed=4)).double().numpy()
    errors = []
    for row, one in enumerate(exact):
        right = wanted(spec, one)
        assert len(right) == got.shape[1]
        for percent in (50, 95):
            errors.append(abs(np.percentile(got[row], percent) / np.percentile(right, percent) - 1))
    return max(errors)


@pytest.mark.parametrize("case", CASES)
def test_bounds_are_those_of_the_exact_forward_model(case, spec, scorer, other, exact):
    assert worst_error(case, spec, scorer, other, exact) < TOLERANCE


def test_a_grasp_whose_other_hand_is_known_is_bounded_closer(spec, scorer, other, exact):
    """And channels of different faces do not get mixed up between the two contacts."""
    joint = found_grasps(scorer, other, random_layouts(COUNT, seed=4)).numpy()
    for row, one in enumerate(exact):
        alone = []
        for face in (FACE, OPPOSITE):
            flat = one[face].reshape(len(one[face]), -1, 3)
            covariance = np.linalg.inv(flat.swapaxes(1, 2) @ flat)
            alone.append(np.sqrt(covariance[:, 0, 0] + covariance[:, 1, 1]))
        least = np.maximum(alone[0][:, None], alone[1]).ravel()
        assert np.all(joint[row] > 0.9 * least)
        assert np.median(joint[row] / least) < 1.5


@pytest.mark.parametrize("case", CASES)
def test_bounds_have_gradients(case, scorer, other):
    found, _ = CASES[case]
    layouts = random_layouts(1, seed=2)
    place = layouts.magnet_mm.clone().requires_grad_()
    found(scorer, other, replace(layouts, magnet_mm=place)).log().mean().backward()
    step = torch.zeros_like(place)
    step[0, 2, 1] = 0.02
    ahead, behind = (
        found(scorer, other, replace(layouts, magnet_mm=layouts.magnet_mm + sign * step))
        .log()
        .mean()
        for sign in (1, -1)
    )
    assert_allclose(float(place.grad[0, 2, 1]), float(ahead - behind) / 0.04, rtol=0.05, atol=1e-3)


def test_there_is_no_grasp_of_a_face_whose_opposite_is_not_pressed(scorer):
    layouts = random_layouts(2, seed=2)
    assert grasps_mm((scorer,), (layouts,)).shape == (2, 0)
