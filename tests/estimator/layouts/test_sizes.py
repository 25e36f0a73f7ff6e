"""Batched scores of magnets of several sizes: against the ordinary chain, against one size, limits."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.pockets import shell_pockets
from design.search.structure import size_variants
from design.spec.object import ContactGridSpec, ObjectSpec
from estimator.layouts.batch import layouts_by_face, layouts_of
from estimator.layouts.batch_scores import DEARER, batch_scores
from estimator.layouts.limits.parts import chips_near_magnets_mm, pockets_of
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import clamp_to_candidates, layout_scorer
from estimator.layouts.scoring import place_information
from tests.support.mechanics.candidate_cases import (
    FACE,
    chain_of_scene,
    layout_scene,
    made_up_motions,
    made_up_spec,
    random_layouts,
)

COUNT = 3
BOUND_TOLERANCE = 0.03
"""Of a place's bound, as with one size."""
SIZES = {"diameter_mm": (7.0, 4.0, 7.0, 5.0, 4.0), "height_mm": (2.0, 1.0, 2.0, 1.5, 1.0)}
STIFFER = {7.0: 0.5, 4.0: 1.0, 5.0: 1.4}
"""Made-up motions of each size over those of a small one."""


def cube(**magnets):
    return made_up_spec(
        ObjectSpec.model_validate(
            {
                "name": "cube",
                "contact_grid": ContactGridSpec(count=(5, 4), pitch_mm=6.0),
                "shell": {"pocket_diameter_mm": 7.2},
                "magnets": magnets,
            }
        )
    )


@cache
def motions_of_one_size():
    return made_up_motions(cube())


@pytest.fixture(scope="module")
def spec():
    return cube(**SIZES)


@pytest.fixture(scope="module")
def motions(spec):
    found = []
    for one in size_variants(spec):
        made, share = made_up_motions(one), STIFFER[one.magnets.sizes[0].diameter_mm]
        found.append(replace(made, by_candidate=share * made.by_candidate))
    return found


def scorer_of(spec, motions, face=FACE, force_n=None):
    each = zip(size_variants(spec), motions, strict=True)
    return layout_scorer(spec, [press_basis(one, its, face, force_n) for one, its in each])


@pytest.fixture(scope="module")
def layouts():
    return random_layouts(COUNT)


def ordinary_chain(spec, motions, layouts, row):
    parts = [
        np.asarray(getattr(layouts, name)[row], float)
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    ]
    scenes = [layout_scene(spec, its, FACE, *parts) for its in motions]
    motion = np.zeros_like(scenes[0][1])
    for number, (scene, of_size) in enumerate(scenes):
        own = scene.magnets.size == number
        motion[..., own, :] = of_size[..., own, :]
    return chain_of_scene(spec, motions[0], FACE, scenes[0][0], motion)


def worst_error(scorer, spec, motions, layouts):
    found, worst = place_information(scorer, layouts), 0.0
    for row in range(COUNT):
        bounds, _, _ = ordinary_chain(spec, motions, layouts, row)
        for name, of in (("position_bound_mm", "position_mm"), ("force_bound_n", "force_n")):
            off = np.asarray(getattr(found, name)[row]) / getattr(bounds, of) - 1
            worst = max(worst, float(abs(off).max()))
    return worst


def test_bounds_are_those_of_the_ordinary_chain(spec, motions, layouts):
    assert len(motions) == 3
    assert worst_error(scorer_of(spec, motions), spec, motions, layouts) < BOUND_TOLERANCE


def faces_of_their_own(layouts):
    return layouts_by_face({face: replace(layouts, polarity=-layouts.polarity) if face == 5 else layouts
                            for face in range(1, 6)}, FACE)  # fmt: skip


def test_scores_of_sizes_that_are_nearly_one_are_those_of_one(layouts):
    """All scores, on two faces and at two forces: however magnets are sorted by size."""
    alike, nearly = cube(), cube(diameter_mm=(6.0, 6.000001, 6.0, 6.000001, 6.000001))
    alike, nearly = (
        one.changed(magnets=one.magnets.changed(positions_mm=(one.magnets.lists[0],) * 5))
        for one in (alike, nearly)
    )
    layouts = faces_of_their_own(layouts)
    made = motions_of_one_size()
    presses = [(face, force) for face in (1, FACE) for force in (4.0, 5.0)]
    found = []
    for one, motions in ((alike, [made]), (nearly, [made, made])):
        scorers = [scorer_of(one, motions, face, force) for face, force in presses]
        laid = [replace(layouts, face=face) for face, _ in presses]
        found.append(batch_scores(scorers, laid, DEARER))
    assert len(found[0]) >= 8
    for name, wanted in found[0].items():
        assert_allclose(found[1][name], wanted, rtol=2e-3, err_msg=name)


def test_magnets_stay_within_the_candidates_of_their_own_size(spec, motions, layouts):
    scorer = scorer_of(spec, motions)
    wide = replace(layouts, magnet_mm=layouts.magnet_mm + torch.tensor([40.0, -40.0, 0.0]))
    found = clamp_to_candidates(scorer, wide).magnet_mm
    pockets = np.array(SIZES["diameter_mm"]) / 2 + 0.1
    assert_allclose(found[:, :, 0], np.tile(21 - pockets, (COUNT, 1)), atol=1e-4)
    assert_allclose(found[:, :, 1], np.tile(pockets - 21, (COUNT, 1)), atol=1e-4)


def test_pockets_in_batches_are_those_of_the_design(spec):
    tilted = spec.changed(
        magnets=spec.magnets.changed(
            tilt_deg=((5, -10), (0, 15), (8, 2), (0, 0), (-9, 0)), depth_mm=(2.5, 2.0, 3, 2.2, 2)
        )
    )
    found = pockets_of(tilted, layouts_of(tilted, FACE, torch.float64))
    for k, pocket in enumerate(shell_pockets(tilted)[0]):
        assert_allclose(found.radius[k], pocket.outline.radius_mm)
        assert_allclose(found.lowest[0, k], pocket.lowest_mm, atol=1e-5)
        assert_allclose(found.reach[:, 0, k], pocket.reach_mm, atol=1e-5)


def test_chips_keep_off_each_magnet_by_its_own_size(spec):
    (frame,) = (frame for frame in face_frames(spec) if frame.number == FACE)
    centres = torch.as_tensor(frame.to_object(np.array([[0.0, 0, -3], [9.0, 0, -3]])))[None]
    pair = spec.changed(
        magnets=spec.magnets.changed(
            positions_mm=((0.0, 0.0), (9.0, 0.0)), diameter_mm=(8.0, 4.0), height_mm=1.0
        ),
        shell=spec.shell.changed(pocket_diameter_mm=8.0),
    )
    short = []
    for x in (0.0, 9.0):
        chip = torch.as_tensor(frame.to_object(np.array([[x, 0.0, -8.0]])))[None]
        short.append(float(chips_near_magnets_mm(pair, FACE, chip, {FACE: centres})))
    radius = np.hypot(8.0, 1.0) / 2
    assert_allclose(short, [1.4 * radius + 0.02 - 5.0, 0.0], atol=1e-6)
