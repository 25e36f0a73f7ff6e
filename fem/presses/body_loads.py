"""Motions of magnets under forces on the magnets themselves, as those of magnets and steel are."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from fem.contact.complementarity import complementary_pressures
from fem.linear.response import ResponseOperator
from fem.presses.table import surface_weights_mm2


def motions_under_loads(
    response: ResponseOperator,
    loads: Float[np.ndarray, "magnet 6"],
    wall: tuple[int, float] | None = None,
) -> Float[np.ndarray, "magnet 6"]:
    """Return how forces (N) and torques (N mm) on the magnets move them, small strain, mm and rad.

    `wall` is the index of a face and a gap (mm): a rigid flat wall, without friction, stands that far
    above the face's frame and keeps the silicone from bulging through it.
    """
    magnets = response.magnet_loads
    moved = response.compliance[magnets, magnets] @ loads.ravel()
    if wall is not None:
        moved = moved + _held_back(response, loads.ravel(), *wall)
    return moved.reshape(loads.shape)


def _held_back(
    response: ResponseOperator, loads: Float[np.ndarray, "n"], index: int, gap_mm: float
) -> Float[np.ndarray, "n"]:
    """Motion of the magnets under the wall's pressures on the face that bulges towards it."""
    face, magnets = response.face_loads(index), response.magnet_loads
    surface = response.surfaces[index]
    # Moments ∫ φ_i (gap − bulge) dA ≥ 0; a face that bulges sinks by less than nothing.
    height = gap_mm - surface.points_mm[:, 2]
    sunk = response.compliance[face, magnets] @ loads
    gap = surface_weights_mm2(surface) * height + sunk
    compliance = np.array(response.compliance[face, face])
    pressure = complementary_pressures(compliance, gap, gap < 0)
    return response.compliance[magnets, face] @ pressure
