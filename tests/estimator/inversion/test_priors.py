"""Priors of contacts: misfits and densities by hand, slopes and curvatures by differences."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.inversion.model.forward import NONE
from estimator.inversion.priors import (
    Pairs,
    Priors,
    Quadratic,
    fitting_sets,
    jaw_pairs,
    log_density,
    log_paired,
    widths,
)

BASE = {"number": (0.4, 0.3, 0.2, 0.1), "faces": 2, "area_mm2": 800.0, "force_n": (0.5, 10.5)}
FREE = Priors(**BASE, apart_mm=10.0)
PROBES = Priors(**BASE, spacing_mm=(15.0, 20.0), force_spread=0.2)
JAWS = Priors(**BASE, paired=True)
FACE = np.array([[0, 0, 0], [0, 0, 1], [1, NONE, NONE], [0, 1, NONE], [NONE] * 3])


def contacts():
    place = np.array(
        [
            [[0.0, 0, 2], [6, 0, 3], [0, 9.0, 4]],
            [[1.0, 2, 2], [5, 5, 6], [0, 0, 1]],
            [[1.0, 1, 3], [0, 0, 0], [0, 0, 0]],
            [[1.0, 1, 3], [1, 2, 4], [0, 0, 0]],
            [[0.0, 0, 0]] * 3,
        ]
    )
    return np.asarray(place, float)


def added(priors, contact):
    found = Quadratic(np.zeros(5), np.zeros((5, 9)), np.zeros((5, 9, 9)), np.zeros(5))
    Pairs(priors, FACE).add(found, contact)
    return found


def test_tips_that_overlap_cost_by_how_much_and_others_nothing():
    """Of 10 mm; 6 and 9 mm overlap, √117 does not; on two faces they never do."""
    misfit = added(FREE, contacts()).misfit
    assert_allclose(misfit, [(4**2 + 1) / 0.5**2 / 2, (10 - 5) ** 2 / 0.5**2 / 2, 0, 0, 0])


def test_tips_of_a_known_probe_stand_as_it_has_them_and_bear_alike():
    three = (6 - 20) ** 2 + (9 - 20) ** 2 + (np.sqrt(117) - 20) ** 2
    forces = np.log([2 / 3, 2 / 4, 3 / 4]) ** 2
    wanted = three / 0.2**2 / 2 + forces.sum() / (3 * 0.2**2) / 2
    misfit = added(PROBES, contacts()).misfit
    assert_allclose(misfit[0], wanted)
    two = (5 - 15) ** 2 / 0.2**2 / 2 + np.log(2 / 6) ** 2 / (2 * 0.2**2) / 2
    assert_allclose(misfit, [wanted, two, 0, 0, 0])


def test_two_jaws_bear_alike_whatever_their_tips_share():
    """Of the five sets two press two faces: 2 + 6 N beside 1 N, and 3 N beside 4 N."""
    spread = 2 * 0.3**2
    wanted = [0, np.log(8 / 1) ** 2 / spread / 2, 0, np.log(3 / 4) ** 2 / spread / 2, 0]
    assert_allclose(added(JAWS, contacts()).misfit, wanted)


def test_jaws_are_two_faces_that_alone_are_pressed():
    face = np.array(
        [[0, 0, 1, NONE], [3, 1, 3, 1], [2, 2, NONE, NONE], [0, 1, 2, NONE], [NONE] * 4]
    )
    wanted = [[1, 1, -1, 0], [1, -1, 1, -1], [0] * 4, [0] * 4, [0] * 4]
    assert_allclose(jaw_pairs(face), wanted)
    assert_allclose(jaw_pairs(torch.as_tensor(face)).numpy(), wanted)


@pytest.mark.parametrize("priors", [FREE, PROBES, JAWS], ids=["free", "probes", "jaws"])
def test_slopes_are_those_of_the_misfit_and_curvature_that_of_its_squares(priors):
    contact, step = contacts(), 1e-6
    found = added(priors, contact)
    for slot in range(3):
        for parameter in range(3):
            ahead, behind = contact.copy(), contact.copy()
            ahead[:, slot, parameter] += step
            behind[:, slot, parameter] -= step
            with np.errstate(divide="ignore", invalid="ignore"):
                by_steps = (added(priors, ahead).misfit - added(priors, behind).misfit) / (2 * step)
            assert_allclose(found.slope[:2, 3 * slot + parameter], by_steps[:2], atol=1e-4)
    assert_allclose(found.curvature, found.curvature.transpose(0, 2, 1))
    assert np.linalg.eigvalsh(found.curvature).min() > -1e-9
    gauss = np.linalg.pinv(found.curvature[1]) @ found.slope[1]
    moved = contact.copy()
    moved[1] -= gauss.reshape(3, 3)
    assert added(priors, moved).misfit[1] < 0.2 * found.misfit[1]


@pytest.mark.parametrize("priors", [FREE, PROBES, JAWS], ids=["free", "probes", "jaws"])
def test_selected_problems_get_what_they_get_among_all(priors):
    rows = [3, 1]
    every = added(priors, contacts())
    found = Quadratic(np.zeros(2), np.zeros((2, 9)), np.zeros((2, 9, 9)), np.zeros(2))
    Pairs(priors, FACE).select(np.array(rows)).add(found, contacts()[rows])
    for one, among_all in zip(found.parts, every.parts, strict=True):
        assert_allclose(one, among_all[rows])


SHARED = np.log([2 * (10 / 9) ** 2, 10 / 8, 1, 1, 1])
"""Three tips share 9 N of up to 10 N, two 8 N; others bear theirs alone."""


def test_the_density_of_free_contacts_counts_them_and_their_orders():
    each = -np.log(800 * 10)
    number = np.array([3, 3, 1, 2, 0])
    wanted = number * each + np.log([0.1, 0.1, 0.3, 0.2, 0.4]) + np.log([6, 6, 1, 2, 1])
    assert_allclose(log_density(Priors(**BASE), FACE, contacts()), wanted + SHARED)
    assert Priors(**BASE).most == 3
    never = Priors(**BASE | {"number": (0.0, 0.5, 0.3, 0.2)})
    assert log_density(never, FACE, contacts())[4] < -600


def test_the_force_of_a_face_is_even_however_many_tips_share_it():
    """Drawn so: the whole force even, cut at even places. Density counted in a box of forces."""
    rng, size = np.random.default_rng(1), 400_000
    whole = rng.uniform(0.5, 10.5, size)
    cuts = np.sort(rng.uniform(0, 1, (size, 2)), axis=1) * whole[:, None]
    force = np.diff(cuts, axis=1, prepend=0.0, append=whole[:, None])
    near = np.all(np.abs(force - [2.0, 3.0, 1.5]) < 0.4, axis=1)
    counted = near.mean() / 0.8**3
    face, contact = np.zeros((1, 3), int), np.zeros((1, 3, 3))
    contact[0, :, 2] = 2.0, 3.0, 1.5
    found = np.exp(log_density(Priors(**BASE), face, contact)[0]) / (0.1 * 6 / 800**3)
    assert_allclose(found, counted, rtol=0.05)


def test_forces_of_two_jaws_are_as_dense_as_drawn():
    """The mean even, the logarithm of the ratio normal. Density counted in a box of forces."""
    rng, size = np.random.default_rng(4), 400_000
    mean, ratio = rng.uniform(0.5, 10.5, size), np.exp(rng.normal(0, 0.3 * np.sqrt(2), size))
    force = 2 * mean[:, None] * np.stack([ratio, np.ones(size)], axis=1) / (1 + ratio[:, None])
    counted = np.all(np.abs(force - [3.0, 2.0]) < 0.2, axis=1).mean() / 0.4**2
    face, contact = np.array([[0, 1, NONE]]), np.zeros((1, 3, 3))
    contact[0, :2, 2] = 3.0, 2.0
    found = Quadratic(np.zeros(1), np.zeros((1, 9)), np.zeros((1, 9, 9)), np.zeros(1))
    Pairs(JAWS, face).add(found, contact)
    dense = log_density(JAWS, face, contact) - log_density(Priors(**BASE), face, contact)
    assert_allclose(np.exp(dense - found.misfit) / 10**2, counted, rtol=0.03)


@pytest.mark.parametrize(("tips", "spacing_mm", "side_mm"), [(2, 15.0, 30.0), (3, 20.0, 30.0)])
def test_places_and_turns_of_a_probe_that_fit_are_those_drawn(tips, spacing_mm, side_mm):
    rng = np.random.default_rng(5)
    first, turn = rng.uniform(0, side_mm, (200_000, 2)), rng.uniform(0, 2 * np.pi, 200_000)
    fits = np.ones(len(turn), bool)
    for other in range(tips - 1):
        way = turn + other * np.pi / 3
        place = first + spacing_mm * np.stack([np.cos(way), np.sin(way)], axis=1)
        fits &= np.all((place > 0) & (place < side_mm), axis=1)
    assert_allclose(fitting_sets(tips, spacing_mm, side_mm), fits.mean(), rtol=0.02)


def test_a_probe_too_large_for_a_square_face_fits_in_few_ways():
    assert fitting_sets(3, 20.0, 15.0) == 0.01


def test_contacts_apart_are_denser_by_the_sets_that_overlap():
    """Of two contacts anywhere on two faces of 20 mm by 20 mm, by drawing them."""
    rng, size = np.random.default_rng(2), 200_000
    place = rng.uniform(0, 20, (size, 2, 2))
    near = np.linalg.norm(place[:, 0] - place[:, 1], axis=1) < 10.0
    overlap = (near & (rng.integers(0, 2, size) == rng.integers(0, 2, size))).mean()
    gained = log_density(FREE, FACE, contacts()) - log_density(Priors(**BASE), FACE, contacts())
    assert_allclose(gained[3], -np.log(1 - overlap), rtol=0.02)
    assert_allclose(gained, gained[3] * np.array([3, 3, 0, 1, 0]))


def test_probes_drawn_as_they_are_known_are_as_dense_as_the_prior_says():
    """One to three tips on a face of 40 mm by 40 mm: number, first place, angle, side, whole force and shares
    drawn, each with its own density, until all tips are on the face; orders of tips are one set."""
    rng, spread, sigma = np.random.default_rng(3), 0.2, 0.2
    priors = Priors((0.1, 0.2, 0.3, 0.4), 1, 1600.0, (0.5, 10.5), 0.0, spread, (15.0, 20.0))
    place, angle, whole = (
        rng.uniform(0, 40, (20, 2)),
        rng.uniform(0, 2 * np.pi, 20),
        rng.uniform(2, 9, 20),
    )
    for tips, orders, sides in ((1, 1, 1), (2, 2, 1), (3, 6, 2)):
        apart = {1: 0.0, 2: 15.0, 3: 20.0}[tips]
        contact = np.zeros((20, 3, 3))
        contact[:, :, :2] = place[:, None]
        for tip, turn in ((1, 0.0), (2, np.pi / 3)):
            way = np.stack([np.cos(angle + turn), np.sin(angle + turn)], axis=1)
            contact[:, tip, :2] += apart * way
        contact[:, :tips, 2] = whole[:, None] / tips
        face = np.where(np.arange(3) < tips, 0, NONE) + np.zeros((20, 1), int)
        found = Quadratic(np.zeros(20), np.zeros((20, 9)), np.zeros((20, 9, 9)), np.zeros(20))
        Pairs(priors, face).add(found, contact)
        assert_allclose(found.misfit, 0, atol=1e-9)
        normal = 1 / (np.sqrt(2 * np.pi) * sigma)
        second = normal / (2 * np.pi * apart) if tips > 1 else 1.0
        # distances to both others are normal; they cross at 60 degrees
        third = normal**2 * np.sin(np.pi / 3) / sides if tips > 2 else 1.0
        # even in the sum; logarithms normal across it: d(sum) = sqrt(tips) d(along), d(force) = force d(log)
        across = (tips / whole / np.sqrt(2 * np.pi) / spread) ** (tips - 1) * np.sqrt(tips)
        fitting = fitting_sets(tips, apart, 40.0) if tips > 1 else 1.0
        drawn = priors.number[tips] * orders / 1600 * second * third * across / 10 / fitting
        assert_allclose(np.exp(log_density(priors, face, contact)), drawn, rtol=1e-9)


def test_probes_on_two_faces_are_ordered_within_a_face_and_as_faces():
    """Of (2, 1) tips: two faces, and the orders of two tips; no probe has four tips."""
    alone = [
        log_density(PROBES, np.array([row]), contacts()[1:2])
        for row in ([0, 0, NONE], [1, NONE, NONE])
    ]
    both = log_density(PROBES, FACE[1:2], contacts()[1:2][:, [0, 1, 2]])
    number = np.log(np.array([0.3, 0.2, 0.1]))
    assert_allclose(both, alone[0] + alone[1] - number[0] - number[1] + number[2] + np.log(2))
    crowded = np.zeros((1, 4), int)
    four = Priors(**BASE | {"number": (0.2,) * 5}, spacing_mm=(15.0, 20.0))
    assert log_density(four, crowded, np.ones((1, 4, 3)))[0] == -np.inf


def test_two_jaws_have_as_many_tips_each_and_anything_else_is_rare():
    face = np.array(
        [
            [NONE] * 4,
            [0, 2, NONE, NONE],
            [2, 0, 0, 2],
            [0, 0, 2, NONE],
            [1, 1, NONE, NONE],
            [0, 1, 2, NONE],
        ]
    )
    paired = Priors(**BASE | {"faces": 3}, paired=True)
    assert_allclose(np.exp(log_paired(paired, face)), [1, 1, 1, 1e-3, 1e-3, 1e-3])
    assert not log_paired(Priors(**BASE | {"faces": 3}), face).any()


def test_no_posterior_is_wider_than_a_face_and_the_forces():
    assert_allclose(widths(FREE), [20.0, 20.0, 10.0])


def test_more_tips_on_a_face_than_any_known_probe_have_no_density():
    """Three are the most: four and five on one face are impossible alike."""
    priors = Priors((1 / 7,) * 7, 2, 800.0, (0.5, 10.5), spacing_mm=(15.0, 20.0))
    face = np.array([[0] * 3 + [NONE] * 3, [0] * 4 + [NONE] * 2, [0] * 5 + [NONE], [0] * 6])
    found = log_density(priors, face, np.ones((4, 6, 3)))
    assert np.isfinite(found).tolist() == [True, False, False, False]
