"""Depth of indentation up to which small-strain mechanics can be trusted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_THICKNESS_MM = 8.0
"""Thickness of the shell whose errors these are; depths scale with it."""
_DEPTH_MM = (0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)
"""Indentation depths of the errors below."""
_FORCE_ERROR = (0.0, 0.025, 0.032, 0.042, 0.055, 0.075, 0.107, 0.137, 0.165)
"""Relative error of the linear model's force at these depths."""
_MOTION_ERROR = (0.0, 0.09, 0.113, 0.144, 0.205, 0.264, 0.312, 0.395, 0.485)
"""Relative error of the linear model's motions at these depths."""


@dataclass(frozen=True)
class LinearError:
    """Largest relative error of small strain at a depth: of the force, and of magnet motions
    (worst magnet, in units of the press's largest motion)."""

    force: float
    motion: float


def depth_of_force_error_mm(share: float, thickness_mm: float) -> float:
    """Depth at which the envelope of `linear_error` reaches an error of force, at most 16.5 %."""
    return float(np.interp(share, _FORCE_ERROR, _DEPTH_MM)) * thickness_mm / _THICKNESS_MM


def linear_error(depth_mm: float, thickness_mm: float) -> LinearError | None:
    """Envelope of small strain against neo-Hookean presses (`fem.large_strain.press`) on one mesh.

    Measured with the R5 hemisphere, without friction, at six places of the paper's cube (centre,
    over a corner magnet, corner, edge, twice between magnets; rigid magnets, ν 0.4999, edges of 1 mm
    at the tip, 17 000 to 23 000 nodes). Signs differ by place: at 4 mm the linear force is 16 % too
    small at the centre and 9 % too large between magnets. Finer meshes (edges of 0.7 to 0.8 mm) give
    the same to 1 % of force. Scaled by depth over thickness for other shells, where it is an
    orientation only; for one press of the object at hand use `instobj press`. None beyond half the
    thickness, where nothing was measured.
    """
    depth = depth_mm * _THICKNESS_MM / thickness_mm
    if depth > _DEPTH_MM[-1]:
        return None
    return LinearError(
        float(np.interp(depth, _DEPTH_MM, _FORCE_ERROR)),
        float(np.interp(depth, _DEPTH_MM, _MOTION_ERROR)),
    )
