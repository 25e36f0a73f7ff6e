"""The small cube without magnets, and its matrix, factored once."""

import pytest

from fem.linear.factorization import Factorization
from tests.support.objects.magnet_free_cases import magnet_free_cube


@pytest.fixture(scope="session")
def cube():
    return magnet_free_cube()


@pytest.fixture(scope="session")
def factor(cube):
    with Factorization(cube.system.matrix) as factor:
        yield factor
