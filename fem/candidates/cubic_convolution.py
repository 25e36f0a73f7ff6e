"""Cubic convolution on a regular axis: third order, once differentiable, four neighbours per value.

Keys, IEEE Trans. Acoust. Speech Signal Process. 29 (1981) 1153, with his extrapolation at the ends,
which keeps parabolas exact up to the border.
"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Int

from design.errors import InputError

_ON_BORDER = 1e-9
"""Share of a step beyond the border that is rounding."""


def axis_weights(
    nodes: Float[np.ndarray, "node"], points: Float[np.ndarray, "point"]
) -> tuple[Int[np.ndarray, "point 4"], Float[np.ndarray, "point 4"]]:
    """Neighbours of each point among equally spaced nodes (four or more), and their weights.

    Raises
    ------
    InputError
        Fewer than four nodes, or a point beyond them.
    """
    count, step = len(nodes), (nodes[-1] - nodes[0]) / (len(nodes) - 1)
    place = (points - nodes[0]) / step
    if count < 4:
        raise InputError(
            f"interpolation needs four nodes an axis; got {count}. Use a finer lattice"
        )
    outside = (place < -_ON_BORDER) | (place > count - 1 + _ON_BORDER)
    if outside.any():
        raise InputError(
            f"{points[outside][0]:g} mm lies outside the lattice ({nodes[0]:g} to {nodes[-1]:g} mm). Keep "
            "magnets within it"
        )
    cell = np.clip(np.floor(place).astype(int), 0, count - 2)
    weight = _kernel(place - cell)
    first = np.clip(cell - 1, 0, count - 4)
    full = np.zeros((len(points), 6))
    row = np.arange(len(points))[:, None]
    full[row, cell[:, None] - first[:, None] + np.arange(4)] = weight  # column 0 is node first − 1
    full[:, 1:4] += full[:, :1] * [3, -3, 1]
    full[:, 2:5] += full[:, 5:] * [1, -3, 3]
    return first[:, None] + np.arange(4), full[:, 1:5]


def _kernel(t: np.ndarray) -> np.ndarray:
    """Weights of the nodes at −1, 0, 1, 2 for a point at 0 ≤ t ≤ 1."""
    return np.stack(
        [
            ((-0.5 * t + 1) * t - 0.5) * t,
            (1.5 * t - 2.5) * t * t + 1,
            ((-1.5 * t + 2) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t,
        ],
        axis=1,
    )


def extension(known_nodes: Bool[np.ndarray, "nx ny"]) -> sp.csr_matrix:
    """Values at all nodes of a lattice from those at the known ones, (node, known).

    Values go on beyond the known nodes with the smallest third differences along both axes (least
    squares): up to parabolas exactly, so that interpolation near their border is as good as within.
    """
    index = np.arange(known_nodes.size).reshape(known_nodes.shape)
    rows = [
        np.stack([lines[k : len(lines) - 3 + k].ravel() for k in range(4)], axis=1)
        for lines in (index, index.T)
    ]
    nodes = np.concatenate(rows)
    differences = np.zeros((len(nodes), known_nodes.size))
    differences[np.arange(len(nodes))[:, None], nodes] = [-1.0, 3.0, -3.0, 1.0]
    is_known = known_nodes.ravel()
    beyond = np.linalg.lstsq(differences[:, ~is_known], -differences[:, is_known], rcond=None)[0]
    values = np.zeros((known_nodes.size, int(is_known.sum())))
    values[is_known], values[~is_known] = np.eye(values.shape[1]), beyond
    return sp.csr_matrix(values)
