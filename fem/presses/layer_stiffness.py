"""Force of a sphere on a flat layer of silicone bonded to rigid ground, in closed form."""

from __future__ import annotations

import numpy as np


def sphere_on_layer_n(
    modulus_mpa: float, poisson_ratio: float, radius_mm: float, thickness_mm: float, depth_mm: float
) -> float:
    """Return the force (N) at a depth, without friction.

    Hertz's force with the layer's correction in powers of χ = √(R d) / h, the solution of Dimitriadis
    et al., Biophys. J. 82 (2002) 2798, equations 12 and 13, for a bonded layer. Magnets and edges are
    not in it: of a small cube's presses the median stiffness at 1 mm is 7 % higher.
    """
    ratio = poisson_ratio
    chi = np.sqrt(radius_mm * depth_mm) / thickness_mm
    # bonded layer: α0 and β0 of the paper
    alpha = -(1.2876 - 1.4678 * ratio + 1.3442 * ratio**2) / (1 - ratio)
    beta = (0.6387 - 1.0277 * ratio + 1.5164 * ratio**2) / (1 - ratio)
    terms = (
        1.0,
        -2 * alpha / np.pi,
        4 * alpha**2 / np.pi**2,
        -8 / np.pi**3 * (alpha**3 + 4 * np.pi**2 / 15 * beta),
        16 * alpha / np.pi**4 * (alpha**3 + 3 * np.pi**2 / 5 * beta),
    )
    # Hertz: 4 E √R d^1.5 / (3 (1 − ν²))
    hertz = 4 * modulus_mpa * np.sqrt(radius_mm) * depth_mm**1.5 / (3 * (1 - ratio**2))
    return float(hertz * np.polynomial.polynomial.polyval(chi, terms))
