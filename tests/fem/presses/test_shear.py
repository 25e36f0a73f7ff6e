"""Magnet motions under tangential forces: reciprocity against a direct solve, frames, files."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import magnet_layout
from fem.linear.magnets import magnet_of_nodes
from fem.linear.response import face_pressure_loads
from fem.presses.shear import load_shear, motions_under_traction, save_shear, simulate_shear
from fem.presses.table import press_places, surface_weights_mm2
from tests.support.mechanics.fem_cases import solve_loads

FACE_INDEX, PLACE, STEP = 2, 9, 1
"""Face 3 (+x) at an unsymmetrical place, (-5, 10) mm, 1 mm deep."""


@pytest.fixture(scope="module")
def spec(rigid_spec):
    """Places every 5 mm, of which five lie over magnets."""
    return rigid_spec.changed(contact_grid={"count": [5, 5], "pitch_mm": 5.0})


@pytest.fixture(scope="module")
def per_traction(rigid_spec, coarse_mesh):
    return motions_under_traction(coarse_mesh, rigid_spec)


@pytest.fixture(scope="module")
def shear(spec, rigid_response, per_traction):
    return simulate_shear(spec, rigid_response, per_traction)


@pytest.fixture(scope="module")
def slipping_tip(spec, rigid_spec, rigid_response, rigid_system):
    """Nodal forces (3·node, 2) of 1 N along the face's x and y, as the tip's pressure lies."""
    xy = contact_grid(spec).xy_mm[[PLACE]]
    depths = np.asarray(rigid_spec.press.depths_mm)
    pressure = press_places(rigid_spec, rigid_response, FACE_INDEX, xy, depths)[0, STEP]
    weights = surface_weights_mm2(rigid_response.surfaces[FACE_INDEX])
    _, inward = face_pressure_loads(rigid_system.space, rigid_spec)
    normal = inward[:, rigid_response.face_loads(FACE_INDEX)] @ (pressure / (pressure @ weights))
    frame = face_frames(rigid_spec)[FACE_INDEX]
    size = -frame.normal @ normal.reshape(3, -1)
    return np.stack([np.outer(axis, size).ravel() for axis in (frame.x, frame.y)], axis=1)


def magnet_motions(system, spec, mesh, forces):
    """Displacement of every magnet's centre and its rotation, from the nodes, for each load."""
    solution = solve_loads(system, forces)
    u = np.asarray(system.motion_basis @ solution[: system.motion_basis.shape[1]])
    owner, nodes = magnet_of_nodes(mesh, system.space), system.space.nodes_mm
    found = np.empty((forces.shape[1], len(magnet_layout(spec).face), 6))
    for magnet, centre in enumerate(magnet_layout(spec).centre_mm):
        arm = nodes[owner == magnet] - centre
        rows = np.concatenate([np.tile(np.eye(3), (len(arm), 1)), _cross(arm)], axis=1)
        for load in range(forces.shape[1]):
            moved = u[:, load].reshape(3, -1)[:, owner == magnet].T.ravel()
            found[load, magnet] = np.linalg.lstsq(rows, moved)[0]
    return found


def _cross(arm):
    """ω × r as a matrix on ω, for each arm r."""
    x, y, z = arm.T
    zero = np.zeros_like(x)
    blocks = np.stack([zero, z, -y, -z, zero, x, y, -x, zero], axis=1)
    return blocks.reshape(-1, 3)


def test_motions_per_newton_equal_a_direct_solve_of_the_slipping_tip(
    shear, slipping_tip, rigid_system, rigid_spec, coarse_mesh, direct
):
    assert_allclose(slipping_tip.reshape(3, -1, 2).sum(axis=1), _tangents(rigid_spec), atol=1e-9)
    found = shear.motion_per_n[FACE_INDEX, PLACE, STEP]
    scale = abs(direct).max()
    assert scale > 1e-3
    assert_allclose(found, direct, rtol=0, atol=1e-8 * scale)


@pytest.fixture(scope="module")
def direct(rigid_system, rigid_spec, coarse_mesh, slipping_tip):
    return magnet_motions(rigid_system, rigid_spec, coarse_mesh, slipping_tip)


def _tangents(spec):
    frame = face_frames(spec)[FACE_INDEX]
    return np.stack([frame.x, frame.y], axis=1)


def test_magnets_follow_the_tangential_force(shear, spec):
    """Of a press over each magnet of a face, that magnet moves along with the force."""
    grid = contact_grid(spec).xy_mm
    for index, frame in enumerate(face_frames(spec)):
        for own, xy in enumerate(spec.magnets.positions_mm):
            place = int(np.argmin(np.linalg.norm(grid - xy, axis=1)))
            moved = shear.motion_per_n[index, place, STEP, :, 5 * index + own, :3] @ frame.axes
            assert (moved[[0, 1], [0, 1]] > 3 * abs(moved[:, 2])).all()
            assert (moved[[0, 1], [0, 1]] > 3 * abs(moved[[0, 1], [1, 0]])).all()


def test_a_press_without_contact_has_no_tangential_motion(spec, rigid_response, per_traction):
    shallow = replace_depths(spec, (1e-4, 1.0))
    found = simulate_shear(shallow, rigid_response, per_traction).motion_per_n
    assert np.isfinite(found).all()
    assert (found[:, :, 0] == 0).any()


def replace_depths(spec, depths):
    return spec.model_copy(update={"press": spec.press.model_copy(update={"depths_mm": depths})})


def test_motions_survive_their_file(shear, tmp_path):
    save_shear(shear, tmp_path / "shear.nc")
    back = load_shear(tmp_path / "shear.nc")
    np.testing.assert_array_equal(back.motion_per_n, shear.motion_per_n)
    np.testing.assert_array_equal(back.grid.xy_mm, shear.grid.xy_mm)
    assert replace(back, grid=shear.grid).faces.tolist() == [1, 2, 3, 4, 5]


def test_cores_that_slide_or_slipped_are_refused(rigid_spec, rigid_response, per_traction):
    mechanics = rigid_spec.mechanics.model_copy(update={"interface": "frictionless"})
    sliding = rigid_spec.model_copy(update={"mechanics": mechanics})
    with pytest.raises(InputError, match=r"bonded core that has not slipped"):
        simulate_shear(sliding, rigid_response, per_traction)
