"""A small magnet-free cube shared by the tests of points, candidates and tied magnets."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from design.layout.body import face_frames
from fem.linear.elements import DisplacementSpace
from fem.linear.response import ElasticSystem, ResponseOperator, build_response, elastic_system
from fem.mesh.tetrahedra import TetMesh, magnet_free_mesh
from tests.support.mechanics.fem_cases import paper_cube

EDGES_MM = (3.0, 7.0)


@dataclass(frozen=True)
class MagnetFree:
    """Mesh of the cube without magnets, its system and its response."""

    spec: object
    mesh: TetMesh
    system: ElasticSystem
    response: ResponseOperator

    @property
    def space(self) -> DisplacementSpace:
        return self.system.space


@cache
def magnet_free_cube():
    spec = paper_cube(EDGES_MM)
    spec = spec.changed(mesh=spec.mesh.changed(envelope_mm=0.03))
    mesh = magnet_free_mesh(spec)
    return MagnetFree(spec, mesh, elastic_system(mesh, spec), build_response(mesh, spec))


def points_in_the_shell(spec, count, seed=3):
    """Random points in the wall of every face, 1 to 7 mm deep, in the object's frame."""
    random = np.random.default_rng(seed)
    points = []
    for frame in face_frames(spec):
        local = np.column_stack(
            [random.uniform(-18, 18, (count, 2)), random.uniform(-7, -1, count)]
        )
        points.append(frame.to_object(local))
    return np.concatenate(points)


def nodal(space, field):
    """Nodal displacements, component by component, of a field of points (n, 3)."""
    return field(space.nodes_mm).T.ravel()
