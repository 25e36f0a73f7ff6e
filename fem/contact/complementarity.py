"""Frictionless unilateral contact on a condensed surface compliance.

Unknowns are the pressures p_i ≥ 0 of P1 hat functions φ_i on the face. With the weak gap
g_i = ∫ φ_i (profile − depth) dA + (C p)_i ≥ 0 and p_i g_i = 0 for every i, this is a linear
complementarity problem with a symmetric positive definite C. Pressures and gaps are tested
against the same φ_i: consistent nodal forces of P2 elements vanish at vertices, so a sign
condition on those would not be one on the pressure.
"""

from __future__ import annotations

import numpy as np
import scipy.linalg
from jaxtyping import Bool, Float
from scipy.linalg.lapack import dposv  # pyright: ignore[reportAttributeAccessIssue]
from scipy.optimize import nnls

from design.errors import SolverError

_MAX_SWITCHES = 25
_TOLERANCE = 1e-10
_TOUCHES_BELOW = 0.6
"""First guess: in contact to this part of the depth (a half of it in Hertz's, more on a layer)."""


def contact_pressures(
    compliance: Float[np.ndarray, "i i"],
    profile_moments: Float[np.ndarray, "i"],
    weights: Float[np.ndarray, "i"],
    depths_mm: Float[np.ndarray, "step"],
) -> Float[np.ndarray, "step i"]:
    """Pressures (MPa) at each depth, for candidate unknowns i of one tip.

    Parameters
    ----------
    compliance : ∫ φ_i u_n dA for unit φ_j, mm³/MPa
    profile_moments : ∫ φ_i profile dA, mm³, the tip's surface above its lowest point
    weights : ∫ φ_i dA, mm²

    Raises
    ------
    SolverError
        A compliance that is not positive definite.
    """
    pressures = np.zeros((len(depths_mm), len(weights)))
    active = np.zeros(len(weights), bool)
    for step, depth in enumerate(depths_mm):
        gap = profile_moments - depth * weights
        guess = active | (profile_moments < _TOUCHES_BELOW * depth * weights)
        try:
            pressures[step], active = _solve_complementarity(compliance, gap, guess)
        except np.linalg.LinAlgError as error:
            raise SolverError(
                "contact cannot be solved: the face's compliance is not positive definite under the "
                "indenter. Use smaller mesh.surface_edge_mm, or magnets further below the surface"
            ) from error
    return pressures


def _solve_complementarity(
    compliance: np.ndarray, gap: np.ndarray, guess: Bool[np.ndarray, "i"]
) -> tuple[np.ndarray, np.ndarray]:
    """p ≥ 0, C p + gap ≥ 0, complementary: primal–dual active set, NNLS where it cycles."""
    scale = float(np.abs(gap).max())
    active = guess
    for _ in range(_MAX_SWITCHES):
        pressure = np.zeros(len(gap))
        if active.any():
            pressure[active] = _solve_positive(_block(compliance, active), -gap[active])
        violated = (compliance @ pressure + gap < -_TOLERANCE * scale) & ~active
        switched = (active & (pressure > 0)) | violated
        if (switched == active).all():
            return pressure, active
        active = switched
    return _by_least_squares(compliance, gap)


def _block(matrix: np.ndarray, chosen: Bool[np.ndarray, "i"]) -> np.ndarray:
    """Chosen rows and columns; `np.ix_` takes three to twenty times as long."""
    (index,) = np.nonzero(chosen)
    return matrix.take(index, axis=0).take(index, axis=1)


def _solve_positive(matrix: np.ndarray, right_side: np.ndarray) -> np.ndarray:
    """A⁻¹ b by LAPACK's Cholesky factorization, which overwrites A.

    The checks around `scipy.linalg.solve` cost two to ten times as much as the solution itself.
    """
    _, solution, failed = dposv(matrix.T, right_side, overwrite_a=True)
    if failed:
        raise np.linalg.LinAlgError(f"leading minor {failed} is not positive")
    return solution


def _by_least_squares(compliance: np.ndarray, gap: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
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
    for _ in range(_MAX_SWITCHES):
        pressure[:] = 0
        if active.any():
            block = _block(compliance, active)
            pressure[active] = scipy.linalg.solve(block, -gap[active], assume_a="sym")
        sunk = compliance @ pressure + gap < -_TOLERANCE * abs(gap).max()
        switched = (active & (pressure > 0)) | (sunk & ~active)
        if (switched == active).all():
            break
        active = switched
    return pressure
