"""Ellipses of the position bound: which way a contact location is uncertain, and how far."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.information.scores import PlaceScores
from estimator.information.sensitivity import read_channels
from estimator.signals.live import live_jacobian
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals


def position_covariances_mm2(
    spec: ObjectSpec, signals: Signals, scores: PlaceScores
) -> Float[np.ndarray, "face place 2 2"]:
    """Smallest covariance of (x, y) at every contact location, with a fresh baseline, in mm².

    At the forces of the scores and from their channels: its trace is the square of
    `position_bound_mm`. NaN where the signals cannot tell the place.
    """
    grid = contact_grid(spec)
    count = signals.baseline_counts.size
    sigma, nuisances = disturbance_counts(spec.sensors, "fresh", count), nuisance_columns(spec)
    covariance = np.full((len(scores.faces), len(grid), 2, 2), np.nan)
    for row, face in enumerate(scores.faces.tolist()):
        used = read_channels(spec, signals, face)
        bounded = np.isfinite(scores.position_bound_mm[row])
        x_mm, y_mm = grid.xy_mm[bounded].T
        force_n = scores.force_at_score_n[row, bounded]
        faces = np.full(len(x_mm), face)
        jacobian = live_jacobian(spec, signals, faces, x_mm, y_mm, force_n)
        bounds = cramer_rao_bounds(jacobian[:, used], sigma[used], nuisances[used])
        covariance[row, bounded] = bounds.position_mm2
    return covariance
