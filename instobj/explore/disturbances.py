"""Changes since the zero, Earth's field and warmth, in the channels of each face by itself."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.spec.object import ObjectSpec
from estimator.information.fisher import disturbance_counts
from estimator.signals.nuisances import nuisance_columns


def face_nuisances(design: ObjectSpec) -> dict[int, Float[np.ndarray, "channel k"]]:
    """Return for each sensed face the columns of nuisances in its own channels, in standard deviations of
    each channel; without columns where `limits.use` is "bench".

    With `score.channels` "all" the chips of the other faces say how far the object is turned and warmed;
    what a press changes in them is left out.
    """
    columns = nuisance_columns(design)
    white = columns / disturbance_counts(design.sensors, "fresh", len(columns))[:, None]
    by_face = np.stack(np.split(white, len(design.body.sensed)))
    if design.score.channels == "own" or not white.shape[1]:
        return dict(zip(design.body.sensed, by_face, strict=True))
    # Precision of the unknowns from the other faces and their prior: P = 1 + Σ AᵀA over those faces.
    informed = by_face.swapaxes(1, 2) @ by_face
    precision = np.eye(white.shape[1]) + informed.sum(axis=0) - informed
    # A P⁻¹ Aᵀ = B Bᵀ with B = A L⁻ᵀ and P = L Lᵀ, so B stands in the place of A.
    lower = np.linalg.cholesky(precision)
    remaining = by_face @ np.linalg.inv(lower).swapaxes(1, 2)
    return dict(zip(design.body.sensed, remaining, strict=True))
