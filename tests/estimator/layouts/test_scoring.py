"""Batched scores of layouts: against the ordinary chain, gradients, mirror images, bad input."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from pydantic import BaseModel

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.layouts import scoring
from estimator.layouts.batch import Layouts, layouts_of
from estimator.layouts.batch_scores import batch_scores
from estimator.layouts.presses.basis import press_basis, surface_compliance
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.presses.mixed_rows import interpolate_motion_rows
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.scoring import place_information
from tests.support.mechanics.candidate_cases import (
    FACE,
    LINEAR,
    SHARES,
    at_contacts,
    counts_of_scene,
    layout_scene,
    motions_at,
    ordinary_chain,
    random_layouts,
)

COUNT = 4
BOUND_TOLERANCE = 0.03
"""Of a place's bound; measured 1 %, from the other faces' short series and basis."""


NAMES = (
    "worst_position_bound_mm",
    "median_position_bound_mm",
    "worst_force_bound_n",
    "sensitivity_ratio",
    "largest_counts",
)


def scores_of(scorer, layouts):
    return batch_scores([scorer], [layouts], ())


@pytest.fixture(scope="module")
def layouts():
    return random_layouts(COUNT)


@pytest.fixture(scope="module")
def ordinary(spec, motions, layouts):
    return [ordinary_chain(spec, motions, FACE, layouts, row) for row in range(COUNT)]


def worst_error(scorer, layouts, ordinary):
    """Largest relative error of any place's position and force bound."""
    found = place_information(scorer, layouts)
    pairs = [
        (getattr(found, name)[row], getattr(bounds, of))
        for row, (bounds, _, _) in enumerate(ordinary)
        for name, of in (("position_bound_mm", "position_mm"), ("force_bound_n", "force_n"))
    ]
    return max(float(np.max(abs(np.asarray(a) / b - 1))) for a, b in pairs)


def test_bounds_are_those_of_the_ordinary_chain(scorer, layouts, ordinary):
    assert worst_error(scorer, layouts, ordinary) < BOUND_TOLERANCE


def test_polarity_counts(scorer, layouts, ordinary):
    north = replace(layouts, polarity=torch.ones_like(layouts.polarity))
    assert worst_error(scorer, north, ordinary) > 3 * BOUND_TOLERANCE


def test_sensitivity_and_rest_are_those_of_the_ordinary_chain(spec, scorer, layouts, ordinary):
    found, resting = (
        place_information(scorer, layouts),
        press_changes(scorer, layouts).resting_counts,
    )
    for row, (_, counts, rest) in enumerate(ordinary):
        white = counts / np.tile(spec.sensors.noise_counts, counts.shape[1] // 3)
        # determinant of noise plus one direction of signal, whose variance is an eighth
        wanted = np.sqrt(1 + (white**2).sum(axis=1) / 8)
        assert_allclose(found.sensitivity[row], wanted, rtol=0.02)
        assert_allclose(resting[row], rest, rtol=0, atol=0.02 * abs(rest).max())


def test_sensitivity_is_the_determinant_of_a_press_whose_signals_bend_with_force(scorer):
    """Against the covariance of its frames; with straight signals det would be far too small."""
    rng = np.random.default_rng(4)
    force_n, white = scorer.presses.force_n, scorer.white_share.repeat(3).numpy()
    peak, slope = 30 * rng.normal(size=(2, 9, 3, 5))
    given = torch.as_tensor(
        np.stack([0 * peak, 0 * peak, slope / force_n, peak], axis=2), dtype=torch.float32
    )
    found = scoring.press_sensitivity(scorer, given).numpy()
    share = 0.5 - 0.5 * np.cos(2 * np.pi * (np.arange(400) + 0.5) / 400)
    parabola = np.multiply.outer(peak, share) + np.multiply.outer(slope - peak, share**2 - share)
    frames = (parabola * white[:, None, None, None]).transpose(1, 2, 0, 3)
    centred = frames - frames.mean(axis=-1, keepdims=True)
    covariance = np.eye(9) + np.einsum("lpcf,lpdf->lpcd", centred, centred) / 400
    assert_allclose(found, np.sqrt(np.linalg.det(covariance)), rtol=1e-3)
    straight = np.sqrt(1 + ((peak * white[:, None, None]) ** 2).sum(axis=0) / 8)
    assert (straight < 0.5 * found).all()


@pytest.mark.parametrize("over_score", [1.5, 0.2, -3.0])
def test_largest_counts_are_those_at_rest_or_in_presses_to_their_deepest(
    scorer, layouts, ordinary, over_score
):
    """Motions in proportion to force, so that signals nearly are; pulled where channels come from their
    largest at rest."""
    deepest = torch.full((scorer.presses.count,), over_score * scorer.presses.force_n)
    scorer = replace(scorer, presses_of=(replace(scorer.presses, deepest_n=deepest),))
    found = place_information(scorer, layouts).largest_counts
    for row, (_, counts, rest) in enumerate(ordinary):
        pressed = rest.ravel() + over_score * counts
        wanted = max(abs(rest).max(), abs(pressed).max())
        assert_allclose(found[row], wanted, rtol=0.02)


def test_counts_in_deepest_presses_are_those_of_magnets_where_they_were_moved(
    spec, motions, scorer, layouts
):
    """Motions of real size; those of other faces' magnets are left out. Linear signals would be up to 7 %
    off."""
    over_score = 5 / LINEAR
    deepest = torch.full((scorer.presses.count,), over_score * scorer.presses.force_n)
    scorer = replace(scorer, presses_of=(replace(scorer.presses, deepest_n=deepest),))
    found, linear = place_information(scorer, layouts).largest_counts, []
    for row in range(COUNT):
        parts = (layouts.magnet_mm, layouts.turn_rad, layouts.polarity, layouts.sensor_mm)
        of_row = (part[row].double().numpy() for part in parts)
        scene, motion = layout_scene(spec, motions, FACE, *of_row)
        moved = at_contacts(spec, motion)[:, 0] * over_score / SHARES[0]
        counts = counts_of_scene(spec, scene, np.concatenate([0 * moved[:1], moved]))
        assert_allclose(found[row], abs(counts).max(), rtol=0.02)
        little = counts_of_scene(spec, scene, np.concatenate([0 * moved[:1], 1e-3 * moved]))
        linear.append(abs(little[0] + 1e3 * (little - little[0])).max() / abs(counts).max())
    assert max(abs(np.array(linear) - 1)) > 0.05, linear


def test_summaries_are_those_of_the_places(spec, motions):
    """In double precision: in single, other batches round otherwise (`estimator.layouts.bounds`)."""
    scorer = layout_scorer(spec, press_basis(spec, motions, FACE, dtype=torch.float64))
    layouts = random_layouts(COUNT, dtype=torch.float64)
    found, score = place_information(scorer, layouts), scores_of(scorer, layouts)
    position, delta = found.position_bound_mm.numpy(), found.sensitivity.numpy()
    wanted = {
        "worst_position_bound_mm": position.max(axis=1),
        "median_position_bound_mm": np.median(position, axis=1),
        "worst_force_bound_n": found.force_bound_n.numpy().max(axis=1),
        "sensitivity_ratio": np.divide(*np.percentile(delta, [5, 50], axis=1)),
        "largest_counts": found.largest_counts.numpy(),
    }
    for name, values in wanted.items():
        assert_allclose(score[name], values, rtol=1e-9, err_msg=name)


def test_gradients_are_those_of_finite_differences(spec, motions):
    scorer = layout_scorer(spec, press_basis(spec, motions, FACE, dtype=torch.float64))
    layouts = random_layouts(2, seed=5, dtype=torch.float64)
    names = ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    given = tuple(getattr(layouts, name).requires_grad_() for name in names)

    def logarithms(*tensors):
        score = scores_of(scorer, Layouts(*tensors))
        return torch.stack([score[name].log() for name in NAMES])

    assert torch.autograd.gradcheck(logarithms, given, eps=1e-6, atol=1e-5, rtol=1e-3)


def test_an_untilted_magnet_and_a_sensor_at_the_centre_have_gradients(scorer, layouts):
    turn = torch.zeros_like(layouts.turn_rad).requires_grad_()
    sensor = torch.cat([torch.zeros(COUNT, 1, 2), layouts.sensor_mm[:, 1:]], dim=1).requires_grad_()
    score = scores_of(scorer, replace(layouts, turn_rad=turn, sensor_mm=sensor))
    score["worst_position_bound_mm"].sum().backward()
    for given in (turn, sensor):
        assert torch.isfinite(given.grad).all()
    assert (abs(turn.grad).amax(dim=(1, 2)) > 0).all()


def test_a_mirrored_layout_has_mirrored_bounds(spec, scorer, layouts):
    """y → −y is a symmetry of the whole object; tilts about x change sign, moments flip."""
    mirror = torch.tensor([1.0, -1.0])
    mirrored = Layouts(
        layouts.magnet_mm * torch.tensor([1.0, -1.0, 1.0]),
        layouts.turn_rad * torch.tensor([-1.0, 1.0]),
        layouts.polarity,
        layouts.sensor_mm * mirror,
    )
    nx, ny = spec.contact_grid.count
    found, other = (place_information(scorer, given) for given in (layouts, mirrored))
    for name in ("position_bound_mm", "force_bound_n", "sensitivity"):
        here = getattr(found, name).reshape(COUNT, nx, ny)
        there = getattr(other, name).reshape(COUNT, nx, ny)
        assert_allclose(there.flip(2), here, rtol=2e-3, err_msg=name)
        assert abs(there / here - 1).max() > 0.1


def test_stored_forces_between_the_least_and_the_largest_change_nothing(spec, motions):
    """Motions count as straight between those two."""
    between = {
        "force_n": np.insert(motions.force_n, 1, motions.force_n.mean(axis=2), axis=2),
        "depth_mm": np.insert(motions.depth_mm, 1, 7.0, axis=2),
        "presses": np.insert(motions.presses, 1, np.float32(7.0), axis=2),
    }
    found, wanted = (press_basis(spec, m, FACE) for m in (replace(motions, **between), motions))
    torch.testing.assert_close(found.own_table.rows, wanted.own_table.rows)
    torch.testing.assert_close(found.own_table.basis, wanted.own_table.basis)
    torch.testing.assert_close(found.mm_per_n, wanted.mm_per_n)


def test_rows_are_the_motions_of_the_table(spec, motions, layouts):
    """Unfolded again, in the pressed face's frame, up to the border of the candidates."""
    presses = press_basis(spec, motions, FACE)
    xyd = layouts.magnet_mm.reshape(-1, 3).clone()
    xyd[0], xyd[1] = torch.tensor([18.0, -18.0, 1.5]), torch.tensor([-18.0, 3.3, 6.5])
    own, _ = interpolate_motion_rows(
        presses, replace(layouts, magnet_mm=xyd.reshape(layouts.magnet_mm.shape))
    )
    unfolded = own.reshape(len(xyd), 6, -1) @ presses.own_table.basis
    found = unfolded.reshape(len(xyd), 2, 3, 4, -1)[:, :, :, 3]
    at = xyd.double().numpy()
    stored = at_contacts(spec, motions_at(motions, FACE, at[:, :2], at[:, 2])[FACE - 1]).mean(
        axis=1
    )
    axes = np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]]).T
    wanted = (stored.reshape(*stored.shape[:2], 2, 3) @ axes).transpose(1, 2, 3, 0)
    assert_allclose(found, wanted, rtol=0, atol=2e-3 * abs(wanted).max())


def test_the_specification_s_own_layout():
    spec = ObjectSpec(name="cube")
    tilts = ((0.0, 0.0), (5.0, 0.0), (0.0, 5.0), (-5.0, 0.0), (0.0, -4.0))
    magnets = spec.magnets.model_copy(update={"tilt_deg": tilts})
    layouts = layouts_of(spec.model_copy(update={"magnets": magnets}), 2)
    assert_allclose(layouts.magnet_mm[0, 1], [10, 10, 2.5], rtol=1e-6)
    assert_allclose(layouts.turn_rad[0, 4], [0, np.deg2rad(-4)], rtol=1e-6)
    assert_allclose(layouts.sensor_mm[0, 0], [-8.585, 0], rtol=0, atol=1e-5)


@pytest.mark.parametrize(
    ("place", "what"), [((18.5, 0, 2.5), "x = 18.5 mm"), ((0, 0, 0.9), "depth = 0.9 mm")]
)
def test_magnets_beyond_the_candidates_are_refused(scorer, layouts, place, what):
    magnet_mm = layouts.magnet_mm.clone()
    magnet_mm[2, 1] = torch.tensor(place)
    with pytest.raises(InputError, match=what):
        scores_of(scorer, replace(layouts, magnet_mm=magnet_mm))


def test_compliance_is_the_depth_over_the_force_on_the_straight_line_between_stored_forces(motions):
    straight = replace(motions, depth_mm=0.2 + 0.3 * motions.force_n)
    for force_n in (5.0, 9.0):
        found = surface_compliance(straight, FACE, force_n)
        np.testing.assert_allclose(found, (0.2 + 0.3 * force_n) / force_n, rtol=1e-5)


def test_what_cannot_be_scored_is_refused(spec, motions, presses):
    blocks = BaseModel.model_copy(spec.magnets, update={"shape": "block"})  # unvalidated
    with pytest.raises(InputError, match="round magnets only"):
        layout_scorer(BaseModel.model_copy(spec, update={"magnets": blocks}), presses)
    silent = BaseModel.model_copy(spec.sensors, update={"noise_counts": (1.0, 0.0, 1.0)})
    with pytest.raises(InputError, match="white noise on every axis"):
        layout_scorer(BaseModel.model_copy(spec, update={"sensors": silent}), presses)
    with pytest.raises(InputError, match="face 6 was not pressed"):
        press_basis(spec, motions, 6)
    once = replace(
        motions,
        force_n=motions.force_n[..., :1],
        depth_mm=motions.depth_mm[..., :1],
        presses=motions.presses[:, :, :1],
    )
    with pytest.raises(InputError, match="two forces"):
        press_basis(spec, once, FACE)
    uneven = replace(motions.candidates[1], x_mm=motions.candidates[1].x_mm * 0.9)
    lattices = (motions.candidates[0], uneven, *motions.candidates[2:])
    with pytest.raises(InputError, match="different sizes"):
        press_basis(spec, replace(motions, candidates=lattices), FACE)


def test_magnets_of_several_grades_are_scored_as_the_ordinary_chain_does(spec, motions, presses):
    """The specification's own layout; the chain is told every magnet's polarization by hand."""
    grades, remanence_t = ("N35", "N52", "N52", "N35", "N42"), (1.20, 1.45, 1.45, 1.20, 1.31)
    magnets = spec.magnets.changed(grade=grades, remanence_t=remanence_t)
    magnets = magnets.changed(north=("outward", "inward", "outward", "inward", "outward"))
    mixed = spec.changed(magnets=magnets)
    laid = layouts_of(mixed, FACE)
    by_hand = torch.tensor([[1.20, -1.45, 1.45, -1.20, 1.31]]) / 1.20
    ordinary = [ordinary_chain(mixed, motions, FACE, replace(laid, polarity=by_hand), 0)]
    own = layout_scorer(mixed, presses)
    assert worst_error(own, laid, ordinary) < BOUND_TOLERANCE
    alike = replace(laid, polarity=laid.polarity.sign())
    assert worst_error(own, alike, ordinary) > 3 * BOUND_TOLERANCE
