"""Monotone piecewise cubic interpolation of many curves at once, also at complex arguments.

Method: Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984). Complex arguments allow exact
derivatives by a complex step; branches follow the real parts.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from jaxtyping import Inexact


@dataclass(frozen=True)
class MonotoneCurves:
    """Shape-preserving cubics through (nodes, values) of each press, asked for as often as needed.

    `nodes` increase along each press.
    """

    nodes: Inexact[np.ndarray, "press node"]
    values: Inexact[np.ndarray, "press node channel"]

    @cached_property
    def pieces(self) -> Inexact[np.ndarray, "press interval 4 channel"]:
        """Coefficients of 1, t, t², t³ between nodes, t from 0 to 1: most of the work, and the same
        wherever the curves are asked."""
        width, rise = np.diff(self.nodes, axis=1)[..., None], np.diff(self.values, axis=1)
        slope = _monotone_slopes(width, rise / width)
        begin_rise, end_rise = width * slope[:, :-1], width * slope[:, 1:]
        bend = begin_rise + end_rise - 2 * rise
        return np.stack([self.values[:, :-1], begin_rise, rise - begin_rise - bend, bend], axis=2)

    def evaluate(
        self, points: Inexact[np.ndarray, "press point"]
    ) -> Inexact[np.ndarray, "press point channel"]:
        """Values of each press at its own points, within the nodes; complex where an argument is, so
        that derivatives can be taken by a complex step."""
        nodes = self.nodes
        interval = np.sum(np.real(points)[:, :, None] >= np.real(nodes)[:, None, 1:-1], axis=2)
        row = np.arange(len(nodes))[:, None]
        begin, end = nodes[row, interval], nodes[row, interval + 1]
        t = ((points - begin) / (end - begin))[..., None]
        pieces = self.pieces[row, interval]
        constant, linear, square, cube = (pieces[:, :, power] for power in range(4))
        return constant + t * (linear + t * (square + t * cube))


def monotone_cubic(
    nodes: Inexact[np.ndarray, "press node"],
    values: Inexact[np.ndarray, "press node channel"],
    points: Inexact[np.ndarray, "press point"],
) -> Inexact[np.ndarray, "press point channel"]:
    """`MonotoneCurves` asked once."""
    return MonotoneCurves(nodes, values).evaluate(points)


def _monotone_slopes(
    width: Inexact[np.ndarray, "press interval 1"],
    secant: Inexact[np.ndarray, "press interval channel"],
) -> Inexact[np.ndarray, "press node channel"]:
    """Slopes at the nodes: weighted harmonic mean of the neighbouring secants, 0 at turns."""
    if secant.shape[1] == 1:
        return np.concatenate([secant, secant], axis=1)
    left, right = secant[:, :-1], secant[:, 1:]
    w_left = width[:, :-1] + 2 * width[:, 1:]
    w_right = 2 * width[:, :-1] + width[:, 1:]
    same = np.real(left) * np.real(right) > 0
    bottom = np.where(same, w_right * left + w_left * right, 1.0)
    inner = np.where(same, (w_left + w_right) * left * right / bottom, 0.0)
    first = _end_slope(width[:, 0], width[:, 1], secant[:, 0], secant[:, 1])
    last = _end_slope(width[:, -1], width[:, -2], secant[:, -1], secant[:, -2])
    return np.concatenate([first[:, None], inner, last[:, None]], axis=1)


def _end_slope(
    near_width: Inexact[np.ndarray, "press 1"],
    far_width: Inexact[np.ndarray, "press 1"],
    near: Inexact[np.ndarray, "press channel"],
    far: Inexact[np.ndarray, "press channel"],
) -> Inexact[np.ndarray, "press channel"]:
    """Three-point end slope, limited so that the end piece stays monotone."""
    slope = ((2 * near_width + far_width) * near - near_width * far) / (near_width + far_width)
    slope = np.where(np.real(slope) * np.real(near) <= 0, 0.0, slope)
    steep = (np.real(near) * np.real(far) < 0) & (abs(slope) > 3 * abs(near))
    return np.where(steep, 3 * near, slope)
