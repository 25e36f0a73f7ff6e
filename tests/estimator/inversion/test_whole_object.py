"""The estimator of a whole object by hand: what it believes, which channels it reads, and how it reads
frames in parts."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.inversion import inversion as module
from estimator.inversion import readings
from estimator.inversion.inversion import Inversion, contact_priors, probe_spacing_mm
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.priors import Priors
from estimator.inversion.problems import BLIND, Observations, Problems
from estimator.inversion.readings import ContactSets

CUBE = ObjectSpec(name="cube")
FACES = np.array([1, 3, 4])


def model(**changes):
    """Tables from (−12, −9) to (10, 11) mm and up to 8 N on three faces, of 18 channels."""
    made = object.__new__(ContactModel)
    made.__dict__.update(
        spec=CUBE.changed(inversion=CUBE.inversion.changed(**changes)),
        signals=SimpleNamespace(faces=FACES, coefficients=np.zeros((1, 18))),
        bounds=(np.array([-12.0, -9.0, 0.0]), np.array([10.0, 11.0, 8.0])),
    )
    return made


def test_any_number_of_contacts_is_as_likely_and_tips_stand_a_diameter_apart():
    found = contact_priors(model(contacts=3, probes="free"))
    assert_allclose(found.number, [0.25] * 4)
    assert (found.faces, found.most) == (3, 3)
    assert_allclose(found.area_mm2, 3 * 22 * 20)
    assert found.force_n == (0.2, 8.0)
    assert_allclose(found.apart_mm, 2 * CUBE.indenter.radius_mm)
    assert found.force_spread is None
    assert found.spacing_mm == ()
    known = contact_priors(model(contacts=2, probes="known"))
    assert_allclose(known.number, [1 / 3] * 3)
    assert known.force_spread == 0.3
    assert known.spacing_mm == probe_spacing_mm(CUBE.indenter.radius_mm)
    paired = contact_priors(model(contacts=3, jaws=True))
    assert paired == replace(found, paired=True)
    assert not found.paired
    assert not known.paired
    both = contact_priors(model(contacts=2, probes="known", jaws=True))
    assert both == replace(known, paired=True)


def test_probes_are_the_paper_s_and_grow_with_large_tips():
    assert_allclose(probe_spacing_mm(5.0), [15, 20])
    assert_allclose(probe_spacing_mm(3.0), [15, 20])
    assert_allclose(probe_spacing_mm(6.0), [18, 24])


def made(noise, search=None, force_error=0.0):
    estimator = object.__new__(Inversion)
    told = SimpleNamespace(
        noise_counts=noise,
        force_error=force_error,
        observed=lambda counts, averaged=None: (counts, averaged),
    )
    estimator.__dict__.update(model=model(), disturbances=told, priors=None)
    if search is not None:
        estimator.__dict__["search"] = search
    return estimator


def test_channels_are_named_face_by_face_and_blind_ones_left_out():
    noise = np.full(18, 10.0)
    noise[[2, 7, 17]] = BLIND
    noise[5] = 2 * BLIND
    found = made(noise)
    every = [(face, sensor, axis) for face in (1, 3, 4) for sensor in (0, 1) for axis in range(3)]
    told = [k for k in range(18) if k not in (2, 5, 7, 17)]
    assert found.live_rows.tolist() == told
    assert list(found.channels) == [every[k] for k in told]


def test_frames_are_read_a_hundred_at_a_time_in_order_with_their_own_means(monkeypatch):
    """The second best answer of a frame that has none is the best, of odds 0."""
    given, progress = [], []

    class Found:
        def __init__(self, counts):
            self.rows = np.arange(len(counts))
            self.odds = np.concatenate([0.6 + 0 * self.rows, 0.3 + 0 * self.rows])
            self.log_evidence = np.log(self.odds)
            self.problems = SimpleNamespace(
                select=lambda rows: SimpleNamespace(to_host=lambda: rows)
            )

        def best(self):
            return self.rows

        def second(self, best):
            return np.where(best % 2 == 0, best, best + len(best))

    def contacts(seen):
        given.append(seen)
        return Found(seen[0])

    monkeypatch.setattr(
        Inversion, "read_part", lambda *given: Inversion.read_once.__wrapped__(*given)[:2]
    )
    monkeypatch.setattr(module, "Hypotheses", lambda problems, log_evidence: None)
    monkeypatch.setattr(Inversion, "search_for", lambda self, frames: self.search)
    monkeypatch.setattr(module, "among_sets", lambda found, best, priors: (found, best))
    monkeypatch.setattr(
        Inversion,
        "reading",
        lambda self, seen, problems, odds, error, spread=None: (
            seen[0][:, 0],
            problems,
            odds,
            spread,
        ),
    )
    learnt = SimpleNamespace(learn=lambda seen, problems: None)
    monkeypatch.setattr(Inversion, "error_share", lambda self: learnt)
    monkeypatch.setattr(module.ContactSets, "joined", staticmethod(lambda parts: list(parts)))
    estimator = made(np.ones(18), SimpleNamespace(contacts=contacts))
    counts = np.arange(250.0)[:, None] * np.ones(18)
    averaged = np.arange(250)
    best, second = Inversion.read.__wrapped__(estimator, counts, averaged, progress.append)
    assert progress == [100, 200, 250]
    assert [len(part[0]) for part in given] == [100, 100, 50]
    assert_array_equal(np.concatenate([part[0] for part in best]), np.arange(250.0))
    assert_array_equal(np.concatenate([part[1] for part in given]), averaged)
    assert_allclose(np.concatenate([part[2] for part in best]), 0.6)
    odds = np.concatenate([part[2] for part in second])
    assert_allclose(odds, np.tile([0.0, 0.3], 125))
    # the best answer's regions are those among all sets found, the next one's its own
    assert all(part[3][1] is part[1] is part[3][0].rows for part in best)
    assert all(part[3] is None for part in second)
    Inversion.read.__wrapped__(estimator, counts[:3])
    assert given[-1][1] is None
    with pytest.raises(InputError, match="no frame"):
        Inversion.read.__wrapped__(estimator, counts[:0])


def test_regions_widen_by_an_error_common_to_all_forces():
    covariance = np.tile(np.diag([0.04, 0.09, 0.16]), (1, 2, 1, 1))
    pulls = np.full((1, 2, 2), np.nan)
    sets = ContactSets(
        np.array([[3, 4]]), np.zeros((1, 2, 2)), np.array([[2.0, 5.0]]), covariance, pulls, pulls,
        np.ones(1), np.array([1e-3]), np.full(1, -1), *[np.zeros((1, 0))] * 2, pulls,
        np.full((1, 2, 2, 2), np.nan),
    )  # fmt: skip
    found = sets.with_force_error(0.1)
    assert_allclose(found.covariance[0, :, 2, 2], [0.16 + 0.04, 0.16 + 0.25])
    assert_allclose(found.covariance[..., :2, :2], covariance[..., :2, :2])
    assert_allclose(sets.force_halfwidth_n, 1.6448536 * 0.4, rtol=1e-6)
    assert sets.explained.all()
    assert sets.number.tolist() == [2]


@pytest.mark.parametrize("slots", [1, 2])
def test_tangential_forces_are_those_of_the_joint_normal_posterior(slots):
    """Of contacts (x, y, F) and pulls t ~ N(0, 1) together: mean at the contacts found, deviation with
    theirs, both in units of a pull's own deviation."""
    rng = np.random.default_rng(6)
    channels, sigma = 12, rng.uniform(0.5, 2, (1, 12))
    singles = rng.normal(size=(1, slots, 4, channels))
    pulls = rng.normal(size=(1, slots, 2, channels))
    pull_sigma = np.array([[2.0, 0.5]])[:, :slots]
    stub = SimpleNamespace(
        channels=channels, singles=lambda face, contact: singles,
        pulls=lambda face, contact: pulls, pull_sigma_n=lambda contact: pull_sigma,
    )  # fmt: skip
    counts, extra = rng.normal(size=(1, channels)), rng.normal(size=(1, channels))
    seen = Observations(counts, sigma, sigma, sigma)
    jacobian = (singles[0, :, 1:] / sigma[0]).reshape(3 * slots, channels)
    across = (pulls[0] / sigma[0]).reshape(2 * slots, channels)
    own = np.eye(2 * slots) + across @ across.T
    curvature = jacobian @ jacobian.T - jacobian @ across.T @ np.linalg.solve(
        own, across @ jacobian.T
    )
    problems = Problems(
        np.zeros(1, int), np.zeros((1, slots), int), np.ones((1, slots, 3)), extra, np.zeros(1),
        np.zeros((1, 3 * slots)), curvature[None], np.zeros(1),
    )  # fmt: skip
    priors = Priors((0.25,) * 4, 2, 800.0, (0.5, 10.5))
    mean, deviation = readings.tangential_forces.__wrapped__(stub, priors, seen, problems)
    flat = np.tile(12 / np.array([20.0, 20.0, 10.0]) ** 2, slots)
    joint = np.block(
        [[jacobian @ jacobian.T + np.diag(flat), jacobian @ across.T], [across @ jacobian.T, own]]
    )
    spread = np.linalg.inv(joint)[3 * slots :, 3 * slots :]
    left = (counts[0] - extra[0] - singles[0, :, 0].sum(axis=0)) / sigma[0]
    scale = np.repeat(pull_sigma[0], 2)
    assert_allclose(mean[0].ravel(), scale * np.linalg.solve(own, across @ left))
    assert_allclose(deviation[0].ravel(), scale * np.sqrt(np.diag(spread)))
