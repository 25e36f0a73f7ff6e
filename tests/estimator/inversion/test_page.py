"""What an inversion believes and reads of a few noisy frames: a page that a person can judge."""

import numpy as np
import pytest

from estimator.inversion.evidence import covariances, log_evidence
from estimator.inversion.posterior import most_probable
from estimator.inversion.priors import log_density, widths
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import contacts, inverted, noisy_counts
from tests.support.physics_pages import assert_page, chosen


@pytest.fixture(scope="module")
def frames():
    """Two frames each of none to three contacts, and their noisy counts."""
    rng = np.random.default_rng(11)
    parts = [contacts(rng, 2, number) for number in range(4)]
    face, contact = (np.concatenate(column) for column in zip(*parts, strict=True))
    return face, contact, noisy_counts(inverted(), face, contact, rng)


def of_readings(probes, counts):
    estimator = inverted(probes)
    yield f"widths of priors, {probes} probes (mm, N)", widths(estimator.priors)
    yield "dictionary (counts)", estimator.search.dictionary.counts
    best, second = estimator.read(counts)
    yield f"numbers of contacts, {probes} probes", best.number
    yield from chosen(best, "xy_mm", "force_n", "odds", "p_value", "position_radius_mm")
    yield from chosen(best, "force_halfwidth_n")
    yield "second best, places (mm)", second.xy_mm


def of_peaks(face, contact, counts):
    estimator = inverted()
    seen = estimator.disturbances.observed(counts)
    peaks = most_probable(estimator.model, estimator.priors, seen, np.arange(8), face, contact)
    yield from chosen(peaks, "contact", "misfit", "curvature")
    yield "evidence (ln)", log_evidence(peaks, estimator.priors)
    yield "covariances (mm², N²)", covariances(peaks, estimator.priors)
    yield "density of priors (ln)", log_density(estimator.priors, face, contact)


def of_tracking():
    """A press that grows and slides, then a second one on another face."""
    face, contact = np.full((9, 6), -1), np.zeros((9, 6, 3))
    for row in range(1, 9):
        face[row, 0], contact[row, 0] = 2, [-4 + 0.3 * row, 3.0, min(5.0, 1.5 * row)]
        if row > 5:
            face[row, 1], contact[row, 1] = 4, [5.0, -2.0, 6.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(5), turned=False)
    tracker = Tracker(inverted())
    followed = [tracker.feed(frame) for frame in counts]
    yield "contacts followed", [float(np.sum(one.face >= 0)) for one in followed]
    yield "the last one's places (mm)", followed[-1].xy_mm


def test_the_page_of_inversion(frames):
    _, _, counts = frames
    lines = [*of_readings("free", counts), *of_readings("known", counts[::2])]
    assert_page("estimator/inversion", [*lines, *of_peaks(*frames), *of_tracking()])
