"""Linear elastic constants, from auxetic lattices to nearly incompressible silicones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from design.errors import InputError

LARGEST_POISSON_RATIO = 0.499999
"""Beyond it ν is taken as this: the factorization needs a pivot for every pressure."""


@dataclass(frozen=True)
class LameConstants:
    """Shear modulus μ (MPa) and 1/λ (1/MPa): infinite at ν = 0, negative below."""

    shear_modulus_mpa: float
    inverse_lambda_per_mpa: float


def lame_constants(youngs_modulus_mpa: float, poisson_ratio: float) -> LameConstants:
    """Shear modulus and 1/λ of an isotropic elastic solid.

    μ = E / (2(1 + ν)) and 1/λ = (1 + ν)(1 − 2ν) / (E ν). ν above 0.499999 counts as 0.499999: the
    compliance of the paper's shell falls by less than 1e-5 from there to 0.5.

    Parameters
    ----------
    youngs_modulus_mpa : float
        E, MPa.
    poisson_ratio : float
        ν, in (−1, 0.5].

    Returns
    -------
    LameConstants
        `shear_modulus_mpa` (MPa) and `inverse_lambda_per_mpa` (1/MPa): infinite at ν = 0.

    Raises
    ------
    InputError
        ν outside (−1, 0.5] or E not positive.

    Examples
    --------
    >>> import instobj
    >>> instobj.fem.lame_constants(0.3, 0.25)
    LameConstants(shear_modulus_mpa=0.12, inverse_lambda_per_mpa=8.333333333333334)
    """
    if not (-1 < poisson_ratio <= 0.5 and youngs_modulus_mpa > 0):
        raise InputError(
            "linear elasticity needs E > 0 and −1 < ν ≤ 0.5; got "
            f"E = {youngs_modulus_mpa:g} MPa, ν = {poisson_ratio:g}"
        )
    nu, e = min(poisson_ratio, LARGEST_POISSON_RATIO), youngs_modulus_mpa
    inverse = (1 + nu) * (1 - 2 * nu) / (e * nu) if nu else np.inf
    return LameConstants(e / (2 * (1 + nu)), inverse)
