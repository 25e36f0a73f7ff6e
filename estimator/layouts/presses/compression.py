"""Compression of tables over presses: rows of candidates on a few singular vectors of what presses tell."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from jaxtyping import Float

from fem.candidates.motions import MM_PER_RAD, FaceCandidates

LEFT_OUT = 2e-3
"""Share of the scaled quantities (root of their squares' sum) that a basis may leave out.

How many vectors that takes depends on how far places are apart, not on their number alone. The paper's cube
(100 places 3 mm apart; 2, 5 and 12 N) keeps 218: bounds are off by less than 0.3 %. A box, a cylinder and a
ball with places 6 to 7 mm apart keep 3.5 to 4.7 for each place: off by 0.7 to 1.2 % (rms; 11 % at most). With
1.5 to 1.9 for each place they were off by 30 to 39 %, and 95th percentiles were 0.41 to 0.93 times as large.
"""
TURN_RANK = 64
"""Vectors that are kept of what a tilt adds to a magnet's rotations.

For ten layouts whose magnets are tilted by up to 20° the bounds are off by 0.2 % (3 % at most; the worst one
by 0.7 %), with 32 by 1.8 % (13 %; 5 %).
"""


def rms(
    modes: Float[np.ndarray, "candidate 6 mode"],
    of_modes: Float[np.ndarray, "mode quantity place"],
) -> Float[np.ndarray, "quantity"]:
    """Return the rms of every quantity over candidates, motions and places; 1 where it is 0."""
    flat = modes.reshape(-1, modes.shape[2])
    # Σ (modes · shares)² = sharesᵀ (modesᵀ modes) shares: r and s modes, q quantity, p place
    power = np.einsum("rqp,rs,sqp->q", of_modes, flat.T @ flat, of_modes, optimize=True)
    root_mean_square = np.sqrt(power / (len(flat) * of_modes.shape[2]))
    return np.where(root_mean_square > 0, root_mean_square, 1.0)  # it divides


def compressed(
    tables: Sequence[Float[np.ndarray, "_ 6 mode"]],
    of_modes: Float[np.ndarray, "mode quantity place"],
    scale: Float[np.ndarray, "quantity"],
    rank: int | None,
) -> tuple[list[Float[np.ndarray, "_ _"]], Float[np.ndarray, "_ _"]]:
    """Rows (node; 6, rank) of each table on the leading right singular vectors of all that the tables tell of
    scaled quantities: `rank` of them, or as few as leave out no more than `LEFT_OUT`."""
    weight = np.repeat([1.0, MM_PER_RAD], 3)[:, None]
    flat = [(table * weight).reshape(-1, table.shape[2]) for table in tables]
    # Singular vectors of (all rows) · columns, without the many rows: their Gram matrix is enough.
    power, mode = np.linalg.eigh(sum(rows.T @ rows for rows in flat))
    root = np.sqrt(np.maximum(power, 0.0))[:, None] * mode.T  # rootᵀ root is the modes' Gram matrix
    columns = (of_modes / scale[:, None]).reshape(len(mode), -1)
    _, size, vectors = np.linalg.svd(root @ columns, full_matrices=False)
    if rank is None:
        # what the first 1, 2, … vectors leave out, squared
        remainder = np.maximum(1 - np.cumsum(size**2) / np.sum(size**2), 0.0)
        rank = 1 + int(np.count_nonzero(remainder > LEFT_OUT**2))
    vectors = vectors[:rank]
    mixed = columns @ vectors.T
    rows = [(table @ mixed).reshape(len(table), -1) for table in tables]
    return rows, vectors * np.repeat(scale, of_modes.shape[2])


def with_turns(
    rows: Float[np.ndarray, "node column"], lattice: FaceCandidates, jeffery_parameter: float
) -> Float[np.ndarray, "node wider"]:
    """Rows of a flat face, and by what the rotations grow with each rad about x, and about y.

    A magnet turns with the silicone's plane that it lies in, as far as strain turns it: by the slopes of
    the candidates' displacements, to first order in its tilt. At 15 to 20° the rotations of a disk of
    6 × 1 mm are off by 9 %, without this by 30 %.
    """
    nodes = rows.reshape(*lattice.shape, 6, -1)
    nodes_of_axis = (lattice.x_mm, lattice.y_mm, -lattice.depth_mm)
    slopes = np.stack(
        [
            np.gradient(nodes[..., :3, :], coordinates, axis=k, edge_order=2)
            for k, coordinates in enumerate(nodes_of_axis)
        ],
        axis=-2,
    )  # (…, component, direction, rank)
    grown = []
    for about in np.eye(3)[:2]:
        cross = np.cross(about, np.eye(3)).T  # cross @ v = about × v
        # Seen from a frame tilted by t about one axis, slopes G change by G [t]× − [t]× G to first order,
        # with [t]× v = t × v; the rotation ω that they give turns back to the face's frame by [t]× ω.
        # c and b components of u, d and e directions of slopes, r vector of the basis
        change = np.einsum("...cdr,de->...cer", slopes, cross)
        change -= np.einsum("bc,...cdr->...bdr", cross, slopes)
        turned = np.einsum("bc,...cr->...br", cross, _turn_of_plane(slopes))
        grown.append(jeffery_parameter * (_turn_of_plane(change) + turned))
    parts = [nodes, *(part[..., :TURN_RANK] for part in grown)]
    return np.concatenate([part.reshape(len(rows), -1) for part in parts], axis=1)


def _turn_of_plane(
    slopes: Float[np.ndarray, "*node 3 3 rank"],
) -> Float[np.ndarray, "*node 3 rank"]:
    """Rotation vector of the material plane z = const. under slopes ∂u_c/∂x_d."""
    spin = (slopes[..., 1, 0, :] - slopes[..., 0, 1, :]) / 2
    return np.stack([slopes[..., 2, 1, :], -slopes[..., 2, 0, :], spin], axis=-2)


def with_ghosts(
    rows: Float[np.ndarray, "node column"], shape: tuple[int, int, int]
) -> Float[np.ndarray, "padded column"]:
    """Nodes beyond both ends of every axis, as parabolas go on (Keys' border)."""
    lattice = rows.reshape(*shape, -1)
    for axis in range(3):
        a = np.moveaxis(lattice, axis, 0)
        # The parabola through three nodes at 1, 2, 3 has 3 a₁ − 3 a₂ + a₃ at 0.
        first, last = 3 * a[0] - 3 * a[1] + a[2], 3 * a[-1] - 3 * a[-2] + a[-3]
        lattice = np.moveaxis(np.concatenate([first[None], a, last[None]]), 0, axis)
    return np.ascontiguousarray(lattice).reshape(-1, rows.shape[1])
