"""Every element through the whole object: inertia, reciprocity, compliance of the shell, locking."""

import pytest
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.errors import InputError
from design.spec.object import ObjectSpec
from fem.large_strain.single_press import require_press
from fem.linear.response import build_response, elastic_system, face_pressure_loads
from fem.mesh.tetrahedra import tetrahedralize_for_press
from tests.support.mechanics.fem_cases import (
    SHELL_COMPLIANCE_MM_PER_N,
    all_silicone,
    paper_cube,
    patch_compliances,
    solve_loads,
)
from tests.support.objects.small_object import small_spec

WITHOUT_PRESSURE = ("p2-p0",)
"""Those that take ratios up to 0.4999."""


def with_element(spec, element, **other):
    mechanics = spec.mechanics.model_copy(update={"element": element, **other})
    return spec.model_copy(update={"mechanics": mechanics})


@pytest.mark.parametrize("element", WITHOUT_PRESSURE)
@pytest.mark.parametrize("interface", ["bonded", "frictionless"])
def test_magnets_motions_by_the_operator_equal_a_direct_solve(small_mesh, element, interface):
    spec = with_element(small_spec(interface), element)
    response, system = build_response(small_mesh, spec), elastic_system(small_mesh, spec)
    assert response.negative_pivots in (-1, 0)
    load = response.face_loads(2).start + 5
    forces = face_pressure_loads(system.space, spec)[1][:, [load]].toarray()
    direct = solve_loads(system, forces)[-60:, 0]
    condensed = response.compliance[response.magnet_loads, load]
    assert abs(direct).max() > 1e-4
    assert_allclose(condensed, direct, rtol=0, atol=1e-9 * abs(direct).max())


@pytest.mark.parametrize("element", WITHOUT_PRESSURE)
def test_a_ratio_too_near_to_a_half_is_refused_without_pressure_unknowns(element):
    content = {"name": "a", "mechanics": {"element": element}}
    ObjectSpec.model_validate(content | {"silicone": {"poisson_ratio": 0.4999}})
    with pytest.raises(ValidationError, match=r"up to 0\.4999; got 0\.49995"):
        ObjectSpec.model_validate(content | {"silicone": {"poisson_ratio": 0.49995}})


@pytest.mark.parametrize("element", WITHOUT_PRESSURE)
def test_a_press_with_large_deformation_refuses_other_elements(element):
    with pytest.raises(InputError, match=r'Set mechanics\.element = "taylor-hood"'):
        require_press(with_element(small_spec(), element), 1, 0.0, 0.0, [1.0])


@pytest.mark.slow
def test_shell_compliance_on_a_graded_mesh():
    """Face 1's centre: −0.1 and +0.7 % on 20 000 nodes for both elements."""
    spec = paper_cube((0.9, 4.0))
    mesh = all_silicone(tetrahedralize_for_press(spec, 1, 0.0, 0.0))
    ratio = {}
    for element in ("taylor-hood", *WITHOUT_PRESSURE):
        system = elastic_system(mesh, with_element(spec, element))
        assert system.space.node_count < 55_000
        compliance, _ = patch_compliances(system, spec)
        ratio[element] = compliance[0] / SHELL_COMPLIANCE_MM_PER_N[0.4999]
    assert_allclose(ratio["taylor-hood"], 1, rtol=0, atol=0.01)
    assert_allclose(ratio["p2-p0"], 1, rtol=0, atol=0.01)
    assert ratio["p2-p0"] > ratio["taylor-hood"]
