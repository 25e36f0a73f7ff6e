"""Tetrahedral mesh of the sealed body with every magnet resolved, by pytetwild (fTetWild)."""

from __future__ import annotations

import contextlib
import itertools
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.body.kinds import face_frame, face_frames
from design.errors import InputError
from design.files import atomic_path
from design.layout.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.mesh.support_line import with_support_lines
from fem.mesh.surfaces import all_surfaces, in_body

SILICONE = -1
"""Value of `TetMesh.magnet` in elements of silicone."""

EdgeLength = Callable[[Float[np.ndarray, "point 3"]], Float[np.ndarray, "point"]]
"""Wanted edge lengths (mm) at points of the object's frame (mm)."""

_SIZING_STEP_MM = 2.0
_FINE_LAYER_MM = 0.5
_FINE_WITHIN_RADII = 1.1
_COARSE_BEYOND_RADII = 3.0
_COARSE_EDGE_MM = 6.0


@dataclass(frozen=True)
class TetMesh:
    """Positively oriented tetrahedra; `magnet` is the rigid body an element lies in, or `SILICONE`.

    The rigid bodies are the magnets, or in the reverse arrangement the sensor boards.
    """

    points_mm: Float[np.ndarray, "vertex 3"]
    tets: Int[np.ndarray, "tet 4"]
    magnet: Int[np.ndarray, "tet"]


@dataclass(frozen=True)
class _EdgeLengths:
    """Background mesh with the target edge length at its points."""

    points_mm: Float[np.ndarray, "point 3"]
    tets: Int[np.ndarray, "brick_tet 4"]
    length_mm: Float[np.ndarray, "point"]


def tetrahedralize(
    spec: ObjectSpec, edge_length: EdgeLength | None = None, magnets: bool = True
) -> TetMesh:
    """Mesh the sealed body, magnets conforming, or as if it were silicone throughout.

    `edge_length` gives the wanted edge length (mm) at points (n, 3); by default edges are fine
    under all sensed faces. The mesher is not deterministic: store the mesh, never compare counts.
    Surfaces are followed to within `mesh.envelope_mm`.

    Raises
    ------
    InputError
        The mesher fails, or a magnet got no element.
    """
    from pytetwild.pytetwild import tetrahedralize as pytetwild_tetrahedralize

    surface = all_surfaces(spec, magnets)
    background = _edge_length_field(spec, edge_length)
    diagonal = float(np.linalg.norm(spec.body.size_mm))
    with _scratch_folder():
        try:
            points, tets = pytetwild_tetrahedralize(
                np.ascontiguousarray(surface.vertices, dtype=np.float64),
                np.ascontiguousarray(surface.faces, dtype=np.int32),
                edge_length_abs=spec.mesh.edge_mm,
                epsilon=spec.mesh.envelope_mm / diagonal,
                quiet=True,
                bg_vertices=background.points_mm,
                bg_tets=background.tets,
                bg_values=background.length_mm,
            )
        except RuntimeError as error:
            raise InputError(
                f"the mesher failed on this body ({error}). Try a larger mesh.envelope_mm "
                f"(now {spec.mesh.envelope_mm:g}) or a smaller mesh.edge_mm"
            ) from error
    tets = _positively_oriented(points, tets.astype(np.int64))
    points, tets = with_support_lines(points, tets, spec)
    if not magnets:
        return TetMesh(points, tets, np.full(len(tets), SILICONE))
    return TetMesh(points, tets, _containing_magnet(spec, points[tets].mean(axis=1)))


def tetrahedralize_for_press(spec: ObjectSpec, face: int, x_mm: float, y_mm: float) -> TetMesh:
    """Edges of `mesh.surface_edge_mm` around the tip, growing to 6 mm three radii away.

    A quarter of the unknowns of the mesh that serves all presses, with the same resolution of this
    one's contact.

    Raises
    ------
    InputError
        The mesher fails, or a magnet got no element.
    """
    frame = face_frame(spec, face)
    place = frame.to_object(np.array([x_mm, y_mm, 0.0]))
    radius = spec.indenter.radius_mm
    fine, coarse = spec.mesh.surface_edge_mm, max(_COARSE_EDGE_MM, spec.mesh.edge_mm)
    reach = np.array([_FINE_WITHIN_RADII, _COARSE_BEYOND_RADII]) * radius

    def edge_length(points_mm: np.ndarray) -> np.ndarray:
        distance = np.linalg.norm(points_mm - place, axis=1)
        return np.interp(distance, reach, [fine, coarse])

    return tetrahedralize(spec, edge_length)


def without_magnets(spec: ObjectSpec) -> ObjectSpec:
    """The same object for mechanics on a magnet-free mesh: no tie, no stiffness of magnets.

    `fem.linear.response` then gives the surface compliance alone, with no magnet among its loads.
    """
    mechanics = spec.mechanics.changed(magnets="points")
    return spec.changed(mechanics=mechanics)


def magnet_free_mesh(spec: ObjectSpec) -> TetMesh:
    """Tetrahedra of the sealed body without magnets, edges as for the mesh with them.

    Raises
    ------
    InputError
        The mesher fails.
    """
    return tetrahedralize(spec, magnets=False)


def tet_volumes_mm3(mesh: TetMesh) -> Float[np.ndarray, "tet"]:
    """Signed volumes."""
    corner = mesh.points_mm[mesh.tets]
    return np.linalg.det(corner[:, 1:] - corner[:, :1]) / 6


def save_mesh(mesh: TetMesh, path: Path | str) -> None:
    """Write as NumPy's .npz."""
    with atomic_path(path) as temporary, temporary.open("wb") as stream:
        np.savez(stream, points_mm=mesh.points_mm, tets=mesh.tets, magnet=mesh.magnet)


def load_mesh(path: Path | str) -> TetMesh:
    """Read what `save_mesh` wrote."""
    with np.load(path, allow_pickle=False) as data:
        return TetMesh(data["points_mm"], data["tets"], data["magnet"])


@contextlib.contextmanager
def _scratch_folder() -> Iterator[None]:
    """fTetWild leaves a stray surface file in the current folder: give it one to lose."""
    before = Path.cwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield
        finally:
            os.chdir(before)


def _positively_oriented(points: np.ndarray, tets: np.ndarray) -> np.ndarray:
    corner = points[tets]
    negative = np.linalg.det(corner[:, 1:] - corner[:, :1]) < 0
    tets[negative] = tets[negative][:, [0, 2, 1, 3]]
    return tets


def _containing_magnet(spec: ObjectSpec, points: np.ndarray) -> np.ndarray:
    layout = shell_body_layout(spec)
    owner = np.full(len(points), SILICONE)
    for index in range(len(layout.face)):
        inside = in_body(points, layout, index, spec)
        if not inside.any():
            raise InputError(
                f"rigid body {index} got no element of the mesh. Use a smaller mesh.envelope_mm "
                f"(now {spec.mesh.envelope_mm:g})"
            )
        owner[inside] = index
    return owner


def _edge_length_field(spec: ObjectSpec, edge_length: EdgeLength | None = None) -> _EdgeLengths:
    """Background mesh of target edge lengths."""
    half = np.asarray(spec.body.size_mm) / 2
    axes = [
        np.linspace(-h - 1, h + 1, int(np.ceil(2 * (h + 1) / _SIZING_STEP_MM)) + 1) for h in half
    ]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    tets = _split_bricks(tuple(len(axis) for axis in axes)).astype(np.int32)
    edge_length = edge_length or partial(_fine_under_all_faces, spec)
    return _EdgeLengths(points, tets, edge_length(points))


def _fine_under_all_faces(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    """Fine under the sensed faces, coarse in the bulk."""
    below = np.full(len(points_mm), np.inf)
    for frame in face_frames(spec):
        local = frame.from_object(points_mm)
        under = frame.flat | frame.covers(local[:, :2])
        below = np.minimum(below, np.where(under, -local[:, 2], np.inf))
    below = np.clip(below - _FINE_LAYER_MM, 0, None) / (spec.shell.thickness_mm / 2)
    fine, coarse = spec.mesh.surface_edge_mm, spec.mesh.edge_mm
    return fine + (coarse - fine) * np.clip(below, 0, 1)


def _split_bricks(shape: tuple[int, ...]) -> np.ndarray:
    """Six tetrahedra (Kuhn) in every brick of a structured grid of `shape` points."""
    index = np.arange(int(np.prod(shape))).reshape(shape)
    cells = tuple(n - 1 for n in shape)

    def corner(offset: tuple[int, ...]) -> np.ndarray:
        window = tuple(slice(o, o + n) for o, n in zip(offset, cells, strict=True))
        return index[window].ravel()

    tets = []
    for order in itertools.permutations(range(3)):
        offset = [0, 0, 0]
        path = [corner((0, 0, 0))]
        for axis in order:
            offset[axis] = 1
            path.append(corner((offset[0], offset[1], offset[2])))
        even = order in {(0, 1, 2), (1, 2, 0), (2, 0, 1)}
        tets.append(np.stack(path if even else [path[0], path[2], path[1], path[3]], axis=1))
    return np.concatenate(tets)
