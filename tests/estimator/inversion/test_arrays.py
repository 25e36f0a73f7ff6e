"""Contacts read by torch's tensors beside those by NumPy's arrays, as a graphics card reads them."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.inversion import inversion as reading
from estimator.inversion.evidence import log_evidence
from estimator.inversion.posterior import most_probable
from estimator.inversion.search import Search
from tests.support.mechanics.inverted import SPEC, contacts, inverted, noisy_counts

TENSOR = torch.empty(0, dtype=torch.float64)
STEEL = {"position_mm": [0, 28, 0], "normal": [0, -1, 0]}
STRENGTHS = tuple(np.linspace(1.1, 1.4, SPEC.magnets.count).tolist())


@pytest.fixture(scope="module")
def frames():
    """Counts of frames of one to three contacts."""
    rng = np.random.default_rng(3)
    parts = [contacts(rng, 2, number) for number in (1, 2, 3)]
    face, contact = (np.concatenate(column) for column in zip(*parts, strict=True))
    return noisy_counts(inverted(), face, contact, rng)


def sorted_contacts(found):
    """Faces, places and forces of each set, in one order."""
    columns = [found.face[..., None], found.xy_mm, found.force_n[..., None]]
    rows = np.concatenate(columns, axis=2)
    return np.stack([row[np.lexsort(row[:, 1::-1].T)] for row in rows])


def test_many_frames_are_read_on_a_card_with_the_same_contacts_and_few_are_not(frames, monkeypatch):
    free = replace(inverted())
    asked = []
    monkeypatch.setattr(reading, "card_tensor", lambda: asked.append(1) or TENSOR)
    by_numpy = free.read(frames)
    assert not asked
    monkeypatch.setattr(reading, "MANY_FRAMES", len(frames))
    monkeypatch.setattr(reading, "FRAMES_ON_A_CARD", 4)
    by_torch = free.read(frames)
    assert asked
    assert isinstance(free.search_for(len(frames)).reference, torch.Tensor)
    assert free.search_for(len(frames)) is free.search_for(len(frames))
    assert free.search_for(len(frames) - 1) is free.search
    for one, other in zip(by_numpy, by_torch, strict=True):
        assert_allclose(sorted_contacts(other), sorted_contacts(one), atol=0.02)
        assert_allclose(other.odds, one.odds, atol=1e-3)
        assert_allclose(other.p_value, one.p_value, atol=1e-3)
        assert isinstance(other.covariance, np.ndarray)


def test_what_is_read_in_a_frame_does_not_depend_on_the_frames_beside_it(frames):
    together = inverted().read(frames)[0]
    for row in (1, 4):
        alone = inverted().read(frames[row : row + 1])[0]
        beside = together.select(np.array([row]))
        assert_allclose(sorted_contacts(beside), sorted_contacts(alone), atol=1e-4)
        assert_allclose(beside.odds, alone.odds, atol=1e-5)


@pytest.mark.parametrize("probes", ["free", "known"])
def test_one_fit_is_the_same_to_rounding(probes):
    """Tips that overlap, or stand as known probes have them and bear alike; frames at rest among them."""
    rng, model = np.random.default_rng(5), inverted().model
    asked = SPEC.changed(inversion=SPEC.inversion.changed(probes=probes))
    priors = reading.contact_priors(replace(model, spec=asked))
    face, contact = contacts(rng, 6, 3)
    face[:3, :3], contact[1:3, 1, :2] = 2, contact[1:3, 0, :2] + 3.0
    face[5] = -1
    seen = inverted().disturbances.observed(noisy_counts(inverted(), face, contact, rng))
    given = np.arange(6), face, contact
    by_numpy, by_torch = (
        most_probable(model.moved_to(kind), priors, seen.moved_to(kind), *given, rounds=2, steps=2)
        for kind in (seen.sigma, TENSOR)
    )
    assert isinstance(by_torch.curvature, torch.Tensor)
    evidence = log_evidence(by_torch, priors)
    by_torch = by_torch.to_host()
    for name in ("face", "contact", "extra", "misfit", "slope", "curvature", "log_spread"):
        one, other = getattr(by_numpy, name), getattr(by_torch, name)
        assert_allclose(other, one, rtol=1e-4, atol=1e-4 * np.abs(one).max(initial=1e-9))
    assert_allclose(evidence, log_evidence(by_numpy, priors), rtol=1e-4)


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"magnets": SPEC.magnets.changed(remanence_t=STRENGTHS)},
        {"environment": {"steel_plates": [STEEL]}},
    ],
    ids=["plain", "several remanences", "steel"],
)
def test_what_contacts_do_to_each_other_is_the_same(changes):
    model = replace(inverted().model, spec=SPEC.changed(**changes))
    face, contact = contacts(np.random.default_rng(6), 4, 3)
    wanted = model.interaction(face, contact)
    there = model.moved_to(TENSOR)
    found = there.interaction(torch.as_tensor(face), torch.as_tensor(contact))
    assert isinstance(found, torch.Tensor)
    assert_allclose(found.numpy(), wanted, atol=1e-6 * np.abs(wanted).max())


def test_presses_to_begin_with_are_the_same(frames):
    estimator = inverted()
    seen, searches = estimator.disturbances.observed(frames), []
    for kind in (seen.sigma, TENSOR):
        search = Search(estimator.model.moved_to(kind), estimator.priors)
        start = most_probable(
            search.model, search.priors, seen.moved_to(kind), np.arange(2),
            np.array([[0, -1, -1], [1, 2, -1]]), np.full((2, 3, 3), 2.0), rounds=1, steps=1,
        )  # fmt: skip
        gain, scale = search.dictionary.gains_of(search.model, seen.moved_to(kind), start)
        added = search.dictionary.added(search.model, seen.moved_to(kind), start, False)
        searches.append([np.asarray(part) for part in (gain, scale, *added)])
    for one, other in zip(*searches, strict=True):
        assert_allclose(other, one, rtol=1e-3, atol=1e-3)
