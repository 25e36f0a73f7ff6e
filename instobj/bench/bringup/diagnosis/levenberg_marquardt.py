"""Levenberg–Marquardt fits of many small models side by side, which `scipy.optimize` does one by one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from jaxtyping import Float

_STEP = 1e-5
"""Step of the difference quotients, in the unknowns' own units."""
_WORTH = 0.02
"""Gain in ½|r|² below which the fit ends."""
_FIRST_DAMPING, _LEAST_DAMPING = 1e-2, 1e-9
"""Damping at the start, and at least, as shares of the diagonal."""


def many_most_probable(
    residuals: Callable[
        [Float[np.ndarray, "problem unknown"]], Float[np.ndarray, "problem residual"]
    ],
    start: Float[np.ndarray, "problem unknown"],
    iterations: int = 30,
) -> tuple[Float[np.ndarray, "problem unknown"], Float[np.ndarray, "problem"]]:
    """Minima of ½|r|² of independent problems, r whitened and with the priors among it; and ½|r|²."""
    value, here = start.copy(), residuals(start)
    cost, damping = _half(here), np.full(len(start), _FIRST_DAMPING)
    steps = _STEP * np.eye(start.shape[1])
    for _ in range(iterations):
        slope = np.stack([(residuals(value + step) - here) / _STEP for step in steps], axis=-1)
        # JᵀJ and, below, Jᵀr: p problem, r residual, x and y unknowns
        normal = np.einsum("prx,pry->pxy", slope, slope)
        # Marquardt's damping scales the diagonal, so that units of unknowns do not matter (1963).
        normal += damping[:, None, None] * normal * np.eye(start.shape[1])
        downhill = np.einsum("prx,pr->px", slope, here)
        tried = value - np.linalg.solve(normal, downhill[..., None])[..., 0]
        trial_residuals = residuals(tried)
        better = _half(trial_residuals) < cost
        gained = np.where(better, cost - _half(trial_residuals), 0.0)
        value[better], here[better] = tried[better], trial_residuals[better]
        cost = _half(here)
        damping = np.where(better, np.maximum(damping / 5, _LEAST_DAMPING), damping * 8)
        if np.all(gained < _WORTH) and np.all(better | (damping > 1e3)):
            break
    return value, cost


def _half(residual: Float[np.ndarray, "problem residual"]) -> Float[np.ndarray, "problem"]:
    return 0.5 * np.einsum("pr,pr->p", residual, residual)
