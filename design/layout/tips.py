"""Where the tips of the paper's three probes are; light, for everything that simulates contact."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.errors import InputError


def tip_positions_mm(
    tips: int, radius_mm: float = 5.0, spacing_mm: float | None = None
) -> Float[np.ndarray, "tip 2"]:
    """Tip centres (x, y) in mm about the probe's axis: one, two 15 mm apart, or three 20 mm apart.

    Without a spacing these are the paper's (Knopke et al., RA-L 2024) for tips of 5 mm radius or
    less; larger tips keep the ratio, 3 and 4 radii, so that they stay apart.

    Raises
    ------
    InputError
        No such probe.
    """
    if tips == 1:
        return np.zeros((1, 2))
    if tips == 2:
        half = (spacing_mm or max(15.0, 3 * radius_mm)) / 2
        return np.array([[-half, 0.0], [half, 0.0]])
    if tips == 3:
        circumradius = (spacing_mm or max(20.0, 4 * radius_mm)) / np.sqrt(3)
        angle = np.deg2rad([90.0, 210.0, 330.0])
        return circumradius * np.column_stack([np.cos(angle), np.sin(angle)])
    raise InputError(f"a probe has 1, 2 or 3 tips; got {tips}. Choose one of these")
