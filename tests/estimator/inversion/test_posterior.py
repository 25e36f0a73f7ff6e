"""Peak, evidence and priors of contacts on given faces."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.inversion.evidence import log_evidence
from estimator.inversion.posterior import most_probable
from estimator.inversion.priors import SPACING_SIGMA_MM
from estimator.inversion.problems import Observations, empty
from tests.support.mechanics.inverted import (
    contacts,
    expected_counts,
    frame_covariance,
    inverted,
    noisy_counts,
)


@pytest.fixture(scope="module")
def free():
    return inverted()


def seen_of(estimator, face, contact, seed=None):
    if seed is None:
        counts = expected_counts(estimator.model, face, contact)
    else:
        counts = noisy_counts(estimator, face, contact, np.random.default_rng(seed))
    return estimator.disturbances.observed(counts)


@pytest.mark.parametrize("number", [1, 2, 3])
def test_undisturbed_contacts_are_met_from_a_start_nearby(number, free):
    rng = np.random.default_rng(number)
    face, contact = contacts(rng, 20, number)
    start = contact + (face >= 0)[..., None] * rng.normal(0, [0.7, 0.7, 0.4], contact.shape)
    seen = seen_of(free, face, contact)
    found = most_probable(free.model, free.priors, seen, np.arange(20), face, start)
    there = face >= 0
    # bounds of these places are 0.05 to 1 mm: a hundredth of a millimetre is none of the noise
    assert np.median(abs(found.contact - contact)[there]) < 5e-3
    assert found.misfit.max() < 0.05


def test_a_fit_goes_on_where_a_cut_step_would_gain_nothing(free):
    """A second contact where only noise is left: its steps are cut. Ends there gained up to 5 by 0.2 mm."""
    rng, frames = np.random.default_rng(5), 60
    face, contact = contacts(rng, frames, 1)
    seen = seen_of(free, face, contact, seed=6)
    face[:, 1] = face[:, 0]
    contact[:, 1, :2], contact[:, 1, 2] = rng.uniform(-13, 13, (frames, 2)), 2.0
    given = free.model, free.priors, seen
    fitted = most_probable(*given, np.arange(frames), face, contact, rounds=1)
    # mm or N, each way in each of six coordinates
    moves = 0.2 * np.concatenate([np.eye(6), -np.eye(6)]).reshape(12, 2, 3)
    row = np.arange(frames).repeat(len(moves))
    moved = fitted.contact[row]
    moved[:, :2] += np.tile(moves, (frames, 1, 1))
    tried = most_probable(*given, row, face[row], moved, fitted.extra[row], rounds=1, steps=0)
    assert np.all(fitted.misfit - tried.misfit.reshape(frames, -1).min(axis=1) < 1.0)


def test_the_misfit_scatters_as_the_noise_says(free):
    face, contact = contacts(np.random.default_rng(6), 200, 2)
    seen = seen_of(free, face, contact, seed=7)
    found = most_probable(free.model, free.priors, seen, np.arange(200), face, contact)
    assert_allclose(2 * found.misfit.mean(), 45 - 6, rtol=0.06)


def test_the_evidence_of_one_contact_is_the_integral_over_its_places_and_forces(free):
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, 0], contact[0, 0] = 2, [3.0, -4.0, 6.0]
    seen = seen_of(free, face, contact, seed=11)
    found = most_probable(free.model, free.priors, seen, np.zeros(1, int), face, contact)
    sigma = np.sqrt(np.diagonal(np.linalg.inv(found.curvature[0]))[:3])
    axes = [np.linspace(-5, 5, 21) * s + c for s, c in zip(sigma, found.contact[0, 0], strict=True)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    expected = free.model.signals.values(np.full(len(grid), 2), grid)[:, 0]
    left = expected - seen.counts
    misfit = 0.5 * np.sum(left * np.linalg.solve(frame_covariance(seen, 0), left.T).T, axis=1)
    cell = np.prod(0.5 * sigma)
    priors = free.priors
    density = priors.number[1] / (priors.area_mm2 * np.ptp(priors.force_n))
    integral = np.log(np.exp(found.misfit[0] - misfit).sum() * cell * density) - found.misfit[0]
    assert_allclose(log_evidence(found, priors)[0], integral, atol=0.1)


def test_two_contacts_count_once_whatever_their_order(free):
    face, contact = contacts(np.random.default_rng(9), 5, 2)
    seen = seen_of(free, face, contact, seed=10)
    order = [1, 0, 2, 3, 4, 5]
    one, other = (
        most_probable(free.model, free.priors, seen, np.arange(5), face[:, o], contact[:, o])
        for o in (np.arange(6), order)
    )
    assert_allclose(log_evidence(one, free.priors), log_evidence(other, free.priors), atol=1e-2)


def test_a_contact_that_nothing_tells_costs_evidence(free):
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    seen = Observations(np.zeros((1, 45)), *[np.full((1, 45), 1e6)] * 3)
    face[0, 0], contact[0, 0] = 0, [0.0, 0.0, 3.0]
    found = most_probable(free.model, free.priors, seen, np.zeros(1, int), face, contact)
    nothing = log_evidence(empty(seen, np.zeros(1, int), 6), free.priors)
    gained = log_evidence(found, free.priors) - nothing
    # five faces alike: this one holds a fifth of what a contact anywhere would
    assert -4.0 < gained[0] < 0.0


def test_known_probes_stand_as_far_apart_as_they_are(free):
    known = inverted("known")
    assert_allclose(known.priors.spacing_mm, (15.0, 20.0))
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, :2], contact[0, :2] = 1, [[-6.0, 1.0, 5.0], [6.0, 0.0, 5.0]]
    seen = seen_of(known, face, contact, seed=11)
    found = most_probable(known.model, known.priors, seen, np.zeros(1, int), face, contact)
    other = most_probable(known.model, free.priors, seen, np.zeros(1, int), face, contact)
    apart = [np.linalg.norm(np.diff(one.contact[0, :2, :2], axis=0)) for one in (found, other)]
    assert abs(apart[0] - 15) < 3 * SPACING_SIGMA_MM < abs(apart[1] - 15)


def test_more_tips_than_any_known_probe_are_impossible():
    known = inverted("known")
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, :4] = 1
    contact[0, :4] = [[-10, -10, 3], [10, -10, 3], [10, 10, 3], [-10, 10, 3]]
    seen = seen_of(known, face, contact)
    found = most_probable(known.model, known.priors, seen, np.zeros(1, int), face, contact)
    assert log_evidence(found, known.priors)[0] == -np.inf


def test_tips_that_bear_alike_share_their_force(free):
    priors = replace(free.priors, force_spread=0.05)
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, :2], contact[0, :2] = 3, [[-9.0, -9.0, 2.0], [9.0, 9.0, 4.0]]
    sigma = np.full((1, 45), 200.0)
    seen = Observations(expected_counts(free.model, face, contact), sigma, sigma, sigma)
    loose, tied = (
        most_probable(free.model, given, seen, np.zeros(1, int), face, contact).contact[0, :2, 2]
        for given in (free.priors, priors)
    )
    assert abs(np.log(tied[1] / tied[0])) < 0.3 * abs(np.log(loose[1] / loose[0]))
