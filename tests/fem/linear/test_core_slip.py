"""A slipped core: rigid where the outside is free, linear and reciprocal where the rim is held."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

import fem.linear.core_slip
from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.large_strain.single_press import require_press
from fem.linear.core_interface import rigid_interface_motions
from fem.linear.core_slip import (
    RestingShell,
    move_interface,
    resting_shell,
    shell_motion,
    slipped_response,
    superposed,
)
from fem.linear.response import FaceSurface, ResponseOperator, elastic_system, face_pressure_loads
from fem.presses.results import load_presses, save_presses
from fem.presses.table import press_places, simulate_lattice, surface_weights_mm2
from tests.support.mechanics.fem_cases import solve_loads
from tests.support.objects.small_object import small_spec

SLIP = {"shift_mm": [0.9, -0.6, 0.4], "rotation_deg": [3.0, -2.0, 4.0]}
AMPLITUDES = np.array([0.3, -0.7, 0.5, 0.02, 0.03, -0.05])
DEPTHS_MM = np.array([1.0, 2.0])
TIP_RADIUS_MM = 5.0


@pytest.fixture(scope="module")
def held_system(small_mesh):
    return elastic_system(small_mesh, small_spec(rim="held"))


@pytest.fixture(scope="module")
def held_motion(held_system, small_mesh):
    return move_interface(held_system, small_mesh, small_spec(rim="held"), AMPLITUDES)


def core_points_seen_from_the_shell(points, spec):
    """Where the slip has put points of the core, by its definition: turned, then shifted."""
    turn = Rotation.from_rotvec(np.deg2rad(spec.mechanics.slip.rotation_deg))
    return turn.apply(points) + spec.mechanics.slip.shift_mm


def test_the_shell_moves_by_the_inverse_of_the_core_s_slip():
    spec = small_spec(**SLIP)
    points = np.random.default_rng(2).uniform(-20, 20, (7, 3))
    turn, shift = shell_motion(spec)
    moved = turn.apply(core_points_seen_from_the_shell(points, spec)) + shift
    assert_allclose(moved, points, rtol=0, atol=1e-13)


def assert_rigid(rest, spec):
    layout = shell_body_layout(spec)
    moved = layout.centre_mm + rest.magnet_motion[:, :3]
    assert_allclose(
        core_points_seen_from_the_shell(moved, spec), layout.centre_mm, rtol=0, atol=1e-11
    )
    rotation = np.tile(-np.deg2rad(SLIP["rotation_deg"]), (len(moved), 1))
    assert_allclose(rest.magnet_motion[:, 3:], rotation, rtol=0, atol=1e-12)


def test_with_a_free_outside_the_slip_moves_the_shell_rigidly(small_mesh):
    spec = small_spec(**SLIP)
    rest = resting_shell(small_mesh, spec)
    assert_allclose(rest.deviation, 0, rtol=0, atol=1e-12)
    assert_rigid(rest, spec)


def test_a_held_rim_makes_the_slip_deform_the_shell(small_mesh):
    spec = small_spec(rim="held", **SLIP)
    rest = resting_shell(small_mesh, spec)
    layout = shell_body_layout(spec)
    deviation = np.linalg.norm(rest.deviation[:, :3], axis=1)
    assert deviation.max() > 0.1
    near_rim = layout.centre_mm[:, 2] < 0
    top = layout.face == 1
    assert deviation[near_rim].max() > 3 * deviation[top].max()


def test_a_held_rim_s_motion_is_linear_in_the_slip(held_system, small_mesh, held_motion):
    spec = small_spec(rim="held")
    parts = [
        move_interface(held_system, small_mesh, spec, AMPLITUDES * mask)
        for mask in (np.array([2, 2, 2, 0, 0, 0.0]), np.array([0, 0, 0, 2, 2, 2.0]))
    ]
    for name in ("displacement_mm", "magnet_motion", "reaction"):
        whole = getattr(held_motion, name)
        sum_of_parts = (getattr(parts[0], name) + getattr(parts[1], name)) / 2
        assert_allclose(sum_of_parts, whole, rtol=0, atol=1e-10 * abs(whole).max())
    assert abs(held_motion.reaction).max() > 1


def test_reactions_of_unit_slips_are_symmetric_and_cost_energy(held_system, small_mesh):
    """s·R is twice the strain energy: R = S s with S symmetric positive definite (Betti)."""
    spec = small_spec(rim="held")
    stiffness = np.stack(
        [move_interface(held_system, small_mesh, spec, unit).reaction for unit in np.eye(6)]
    )
    scale = np.sqrt(np.outer(np.diag(stiffness), np.diag(stiffness)))
    assert_allclose(stiffness / scale, stiffness.T / scale, rtol=0, atol=1e-10)
    assert np.linalg.eigvalsh(stiffness / scale).min() > 1e-3


def test_a_free_shell_needs_no_force_to_follow_its_core(small_mesh):
    spec = small_spec()
    system = elastic_system(small_mesh, spec)
    free = move_interface(system, small_mesh, spec, AMPLITUDES)
    assert_allclose(free.reaction, 0, rtol=0, atol=1e-9)


def test_the_held_interface_s_motion_is_reciprocal_to_a_press(held_system, held_motion):
    """f·u(slip) = −R(f)·s: work of a face's pressure on the slip, and of the core on the press."""
    spec = small_spec(rim="held")
    _, tractions = face_pressure_loads(held_system.space, spec)
    chosen = tractions[:, [tractions.shape[1] // 2]]
    unknowns = solve_loads(held_system, chosen.toarray())[:, 0]
    motions = held_system.motion_basis.shape[1]
    operators, nodes = held_system.operators, held_system.space.pressure_nodes
    internal = operators.stiffness @ (held_system.motion_basis @ unknowns[:motions])
    internal += operators.divergence[nodes].T @ unknowns[motions:]
    lifting = rigid_interface_motions(held_system.space.nodes_mm, spec)
    by_core = lifting.T @ internal @ AMPLITUDES
    on_slip = float((chosen.T @ held_motion.displacement_mm.ravel())[0])
    assert abs(on_slip) > 1e-2
    assert_allclose(on_slip, -by_core, rtol=1e-9)


def forces_n(spec, response, face_index, xy_mm):
    pressures = press_places(spec, response, face_index, np.array([xy_mm]), DEPTHS_MM)
    return pressures[0] @ surface_weights_mm2(response.surfaces[face_index])


def test_a_shifted_shell_is_touched_elsewhere_and_its_depth_counts_from_the_touch(
    small_mesh, small_response
):
    """Face 1 under a core shifted along x, y and z: the indenter in the laboratory stays."""
    spec = small_spec(shift_mm=[0.9, -0.6, 0.4])
    slipped = slipped_response(spec, small_response, resting_shell(small_mesh, spec))
    here = forces_n(spec, slipped, 0, (2.0, 3.0))
    there = forces_n(spec, small_response, 0, (2.9, 2.4))
    elsewhere = forces_n(spec, small_response, 0, (2.0, 3.0))
    assert_allclose(here, there, rtol=1e-8)
    assert abs(here / elsewhere - 1).max() > 1e-3


def mean_contact_shift_mm(spec, response, places_mm):
    """Centre of force less the place, towards +x: mean over the places, so over the mesh."""
    pressure = press_places(spec, response, 0, places_mm, DEPTHS_MM)[:, -1]
    surface = response.surfaces[0]
    force = pressure * surface_weights_mm2(surface)
    return ((force @ surface.xy_mm[:, 0]) / force.sum(axis=1) - places_mm[:, 0]).mean()


def turned_about_y(before_xy_mm, after_xy_mm, height_mm, angle_deg):
    """Heights of turned vertices, found and expected; a mesh puts them close to z = 21, not on it."""
    sin, cos = np.sin(np.deg2rad(angle_deg)), np.cos(np.deg2rad(angle_deg))
    x, y = before_xy_mm.T
    z = (after_xy_mm[:, 0] - x * cos) / sin
    assert_allclose(z, 21, atol=0.1)
    assert_allclose(after_xy_mm[:, 1], y, atol=1e-11)
    return height_mm, z * (cos - 1) - x * sin


def test_a_tilted_face_is_touched_first_on_its_high_side(small_mesh, small_response):
    """A turn of 4° about y lowers face 1 towards +x: the tip's contact moves to −x."""
    spec = small_spec(rotation_deg=[0.0, -4.0, 0.0])
    slipped = slipped_response(spec, small_response, resting_shell(small_mesh, spec))
    before, after = (r.surfaces[0] for r in (small_response, slipped))
    assert_allclose(*turned_about_y(before.xy_mm, after.xy_mm, after.height_mm, 4), atol=1e-11)
    ticks = np.linspace(-9, 9, 17)  # over many elements: single ones are 3.5 mm long
    places = np.stack(np.meshgrid(ticks, ticks), axis=-1).reshape(-1, 2)
    shift = mean_contact_shift_mm(spec, slipped, places)
    shift -= mean_contact_shift_mm(small_spec(), small_response, places)
    assert_allclose(shift, -TIP_RADIUS_MM * np.sin(np.deg2rad(4)), rtol=0.4)


def test_superposed_motions_turn_with_the_shell():
    rng = np.random.default_rng(4)
    rest, motion = rng.normal(0, 0.3, (3, 6)), rng.normal(0, 0.3, (2, 4, 3, 6))
    both = superposed(rest, motion)
    for magnet in range(3):
        turn = Rotation.from_rotvec(rest[magnet, 3:])
        shift = rest[magnet, :3] + turn.apply(motion[1, 2, magnet, :3])
        assert_allclose(both[1, 2, magnet, :3], shift, rtol=0, atol=1e-13)
        axis = np.array([0.3, -0.2, 0.9])
        pressed = Rotation.from_rotvec(motion[1, 2, magnet, 3:]).apply(axis)
        turned = Rotation.from_rotvec(both[1, 2, magnet, 3:]).apply(axis)
        assert_allclose(turned, turn.apply(pressed), rtol=0, atol=1e-13)
    still = superposed(rest, np.zeros((1, 3, 6)))[0]
    assert_allclose(still, rest, rtol=0, atol=1e-13)


@pytest.mark.slow
def test_the_table_of_a_slipped_object_keeps_its_rest(small_mesh, small_response, tmp_path):
    spec = small_spec(**SLIP)
    spec = spec.model_copy(
        update={"contact_grid": spec.contact_grid.model_copy(update={"count": (2, 2)})}
    )
    rest = resting_shell(small_mesh, spec)
    forces, motions = simulate_lattice(spec, small_response, rest=rest)
    before = simulate_lattice(spec, small_response)[1]
    assert before.rest is None
    assert_allclose(motions.rest, rest.magnet_motion, rtol=0, atol=0)
    pressed = np.linalg.norm(motions.motion[..., :3] - motions.rest[:, :3], axis=-1)
    unslipped = np.linalg.norm(before.motion[..., :3], axis=-1)
    assert 0.5 < pressed.mean() / unslipped.mean() < 2
    save_presses(forces, motions, tmp_path / "presses.nc")
    loaded = load_presses(tmp_path / "presses.nc")[1]
    np.testing.assert_array_equal(loaded.rest, motions.rest)
    save_presses(forces, replace(motions, rest=None), tmp_path / "presses.nc")
    assert load_presses(tmp_path / "presses.nc")[1].rest is None


@pytest.mark.parametrize(
    ("spec", "words"),
    [
        (small_spec("frictionless"), "interface = 'frictionless'"),
        (small_spec(**SLIP), "a core that has slipped"),
    ],
)
def test_large_deformation_refuses_what_it_does_not_know(spec, words):
    with pytest.raises(InputError, match=words):
        require_press(spec, 1, 0.0, 0.0, [0.5, 1.0])


def test_rest_is_the_finite_rigid_motion_and_what_deviates_from_the_small_one(monkeypatch):
    """Of a turn by 3°: whose small and finite forms differ by 0.03 mm 22 mm from the axis."""
    slip = {"shift_mm": (0.3, -0.2, 0.1), "rotation_deg": (0.0, 0.0, 3.0)}
    spec = small_spec().changed(mechanics={"slip": slip})
    centre = np.array(shell_body_layout(spec).centre_mm)
    turn, shift = shell_motion(spec)
    nodes = np.random.default_rng(1).uniform(-20, 20, (30, 3))
    small = np.column_stack(
        [shift + np.cross(turn.as_rotvec(), centre), np.tile(turn.as_rotvec(), (len(centre), 1))]
    )
    deviation = 0.1 * np.random.default_rng(2).standard_normal(small.shape)
    bent = 0.1 * np.random.default_rng(3).standard_normal(nodes.shape)
    moved = shift + np.cross(turn.as_rotvec(), nodes) + bent
    solution = fem.linear.core_slip.InterfaceSolution(moved.T, small + deviation, np.zeros(6))
    module = fem.linear.core_slip
    system = SimpleNamespace(space=SimpleNamespace(nodes_mm=nodes))
    monkeypatch.setattr(module, "elastic_system", lambda mesh, spec: system)
    monkeypatch.setattr(module, "move_interface", lambda *given: solution)
    monkeypatch.setattr(module, "deviation_at_faces", lambda system, spec, moved_mm: (moved_mm,))
    rest = resting_shell.__wrapped__(None, spec)
    finite = turn.apply(centre) + shift - centre
    assert_allclose(rest.deviation, deviation, atol=1e-12)
    assert_allclose(rest.magnet_motion[:, :3], finite + deviation[:, :3], atol=1e-12)
    assert_allclose(rest.magnet_motion[:, 3:], turn.as_rotvec() + deviation[:, 3:], atol=1e-12)
    assert_allclose(rest.face_shift_mm[0], turn.apply(nodes) + shift - nodes + bent, atol=1e-12)


def test_vertices_of_slipped_faces_move_in_their_plane_and_out_of_it():
    spec = ObjectSpec.model_validate({"name": "two", "body": {"sensed_faces": [2, 3]}})
    xy = np.array([[0.0, 1.0], [2.0, 3.0], [4.0, -5.0]])
    surfaces = tuple(FaceSurface(number, xy, np.array([[0, 1, 2]])) for number in (2, 3))
    shift = np.array([[0.1, 0.2, 0.3], [0.0, -0.4, 0.0], [0.7, 0.0, -0.6]])
    response = ResponseOperator(surfaces, np.eye(2), 2, 0)
    none = np.zeros((0, 6))
    rest = RestingShell(none, none, (shift, 2 * shift))
    found = slipped_response(spec, response, rest)
    for surface, frame, moved in zip(
        found.surfaces, face_frames(spec), (shift, 2 * shift), strict=True
    ):
        assert surface.number == frame.number
        assert_allclose(surface.xy_mm, xy + np.column_stack([moved @ frame.x, moved @ frame.y]))
        assert_allclose(surface.height_mm, moved @ frame.normal)
    assert_allclose(found.compliance, np.eye(2))
