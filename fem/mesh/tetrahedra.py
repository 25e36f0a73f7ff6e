"""Tetrahedral mesh of the sealed body with every magnet resolved, by pytetwild (fTetWild)."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import SolverError
from design.files import atomic_path
from design.layout.body import face_frame
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.mesh.edge_lengths import EdgeLength, edge_length_field
from fem.mesh.mesher import run_mesher
from fem.mesh.support_line import with_support_lines
from fem.mesh.surfaces import all_surfaces, points_in_body

SILICONE = -1
"""Value of `TetMesh.magnet` in elements of silicone."""

_NEAR_EDGE = 0.75
"""Edges `_NEAR_RADII` away from a press's contact, in `mesh.surface_edge_mm`."""
_CONTACT_RADII, _NEAR_RADII, _FAR_RADII = 0.75, 0.6, 2.5
"""Radius of the finest mesh, and from there to the near and to the far edges, over the tip's radius."""
_COARSE_EDGE_MM = 6.0
"""Edge far away from a press, at least."""


@dataclass(frozen=True)
class TetMesh:
    """Positively oriented tetrahedra; `magnet` is the rigid body an element lies in, or `SILICONE`.

    The rigid bodies are the magnets, or in the reverse arrangement the sensor boards.
    """

    points_mm: Float[np.ndarray, "vertex 3"]
    tets: Int[np.ndarray, "tet 4"]
    magnet: Int[np.ndarray, "tet"]

    @property
    def magnets(self) -> int:
        """Number of rigid bodies; 0 in a shell without magnets, whose mechanics then know none."""
        return int(self.magnet.max()) + 1


def tetrahedralize(
    spec: ObjectSpec,
    edge_length: EdgeLength | None = None,
    magnets: bool = True,
) -> TetMesh:
    """Mesh the sealed body, magnets conforming, or as if it were silicone throughout.

    `edge_length` gives the wanted edge length (mm) at points (n, 3); by default edges are fine
    under all sensed faces and at the rims of magnets. The mesher is not deterministic: store the
    mesh, never compare counts; `mesh_sha256` distinguishes two meshes. Surfaces are followed to
    within `mesh.envelope_mm`.

    Raises
    ------
    SolverError
        The mesher fails or takes too long, or a magnet got no element.
    """
    surface = all_surfaces(spec, magnets)
    background = edge_length_field(spec, edge_length, magnets)
    content = {
        "vertices": np.asarray(surface.vertices, dtype=np.float64),
        "faces": np.asarray(surface.faces, dtype=np.int32),
        "edge_length_abs": np.array(spec.mesh.edge_mm),
        "epsilon": spec.mesh.envelope_mm / np.linalg.norm(spec.body.size_mm),
        "bg_vertices": background.points_mm,
        "bg_tets": background.tets,
        "bg_values": background.length_mm,
    }
    points, tets = run_mesher(content)
    tets = positively_oriented(points, tets.astype(np.int64))
    points, tets = with_support_lines(points, tets, spec)
    if not magnets:
        return TetMesh(points, tets, np.full(len(tets), SILICONE))
    return TetMesh(points, tets, _containing_magnet(spec, points[tets].mean(axis=1)))


def tetrahedralize_for_press(spec: ObjectSpec, face: int, x_mm: float, y_mm: float) -> TetMesh:
    """Edges as fine at the contact as at the rims of magnets, growing to 6 mm.

    The force of pressures on hats of size h under a contact of radius a is off by a multiple of
    (h/a)² that changes with the depth, as vertices come into contact one after the other.

    Raises
    ------
    SolverError
        The mesher fails, or a magnet got no element.
    """
    frame = face_frame(spec, face)
    radius = spec.indenter.radius_mm
    finest = spec.mesh.finest_edge_mm
    near = max(finest, _NEAR_EDGE * spec.mesh.surface_edge_mm)
    reach = np.array([0.0, _NEAR_RADII, _FAR_RADII]) * radius
    edges = [finest, near, max(_COARSE_EDGE_MM, spec.mesh.edge_mm)]

    def edge_length(points_mm: np.ndarray) -> np.ndarray:
        local = frame.from_object(points_mm)
        across = np.hypot(local[:, 0] - x_mm, local[:, 1] - y_mm) - _CONTACT_RADII * radius
        return np.interp(np.hypot(np.clip(across, 0, None), local[:, 2]), reach, edges)

    return tetrahedralize(spec, edge_length)


def magnet_free_mesh(spec: ObjectSpec) -> TetMesh:
    """Tetrahedra of the sealed body without magnets, edges as for the mesh with them.

    Raises
    ------
    SolverError
        The mesher fails.
    """
    return tetrahedralize(spec, magnets=False)


def tet_volumes_mm3(mesh: TetMesh) -> Float[np.ndarray, "tet"]:
    """Signed volumes."""
    corner = mesh.points_mm[mesh.tets]
    return np.linalg.det(corner[:, 1:] - corner[:, :1]) / 6


def mesh_sha256(mesh: TetMesh) -> str:
    """Hash of a mesh's content: the same for two meshes with the same arrays, in the same order."""
    digest = hashlib.sha256()
    for array in (mesh.points_mm, mesh.tets, mesh.magnet):
        digest.update(f"{array.dtype.str}{array.shape}".encode())
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def save_mesh(mesh: TetMesh, path: Path | str) -> None:
    """Write as NumPy's .npz."""
    with atomic_path(path) as temporary, temporary.open("wb") as stream:
        np.savez(stream, points_mm=mesh.points_mm, tets=mesh.tets, magnet=mesh.magnet)


def load_mesh(path: Path | str) -> TetMesh:
    """Read what `save_mesh` wrote."""
    with np.load(path, allow_pickle=False) as data:
        return TetMesh(data["points_mm"], data["tets"], data["magnet"])


def positively_oriented(points: np.ndarray, tets: np.ndarray) -> np.ndarray:
    corner = points[tets]
    negative = np.linalg.det(corner[:, 1:] - corner[:, :1]) < 0
    tets[negative] = tets[negative][:, [0, 2, 1, 3]]
    return tets


def _containing_magnet(spec: ObjectSpec, points: np.ndarray) -> np.ndarray:
    layout = shell_body_layout(spec)
    owner = np.full(len(points), SILICONE)
    for index in range(len(layout.face)):
        inside = points_in_body(points, layout, index, spec)
        if not inside.any():
            raise SolverError(
                f"rigid body {index} got no element of the mesh. Use a smaller mesh.envelope_mm "
                f"(now {spec.mesh.envelope_mm:g})"
            )
        owner[inside] = index
    return owner
