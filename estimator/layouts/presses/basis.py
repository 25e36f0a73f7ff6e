"""Presses of one face at candidate magnets, compressed for scoring layouts in batches.

Presses to one force, and their derivatives in x, y and force, are a table (candidate, 6; place, 4).
A few singular vectors of its columns carry all of it, so that the many candidates around a magnet
are mixed as short rows and unfolded to places once a layout. Rows of the pressed face's candidates
and of the other faces', which move less, have bases of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.interpolate import make_interp_spline
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import (
    PlaceGrid,
    contact_grid,
    grid_places_in_lattice,
    press_lattice,
)
from design.layout.places.contact_places import contact_places
from design.search.faces import layout_groups
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from estimator.layouts.presses.compression import compressed, rms, with_ghosts, with_turns
from estimator.layouts.surfaces import Surface, surfaces
from estimator.signals.continuation import continued
from fem.candidates.motions import CandidateMotions, FaceCandidates

OTHER_RANK = 40
"""Singular vectors of the other faces' basis, which move less.

With 40 those bounds are off by 0.2 % (1.4 % at most; the worst one by 0.4 %), with 60 by 0.1 %.
"""
MORE_RANK = 1.2
"""Factor of that number where the vectors serve several forces at once."""
STRAIN_RANK = 96
"""Vectors on which the strain round magnets is kept, for what they take from each other.

With 96 the bounds at 2, 5 and 12 N are off by 0.2 % (3 % at most; the worst one of the fourteen layouts by
0.6 %), with 64 by 1.1 % (18 %; 2.7 %).
"""


@dataclass(frozen=True)
class RowTable:
    """Short rows on a regular lattice, with one ghost node beyond each end of every axis.

    `rows` (node, 6 · rank · faces), or (node of any face, 6 · rank) where faces differ; of a flat pressed
    face followed by what the rotation grows by with each rad that a magnet is turned about the face's x,
    3 · `compression.TURN_RANK` columns or less, and about its y. `basis` (rank, 4 · place) unfolds them to
    ∂/∂x, ∂/∂y, ∂/∂F and the motion itself, block by block: mm and rad, per mm, mm and N.
    """

    rows: Float[Tensor, "node column"]
    basis: Float[Tensor, "rank quantity"]

    def select_force(self, index: int, count: int) -> RowTable:
        """The same rows for one of several forces, whose quantities follow each other."""
        width = self.basis.shape[1] // count
        return RowTable(self.rows, self.basis[:, index * width : (index + 1) * width].contiguous())


@dataclass(frozen=True)
class StrainCoupling:
    """Strain that magnets of the pressed face take from each other as they resist it.

    `strain` (node, 5 · `STRAIN_RANK` or less): rows of the strain round each, on the first vectors of the
    face's own basis. `values`: `Influence`, of depths of the other and of its own and of distances, motion by
    motion; their lattice, distance first, begins at `first_mm` and is `span_mm` long.
    """

    strain: Float[Tensor, "node column"]
    values: Float[Tensor, "30 depth depth distance"]
    first_mm: Float[Tensor, "3"]
    span_mm: Float[Tensor, "3"]


@dataclass(frozen=True)
class Patch:
    """One of several unequal faces: its surface, its candidates' lattice along it, ghosts left out, and
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
    which places of the contact grid the face has; all that goes by places goes by these.
    Where faces are curved or differ in size, `patches` are this face, then the others in their order;
    else there are none, and one lattice serves all faces.
    `turn`, `shift_mm` take the other faces' frames to this one's: first those of `neighbours`
    (numbers of the adjacent faces), last that of the opposite one, where it is sensed. The opposite face
    has no rows: what motions of magnets that far away add does not show in the bounds. Of the shell
    without magnets, at every location: `deepest_n`, force of the deepest simulated press, and
    `mm_per_n`, indentation depth over force.
    """

    face: int
    neighbours: tuple[int, ...]
    force_n: float
    places: PlaceGrid
    on_face: Bool[np.ndarray, "grid_place"]
    first_mm: Float[Tensor, "3"]
    step_mm: Float[Tensor, "3"]
    nodes: tuple[int, int, int]
    own_table: RowTable
    other_table: RowTable
    turn: Float[Tensor, "face 3 3"]
    shift_mm: Float[Tensor, "face 3"]
    deepest_n: Float[Tensor, "place"]
    mm_per_n: Float[np.ndarray, "place"]
    held: StrainCoupling
    patches: tuple[Patch, ...] = ()

    @property
    def count(self) -> int:
        """Contact locations that the face has."""
        return int(self.on_face.sum())


def press_basis(
    spec: ObjectSpec,
    motions: CandidateMotions,
    face: int,
    force_n: float | None = None,
    own_rank: int | None = None,
    dtype: torch.dtype = torch.float32,
) -> PressBasis:
    """Return the `press_bases` of one force, `score.force_n` by default."""
    forces_n = (force_n or spec.score.force_n,)
    return press_bases(spec, motions, face, forces_n, own_rank, dtype)[0]


@one_thread()
def press_bases(
    spec: ObjectSpec,
    motions: CandidateMotions,
    face: int,
    forces_n: Sequence[float],
    own_rank: int | None = None,
    dtype: torch.dtype = torch.float32,
) -> tuple[PressBasis, ...]:
    """Compress the presses of one face to several forces, which share their rows.

    Between and beyond the two stored forces that belong to one motions go on straight, so that places
    that the presses could not load to it count as if they could. Derivatives in x and y, along the
    surface, are at constant force: those of cubic splines through the lattice of presses, as of the chain's
    signals (`estimator.signals.interpolation`).

    Parameters
    ----------
    own_rank : vectors of the face's own basis; by default as many as leave out no more than
        `compression.LEFT_OUT`

    Raises
    ------
    InputError
        A face that was not pressed, presses on another lattice, or of fewer than two forces.
    """
    check_lattices(spec, motions, face)
    frames = {frame.number: frame for frame in face_frames(spec)}
    here = frames.pop(face)
    others = sorted(frames.values(), key=lambda frame: _opposite(frame, here))
    adjacent = [frame.number for frame in others if not _opposite(frame, here)]
    has_place = contact_places(spec)[spec.body.sensed.index(face)]
    located = grid_places_in_lattice(spec)[has_place]
    differ, row = faces_differ(spec), motions.faces.tolist().index(face)
    lattices = {lattice.face: lattice for lattice in motions.candidates}
    lattice = lattices[face] if differ else motions.candidates[0]
    more = MORE_RANK if len(forces_n) > 1 else 1.0
    ranks = own_rank, int(more * OTHER_RANK)
    # Quantities of one force follow those of another: 4 for each (∂x, ∂y, ∂F, the motion itself).
    of_modes = np.concatenate(
        [press_derivatives(motions, face, force, located) for force in forces_n], axis=1
    )
    whole, adjoining, held = _tables(spec, motions, here, adjacent, of_modes, ranks, dtype)

    def tensor(values: object) -> Tensor:
        return torch.as_tensor(np.asarray(values), dtype=dtype)

    first, step = (tensor(part) for part in ends_and_steps(lattice))
    order = [face, *(frame.number for frame in others)]
    shared = PressBasis(
        face,
        tuple(adjacent),
        np.nan,
        contact_grid(spec),
        has_place,
        first,
        step,
        lattice.shape,
        whole,
        adjoining,
        # p in another face's frame is turn · p + shift in this one's: axes are columns
        tensor([here.axes.T @ frame.axes for frame in others]).reshape(-1, 3, 3),
        tensor([here.plane_coordinates(frame.centre_mm) for frame in others]).reshape(-1, 3),
        tensor(motions.deepest_n[row][located]),
        np.full(len(located), np.nan),
        held,
        patches_of(spec, [lattices[number] for number in order], dtype) if differ else (),
    )
    return tuple(
        replace(
            shared,
            force_n=force,
            own_table=whole.select_force(index, len(forces_n)),
            other_table=adjoining.select_force(index, len(forces_n)),
            mm_per_n=surface_compliance(motions, face, force)[located],
        )
        for index, force in enumerate(forces_n)
    )


def _tables(
    spec: ObjectSpec,
    motions: CandidateMotions,
    here: FaceFrame,
    adjacent: Sequence[int],
    of_modes: Float[np.ndarray, "mode quantity place"],
    ranks: tuple[int | None, int],
    dtype: torch.dtype,
) -> tuple[RowTable, RowTable, StrainCoupling]:
    """Return the tables of the pressed face and of its neighbours, and how its magnets move each other."""
    face, differ = here.number, faces_differ(spec)
    lattices = {lattice.face: lattice for lattice in motions.candidates}
    row = motions.faces.tolist().index(face)
    # Quantities have different units: each is divided by its rms, so that one rank suits all of them.
    own_modes, *moving = (modes_of(motions, number, row, here.axes) for number in (face, *adjacent))
    scale = rms(own_modes, of_modes)
    widths = np.repeat(scale, of_modes.shape[2])

    def table(numbers: Sequence[int], rows: list[np.ndarray], basis: np.ndarray) -> RowTable:
        # Faces that differ have a lattice each, one below the other; else one lattice, side by side.
        if differ:
            each = zip(numbers, rows, strict=True)
            padded = np.concatenate([with_ghosts(part, lattices[n].shape) for n, part in each])
        else:
            padded = with_ghosts(np.concatenate(rows, axis=1), motions.candidates[0].shape)
        return RowTable(torch.as_tensor(padded, dtype=dtype), torch.as_tensor(basis, dtype=dtype))

    rows, basis = compressed([own_modes], of_modes, scale, ranks[0])
    if here.flat:
        rows = [with_turns(rows[0], lattices[face], motions.jeffery_parameter)]
    adjoining = _nothing(of_modes, dtype)
    if moving:
        adjoining = table(adjacent, *compressed(moving, of_modes, scale, ranks[1]))
    # `compressed` returns vectors times `widths`: undone here, as strain needs them orthonormal.
    held = _held(motions, lattices[face], of_modes, basis / widths, widths, dtype)
    return table([face], rows, basis), adjoining, held


def faces_differ(spec: ObjectSpec) -> bool:
    """Return whether faces are curved, round, of different sizes or have layouts of their own.

    One layout, turned from face to face on one lattice, then does not describe all of them.
    """
    frames = face_frames(spec)
    several_layouts = len(layout_groups(spec)) > 1 or len(spec.magnets.lists) > 1
    sizes = {frame.half_extents_mm for frame in frames}
    return (
        several_layouts
        or len(sizes) > 1
        or not all(frame.flat and not frame.round for frame in frames)
    )


def patches_of(
    spec: ObjectSpec, lattices: Sequence[FaceCandidates], dtype: torch.dtype
) -> tuple[Patch, ...]:
    """Return the patch of the pressed face, then those of the others."""
    patches, start, by_number = [], 0, surfaces(spec)
    for index, lattice in enumerate(lattices):
        first, step = (torch.as_tensor(part, dtype=dtype) for part in ends_and_steps(lattice))
        patches.append(Patch(by_number[lattice.face], first, step, lattice.shape, start))
        # The pressed face (index 0) has a table of its own; the others share one, each with 2 ghost
        # nodes along every axis.
        if index:
            start += int(np.prod([count + 2 for count in lattice.shape]))
    return tuple(patches)


def ends_and_steps(lattice: FaceCandidates) -> tuple[np.ndarray, np.ndarray]:
    ends = np.array([[n[0], n[1]] for n in (lattice.x_mm, lattice.y_mm, lattice.depth_mm)])
    return ends[:, 0], ends[:, 1] - ends[:, 0]


def _nothing(of_modes: Float[np.ndarray, "mode quantity place"], dtype: torch.dtype) -> RowTable:
    """Return the empty table of a face without neighbours."""
    quantities = of_modes[0].size
    return RowTable(torch.zeros(0, 0, dtype=dtype), torch.zeros(0, quantities, dtype=dtype))


def surface_compliance(
    motions: CandidateMotions, pressed: int, force_n: float
) -> Float[np.ndarray, "place"]:
    """Return indentation depth over force (mm/N): a secant, straight between and beyond stored forces."""
    row = motions.faces.tolist().index(pressed)
    steps = motions.steps_around(force_n)
    (low, high), depth = motions.force_n[row][:, steps].T, motions.depth_mm[row][:, steps]
    share = (force_n - low) / (high - low)
    return (depth[:, 0] + share * (depth[:, 1] - depth[:, 0])) / force_n


def _opposite(a: FaceFrame, b: FaceFrame) -> bool:
    # Cosine of the normals' angle: about 0 of adjacent faces, −1 of opposite ones; any bound between.
    return bool(a.normal @ b.normal < -0.5)


def check_lattices(spec: ObjectSpec, motions: CandidateMotions, face: int) -> None:
    """Refuse motions that do not fit a face of the specification.

    Raises
    ------
    InputError
        As `press_bases`.
    """
    if face not in motions.faces:
        raise InputError(f"face {face} was not pressed. Choose one of {motions.faces.tolist()}")
    # ∂/∂F is a difference of two stored forces.
    if motions.force_n.shape[2] < 2:
        raise InputError("derivatives of presses need two forces; got one. Simulate more")
    # Quantities are picked by place: another lattice would give those of other places, unnoticed.
    lattice = press_lattice(spec)
    if motions.places.shape != lattice.shape or not np.allclose(
        motions.places.xy_mm, lattice.xy_mm
    ):
        raise InputError(
            f"presses were simulated on {motions.places.shape} places, not on the lattice of this "
            f"specification's contact grid, {lattice.shape}. Simulate them anew"
        )
    # Faces that are alike share the first face's lattice.
    first = motions.candidates[0].xyd_mm
    for lattice in () if faces_differ(spec) else motions.candidates:
        if lattice.xyd_mm.shape != first.shape or not np.allclose(lattice.xyd_mm, first):
            raise InputError(
                f"candidates of face {lattice.face} are not those of face "
                f"{motions.candidates[0].face}: one layout cannot be repeated on faces of different "
                "sizes. Use a body with equal edges"
            )


def press_derivatives(
    motions: CandidateMotions,
    pressed: int,
    force_n: float,
    located: Int[np.ndarray, "place"],
) -> Float[np.ndarray, "mode 4 place"]:
    """Return ∂/∂x, ∂/∂y, ∂/∂F of the modes' shares in presses, and the shares themselves.

    At places of the lattice; per mm, per mm and per N.
    """
    row = motions.faces.tolist().index(pressed)
    steps = motions.steps_around(force_n)
    force, pressed_there = motions.force_n[row][:, steps], ~np.isnan(motions.force_n[row, :, 0])
    # Straight in force between the two stored steps of each place, and beyond them.
    low, high = (np.asarray(motions.presses[row, :, step], float) for step in steps)
    per_n = (high - low) / (force[:, 1] - force[:, 0])[:, None]
    share = low + per_n * (force_n - force[:, 0])[:, None]
    shape = motions.places.shape
    # Splines run through the whole lattice: places that the face has not are continued smoothly.
    share = continued(share, pressed_there, shape)
    # Matrices (node, node): derivatives at the nodes of the cubic splines through unit vectors.
    along_x, along_y = (
        make_interp_spline(nodes, np.eye(len(nodes)), k=3)(nodes, nu=1)
        for nodes in (motions.places.x_mm, motions.places.y_mm)
    )
    table = share.reshape(*shape, -1)
    # p and q nodes along x and y, r mode; i and j the nodes where the derivative is taken
    by_x = np.einsum("ip,pqr->iqr", along_x, table).reshape(share.shape)
    by_y = np.einsum("jq,pqr->pjr", along_y, table).reshape(share.shape)
    return np.stack([by_x, by_y, per_n, share])[:, located].transpose(2, 0, 1)


def _held(
    motions: CandidateMotions,
    lattice: FaceCandidates,
    of_modes: Float[np.ndarray, "mode quantity place"],
    vectors: Float[np.ndarray, "rank column"],
    scale: Float[np.ndarray, "column"],
    dtype: torch.dtype,
) -> StrainCoupling:
    """Return how magnets of the pressed face move each other, on its own basis.

    `vectors` are the basis for quantities divided by `scale`: orthonormal, so that a product with
    their transpose projects on them.
    """
    number = [candidates.face for candidates in motions.candidates].index(lattice.face)
    first = sum(map(len, motions.candidates[:number]))
    strain = np.asarray(motions.strain[first : first + len(lattice)], dtype=float)
    mixed = of_modes.reshape(len(of_modes), -1) / scale @ vectors[:STRAIN_RANK].T
    # c candidate, r mode, s of 5 strains, t basis vector
    rows = np.einsum("crs,rt->cst", strain, mixed, optimize=True)
    between = motions.influence
    values = between.values.transpose(3, 4, 0, 1, 2).reshape(30, *between.values.shape[:3])
    # As `grid_sample` wants them: (6 · 5 motions and strains, depth, depth, distance) of the table, but
    # ends in the order distance, own depth, the other's depth. Both depths have the same nodes.
    ends = np.array([between.first_mm, *2 * [between.depth_mm[0]]])
    span = [between.step_mm * (values.shape[3] - 1), *2 * [np.ptp(between.depth_mm)]]
    return StrainCoupling(
        torch.as_tensor(with_ghosts(rows.reshape(len(rows), -1), lattice.shape), dtype=dtype),
        torch.as_tensor(values, dtype=dtype),
        torch.as_tensor(ends, dtype=dtype),
        torch.as_tensor(np.array(span), dtype=dtype),
    )


def modes_of(
    motions: CandidateMotions, face: int, row: int, axes: Float[np.ndarray, "3 3"]
) -> Float[np.ndarray, "candidate 6 mode"]:
    """Return the modes of a face's candidates under presses of face `row`, along the columns of `axes`.

    `row` counts the pressed faces. Displacements and rotations are turned alike, as vectors.
    """
    number = [lattice.face for lattice in motions.candidates].index(face)
    first = sum(len(lattice) for lattice in motions.candidates[:number])
    chosen = slice(first, first + len(motions.candidates[number]))
    modes = np.asarray(motions.by_candidate[chosen, row], dtype=float)
    # (candidate, mode, displacement or rotation, component): v @ axes are v's parts along the columns
    turned = modes.reshape(*modes.shape[:2], 2, 3) @ axes
    return turned.reshape(modes.shape).transpose(0, 2, 1)
