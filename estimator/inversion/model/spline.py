"""Cubic splines over (x, y, force) of many channels at once, with their derivatives.

One product of a few coefficients serves all channels of a contact, so that a tracked frame costs
microseconds where `estimator.signals.interpolation` takes milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Float, Int

_ORDER = 3


@dataclass(frozen=True)
class CubicAxis:
    """Not-a-knot cubic splines through nodes, as polynomials of each interval.

    Attributes
    ----------
    nodes : (node,) what they pass through
    breaks : (interval + 1,) where polynomials meet
    power : (interval, basis, power) coefficients of the four splines that live on an interval, by
        growing powers of the distance from its lower break
    """

    nodes: Float[np.ndarray, "node"]
    breaks: Float[np.ndarray, "break"]
    power: Float[np.ndarray, "interval 4 4"]

    def interval(self, at: Float[np.ndarray, "n"]) -> Int[np.ndarray, "n"]:
        """In which interval points lie; beyond the ends the last polynomial goes on."""
        after = np.searchsorted(self.breaks, at, "right") - 1
        return np.minimum(np.maximum(after, 0), len(self.power) - 1)


@dataclass(frozen=True)
class CubicAxes:
    """Several axes at once: few contacts cost calls of NumPy, not arithmetic."""

    axes: tuple[CubicAxis, ...]

    def weights(
        self, at: tuple[Float[np.ndarray, "n"], ...]
    ) -> tuple[Int[np.ndarray, "axis n"], Float[np.ndarray, "axis n 4 2"]]:
        """Of points on every axis: first of the four coefficients that count, their weights and the
        weights' derivatives."""
        first = np.array([axis.interval(one) for axis, one in zip(self.axes, at, strict=True)])
        rows = first + self._begin
        u = np.array(at) - self._lower[rows]
        powers = np.zeros((*u.shape, 4, 2))
        powers[..., 0, 0] = powers[..., 1, 1] = 1.0
        powers[..., 1, 0] = u
        powers[..., 2, 1] = 2 * u
        square = u * u
        powers[..., 2, 0] = square
        powers[..., 3, 0] = square * u
        powers[..., 3, 1] = 3 * square
        return first, self._power[rows] @ powers

    @cached_property
    def _begin(self) -> Int[np.ndarray, "axis 1"]:
        intervals = [len(axis.power) for axis in self.axes]
        return np.concatenate([[0], np.cumsum(intervals)[:-1]])[:, None]

    @cached_property
    def _lower(self) -> Float[np.ndarray, "row"]:
        return np.concatenate([axis.breaks[:-1] for axis in self.axes])

    @cached_property
    def _power(self) -> Float[np.ndarray, "row 4 4"]:
        return np.concatenate([axis.power for axis in self.axes])


def cubic_axis(nodes: Float[np.ndarray, "node"]) -> CubicAxis:
    """Splines through at least four increasing nodes."""
    from math import factorial

    from scipy.interpolate import BSpline, make_interp_spline

    knots = make_interp_spline(nodes, nodes, k=_ORDER).t
    unit = BSpline(knots, np.eye(len(nodes)), _ORDER)
    breaks = np.unique(knots)
    first, rows = np.arange(len(breaks) - 1), np.arange(_ORDER + 1)
    columns = first[:, None] + rows
    power = [unit(breaks[:-1], nu=int(p))[first[:, None], columns] / factorial(p) for p in rows]
    return CubicAxis(nodes, breaks, np.stack(power, axis=-1))


def spline_coefficients(
    nodes: tuple[np.ndarray, ...], values: Float[np.ndarray, "*grid channel"]
) -> Float[np.ndarray, "*grid channel"]:
    """Coefficients of the splines that pass through values on a grid of nodes."""
    from scipy.interpolate import make_interp_spline

    for axis, at in enumerate(nodes):
        of_values = make_interp_spline(at, np.eye(len(at)), k=_ORDER).c
        values = np.moveaxis(np.tensordot(of_values, values, axes=(1, axis)), 0, axis)
    return values
