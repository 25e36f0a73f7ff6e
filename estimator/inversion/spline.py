"""Cubic splines over (x, y, force) of many channels at once, with their derivatives.

One product of a few coefficients serves all channels of a contact, so that a tracked frame costs
microseconds where `estimator.signals.interpolation` takes milliseconds.
"""

from __future__ import annotations

from dataclasses import dataclass

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

    def weights(
        self, at: Float[np.ndarray, "n"]
    ) -> tuple[Int[np.ndarray, "n"], Float[np.ndarray, "n 4"], Float[np.ndarray, "n 4"]]:
        """First of the four coefficients that count, their weights, and the weights' derivatives.

        Beyond the ends the last polynomial goes on.
        """
        first = np.clip(np.searchsorted(self.breaks, at, "right") - 1, 0, len(self.power) - 1)
        u = at - self.breaks[first]
        one = np.ones_like(u)
        powers = np.stack([one, u, u * u, u * u * u], axis=1)
        slopes = np.stack([0 * u, one, 2 * u, 3 * u * u], axis=1)
        basis = self.power[first]
        return first, np.einsum("nbp,np->nb", basis, powers), np.einsum("nbp,np->nb", basis, slopes)


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
        values = np.moveaxis(make_interp_spline(at, values, k=_ORDER, axis=axis).c, 0, axis)
    return values
