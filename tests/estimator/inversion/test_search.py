"""Contacts from scratch, and what is told of them."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.stats import kstest

from estimator.inversion.model.dictionary import probe_tips_mm
from estimator.inversion.posterior import most_probable
from estimator.inversion.readings import ContactSets
from estimator.metrics.contacts import possible_distance_mm
from tests.support.mechanics.inverted import (
    contacts,
    expected_counts,
    inverted,
    labelled_frames,
    noisy_counts,
)


@pytest.fixture(scope="module")
def free():
    return inverted()


def paired_mm(found, face, contact, faces):
    """Distance of every true contact to the nearest found one on its face."""
    away = []
    for row, slot in np.argwhere(face >= 0):
        mine = found.face[row] == faces[face[row, slot]]
        gap = np.linalg.norm(found.xy_mm[row, mine] - contact[row, slot, :2], axis=1)
        away.append(gap.min(initial=99.0))
    return np.array(away)


def possible_mm(estimator, face, contact):
    """What the Cramér–Rao bound leaves in each frame."""
    number = np.where(face >= 0, estimator.model.signals.faces[face], 0)
    place = np.where((face >= 0)[..., None], contact, np.nan)
    frames = labelled_frames(number, place[..., :2], place[..., 2])
    return possible_distance_mm(estimator, frames)


@pytest.fixture(scope="module")
def read(free):
    """Frames of none to two contacts of 2 to 8 N, and what is found in them."""
    rng = np.random.default_rng(1)
    parts = [contacts(rng, frames, number) for number, frames in ((0, 60), (1, 60), (2, 40))]
    face, contact = (np.concatenate(column) for column in zip(*parts, strict=True))
    best, second = free.read(noisy_counts(free, face, contact, rng))
    return face, contact, best, second


def test_as_many_contacts_are_found_as_there_are(read):
    face, _, best, _ = read
    true = (face >= 0).sum(axis=1)
    assert np.all(best.number[true == 0] == 0)
    assert np.mean(best.number[true == 1] == 1) >= 0.95
    assert np.mean(best.number[true == 2] == 2) >= 0.85


def test_they_are_where_they_are_within_the_region_told(read, free):
    face, contact, best, _ = read
    faces = free.model.signals.faces
    right = best.number == (face >= 0).sum(axis=1)
    away = paired_mm(best.select(np.flatnonzero(right)), face[right], contact[right], faces)
    radius = best.position_radius_mm[right]
    assert away.mean() < 1.15 * np.nanmean(possible_mm(free, face[right], contact[right]))
    assert 0.8 < np.mean(away <= radius[np.isfinite(radius)]) < 0.97


def test_odds_are_those_of_being_right(read):
    face, _, best, second = read
    right = best.number == (face >= 0).sum(axis=1)
    assert abs(best.odds.mean() - right.mean()) < 0.08
    assert np.all(best.odds + second.odds <= 1 + 1e-9)
    assert np.all(second.odds <= best.odds + 1e-9)


def test_p_values_are_even_where_the_contacts_are_right(read):
    face, _, best, _ = read
    right = best.number == (face >= 0).sum(axis=1)
    assert kstest(best.p_value[right], "uniform").pvalue > 1e-3


def test_what_no_contact_explains_is_told(free):
    rng = np.random.default_rng(3)
    face, contact = contacts(rng, 12, 1)
    counts = noisy_counts(free, face, contact, rng)
    fine, _ = free.read(counts)
    broken = counts.copy()
    broken[:, 7] += 2000  # a channel gone wrong
    near_magnet = counts + rng.normal(0, 800, (12, 15)).repeat(3, axis=1)
    assert np.all(fine.p_value > 1e-4)
    left_out, _ = free.read(broken[:6])
    assert np.mean(left_out.chip_out == 2) >= 0.9
    assert np.all(left_out.explained[left_out.chip_out == 2])
    assert np.all(free.read(near_magnet[:4])[0].p_value < 1e-3)


def with_model_error(free, error):
    told = replace(free.disturbances, model_error=np.full(45, error))
    return replace(free, disturbances=told)


def test_an_object_that_is_not_the_drawing_is_neither_at_rest_nor_explained(free):
    rng = np.random.default_rng(8)
    face, contact = contacts(rng, 10, 2, (6.0, 9.0))
    counts = noisy_counts(free, face, contact, rng)
    other = counts.reshape(10, 15, 3)[:, rng.permutation(15), ::-1].reshape(10, 45)
    found, _ = with_model_error(free, 1.0).read(other)
    assert not found.explained.any()
    assert np.all(found.number >= 1)
    assert np.nanmedian(found.position_radius_mm) > 3.0


def test_a_model_as_wrong_as_tolerances_make_it_explains_its_own_presses(free):
    rng = np.random.default_rng(9)
    face, contact = contacts(rng, 10, 1, (4.0, 8.0))
    counts = noisy_counts(free, face, contact, rng) * rng.normal(1, 0.1, (10, 45))
    assert with_model_error(free, 0.17).read(counts)[0].explained.all()


def test_a_channel_without_a_reading_says_nothing(free):
    rng = np.random.default_rng(4)
    face, contact = contacts(rng, 10, 1, (5.0, 8.0))
    counts = noisy_counts(free, face, contact, rng)
    counts[:, 4] = np.nan
    best, _ = free.read(counts)
    assert np.mean(best.number == 1) >= 0.9


def test_the_mean_of_a_hold_says_more_than_a_frame(free):
    rng = np.random.default_rng(5)
    face, contact = contacts(rng, 15, 1, (1.0, 3.0))
    one, _ = free.read(expected_counts(free.model, face, contact))
    many, _ = free.read(expected_counts(free.model, face, contact), np.full(15, 100))
    both = (one.number == 1) & (many.number == 1)
    assert np.all(many.position_radius_mm[both, 0] < one.position_radius_mm[both, 0])


def test_known_probes_are_found_whole():
    known = inverted("known")
    rng = np.random.default_rng(6)
    face, contact = np.full((12, 6), -1), np.zeros((12, 6, 3))
    for row in range(12):
        tips = 2 + row % 2
        xy = rng.uniform(-1, 1, 2) + probe_tips_mm(tips, rng.uniform(0, 6), known.priors)
        face[row, :tips], contact[row, :tips, :2] = row % 5, xy
        contact[row, :tips, 2] = rng.uniform(4, 6)
    best, _ = known.read(noisy_counts(known, face, contact, rng))
    assert np.mean(best.number == (face >= 0).sum(axis=1)) >= 0.9
    away = paired_mm(best, face, contact, known.model.signals.faces)
    assert away.mean() < np.nanmean(possible_mm(known, face, contact))


@pytest.mark.parametrize("ratio", [0.0, 0.2, 0.6, 1.0])
def test_the_radius_holds_nine_of_ten_places(ratio):
    draws = np.random.default_rng(7).standard_normal((400_000, 2)) * [2.0, 2.0 * ratio]
    covariance = np.zeros((1, 1, 3, 3))
    covariance[0, 0, 0, 0], covariance[0, 0, 1, 1] = 4.0, (2.0 * ratio) ** 2
    one, zero = np.ones((1, 1)), np.zeros((1, 1, 2))
    found = ContactSets(
        one.astype(int),
        zero,
        one,
        covariance,
        zero,
        zero,
        one[0],
        one[0],
        np.full(1, -1),
        *[np.zeros((1, 0))] * 2,
        np.full((1, 1, 2), np.nan),
        np.full((1, 1, 2, 2), np.nan),
    )
    assert_allclose(
        np.mean(np.linalg.norm(draws, axis=1) <= found.position_radius_mm[0, 0]), 0.9, atol=0.012
    )


def test_the_best_set_gets_the_contact_that_it_lacks_when_it_is_revisited(free):
    rng = np.random.default_rng(10)
    face, contact = contacts(rng, 4, 3, (5.0, 8.0))
    seen = free.disturbances.observed(noisy_counts(free, face, contact, rng))
    lacking = np.where(np.arange(6) < 2, face, -1)
    search = free.search
    start = most_probable(free.model, free.priors, seen, np.arange(4), lacking, contact)
    found = search.revisited(seen, search.judged(start))
    best = found.problems.select(found.best())
    assert np.array_equal(np.sort(best.face, axis=1), np.sort(face, axis=1))
