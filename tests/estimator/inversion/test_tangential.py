"""Tangential forces: integrated out while contacts are looked for, then read."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.inversion.inversion import inversion
from estimator.inversion.posterior import most_probable
from estimator.inversion.readings import tangential_forces
from estimator.inversion.storage import load_inversion, save_inversion
from tests.support.mechanics.inverted import (
    PULLING,
    SHARE,
    contacts,
    frame_covariance,
    inverted,
    noisy_counts,
    presses,
    shear_of,
)

FRAMES = 150


@pytest.fixture(scope="module")
def pulling():
    return inversion(PULLING, *presses(), model_error=0.0, force_error=0.0, shear=shear_of(PULLING))


@pytest.fixture(scope="module")
def pulled(pulling):
    """Single contacts that pull sideways as hard as is believed, and their frames."""
    rng = np.random.default_rng(2)
    face, contact = contacts(rng, FRAMES, 1, (4.0, 8.0))
    force = 0.5 * SHARE * contact[:, 0, 2:] * rng.standard_normal((FRAMES, 2))
    per_n = pulling.model.shear.values(face[:, 0], contact[:, 0])[:, 0].reshape(FRAMES, 2, -1)
    counts = noisy_counts(pulling, face, contact, rng) + np.einsum("fa,fac->fc", force, per_n)
    return face, contact, force, counts


def away_mm(found, face, contact, faces):
    right = (found.number == 1) & (found.face[:, 0] == faces[face[:, 0]])
    assert right.mean() > 0.9
    return right, np.linalg.norm(found.xy_mm[right, 0] - contact[right, 0, :2], axis=1)


def test_tangential_forces_are_read_with_the_uncertainty_told(pulling, pulled):
    face, contact, force, counts = pulled
    found, _ = pulling.read(counts)
    right, _ = away_mm(found, face, contact, pulling.model.signals.faces)
    error = (found.tangential_n[:, 0] - force)[right]
    assert np.abs(error).mean() < 0.3 * np.abs(force[right]).mean()
    told = np.abs(error / found.tangential_sigma_n[right, 0])
    assert 0.5 < np.median(told) < 0.9  # of a normal error 0.67
    assert 1.3 < np.quantile(told, 0.9) < 2.1  # 1.64
    assert np.mean(found.explained) > 0.95


def test_places_of_pulled_contacts_are_wrong_for_who_takes_them_for_frictionless(pulling, pulled):
    face, contact, counts = pulled[0][:10], pulled[1][:10], pulled[3][:10]
    faces = pulling.model.signals.faces
    _, loose = away_mm(pulling.read(counts)[0], face, contact, faces)
    plain, _ = inverted().read(counts)
    assert np.mean(plain.explained) < 0.3
    assert np.isnan(plain.tangential_n).all()
    nearest = np.nanmin(np.linalg.norm(plain.xy_mm - contact[:, :1, :2], axis=2), axis=1)
    assert loose.mean() < 0.5 * nearest.mean()


def test_misfit_and_spread_are_those_of_the_widened_covariance(pulling, pulled):
    face, contact, _, counts = pulled
    seen, rows = pulling.disturbances.observed(counts), np.arange(FRAMES)
    model = pulling.model
    found = most_probable(model, pulling.priors, seen, rows, face, contact, steps=1)
    left = model.singles(found.face, found.contact)[:, :, 0].sum(axis=1) - counts
    pulls = model.pulls(found.face, found.contact)[:, 0]
    for row in range(0, FRAMES, 19):
        noise = frame_covariance(seen, row)
        covariance = noise + pulls[row].T @ pulls[row]
        misfit = 0.5 * left[row] @ np.linalg.solve(covariance, left[row])
        assert_allclose(found.misfit[row], misfit, rtol=1e-6)
        spread = 0.5 * (np.linalg.slogdet(covariance)[1] - np.linalg.slogdet(noise)[1])
        assert_allclose(found.log_spread[row], spread, rtol=1e-9)


def test_torch_fits_pulled_contacts_alike(pulling, pulled):
    face, contact, counts = (part[:10] for part in (pulled[0], pulled[1], pulled[3]))
    seen, given = pulling.disturbances.observed(counts), (np.arange(10), face, contact)
    one, other = (
        most_probable(
            pulling.model.moved_to(kind), pulling.priors, seen.moved_to(kind), *given, steps=2
        )
        for kind in (counts, torch.empty(0, dtype=torch.float64))
    )
    assert isinstance(other.slope, torch.Tensor)
    for name in ("contact", "misfit", "log_spread", "curvature"):
        wanted = getattr(one, name)
        near = 1e-4 * np.abs(wanted).max()
        assert_allclose(getattr(other.to_host(), name), wanted, rtol=1e-4, atol=near)


def test_mean_and_deviation_are_those_of_the_joint_posterior(pulling, pulled):
    """Beside one linear least-squares problem of place, force and both tangential forces."""
    face, contact, _, counts = pulled
    seen, rows = pulling.disturbances.observed(counts), np.arange(FRAMES)
    model, priors = pulling.model, pulling.priors
    found = most_probable(model, priors, seen, rows, face, contact)
    force, sigma = tangential_forces(model, priors, seen, found)
    singles = model.singles(found.face, found.contact)[:, 0]
    pulls = model.pulls(found.face, found.contact)[:, 0]
    for row in range(0, FRAMES, 19):
        white = np.linalg.inv(np.linalg.cholesky(frame_covariance(seen, row)))
        design = np.vstack([singles[row, 1:], pulls[row]]) @ white.T
        wide = np.diag([1e-6, 1e-6, 1e-6, 1.0, 1.0])  # contacts: next to no prior
        posterior = np.linalg.inv(design @ design.T + wide)
        left = white @ (counts[row] - singles[row, 0])
        mean = posterior @ design @ left
        scale = 0.5 * SHARE * found.contact[row, 0, 2]
        assert_allclose(sigma[row, 0], scale * np.sqrt(np.diag(posterior)[3:]), rtol=0.02)
        assert_allclose(force[row, 0], scale * mean[3:], atol=0.3 * sigma[row, 0].max())


def test_a_file_keeps_the_table_of_tangential_forces(tmp_path, pulling, pulled):
    save_inversion(pulling, tmp_path / "contacts.nc")
    again = load_inversion(tmp_path / "contacts.nc")
    first, second = (one.read(pulled[3][:5])[0] for one in (pulling, again))
    assert_allclose(first.tangential_n, second.tangential_n, equal_nan=True)


def test_tangential_forces_need_their_signals():
    with pytest.raises(InputError, match=r"tangential_share = 0\.5 needs"):
        inversion(PULLING, *presses(), model_error=0.0, force_error=0.0)


def test_a_frictionless_table_gives_the_readings_of_before(pulling, pulled):
    face, contact = pulled[0][:10], pulled[1][:10]
    counts = noisy_counts(pulling, face, contact, np.random.default_rng(5))
    frictionless = replace(pulling, model=replace(pulling.model, shear=None))
    one, other = (model.read(counts)[0] for model in (frictionless, inverted()))
    assert_allclose(one.xy_mm, other.xy_mm, equal_nan=True)
