"""The response operator of the real object: reciprocity, balance, stiffness, frames, files."""

from dataclasses import dataclass

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout
from fem.linear.magnets import magnet_of_nodes
from fem.linear.response import face_pressure_loads, load_response, save_response
from fem.presses.table import surface_weights_mm2
from tests.support.mechanics.fem_cases import (
    SHELL_COMPLIANCE_MM_PER_N,
    patch_compliances,
    patch_loads,
    solve_loads,
    with_poisson_ratio,
)

FACE_INDEX = 2
"""Face 3 (+x)."""


@dataclass(frozen=True)
class DirectSolve:
    """One P1 pressure load, solved without any condensation."""

    load: int
    forces_n: np.ndarray
    u_mm: np.ndarray
    residual_n: np.ndarray


def direct_solve(system, spec):
    """Unit pressure at the vertex of face 3 nearest to (x, y) = (5, −7) mm."""
    surfaces, tractions = face_pressure_loads(system.space, spec)
    before = sum(len(surface.xy_mm) for surface in surfaces[:FACE_INDEX])
    distance = np.linalg.norm(surfaces[FACE_INDEX].xy_mm - [5.0, -7.0], axis=1)
    load = before + int(np.argmin(distance))
    forces = tractions[:, [load]].toarray()
    solution = solve_loads(system, forces)[:, 0]
    motions = system.motion_basis.shape[1]
    u = system.motion_basis @ solution[:motions]
    pressure = np.zeros(system.operators.divergence.shape[0])
    pressure[system.space.pressure_nodes] = solution[motions:]
    internal = system.operators.stiffness @ u + system.operators.divergence.T @ pressure
    residual = (internal - forces[:, 0]).reshape(3, -1)
    return DirectSolve(load, forces.reshape(3, -1), u.reshape(3, -1), residual)


@pytest.fixture(scope="module")
def rigid_solve(rigid_system, rigid_spec):
    return direct_solve(rigid_system, rigid_spec)


def fitted_motions(nodes_mm, u_mm, owner, centres_mm):
    """c and ω of every magnet by least squares on its nodes, and the largest misfit."""
    motions, misfit = [], 0.0
    for magnet, centre in enumerate(centres_mm):
        nodes = owner == magnet
        x, y, z = (nodes_mm[nodes] - centre).T
        one, zero = np.ones_like(x), np.zeros_like(x)
        rows = [
            [one, zero, zero, zero, z, -y],
            [zero, one, zero, -z, zero, x],
            [zero, zero, one, y, -x, zero],
        ]
        matrix = np.concatenate([np.stack(row, axis=1) for row in rows])
        motion, *_ = np.linalg.lstsq(matrix, u_mm[:, nodes].ravel())
        motions.append(motion)
        misfit = max(misfit, abs(matrix @ motion - u_mm[:, nodes].ravel()).max())
    return np.array(motions), misfit


def test_rigid_magnets_motions_by_reciprocity_equal_a_direct_solve(
    coarse_mesh, rigid_system, rigid_spec, rigid_response, rigid_solve
):
    owner = magnet_of_nodes(coarse_mesh, rigid_system.space)
    centres = magnet_layout(rigid_spec).centre_mm
    nodes = rigid_system.space.nodes_mm
    direct, misfit = fitted_motions(nodes, rigid_solve.u_mm, owner, centres)
    condensed = rigid_response.compliance[rigid_response.magnet_loads, rigid_solve.load]
    scale = abs(direct).max()
    assert scale > 1e-3
    assert misfit < 1e-12 * scale * 100
    assert_allclose(condensed.reshape(-1, 6), direct, rtol=0, atol=1e-9 * scale)


def test_compliance_is_symmetric_positive_definite_with_one_negative_pivot_a_pressure(
    rigid_response, rigid_system
):
    compliance = rigid_response.compliance
    assert_allclose(compliance, compliance.T, rtol=0, atol=1e-12 * abs(compliance).max())
    scale = 1 / np.sqrt(np.diag(compliance))
    np.linalg.cholesky(compliance * np.outer(scale, scale))  # fails unless positive definite
    assert rigid_response.unknowns == rigid_system.matrix.shape[0]
    assert rigid_response.negative_pivots == len(rigid_system.space.pressure_nodes)


def test_the_reaction_at_the_core_balances_force_and_moment(
    coarse_mesh, rigid_system, rigid_spec, rigid_solve, rigid_response
):
    nodes = rigid_system.space.nodes_mm.T
    touching_core = (abs(nodes) < 13.1).all(axis=0) & rigid_system.space.elastic_nodes
    in_magnet = magnet_of_nodes(coarse_mesh, rigid_system.space) >= 0
    loose = ~touching_core & ~in_magnet
    reaction = rigid_solve.residual_n * touching_core
    total = rigid_solve.forces_n.sum(axis=1)
    size = float(np.linalg.norm(total))
    assert abs(rigid_solve.residual_n[:, loose]).max() < 1e-9 * size
    assert_allclose(reaction.sum(axis=1), -total, rtol=0, atol=1e-9 * size)
    moment = np.cross(nodes.T, rigid_solve.forces_n.T).sum(axis=0)
    assert_allclose(
        np.cross(nodes.T, reaction.T).sum(axis=0),
        -moment,
        rtol=0,
        atol=1e-9 * float(abs(moment).max()),
    )
    surface = rigid_response.surfaces[FACE_INDEX]
    vertex = rigid_solve.load - rigid_response.face_loads(FACE_INDEX).start
    weight = float(surface_weights_mm2(surface)[vertex])
    assert_allclose(
        total, np.array([-weight, 0, 0]), rtol=0, atol=1e-12 * weight
    )  # inwards on face 3


def interpolated_patch_compliance(response, index):
    """C of p = (1 − r²/25)² taken at the vertices only: for comparing two models on one mesh."""
    surface = response.surfaces[index]
    r2 = np.sum(surface.xy_mm**2, axis=1)
    pressure = np.clip(1 - r2 / 25, 0, None) ** 2
    loads = response.face_loads(index)
    force = pressure @ surface_weights_mm2(surface)
    return pressure @ response.compliance[loads, loads] @ pressure / force**2


def test_rigid_magnets_stiffen_the_face_over_them(rigid_response, plain_response):
    """The tie cut the compliance at the face centres by about 27 % in earlier prototypes."""
    for index in range(5):
        rigid = interpolated_patch_compliance(rigid_response, index)
        plain = interpolated_patch_compliance(plain_response, index)
        assert 0.15 < 1 - rigid / plain < 0.45


@pytest.fixture(scope="module")
def coarse_compliances(plain_system, rigid_spec):
    """C at each ν, and the energy of compression over the whole energy."""
    result = {}
    for nu in (0.49, 0.4999, 0.5):
        system = with_poisson_ratio(plain_system, 0.4999, nu)
        compliance, pressure = patch_compliances(system, rigid_spec)
        totals = patch_loads(system, rigid_spec)[1]
        nodes = system.space.pressure_nodes
        block = system.operators.compressibility[nodes][:, nodes]
        compression = np.einsum("pf,pf->f", pressure, block @ pressure) / totals**2
        result[nu] = (compliance, compression / compliance)
    return result


def test_the_patch_load_has_its_closed_form_resultant(plain_system, rigid_spec):
    forces, totals = patch_loads(plain_system, rigid_spec)
    assert_allclose(totals, np.pi * 25 / 3, rtol=2e-3)
    inwards = forces.reshape(3, -1, 5).sum(axis=1).T
    assert_allclose(inwards[2], [-totals[2], 0, 0], rtol=0, atol=1e-9)


@pytest.mark.parametrize("poisson_ratio", [0.49, 0.4999, 0.5])
def test_shell_compliance_against_its_converged_value(coarse_compliances, poisson_ratio):
    """At every face's centre within 1.5 % on this coarse mesh."""
    compliance, _ = coarse_compliances[poisson_ratio]
    assert_allclose(compliance, SHELL_COMPLIANCE_MM_PER_N[poisson_ratio], rtol=0.015)


def test_the_last_percent_of_poisson_s_ratio_is_worth_2_4_percent(coarse_compliances):
    ratio = coarse_compliances[0.49][0] / coarse_compliances[0.4999][0]
    assert_allclose(ratio, 0.23170 / 0.22621, rtol=0, atol=2e-3)


def test_taking_0_499999_for_0_5_softens_the_shell_by_less_than_1e_5(coarse_compliances):
    """Compression softens by κ ∫ p² dV / F², κ = 1/λ; μ = E/(2(1 + ν)) takes 6.7e-5 back."""
    for nu, low, high in ((0.5, 1e-7, 1e-5), (0.4999, 1e-5, 1e-3)):
        compression = coarse_compliances[nu][1]
        assert (compression > low).all()
        assert (compression < high).all()
    softer = coarse_compliances[0.4999][0] / coarse_compliances[0.5][0] * (1.5 / 1.4999) - 1
    assert_allclose(softer, coarse_compliances[0.4999][1], rtol=0.05)


def test_every_face_s_surface_is_flat_complete_and_in_its_own_frame(rigid_response, rigid_spec):
    for surface, frame in zip(rigid_response.surfaces, face_frames(rigid_spec), strict=True):
        assert surface.number == frame.number
        assert_allclose(surface_weights_mm2(surface).sum(), 42.0**2, rtol=1e-3)
        assert_allclose(abs(surface.xy_mm).max(axis=0), [21, 21], rtol=0, atol=0.05)
        assert surface.triangles.max() == len(surface.xy_mm) - 1


def test_a_saved_response_comes_back_alike(rigid_response, tmp_path):
    save_response(rigid_response, tmp_path / "response")
    loaded = load_response(tmp_path / "response")
    np.testing.assert_array_equal(loaded.compliance, rigid_response.compliance)
    assert (loaded.unknowns, loaded.negative_pivots) == (
        rigid_response.unknowns,
        rigid_response.negative_pivots,
    )
    assert loaded.magnet_loads == rigid_response.magnet_loads
    for read, saved in zip(loaded.surfaces, rigid_response.surfaces, strict=True):
        assert read.number == saved.number
        np.testing.assert_array_equal(read.xy_mm, saved.xy_mm)
        np.testing.assert_array_equal(read.triangles, saved.triangles)
    files = sorted(path.name for path in (tmp_path / "response").iterdir())
    assert files == ["compliance.npy", "surfaces.npz"]
