"""One coarse mesh of the paper's cube and its response, built once for all tests of mechanics."""

import os
from dataclasses import dataclass

import pytest

from fem.linear.response import build_response, elastic_system
from fem.mesh.tetrahedra import TetMesh, tetrahedralize
from tests.support import small_object
from tests.support.fem_cases import COARSE_EDGES_MM, paper_cube


@dataclass(frozen=True)
class MeshRun:
    """A mesh, and the names of all files found afterwards in the folder that it was made in."""

    mesh: TetMesh
    left_behind: tuple[str, ...]


@pytest.fixture(scope="session")
def rigid_spec():
    return paper_cube("rigid", COARSE_EDGES_MM)


@pytest.fixture(scope="session")
def points_spec():
    return paper_cube("points", COARSE_EDGES_MM)


@pytest.fixture(scope="session")
def coarse_run(rigid_spec, tmp_path_factory):
    folder, before = tmp_path_factory.mktemp("mesher"), os.getcwd()
    os.chdir(folder)
    try:
        mesh = tetrahedralize(rigid_spec)
    finally:
        os.chdir(before)
    return MeshRun(mesh, tuple(os.listdir(folder)))


@pytest.fixture(scope="session")
def coarse_mesh(coarse_run):
    return coarse_run.mesh


@pytest.fixture(scope="session")
def rigid_response(coarse_mesh, rigid_spec):
    return build_response(coarse_mesh, rigid_spec)


@pytest.fixture(scope="session")
def points_response(coarse_mesh, points_spec):
    return build_response(coarse_mesh, points_spec)


@pytest.fixture(scope="session")
def rigid_system(coarse_mesh, rigid_spec):
    return elastic_system(coarse_mesh, rigid_spec)


@pytest.fixture(scope="session")
def points_system(coarse_mesh, points_spec):
    return elastic_system(coarse_mesh, points_spec)


@pytest.fixture(scope="session")
def small_mesh():
    return small_object.small_mesh()


@pytest.fixture(scope="session")
def small_response(small_mesh):
    return build_response(small_mesh, small_object.small_spec())
