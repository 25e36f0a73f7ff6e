"""Cubic splines over (x, y, force) of many channels at once, with their derivatives.

One product of a few coefficients serves all channels of a contact, so that a tracked frame costs
microseconds where `estimator.signals.interpolation` takes milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from estimator.inversion.model.arrays import Array, library, like

_ORDER = 3
"""Degree of the splines: cubic, so that signals have a continuous curvature."""


@dataclass(frozen=True)
class CubicAxis:
    """Not-a-knot cubic splines through nodes, as polynomials of each interval.

    Attributes
    ----------
    nodes : (node,) what they pass through
    breaks : (interval + 1,) where polynomials meet; beyond the ends the last ones go on
    power : (interval, basis, power) coefficients of the four splines that live on an interval, by
        growing powers of the distance from its lower break
    """

    nodes: Float[np.ndarray, "node"]
    breaks: Float[np.ndarray, "break"]
    power: Float[np.ndarray, "interval 4 4"]


@dataclass(frozen=True)
class CubicAxes:
    """Several axes at once: few contacts cost calls of NumPy, not arithmetic.

    They work with arrays of the kind of `reference`, on its device.
    """

    axes: tuple[CubicAxis, ...]
    reference: Array = field(default_factory=lambda: np.empty(0))

    def weights(
        self, points: tuple[Float[Array, "n"], ...]
    ) -> tuple[Int[Array, "axis n"], Float[Array, "axis n 4 2"]]:
        """Return, for points on every axis, the first of their four coefficients and the weights of these
        with their derivatives."""
        first = _stacked([_interval(*pair) for pair in zip(self._inner, points, strict=True)])
        rows = first + self._begin
        u = (_stacked(points) - self._lower[rows])[..., None]
        power = self._power[rows]
        weights = power[:, :, 3] * u
        for lower in (2, 1):
            weights += power[:, :, lower]
            weights *= u
        weights += power[:, :, 0]
        return first, weights.reshape(*first.shape, 4, 2)

    @cached_property
    def _inner(self) -> tuple[Float[Array, "_"], ...]:
        """Breaks between polynomials."""
        return tuple(like(self.reference, axis.breaks[1:-1].copy()) for axis in self.axes)

    @cached_property
    def _begin(self) -> Int[Array, "axis 1"]:
        intervals = [len(axis.power) for axis in self.axes]
        return like(self.reference, np.concatenate([[0], np.cumsum(intervals)[:-1]])[:, None])

    @cached_property
    def _lower(self) -> Float[Array, "row"]:
        return like(self.reference, np.concatenate([axis.breaks[:-1] for axis in self.axes]))

    @cached_property
    def _power(self) -> Float[Array, "row 4 8"]:
        """Return polynomials by growing powers: of each spline and, after it, of its derivative."""
        power = np.concatenate([axis.power for axis in self.axes]).swapaxes(1, 2)
        slopes = np.zeros_like(power)
        slopes[:, :3] = power[:, 1:] * [[1.0], [2.0], [3.0]]
        return like(self.reference, np.stack([power, slopes], axis=-1).reshape(len(power), 4, 8))


def _stacked(parts: Any) -> Array:
    """Equal arrays in a new first dimension."""
    first = parts[0]
    return np.array(parts) if isinstance(first, np.ndarray) else library(first).stack(list(parts))


def _interval(inner: Array, points: Array) -> Int[Array, "n"]:
    """Return the interval in which each point lies."""
    if isinstance(points, np.ndarray):
        return inner.searchsorted(points, "right")
    return library(points).searchsorted(inner, points.contiguous(), right=True)


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

    for axis, axis_nodes in enumerate(nodes):
        of_values = make_interp_spline(axis_nodes, np.eye(len(axis_nodes)), k=_ORDER).c
        values = np.moveaxis(np.tensordot(of_values, values, axes=(1, axis)), 0, axis)
    return values
