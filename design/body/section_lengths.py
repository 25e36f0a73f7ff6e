"""Lengths along the two central sections of a patch, the coordinates of contact locations.

A location (x, y) of a patch lies over the point x mm along the section y = 0 and y mm along the
section x = 0, both from the patch's middle. Equal steps in such coordinates are equal lengths along
the sections, and nearly equal ones next to them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

if TYPE_CHECKING:
    from collections.abc import Callable

    from scipy.interpolate import CubicHermiteSpline

_PANELS = 256
"""Between the middle of a section and its end; lengths and their inverse agree within 1e-7 mm."""
_GAUSS_POINTS = 4
_WITHIN = 1 - 1e-9
"""Used share of a section, whose very end may be rounded off the patch."""


@dataclass(frozen=True)
class SectionLengths:
    """One central section: its length from the middle against the coordinate in the frame's plane.

    Both splines are monotone, and straight beyond the section's ends.
    """

    length: CubicHermiteSpline
    plane: CubicHermiteSpline

    def to_lengths(self, plane_mm: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
        """Lengths along the section of coordinates in the plane."""
        return _straight_beyond(self.length, plane_mm)

    def to_plane(self, length_mm: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
        """Inverse of `to_lengths`."""
        return _straight_beyond(self.plane, length_mm)

    def plane_rate(self, length_mm: Float[np.ndarray, "*n"]) -> Float[np.ndarray, "*n"]:
        """Change of the coordinate in the plane per length: the cosine of the section's slope."""
        return np.asarray(self.plane(np.clip(length_mm, *self.plane.x[[0, -1]]), 1))


def section_lengths(
    slope: Callable[[np.ndarray], np.ndarray], half_mm: float
) -> SectionLengths | None:
    """Return the lengths of the section of that slope at coordinates in the plane within ±half; None where
    it is straight."""
    from scipy.interpolate import CubicHermiteSpline

    def stretch(t_mm: np.ndarray) -> np.ndarray:
        return np.hypot(1.0, slope(t_mm))

    knots = half_mm * _WITHIN * np.arange(-_PANELS, _PANELS + 1) / _PANELS
    slopes = stretch(knots)
    if (slopes == 1).all():
        return None
    lengths = _integrated(stretch, knots)
    return SectionLengths(
        CubicHermiteSpline(knots, lengths, slopes), CubicHermiteSpline(lengths, knots, 1 / slopes)
    )


def _integrated(stretch: Callable[[np.ndarray], np.ndarray], knots: np.ndarray) -> np.ndarray:
    """∫ from the middle knot to every knot, outwards on either side."""
    nodes, weights = np.polynomial.legendre.leggauss(_GAUSS_POINTS)
    half = np.diff(knots)[:, None] / 2
    steps = (stretch(knots[:-1, None] + half * (1 + nodes)) * weights * half).sum(axis=1)
    inner_steps, outer_steps = steps[:_PANELS], steps[_PANELS:]
    return np.concatenate([-np.cumsum(inner_steps[::-1])[::-1], [0.0], np.cumsum(outer_steps)])


def _straight_beyond(spline: CubicHermiteSpline, at_mm: np.ndarray) -> np.ndarray:
    low, high = spline.x[0], spline.x[-1]
    within = np.clip(at_mm, low, high)
    beyond = spline(np.where(at_mm < 0, low, high), 1) * (at_mm - within)
    return np.asarray(spline(within) + beyond)
