"""Readings of a frame: contacts with their uncertainty, their odds, and whether they explain it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.frames.dataset import NO_FACE
from estimator.inversion.evidence import covariances, joint_covariance
from estimator.inversion.explained import UNEXPLAINED
from estimator.inversion.jaws import JawFit
from estimator.inversion.model.arrays import diagonals
from estimator.inversion.model.columns import Columns
from estimator.inversion.model.forward import NONE, ContactModel
from estimator.inversion.posterior import used_slots
from estimator.inversion.priors import Priors, flat_precision
from estimator.inversion.problems import Observations, Problems
from estimator.inversion.search import Hypotheses

COVERAGE = 0.9
_LEAST_ODDS = 1e-3
"""Sets less probable do not widen the regions."""


@dataclass(frozen=True)
class ContactSets(Columns):
    """A set of contacts for every frame; empty slots have `face` 0 and NaN elsewhere.

    Attributes
    ----------
    face : (frame, contact) face numbers
    xy_mm, force_n : (frame, contact, 2), (frame, contact), in the face's frame, and normal force; of a
        jaw its centre of pressure and net force
    covariance : (frame, contact, 3, 3) of x, y (mm) and force (N) of each contact, with what is uncertain
        of the others and, from scratch, of the set
    tangential_n, tangential_sigma_n : (frame, contact, 2), along x and y of the face, and their
        standard deviations; NaN where contacts are taken for frictionless
    odds : (frame,) posterior probability of as many contacts on each face, among all numbers found, and of
        tips where jaws may have pressed; 1 of jaws
    p_value : (frame,) chance of a misfit as large if the set were true; a frame far below 0.001 is
        explained by no contact that the model knows; 0 where a magnet near by is more probable
    chip_out : (frame,) chip that was not believed, as the row of its sensor among all of the object;
        `NONE` where all were
    since_zero, since_zero_sigma : (frame, unknown) what changed since the zero and is no contact, in
        the order and units of `Disturbances.nuisances`, and its standard deviations; NaN where jaws are read
    tilt_deg : (frame, contact, 2) tilt of a jaw about x and y of its face; NaN for a tip
    size_mm : (frame, contact, 2, 2) edges along x and y of what a jaw covers of its face, and their
        standard deviations; NaN for a tip
    """

    face: Int[np.ndarray, "frame contact"]
    xy_mm: Float[np.ndarray, "frame contact 2"]
    force_n: Float[np.ndarray, "frame contact"]
    covariance: Float[np.ndarray, "frame contact 3 3"]
    tangential_n: Float[np.ndarray, "frame contact 2"]
    tangential_sigma_n: Float[np.ndarray, "frame contact 2"]
    odds: Float[np.ndarray, "frame"]
    p_value: Float[np.ndarray, "frame"]
    chip_out: Int[np.ndarray, "frame"]
    since_zero: Float[np.ndarray, "frame unknown"]
    since_zero_sigma: Float[np.ndarray, "frame unknown"]
    tilt_deg: Float[np.ndarray, "frame contact 2"]
    size_mm: Float[np.ndarray, "frame contact axis 2"]

    def with_force_error(self, relative: float) -> ContactSets:
        """Return the sets with forces also wrong by a common relative error."""
        covariance = self.covariance.copy()
        covariance[..., 2, 2] += (relative * self.force_n) ** 2
        return replace(self, covariance=covariance)

    @property
    def jaws(self) -> Bool[np.ndarray, "frame"]:
        """Return which frames are read as jaws, not as tips."""
        return np.isfinite(self.tilt_deg[:, 0, 0])

    @property
    def explained(self) -> Bool[np.ndarray, "frame"]:
        """Frames whose signals the contacts can give."""
        return self.p_value >= UNEXPLAINED

    @property
    def number(self) -> Int[np.ndarray, "frame"]:
        """Return the number of contacts."""
        return np.sum(self.face != NO_FACE, axis=1)

    @property
    def position_radius_mm(self) -> Float[np.ndarray, "frame contact"]:
        """Return the radius of the circle that holds the contact location with a probability of 90 %.

        The error is normal with standard deviations σ1 ≥ σ2. Between the line (σ2 = 0: 1.645 σ1) and
        the circle (2.146 σ1) the radius is right within 1 %.
        """
        from scipy.stats import chi2, norm

        variance = np.linalg.eigvalsh(np.nan_to_num(self.covariance[..., :2, :2]))
        large = np.sqrt(np.maximum(variance[..., 1], 0.0))
        ratio = np.divide(
            variance[..., 0], variance[..., 1], out=np.zeros_like(large), where=large > 0
        )
        line, circle = norm.ppf(0.5 + COVERAGE / 2), np.sqrt(chi2.ppf(COVERAGE, 2))
        radius = large * np.sqrt(line**2 + (circle**2 - line**2) * np.clip(ratio, 0.0, 1.0))
        return np.where(self.face != NO_FACE, radius, np.nan)

    @property
    def force_halfwidth_n(self) -> Float[np.ndarray, "frame contact"]:
        """Half the interval that holds the normal force with a probability of 90 %."""
        from scipy.stats import norm

        return norm.ppf(0.5 + COVERAGE / 2) * np.sqrt(self.covariance[..., 2, 2])

    @property
    def size_halfwidth_mm(self) -> Float[np.ndarray, "frame contact"]:
        """Half the interval that holds either edge of a jaw with a probability of 90 %."""
        from scipy.stats import norm

        return norm.ppf(0.5 + COVERAGE / 2) * self.size_mm[..., 1].max(axis=2)


def contact_sets(
    model: ContactModel,
    priors: Priors,
    observations: Observations,
    problems: Problems,
    odds: Float[np.ndarray, "frame"],
    p_value: Float[np.ndarray, "frame"],
    covariance: Float[np.ndarray, "frame contact 3 3"],
    joint: Float[np.ndarray, "frame parameter parameter"],
) -> ContactSets:
    """Contacts of one problem per frame, in the order of the problems, with their `joint_covariance`.
    Changes since the zero are in standard deviations of their priors."""
    filled = problems.face != NONE
    pulls = np.full((2, *filled.shape, 2), np.nan)
    if model.shear is not None:
        forces = np.stack(tangential_forces(model, priors, observations, problems))
        pulls = np.where(filled[..., None], forces, np.nan)
    return ContactSets(
        np.where(filled, model.signals.faces[problems.face], NO_FACE),
        np.where(filled[..., None], problems.contact[..., :2], np.nan),
        np.where(filled, problems.contact[..., 2], np.nan),
        np.where(filled[..., None, None], covariance, np.nan),
        pulls[0],
        pulls[1],
        odds,
        p_value,
        np.full(len(filled), NONE),
        *changes_since_zero(model, observations, problems, joint),
        np.full((*filled.shape, 2), np.nan),
        np.full((*filled.shape, 2, 2), np.nan),
    )


def jaw_set(fit: JawFit, tips: ContactSets) -> ContactSets:
    """Return a frame that was read as these `tips` as jaws: one contact for each of them."""
    count = len(fit.faces)
    columns = [np.full_like(column, np.nan) if column.dtype.kind == "f" else column.copy()
               for column in tips._columns()]  # fmt: skip
    jaws = ContactSets(*columns)
    jaws.face[:], jaws.face[0, :count] = NO_FACE, fit.faces
    jaws.xy_mm[0, :count], jaws.force_n[0, :count] = fit.values[:, :2], fit.values[:, 2]
    jaws.covariance[0, :count], jaws.tilt_deg[0, :count] = fit.covariance[:, :3, :3], fit.tilt_deg
    size_sigma = np.sqrt(fit.covariance.diagonal(axis1=1, axis2=2)[:, 3:])
    jaws.size_mm[0, :count] = np.stack([fit.values[:, 3:], size_sigma], axis=2)
    jaws.odds[:], jaws.p_value[:] = 1.0, fit.p_value
    return jaws


def doubted(tips: ContactSets, jaws: ContactSets, share: float) -> ContactSets:
    """Return a frame's tips, as uncertain as they are where `jaws` have a `share` of the probability.

    The force of a jaw and its variance are shared out evenly among the tips of its face, so that their sum
    holds them; a tip where no jaw presses may bear nothing.
    """
    covariance, pressed = tips.covariance.copy(), tips.face[0]
    for slot in np.flatnonzero(pressed != NO_FACE):
        alike = pressed == pressed[slot]
        tip = np.array([*tips.xy_mm[0, slot], tips.force_n[0, alike].sum()])
        away, spread = np.array([0.0, 0.0, tips.force_n[0, slot]]), np.zeros((3, 3))
        for jaw in np.flatnonzero(jaws.face[0] == pressed[slot]):  # one at most
            # n variances of a share sum up to the whole: σ²/n each, of (J − T)²/n too
            scale = np.array([1.0, 1.0, alike.sum() ** -0.5])
            away = scale * ([*jaws.xy_mm[0, jaw], jaws.force_n[0, jaw]] - tip)
            spread = np.outer(scale, scale) * jaws.covariance[0, jaw]
        mixed = share * (spread + np.outer(away, away))
        covariance[0, slot] = (1 - share) * covariance[0, slot] + mixed
    return replace(tips, covariance=covariance, odds=tips.odds * (1 - share))


def among_sets(
    hypotheses: Hypotheses, best: Int[np.ndarray, "frame"], priors: Priors
) -> Float[np.ndarray, "frame contact 3 3"]:
    """Covariances of the contacts of each frame's best set about where they are, over all sets, by share.

    In another set a contact is the nearest one on its face; sets without one there say nothing of it.
    """
    rows = np.flatnonzero(hypotheses.share > _LEAST_ODDS)
    sets, share = hypotheses.problems.select(rows).to_host(), hypotheses.share[rows]
    of_best = hypotheses.problems.select(best[sets.frame])
    face, contact = of_best.face[:, :, None], of_best.contact[:, :, None]
    away = np.linalg.norm((sets.contact[:, None] - contact)[..., :2], axis=3)
    away[(face == NONE) | (face != sets.face[:, None])] = np.inf
    nearest, each = away.argmin(axis=2), np.arange(len(rows))[:, None]
    gone = sets.contact[each, nearest] - of_best.contact
    square = covariances(sets, priors)[each, nearest] + gone[..., None] * gone[..., None, :]
    weight = np.where(np.isfinite(away.min(axis=2)), share[:, None], 0.0)[..., None, None]
    total, norm = np.zeros((len(best), *square.shape[1:])), np.zeros((len(best), *weight.shape[1:]))
    np.add.at(total, sets.frame, weight * square)
    np.add.at(norm, sets.frame, weight)
    return np.where(norm > 0, total / np.where(norm > 0, norm, 1.0), np.eye(3))


def widened(
    covariance: Float[np.ndarray, "frame contact 3 3"],
    factor: Float[np.ndarray, "frame"],
    priors: Priors,
) -> Float[np.ndarray, "frame contact 3 3"]:
    """Return covariances times a factor from 1 on, no wider than the priors."""
    rows = np.flatnonzero(factor > 1)
    wide = covariance.copy()
    # Normal priors as wide as the even ones, as in `bounded_curvature`: precisions add up.
    prior = np.diag(flat_precision(priors))
    precision = np.linalg.inv(covariance[rows] * factor[rows, None, None, None])
    wide[rows] = np.linalg.inv(precision + prior)
    return wide


def changes_since_zero(
    model: ContactModel,
    observations: Observations,
    problems: Problems,
    joint: Float[np.ndarray, "problem parameter parameter"],
) -> tuple[Float[np.ndarray, "problem k"], Float[np.ndarray, "problem k"]]:
    """Nuisances of each frame in standard deviations of their priors: posterior mean at the contacts
    found, and its standard deviation with what is uncertain of the contacts."""
    used, columns = used_slots(problems.face), observations.shared
    unknowns, parameters = columns.shape[-1], 3 * used
    singles = model.singles(problems.face[:, :used], problems.contact[:, :used])
    rows = np.empty((len(singles), unknowns + 1 + parameters, model.channels))
    rows[:, :unknowns] = columns.T
    rows[:, unknowns] = observations.counts[problems.frame] - problems.extra
    rows[:, unknowns] -= singles[:, :, 0].sum(axis=1)
    rows[:, unknowns + 1 :] = singles[:, :, 1:].reshape(len(rows), parameters, -1)
    white_rows = observations.white.select(problems.frame)(rows)
    # With r = A t + noise and t ~ N(0, 1) the mean is AᵀΣ⁻¹r, the covariance 1 − AᵀΣ⁻¹A; Σ⁻¹ = WᵀW.
    products = white_rows[:, :unknowns] @ white_rows.swapaxes(1, 2)
    carried = products[:, :, unknowns + 1 :]
    of_contacts = (carried @ joint[:, :parameters, :parameters] * carried).sum(axis=2)
    variance = 1 - diagonals(products[:, :, :unknowns]) + of_contacts
    return products[:, :, unknowns], np.sqrt(variance.clip(0.0))


def tangential_forces(
    model: ContactModel, priors: Priors, observations: Observations, problems: Problems
) -> tuple[Float[np.ndarray, "problem contact 2"], Float[np.ndarray, "problem contact 2"]]:
    """Along x and y of each contact's face, N, and their standard deviations.

    Those of the posterior mean at the contacts found, with what is uncertain of the contacts; errors
    of simulated presses are 1.15 times the deviations (rms; 300 presses of a synthetic object).
    """
    slots = problems.face.shape[1]
    face, contact, white = (
        problems.face,
        problems.contact,
        observations.white.select(problems.frame),
    )
    singles = model.singles(face, contact)
    pulls = white(model.pulls(face, contact).reshape(len(face), 2 * slots, model.channels))
    residual = observations.counts[problems.frame] - problems.extra - singles[:, :, 0].sum(axis=1)
    jacobian = white(singles[:, :, 1:].reshape(len(face), 3 * slots, model.channels))
    posterior_covariance = np.linalg.inv(np.eye(2 * slots) + pulls @ pulls.transpose(0, 2, 1))
    mean = (posterior_covariance @ (pulls @ white(residual[:, None]).transpose(0, 2, 1)))[..., 0]
    carried = posterior_covariance @ pulls @ jacobian.transpose(0, 2, 1)
    contacts = joint_covariance(problems, priors)
    covariance = posterior_covariance + carried @ contacts @ carried.transpose(0, 2, 1)
    deviation = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    scale = model.pull_sigma_n(contact)[..., None]
    shape = (*face.shape, 2)
    return scale * mean.reshape(shape), scale * deviation.reshape(shape)
