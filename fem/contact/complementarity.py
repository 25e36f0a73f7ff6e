"""Frictionless unilateral contact on a condensed surface compliance.

Unknowns are the pressures p_i ≥ 0 of P1 hat functions φ_i on the face. With the weak gap
g_i = ∫ φ_i (profile − depth) dA + (C p)_i ≥ 0 and p_i g_i = 0 for every i, this is a linear
complementarity problem with a symmetric positive definite C. Pressures and gaps are tested
against the same φ_i: consistent nodal forces of P2 elements vanish at vertices, so a sign
condition on those would not be one on the pressure.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg
from jaxtyping import Bool, Float, Int
from scipy.linalg.lapack import (
    dposv,  # pyright: ignore[reportAttributeAccessIssue]
    dpotrs,  # pyright: ignore[reportAttributeAccessIssue]
)
from scipy.optimize import nnls

from design.errors import SolverError

MAX_SWITCHES = 25
"""Rounds in which unknowns switch between contact and none, at most."""
_TOLERANCE = 1e-10
"""Share of the largest gap that is rounding."""
_TOUCHES_BELOW = 0.6
"""First guess: in contact to this part of the depth (a half of it in Hertz's, more on a layer)."""


@dataclass(frozen=True)
class Contact:
    """Pressures (MPa) at each depth, and how firmly each unknown is in contact or out of it.

    `firmness_mm3` is p_i C_ii in contact and −g_i out of it: it changes little from place to place.
    """

    pressure_mpa: Float[np.ndarray, "step i"]
    firmness_mm3: Float[np.ndarray, "step i"]


def contact_pressures(
    compliance: Float[np.ndarray, "i i"],
    profile_moments: Float[np.ndarray, "i"],
    weights: Float[np.ndarray, "i"],
    depths_mm: Float[np.ndarray, "step"],
) -> Float[np.ndarray, "step i"]:
    """The pressures of `contact`."""
    return contact(compliance, profile_moments, weights, depths_mm).pressure_mpa


def contact(
    compliance: Float[np.ndarray, "i i"],
    profile_moments: Float[np.ndarray, "i"],
    weights: Float[np.ndarray, "i"],
    depths_mm: Float[np.ndarray, "step"],
    nearby: Contact | None = None,
) -> Contact:
    """Pressures (MPa) at each depth, for candidate unknowns i of one tip.

    Parameters
    ----------
    compliance : ∫ φ_i u_n dA for unit φ_j, mm³/MPa
    profile_moments : ∫ φ_i profile dA, mm³, the tip's surface above its lowest point
    weights : ∫ φ_i dA, mm²
    nearby : the same tip at the same depths elsewhere, which says where to begin (the pressures are
        the same: a third fewer systems are solved)

    Raises
    ------
    SolverError
        A compliance that is not positive definite.
    """
    pressures = np.zeros((len(depths_mm), len(weights)))
    firmness, own_compliance = np.zeros_like(pressures), compliance.diagonal()
    active = np.zeros(len(weights), bool)
    for step, depth in enumerate(depths_mm):
        gap = profile_moments - depth * weights
        if nearby is None:
            guess = active | (profile_moments < _TOUCHES_BELOW * depth * weights)
        else:
            guess = _expected(nearby, firmness, step)
        try:
            pressures[step], after, active = _solve_complementarity(compliance, gap, guess)
        except np.linalg.LinAlgError as error:
            raise SolverError(
                "contact cannot be solved: the face's compliance is not positive definite under the "
                "indenter. Use smaller mesh.surface_edge_mm, or magnets further below the surface"
            ) from error
        firmness[step] = pressures[step] * own_compliance - after
    return Contact(pressures, firmness)


def _expected(nearby: Contact, firmness: np.ndarray, step: int) -> Bool[np.ndarray, "i"]:
    """Return what touches: as nearby, corrected by how the steps before differed from there."""
    nearby_firmness = nearby.firmness_mm3
    expected = nearby_firmness[step]
    if step:
        off = firmness[step - 1] - nearby_firmness[step - 1]
        expected = expected + off
    if step > 1:
        expected += (off - (firmness[step - 2] - nearby_firmness[step - 2])) / 2
    return expected > 0


def _solve_complementarity(
    compliance: np.ndarray, gap: np.ndarray, guess: Bool[np.ndarray, "i"]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """p ≥ 0, C p + gap ≥ 0, complementary: primal–dual active set, NNLS where it cycles.

    Returns p, C p + gap, and where p > 0.
    """
    least = -_TOLERANCE * float(np.abs(gap).max())
    active = guess
    for _ in range(MAX_SWITCHES):
        pressure = np.zeros(len(gap))
        (index,) = np.nonzero(active)
        if len(index):
            pressure[index], _ = solve_positive(_block(compliance, index), -gap[index])
        after = compliance @ pressure + gap
        switched = after < least
        switched[index] = pressure[index] > 0
        if (switched == active).all():
            return pressure, after, active
        active = switched
    pressure, active = _solve_least_squares(compliance, gap)
    return pressure, compliance @ pressure + gap, active


def _block(matrix: np.ndarray, index: Int[np.ndarray, "chosen"]) -> np.ndarray:
    """Chosen rows and columns; `np.ix_` takes three to twenty times as long."""
    return matrix.take(index, axis=0).take(index, axis=1)


def solve_positive(matrix: np.ndarray, right_side: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A⁻¹ b by LAPACK's Cholesky factorization, which overwrites A, and the factor.

    The checks around `scipy.linalg.solve` cost two to ten times as much as the solution itself.
    """
    factor, solution, failed = dposv(matrix.T, right_side, lower=True, overwrite_a=True)
    if failed:
        raise np.linalg.LinAlgError(f"leading minor {failed} is not positive")
    return solution, factor


def solve_factored(factor: np.ndarray, right_side: np.ndarray) -> np.ndarray:
    """A⁻¹ b by the factor of `solve_positive`."""
    return dpotrs(factor, right_side, lower=True)[0]


def _solve_least_squares(compliance: np.ndarray, gap: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The same problem as min |Lᵀp + L⁻¹ gap|, p ≥ 0, with C = L Lᵀ: slower, never cycles."""
    lower = np.linalg.cholesky(compliance)
    pressure, _ = nnls(lower.T, -scipy.linalg.solve_triangular(lower, gap, lower=True))
    return pressure, pressure > 0


def complementary_pressures(
    compliance: np.ndarray, gap: np.ndarray, active: np.ndarray
) -> np.ndarray:
    """p ≥ 0, C p + gap ≥ 0, complementary, by the primal–dual active set.

    Unlike `contact_pressures` this takes an indefinite C: under its contact pressures alone, a body
    that deforms largely may be unstable where the touching sphere holds it. A set that cycles is
    left to the next Newton iteration.
    """
    pressure = np.zeros(len(gap))
    for _ in range(MAX_SWITCHES):
        pressure[:] = 0
        if active.any():
            block = _block(compliance, np.flatnonzero(active))
            pressure[active] = scipy.linalg.solve(block, -gap[active], assume_a="sym")
        sunk = compliance @ pressure + gap < -_TOLERANCE * abs(gap).max()
        switched = (active & (pressure > 0)) | (sunk & ~active)
        if (switched == active).all():
            break
        active = switched
    return pressure
