"""Fidelity levels of a layout search: cross-face disturbance in batches, one score, toleranced twins."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from scipy.stats import gmean

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_places import contact_places, pressed_nodes
from design.spec.object import ScoreSpec
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.information.cross_face import LEAST_FALSE_FORCE_N, cross_face_disturbance
from estimator.information.fisher import disturbance_counts
from estimator.information.scores import score_places
from estimator.layouts.batch import layouts_of
from estimator.layouts.cross_face import CROSS_FACE_FORCE_N, false_forces_n, neighbour_changes
from estimator.layouts.fidelity import (
    SCORE_NAMES,
    lowest_fidelity_score,
    regressed_share,
    score_signals,
)
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.scoring import place_information
from estimator.signals.field_setup import sensed_field
from estimator.signals.hall import counts_of_field, full_scale_counts
from estimator.signals.presses import press_signals, saturation_margin
from estimator.tolerances.budget import twin_bounds
from estimator.tolerances.saturation import saturation
from tests.support.mechanics.candidate_cases import (
    FACE,
    at_contacts,
    layout_scene,
    random_layouts,
)
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

COUNT = 3
GRID = {"count": (3, 3), "pitch_mm": 8.0}
DISTURBANCE_TOLERANCE = 0.05
"""Of a layout's percentiles; measured 3 %, from the short series and basis."""


def neighbours_of(spec):
    frames = {frame.number: frame for frame in face_frames(spec)}
    return [n for n, f in frames.items() if abs(f.normal @ frames[FACE].normal) < 0.5]


def ordinary_changes(spec, motions, layouts, row, numbers):
    """Whitened, per face that is read, place and channel, with exact fields of all 25 magnets."""
    parts = [
        np.asarray(getattr(layouts, name)[row], float)
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    ]
    motion = at_contacts(spec, layout_scene(spec, motions, FACE, *parts)[1])
    motion = motion.mean(axis=1)  # of 0.8 and 1.2 times 8 N
    model, found = FieldModel(magnet_source(spec.magnets), "exact"), []
    for number in numbers:
        scene = layout_scene(spec, motions, number, *parts)[0]
        states = np.concatenate([motion, 0 * motion[:1]])
        counts = counts_of_field(
            1e3 * sensed_field(scene, states, model), scene.sensors.axes, spec.sensors
        )
        change = (counts[:-1] - counts[-1]).reshape(len(motion), -1)
        found.append(change / disturbance_counts(spec.sensors, "fresh", change.shape[1]))
    return np.stack(found)


def disturbance(scorer, layouts):
    """Length of the change of each neighbour's channels at the score's force, per place."""
    places = len(scorer.presses.places)
    motion = torch.arange(3 * places, 4 * places)
    return neighbour_changes(scorer, layouts, motion).square().sum(2).sqrt()


def worst_median_error(spec, motions, scorer):
    layouts = random_layouts(COUNT, seed=4)
    found = disturbance(scorer, layouts).numpy()
    errors = []
    for row in range(COUNT):
        changes = ordinary_changes(spec, motions, layouts, row, neighbours_of(spec))
        exact = np.linalg.norm(changes, axis=2)
        errors.append(np.max(abs(np.median(found[row], axis=1) / np.median(exact, axis=1) - 1)))
    return max(errors)


def test_disturbance_of_neighbours_is_that_of_all_magnets_exactly(spec, motions, scorer):
    assert worst_median_error(spec, motions, scorer) < DISTURBANCE_TOLERANCE


def nearest_forces_n(spec, changes, own):
    """Force of the nearest own press of each change, searched on a fine grid of forces to 16 N.

    `changes` (change, channel) of presses of 10 N, `own` (place, channel) of presses to the score's
    force.
    """
    share = np.linspace(0, 2, 401)
    curves = (share[:, None, None] * own).reshape(-1, own.shape[1])
    away = (curves**2).sum(axis=1) - 2 * changes @ curves.T
    return spec.score.force_n * np.repeat(share, len(own))[away.argmin(axis=1)]


def test_false_forces_are_those_of_exact_fields(spec, motions, scorer):
    layouts = random_layouts(COUNT, seed=4)
    found = false_forces_n(scorer, layouts).numpy()
    for row in range(COUNT):
        faces = [FACE, *neighbours_of(spec)]
        own, *others = ordinary_changes(spec, motions, layouts, row, faces)
        changes = np.concatenate(others) * CROSS_FACE_FORCE_N / spec.score.force_n
        wanted = nearest_forces_n(spec, changes, own)
        for percent in (50, 95):
            ratio = np.percentile(found[row], percent) / np.percentile(wanted, percent)
            assert abs(ratio - 1) < DISTURBANCE_TOLERANCE


@pytest.mark.parametrize("score", [disturbance, false_forces_n])
def test_disturbance_has_gradients(scorer, score):
    layouts = random_layouts(1, seed=2)
    place = layouts.magnet_mm.clone().requires_grad_()
    score(scorer, replace(layouts, magnet_mm=place)).mean().backward()
    step = torch.zeros_like(place)
    step[0, 2, 1] = 0.02
    ahead, behind = (
        score(scorer, replace(layouts, magnet_mm=layouts.magnet_mm + sign * step)).mean()
        for sign in (1, -1)
    )
    assert_allclose(float(place.grad[0, 2, 1]), float(ahead - behind) / 0.04, rtol=0.05)


def test_lowest_fidelity_score_pools_the_places_of_all_faces(spec, motions, scorer):
    other = layout_scorer(spec, press_basis(spec, motions, 1))
    found = lowest_fidelity_score(spec, (scorer, other))
    places = [place_information(s, layouts_of(spec, s.presses.face)) for s in (scorer, other)]
    position = torch.cat([p.position_bound_mm.flatten() for p in places]).double().numpy()
    delta = torch.cat([p.sensitivity.flatten() for p in places]).double().numpy()
    assert_allclose(found.worst_position_bound_mm, position.max(), rtol=1e-6)
    assert_allclose(found.median_position_bound_mm, np.median(position), rtol=1e-6)
    low, middle = np.percentile(delta, [5, 50])
    assert_allclose(found.sensitivity_ratio, low / middle, rtol=1e-6)
    largest = max(float(p.largest_counts) for p in places)
    assert_allclose(
        found.saturation_margin, 1 - largest / full_scale_counts(spec.sensors), rtol=1e-6
    )
    kept = max(float(p.kept_counts) for p in places)
    assert_allclose(found.objects_margin, 1 - kept / full_scale_counts(spec.sensors), rtol=1e-6)
    assert found.objects_margin < found.saturation_margin


def test_a_score_of_signals_is_that_of_its_parts():
    spec = coarse_spec(contact_grid=GRID)
    presses = synthetic_presses(spec)
    signals = press_signals(spec, *presses)
    found, scores = score_signals(spec, signals, *presses), score_places(spec, signals)
    assert found.worst_position_bound_mm == scores.position_bound_mm.max()
    assert found.worst_force_bound_n == scores.force_bound_n.max()
    assert found.saturation_margin == saturation_margin(signals, spec)
    assert found.objects_margin == saturation(spec, signals, presses[1]).margin[-1]
    cross = cross_face_disturbance(spec, signals, CROSS_FACE_FORCE_N).summary("adjacent")
    for name in ("median_false_force_n", "percentile_95_false_force_n"):
        assert getattr(found, name) == cross[name] > LEAST_FALSE_FORCE_N
    ratio = np.percentile(scores.delta_raw, 5) / np.median(scores.delta_raw)
    assert_allclose(found.sensitivity_ratio, ratio, rtol=1e-12)


def test_a_range_of_forces_is_judged_by_geometric_means():
    forces = (1.0, 2.5)
    spec = coarse_spec(search={"forces_n": forces}, contact_grid=GRID)
    presses = synthetic_presses(spec)
    signals = press_signals(spec, *presses)
    found = score_signals(spec, signals, *presses)
    each = [score_places(spec.changed(score=ScoreSpec(force_n=n)), signals) for n in forces]
    bounds = np.array([one.position_bound_mm for one in each])
    assert_allclose(found.position_bounds_mm, bounds.ravel(), rtol=1e-12)
    wanted = np.prod([np.percentile(one, 99) for one in bounds]) ** 0.5
    assert_allclose(found.percentile_99_position_bound_mm, wanted, rtol=1e-12)
    assert_allclose(found.worst_position_bound_mm, np.prod(bounds.max((1, 2))) ** 0.5, rtol=1e-12)
    better = replace(found, position_bounds_mm=tuple((0.5 * bounds.ravel()).tolist()))
    assert regressed_share(better, found) == 1
    limit, edge = spec.limits.position_bound_mm, max(spec.body.size_mm)
    assert regressed_share(better, found, limit) == np.mean(bounds > limit)
    assert_allclose(found.position_over_limit, gmean(np.clip(bounds, limit, edge).ravel() / limit))


def test_twins_are_the_design_first_then_seeded_draws_of_its_tolerances():
    spec = coarse_spec(contact_grid={"count": (2, 3), "pitch_mm": 4.0})
    presses = synthetic_presses(spec)
    found = twin_bounds(spec, *presses, 3)
    assert found["position_mm"].shape == found["force_n"].shape == (4, 30)
    assert_allclose(found["position_mm"], twin_bounds(spec, *presses, 3)["position_mm"], rtol=0)
    assert np.ptp(found["position_mm"][1:].mean(axis=1)) > 1e-3
    signals = press_signals(spec, *presses)
    design = score_places(spec, signals).position_bound_mm
    assert_allclose(found["position_mm"][0], design.ravel(), rtol=0.06)
    exact = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    perfect = spec.model_copy(update={"tolerances": spec.tolerances.model_copy(update=exact)})
    alike = twin_bounds(perfect, *presses, 2)["position_mm"]
    assert_allclose(alike[1:], alike[[0, 0]], rtol=1e-12)


def test_bounds_are_those_of_a_drifted_baseline_where_the_zero_is_as_far_off():
    grid = {"count": (2, 3), "pitch_mm": 4.0}
    fresh = coarse_spec(contact_grid=grid, search={"forces_n": []})
    drift = fresh.sensors.drift_counts
    drifted = fresh.changed(sensors=fresh.sensors.changed(zeroing_counts=drift))
    presses = synthetic_presses(fresh)
    signals = press_signals(fresh, *presses)
    known, found = score_places(fresh, signals), score_signals(drifted, signals, *presses)
    assert_allclose(found.position_bounds_mm, known.position_bound_drifted_mm.ravel(), rtol=1e-12)
    assert_allclose(found.worst_force_bound_n, known.force_bound_drifted_n.max(), rtol=1e-12)
    assert found.median_position_bound_mm > 1.5 * np.median(known.position_bound_mm)
    ratio = np.percentile(known.delta_raw, 5) / np.median(known.delta_raw)
    assert_allclose(found.sensitivity_ratio, ratio, err_msg="δ is of white noise")
    twins = twin_bounds(drifted, *presses, 1)["position_mm"][0]
    assert_allclose(twins, known.position_bound_drifted_mm.ravel(), rtol=0.06)


def test_a_twin_too_soft_for_the_simulated_depths_is_left_out_there():
    sizes = {"tolerances": {"modulus_relative": 0.6}, "score": {"force_n": 25.0}}
    spec = coarse_spec(contact_grid={"count": (2, 3), "pitch_mm": 4.0}, **sizes)
    presses = synthetic_presses(spec)
    found = twin_bounds(spec, *presses, 8)
    left_out = np.isnan(found["force_n"])
    assert not left_out[0].any()  # the design
    assert left_out[1:].any()
    assert not left_out[1:].all()
    assert np.isfinite(found["force_n"][~left_out]).all()
    assert (np.isnan(found["position_mm"]) == left_out).all()


def test_locations_that_a_face_has_not_are_in_no_score():
    """A box whose faces are filled: the scores are those of the locations that are there."""
    box = {"size_mm": (44.0, 36.0, 28.0)}
    fill = {"count": "fill", "pitch_mm": 7.0}
    spec = coarse_spec(body=box, contact_grid=fill, press={"depths_mm": (0.5, 1.0, 2.0, 3.0)})
    forces, motions = synthetic_presses(spec)
    there = pressed_nodes(spec)
    for values in (forces.force_n, forces.contact_area_mm2, motions.motion):
        values[~there] = np.nan
    signals = press_signals(spec, forces, motions)
    found, scores = score_signals(spec, signals, forces, motions), score_places(spec, signals)
    own = contact_places(spec)
    assert not own.all()
    assert all(np.isfinite(getattr(found, name)) for name in SCORE_NAMES)
    np.testing.assert_array_equal(found.position_bounds_mm, scores.position_bound_mm[own])
    assert found.worst_position_bound_mm == pytest.approx(np.nanmax(scores.position_bound_mm[own]))


def test_twins_are_judged_where_the_force_is_reached_and_refused_where_it_is_nowhere():
    spec = coarse_spec(contact_grid={"count": (2, 3), "pitch_mm": 4.0}, score={"force_n": 25.0})
    forces, motions = synthetic_presses(spec)
    first_soft = np.where(np.arange(len(forces.force_n)) == 0, 0.5, 1.0)[:, None, None]
    forces = replace(forces, force_n=forces.force_n * first_soft)
    reached = score_places(spec, press_signals(spec, forces, motions)).reaches_score_force.ravel()
    assert 0 < reached.sum() < reached.size
    bounds = twin_bounds(spec, forces, motions, 1)
    for name in ("position_mm", "force_n"):
        np.testing.assert_array_equal(np.isfinite(bounds[name][0]), reached)
    with pytest.raises(InputError, match="no press reaches 400 N"):
        twin_bounds(spec.changed(score=spec.score.changed(force_n=400.0)), forces, motions, 1)
