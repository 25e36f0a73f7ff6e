"""One press over an edge or a corner: the tip meets whatever lies under it, along a slanted way.

Beyond a flat face's border a place counts as the tip rolls: its middle goes round the edge on an arc of the
tip's radius, its way leans as far as it has rolled, and the edge is touched first. Everything under the
tip takes part, of one face or of several, sharp or rounded: a pressure p on the area across the way acts
along the way, and the gap is measured along it. That is the table's own contact where the way is a flat
face's normal, one complementarity problem over all hats on the surface. The press has a mesh of its own,
fine at the edge, and so one more factorization.

Against NGSolve (`benchmarks/forces_over_edges.py`), the same contact: docs/measured/presses.md.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int
from skfem import ElementTetP1, FacetBasis, LinearForm, MeshTet

from design.body.surface_chart import FaceFrame
from design.errors import InputError
from design.layout.body import face_frame
from design.layout.tips import tip_heights_mm, tip_shape
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.contact.traction import condensed_compliance
from fem.linear.response import elastic_system, leaning_moments
from fem.linear.sparse import rows_of
from fem.mesh.tetrahedra import TetMesh, tetrahedralize
from fem.presses.joint import JointPress, Tip

_FINEST_EDGE, _FINE_RADII, _FAR_RADII = 0.15, 0.35, 2.5
"""Edges at the place in `mesh.surface_edge_mm`; so far from it, in radii of the tip, they stay, and so
far they have grown to those of the bulk."""
_STEEPEST = 0.05
"""Cosine of surface and way below which a facet is not pressed: it lies along the way."""
_ORDER = 6
"""Degree that quadrature over a facet integrates exactly: a tip's profile is curved."""


@dataclass(frozen=True)
class EdgePlace:
    """The point that a rolled tip touches first, and axes as columns: two across its way, the last out of the
    body against it; in the object's frame."""

    tip: Tip
    point_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]

    @property
    def outward(self) -> Float[np.ndarray, "3"]:
        return self.axes[:, 2]


def edge_place(spec: ObjectSpec, tip: Tip) -> EdgePlace | None:
    """Return where a place beyond a flat face's border is; None for a place on a face, and for jaws and
    others that are not round: they hang over it.

    Raises
    ------
    InputError
        A tip other than one hemisphere that goes straight without friction, rolled by more than 90°.
    """
    frame = face_frame(spec, tip.face)
    xy = np.array([tip.x_mm, tip.y_mm])
    on_face = _nearest_on_face(frame, xy)
    beyond = xy - on_face
    length = float(np.linalg.norm(beyond))
    indenter = spec.indenter
    if not frame.flat or length < 1e-9 or tip_shape(indenter).ellipsoid is None:
        return None
    if not indenter.is_one_plain_ball:
        raise InputError(
            f"({tip.x_mm:g}, {tip.y_mm:g}) mm lies beyond the border of face {tip.face}; over an edge rolls "
            "one hemisphere, rigid, straight and without friction. Set the indenter so, or press on the face"
        )
    angle = length / indenter.radius_mm
    if angle > np.pi / 2 + 1e-9:
        raise InputError(
            f"({tip.x_mm:g}, {tip.y_mm:g}) mm lies {length:.4g} mm beyond the border of face {tip.face}: the "
            f"tip has rolled by more than 90°, {np.pi / 2 * indenter.radius_mm:.4g} mm. Press the next face"
        )
    across = frame.axes[:, :2] @ beyond / length
    outward = np.cos(angle) * frame.normal + np.sin(angle) * across
    first = np.cross(outward, frame.axes @ [-beyond[1] / length, beyond[0] / length, 0.0])
    axes = np.column_stack([first, np.cross(outward, first), outward])
    return EdgePlace(tip, np.asarray(frame.to_object(np.append(on_face, 0.0))), axes)


def _nearest_on_face(frame: FaceFrame, xy_mm: Float[np.ndarray, "2"]) -> Float[np.ndarray, "2"]:
    half = np.asarray(frame.half_extents_mm)
    if frame.round:
        return xy_mm * min(1.0, half.min() / max(float(np.linalg.norm(xy_mm)), 1e-9))
    return np.clip(xy_mm, -half, half)


def edge_mesh(spec: ObjectSpec, place: EdgePlace) -> TetMesh:
    """Tetrahedra that are fine round the place.

    Raises
    ------
    SolverError
        As `tetrahedralize`.
    """
    radius, mesh = spec.indenter.radius_mm, spec.mesh
    reach = radius * np.array([_FINE_RADII, _FAR_RADII])
    edges = [_FINEST_EDGE * mesh.surface_edge_mm, mesh.edge_mm]

    def edge_length(points_mm: np.ndarray) -> np.ndarray:
        return np.interp(np.linalg.norm(points_mm - place.point_mm, axis=1), reach, edges)

    return tetrahedralize(spec, edge_length)


def edge_presser(
    spec: ObjectSpec, mesh: TetMesh, place: EdgePlace
) -> Callable[[Float[np.ndarray, "1"]], JointPress]:
    """Function from a depth along the way, from the first touch, to the press.

    `JointPress.force_n` is the force along the way.

    Raises
    ------
    InputError
        The shell slides on its core.
    SingularSystemError
        The matrix could not be factored.
    """
    if spec.mechanics.interface != "bonded":
        raise InputError(
            "presses over an edge know a bonded core only. Set mechanics.interface = 'bonded'"
        )
    system = elastic_system(mesh, spec)
    facets = facets_under_tip(system.mesh, place, spec.indenter.radius_mm)
    moments, vertices = leaning_moments(system.space, facets, place.outward)
    across = (system.mesh.p[:, vertices].T - place.point_mm) @ place.axes[:, :2]
    under = np.linalg.norm(across, axis=1) < spec.indenter.radius_mm
    moments, vertices = moments[:, under], vertices[under]
    tractions = rows_of([-part * moments for part in place.outward])
    condensed = condensed_compliance(system, mesh, tractions)
    weights, gaps = _moments(system.mesh, facets, vertices, place, spec)
    count = len(vertices)
    compliance, motion = condensed[:count, :count], condensed[count:, :count]

    def press(depth_mm: np.ndarray) -> JointPress:
        (pressure,) = contact_pressures(compliance, gaps, weights, np.asarray(depth_mm, float))
        force = np.array([pressure @ weights])
        touched = np.array([weights[pressure > 0].sum()])
        moved = (motion @ pressure).reshape(-1, 6)
        return JointPress((place.tip,), depth_mm, force, np.zeros((1, 2)), touched, moved)

    return press


def facets_under_tip(mesh: MeshTet, place: EdgePlace, radius_mm: float) -> Int[np.ndarray, "facet"]:
    """Facets of the boundary that face the tip, with a corner in its outline, as deep as it is high."""
    boundary = mesh.boundary_facets()
    corners = np.moveaxis(mesh.p[:, np.asarray(mesh.facets)[:, boundary]], 0, -1)
    local = (corners - place.point_mm) @ place.axes
    within = (np.linalg.norm(local[..., :2], axis=-1) < radius_mm).any(axis=0)
    facets = boundary[within & (local[..., 2] > -2 * radius_mm).all(axis=0)]
    lean = np.asarray(FacetBasis(mesh, ElementTetP1(), facets=facets).normals)[..., 0].T
    return facets[lean @ place.outward > _STEEPEST]


def _moments(
    mesh: MeshTet,
    facets: Int[np.ndarray, "facet"],
    vertices: Int[np.ndarray, "hat"],
    place: EdgePlace,
    spec: ObjectSpec,
) -> tuple[Float[np.ndarray, "hat"], Float[np.ndarray, "hat"]]:
    """∫ φ_i dA and ∫ φ_i gap dA over the area across the way, mm² and mm³."""
    basis = FacetBasis(mesh, ElementTetP1(), facets=facets, intorder=_ORDER)
    points = np.moveaxis(np.asarray(basis.global_coordinates()), 0, -1)
    local = (points - place.point_mm) @ place.axes
    # cosine of surface and way: d coordinate, f facet, q point
    lean = np.einsum("dfq,d->fq", np.asarray(basis.normals), place.outward)
    shape = tip_shape(spec.indenter)
    # beside its outline the tip is as high as it may be pressed: nothing touches there
    gap = np.minimum(tip_heights_mm(shape, local[..., :2]), shape.height_mm) - local[..., 2]
    weights, gaps = (np.asarray(_weighted.assemble(basis, weight=w)) for w in (lean, lean * gap))
    return weights[vertices], gaps[vertices]


@LinearForm
def _weighted(v, w):
    return w.weight * v
