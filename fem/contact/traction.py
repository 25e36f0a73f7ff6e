"""Compliance of a few places to tractions in all three directions, from one more factorization.

The response operator knows pressures alone. Here normal and tangential tractions of the hat
functions near some indenters are condensed together, with all magnets, and refined to the
indenters' cells as in `fem.contact.refined`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.linalg
import scipy.sparse as sp
from jaxtyping import Float
from scipy.spatial import Delaunay

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from fem.contact.half_space import Patches, chosen, joined, traction_compliance
from fem.contact.refined import (
    RefinedFace,
    hat_narrowing,
    hat_patches,
    spread_cells,
    take_back,
)
from fem.contact.rigid_base import rigid_bases
from fem.linear.factorization import compliance_of_loads
from fem.linear.response import (
    ElasticSystem,
    elastic_system,
    face_facets,
    face_surface,
    last_columns,
)
from fem.linear.sparse import columns_of, rows_of, shape_of
from fem.mesh.tetrahedra import TetMesh


@dataclass(frozen=True)
class TractionResponse:
    """Response of cells to each other and to the magnets, per unit traction on each.

    Directions are inwards, then along the face's x and y. `compliance` holds ∫ u_i dA, mm³/MPa;
    `motion` the magnets' six motions each, mm and rad per MPa.
    """

    compliance: Float[np.ndarray, "3 cell 3 cell"]
    motion: Float[np.ndarray, "motion 3 cell"]


def traction_response(
    spec: ObjectSpec, mesh: TetMesh, faces: Sequence[int], groups: Sequence[Patches]
) -> TractionResponse:
    """Condense the tractions of groups of cells, each on a face (1…5).

    Raises
    ------
    InputError
        A curved face.
    SingularSystemError
        The matrix could not be factored.
    """
    system = elastic_system(mesh, spec)
    frames = {frame.number: frame for frame in face_frames(spec)}
    for number in set(faces):
        require_flat(frames[number])
    surfaces = {
        number: refined_surface(system, spec, frames[number], mesh.magnets) for number in set(faces)
    }
    centre = np.zeros(2)
    spreads = [
        spread_cells(surfaces[n][0], group, centre) for n, group in zip(faces, groups, strict=True)
    ]
    tractions = [
        columns_of(
            [
                traction_loads(frames[n], direction, surfaces[n][1][:, spread.rows])
                for n, spread in zip(faces, spreads, strict=True)
            ]
        )
        for direction in range(3)
    ]
    condensed = condensed_compliance(system, mesh, columns_of(tractions))
    hats = [chosen(spread.face.hats, spread.rows) for spread in spreads]
    count = 3 * sum(len(group.area_mm2) for group in hats)
    spread_matrix = np.asarray(scipy.linalg.block_diag(*(spread.matrix for spread in spreads)))
    share = np.kron(np.eye(3), spread_matrix)
    wide = condensed[:count, :count] - half_space_compliance(spec, faces, hats)
    compliance = share.T @ wide @ share + half_space_compliance(spec, faces, groups)
    cells, first = share.shape[1] // 3, 0
    for spread in spreads:
        last = first + len(spread.patches.area_mm2)
        for base in spread.face.bases:
            take_back(compliance[first:last, first:last], spread, base)
        first = last
    return TractionResponse(
        ((compliance + compliance.T) / 2).reshape(3, cells, 3, cells),
        (condensed[count:, :count] @ share).reshape(-1, 3, cells),
    )


def refined_surface(
    system: ElasticSystem, spec: ObjectSpec, frame: FaceFrame, magnets: int
) -> tuple[RefinedFace, sp.csc_matrix]:
    surface, moments = face_surface(system.space, face_facets(system.mesh, spec, frame), frame)
    unused = np.zeros((0, 0))
    hats = hat_patches(surface)
    narrowing = hat_narrowing(surface)
    around = Delaunay(surface.xy_mm)
    # a shell without magnets has nothing rigid close under a face
    bases = rigid_bases(spec, frame, surface, hats) if magnets else ()
    elastic = (spec.silicone.surface_modulus_mpa, spec.silicone.poisson_ratio)
    face = RefinedFace(
        frame, surface, frame.number, hats, unused, narrowing, around, elastic, bases
    )
    return face, moments


def require_flat(frame: FaceFrame) -> None:
    if not frame.flat:
        raise InputError(
            f"face {frame.number} is curved, and friction is known on flat faces only. Set "
            "indenter.friction = 'none', or press a flat face"
        )


def traction_loads(frame: FaceFrame, direction: int, moments: sp.csc_matrix) -> sp.csr_matrix:
    """Nodal forces of unit hats inwards (0), along the face's x (1) or y (2)."""
    axis = (-frame.normal, frame.x, frame.y)[direction]
    return rows_of([part * moments for part in axis])


def condensed_compliance(
    system: ElasticSystem, mesh: TetMesh, tractions: sp.csr_matrix
) -> np.ndarray:
    """Mutual compliance of nodal loads and all magnets' motions."""
    unknowns, motions = shape_of(system.matrix)[0], shape_of(system.motion_basis)[1]
    loads = columns_of([system.motion_basis.T @ tractions, last_columns(motions, 6 * mesh.magnets)])
    padding = sp.csr_matrix((unknowns - motions, shape_of(loads)[1]))
    return compliance_of_loads(system.matrix, rows_of([loads, padding])).matrix


def half_space_compliance(
    spec: ObjectSpec, faces: Sequence[int], groups: Sequence[Patches]
) -> np.ndarray:
    """Compliance of patches on half-spaces, one for every face."""
    face = np.repeat(faces, [len(group.area_mm2) for group in groups])
    together, silicone = joined(groups), spec.silicone
    compliance = traction_compliance(
        together, together, silicone.surface_modulus_mpa, silicone.poisson_ratio
    )
    compliance *= (face[:, None] == face)[None, :, None, :]
    return compliance.reshape(3 * len(face), 3 * len(face))
