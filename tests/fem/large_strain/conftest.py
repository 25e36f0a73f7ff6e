"""A block with a rigid magnet, pressed by a ball."""

import pytest

from fem.large_strain.newton import equilibrium, undeformed
from tests.support.mechanics.large_strain_cases import block


@pytest.fixture(scope="module")
def pressed():
    """The block with its magnet, pressed 0.9 mm by a tip of 5 mm."""
    setup = block()
    state = undeformed(setup.problem)
    for depth in (0.3, 0.6, 0.9):
        state = equilibrium(setup.problem, state, setup.centre(depth))
    return setup, state
