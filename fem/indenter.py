"""Rigid indenters: height of the tip's surface above its lowest point."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float


def hemisphere_profile_mm(
    distance_mm: Float[np.ndarray, "*n"], radius_mm: float
) -> Float[np.ndarray, "*n"]:
    """R − √(R² − r²) up to r = R; beyond, R (nothing deeper than R ever touches there)."""
    inside = np.clip(radius_mm**2 - np.minimum(distance_mm, radius_mm) ** 2, 0, None)
    return radius_mm - np.sqrt(inside)
