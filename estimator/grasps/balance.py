"""Balance of a grasp: net wrench with its covariance, equilibrium, and the jaws' asymmetry."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import brentq
from scipy.stats import chi2

from estimator.grasps.track import Placed

_SIDE = 0.5
"""Least cosine between a contact's normal and the grasp's axis for it to belong to a side."""


def net_wrench(contacts: Placed) -> Float[np.ndarray, "6"]:
    """Force (N) and moment (N mm) about the object's origin; a tangential force that was not read counts
    as none."""
    # contact c, of i and j of its three coordinates
    push = np.einsum("cij,cj->ci", contacts.axes, np.nan_to_num(contacts.force_n))
    return np.concatenate([push.sum(axis=0), np.cross(contacts.point_mm, push).sum(axis=0)])


def wrench_covariance(contacts: Placed, friction: float) -> Float[np.ndarray, "6 6"]:
    """Covariance of the net wrench, of first order in the errors of places.

    A tangential force that was not read may lie anywhere within the friction disc μF: mean 0 and
    variance (μF)²/4 along each of two axes, as of a uniform disc. Errors of contacts are independent but
    for their common factor.
    """
    covariance = np.zeros((6, 6))
    for point, axes, force, errors in zip(
        contacts.point_mm, contacts.axes, contacts.force_n, contacts.covariance, strict=True
    ):
        unread = np.isnan(force)
        read = np.where(unread, 0.0, force)
        spread = errors.copy()
        spread[2:, 2:][np.diag(unread)] += (friction * read[2]) ** 2 / 4
        # columns: d/dx, d/dy of r × f, then d/dforce of (f, r × f)
        moved = np.cross(axes[:, :2].T, axes @ read).T
        lever = np.cross(point, axes.T).T
        slope = np.block([[np.zeros((3, 2)), axes], [moved, lever]])
        covariance += slope @ spread @ slope.T
    # a common factor scales the whole wrench: w → (1 + s) w
    wrench = net_wrench(contacts)
    return covariance + contacts.scale_error**2 * np.outer(wrench, wrench)


def equilibrium_misfit(
    force_n: Float[np.ndarray, "3"], covariance: Float[np.ndarray, "3 3"], weight_n: float
) -> float:
    """Misfit χ² of a net force to the weight in whatever direction fits best; 3 degrees of freedom
    for no weight, 1 with one, as the direction takes two.

    Minimises (f + W u)ᵀ C⁻¹ (f + W u) over unit vectors u by its secular equation: in the
    eigenbasis of C⁻¹ u = −W a f/(W² a + λ) with the largest root λ of |u| = 1 (Golub & Van Loan, Matrix
    Computations, 4th ed., section 6.2.1).
    """
    value, vector = np.linalg.eigh(covariance)
    # a floor, so that what is known exactly is not divided by 0
    stiff = 1 / np.maximum(value, 1e-9 * max(float(value[-1]), 1e-9))
    load = vector.T @ force_n
    if weight_n <= 0:
        return float(stiff @ load**2)

    def excess(shift: float) -> float:
        return float(np.sum((weight_n * stiff * load / (weight_n**2 * stiff + shift)) ** 2) - 1)

    low = -(weight_n**2) * float(stiff.min()) * (1 - 1e-9)
    high = float(weight_n * np.linalg.norm(stiff * load)) + 1.0
    if excess(low) <= 0:  # no pull along the softest axis: any direction there does
        direction = -weight_n * stiff * load / (weight_n**2 * stiff + low)
        softest = int(np.argmin(stiff))
        rest = max(0.0, 1 - float(np.sum(np.delete(direction, softest) ** 2)))
        direction[softest] = np.sqrt(rest)
    else:
        shift = float(brentq(excess, low, high))  # pyright: ignore[reportArgumentType]
        direction = -weight_n * stiff * load / (weight_n**2 * stiff + shift)
    return float(stiff @ (load + weight_n * direction) ** 2)


def equilibrium_p(misfit: float, weight_n: float) -> float:
    """Chance of a misfit as large in equilibrium."""
    return float(chi2.sf(misfit, 1 if weight_n > 0 else 3))


def drawn_in_balance(
    contacts: Placed,
    drawn: list[Placed],
    normals: Float[np.ndarray, "draw 3"],
    friction: float,
    weight_n: float,
    pull: Float[np.ndarray, "3"],
) -> list[Placed]:
    """Return draws of contacts corrected by what is known of their sum: a held object balances.

    Each contact read by itself may be too high, so that the largest of several mostly is, and errors drawn
    about it add to that once more. Forces that must balance cannot all be. A draw is corrected as by kriging,
    x − C Hᵀ (k S)⁻¹ (H x + W + ε), with `normals` for ε (Journel & Huijbregts, Mining Geostatistics, 1978,
    VII.A); W is `pull` times the weight at rest. S is the covariance of the sum, of errors and of what was
    not read: friction, and the weight's direction where `pull` is NaN. k is the misfit over what errors alone
    would give, at least 1: a sum that does not balance within them is believed so much less, as with an
    unknown weight (James & Stein, 1961).
    """
    errors, axes = contacts.covariance[:, 2:, 2:], contacts.axes
    unread = np.isnan(contacts.force_n) * (friction * contacts.force_n[:, 2:]) ** 2 / 4
    # contact c, of i and j of the object's axes; p and q of the contact's own
    read = np.einsum("cip,cpq,cjq->ij", axes, errors, axes)
    whole = read + np.einsum("cip,cp,cjp->ij", axes, unread, axes)
    load_n = weight_n * pull
    if not np.isfinite(pull).all():
        # of a vector of one length in any direction: mean 0, a third of its square along each axis
        load_n, whole = np.zeros(3), whole + weight_n**2 / 3 * np.eye(3)
    inverse = np.linalg.pinv(whole, hermitian=True)
    usual = float(np.trace(inverse @ read))
    if not usual > 0:  # exact forces
        return drawn
    net = net_wrench(contacts)[:3] + load_n
    excess = max(1.0, float(net @ inverse @ net) / usual)
    gain = errors @ axes.transpose(0, 2, 1) @ inverse / excess
    value, vector = np.linalg.eigh(excess * whole - read)
    noise = normals @ (vector * np.sqrt(value.clip(0.0))).T
    corrected = []
    for draw, shift in zip(drawn, noise, strict=True):
        force = draw.force_n - gain @ (net_wrench(draw)[:3] + load_n + shift)
        force[:, 2] = force[:, 2].clip(0.0)
        corrected.append(replace(draw, force_n=force))
    return corrected


def grasp_axis(contacts: Placed) -> Float[np.ndarray, "3"]:
    """Direction that most of the squeeze lies along: the leading eigenvector of Σ F² n nᵀ.

    Its largest component is positive, so that sides keep their names.
    """
    # contact c, components i and j
    scatter = np.einsum(
        "c,ci,cj->ij", contacts.force_n[:, 2] ** 2, contacts.inward, contacts.inward
    )
    axis = np.linalg.eigh(scatter)[1][:, -1]
    return axis * np.sign(axis[np.argmax(abs(axis))])


def side_forces_n(contacts: Placed, axis: Float[np.ndarray, "3"]) -> tuple[float, float]:
    """Forces along the axis of the contacts that push with it, and of those against it."""
    share = contacts.inward @ axis
    push = contacts.force_n[:, 2] * share
    return float(push[share > _SIDE].sum()), float(-push[share < -_SIDE].sum())


def asymmetry(contacts: Placed, axis: Float[np.ndarray, "3"]) -> float:
    """Difference of the sides' forces over their sum: 0 for jaws that press alike, ±1 for one alone."""
    ahead, back = side_forces_n(contacts, axis)
    return (ahead - back) / (ahead + back) if ahead + back > 0 else float("nan")
