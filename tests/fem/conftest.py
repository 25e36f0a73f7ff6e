"""One coarse mesh of the paper's cube and its response, built once for all tests of mechanics."""

import pytest

from fem.linear import factorization
from fem.linear.response import elastic_system
from tests.support.mechanics.fem_cases import COARSE_EDGES_MM, all_silicone, paper_cube
from tests.support.mechanics.kept_factors import kept_solver
from tests.support.objects import small_object
from tests.support.shared import shared_mesh, shared_response


@pytest.fixture(scope="session", autouse=True)
def factors_kept():
    """One factor of a matrix for all tests of mechanics that solve with it."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(factorization, "solver_of", kept_solver)
        yield


@pytest.fixture(scope="session")
def rigid_spec():
    return paper_cube(COARSE_EDGES_MM)


@pytest.fixture(scope="session")
def coarse_mesh(rigid_spec):
    return shared_mesh(rigid_spec)


@pytest.fixture(scope="session")
def rigid_response(coarse_mesh, rigid_spec):
    return shared_response(coarse_mesh, rigid_spec)


@pytest.fixture(scope="session")
def plain_response(coarse_mesh, rigid_spec):
    return shared_response(all_silicone(coarse_mesh), rigid_spec)


@pytest.fixture(scope="session")
def rigid_system(coarse_mesh, rigid_spec):
    return elastic_system(coarse_mesh, rigid_spec)


@pytest.fixture(scope="session")
def plain_system(coarse_mesh, rigid_spec):
    return elastic_system(all_silicone(coarse_mesh), rigid_spec)


@pytest.fixture(scope="session")
def small_mesh():
    return small_object.small_mesh()


@pytest.fixture(scope="session")
def small_response(small_mesh):
    return shared_response(small_mesh, small_object.small_spec())
