"""Monotone piecewise cubic interpolation of many curves at once, also at complex arguments.

Method: Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984). Complex arguments allow exact
derivatives by a complex step; branches follow the real parts.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Inexact


def monotone_cubic(
    nodes: Inexact[np.ndarray, "press node"],
    values: Inexact[np.ndarray, "press node channel"],
    at: Inexact[np.ndarray, "press point"],
) -> Inexact[np.ndarray, "press point channel"]:
    """Shape-preserving cubic through (nodes, values) of each press, at its own points.

    Parameters
    ----------
    nodes : increasing along each press
    at : within the nodes

    Returns
    -------
    Values at the points; complex where an argument is, so that derivatives can be taken by a
    complex step.
    """
    width = np.diff(nodes, axis=1)[..., None]
    secant = np.diff(values, axis=1) / width
    slope = _monotone_slopes(width, secant)
    interval = np.sum(np.real(at)[:, :, None] >= np.real(nodes)[:, None, 1:-1], axis=2)
    row = np.arange(len(nodes))[:, None]
    h = width[row, interval]
    t = (at - nodes[row, interval])[..., None] / h
    left, right = slope[row, interval], slope[row, interval + 1]
    chord = secant[row, interval]
    bend = left + right - 2 * chord
    rise = t * (left + t * (chord - left + (t - 1) * bend))
    return values[row, interval] + h * rise


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
