"""How far an object is from as soft as wanted, as one number."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.layout.positions import PlaceGrid
from design.spec.search import WantedCompliance
from estimator.information.scores import area_places


def compliance_deviation(
    wanted_mm_per_n: WantedCompliance,
    grid: PlaceGrid,
    mm_per_n: Float[np.ndarray, "face place"],
) -> float:
    """Root mean square of compliance over the wanted one, less 1, over the places that have one.

    Where nothing is wanted, even softness is: places are compared with their mean.
    """
    target = np.full(len(grid), np.nan)
    for area, value in wanted_mm_per_n.items():
        target[slice(None) if area == "everywhere" else area_places(grid, area)] = value
    if not wanted_mm_per_n:
        target[:] = mm_per_n.mean()
    counted = np.isfinite(target)
    return float(np.sqrt(np.mean((mm_per_n[:, counted] / target[counted] - 1) ** 2)))
