"""Mean demagnetising factors: by how much a magnet's own field opposes its polarization.

N is −μ0 H / J along the axis, averaged over a body of uniform polarization J (the magnetometric
factor): 0 of a long rod, 1 of a thin plate.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from math import asinh, cos, hypot, pi, sin, sqrt

import numpy as np
from scipy.integrate import quad


def cylinders_factor(cylinders: Sequence[tuple[float, float]], height_mm: float) -> float:
    """N of a body that is a sum of coaxial cylinders (radius in mm, weight) of one height.

    One less the mean of B / J. For a disk that mean is Nagaoka's coefficient of a current sheet
    (Joseph, J. Appl. Phys. 37, 1966), for a ring it has three such terms.
    """
    pairs = [(w * v, r, s) for r, w in cylinders for s, v in cylinders]
    flux = sum(weight * _linked_flux_mm3(r, s, height_mm) for weight, r, s in pairs)
    return 1 - flux / (pi * height_mm * sum(weight * r**2 for r, weight in cylinders))


@lru_cache(maxsize=1024)
def _linked_flux_mm3(radius: float, other_radius: float, height: float) -> float:
    """Integral of B / J of a full cylinder over another on the same axis, of the same height.

    Neumann's integral over two current sheets, of which the one over the angle between them is
    left: angle = π t³ takes away the logarithm where the two are one.
    """

    def integrand(t: float) -> float:
        angle = pi * t**3
        apart = hypot(radius - other_radius, 2 * sqrt(radius * other_radius) * sin(angle / 2))
        sheets = height * asinh(height / apart) - hypot(height, apart) + apart
        return 6 * pi * t**2 * cos(angle) * sheets

    return radius * other_radius * quad(integrand, 0, 1, epsabs=0, epsrel=1e-10, limit=200)[0]


def block_factor(x: float, y: float, z: float) -> float:
    """N along z of a block of these edges (Aharoni, J. Appl. Phys. 83, 1998, equation 1)."""
    a, b, c = x / 2, y / 2, z / 2
    ab, bc, ca = np.hypot(a, b), np.hypot(b, c), np.hypot(c, a)
    abc = np.hypot(ab, c)
    logarithms = (
        (c * c - b * b) / (b * c) * np.arcsinh(a / bc)
        + (c * c - a * a) / (a * c) * np.arcsinh(b / ca)
        + b / c * np.arcsinh(a / b)
        + a / c * np.arcsinh(b / a)
        - c / a * np.arcsinh(b / c)
        - c / b * np.arcsinh(a / c)
    )
    powers = (
        (a**3 + b**3 - 2 * c**3)
        + (a * a + b * b - 2 * c * c) * abc
        + 3 * c * c * (ca + bc)
        - (ab**3 + bc**3 + ca**3)
    )
    angle = 2 * np.arctan(a * b / (c * abc))
    return float((logarithms + powers / (3 * a * b * c) + angle) / pi)
