"""Presses of the magnet-free shell, recorded at every candidate place of a magnet.

They go to the lattice of the chain's own presses, so that slopes along the surface are as good as there.
From contact locations alone, twice as far apart, position bounds scattered by 21 % place by place, from the
lattice by 11 %. That is of seven layouts of the paper's cube at 2, 5 and 12 N, one face, against rigid
magnets tied to the same mesh.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from threading import Event

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float, Float32

from design.files import atomic_path, reserve_room
from design.layout.body import face_frame
from design.layout.places.contact_grid import press_lattice
from design.layout.places.contact_places import pressed_nodes
from design.processes import one_blas_thread
from design.spec.object import ObjectSpec
from fem.candidates.cubic_convolution import extension
from fem.candidates.influence import influence
from fem.candidates.motions import (
    MM_PER_RAD,
    MOTIONS_FILE,
    CandidateMotions,
    FaceCandidates,
    Influence,
    known_places,
    save_candidates,
)
from fem.candidates.rigid_body import (
    BodyRows,
    RigidBody,
    candidate_rows,
    tied_magnets,
)
from fem.linear.factorization import Factorization, pardiso_available
from fem.linear.response import (
    ResponseOperator,
    elastic_system,
    face_pressure_loads,
)
from fem.mesh.tetrahedra import TetMesh
from fem.presses.table import press_places, surface_weights_mm2

FORCE_SHARES = (0.8, 1.2)
_LEAST_PRESSURE = 1e-7
"""Share of the largest pattern of pressure below which a pattern is left out."""
_LEAST_MODE = 3e-4
"""Share of the largest mode below which a mode of the candidates is left out.

Such modes change position bounds by less than 0.1 % (rms over places of fourteen layouts of the paper's
cube; 1.5 % at most), modes below 1e-3 by 0.24 % (3 %)."""
_LEAST_MOTION = 1e-3
"""Share of the largest motions of all candidates below which those of a face stay 0.

Patterns of pressure are solved by the energy that they leave, until all faces' fall below. On the paper's
cube half of 3136 patterns are. Position bounds of seven layouts change by 0.6 % at 3.5 N (rms over places)
and by 2.4 % at 1 N, where the worst place changes by 16 %. The level itself scatters by 11 %."""
_CHUNK = 32
"""Right-hand sides solved at once: it bounds the memory."""

Progress = Callable[[str], None]


@dataclass(frozen=True)
class PressesAtForce:
    """Pressures (place, step, vertex) on one face in MPa, their forces (N) and depths (mm); the force of the
    deepest simulated press."""

    pressure_mpa: Float[np.ndarray, "place step vertex"]
    force_n: Float[np.ndarray, "place step"]
    depth_mm: Float[np.ndarray, "place step"]
    deepest_n: Float[np.ndarray, "place"]


_InPatterns = tuple[PressesAtForce, np.ndarray, np.ndarray]
"""Presses of a face, each press's share of its patterns of pressure, and the patterns (`_patterns`)."""


def _kept(folder: Path, face: int, make: Callable[[], PressesAtForce]) -> PressesAtForce:
    """Return the presses of a face that the folder holds, else make and keep them."""
    path = folder / f"presses_face_{face}.npz"
    if path.is_file():
        with np.load(path) as stored:
            return PressesAtForce(**stored)
    presses = make()
    with atomic_path(path) as temporary, temporary.open("wb") as file:
        np.savez_compressed(file, **vars(presses))  # most vertices are beside the contact: zeros
    return presses


def simulate_candidates(
    spec: ObjectSpec,
    mesh: TetMesh,
    response: ResponseOperator,
    lattices: tuple[FaceCandidates, ...],
    folder: Path | str,
    force_shares: Sequence[float] = FORCE_SHARES,
    progress: Progress | None = None,
    unfinished: Path | None = None,
) -> CandidateMotions:
    """Press every place of the lattice on a magnet-free mesh, record every candidate, write the folder.

    Presses go to `force_shares` of every one of `spec.pressed_forces_n`, or of less where the deepest
    simulated press does not reach the largest share. Between simulated depths pressures are interpolated
    linearly: forces and equilibrium stay exact. A slip of the core is left out. Contact of each face is
    kept in the folder `unfinished`, from which a run that was broken off goes on.

    Raises
    ------
    InputError
        A candidate outside the silicone.
    SingularSystemError
        The matrix could not be factored.
    """

    broken_off = Event()

    def contact(index: int) -> PressesAtForce:
        presses = presses_at_forces(spec, response, index, force_shares)
        if broken_off.is_set():  # more threads may have made it, with other last digits
            raise CancelledError
        return presses

    def pressed(index: int) -> _InPatterns:
        number, make = response.surfaces[index].number, partial(contact, index)
        presses = make() if unfinished is None else _kept(unfinished, number, make)
        loads = response.face_loads(index)
        share, patterns = _patterns(presses.pressure_mpa, response.compliance[loads, loads])
        # patterns hold all of the pressures, which take the most memory and are dropped: an array of
        # none, as a view of them would keep them
        none = np.zeros((*presses.pressure_mpa.shape[:2], 0))
        without = replace(presses, pressure_mpa=none)
        return without, share.astype(np.float32), patterns

    # contact of faces to come on a second core, while this one solves; both on one thread of linear
    # algebra throughout, so that results are the same, run for run
    pardiso_available()  # loads MKL, which the limit could not find later
    ahead = ThreadPoolExecutor(1)
    with one_blas_thread():
        try:
            begin = partial(ahead.submit, pressed)
            presses, recorded, body, between = _record(
                spec, mesh, response, begin, lattices, progress
            )
        finally:
            # an error is raised at once, while contact at work goes on to its end unread
            broken_off.set()
            ahead.shutdown(wait=False, cancel_futures=True)
    has_place = pressed_nodes(spec)
    force, depth, deepest = (
        np.stack(
            [
                values_on_grid(face_places, getattr(press, name))
                for face_places, press in zip(has_place, presses, strict=True)
            ]
        )
        for name in ("force_n", "depth_mm", "deepest_n")
    )
    modes = max(len(face_motions.presses.T) for face_motions in recorded)
    count = sum(len(lattice) for lattice in lattices)
    motions_file = Path(folder) / MOTIONS_FILE
    by_candidate = np.lib.format.open_memmap(
        motions_file, "w+", np.float32, (count, len(recorded), modes, 6)
    )
    reserve_room(motions_file, by_candidate.offset)
    mixed = np.zeros((*force.shape, modes), np.float32)
    strain = np.zeros((count, modes, 5), np.float32)
    for index, (face_places, face_motions) in enumerate(zip(has_place, recorded, strict=True)):
        used = face_motions.presses.shape[1]
        by_candidate[:, index, :used] = face_motions.by_candidate
        mixed[index, face_places, :, :used] = face_motions.presses.reshape(
            int(face_places.sum()), -1, used
        )
        strain[face_motions.under_face, :used] = face_motions.strain
    by_candidate.flush()
    faces = np.array([surface.number for surface in response.surfaces])
    table = CandidateMotions(
        faces,
        press_lattice(spec),
        force,
        depth,
        deepest,
        lattices,
        by_candidate,
        mixed,
        body.jeffery_parameter,
        strain,
        between,
    )
    save_candidates(table, folder)
    return table


def presses_at_forces(
    spec: ObjectSpec, response: ResponseOperator, face_index: int, force_shares: Sequence[float]
) -> PressesAtForce:
    """Contact at shares of every judged force at every place of the lattice that one face has.

    Steps are the shares of the first force, then of the second, and so on.

    Raises
    ------
    InputError
        A tip that would hang over the face's border.
    """
    depths = np.append(0.0, spec.press.depths_mm)
    places = press_lattice(spec).xy_mm[pressed_nodes(spec)[face_index]]
    pressed = press_places(spec, response, face_index, places, depths[1:])
    pressed = np.concatenate([np.zeros_like(pressed[:, :1]), pressed], axis=1)
    reached = pressed @ surface_weights_mm2(response.surfaces[face_index])
    shares = np.asarray(force_shares)
    most = np.minimum(np.array(spec.pressed_forces_n), reached[:, -1:] / shares.max())
    force = (shares * most[:, :, None]).reshape(len(places), -1)
    after = np.argmax(reached[:, None] >= force[:, :, None] * (1 - 1e-12), axis=2)
    place = np.arange(len(places))[:, None]
    low, high = reached[place, after - 1], reached[place, after]
    share = (force - low) / (high - low)
    below, above = pressed[place, after - 1], pressed[place, after]
    mixed = below + share[..., None] * (above - below)
    depth = depths[after - 1] + share * np.diff(depths)[after - 1]
    return PressesAtForce(mixed, force, depth, reached[:, -1])


@dataclass(frozen=True)
class _Recorded:
    """Motions under presses of one face, in its own modes: motions of candidates, strain round candidates
    under that face, and what each press has of every mode."""

    under_face: slice
    strain: Float32[np.ndarray, "own_candidate mode 5"]
    by_candidate: Float32[np.ndarray, "candidate mode 6"]
    presses: Float32[np.ndarray, "press mode"]


def _record(
    spec: ObjectSpec,
    mesh: TetMesh,
    response: ResponseOperator,
    begin_contact: Callable[[int], Future[_InPatterns]],
    lattices: tuple[FaceCandidates, ...],
    progress: Progress | None,
) -> tuple[list[PressesAtForce], list[_Recorded], RigidBody, Influence]:
    """Record every pressed face; return the magnet that moves so and how others move it too."""
    coming = begin_contact(0)
    system = elastic_system(mesh, spec)
    basis = sp.csr_matrix(system.motion_basis, dtype=np.float32)
    loads = sp.csc_matrix(basis.T @ face_pressure_loads(system.space, spec)[1], dtype=np.float32)
    is_known = [
        np.repeat(known_places(spec, candidates), len(candidates.depth_mm))
        for candidates in lattices
    ]
    filled, presses, recorded = filled_candidates(lattices, is_known), [], []
    with Factorization(system.matrix, single=True) as factor:
        body, tied = tied_magnets(spec, system, factor, lattices)
        between = influence(spec, system.space, body, tied, lattices)
        placed = [
            _placed(spec, lattice.face, lattice.xyd_mm[here])
            for lattice, here in zip(lattices, is_known, strict=True)
        ]
        whole = [_single_precision(candidate_rows(system.space, *place, body)) for place in placed]
        for index, surface in enumerate(response.surfaces):
            face_presses, share, patterns = coming.result()
            number = surface.number
            if progress:
                progress(f"face {number}: contact at {len(face_presses.force_n)} places")
            if index + 1 < len(response.surfaces):
                coming = begin_contact(index + 1)
            own_loads = response.face_loads(index)
            (under,) = (k for k, candidates in enumerate(lattices) if candidates.face == number)
            rows = [whole[k] if k == under else whole[k].motions for k in range(len(whole))]
            moved = _moved(basis, factor, loads[:, own_loads], patterns, rows)
            moved[under], strain = np.split(moved[under], [6], axis=1)
            solved = strain.shape[2]
            motion, of_patterns = compressed(np.concatenate(moved))
            strain = strain @ of_patterns.astype(np.float32)
            begin = sum(map(len, lattices[:under]))
            presses.append(face_presses)
            recorded.append(
                _Recorded(
                    slice(begin, begin + len(lattices[under])),
                    filled_candidates((lattices[under],), [is_known[under]])(
                        strain.transpose(0, 2, 1)
                    ),
                    filled(motion),
                    share[:, :solved] @ of_patterns.astype(np.float32),
                )
            )
            if progress:
                progress(f"face {number}: {len(share)} presses")
    return presses, recorded, body, between


def _single_precision(rows: BodyRows) -> BodyRows:
    """Return rows in single precision, in which motions are stored: half the memory and time."""
    return BodyRows(rows.columns.astype(np.int32), rows.weights.astype(np.float32))


def _moved(
    basis: sp.csr_matrix,
    factor: Factorization,
    loads_n: sp.csc_matrix,
    patterns: Float[np.ndarray, "pattern vertex"],
    rows: Sequence[BodyRows],
) -> list[Float32[np.ndarray, "candidate figure solved"]]:
    """Return what rows of every face give under patterns, as many as have motions above `_LEAST_MOTION`.

    The first six figures are motions of candidates. Once they fall below it, the face's rows stay 0. Loads
    act on the free displacements, of which `basis` makes those of the nodes.
    """
    moved: list[list[np.ndarray]] = [[] for _ in rows]
    active, largest = list(range(len(rows))), 0.0
    for first in range(0, len(patterns), _CHUNK):
        some = patterns[first : first + _CHUNK].T.astype(np.float32)
        pressed: np.ndarray = loads_n @ some
        right = np.zeros((factor.unknowns, some.shape[1]), np.float32, order="F")
        right[: len(pressed)] = pressed
        fields = basis @ factor.solve(right)[: len(pressed)].astype(np.float32)
        sizes = {}
        for face, of_face in enumerate(rows):
            if face not in active:
                shape = (*of_face.weights.shape[:2], some.shape[1])
                moved[face].append(np.zeros(shape, np.float32))
                continue
            moved[face].append(of_face @ fields)
            motion = moved[face][-1][:, :6].reshape(-1, 2, 3, some.shape[1])
            # c candidate, t displacement or rotation, i component, p pattern
            squared = np.einsum("ctip,ctip->tp", motion, motion, dtype=float)
            sizes[face] = float(np.sqrt((squared[0] + MM_PER_RAD**2 * squared[1]).max()))
        largest = max(largest, *sizes.values())
        active = [face for face in active if sizes[face] >= _LEAST_MOTION * largest]
        if not active:
            break
    return [np.concatenate(chunks, axis=2) for chunks in moved]


def _patterns(
    pressure_mpa: Float[np.ndarray, "place step vertex"],
    compliance: Float[np.ndarray, "vertex vertex"],
) -> tuple[Float[np.ndarray, "press pattern"], Float[np.ndarray, "pattern vertex"]]:
    """Return each press's share of patterns of pressure, and the patterns, so that few solves are needed.

    Shares are orthonormal. Patterns do no work on each other and come by the energy that they leave in the
    silicone, the largest first: deep in it motions fall with it, faster than with pressure.
    """
    all_pressures = pressure_mpa.reshape(-1, pressure_mpa.shape[-1])
    share, size, pattern = np.linalg.svd(all_pressures, full_matrices=False)
    kept = size > _LEAST_PRESSURE * size[0]
    patterns = size[kept, None] * pattern[kept]
    _, turn = np.linalg.eigh(patterns @ compliance @ patterns.T)
    turn = turn[:, ::-1]
    return share[:, kept] @ turn, turn.T @ patterns


def compressed(
    motion: Float[np.ndarray, "candidate 6 press"], least: float = _LEAST_MODE
) -> tuple[Float32[np.ndarray, "candidate mode 6"], Float[np.ndarray, "press mode"]]:
    """Modes of motions under presses, rotations weighed by `MM_PER_RAD`, and what each press has of them;
    modes smaller than `least` of the largest are left out."""
    gram = np.zeros((motion.shape[2], motion.shape[2]))
    for part in np.array_split(motion, max(1, len(motion) // 1024)):
        weighted = part * np.repeat([1.0, MM_PER_RAD], 3)[:, None]
        flat = weighted.reshape(-1, motion.shape[2])
        gram += flat.T @ flat
    power, mode = np.linalg.eigh(gram)
    mode = mode[:, power > least**2 * power[-1]][:, ::-1]
    modes = (motion @ mode.astype(np.float32)).astype(np.float32)
    return modes.transpose(0, 2, 1), mode


def _placed(
    spec: ObjectSpec, face: int, xyd_mm: np.ndarray
) -> tuple[Float[np.ndarray, "body 3"], Float[np.ndarray, "body 3 3"]]:
    """Centres of magnets under a face, and their axes as columns."""
    frame = face_frame(spec, face)
    plane = frame.to_plane(xyd_mm[:, :2])
    points = frame.to_object(np.column_stack([plane, -xyd_mm[:, 2]]))
    axes = np.broadcast_to(frame.axes, (len(points), 3, 3)) if frame.flat else frame.axes_at(plane)
    return points, axes


def values_on_grid(
    has_place: Bool[np.ndarray, "place"], values: Float[np.ndarray, "own *step"]
) -> Float[np.ndarray, "place *step"]:
    """Spread values of a face's places over the lattice; NaN elsewhere."""
    on_grid = np.full((len(has_place), *values.shape[1:]), np.nan)
    on_grid[has_place] = values
    return on_grid


def filled_candidates(
    lattices: tuple[FaceCandidates, ...], is_known: list[np.ndarray]
) -> Callable[[np.ndarray], np.ndarray]:
    """Return what goes on from the known candidates of every face to all of them."""
    if all(here.all() for here in is_known):
        return lambda values: values
    blocks = [
        extension(here.reshape(candidates.shape)[:, :, 0])
        for candidates, here in zip(lattices, is_known, strict=True)
    ]
    all_blocks = [
        sp.kron(block, sp.eye(len(candidates.depth_mm)))
        for block, candidates in zip(blocks, lattices, strict=True)
    ]
    matrix = sp.csr_matrix(sp.block_diag(all_blocks), dtype=np.float32)

    def filled(values: np.ndarray) -> np.ndarray:
        extended = matrix @ values.reshape(len(values), -1)
        return extended.reshape(-1, *values.shape[1:])

    return filled
