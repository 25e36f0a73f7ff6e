"""Laplace's approximation about the most probable contacts: evidence and covariances."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from estimator.inversion.model.arrays import Array, diagonals, library, like, to_host
from estimator.inversion.model.forward import NONE
from estimator.inversion.priors import Bounds, Priors, flat_precision, held_between, log_density
from estimator.inversion.problems import Problems

_AT_BOUND = 1e-6
"""In mm and N: a contact nearer is held there."""


def log_evidence(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem"]:
    """Log of the posterior mass about each peak, priors included, but for the frame's constant."""
    curvature = bounded_curvature(problems, priors)
    log_volume = to_host(library(curvature).linalg.slogdet(curvature)[1])
    mass = 0.5 * (3 * problems.number * np.log(2 * np.pi) - log_volume)
    return (
        mass
        - problems.misfit
        - problems.log_spread
        + log_density(priors, problems.face, problems.contact)
    )


def log_inside(bounds: Bounds, priors: Priors, problems: Problems) -> Float[np.ndarray, "problem"]:
    """Log of the share of each peak's mass within the bounds of the model and the priors, axis by axis.

    A contact that is held at a bound would lie beyond it: where the top of a normal peak is d standard
    deviations outside, the mass inside is exp(d²/2) Φ(−d) of what Laplace's approximation makes of the
    height at the bound.
    """
    curvature = bounded_curvature(problems, priors)
    shape = problems.contact.shape
    variance = diagonals(library(curvature).linalg.inv(curvature))
    sigma = np.sqrt(to_host(variance)).reshape(shape)
    slope = to_host(problems.slope).reshape(shape)
    low, high = held_between(bounds, priors)
    mass = log_mass_between(problems.contact, low, high, sigma, slope)
    return np.where((problems.face != NONE)[..., None], mass, 0.0).sum(axis=(1, 2))


def log_mass_between(
    peak: Float[np.ndarray, "*some"],
    low: Float[np.ndarray, "..."],
    high: Float[np.ndarray, "..."],
    sigma: Float[np.ndarray, "*some"],
    slope: Float[np.ndarray, "*some"],
) -> Float[np.ndarray, "*some"]:
    """Log of the share of normal peaks that lies between bounds, with the misfit's `slope` there."""
    from scipy.special import log_ndtr

    mass = np.zeros(np.shape(peak))
    for room, out in ((peak - low, slope * sigma), (high - peak, -slope * sigma)):
        beyond = np.where(room < _AT_BOUND, np.maximum(out, 0.0), 0.0)
        mass += log_ndtr(room / sigma - beyond) + 0.5 * beyond * beyond
    return mass


def covariances(problems: Problems, priors: Priors) -> Float[np.ndarray, "problem contact 3 3"]:
    """Return covariances of x, y (mm) and force (N) of each contact, that of the others included.

    They are no wider than the priors; empty slots have the identity.
    """
    return contact_blocks(joint_covariance(problems, priors))


def joint_covariance(
    problems: Problems, priors: Priors
) -> Float[np.ndarray, "problem parameter parameter"]:
    """Return the covariance of x, y (mm) and force (N) of all contacts together."""
    return np.linalg.inv(bounded_curvature(problems, priors))


def contact_blocks(
    joint: Float[np.ndarray, "problem parameter parameter"],
) -> Float[np.ndarray, "problem contact 3 3"]:
    """Return the blocks of a joint covariance that belong to one contact each."""
    slots = joint.shape[1] // 3
    blocks = joint.reshape(-1, slots, 3, slots, 3)
    return blocks.diagonal(axis1=1, axis2=3).transpose(0, 3, 1, 2)


def bounded_curvature(
    problems: Problems, priors: Priors
) -> Float[Array, "problem parameter parameter"]:
    """Return the curvature with that of normal priors as wide as the even ones: it has an inverse."""
    flat = (problems.face != NONE)[..., None] * flat_precision(priors)
    curvature = problems.curvature + 0.0
    diagonal = diagonals(curvature)
    diagonal += like(curvature, flat.reshape(diagonal.shape))
    return curvature
