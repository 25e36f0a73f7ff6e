"""Linear elastic constants, from auxetic lattices to nearly incompressible silicones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

LARGEST_POISSON_RATIO = 0.499999
"""Beyond it ν is taken as this: the factorization needs a pivot for every pressure."""


@dataclass(frozen=True)
class LameConstants:
    """Shear modulus μ (MPa) and 1/λ (1/MPa): infinite at ν = 0, negative below."""

    shear_modulus_mpa: float
    inverse_lambda_per_mpa: float


def lame_constants(youngs_modulus_mpa: float, poisson_ratio: float) -> LameConstants:
    """μ = E / (2(1 + ν)) and 1/λ = (1 + ν)(1 − 2ν) / (E ν), finite up to ν = 0.5 but for ν = 0.

    ν above 0.499999 counts as 0.499999: the compliance of the paper's shell falls by less than
    1e-5 from there to 0.5 (it falls by 2.4 % from 0.49 to 0.5).

    Raises
    ------
    ValueError
        ν outside (−1, 0.5] or E not positive.
    """
    if not (-1 < poisson_ratio <= 0.5 and youngs_modulus_mpa > 0):
        raise ValueError(
            "linear elasticity needs E > 0 and −1 < ν ≤ 0.5; got "
            f"E = {youngs_modulus_mpa:g} MPa, ν = {poisson_ratio:g}"
        )
    nu, e = min(poisson_ratio, LARGEST_POISSON_RATIO), youngs_modulus_mpa
    inverse = (1 + nu) * (1 - 2 * nu) / (e * nu) if nu else np.inf
    return LameConstants(e / (2 * (1 + nu)), inverse)
