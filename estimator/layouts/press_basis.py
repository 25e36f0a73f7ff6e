"""Presses of one face at candidate magnets, compressed for scoring layouts in batches.

Presses to one force, and their derivatives in x, y and force, are a table (candidate, 6; place, 4).
A few singular vectors of its columns carry all of it, so that the many candidates around a magnet
are mixed as short rows and unfolded to places once a layout. Rows of the pressed face's candidates
and of the other faces', which move less, have bases of their own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from scipy.interpolate import make_interp_spline
from torch import Tensor
from torch.nn.functional import embedding_bag

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from fem.candidates.motions import CandidateMotions

OTHER_RANK = 40
"""Of the other faces' basis: 40 leave 2 % of a random layout's worst bound, 24 leave 5 %."""
_MM_PER_RAD = 4.0
"""Weight of rotations beside displacements: both then change a magnet's field about alike."""


@dataclass(frozen=True)
class RowTable:
    """Short rows on a regular lattice, with one ghost node beyond each end of every axis.

    `rows` (node, 6 · rank · faces); `basis` (rank, 4 · place) unfolds them to ∂/∂x, ∂/∂y, ∂/∂F and
    the motion itself, block by block: mm and rad, per mm, mm and N.
    """

    rows: Float[Tensor, "node column"]
    basis: Float[Tensor, "rank quantity"]


@dataclass(frozen=True)
class PressBasis:
    """Presses of one face to `force_n` (N), as motions in the face's own frame (z outward).

    `first_mm`, `step_mm`, `nodes`: the candidates' lattice in (x, y, depth), ghosts left out.
    `turn`, `shift_mm` take the other faces' frames to this one's: first those of `neighbours`
    (numbers of the adjacent faces), last that of `opposite`, where it is sensed. The opposite face
    has no rows: what motions of magnets that far away add does not show in the bounds. `mm_per_n` is
    indentation depth over force at every location, of the shell without magnets.
    """

    face: int
    neighbours: tuple[int, ...]
    opposite: int | None
    force_n: float
    places: PlaceGrid
    first_mm: Float[Tensor, "3"]
    step_mm: Float[Tensor, "3"]
    nodes: tuple[int, int, int]
    own: RowTable
    other: RowTable
    turn: Float[Tensor, "face 3 3"]
    shift_mm: Float[Tensor, "face 3"]
    mm_per_n: Float[np.ndarray, "place"]


def press_basis(
    spec: ObjectSpec,
    motions: CandidateMotions,
    face: int,
    force_n: float | None = None,
    own_rank: int | None = None,
    other_rank: int = OTHER_RANK,
    dtype: torch.dtype = torch.float32,
) -> PressBasis:
    """Compress the presses of one face to `force_n` (`score.force_n` by default).

    Between and beyond the two stored forces that belong to it motions go on straight, so that places
    that the presses could not load to it count as if they could. Derivatives in x and y are those of
    cubic splines through the contact locations, at constant force.

    Parameters
    ----------
    own_rank : as many as there are places by default, which leaves 0.5 % of a random layout's worst
        bound; 80 for 100 places leave 8 %: where little is seen, little may be left out

    Raises
    ------
    InputError
        A face that was not pressed, fewer than two forces or four locations per axis, or faces of
        different sizes: one layout then does not fit all of them.
    """
    _check(motions, face)
    force_n = force_n or spec.score.force_n
    frames = {frame.number: frame for frame in face_frames(spec)}
    here = frames.pop(face)
    others = sorted(frames.values(), key=lambda frame: _opposite(frame, here))
    adjacent = [frame.number for frame in others if not _opposite(frame, here)]
    own, *moving = (
        _derivatives(motions, face, number, here.axes, force_n) for number in (face, *adjacent)
    )
    scale = np.sqrt(np.mean(own**2, axis=(0, 1, 3)))
    scale = np.repeat(np.where(scale > 0, scale, 1.0), len(motions.places))
    lattice = motions.candidates[0]
    ends = np.array([[n[0], n[1]] for n in (lattice.x_mm, lattice.y_mm, lattice.depth_mm)])

    def tensor(values: object) -> Tensor:
        return torch.as_tensor(np.asarray(values), dtype=dtype)

    def table(parts: list[np.ndarray], rank: int) -> RowTable:
        rows, basis = _compressed(parts, scale, rank)
        return RowTable(tensor(_with_ghosts(rows, lattice.shape)), tensor(basis))

    opposite = [frame.number for frame in others if _opposite(frame, here)]
    return PressBasis(
        face,
        tuple(adjacent),
        opposite[0] if opposite else None,
        force_n,
        motions.places,
        tensor(ends[:, 0]),
        tensor(ends[:, 1] - ends[:, 0]),
        lattice.shape,
        table([own], own_rank or len(motions.places)),
        table(moving, other_rank),
        tensor([here.axes.T @ frame.axes for frame in others]),
        tensor([here.from_object(frame.centre_mm) for frame in others]),
        _compliance(motions, face, force_n),
    )


def mixed_rows(
    basis: PressBasis, xyd_mm: Float[Tensor, "magnet 3"]
) -> tuple[Float[Tensor, "magnet own"], Float[Tensor, "magnet other"]]:
    """Rows of magnets anywhere among the candidates: tricubic convolution, as `CandidateMotions.at`.

    Differentiable in the positions; the same (x, y, depth) is meant on every face.

    Raises
    ------
    InputError
        A place outside the candidates.
    """
    place = (xyd_mm - basis.first_mm) / basis.step_mm
    last = torch.tensor(basis.nodes, dtype=place.dtype) - 1
    outside = (place < -1e-4) | (place > last + 1e-4)
    if outside.any():
        magnet, axis = outside.nonzero()[0].tolist()
        low = float(basis.first_mm[axis])
        high = low + float(basis.step_mm[axis] * last[axis])
        raise InputError(
            f"{('x', 'y', 'depth')[axis]} = {float(xyd_mm[magnet, axis]):.4g} mm of a magnet lies "
            f"outside the candidates ({low:g} to {high:g} mm). Keep magnets within them"
        )
    # The tables hold one more node beyond each end, so that the four neighbours of
    # a cell along an axis, −1 … 2, are nodes cell … cell + 3 of a table of nodes + 2.
    cell = torch.minimum(place.detach().floor().clamp(min=0), last - 1)
    x, y, z = _kernel(place - cell).unbind(1)
    weight = x[:, :, None, None] * y[:, None, :, None] * z[:, None, None, :]
    _, ny, nz = (count + 2 for count in basis.nodes)
    corner = cell.long() @ torch.tensor([ny * nz, nz, 1])
    around = torch.arange(4)
    near = ((around[:, None, None] * ny + around[:, None]) * nz + around).reshape(-1)
    index, weight = corner[:, None] + near, weight.reshape(-1, 64)
    own, other = (  # weighted sums of 64 rows each, without a copy of the rows
        embedding_bag(index, table.rows, per_sample_weights=weight, mode="sum")
        for table in (basis.own, basis.other)
    )
    return own, other


def _kernel(t: Float[Tensor, "magnet 3"]) -> Float[Tensor, "magnet 3 4"]:
    """Weights of the nodes at −1, 0, 1, 2 for a point at 0 ≤ t ≤ 1 (Keys, 1981)."""
    return torch.stack(
        [
            ((-0.5 * t + 1) * t - 0.5) * t,
            (1.5 * t - 2.5) * t * t + 1,
            ((-1.5 * t + 2) * t + 0.5) * t,
            (0.5 * t - 0.5) * t * t,
        ],
        dim=-1,
    )


def _compliance(
    motions: CandidateMotions, pressed: int, force_n: float
) -> Float[np.ndarray, "place"]:
    """Secant, straight between and beyond the stored forces."""
    row = motions.faces.tolist().index(pressed)
    steps = motions.steps_around(force_n)
    (low, high), depth = motions.force_n[row][:, steps].T, motions.depth_mm[row][:, steps]
    share = (force_n - low) / (high - low)
    return (depth[:, 0] + share * (depth[:, 1] - depth[:, 0])) / force_n


def _opposite(a: FaceFrame, b: FaceFrame) -> bool:
    return bool(a.normal @ b.normal < -0.5)


def _check(motions: CandidateMotions, face: int) -> None:
    if face not in motions.faces:
        raise InputError(f"face {face} was not pressed. Choose one of {motions.faces.tolist()}")
    if motions.force_n.shape[2] < 2 or min(motions.places.shape) < 4:
        raise InputError(
            "derivatives of presses need two forces and four locations per axis; got "
            f"{motions.force_n.shape[2]} forces and {motions.places.shape} places. Simulate more"
        )
    first = motions.candidates[0].xyd_mm
    for lattice in motions.candidates:
        if lattice.xyd_mm.shape != first.shape or not np.allclose(lattice.xyd_mm, first):
            raise InputError(
                f"candidates of face {lattice.face} are not those of face "
                f"{motions.candidates[0].face}: one layout cannot be repeated on faces of different "
                "sizes. Use a body with equal edges"
            )


def _derivatives(
    motions: CandidateMotions,
    pressed: int,
    face: int,
    axes: Float[np.ndarray, "3 3"],
    force_n: float,
) -> Float[np.ndarray, "candidate 6 4 place"]:
    """∂/∂x, ∂/∂y, ∂/∂F and the motion of one face's candidates, along the columns of `axes`."""
    row = motions.faces.tolist().index(pressed)
    number = [lattice.face for lattice in motions.candidates].index(face)
    first = sum(len(lattice) for lattice in motions.candidates[:number])
    chosen = slice(first, first + len(motions.candidates[number]))
    steps = motions.steps_around(force_n)
    stored = np.asarray(motions.by_candidate[chosen, row, :, steps], dtype=float)
    low, high = stored.reshape(2, -1, *motions.places.shape, 2, 3) @ axes
    force = motions.force_n[row][:, steps].reshape(*motions.places.shape, 2, 1, 1)
    per_n = (high - low) / (force[:, :, 1] - force[:, :, 0])
    motion = low + per_n * (force_n - force[:, :, 0])
    along_x, along_y = (
        make_interp_spline(nodes, np.eye(len(nodes)), k=3)(nodes, nu=1)
        for nodes in (motions.places.x_mm, motions.places.y_mm)
    )
    by_x = np.einsum("ip,cpqkv->ciqkv", along_x, motion)
    by_y = np.einsum("jq,cpqkv->cpjkv", along_y, motion)
    parts = np.stack([by_x, by_y, per_n, motion], axis=-1)
    return parts.reshape(len(motion), -1, 6, 4).transpose(0, 2, 3, 1)


def _compressed(
    tables: list[np.ndarray], scale: Float[np.ndarray, "quantity"], rank: int
) -> tuple[Float[np.ndarray, "node column"], Float[np.ndarray, "rank quantity"]]:
    """Rows (node; face, 6, rank) on the leading singular vectors of all tables' columns."""
    weight = np.repeat([1.0, _MM_PER_RAD], 3)[:, None]
    weighted = [t.reshape(*t.shape[:2], -1) * weight / scale for t in tables]
    gram = sum(np.einsum("ckq,ckp->qp", w, w, optimize=True) for w in weighted)
    vectors = np.linalg.eigh(gram)[1][:, ::-1][:, :rank]
    rows = np.stack([w @ vectors / weight for w in weighted], axis=1)
    return rows.reshape(len(rows), -1), vectors.T * scale


def _with_ghosts(
    rows: Float[np.ndarray, "node column"], shape: tuple[int, int, int]
) -> Float[np.ndarray, "padded column"]:
    """Nodes beyond both ends of every axis, as parabolas go on (Keys' border)."""
    lattice = rows.reshape(*shape, -1)
    for axis in range(3):
        a = np.moveaxis(lattice, axis, 0)
        before, after = 3 * a[0] - 3 * a[1] + a[2], 3 * a[-1] - 3 * a[-2] + a[-3]
        lattice = np.moveaxis(np.concatenate([before[None], a, after[None]]), 0, axis)
    return np.ascontiguousarray(lattice).reshape(-1, rows.shape[1])
