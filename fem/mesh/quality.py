"""Quality of a tetrahedral mesh, and the gate that a mesh must pass before mechanics."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import SolverError
from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from design.layout.surface import sealed_body_surface
from design.layout.volumes import sealed_volume_mm3
from design.spec.object import ObjectSpec
from fem.mesh.tetrahedra import SILICONE, TetMesh, tet_volumes_mm3

MIN_DIHEDRAL_DEG = 4.0
"""Smallest dihedral angle of a mesh that is accepted."""
MAX_VOLUME_ERROR = 2e-3
"""Relative error of the silicone's volume that is accepted, facets of curved faces apart."""
MAX_MAGNET_VOLUME_ERROR = 0.03
"""Relative error of the magnets' volume: their rims are polygons."""


@dataclass(frozen=True)
class MeshQuality:
    """Counts, dihedral angles (degrees) and volumes (mm³) with their errors (relative).

    `volume_error_limit` is what the mesh may be off by: a curved surface by the mesh's envelope.
    """

    vertices: int
    tets: int
    min_dihedral_deg: float
    dihedral_5th_percentile_deg: float
    volume_mm3: float
    volume_error: float
    volume_error_limit: float
    magnet_volume_error: float


def mesh_quality(mesh: TetMesh, spec: ObjectSpec) -> MeshQuality:
    """Measure a mesh against the sealed body that it stands for."""
    volume = tet_volumes_mm3(mesh)
    angles = dihedral_angles_deg(mesh)
    exact = sealed_volume_mm3(spec)
    body = shell_body_layout(spec).volume_mm3
    in_magnets = mesh.magnet != SILICONE
    per_magnet = np.bincount(mesh.magnet[in_magnets], volume[in_magnets])
    body = body[: len(per_magnet)]  # none without magnets
    return MeshQuality(
        vertices=len(mesh.points_mm),
        tets=len(mesh.tets),
        min_dihedral_deg=float(angles.min()),
        dihedral_5th_percentile_deg=float(np.percentile(angles.min(axis=1), 5)),
        volume_mm3=float(volume.sum()),
        volume_error=float(volume.sum() / exact - 1),
        volume_error_limit=_volume_error_limit(spec),
        magnet_volume_error=float(abs(per_magnet / body - 1).max(initial=0)),
    )


def require_quality(quality: MeshQuality) -> None:
    """Raise SolverError when a mesh is too poor to trust (slivers, lost volume, lost magnets)."""
    limits = [
        ("smallest dihedral angle (deg)", -quality.min_dihedral_deg, -MIN_DIHEDRAL_DEG),
        ("relative volume error", abs(quality.volume_error), quality.volume_error_limit),
        ("relative magnet volume error", quality.magnet_volume_error, MAX_MAGNET_VOLUME_ERROR),
    ]
    for what, value, limit in limits:
        if not value <= limit:
            raise SolverError(
                f"the mesh fails its quality gate: {what} is {abs(value):.3g}, the limit is "
                f"{abs(limit):g}. Change mesh.edge_mm, mesh.surface_edge_mm or mesh.envelope_mm"
            )


def _volume_error_limit(spec: ObjectSpec) -> float:
    if all(frame.flat for frame in face_frames(spec)):
        return MAX_VOLUME_ERROR
    surface = sealed_body_surface(spec)
    return MAX_VOLUME_ERROR + spec.mesh.envelope_mm * float(surface.area / surface.volume)


def dihedral_angles_deg(mesh: TetMesh) -> Float[np.ndarray, "tet 6"]:
    """The six angles between faces of every tetrahedron."""
    corner = mesh.points_mm[mesh.tets]
    normals = []
    for face in ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)):
        a, b, c = (corner[:, k] for k in face)
        normal = np.cross(b - a, c - a)
        normals.append(normal / np.linalg.norm(normal, axis=1, keepdims=True))
    angles = [
        # Dihedral angle: 180° less that of the outward normals. i tet, j coordinate. Clipped, as
        # rounding may give a cosine beyond ±1.
        np.degrees(np.arccos(np.clip(-np.einsum("ij,ij->i", normals[i], normals[j]), -1, 1)))
        for i in range(4)
        for j in range(i + 1, 4)
    ]
    return np.stack(angles, axis=1)
