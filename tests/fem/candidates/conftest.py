"""The small cube without magnets; its matrix, factored once, and its disks, tied once."""

import pytest

from fem.candidates.motions import candidate_lattices
from fem.candidates.rigid_body import tied_magnets
from fem.linear.factorization import Factorization
from tests.support.objects.magnet_free_cases import magnet_free_cube


@pytest.fixture(scope="session")
def cube():
    return magnet_free_cube()


@pytest.fixture(scope="session")
def factor(cube):
    with Factorization(cube.system.matrix) as factor:
        yield factor


@pytest.fixture(scope="session")
def lattices(cube):
    return candidate_lattices(cube.spec, pitch_mm=4.0)


@pytest.fixture(scope="session")
def disks(cube, factor, lattices):
    """The rigid disk whose weights are means over all candidates, and the tied ones of which."""
    return tied_magnets(cube.spec, cube.system, factor, lattices)
