"""Deformed body under one press: displacement, pressure and contact pressure, as VTU."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int
from skfem import Basis

from design.errors import InputError
from design.files import atomic_path
from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.contact.refined import with_dents
from fem.linear.elements import DisplacementSpace
from fem.linear.factorization import solve_symmetric
from fem.linear.response import (
    ElasticSystem,
    FactoredObject,
    ResponseOperator,
    elastic_system,
    face_facets,
    system_loads,
)
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import TetMesh
from fem.presses.table import press_places, profile_moments_mm3, surface_weights_mm2

if TYPE_CHECKING:
    import pyvista

_VTK_TETS = {4: 10, 10: 24}
"""VTK's cell types of tets with 4 and with 10 nodes."""
_EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3))
"""Corners at the ends of an edge, in the order of VTK's nodes 4 to 9."""


@dataclass(frozen=True)
class DeformedShape:
    """Tetrahedra of silicone and magnets (corners, then edges 01 12 02 03 13 23) at one depth.

    `magnet` is the magnet that an element lies in, −1 in silicone. `pressure_mpa` is positive where
    the silicone is compressed, 0 inside rigid magnets, None where the element has no pressure.
    `contact_pressure_mpa` is that under the tip, on the undeformed face's area, 0 elsewhere.
    """

    nodes_mm: Float[np.ndarray, "node 3"]
    tets: Int[np.ndarray, "tet corner"]
    magnet: Int[np.ndarray, "tet"]
    displacement_mm: Float[np.ndarray, "node 3"]
    pressure_mpa: Float[np.ndarray, "node"] | None
    contact_pressure_mpa: Float[np.ndarray, "node"]


@dataclass(frozen=True)
class FacePressure:
    """Contact pressure (MPa) at the vertices of a face, numbered as in the mesh."""

    vertices: Int[np.ndarray, "vertex"]
    pressure_mpa: Float[np.ndarray, "vertex"]


def deformed_shape(
    mesh: TetMesh,
    space: DisplacementSpace,
    displacement_mm: Float[np.ndarray, "component_node"],
    pressure_mpa: Float[np.ndarray, "pressure"],
    contact: FacePressure,
) -> DeformedShape:
    """Nodal fields of a solution; P1 fields are averaged onto the nodes of edges."""
    tets = Basis(space.mesh, space.displacement.elem, intorder=1).element_dofs.T
    vertex = np.zeros(len(mesh.points_mm))
    vertex[space.pressure_nodes] = pressure_mpa
    on_face, pressed = np.zeros(len(vertex), bool), np.zeros(len(vertex))
    on_face[contact.vertices] = True
    pressed[contact.vertices] = contact.pressure_mpa
    silicone = np.unique(space.displacement.element_dofs)
    pressure = np.zeros(space.node_count)
    pressure[silicone] = pressures_on_nodes(mesh, tets, vertex, np.ones(len(vertex), bool))[
        silicone
    ]
    return DeformedShape(
        space.nodes_mm,
        tets,
        np.asarray(mesh.magnet),
        displacement_mm.reshape(3, -1).T,
        pressure if len(space.pressure_nodes) else None,
        pressures_on_nodes(mesh, tets, pressed, on_face),
    )


def shape_of_unknowns(
    system: ElasticSystem,
    mesh: TetMesh,
    unknowns: Float[np.ndarray, "unknown"],
    contact: FacePressure,
) -> DeformedShape:
    """The shape that the unknowns of an elastic system stand for."""
    motions = shape_of(system.motion_basis)[1]
    displacement = system.motion_basis @ unknowns[:motions]
    return deformed_shape(mesh, system.space, displacement, unknowns[motions:], contact)


def table_shapes(
    spec: ObjectSpec,
    mesh: TetMesh,
    response: ResponseOperator,
    face_index: int,
    xy_mm: Float[np.ndarray, "place 2"],
    depth_mm: float,
    factored: FactoredObject | None = None,
) -> list[DeformedShape]:
    """Small-strain shapes of presses on the table's mesh; one factorization, or that of `factored`.

    A hemisphere's contact is solved on the mesh's own hat functions, so that the face follows it;
    the table's contact is finer than the mesh, and its forces differ by what the mesh costs. Other
    indenters, and all on curved faces, press with the hats that stand for the table's contact:
    right under them the face shows less depth than they have.

    Raises
    ------
    InputError
        A tip over the face's border, or a shell that slides on its core.
    """
    if response.core is not None:
        raise InputError(
            "shapes of presses need a shell bonded to its core; mechanics.interface is "
            "'frictionless'. Set it to 'bonded'"
        )
    pressures = hat_pressures(spec, response, face_index, xy_mm, depth_mm)
    weights = np.zeros((len(response.compliance), len(pressures)))
    weights[response.face_loads(face_index)] = pressures.T
    if factored is not None:
        system, unknowns = factored.system, factored.unknowns(weights)
    else:
        system = elastic_system(mesh, spec)
        _, loads = system_loads(mesh, system, spec)
        unknowns = solve_symmetric(system.matrix, loads @ weights)
    number = response.surfaces[face_index].number
    vertices = face_vertices(system, spec, number)
    return [
        shape_of_unknowns(system, mesh, column, FacePressure(vertices, pressure))
        for column, pressure in zip(unknowns.T, pressures, strict=True)
    ]


def hat_pressures(
    spec: ObjectSpec,
    response: ResponseOperator,
    face_index: int,
    xy_mm: np.ndarray,
    depth_mm: float,
) -> np.ndarray:
    """Hat pressures (place, vertex), MPa."""
    depth = np.array([depth_mm])
    frame = face_frame(spec, response.surfaces[face_index].number)
    rigid_ball = spec.indenter.kind == "hemisphere" and not spec.indenter.pad[0]
    if not rigid_ball or not frame.flat:
        return press_places(spec, response, face_index, xy_mm, depth)[:, 0]
    surface, loads = with_dents(spec, response, face_index), response.face_loads(face_index)
    radius, weights = spec.indenter.radius_mm, surface_weights_mm2(surface)
    moments = profile_moments_mm3(surface, xy_mm, radius)
    pressures = np.zeros(moments.shape)
    for row, moment, centre in zip(pressures, moments, xy_mm, strict=True):
        near = np.flatnonzero(np.linalg.norm(surface.xy_mm - centre, axis=1) < radius)
        compliance = np.asarray(response.compliance[loads, loads])[np.ix_(near, near)]
        row[near] = contact_pressures(compliance, moment[near], weights[near], depth)[0]
    return pressures


def face_vertices(system: ElasticSystem, spec: ObjectSpec, face: int) -> Int[np.ndarray, "vertex"]:
    """Vertices of a face in the order of its `FaceSurface`."""
    frame = face_frame(spec, face)
    facets = face_facets(system.mesh, spec, frame)
    return np.unique(np.asarray(system.mesh.facets)[:, facets])


def save_deformed_shape(
    shape: DeformedShape, path: Path | str, motion: Float[np.ndarray, "magnet 6"] | None = None
) -> None:
    """Write the deformed body as VTU.

    Point data `displacement_mm`, `pressure_mpa` and `contact_pressure_mpa`; cell data `magnet` (−1
    in silicone); field data `magnet_motion` (mm and rad, in the object's frame) where given.
    """
    path = Path(path)
    if path.suffix != ".vtu":
        raise InputError(f"a deformed shape is written as .vtu; got {path.name}. Rename the file")
    grid = vtk_grid(shape)
    grid.points = shape.nodes_mm + shape.displacement_mm
    if motion is not None:
        grid.field_data["magnet_motion"] = motion
    with atomic_path(path) as temporary:
        temporary.write_text(_vtu(grid), encoding="utf-8")


def _vtu(grid: pyvista.UnstructuredGrid) -> str:
    """Write the file as PyVista does, less thoroughly compressed: a hundredth larger in two thirds of the
    time.

    In memory, as VTK's writer crashes on a disk that fills.
    """
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

    writer = vtkXMLUnstructuredGridWriter()
    writer.WriteToOutputStringOn()
    writer.SetInputData(grid)
    writer.SetDataModeToBinary()
    writer.SetCompressionLevel(1)
    if not writer.Write():
        raise MemoryError("VTK cannot write the shape of a press")
    return writer.GetOutputString()


def vtk_grid(shape: DeformedShape) -> pyvista.UnstructuredGrid:
    """The undeformed body as a pyvista grid that carries the shape's fields."""
    import pyvista

    corners = shape.tets.shape[1]
    cells = np.insert(shape.tets, 0, corners, axis=1)
    kinds = np.full(len(shape.tets), _VTK_TETS[corners], np.uint8)
    grid = pyvista.UnstructuredGrid(cells.ravel(), kinds, shape.nodes_mm)
    grid.cell_data["magnet"] = shape.magnet
    grid.point_data["displacement_mm"] = shape.displacement_mm
    grid.point_data["contact_pressure_mpa"] = shape.contact_pressure_mpa
    if shape.pressure_mpa is not None:
        grid.point_data["pressure_mpa"] = shape.pressure_mpa
    return grid


def pressures_on_nodes(
    mesh: TetMesh, tets: np.ndarray, vertex: np.ndarray, carries: np.ndarray
) -> np.ndarray:
    """A P1 field at all nodes; edges that leave the vertices that carry it get 0."""
    values = np.zeros(tets.max() + 1)
    values[tets[:, :4]] = vertex[mesh.tets]
    if tets.shape[1] == 10:
        for node, (a, b) in enumerate(_EDGES, start=4):
            ends = mesh.tets[:, [a, b]]
            inside = carries[ends].all(axis=1)
            values[tets[inside, node]] = vertex[ends[inside]].mean(axis=1)
    return values
