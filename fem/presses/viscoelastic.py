"""Relaxation of press forces: a Prony series in time on top of the elastic solution.

In a homogeneous body of constant Poisson ratio a linear viscoelastic force is the hereditary
integral of the elastic one at the same depths (correspondence principle; for contact that grows,
Lee and Radok, J. Appl. Mech. 27 (1960) 438):

    F(t) = ∫ [1 − Σ g_i (1 − exp(−(t − s)/τ_i))] dF_e(s)

Displacements at prescribed depths, so all magnet motions, remain the elastic ones.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from design.spec.silicone import PronyTerm


def relaxed_force_n(
    elastic_force_n: Float[np.ndarray, "*press time"],
    time_s: Float[np.ndarray, "time"],
    terms: Sequence[PronyTerm],
) -> Float[np.ndarray, "*press time"]:
    """Force (N) that is felt, from a history of forces computed with the instantaneous modulus.

    Exact for forces that are linear between the times (any spacing) and at rest before the first.
    Never below zero: the tip lifts off a surface that lags. While a contact shrinks the integral
    is an approximation, because the lagging surface leaves the tip earlier: for raised-cosine
    presses of 4 s, relaxation times of 0.3 to 5 s and fractions of 0.1, 0.2 and 0.4 it is off by
    up to 2, 4 and 6 % of the peak against Ting's solution (J. Appl. Mech. 33 (1966) 845).
    """
    if not terms:
        return elastic_force_n
    step_s, rise = np.diff(time_s), np.diff(elastic_force_n)
    force = elastic_force_n * (1 - sum(fraction for fraction, _ in terms))
    for fraction, decay_s in terms:
        memory = _fading_memory(elastic_force_n[..., :1], rise, step_s, decay_s)
        force = force + fraction * memory
    return np.maximum(force, 0.0)


def _fading_memory(
    first: np.ndarray, rise: np.ndarray, step_s: np.ndarray, decay_s: float
) -> np.ndarray:
    """∫ exp(−(t − s)/τ) dF_e(s) at every time, by one step from each to the next."""
    decay = np.exp(-step_s / decay_s)
    gain = -np.expm1(-step_s / decay_s) * decay_s / step_s
    memory = [first[..., 0]]
    for index in range(len(step_s)):
        memory.append(decay[index] * memory[-1] + gain[index] * rise[..., index])
    return np.stack(memory, axis=-1)
