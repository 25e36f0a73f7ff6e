"""What an inversion believes and reads of a few noisy frames, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest

from estimator.inversion.evidence import covariances, log_evidence
from estimator.inversion.posterior import most_probable
from estimator.inversion.priors import log_density, widths
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import contacts, inverted, noisy_counts
from tests.support.recorded_facts import assert_on_record, told, told_whole


def on_record(section, lines):
    assert_on_record("inversion", section, lines, "estimator")


@pytest.fixture(scope="module")
def frames():
    """Two frames each of none to three contacts, and their noisy counts."""
    rng = np.random.default_rng(11)
    parts = [contacts(rng, 2, number) for number in range(4)]
    face, contact = (np.concatenate(column) for column in zip(*parts, strict=True))
    return face, contact, noisy_counts(inverted(), face, contact, rng)


@pytest.mark.parametrize("probes", ["free", "known"])
def test_beliefs_are_as_on_record(probes):
    estimator = inverted(probes)
    known = estimator.search.dictionary
    lines = [
        *told_whole("priors", estimator.priors),
        *told_whole("disturbances", estimator.disturbances),
        told("widths", widths(estimator.priors)),
        told("dictionary", known.counts),
        told("its contacts", known.contact),
        told("faces and tips", np.column_stack([known.face, known.tips])),
    ]
    on_record(f"beliefs, {probes} probes", lines)


@pytest.mark.parametrize("probes", ["free", "known"])
def test_readings_are_as_on_record(probes, frames):
    best, second = inverted(probes).read(frames[2][::2] if probes == "known" else frames[2])
    lines = [
        *told_whole("best", best),
        *told_whole("second", second),
        told("numbers", best.number),
        told("explained", best.explained),
        told("radii", best.position_radius_mm),
        told("half widths", best.force_halfwidth_n),
    ]
    on_record(f"readings, {probes} probes", lines)


def test_peaks_and_evidence_are_as_on_record(frames):
    face, contact, counts = frames
    estimator = inverted()
    seen = estimator.disturbances.observed(counts)
    found = most_probable(estimator.model, estimator.priors, seen, np.arange(8), face, contact)
    lines = [
        told("contacts", found.contact),
        told("misfit", found.misfit),
        told("curvature", found.curvature),
        told("evidence", log_evidence(found, estimator.priors)),
        told("covariances", covariances(found, estimator.priors)),
        told("density", log_density(estimator.priors, face, contact)),
    ]
    on_record("peaks", lines)


def test_contacts_followed_are_as_on_record():
    """A press that grows and slides, then a second one on another face."""
    face, contact = np.full((9, 6), -1), np.zeros((9, 6, 3))
    for row in range(1, 9):
        face[row, 0], contact[row, 0] = 2, [-4 + 0.3 * row, 3.0, min(5.0, 1.5 * row)]
        if row > 5:
            face[row, 1], contact[row, 1] = 4, [5.0, -2.0, 6.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(5))
    tracker = Tracker(inverted())
    found = [tracker.feed(frame) for frame in counts]
    lines = [line for row in (0, 3, 8) for line in told_whole(f"frame {row}", found[row])]
    on_record("followed", lines)
