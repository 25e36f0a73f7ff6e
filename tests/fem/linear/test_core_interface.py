"""Bonded and frictionless interfaces: closed forms of layers, and the real core's balance."""

import numpy as np
import pytest
import scipy.sparse as sp
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from fem.linear.core_interface import (
    WALLS,
    held_components,
    nodes_on_wall,
    prescribed_loads,
    rigid_interface_motions,
    wall_openings,
)
from fem.linear.elements import assemble, free_motion_basis, saddle_point_matrix, taylor_hood
from fem.linear.factorization import solve_symmetric
from fem.linear.material import lame_constants
from fem.linear.response import build_response, elastic_system, face_pressure_loads
from fem.presses.core_tension import core_tension, largest_core_tension
from fem.presses.table import press_places, surface_weights_mm2
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA, box_mesh
from tests.support.objects.small_object import small_spec

POISSON_RATIO = 0.4999


@pytest.fixture(scope="module")
def sliding(small_mesh):
    return build_response(small_mesh, small_spec("frictionless"))


def platen_force_n(mesh, size, shift_mm, bonded):
    """Force that squeezes a box; bonded platens in plane strain, or frictionless ones."""
    space = taylor_hood(mesh)
    x, y, z = space.nodes_mm.T
    above = z > size[2] - 1e-9
    platens = (z < 1e-9) | above
    free = np.ones((3, len(z)), bool)
    free[2] = ~platens
    if bonded:
        free[0] = ~platens
        free[1] = (y > 1e-9) & (y < size[1] - 1e-9)
    else:  # no rigid motion in the plane
        free[:2, np.argmin(x + y + z)] = False
        free[1, np.argmin(y + z - x)] = False
    lifting = sp.csr_matrix((3 * len(z), 1)).tolil()
    lifting[2 * len(z) + np.flatnonzero(above), 0] = 1
    lifting = lifting.tocsr()
    operators = assemble(space, lame_constants(YOUNGS_MODULUS_MPA, POISSON_RATIO))
    basis = free_motion_basis(free)
    loads = prescribed_loads(operators, basis, space.pressure_nodes, lifting)
    matrix = saddle_point_matrix(operators, basis, space.pressure_nodes)
    unknowns = solve_symmetric(matrix, loads.toarray() * shift_mm)[:, 0]
    motions = basis.shape[1]
    u = basis @ unknowns[:motions] + (lifting @ [shift_mm])
    inner = operators.divergence[space.pressure_nodes].T @ unknowns[motions:]
    return float((lifting.T @ (operators.stiffness @ u + inner))[0])


def test_a_layer_between_frictionless_platens_is_in_uniaxial_stress():
    """F = E A δ/h exactly, at any shape of the layer and any mesh."""
    size = (9.0, 7.0, 2.0)
    force = platen_force_n(box_mesh((4, 3, 2), size, 0.2), size, -0.1, False)
    assert_allclose(force, -YOUNGS_MODULUS_MPA * 63.0 * 0.1 / 2.0, rtol=1e-9)


def test_a_bonded_strip_is_stiffer_by_its_shape_factor():
    """Plane strain: 1/E_a = 1/(4/3 E (1 + S²)) + 1/K, S = width/(2 h) (Gent & Lindley, 1959).

    The end's correction that the formula leaves out is −2.1 % here.
    """
    size = (20.0, 0.5, 2.0)
    shape = size[0] / (2 * size[2])
    mesh = box_mesh((60, 1, 8), size)
    bonded = platen_force_n(mesh, size, -0.1, True)
    apparent = -bonded * size[2] / (size[0] * size[1] * 0.1)
    incompressible = 4 / 3 * YOUNGS_MODULUS_MPA * (1 + shape**2)
    bulk_modulus = YOUNGS_MODULUS_MPA / (3 * (1 - 2 * POISSON_RATIO))
    assert_allclose(apparent, 1 / (1 / incompressible + 1 / bulk_modulus), rtol=0.03)


def test_walls_edges_and_corners_hold_one_two_and_three_components():
    spec = small_spec("frictionless")
    nodes = np.array(
        [
            [13.0, 1, 2],
            [-13, -13, 3],
            [13, -13, 13],
            [2, 3, 13],
            [13, 4, -13],
            [13, 4, -13.5],
            [4, 5, 21],
        ]
    )
    held = held_components(nodes, spec)
    expected = [[1, 0, 0], [1, 1, 0], [1, 1, 1], [0, 0, 1], [1, 0, 0], [0, 0, 0], [0, 0, 0]]
    assert (np.array(expected, bool) == held.T).all()
    bonded = held_components(nodes, small_spec())
    assert (np.array(expected).any(axis=1)[:, None] == bonded.T).all()


def test_the_held_rim_is_the_ring_of_the_open_face_alone():
    nodes = np.array([[17.0, 3, -21], [21, 21, -21], [17, 3, -20.5], [17, 3, 21], [0, 0, 13]])
    held = held_components(nodes, small_spec(rim="held"))
    assert (held.all(axis=0) == [True, True, False, False, True]).all()
    free = held_components(nodes, small_spec())
    assert (free.all(axis=0) == [False, False, False, False, True]).all()


def assert_core_balances(core, response, spec):
    """The core's normal forces hold every face's pressure in force and moment.

    Facets may leave the face's plane by the mesher's envelope: 1e-8 of the force was seen.
    """
    for index, frame in enumerate(face_frames(spec)):
        loads, surface = response.face_loads(index), response.surfaces[index]
        pressure = np.exp(-np.sum((surface.xy_mm - [5.0, -4.0]) ** 2, axis=1) / 40)
        place = frame.to_object(np.column_stack([surface.xy_mm, np.zeros(len(pressure))]))
        applied = -(pressure @ surface_weights_mm2(surface)) * frame.normal
        normal = core.force_per_load[:, loads] @ pressure
        assert_allclose(core.normal.T @ normal, -applied, rtol=0, atol=1e-6 * abs(applied).max())
        arm = hat_centres_mm(surface, place)
        moment = -np.cross(arm, frame.normal).T @ pressure
        by_core = np.cross(core.points_mm, core.normal).T @ normal
        assert_allclose(by_core, -moment, rtol=0, atol=1e-6 * abs(moment).max())


def hat_centres_mm(surface, points):
    """∫ φ_i x dA of a triangulated surface."""
    corner = points[surface.triangles]
    area = (
        np.linalg.norm(np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
        / 2
    )
    total = np.zeros((len(points), 3))
    for k in range(3):
        share = (corner.sum(axis=1) + corner[:, k]) * area[:, None] / 12
        np.add.at(total, surface.triangles[:, k], share)
    return total


def test_the_frictionless_core_balances_force_and_moment_by_normal_forces(sliding):
    assert_core_balances(sliding.core, sliding, small_spec("frictionless"))


def test_rigid_motions_of_the_shell_open_the_core_without_force(sliding):
    core = sliding.core
    scale = abs(core.stiffness).max()
    assert_allclose(core.stiffness, core.stiffness.T, rtol=0, atol=1e-12 * scale)
    for unit in np.eye(3):
        for motion in (np.tile(unit, (len(core.normal), 1)), np.cross(unit, core.points_mm)):
            opening = np.sum(core.normal * motion, axis=1)
            force = core.stiffness @ opening
            assert_allclose(force, 0, rtol=0, atol=1e-3 * scale * abs(opening).max())
    lowest = np.linalg.eigvalsh(core.stiffness)
    assert lowest[6] > 1e3 * abs(lowest[:3]).max()


def test_openings_move_the_loads_by_reciprocity(small_mesh, sliding):
    spec = small_spec("frictionless")
    system = elastic_system(small_mesh, spec)
    openings = wall_openings(system.space, spec)
    chosen = np.array([3, len(openings.vertices) // 2])
    lifting = openings.displacement[:, chosen]
    arguments = (system.operators, system.motion_basis, system.space.pressure_nodes, lifting)
    unknowns = solve_symmetric(system.matrix, prescribed_loads(*arguments).toarray())
    u = system.motion_basis @ unknowns[: system.motion_basis.shape[1]] + lifting.toarray()
    _, tractions = face_pressure_loads(system.space, spec)
    faces = slice(0, tractions.shape[1])
    expected = -sliding.core.force_per_load[chosen, faces].T
    assert abs(expected).max() > 1e-3
    assert_allclose(tractions.T @ u, expected, rtol=0, atol=1e-9 * abs(expected).max())


def test_walls_have_their_area_and_their_vertices_lie_on_them(small_mesh, sliding):
    core, spec = sliding.core, small_spec("frictionless")
    assert_allclose(core.weights_mm2.sum(), 5 * 26.0**2, rtol=1e-3)
    for axis, sign in WALLS:
        mine = core.normal[:, axis] * sign > 0.5
        assert_allclose(core.weights_mm2[mine].sum(), 26.0**2, rtol=1e-3)
        assert nodes_on_wall(core.points_mm[mine], axis, sign, spec).all()


def test_a_sliding_shell_is_softer_and_its_core_would_let_go_somewhere(small_response, sliding):
    bonded, spec = small_response, small_spec("frictionless")
    for index in range(5):
        loads, surface = sliding.face_loads(index), sliding.surfaces[index]
        pressure = np.exp(-np.sum(surface.xy_mm**2, axis=1) / 30)
        soft, stiff = (pressure @ r.compliance[loads, loads] @ pressure for r in (sliding, bonded))
        assert 1.1 < soft / stiff < 2
    place = np.array([[6.0, -3.0]])
    pressures = press_places(spec, sliding, 2, place, np.array([1.0, 2.0]))
    tension, _ = largest_core_tension(sliding, 2, pressures[0])
    forces = sliding.core.force_per_load[:, sliding.face_loads(2)] @ pressures[0].T
    mean = (
        forces
        / sliding.core.weights_mm2[:, None]
        / (pressures[0] @ surface_weights_mm2(sliding.surfaces[2]))
    )
    assert_allclose(tension.pressure_mpa_per_n, -mean.min(), rtol=1e-12)
    assert 1e-4 < tension.pressure_mpa_per_n < 1e-1
    assert abs(abs(tension.point_mm).max() - 13) < 0.1


def test_the_tension_of_an_object_is_that_of_its_worst_press_to_the_deepest_depth(sliding):
    pressed = {
        "press": {"depths_mm": [0.5, 1.0, 2.0]},
        "contact_grid": {"count": [2, 2], "pitch_mm": 5.0},
    }
    spec = ObjectSpec.model_validate(small_spec("frictionless").model_dump() | pressed)
    worst = core_tension(spec, sliding)
    face, x, y = worst.press
    index = [surface.number for surface in sliding.surfaces].index(face)
    pressures = press_places(spec, sliding, index, np.array([[x, y]]), np.array([2.0]))
    tension, _ = largest_core_tension(sliding, index, pressures[:, 0])
    assert_allclose(worst.pressure_mpa_per_n, tension.pressure_mpa_per_n, rtol=1e-9)
    assert 0 < worst.force_drop < 0.5


def test_a_slip_of_a_frictionless_core_is_refused():
    with pytest.raises(ValidationError, match="a shell that slides keeps no slip"):
        ObjectSpec.model_validate(
            {
                "name": "both",
                "mechanics": {"interface": "frictionless", "slip": {"shift_mm": [1.0, 0, 0]}},
            }
        )


def test_rigid_interface_motions_are_shifts_and_rotations_of_the_touching_nodes():
    nodes = np.array([[13.0, 2, -5], [17, 2, -5], [3, -4, 13]])
    lifting = rigid_interface_motions(nodes, small_spec())
    amplitudes = np.array([0.1, -0.2, 0.3, 0.02, 0.05, -0.01])
    u = (lifting @ amplitudes).reshape(3, -1).T
    expected = amplitudes[:3] + np.cross(amplitudes[3:], nodes)
    expected[1] = 0
    assert_allclose(u, expected, rtol=0, atol=1e-14)
