"""Discretisation error of forces and magnet motions, from the same presses on a coarser mesh.

Where all edges are longer by a factor r, an error of order q grows by r^q, so that a difference d
between the two meshes stands for an error of d/(r^q − 1) on the finer one. Here r = 1.5 and q = 2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.sparse.linalg
from jaxtyping import Bool, Float
from skfem import Basis, ElementTriP1, LinearForm, MeshTri
from skfem.models.poisson import mass

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec.object import ObjectSpec
from fem.linear.response import FaceSurface, ResponseOperator
from fem.presses.table import press_face, surface_weights_mm2

COARSENING = 1.5
"""Ratio of the edges of the two meshes."""

ORDER = 2.0
"""Order of the error: as observed on the paper's cube on three meshes, see `discretisation_error`."""

_PLACES_PER_AXIS = 5
"""Places along each axis of the grid that are compared."""
ROTATION_ARM_MM = 3.0
"""Arm at which rotations count as displacements (mm)."""
_PATCH_RADIUS_MM = 5.0
"""Radius of the smooth patch of pressure that is pressed."""
_PATCH_ORDER = 8
"""Degree that the quadrature of its loads integrates exactly."""


@dataclass(frozen=True)
class PressSample:
    """Presses of a spread of the contact grid, faces one after the other.

    `motion_mm` holds every magnet's displacement and its rotation times 3 mm: the field of a magnet
    some 9 mm away changes as much by the one as by the other.
    """

    force_n: Float[np.ndarray, "press step"]
    motion_mm: Float[np.ndarray, "press step component"]


@dataclass(frozen=True)
class MeshDifference:
    """Relative differences between two meshes: of force, and of the magnets' motions per newton."""

    force: Float[np.ndarray, "press step"]
    motion: Float[np.ndarray, "press step"]


@dataclass(frozen=True)
class DepthError:
    """Estimated relative errors at one depth: root mean square and largest over the presses.

    None where a press missed the coarser mesh altogether: the two cannot be compared then.
    """

    depth_mm: float
    force_rms: float | None
    force_worst: float | None
    motion_rms: float | None
    motion_worst: float | None


@dataclass(frozen=True)
class DiscretisationError:
    """Estimated errors of the specification's own mesh, and the differences that they stand on.

    `patch_compliance` is the largest, over the faces, of a patch load's compliance at the centre.
    """

    steps: tuple[DepthError, ...]
    patch_compliance: float
    share_of_difference: float
    presses: int
    unknowns: int
    coarse_unknowns: int


def discretisation_error(
    spec: ObjectSpec, response: ResponseOperator, coarse: ResponseOperator
) -> DiscretisationError:
    """Estimate from the responses of the specification's mesh and of that of `coarser`.

    On the paper's cube it was held against a mesh with edges 0.45 times as long under face 1
    (100 places, 0.25 to 4 mm deep). Estimate over root mean square difference from that mesh: 1.0
    to 1.2 for forces (2.5 % at 2 mm), 1.2 to 1.3 for motions (5.8 %); 1.2 is what an error of
    second order on that mesh itself would make of a perfect estimate. The largest differences are
    estimated 1.0 to 1.5 times too large, the patch load's compliance 4 times (2.6 % for 0.6 %).
    """
    difference = mesh_difference(sample_presses(spec, coarse), sample_presses(spec, response))
    share = 1 / (COARSENING**ORDER - 1)
    patches = [_patch_compliances(operator) for operator in (coarse, response)]
    return DiscretisationError(
        tuple(
            depth_error(depth, share, difference.force[:, step], difference.motion[:, step])
            for step, depth in enumerate(spec.press.depths_mm)
        ),
        share * float(abs(patches[0] / patches[1] - 1).max()),
        share,
        len(difference.force),
        response.unknowns,
        coarse.unknowns,
    )


def coarser(spec: ObjectSpec) -> ObjectSpec:
    """The same object with all edges longer by `COARSENING`.

    Its surface may lie off by twice as much, which halves the time of meshing.
    """
    mesh = spec.mesh
    lengths = {
        "edge_mm": COARSENING * mesh.edge_mm,
        "surface_edge_mm": COARSENING * mesh.surface_edge_mm,
        "envelope_mm": 2 * mesh.envelope_mm,
    }
    return spec.changed(mesh=mesh.changed(**lengths))


def sample_presses(spec: ObjectSpec, response: ResponseOperator) -> PressSample:
    """Press up to 25 places of each face to the depths of the specification."""
    grid, depths = contact_grid(spec), np.asarray(spec.press.depths_mm)
    count = len(response.compliance) - response.magnet_loads.start
    arm = np.tile(np.repeat([1.0, ROTATION_ARM_MM], 3), count // 6)
    forces, motions = [], []
    for face, has_place in enumerate(contact_places(spec)):
        xy = grid.xy_mm[has_place & spread_places(has_place.reshape(grid.shape))]
        presses = press_face(spec, response, face, xy, depths)
        rows = response.compliance[response.magnet_loads, response.face_loads(face)]
        forces.append(presses.force_n)
        motions.append(presses.vertex_mpa @ rows.T * arm)
    return PressSample(np.concatenate(forces), np.concatenate(motions))


def mesh_difference(coarse: PressSample, fine: PressSample) -> MeshDifference:
    """F/F' − 1 at equal depth, and motion per newton, as the norm of its change over all magnets.

    NaN where the tip misses either mesh.
    """
    touching = (coarse.force_n > 0) & (fine.force_n > 0)
    force = _quotient(coarse.force_n, fine.force_n, touching) - 1
    rates = [
        _quotient(s.motion_mm, s.force_n[..., None], touching[..., None]) for s in (coarse, fine)
    ]
    change, size = (np.linalg.norm(rate, axis=-1) for rate in (rates[0] - rates[1], rates[1]))
    return MeshDifference(force, _quotient(change, size, touching))


def patch_compliance_mm_per_n(surface: FaceSurface, compliance: np.ndarray) -> float:
    """∫ p uₙ dA / F² of the load p ∝ (1 − r²/25)² (r in mm, up to 5) about the face's centre.

    The load is projected on the P1 pressures (in L2), so that its error is of the mesh's own order.
    """
    mesh = MeshTri(surface.xy_mm.T.copy(), surface.triangles.T.copy())
    basis = Basis(mesh, ElementTriP1(), intorder=_PATCH_ORDER)
    moments = _patch.assemble(basis)
    pressure = scipy.sparse.linalg.spsolve(mass.assemble(basis).tocsc(), moments)
    force = pressure @ surface_weights_mm2(surface)
    return float(pressure @ compliance @ pressure / force**2)


@LinearForm
def _patch(v, w):
    return v * np.clip(1 - (w.x[0] ** 2 + w.x[1] ** 2) / _PATCH_RADIUS_MM**2, 0, None) ** 2


def depth_error(depth_mm: float, share: float, force: np.ndarray, motion: np.ndarray) -> DepthError:
    if not np.isfinite(force).all():
        return DepthError(depth_mm, None, None, None, None)
    figures = [f(d) * share for d in (force, motion) for f in (_root_mean_square, _largest)]
    return DepthError(depth_mm, *figures)


def _patch_compliances(response: ResponseOperator) -> np.ndarray:
    compliances = []
    for face, surface in enumerate(response.surfaces):
        rows = response.face_loads(face)
        compliances.append(patch_compliance_mm_per_n(surface, response.compliance[rows, rows]))
    return np.array(compliances)


def _root_mean_square(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _largest(values: np.ndarray) -> float:
    return float(abs(values).max())


def spread_places(has_place: Bool[np.ndarray, "nx ny"]) -> Bool[np.ndarray, "place"]:
    """Up to five rows and columns of the locations that a face has, the first and last among them."""
    chosen = []
    for across in (1, 0):
        used = np.flatnonzero(has_place.any(axis=across))
        some = used[np.unique(np.linspace(0, len(used) - 1, _PLACES_PER_AXIS).round().astype(int))]
        chosen.append(np.isin(np.arange(has_place.shape[1 - across]), some))
    return np.outer(*chosen).ravel()


def _quotient(numerator: np.ndarray, denominator: np.ndarray, where: np.ndarray) -> np.ndarray:
    """Numerator over denominator, NaN where they do not count."""
    shape = np.broadcast_shapes(numerator.shape, denominator.shape)
    return np.divide(numerator, denominator, out=np.full(shape, np.nan), where=where)
