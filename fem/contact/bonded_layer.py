"""Rigid sphere on a soft layer that is bonded to a rigid base, in closed form."""

from __future__ import annotations

import numpy as np

THINNEST = 1.5
"""Least thickness over the depth for which the series is asked: below, no closed form is near."""


def layer_force_n(
    depth_mm: float, modulus_mpa: float, radius_mm: float, thickness_mm: float
) -> float:
    """Force of a sphere on an incompressible layer.

    Hertz with ν = ½ times a series in χ = √(Rδ)/t: Dimitriadis, Horkay, Maresca, Kachar & Chadwick,
    Biophysical J. 82, 2002, equation 12, layer bonded. Small strain, no friction; for χ up to about 1.
    """
    chi = np.sqrt(radius_mm * depth_mm) / thickness_mm
    series = 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4
    return float(16 / 9 * modulus_mpa * np.sqrt(radius_mm) * depth_mm**1.5 * series)


def layer_thickness_mm(
    force_n: float, depth_mm: float, modulus_mpa: float, radius_mm: float
) -> float:
    """Thickness at which a layer gives way by a depth under a force; NaN where it is too stiff at any
    thickness, or so soft that it would be thinner than 1.5 depths."""
    from scipy.optimize import brentq

    def excess(thickness_mm: float) -> float:
        return layer_force_n(depth_mm, modulus_mpa, radius_mm, thickness_mm) - force_n

    low, high = THINNEST * depth_mm, 1e3 * depth_mm
    if excess(low) < 0 or excess(high) > 0:
        return float("nan")
    return float(brentq(excess, low, high))  # pyright: ignore[reportArgumentType]
