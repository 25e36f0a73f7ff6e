"""Batched scores of layouts under curved surfaces: beside the ordinary chain, and a cube taken as one."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.layouts.batch_scores import DEARER, batch_scores
from estimator.layouts.presses import basis as module
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.scoring import place_information
from estimator.layouts.surfaces import surfaces
from tests.support.mechanics.candidate_cases import (
    FACE,
    made_up_motions,
    made_up_spec,
    ordinary_chain,
    random_layouts,
)
from tests.support.objects.body_cases import body_spec

COUNT = 2
REACH_MM = 12.0
BOUND_TOLERANCE = 0.008
"""Of a place's bound and of counts at rest; measured 0.004."""
GRID = {"contact_grid": {"count": [6, 5], "pitch_mm": 2.5}}
BODIES = {"cylinder": 2, "ellipsoid": 3}
"""Pressed face: of the cylinder one whose neighbours are curved and flat."""


@cache
def made(body):
    spec = made_up_spec(body_spec(body, **GRID))
    return spec, made_up_motions(spec)


def layouts_within(reach_mm, seed=0):
    """Magnets and sensors in the middle of a patch, without tilt."""
    wide = random_layouts(COUNT, seed)
    shrink = torch.tensor([reach_mm / 15, reach_mm / 15, 1.0])
    return replace(
        wide,
        magnet_mm=wide.magnet_mm * shrink,
        turn_rad=torch.zeros_like(wide.turn_rad),
        sensor_mm=wide.sensor_mm * 0.6,
    )


def worst_error(spec, motions, face):
    layouts = layouts_within(REACH_MM)
    scorer = layout_scorer(spec, press_basis(spec, motions, face))
    found, resting = (
        place_information(scorer, layouts),
        press_changes(scorer, layouts).resting_counts,
    )
    worst = 0.0
    for row in range(COUNT):
        bounds, _, rest = ordinary_chain(spec, motions, face, layouts, row)
        for name, wanted in (
            ("position_bound_mm", bounds.position_mm),
            ("force_bound_n", bounds.force_n),
        ):
            worst = max(worst, float(np.max(abs(getattr(found, name)[row].numpy() / wanted - 1))))
        away = abs(resting[row].numpy() - rest).max() / abs(rest).max()
        worst = max(worst, float(away))
    return worst


@pytest.mark.parametrize(
    ("body", "face"),
    [pytest.param("cylinder", 2, marks=pytest.mark.slow), ("ellipsoid", 3)],
)
def test_bounds_are_those_of_the_ordinary_chain(body, face):
    assert worst_error(*made(body), face) < BOUND_TOLERANCE


def test_a_cube_told_by_its_surfaces_scores_as_one_of_flat_faces(spec, motions, monkeypatch):
    """One layout turned from face to face, and every part under its own surface: the same numbers."""
    spec = made_up_spec(spec.changed(contact_grid=spec.contact_grid.changed(pitch_mm=3.0)))
    motions = made_up_motions(spec)
    layouts, faces = random_layouts(3, seed=2), (FACE, 1, 5)
    flat = [layout_scorer(spec, press_basis(spec, motions, face)) for face in faces]
    assert not any(scorer.presses.patches for scorer in flat)
    monkeypatch.setattr(module, "faces_differ", lambda spec: True)
    other = [layout_scorer(spec, press_basis(spec, motions, face)) for face in faces]
    wanted, found = (batch_scores(one, [layouts] * 3, DEARER) for one in (flat, other))
    for name, values in wanted.items():
        assert_allclose(found[name], values, rtol=0.03, err_msg=name)


def test_one_face_alone_is_scored():
    spec = made_up_spec(body_spec("dome_on_core", contact_grid={"count": [4, 4], "pitch_mm": 2.5}))
    motions = made_up_motions(spec)
    scorer = layout_scorer(spec, press_basis(spec, motions, 1))
    layouts = layouts_within(8.0)
    found = place_information(scorer, layouts)
    for row in range(COUNT):
        bounds, _, _ = ordinary_chain(spec, motions, 1, layouts, row)
        assert_allclose(found.position_bound_mm[row], bounds.position_mm, rtol=BOUND_TOLERANCE)
    scores = batch_scores([scorer], [layouts], DEARER)
    assert {*DEARER} < {*scores}
    for name, values in scores.items():
        assert values.isnan().all() == (name in DEARER), f"{name}: no other face can be pressed"


def test_gradients_are_those_of_finite_differences():
    """Along random directions of all places at once."""
    spec, motions = made("ellipsoid")
    scorer = layout_scorer(spec, press_basis(spec, motions, 3, dtype=torch.float64))
    one = layouts_within(9.0)
    magnets = one.magnet_mm[:1].double().requires_grad_()
    sensors = one.sensor_mm[:1].double().requires_grad_()

    def logarithms(magnet_mm, sensor_mm):
        laid = replace(
            one,
            magnet_mm=magnet_mm.clone(),  # gradcheck changes its inputs unseen
            sensor_mm=sensor_mm.clone(),
            turn_rad=one.turn_rad[:1].double(),
            polarity=one.polarity[:1].double(),
        )
        return place_information(scorer, laid).position_bound_mm.log().mean()

    allowed = {"eps": 1e-4, "atol": 1e-5, "rtol": 1e-2}
    assert torch.autograd.gradcheck(logarithms, (magnets, sensors), fast_mode=True, **allowed)


def test_surfaces_are_worked_out_once():
    spec = body_spec("capsule")
    assert surfaces(spec)[2] is surfaces(spec)[2]
