"""Rigid magnets tied to a magnet-free mesh: the ties, the balance, and a mesh that resolves them."""

from types import SimpleNamespace

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose
from skfem import MeshTet

from design.layout.places.positions import shell_body_layout
from design.spec.object import MagnetSpec
from fem.candidates import tied_magnets
from fem.candidates.quadrature import skin_quadrature
from fem.candidates.tied_magnets import rigid_magnet_response, tie_functionals
from fem.linear.factorization import SingularSystemError, solve_symmetric
from fem.linear.response import face_pressure_loads

PLACES_MM = ((3.0, -5.0), (-8.0, 6.0))
DEGREE = 1
SPRING_N_PER_MM = 1e7


@pytest.fixture(scope="module")
def spec(cube):
    """Two magnets per face, tilted and each in its own depth."""
    tilts = ((4.0, -7.0), (0.0, 5.0))
    magnets = MagnetSpec(positions_mm=PLACES_MM, tilt_deg=tilts, depth_mm=(2.4, 3.1))
    shell = cube.spec.shell.model_copy(update={"pocket_diameter_mm": 7.0})
    return cube.spec.model_copy(update={"magnets": magnets, "shell": shell})


@pytest.fixture(scope="module")
def tied(cube, spec, factor):
    return rigid_magnet_response(spec, cube.system, factor, cube.response, DEGREE)


@pytest.fixture(scope="module")
def penalised(cube, spec):
    """Motions and surface under one pressure, the ties as springs of 1e7 N/mm instead."""
    system = cube.system
    functionals, rigid = tie_functionals(spec, system.space, DEGREE)
    free, motions = system.motion_basis.shape[1], rigid.shape[1]
    phi = system.motion_basis.T @ functionals.T
    empty = sp.csr_matrix((system.matrix.shape[0] - free, rigid.shape[0]))
    gap = sp.vstack([phi, empty, sp.csr_matrix(-rigid.T)])
    held = sp.block_diag([system.matrix, sp.csr_matrix((motions, motions))])
    load = 7 + cube.response.face_loads(2).start
    tractions = face_pressure_loads(system.space, spec)[1]
    right = np.zeros((held.shape[0], 1))
    right[:free, 0] = (system.motion_basis.T @ tractions[:, [load]]).toarray()[:, 0]
    solution = solve_symmetric(sp.csr_matrix(held + SPRING_N_PER_MM * gap @ gap.T), right)[:, 0]
    surface = tractions.T @ (system.motion_basis @ solution[:free])
    return load, solution[-motions:], surface


def test_condensed_ties_equal_stiff_springs_in_one_matrix(tied, penalised):
    load, motions, surface = penalised
    condensed = tied.compliance[:, load]
    assert abs(motions).max() > 1e-4
    scale = abs(motions).max()
    assert_allclose(condensed[tied.magnet_loads], motions, rtol=0, atol=1e-5 * scale)
    faces = slice(0, tied.magnet_loads.start)
    assert_allclose(condensed[faces], surface, rtol=0, atol=1e-5 * abs(surface).max())


def test_a_rigid_motion_of_the_silicone_is_that_of_the_magnets(cube, spec):
    functionals, rigid = tie_functionals(spec, cube.space, 2)
    shift, turn = np.array([0.3, -0.8, 0.5]), np.array([0.02, -0.06, 0.04])
    u = (shift + np.cross(turn, cube.space.nodes_mm)).T.ravel()
    centres = shell_body_layout(spec).centre_mm
    motion = np.column_stack([shift + np.cross(turn, centres), np.tile(turn, (len(centres), 1))])
    assert_allclose(functionals @ u, rigid @ motion.ravel(), rtol=0, atol=1e-11)
    assert functionals.shape[0] == 10 * 3 * 12


def test_the_tied_compliance_is_symmetric_and_positive_definite(tied):
    compliance = tied.compliance
    assert_allclose(compliance, compliance.T, rtol=0, atol=1e-12 * abs(compliance).max())
    scale = 1 / np.sqrt(np.diag(compliance))
    np.linalg.cholesky(compliance * np.outer(scale, scale))
    assert tied.magnet_loads.stop - tied.magnet_loads.start == 6 * 10


def test_ties_only_ever_stiffen(cube, spec, tied, factor):
    """More functionals, less compliance, for every pressure; without ties the most."""
    more = rigid_magnet_response(spec, cube.system, factor, cube.response, DEGREE + 1)
    faces = slice(0, tied.magnet_loads.start)
    plain = np.diag(cube.response.compliance)
    softer, stiffer = (np.diag(one.compliance)[faces] for one in (tied, more))
    assert (softer < plain * (1 + 1e-9)).all()
    assert (stiffer < softer * (1 + 1e-9)).all()
    assert (softer / plain).min() < 0.99


def test_functionals_that_the_mesh_cannot_tell_apart_are_refused(cube, factor):
    magnets, body = MagnetSpec(positions_mm=(PLACES_MM[0],)), cube.spec.body
    one = cube.spec.model_copy(update={"magnets": magnets, "body": body.changed(sensed_faces=(1,))})
    with pytest.raises(SingularSystemError, match="lower degree"):
        rigid_magnet_response(one, cube.system, factor, cube.response, 8)


def test_ties_of_coarse_meshes_stay_within_a_share_of_the_magnet_s_height(cube, spec, monkeypatch):
    """However long its edges, the skin of the ties is a fifth of the height inside at most."""
    monkeypatch.setattr(tied_magnets, "INSET", 1e3)
    layout = shell_body_layout(spec)
    _, rigid = tie_functionals(spec, cube.system.space, DEGREE)
    inset = tied_magnets.MOST_INSET * layout.bodies[0].height_mm
    local, weights = skin_quadrature(
        layout.bodies[0].outline.inset(inset), layout.bodies[0].height_mm - 2 * inset
    )
    frame = layout.frame[0]
    psi = tied_magnets.polynomials(local, weights, DEGREE) * weights[:, None]
    count = psi.shape[1]
    turned = np.cross(np.eye(3)[0], local @ frame.T)  # once about x
    assert_allclose(rigid[: 3 * count, 3], (psi.T @ turned).T.ravel(), rtol=0, atol=1e-12)


def test_a_unit_cell_s_edges_are_counted_as_often_as_points_lie_in_it():
    """One tetrahedron of legs 1, another of legs 3 beside it, of all six edges each."""
    points = np.array(
        [[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [3, 0, 0], [3, 3, 0], [3, 0, 3], [6, 0, 0]]
    )
    mesh = MeshTet(points.T, np.array([[0, 1, 2, 3], [4, 7, 5, 6]]).T)
    space = SimpleNamespace(mesh=mesh)
    small, large = 3 * (1 + np.sqrt(2)) / 6, 3 * (3 + 3 * np.sqrt(2)) / 6
    inside = np.array([[0.2, 0.2, 0.2], [3.5, 0.5, 0.5], [4.0, 0.2, 0.3]])
    found = tied_magnets.edge_mm.__wrapped__(space, inside)
    assert_allclose(found, (small + 2 * large) / 3)


def test_polynomials_are_orthonormal_on_the_quadrature_and_span_their_degree():
    rng = np.random.default_rng(0)
    points, weights = rng.normal(size=(60, 3)), rng.random(60)
    for degree, count in ((1, 6), (2, 12)):
        basis = tied_magnets.polynomials(points, weights, degree)
        assert_allclose(basis.T @ (weights[:, None] * basis), np.eye(count), atol=1e-9)
        x, y, z = points.T
        for power in (x, y * z, np.ones(60), x**degree):
            share = basis.T @ (weights * power)
            assert_allclose(basis @ share, power, atol=1e-9)
    flat = points * [1, 1, 0]
    flat[:, 2] = 1.0
    assert tied_magnets.polynomials(flat, weights, 1).shape[1] == 3


def test_rigid_motions_are_those_of_shift_and_cross_product():
    rng = np.random.default_rng(1)
    arm, motion = rng.normal(size=(5, 3)), rng.normal(size=6)
    found = np.stack([part @ motion for part in tied_magnets.rigid_motions(arm)], axis=1)
    assert_allclose(found, motion[:3] + np.cross(motion[3:], arm))
