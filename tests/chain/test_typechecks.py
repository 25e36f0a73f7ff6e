"""The types that the tests enforce: a wrong shape is noticed, in every test anew."""

from dataclasses import replace

import numpy as np
import pytest
from beartype.roar import BeartypeCallHintParamViolation
from jaxtyping import TypeCheckError

from fem.mesh.tetrahedra import TetMesh, mesh_sha256, tet_volumes_mm3
from tests.support import typechecks

MESH = TetMesh(np.eye(4, 3), np.array([[0, 1, 2, 3]]), np.array([-1]))
WRONG = np.zeros((2, 2))


@pytest.mark.parametrize("again", range(2))
@pytest.mark.parametrize(
    ("function", "error"),
    [(tet_volumes_mm3, TypeCheckError), (mesh_sha256, BeartypeCallHintParamViolation)],
)
def test_a_wrong_shape_or_type_is_noticed_in_the_first_calls_of_a_test(function, error, again):
    with pytest.raises(error):
        function(WRONG)
    for _ in range(typechecks.CALLS):
        function(MESH)
    with pytest.raises(AttributeError):
        function(WRONG)


@pytest.mark.parametrize("again", range(2))
def test_a_wrong_field_is_noticed_in_the_first_objects_of_a_test(again):
    with pytest.raises(TypeCheckError):
        replace(MESH, points_mm=WRONG)
    for _ in range(typechecks.CALLS):
        replace(MESH)
    assert replace(MESH, points_mm=WRONG).points_mm is WRONG


def test_a_name_of_an_axis_stands_for_one_size_in_a_call():
    with pytest.raises(TypeCheckError):
        replace(MESH, magnet=np.array([-1, -1]))


def test_where_many_tests_called_a_function_the_first_call_of_a_test_is_still_checked():
    for _ in range(typechecks.TESTS):
        typechecks.next_test()
        mesh_sha256(MESH)
    typechecks.next_test()
    with pytest.raises(BeartypeCallHintParamViolation):
        mesh_sha256(WRONG)
    with pytest.raises(AttributeError):
        mesh_sha256(WRONG)
