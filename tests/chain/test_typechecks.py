"""The types that the tests enforce: a wrong shape is noticed, in every test anew."""

import numpy as np
import pytest
from jaxtyping import TypeCheckError

from fem.mesh.tetrahedra import TetMesh, tet_volumes_mm3
from tests.support import typechecks

MESH = TetMesh(np.eye(4, 3), np.array([[0, 1, 2, 3]]), np.array([-1]))
WRONG = np.zeros((2, 2))


@pytest.mark.parametrize("again", range(2))
def test_a_wrong_shape_is_noticed_in_the_first_calls_of_a_test(again):
    with pytest.raises(TypeCheckError):
        tet_volumes_mm3(WRONG)
    for _ in range(typechecks.CALLS):
        tet_volumes_mm3(MESH)
    with pytest.raises(AttributeError):
        tet_volumes_mm3(WRONG)
