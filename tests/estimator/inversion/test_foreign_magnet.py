"""Magnets near the object, by a second forward model: no place is believed, and light presses still are."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation
from scipy.stats import multivariate_normal

from design.layout.places.positions import magnet_layout
from estimator.inversion.lying import log_evidence_without
from estimator.inversion.magnets import BesideMagnet, slip_columns
from estimator.inversion.model.forward import NONE
from estimator.inversion.posterior import most_probable
from estimator.inversion.problems import empty
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import (
    SPEC,
    contacts,
    inverted,
    motion_of,
    noisy_counts,
    right,
)
from tests.support.turned_frames import (
    expected_counts,
    foreign_magnets_t,
    magnets_field_t,
    read_out,
    zeroed_counts,
)

FRAMES = 30
STILL = np.zeros((FRAMES, 25, 6))


def beside_magnet(distance_mm, moment_am2, motion=STILL, seed=11):
    rng = np.random.default_rng(seed)
    foreign_t = foreign_magnets_t(SPEC, rng, len(motion), distance_mm, moment_am2)
    return zeroed_counts(SPEC, motion, rng, foreign_t=foreign_t)


def doubting():
    """A reader that believes its model wrong by 17 % of the signals."""
    told = replace(inverted().disturbances, model_error=np.full(45, 0.17))
    return replace(inverted(), disturbances=told)


@pytest.mark.parametrize("reader", [inverted, doubting])
def test_a_magnet_is_no_contact(reader):
    """Its gradients are those of a press of 2 to 4 N, but for what the other chips show."""
    magnets = [(60, 0.1), (80, 0.4), (90, 0.4), (110, 1.0)]
    found, _ = reader().read(np.concatenate([beside_magnet(*magnet) for magnet in magnets]))
    assert np.mean(found.explained & (found.number > 0)) <= 0.09
    assert np.mean(found.number > 0) <= 0.12


def test_columns_of_a_slip_are_what_shifted_and_turned_magnets_add():
    """Oracle: magpylib, where the shell's magnets move against the chips, the other way than the core."""
    shift_mm, turn_rad = np.array([0.06, -0.03, 0.02]), np.array([0.002, 0.003, -0.0025])
    centre, back = magnet_layout(SPEC).centre_mm, Rotation.from_rotvec(-turn_rad)
    motion = np.zeros((2, len(centre), 6))
    motion[1, :, :3] = back.apply(centre - shift_mm) - centre
    motion[1, :, 3:] = back.as_rotvec()
    change = np.diff(expected_counts(SPEC, magnets_field_t(SPEC, motion)), axis=0)[0]
    unknowns = np.concatenate([shift_mm / 0.1, turn_rad / 0.005])
    columns = slip_columns(inverted().model)
    assert_allclose(columns @ unknowns, change, atol=0.02 * np.abs(change).max())


@pytest.mark.parametrize(("slip_mm", "reader"), [(0.05, inverted), (0.1, doubting)])
def test_a_slipped_core_is_no_contact(slip_mm, reader):
    """All magnets shift against the chips; half of the frames at 0.05 mm look like presses of 5 N."""
    rng = np.random.default_rng(13)
    way = rng.standard_normal((FRAMES, 1, 3))
    shift_mm = slip_mm * way / np.linalg.norm(way, axis=2, keepdims=True)
    motion = STILL + np.pad(shift_mm, ((0, 0), (0, 0), (0, 3)))
    found, _ = reader().read(zeroed_counts(SPEC, motion, rng))
    assert np.mean(found.explained & (found.number > 0)) <= 0.1


def test_a_tracker_believes_no_place_beside_a_magnet_at_80_mm():
    found = [Tracker(inverted()).feed(frame) for frame in beside_magnet(80, 0.4)]
    assert np.mean([one.explained[0] and one.number[0] > 0 for one in found]) <= 0.07


def test_a_tracked_magnet_that_comes_nearer_is_no_contact_on_its_way():
    """From 160 to 60 mm, four times; beyond 110 mm it does not show, at 60 mm nothing explains it."""
    believed, explained = [], []
    for seed in range(4):
        rng = np.random.default_rng(seed)
        field_t = [
            foreign_magnets_t(SPEC, np.random.default_rng(seed), 1, mm, 0.4)[0]
            for mm in np.linspace(160, 60, 40)
        ]
        still = np.zeros((40, 25, 6))
        counts = zeroed_counts(SPEC, still, rng, turned=False, foreign_t=np.array(field_t))
        tracker = Tracker(inverted())
        found = [tracker.feed(frame) for frame in counts]
        believed.append([one.explained[0] and one.number[0] > 0 for one in found])
        explained.append([one.explained[0] for one in found])
    assert np.mean(believed) < 0.015
    assert np.mean(np.array(explained)[:, :10]) > 0.95
    assert not np.any(np.array(explained)[:, -4:])


def test_no_chip_is_blamed_for_a_magnet():
    """Without any one chip, contacts explain one frame in ten."""
    found, _ = inverted().read(beside_magnet(80, 0.4))
    assert np.mean(found.chip_out != NONE) <= 0.03


def test_contacts_beside_a_magnet_are_read_and_no_others():
    """Further contacts are believed in a fifth of the frames, in a quarter without magnets weighed."""
    face, contact = contacts(np.random.default_rng(3), FRAMES, 1, (5.0, 8.0))
    found, _ = inverted().read(beside_magnet(80, 0.4, motion_of(face, contact)))
    assert np.mean(right(found, face)) >= 0.8
    assert np.mean(found.explained & (found.number > 1)) <= 0.2


def test_light_presses_are_no_magnets():
    """The number read and believed is that of a reader that knows no magnet."""
    face, contact = contacts(np.random.default_rng(21), 60, 1, (1.0, 2.5))
    counts = zeroed_counts(SPEC, motion_of(face, contact), np.random.default_rng(22))
    reader = inverted()
    believed = []
    seen = reader.disturbances.observed(counts)
    for found in (
        reader.read(counts)[0],
        reader.read_once(reader.search, seen, reader.error_share())[0],
    ):
        believed.append(np.mean(found.explained & right(found, face)))
    assert believed[1] > 0.4, "else nothing is to be lost"
    assert believed[0] > believed[1] - 0.05


@pytest.mark.parametrize("seed", [0, 1, 5])
def test_a_grasp_of_six_tips_that_began_as_a_magnet_is_read_once_it_is_strong(seed):
    """Three on each of two faces, from 1 to 17 N a face: light ones pass for a magnet."""
    rng = np.random.default_rng(seed)
    face_n = np.concatenate([np.linspace(1, 17, 10), np.full(6, 17.0)])
    face, contact = np.tile([2, 2, 2, 4, 4, 4], (16, 1)), np.zeros((16, 6, 3))
    places = 12 * np.array([(-0.45, -0.45), (0.45, -0.45), (0.0, 0.45)])
    contact[:, :, :2] = np.concatenate([places + rng.uniform(-3.6, 3.6, 2) for _ in range(2)])
    contact[:, :, 2] = face_n[:, None] / 3
    rest, pressed = (magnets_field_t(SPEC, motion) for motion in (STILL, motion_of(face, contact)))
    counts = read_out(SPEC, pressed, rng) - read_out(SPEC, rest, rng).mean(axis=0)
    tracker = Tracker(inverted())
    read = [tracker.feed(frame) for frame in counts]
    assert not tracker.beside_magnet
    assert all(sets.explained[0] and sets.number[0] >= 4 for sets in read[-4:])


def nothing_seen(frames):
    counts = np.random.default_rng(5).normal(0, 60, (frames, 45))
    seen = inverted().disturbances.observed(counts)
    sets = inverted().search.judged(empty(seen, np.arange(frames), 6))
    covariance = [np.diag(sigma**2) + seen.columns @ seen.columns.T for sigma in seen.still]
    return seen, sets, counts, covariance


def test_evidence_of_a_magnet_is_that_of_normal_densities():
    """Densities by scipy: the mean over the shells, over that without a magnet, but for a constant."""
    seen, sets, counts, covariance = nothing_seen(4)
    shells = inverted().lookalike_columns
    beside = BesideMagnet(seen, shells).log_evidence(inverted().search, sets.problems)
    expected = []
    for frame, plain in zip(counts, covariance, strict=True):
        near = [multivariate_normal(cov=plain + a @ a.T).logpdf(frame) for a in shells]
        far = multivariate_normal(cov=plain).logpdf(frame)
        expected.append(np.logaddexp.reduce(near) - np.log(len(shells)) - far)
    gained = beside - sets.log_evidence
    assert_allclose(gained - gained[0], np.array(expected) - expected[0], atol=1e-6)
    assert -3 < gained[0] - expected[0] <= 0, "odds of a magnet: rare, not excluded"


def test_evidence_of_a_chip_that_lies_is_that_of_the_other_channels():
    """Densities by scipy: those of the chip's own are even over the range of counts."""
    seen, _, counts, covariance = nothing_seen(3)
    out = np.array([0, 6, 14])
    search = inverted().search
    without = search.judged(empty(seen.without(out), np.arange(3), 6))
    evidence = log_evidence_without(search, seen, out, without)
    plain = search.judged(empty(seen, np.arange(3), 6)).log_evidence
    for row, chip in enumerate(out):
        kept = np.arange(45) // 3 != chip
        others = multivariate_normal(cov=covariance[row][np.ix_(kept, kept)]).logpdf(
            counts[row, kept]
        )
        whole = multivariate_normal(cov=covariance[row]).logpdf(counts[row])
        expected = others - 3 * np.log(2 * 32767) - whole
        assert evidence[row] - plain[row] == pytest.approx(expected, abs=0.05)


def test_fewer_readings_than_a_magnet_has_unknowns_tell_nothing_of_one():
    """Nine readings of one face: without this half of two contacts there would be taken for a magnet."""
    rng, face, contact = (
        np.random.default_rng(0),
        np.full((FRAMES, 6), NONE),
        np.zeros((FRAMES, 6, 3)),
    )
    face[:, :2] = 0
    contact[:, :2, 0] = rng.uniform([-10, 3], [-3, 10], (FRAMES, 2))
    contact[:, :2, 1] = rng.uniform(-8, 8, (FRAMES, 2))
    contact[:, :2, 2] = rng.uniform(3, 7, (FRAMES, 2))
    counts = noisy_counts(inverted(), face, contact, rng, turned=False)
    counts[:, 9:] = np.nan
    frames, search = inverted().disturbances.observed(counts), inverted().search
    fit = most_probable(search.model, search.priors, frames, np.arange(FRAMES), face, contact)
    beside = BesideMagnet(frames, inverted().lookalike_columns)
    assert not beside.explains_with_fewer(search, search.judged(fit)).any()
