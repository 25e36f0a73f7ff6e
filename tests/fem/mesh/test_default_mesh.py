"""The mesh of the default specification: shell compliance, layer force, symmetry. Minutes long."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.spec.object import MeshSpec
from fem.linear.response import build_response, elastic_system
from fem.mesh.quality import mesh_quality, require_quality
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import simulate_lattice
from tests.support.mechanics.fem_cases import (
    SHELL_COMPLIANCE_MM_PER_N,
    all_silicone,
    dimitriadis_force_n,
    forces_near_the_centre,
    hertz_loads,
    paper_cube,
    patch_compliances,
    patch_loads,
    relative_mirror_difference,
    solve_loads,
)

pytestmark = pytest.mark.slow
MAGNET_MM_PER_N = {"patch": 0.10273, "hertz": 0.11330}
"""Magnet at the middle of face 1 under two loads there, (1 − r²/25)² and √(1 − r²/9) (r in mm).

NGSolve 6.2.2608: Taylor–Hood P3/P2 (172 000 unknowns), curved elements, true cylinders with edges of
0.4 mm at their rims, a quarter by symmetry. An earlier mesh of the same kind gave 0.10269."""
MOST_UNKNOWNS = 1.1 * 212_044
"""A tenth more than with the mesh before rims were refined, whose bias was −2.6 and −3.3 %."""
EDGES_MM = (MeshSpec().surface_edge_mm, MeshSpec().edge_mm)


def default_cube(poisson_ratio=0.4999):
    return paper_cube(EDGES_MM, poisson_ratio).changed(mesh=MeshSpec())


@pytest.fixture(scope="module")
def default_mesh():
    spec = default_cube()
    mesh = tetrahedralize(spec)
    require_quality(mesh_quality(mesh, spec))
    return mesh


def test_shell_compliance_within_one_percent(default_mesh):
    spec = default_cube()
    compliance, _ = patch_compliances(elastic_system(all_silicone(default_mesh), spec), spec)
    assert_allclose(compliance, SHELL_COMPLIANCE_MM_PER_N[0.4999], rtol=0.01)


def test_layer_force_without_magnets_within_three_percent(default_mesh):
    """Random places within ±4 mm of the face centres; Dimitriadis et al. up to 1 mm."""
    spec = default_cube(0.5)
    response = build_response(all_silicone(default_mesh), spec)
    mean = forces_near_the_centre(spec, response, 60).mean(axis=(0, 1))
    assert_allclose(mean[1:], [1.69, 5.5], rtol=0.03)
    assert_allclose(mean[0], dimitriadis_force_n(0.5, 5.0, 8.0), rtol=0.02)


@pytest.fixture(scope="module")
def default_forces_n(default_mesh):
    spec = default_cube()
    forces, _ = simulate_lattice(spec, build_response(default_mesh, spec))
    return forces.force_n


def test_mirrored_presses_from_one_millimetre_agree_and_every_press_is_in_contact(default_forces_n):
    difference = relative_mirror_difference(default_forces_n[0], default_cube())
    assert (default_forces_n > 0).all()
    assert (difference[1:] < [0.01, 0.008]).all()


@pytest.mark.xfail(reason="missed on most meshes: 1.06 to 1.39 % (docs/verification/scope.md)")
def test_mirrored_presses_of_half_a_millimetre_agree(default_forces_n):
    difference = relative_mirror_difference(default_forces_n[0], default_cube())
    assert difference[0] < 0.012


def test_magnets_under_central_loads_move_as_in_another_code(default_mesh):
    """Mean of five faces: the four others differ from face 1 by less than meshes scatter."""
    spec = default_cube()
    system = elastic_system(default_mesh, spec)
    for name, load in (("patch", patch_loads), ("hertz", hertz_loads)):
        forces, totals = load(system, spec)
        motions = solve_loads(system, forces)[: system.motion_basis.shape[1]]
        below = motions[-6 * 25 :].reshape(5, 5, 6, 5)[range(5), 0, :3, range(5)]
        inward = -np.sum(below * [frame.normal for frame in face_frames(spec)], axis=1) / totals
        bias = inward / MAGNET_MM_PER_N[name] - 1
        assert abs(bias.mean()) < 0.0125
        assert (abs(bias) < 0.02).all()
    assert system.matrix.shape[0] < MOST_UNKNOWNS
