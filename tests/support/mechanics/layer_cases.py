"""A rigid punch or sphere on a layer bonded below, by its integral equation: no finite elements.

A pressure of wave number ξ moves the surface by 2 L(ξh)/(E* ξ), L in `_transform`,
and a tip of contact radius a gives, with g = 1 − L and G(u) = ∫₀^∞ g(ξh) cos ξu dξ,
    φ(t) − (1/π) ∫₀^a (G(t − s) + G(t + s)) φ(s) ds = φ₀(t),      F = 2 E* ∫₀^a φ dt,
φ₀ = δ under a flat punch and δ − t artanh(t/R) under a sphere, whose φ(a) = 0 (Lebedev & Ufliand,
PMM 22 (1958) 442; Hayes, Keer, Herrmann & Mockros, J. Biomechanics 5 (1972) 541).
"""

from functools import cache

import numpy as np
from scipy.optimize import brentq

_POINTS = 40


def sphere_on_layer_n(depth_mm, radius_mm, thickness_mm, youngs_modulus_mpa, poisson_ratio):
    """Force of a sphere; the radius of contact is where the pressure at its border vanishes."""

    def solved(contact_mm):
        def shape(t):
            x = t * contact_mm
            return depth_mm - x * np.arctanh(x / radius_mm)

        return _mean_of_solution(contact_mm / thickness_mm, poisson_ratio, shape)

    contact = brentq(lambda a: solved(a)[1], 1e-3 * radius_mm, 0.99 * radius_mm)
    modulus = youngs_modulus_mpa / (1 - poisson_ratio**2)
    return 2 * modulus * contact * solved(contact)[0]


def _mean_of_solution(ratio, poisson_ratio, right_side):
    """Mean of φ over t/a in (0, 1), and φ at t = a."""
    t, weight = np.polynomial.legendre.leggauss(_POINTS)
    t, weight = (t + 1) / 2, weight / 2
    at = np.append(t, 1.0)
    kernel = _kernel((at[:, None] - t) * ratio, poisson_ratio)
    kernel = kernel + _kernel((at[:, None] + t) * ratio, poisson_ratio)
    kernel = kernel * weight * ratio / np.pi
    phi = np.linalg.solve(np.eye(_POINTS) - kernel[:-1], right_side(t))
    return float(weight @ phi), float(right_side(np.array([1.0]))[0] + kernel[-1] @ phi)


def _kernel(u, poisson_ratio):
    x, weighted = _transform(poisson_ratio)
    return np.cos(np.multiply.outer(u, x)) @ weighted


@cache
def _transform(poisson_ratio):
    """Quadrature of ∫₀^∞ (1 − L(x)) … dx, which falls as x² exp(−2x), with
    L = (2κ sinh 2x − 4x)/(2κ cosh 2x + 4x² + 1 + κ²), κ = 3 − 4ν."""
    x, weight = np.polynomial.legendre.leggauss(200)
    x, weight = 12 * (x + 1), 12 * weight
    kappa, decay = 3 - 4 * poisson_ratio, np.exp(-2 * x)
    numerator = kappa * (1 - decay**2) - 4 * x * decay
    denominator = kappa * (1 + decay**2) + (4 * x**2 + 1 + kappa**2) * decay
    return x, weight * (1 - numerator / denominator)
