"""Presses of one face at candidate magnets, compressed for scoring layouts in batches.

Presses to one force, and their derivatives in x, y and force, are a table (candidate, 6; place, 4).
A few singular vectors of its columns carry all of it, so that the many candidates around a magnet
are mixed as short rows and unfolded to places once a layout. Rows of the pressed face's candidates
and of the other faces', which move less, have bases of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.interpolate import make_interp_spline
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import PlaceGrid
from design.layout.places.contact_places import contact_places
from design.search.faces import layout_groups
from design.spec.object import ObjectSpec
from estimator.information.scores import outermost_places
from estimator.layouts.surfaces import Surface, surfaces
from fem.candidates.motions import CandidateMotions, FaceCandidates

OTHER_RANK = 40
"""Of the other faces' basis: 40 leave 2 % of a random layout's worst bound, 24 leave 5 %."""
_MM_PER_RAD = 4.0
"""Weight of rotations beside displacements: both then change a magnet's field about alike."""


@dataclass(frozen=True)
class RowTable:
    """Short rows on a regular lattice, with one ghost node beyond each end of every axis.

    `rows` (node, 6 · rank · faces), or (node of any face, 6 · rank) where faces differ; of a flat pressed
    face (node, 12 · rank), with what the rotation grows by with each rad that a magnet is turned about
    the face's x, and about its y. `basis` (rank, 4 · place) unfolds them to ∂/∂x, ∂/∂y, ∂/∂F and the
    motion itself, block by block: mm and rad, per mm, mm and N.
    """

    rows: Float[Tensor, "node column"]
    basis: Float[Tensor, "rank quantity"]


@dataclass(frozen=True)
class Patch:
    """One face of those that differ: its surface, its candidates' lattice along it, ghosts left out, and
    where its rows begin in the table."""

    surface: Surface
    first_mm: Float[Tensor, "3"]
    step_mm: Float[Tensor, "3"]
    nodes: tuple[int, int, int]
    start: int


@dataclass(frozen=True)
class PressBasis:
    """Presses of one face to `force_n` (N), as motions in the face's own frame (z outward).

    `first_mm`, `step_mm`, `nodes`: the candidates' lattice in (x, y, depth), ghosts left out. `there`:
    which places of the contact grid the face has; all that is told by places is told of these.
    Where faces are curved or differ in size, `patches` are this face, then the others in their order;
    else there are none, and one lattice serves all faces.
    `turn`, `shift_mm` take the other faces' frames to this one's: first those of `neighbours`
    (numbers of the adjacent faces), last that of `opposite`, where it is sensed. The opposite face
    has no rows: what motions of magnets that far away add does not show in the bounds. Of the shell
    without magnets, at every location: `deepest_n`, force of the deepest simulated press, and
    `mm_per_n`, indentation depth over force.
    """

    face: int
    neighbours: tuple[int, ...]
    opposite: int | None
    force_n: float
    places: PlaceGrid
    there: Bool[np.ndarray, "grid_place"]
    first_mm: Float[Tensor, "3"]
    step_mm: Float[Tensor, "3"]
    nodes: tuple[int, int, int]
    own: RowTable
    other: RowTable
    turn: Float[Tensor, "face 3 3"]
    shift_mm: Float[Tensor, "face 3"]
    deepest_n: Float[Tensor, "place"]
    mm_per_n: Float[np.ndarray, "place"]
    patches: tuple[Patch, ...] = ()

    @property
    def count(self) -> int:
        """Contact locations that the face has."""
        return int(self.there.sum())

    @cached_property
    def outermost(self) -> Bool[Tensor, "place"]:
        """Places of the face's outermost ring, corners included."""
        return torch.as_tensor(outermost_places(self.places, self.there)[self.there])

    def rows_of(self, places: Int[np.ndarray, "some"]) -> Int[np.ndarray, "some"]:
        """Rows that places of the contact grid have among the face's own."""
        return (np.cumsum(self.there) - 1)[places]


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
    that the presses could not load to it count as if they could. Derivatives in x and y, along the
    surface, are at constant force: those of cubic splines through the contact locations, or of an r⁵
    spline where the face has not all of the grid.

    Parameters
    ----------
    own_rank : as many as there are places by default, which leaves 0.5 % of a random layout's worst
        bound; 80 for 100 places leave 8 %: where little is seen, little may be left out

    Raises
    ------
    InputError
        A face that was not pressed, fewer than two forces or four locations per axis.
    """
    _check(spec, motions, face)
    force_n = force_n or spec.score.force_n
    frames = {frame.number: frame for frame in face_frames(spec)}
    here = frames.pop(face)
    others = sorted(frames.values(), key=lambda frame: _opposite(frame, here))
    adjacent = [frame.number for frame in others if not _opposite(frame, here)]
    there = contact_places(spec)[spec.body.sensed.index(face)]
    differ = faces_differ(spec)
    derive = partial(
        _derivatives,
        motions,
        pressed=face,
        axes=here.axes,
        force_n=force_n,
        there=there,
    )
    own, *moving = (derive(number) for number in (face, *adjacent))
    scale = np.sqrt(np.mean(own**2, axis=(0, 1, 3)))
    scale = np.repeat(np.where(scale > 0, scale, 1.0), int(there.sum()))
    lattices = {lattice.face: lattice for lattice in motions.candidates}
    lattice = lattices[face] if differ else motions.candidates[0]

    def tensor(values: object) -> Tensor:
        return torch.as_tensor(np.asarray(values), dtype=dtype)

    def table(numbers: list[int], parts: list[np.ndarray], rank: int) -> RowTable:
        rows, basis = _compressed(parts, scale, rank)
        if numbers == [face] and here.flat:
            rows = [_with_turns(rows[0], lattices[face], motions.turns_with_plane)]
        if differ:
            each = [
                _with_ghosts(one, lattices[n].shape) for n, one in zip(numbers, rows, strict=True)
            ]
            return RowTable(tensor(np.concatenate(each)), tensor(basis))
        return RowTable(
            tensor(_with_ghosts(np.concatenate(rows, axis=1), lattice.shape)), tensor(basis)
        )

    opposite = [frame.number for frame in others if _opposite(frame, here)]
    first, step = (tensor(part) for part in _ends_and_steps(lattice))
    order = [face, *(frame.number for frame in others)]
    return PressBasis(
        face,
        tuple(adjacent),
        opposite[0] if opposite else None,
        force_n,
        motions.places,
        there,
        first,
        step,
        lattice.shape,
        table([face], [own], own_rank or int(there.sum())),
        table(adjacent, moving, other_rank) if moving else _nothing(scale, dtype),
        tensor([here.axes.T @ frame.axes for frame in others]).reshape(-1, 3, 3),
        tensor([here.in_plane(frame.centre_mm) for frame in others]).reshape(-1, 3),
        tensor(motions.deepest_n[motions.faces.tolist().index(face)][there]),
        _compliance(motions, face, force_n)[there],
        _patches(spec, [lattices[number] for number in order], dtype) if differ else (),
    )


def faces_differ(spec: ObjectSpec) -> bool:
    """Whether faces are curved, round, of different sizes or have layouts of their own: one layout turned
    from face to face, on one lattice, then does not tell all of them."""
    frames = face_frames(spec)
    own = len(layout_groups(spec)) > 1 or len(spec.magnets.lists) > 1
    sizes = {frame.half_extents_mm for frame in frames}
    return own or len(sizes) > 1 or not all(frame.flat and not frame.round for frame in frames)


def _patches(
    spec: ObjectSpec, lattices: Sequence[FaceCandidates], dtype: torch.dtype
) -> tuple[Patch, ...]:
    """The pressed face, then the others."""
    found, start, known = [], 0, surfaces(spec)
    for index, lattice in enumerate(lattices):
        first, step = (torch.as_tensor(part, dtype=dtype) for part in _ends_and_steps(lattice))
        found.append(Patch(known[lattice.face], first, step, lattice.shape, start))
        if index:
            start += int(np.prod([count + 2 for count in lattice.shape]))
    return tuple(found)


def _ends_and_steps(lattice: FaceCandidates) -> tuple[np.ndarray, np.ndarray]:
    ends = np.array([[n[0], n[1]] for n in (lattice.x_mm, lattice.y_mm, lattice.depth_mm)])
    return ends[:, 0], ends[:, 1] - ends[:, 0]


def _nothing(scale: np.ndarray, dtype: torch.dtype) -> RowTable:
    """Of a face without neighbours."""
    return RowTable(torch.zeros(0, 0, dtype=dtype), torch.zeros(0, len(scale), dtype=dtype))


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


def _check(spec: ObjectSpec, motions: CandidateMotions, face: int) -> None:
    if face not in motions.faces:
        raise InputError(f"face {face} was not pressed. Choose one of {motions.faces.tolist()}")
    if motions.force_n.shape[2] < 2 or min(motions.places.shape) < 4:
        raise InputError(
            "derivatives of presses need two forces and four locations per axis; got "
            f"{motions.force_n.shape[2]} forces and {motions.places.shape} places. Simulate more"
        )
    first = motions.candidates[0].xyd_mm
    for lattice in () if faces_differ(spec) else motions.candidates:
        if lattice.xyd_mm.shape != first.shape or not np.allclose(lattice.xyd_mm, first):
            raise InputError(
                f"candidates of face {lattice.face} are not those of face "
                f"{motions.candidates[0].face}: one layout cannot be repeated on faces of different "
                "sizes. Use a body with equal edges"
            )


def _derivatives(
    motions: CandidateMotions,
    face: int,
    pressed: int,
    axes: Float[np.ndarray, "3 3"],
    force_n: float,
    there: Bool[np.ndarray, "grid_place"],
) -> Float[np.ndarray, "candidate 6 4 place"]:
    """∂/∂x, ∂/∂y, ∂/∂F and the motion of one face's candidates, along the columns of `axes`, at the
    places that are there."""
    row = motions.faces.tolist().index(pressed)
    number = [lattice.face for lattice in motions.candidates].index(face)
    first = sum(len(lattice) for lattice in motions.candidates[:number])
    chosen = slice(first, first + len(motions.candidates[number]))
    steps = motions.steps_around(force_n)
    stored = np.asarray(motions.by_candidate[chosen, row, :, steps], dtype=float)
    force = motions.force_n[row][:, steps]
    shape, scattered = motions.places.shape, not there.all()
    if scattered:
        stored, force, shape = stored[:, :, there], force[there], (int(there.sum()), 1)
    low, high = stored.reshape(2, -1, *shape, 2, 3) @ axes
    force = force.reshape(*shape, 2, 1, 1)
    per_n = (high - low) / (force[:, :, 1] - force[:, :, 0])
    motion = low + per_n * (force_n - force[:, :, 0])
    if scattered:
        slopes = scattered_slopes(motions.places.xy_mm[there])
        by_x, by_y = (np.einsum("ip,cpqkv->ciqkv", slope, motion) for slope in slopes)
    else:
        along_x, along_y = (
            make_interp_spline(nodes, np.eye(len(nodes)), k=3)(nodes, nu=1)
            for nodes in (motions.places.x_mm, motions.places.y_mm)
        )
        by_x = np.einsum("ip,cpqkv->ciqkv", along_x, motion)
        by_y = np.einsum("jq,cpqkv->cpjkv", along_y, motion)
    parts = np.stack([by_x, by_y, per_n, motion], axis=-1)
    return parts.reshape(len(motion), -1, 6, 4).transpose(0, 2, 3, 1)


def scattered_slopes(
    xy_mm: Float[np.ndarray, "place 2"],
) -> tuple[Float[np.ndarray, "place place"], Float[np.ndarray, "place place"]]:
    """∂/∂x and ∂/∂y at places from values at all of them: of the r⁵ spline through these.

    Polyharmonic, with parabolas (Duchon, RAIRO Anal. Numér. 10 (1976) 5): where places fill a square
    or a disk 3 mm apart its slopes are as good as a cubic spline's or better.
    """
    scale = np.ptp(xy_mm, axis=0).max() / 2
    at = xy_mm / scale
    away = at[:, None] - at
    distance = np.linalg.norm(away, axis=2)
    powers = [(a, n - a) for n in range(3) for a in range(n + 1)]
    x, y = at.T
    parabolas = np.stack([x**a * y**b for a, b in powers], axis=1)
    by_axis = (
        np.stack([a * x ** max(a - 1, 0) * y**b for a, b in powers], axis=1),
        np.stack([b * x**a * y ** max(b - 1, 0) for a, b in powers], axis=1),
    )
    system = np.block(
        [[distance**5, parabolas], [parabolas.T, np.zeros((len(powers), len(powers)))]]
    )
    weights = np.linalg.solve(system, np.eye(len(system))[:, : len(at)])
    slopes = (
        np.hstack([5 * distance**3 * away[..., k], by_axis[k]]) @ weights / scale for k in (0, 1)
    )
    by_x, by_y = slopes
    return by_x, by_y


def _compressed(
    tables: list[np.ndarray], scale: Float[np.ndarray, "quantity"], rank: int
) -> tuple[list[Float[np.ndarray, "node column"]], Float[np.ndarray, "rank quantity"]]:
    """Rows (node; 6, rank) of each table on the leading singular vectors of all tables' columns."""
    weight = np.repeat([1.0, _MM_PER_RAD], 3)[:, None]
    weighted = [t.reshape(*t.shape[:2], -1) * weight / scale for t in tables]
    gram = sum(np.einsum("ckq,ckp->qp", w, w, optimize=True) for w in weighted)
    vectors = np.linalg.eigh(gram)[1][:, ::-1][:, :rank]
    rows = [(w @ vectors / weight).reshape(len(w), -1) for w in weighted]
    return rows, vectors.T * scale


def _with_turns(
    rows: Float[np.ndarray, "node column"], lattice: FaceCandidates, turns_with_plane: float
) -> Float[np.ndarray, "node wider"]:
    """Rows of a flat face, and by what the rotations grow with each rad about x, and about y.

    A magnet turns with the silicone's plane that it lies in, as far as strain turns it: by the slopes of
    the candidates' displacements, to first order in its tilt. At 15 to 20° the rotations of a disk of
    6 × 1 mm are off by 9 %, without this by 30 %.
    """
    nodes = rows.reshape(*lattice.shape, 6, -1)
    along = (lattice.x_mm, lattice.y_mm, -lattice.depth_mm)
    slopes = np.stack(
        [np.gradient(nodes[..., :3, :], at, axis=k, edge_order=2) for k, at in enumerate(along)],
        axis=-2,
    )  # (…, component, direction, rank)
    grown = []
    for about in np.eye(3)[:2]:
        cross = np.cross(about, np.eye(3)).T  # cross @ v = about × v
        change = np.einsum("...cdr,de->...cer", slopes, cross)
        change -= np.einsum("bc,...cdr->...bdr", cross, slopes)
        turned = np.einsum("bc,...cr->...br", cross, _turn_of_plane(slopes))
        grown.append(turns_with_plane * (_turn_of_plane(change) + turned))
    return np.concatenate([nodes, *grown], axis=-2).reshape(len(rows), -1)


def _turn_of_plane(
    slopes: Float[np.ndarray, "*node 3 3 rank"],
) -> Float[np.ndarray, "*node 3 rank"]:
    """Rotation vector of the material plane z = const. under slopes ∂u_c/∂x_d."""
    spin = (slopes[..., 1, 0, :] - slopes[..., 0, 1, :]) / 2
    return np.stack([slopes[..., 2, 1, :], -slopes[..., 2, 0, :], spin], axis=-2)


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
