"""Response operator: one factorization that answers every press.

Loads are unit P1 pressures at the vertices of every sensed face, and unit forces and moments on
every magnet. Their mutual compliance Lᵀ A⁻¹ L holds the surface compliance for contact and, by
reciprocity (A is symmetric), every magnet's motion under any pressure on any face.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int
from skfem import BilinearForm, ElementTetP1, FacetBasis, MeshTet

from design.body.surface_chart import FaceFrame
from design.files import atomic_path
from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.linear.core_interface import (
    CoreContact,
    held_components,
    prescribed_loads,
    wall_openings,
)
from fem.linear.elements import (
    DisplacementSpace,
    MixedOperators,
    assemble,
    element_space,
    free_motion_basis,
    saddle_point_matrix,
)
from fem.linear.factorization import (
    Compliance,
    LoadedFactor,
    SingularSystemError,
    compliance_of_loads,
)
from fem.linear.layers import layer_stiffness
from fem.linear.magnets import magnet_of_nodes, rigid_motion_basis
from fem.linear.material import lame_constants
from fem.linear.sparse import columns_of, rows_of, shape_of
from fem.mesh.entities import tet_mesh
from fem.mesh.surfaces import surface_tolerance_mm
from fem.mesh.tetrahedra import SILICONE, TetMesh


@dataclass(frozen=True)
class FaceSurface:
    """Triangulation of one sensed face: places (x, y) of its vertices and triangles.

    `relief_mm` is the height of a curved face at the vertices over its frame's plane; `height_mm` is
    how far they lie above the face at rest, `slip_mm` how far they lie to the side of it, on a slipped shell.
    None where there is none.
    """

    number: int
    xy_mm: Float[np.ndarray, "vertex 2"]
    triangles: Int[np.ndarray, "triangle 3"]
    height_mm: Float[np.ndarray, "vertex"] | None = None
    relief_mm: Float[np.ndarray, "vertex"] | None = None
    slip_mm: Float[np.ndarray, "vertex 2"] | None = None

    @property
    def points_mm(self) -> Float[np.ndarray, "vertex 3"]:
        """The vertices at rest in the face's frame, without slip."""
        height = np.zeros(len(self.xy_mm)) if self.relief_mm is None else self.relief_mm
        return np.column_stack([self.xy_mm, height])


@dataclass(frozen=True)
class ResponseOperator:
    """Condensed elastic response of a whole object; `core` where it slides on a frictionless core.

    `compliance` (load, load): first the vertices of every face, face by face (conjugate: ∫ φ_i u·(−n) dA,
    mm³ per MPa), then six motions per magnet (mm, rad per MPa of pressure at a vertex).
    """

    surfaces: tuple[FaceSurface, ...]
    compliance: Float[np.ndarray, "load load"]
    unknowns: int
    negative_pivots: int
    core: CoreContact | None = None

    def face_loads(self, index: int) -> slice:
        """Rows of the index-th face's vertices."""
        first = sum(len(surface.xy_mm) for surface in self.surfaces[:index])
        return slice(first, first + len(self.surfaces[index].xy_mm))

    @property
    def magnet_loads(self) -> slice:
        """Rows of the magnets' motions."""
        return slice(sum(len(surface.xy_mm) for surface in self.surfaces), len(self.compliance))


@dataclass(frozen=True)
class ElasticSystem:
    """An object on its core, before any load: A (q, p) = (loads, 0), u = motion_basis q."""

    mesh: MeshTet
    space: DisplacementSpace
    operators: MixedOperators
    motion_basis: sp.csr_matrix
    matrix: sp.csr_matrix


def elastic_system(mesh: TetMesh, spec: ObjectSpec) -> ElasticSystem:
    """Assemble the silicone, hold what the core holds, tie the magnets.

    Unknowns: every free displacement (by component), six motions of every rigid magnet, then the
    pressures (Taylor–Hood only).
    """
    skfem_mesh = tet_mesh(mesh.points_mm, mesh.tets)
    elements = np.flatnonzero(mesh.magnet == SILICONE) if mesh.magnets else None
    space = element_space(skfem_mesh, spec.mechanics.element, elements)
    silicone = spec.silicone
    constants = lame_constants(silicone.youngs_modulus_mpa, silicone.poisson_ratio)
    chosen = slice(None) if elements is None else elements
    operators = assemble(space, constants, layer_stiffness(mesh.points_mm[mesh.tets[chosen]], spec))
    motion = motion_basis_of(mesh, space, spec)
    matrix = saddle_point_matrix(operators, motion, space.pressure_nodes)
    return ElasticSystem(skfem_mesh, space, operators, motion, matrix)


def displacements(
    system: ElasticSystem, factor: Factorization, forces_n: Float[np.ndarray, "n load"]
) -> Float[np.ndarray, "n load"]:
    """Nodal displacements (mm) under nodal forces, both (3·node, load)."""
    motions = shape_of(system.motion_basis)[1]
    right = np.zeros((shape_of(system.matrix)[0], forces_n.shape[1]), order="F")
    right[:motions] = system.motion_basis.T @ forces_n
    return system.motion_basis @ factor.solve(right)[:motions]


def build_response(mesh: TetMesh, spec: ObjectSpec) -> ResponseOperator:
    """Assemble, hold on the core, factor once and condense.

    Raises
    ------
    SingularSystemError
        The factored matrix has not one negative pivot per pressure unknown (none without).
    """
    system = elastic_system(mesh, spec)
    surfaces, loads = system_loads(mesh, system, spec)
    if spec.mechanics.interface == "bonded":
        condensed, core = compliance_of_loads(system.matrix, loads), None
    else:
        condensed, core = _condense_with_core(system, spec, loads)
    return _operator(system, surfaces, condensed, core)


@dataclass(frozen=True)
class FactoredObject:
    """A bonded object and its factor, which answers what the response operator does not hold: the
    unknowns of the system under pressures at the faces' vertices and loads of the magnets."""

    system: ElasticSystem
    factor: LoadedFactor

    def unknowns(self, weights: Float[np.ndarray, "load m"]) -> Float[np.ndarray, "unknown m"]:
        """Under mixtures of the operator's loads, in its order."""
        return self.factor.solve(weights)


def build_and_keep_factor(
    mesh: TetMesh, spec: ObjectSpec
) -> tuple[ResponseOperator, FactoredObject | None]:
    """`build_response`, and the factor, to be released by whoever takes it.

    None where the object slides on its core or its loads depend on each other, as those of patches that
    overlap may.

    Raises
    ------
    SingularSystemError
        As `build_response`.
    """
    if spec.mechanics.interface != "bonded":
        return build_response(mesh, spec), None
    system = elastic_system(mesh, spec)
    surfaces, loads = system_loads(mesh, system, spec)
    try:
        factor = LoadedFactor(system.matrix, loads)
    except SingularSystemError:
        return _operator(system, surfaces, compliance_of_loads(system.matrix, loads), None), None
    try:
        operator = _operator(system, surfaces, factor.compliance, None)
    except BaseException:
        factor.release()
        raise
    return operator, FactoredObject(system, factor)


def _operator(
    system: ElasticSystem,
    surfaces: tuple[FaceSurface, ...],
    condensed: Compliance,
    core: CoreContact | None,
) -> ResponseOperator:
    unknowns, motions = shape_of(system.matrix)[0], shape_of(system.motion_basis)[1]
    require_inertia(condensed.negative_pivots, unknowns - motions)
    return ResponseOperator(surfaces, condensed.matrix, unknowns, condensed.negative_pivots, core)


def system_loads(
    mesh: TetMesh, system: ElasticSystem, spec: ObjectSpec
) -> tuple[tuple[FaceSurface, ...], sp.csr_matrix]:
    """Surfaces of the sensed faces, and loads (unknown, load): a pressure per vertex of theirs, then
    the magnets' motions."""
    surfaces, tractions = face_pressure_loads(system.space, spec)
    unknowns, motions = shape_of(system.matrix)[0], shape_of(system.motion_basis)[1]
    magnets = last_columns(motions, 6 * mesh.magnets)
    loads = columns_of([system.motion_basis.T @ tractions, magnets])
    no_pressure = sp.csr_matrix((unknowns - motions, shape_of(loads)[1]))
    return surfaces, rows_of([loads, no_pressure])


def _condense_with_core(
    system: ElasticSystem, spec: ObjectSpec, loads: sp.csr_matrix
) -> tuple[Compliance, CoreContact]:
    """Compliance of the loads, and the core's forces under them and under openings."""
    openings = wall_openings(system.space, spec)
    lifting = openings.displacement
    operators, pressure_nodes = system.operators, system.space.pressure_nodes
    prescribed = prescribed_loads(operators, system.motion_basis, pressure_nodes, lifting)
    condensed = compliance_of_loads(system.matrix, columns_of([loads, prescribed]))
    count = shape_of(loads)[1]
    matrix = condensed.matrix
    stiffness = (lifting.T @ (operators.stiffness @ lifting)).toarray() - matrix[count:, count:]
    core = CoreContact(
        system.space.nodes_mm[openings.vertices],
        openings.normal,
        openings.weights_mm2,
        -matrix[count:, :count],
        stiffness,
    )
    return Compliance(np.ascontiguousarray(matrix[:count, :count]), condensed.negative_pivots), core


def face_pressure_loads(
    space: DisplacementSpace, spec: ObjectSpec
) -> tuple[tuple[FaceSurface, ...], sp.csr_matrix]:
    """Nodal forces of unit P1 pressures, acting inwards, at the vertices of every face."""
    surfaces, loads = [], []
    for frame in face_frames(spec):
        facets = face_facets(space.mesh, spec, frame)
        surface, moments = face_surface(space, facets, frame)
        surfaces.append(surface)
        if frame.flat:
            loads.append(rows_of([-component * moments for component in frame.normal]))
        else:
            loads.append(rows_of(_curved_moments(space, facets, frame)))
    return tuple(surfaces), columns_of(loads)


def face_facets(mesh: MeshTet, spec: ObjectSpec, frame: FaceFrame) -> Int[np.ndarray, "facet"]:
    """Boundary facets that lie in one sensed face; patches of a curved body overlap."""
    boundary = mesh.boundary_facets()
    corner = np.moveaxis(mesh.p[:, np.asarray(mesh.facets)[:, boundary]], 0, -1)
    local = np.asarray(frame.from_object(corner))
    close = abs(local[..., 2]) < surface_tolerance_mm(spec)
    return boundary[np.all(close & (frame.flat | frame.touched(local[..., :2])), axis=0)]


def face_surface(
    space: DisplacementSpace, facets: np.ndarray, frame: FaceFrame
) -> tuple[FaceSurface, sp.csc_matrix]:
    """Surface of some boundary facets, and ∫ φ_i v dA of P1 pressures against the space's nodes.

    Shape of the moments: (node, vertex), mm².
    """
    mesh = space.mesh
    displacement = FacetBasis(mesh, space.displacement.elem, facets=facets, intorder=3)
    pressure = FacetBasis(mesh, ElementTetP1(), facets=facets, intorder=3)
    vertices, triangles = np.unique(np.asarray(mesh.facets)[:, facets], return_inverse=True)
    moments = _normal_product.assemble(pressure, displacement).tocsc()[:, vertices]
    xy = np.asarray(frame.from_object(mesh.p[:, vertices].T)[:, :2])
    relief = None if frame.flat else frame.relief.evaluate(xy)[0]
    surface = FaceSurface(frame.number, xy, triangles.reshape(3, -1).T, relief_mm=relief)
    return surface, moments


def _curved_moments(
    space: DisplacementSpace, facets: np.ndarray, frame: FaceFrame
) -> list[sp.csc_matrix]:
    """∫ −n_k φ_i v dA for the components k of the surface's own normal, not of its triangles'."""
    mesh = space.mesh
    displacement = FacetBasis(mesh, space.displacement.elem, facets=facets, intorder=4)
    pressure = FacetBasis(mesh, ElementTetP1(), facets=facets, intorder=4)
    vertices = np.unique(np.asarray(mesh.facets)[:, facets])
    points = np.moveaxis(np.asarray(displacement.global_coordinates()), 0, -1)
    inward = -frame.axes_at(frame.from_object(points)[..., :2])[..., 2]
    return [
        _weighted_product.assemble(pressure, displacement, weight=part).tocsc()[:, vertices]
        for part in np.moveaxis(inward, -1, 0)
    ]


def leaning_moments(
    space: DisplacementSpace,
    facets: Int[np.ndarray, "facet"],
    outward: Float[np.ndarray, "3"],
) -> tuple[sp.csc_matrix, Int[np.ndarray, "vertex"]]:
    """∫ φ_i v dA over the area across a direction, (node, vertex) in mm², and the vertices used."""
    mesh = space.mesh
    displacement = FacetBasis(mesh, space.displacement.elem, facets=facets, intorder=3)
    pressure = FacetBasis(mesh, ElementTetP1(), facets=facets, intorder=3)
    vertices = np.unique(np.asarray(mesh.facets)[:, facets])
    # d component of the normal, f facet, q quadrature point
    lean = np.einsum("dfq,d->fq", np.asarray(displacement.normals), outward)
    moments = _weighted_product.assemble(pressure, displacement, weight=lean)
    return moments.tocsc()[:, vertices], vertices


def save_response(response: ResponseOperator, folder: Path | str) -> None:
    """Write `compliance.npy` (memory-mapped on loading) and `surfaces.npz`."""
    folder = Path(folder)
    with atomic_path(folder / "compliance.npy") as temporary, temporary.open("wb") as stream:
        np.save(stream, response.compliance)
    arrays: dict[str, np.ndarray] = {
        "faces": np.array([surface.number for surface in response.surfaces]),
        "counts": np.array([response.unknowns, response.negative_pivots]),
    }
    for surface in response.surfaces:
        arrays[f"xy_mm_{surface.number}"] = surface.xy_mm
        arrays[f"triangles_{surface.number}"] = surface.triangles
        if surface.relief_mm is not None:
            arrays[f"relief_mm_{surface.number}"] = surface.relief_mm
    if response.core is not None:
        arrays |= {f"core_{f.name}": getattr(response.core, f.name) for f in fields(CoreContact)}
    with atomic_path(folder / "surfaces.npz") as temporary, temporary.open("wb") as stream:
        np.savez(stream, **arrays)  # pyright: ignore[reportArgumentType]


def load_response(folder: Path | str) -> ResponseOperator:
    """Read what `save_response` wrote."""
    folder = Path(folder)
    compliance = np.load(folder / "compliance.npy", mmap_mode="r", allow_pickle=False)
    with np.load(folder / "surfaces.npz", allow_pickle=False) as data:
        surfaces = tuple(
            FaceSurface(
                int(n),
                data[f"xy_mm_{n}"],
                data[f"triangles_{n}"],
                relief_mm=data.get(f"relief_mm_{n}"),
            )
            for n in data["faces"]
        )
        unknowns, negative = (int(count) for count in data["counts"])
        names = [f.name for f in fields(CoreContact)]
        sliding = "core_normal" in data
        core = CoreContact(**{n: data[f"core_{n}"] for n in names}) if sliding else None
    return ResponseOperator(surfaces, compliance, unknowns, negative, core)


def last_columns(size: int, count: int) -> sp.csr_matrix:
    """The last `count` unit vectors of `size` unknowns, as columns."""
    rows = np.arange(size - count, size)
    return sp.csr_matrix((np.ones(count), (rows, np.arange(count))), shape=(size, count))


def motion_basis_of(mesh: TetMesh, space: DisplacementSpace, spec: ObjectSpec) -> sp.csr_matrix:
    """Return what nothing holds as free, and magnets as six motions each."""
    free = space.elastic_nodes & ~held_components(space.nodes_mm, spec)
    if not mesh.magnets:
        return free_motion_basis(free)
    owner = magnet_of_nodes(mesh, space)
    centres = shell_body_layout(spec).centre_mm
    return rigid_motion_basis(space.nodes_mm, free & (owner < 0), owner, centres)


@BilinearForm
def _normal_product(pressure, displacement, _):
    return pressure * displacement


@BilinearForm
def _weighted_product(pressure, displacement, w):
    return w.weight * pressure * displacement


def require_inertia(negative_pivots: int, pressures: int) -> None:
    """Raise SingularSystemError where there is not one negative pivot per pressure unknown."""
    if negative_pivots != pressures:
        raise SingularSystemError(
            f"the factored matrix has {negative_pivots} negative pivots instead of {pressures}, "
            "one per pressure unknown: the mesh or the support is broken. Remesh with other edge "
            "lengths"
        )
