"""Smooth continuation of tables of presses beyond the places that a face has.

Splines of the press lattice need all of it. Where a face has not all places, the values of the others
make third differences along x and y least (in the mean square), with the pressed
places as they are: parabolas go on as parabolas. No place beyond the pressed ones is ever read; a
spline's weights there fall by a factor of 3.7 with every node.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float
from scipy.sparse.linalg import splu

_THIRD_DIFFERENCE = (-1.0, 3.0, -3.0, 1.0)
_REACH = 6
"""Nodes beyond the pressed ones that are continued; those further off repeat the nearest."""


def fill_lattice(
    values: Float[np.ndarray, "some *rest"],
    pressed: Bool[np.ndarray, "node"],
    shape: tuple[int, int],
) -> Float[np.ndarray, "node *rest"]:
    """Return values of the pressed nodes of a lattice, continued smoothly to the other nodes."""
    on_lattice = np.full((len(pressed), *values.shape[1:]), np.nan)
    on_lattice[pressed] = values
    return continued(on_lattice, pressed, shape)


def continued(
    values: Float[np.ndarray, "node *rest"],
    pressed: Bool[np.ndarray, "node"],
    shape: tuple[int, int],
) -> Float[np.ndarray, "node *rest"]:
    """Return the table of one face with all places of the lattice; values of pressed ones stay."""
    if pressed.all():
        return values
    matrix = _continuation(pressed.tobytes(), shape)
    whole = values.copy()
    pressed_values = values[pressed].reshape(int(pressed.sum()), -1)
    whole[~pressed] = (matrix @ pressed_values).reshape(-1, *values.shape[1:])
    return whole


@lru_cache(maxsize=32)
def _continuation(pressed_bytes: bytes, shape: tuple[int, int]) -> np.ndarray:
    """Values of the other nodes, as sums over the pressed ones."""
    from scipy.ndimage import distance_transform_cdt

    pressed = np.frombuffer(pressed_bytes, bool)
    away, nearest = distance_transform_cdt(  # pyright: ignore[reportGeneralTypeIssues]
        ~pressed.reshape(shape), metric="chessboard", return_indices=True
    )
    near = (away.ravel() > 0) & (away.ravel() <= _REACH)
    rows = sp.vstack([_differences(shape, axis) for axis in (0, 1)]).tocsc()
    used = np.asarray(abs(rows[:, away.ravel() > _REACH]).sum(axis=1)).ravel() == 0
    rows = rows[used]
    near_rows, pressed_rows = rows[:, near], rows[:, pressed]
    solved = splu((near_rows.T @ near_rows).tocsc()).solve(-(near_rows.T @ pressed_rows).toarray())
    all_nodes = np.zeros((pressed.size, int(pressed.sum())))
    all_nodes[pressed] = np.eye(int(pressed.sum()))
    all_nodes[near] = solved
    flat = np.ravel_multi_index(tuple(nearest), shape).ravel()
    all_nodes[away.ravel() > _REACH] = all_nodes[flat[away.ravel() > _REACH]]
    return all_nodes[~pressed]


def _differences(shape: tuple[int, int], axis: int) -> sp.csr_matrix:
    """Third differences along an axis, everywhere on the lattice."""
    factors = [
        sp.diags_array(_THIRD_DIFFERENCE, offsets=range(4), shape=(max(n - 3, 0), n))  # pyright: ignore[reportArgumentType]
        if k == axis
        else sp.identity(n)
        for k, n in enumerate(shape)
    ]
    return sp.csr_matrix(sp.kron(*factors))
