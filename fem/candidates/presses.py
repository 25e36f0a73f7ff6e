"""Presses of the magnet-free shell, recorded at every candidate place of a magnet."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import scipy.sparse as sp
from jaxtyping import Bool, Float

from design.layout.body import face_frame
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from fem.candidates.cubic_convolution import extension
from fem.candidates.motions import (
    MOTIONS_FILE,
    CandidateMotions,
    FaceCandidates,
    InterpolationError,
    known_places,
    save_candidates,
)
from fem.candidates.rigid_body import RigidBody, candidate_rows, rigid_body
from fem.linear.elements import DisplacementSpace
from fem.linear.factorization import Factorization
from fem.linear.response import (
    ResponseOperator,
    displacements,
    elastic_system,
    face_pressure_loads,
)
from fem.linear.sparse import rows_of
from fem.mesh.tetrahedra import TetMesh, without_magnets
from fem.presses.table import press_places, surface_weights_mm2

FORCE_SHARES = (0.8, 1.2)
_TEST_POINTS_PER_FACE = 60
_CHUNK = 128

Progress = Callable[[str], None]


@dataclass(frozen=True)
class PressesAtForce:
    """Pressures (place, step, vertex) on one face in MPa, their forces (N) and depths (mm); the force of the
    deepest simulated press."""

    pressure_mpa: Float[np.ndarray, "place step vertex"]
    force_n: Float[np.ndarray, "place step"]
    depth_mm: Float[np.ndarray, "place step"]
    deepest_n: Float[np.ndarray, "place"]


def simulate_candidates(
    spec: ObjectSpec,
    mesh: TetMesh,
    response: ResponseOperator,
    lattices: tuple[FaceCandidates, ...],
    folder: Path | str,
    force_shares: Sequence[float] = FORCE_SHARES,
    progress: Progress | None = None,
) -> CandidateMotions:
    """Press every contact location on a magnet-free mesh, record every candidate, write the folder.

    Presses go to `force_shares` of every one of `spec.judged_forces_n`, or of less where the deepest
    simulated press does not reach the largest share. Between simulated depths pressures are interpolated
    linearly: forces and equilibrium stay exact. A slip of the core is left out.

    Raises
    ------
    InputError
        A candidate outside the silicone.
    SingularSystemError
        The matrix could not be factored.
    """
    spec = without_magnets(spec)
    presses = [
        presses_at_forces(spec, response, index, force_shares)
        for index in range(len(response.surfaces))
    ]
    there = contact_places(spec)
    force, depth, deepest = (
        np.stack(
            [_on_grid(own, getattr(press, name)) for own, press in zip(there, presses, strict=True)]
        )
        for name in ("force_n", "depth_mm", "deepest_n")
    )
    count = sum(len(lattice) for lattice in lattices)
    motions = np.lib.format.open_memmap(
        Path(folder) / MOTIONS_FILE, "w+", np.float32, (count, *force.shape, 6)
    )
    tests = _test_points(spec, lattices)
    direct, body = _record(spec, mesh, response, presses, lattices, tests, motions, progress)
    motions.flush()
    faces = np.array([surface.number for surface in response.surfaces])
    unknown = InterpolationError(*(4 * [np.nan]))
    table = CandidateMotions(
        faces,
        contact_grid(spec),
        force,
        depth,
        deepest,
        lattices,
        motions,
        unknown,
        body.turns_with_plane,
    )
    table = _with_error(table, tests, direct)
    save_candidates(table, folder)
    return table


def presses_at_forces(
    spec: ObjectSpec, response: ResponseOperator, face_index: int, force_shares: Sequence[float]
) -> PressesAtForce:
    """Contact at shares of every judged force at every contact location that one face has.

    Steps are the shares of the first force, then of the second, and so on.

    Raises
    ------
    InputError
        A tip that would hang over the face's border.
    """
    depths = np.append(0.0, spec.press.depths_mm)
    places = contact_grid(spec).xy_mm[contact_places(spec)[face_index]]
    pressed = press_places(spec, response, face_index, places, depths[1:])
    pressed = np.concatenate([np.zeros_like(pressed[:, :1]), pressed], axis=1)
    reached = pressed @ surface_weights_mm2(response.surfaces[face_index])
    shares = np.asarray(force_shares)
    most = np.minimum(np.array(spec.judged_forces_n), reached[:, -1:] / shares.max())
    force = (shares * most[:, :, None]).reshape(len(places), -1)
    after = np.argmax(reached[:, None] >= force[:, :, None] * (1 - 1e-12), axis=2)
    place = np.arange(len(places))[:, None]
    low, high = reached[place, after - 1], reached[place, after]
    share = (force - low) / (high - low)
    below, above = pressed[place, after - 1], pressed[place, after]
    mixed = below + share[..., None] * (above - below)
    depth = depths[after - 1] + share * np.diff(depths)[after - 1]
    return PressesAtForce(mixed, force, depth, reached[:, -1])


def _record(
    spec: ObjectSpec,
    mesh: TetMesh,
    response: ResponseOperator,
    presses: list[PressesAtForce],
    lattices: tuple[FaceCandidates, ...],
    tests: list[np.ndarray],
    motions: np.ndarray,
    progress: Progress | None,
) -> tuple[np.ndarray, RigidBody]:
    """Fill `motions`; the motions of the test points are returned, in the same order of axes, and the
    magnet that moves so."""
    system = elastic_system(mesh, spec)
    tractions = face_pressure_loads(system.space, spec)[1]
    known = [np.repeat(known_places(spec, one), len(one.depth_mm)) for one in lattices]
    points = [*(one.xyd_mm[here] for one, here in zip(lattices, known, strict=True)), *tests]
    filled, there = _filled(lattices, known), contact_places(spec)
    direct = np.zeros((sum(map(len, tests)), *motions.shape[1:]), np.float32)
    steps = motions.shape[3]
    with Factorization(system.matrix) as factor:
        body = rigid_body(spec, system, factor, lattices)
        rows = rows_of(
            [
                _face_rows(spec, system.space, lattice.face, xyd, body)
                for lattice, xyd in zip(lattices * 2, points, strict=True)
            ]
        )
        for index, press in enumerate(presses):
            loads = tractions[:, response.face_loads(index)]
            pressures = press.pressure_mpa.reshape(-1, press.pressure_mpa.shape[-1]).T
            for first in range(0, pressures.shape[1], _CHUNK):
                column = np.arange(first, min(first + _CHUNK, pressures.shape[1]))
                u = displacements(system, factor, loads @ pressures[:, column])
                found = (rows @ u).astype(np.float32).reshape(-1, 6, len(column))
                row, step = np.divmod(column, steps)
                place = np.flatnonzero(there[index])[row]
                candidates = filled(found[: len(found) - len(direct)])
                motions[:, index, place, step] = candidates.transpose(0, 2, 1)
                direct[:, index, place, step] = found[len(found) - len(direct) :].transpose(0, 2, 1)
            if progress:
                progress(f"face {response.surfaces[index].number}: {pressures.shape[1]} presses")
    return direct, body


def _face_rows(
    spec: ObjectSpec, space: DisplacementSpace, face: int, xyd_mm: np.ndarray, body: RigidBody
) -> sp.csr_matrix:
    frame = face_frame(spec, face)
    plane = frame.to_plane(xyd_mm[:, :2])
    points = frame.to_object(np.column_stack([plane, -xyd_mm[:, 2]]))
    axes = frame.axes if frame.flat else frame.axes_at(plane)
    return candidate_rows(space, points, axes, body)


def _test_points(spec: ObjectSpec, lattices: tuple[FaceCandidates, ...]) -> list[np.ndarray]:
    """Random (x, y, depth) among the candidates of every face, where a pocket lies under its patch."""
    random, found = np.random.default_rng(1), []
    for lattice in lattices:
        frame = face_frame(spec, lattice.face)
        ends = lattice.xyd_mm.min(0), lattice.xyd_mm.max(0)
        points = random.uniform(*ends, (_TEST_POINTS_PER_FACE, 3))
        beside = abs(frame.to_plane(points[:, :2])) + spec.shell.pocket_diameter_mm / 2
        found.append(points[frame.covers(beside)])
    return found


def _on_grid(
    there: Bool[np.ndarray, "place"], values: Float[np.ndarray, "own *step"]
) -> Float[np.ndarray, "place *step"]:
    """Of the places that a face has; NaN elsewhere."""
    found = np.full((len(there), *values.shape[1:]), np.nan)
    found[there] = values
    return found


def _filled(
    lattices: tuple[FaceCandidates, ...], known: list[np.ndarray]
) -> Callable[[np.ndarray], np.ndarray]:
    """What goes on from the known candidates of every face to all of them."""
    if all(here.all() for here in known):
        return lambda values: values
    blocks = [
        extension(here.reshape(one.shape)[:, :, 0])
        for one, here in zip(lattices, known, strict=True)
    ]
    every = [
        sp.kron(block, sp.eye(len(one.depth_mm)))
        for block, one in zip(blocks, lattices, strict=True)
    ]
    matrix = sp.csr_matrix(sp.block_diag(every), dtype=np.float32)

    def filled(values: np.ndarray) -> np.ndarray:
        found = matrix @ values.reshape(len(values), -1)
        return found.reshape(-1, *values.shape[1:])

    return filled


def _with_error(
    table: CandidateMotions, tests: list[np.ndarray], direct: np.ndarray
) -> CandidateMotions:
    """The table with the error of its interpolation on the pressed faces' own test points."""
    exact, wrong = [], []
    ends = np.cumsum([len(points) for points in tests])[:-1]
    for lattice, points, values in zip(
        table.candidates, tests, np.split(direct, ends), strict=True
    ):
        own = table.faces == lattice.face
        found = np.moveaxis(table.at(lattice.face, points[:, :2], points[:, 2]), 3, 0)
        exact.append(values[:, own])
        wrong.append(found[:, own] - values[:, own])
    exact, wrong = (
        np.concatenate([m.reshape(-1, 2, 3) for m in parts]) for parts in (exact, wrong)
    )
    size, miss = np.linalg.norm(exact, axis=2), np.linalg.norm(wrong, axis=2)
    rms = np.sqrt(np.mean(miss**2, axis=0) / np.mean(size**2, axis=0))
    worst = miss.max(axis=0) / size.max(axis=0)
    error = InterpolationError(*(float(v) for v in (rms[0], worst[0], rms[1], worst[1])))
    return replace(table, error=error)
