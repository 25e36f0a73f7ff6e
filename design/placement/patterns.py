"""Patterns of parts on a face, as shares of its half extents along x and y."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

Shares = Float[np.ndarray, "part 2"]
_CORNERS_DEG = 45.0
"""Azimuth of the first of four magnets: they stand towards the corners."""


def sensor_patterns(count: int) -> tuple[list[Shares], list[Shares]]:
    """Patterns of sensors, evenest first: rings, then rows, then patterns that leave a half of
    the face without any."""
    if count == 1:
        return [np.zeros((1, 2))], []
    rings = [_ring(count, first) for first in (90.0, 0.0, 45.0, 75.0)]
    tee = np.concatenate([_row(count - 1), [[0.0, 1.0]]])
    tees, rows = [tee, tee[:, ::-1]], [_row(count), _row(count)[:, ::-1]]
    return ([*rings, *rows], tees) if count == 2 else ([*rings, *tees, *rows], [])


def along_longer_side(pattern: Shares, half_mm: Float[np.ndarray, "2"]) -> Shares:
    """Return a pattern whose row, if it is one, runs along the longer side of a face.

    Two sensors along the short side of a face leave both its ends without any.
    """
    in_a_row = (abs(pattern) < 1e-9).all(axis=0).any()  # angles leave 1e-16
    across = np.ptp(pattern, axis=0).argmax() != half_mm.argmax()
    return pattern[:, ::-1] if in_a_row and across and half_mm[0] != half_mm[1] else pattern


def magnet_patterns(count: int) -> list[Shares]:
    """Patterns of magnets, one in the middle where the count is odd; rows last."""
    rows = [*_grids(count), _row(count), _row(count)[:, ::-1]]
    if count < 4:
        return rows
    middle = np.zeros((count % 2, 2))
    around = count - count % 2
    first = _CORNERS_DEG if around == 4 else 0.0
    corners = np.sqrt(2.0) if around == 4 else 1.0
    return [np.concatenate([middle, corners * _ring(around, first)]), *rows]


def _grids(count: int) -> list[Shares]:
    """Even rows and columns, longer along x and along y; of six and nine alone."""
    if count not in (6, 9):
        return []
    columns = 3
    x, y = np.meshgrid(*(np.linspace(-1, 1, n) for n in (columns, count // columns)))
    grid = np.column_stack([x.ravel(), y.ravel()])
    return [grid, grid[:, ::-1]]


def _ring(count: int, first_deg: float) -> Shares:
    angles = np.deg2rad(first_deg + 360 * np.arange(count) / count)
    return np.column_stack([np.cos(angles), np.sin(angles)])


def _row(count: int) -> Shares:
    steps = np.linspace(-1, 1, count) if count > 1 else np.zeros(1)
    return np.column_stack([steps, np.zeros(count)])
