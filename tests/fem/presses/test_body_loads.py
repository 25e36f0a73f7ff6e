"""Motions of magnets under forces on themselves: a direct solution, and a wall in their way."""

import numpy as np
import scipy.linalg
from numpy.testing import assert_allclose
from scipy.optimize import nnls

from fem.linear.magnets import magnet_of_nodes
from fem.presses.body_loads import motions_under_loads
from fem.presses.table import surface_weights_mm2
from tests.support.mechanics.fem_cases import solve_loads

RNG = np.random.default_rng(6)


def test_forces_and_torques_move_magnets_as_forces_on_their_nodes_do(
    coarse_mesh, rigid_system, rigid_response
):
    """Random forces on the nodes of two magnets; their resultants about the nodes' centre."""
    owner = magnet_of_nodes(coarse_mesh, rigid_system.space)
    nodes, count = rigid_system.space.nodes_mm, owner.max() + 1
    nodal, loads = np.zeros((len(nodes), 3)), np.zeros((count, 6))
    centre = np.zeros((count, 3))
    for magnet in range(count):
        own = np.flatnonzero(owner == magnet)
        centre[magnet] = (nodes[own].min(axis=0) + nodes[own].max(axis=0)) / 2
        if magnet in (1, 12):
            nodal[own] = RNG.normal(size=(len(own), 3)) / len(own)
            arm = nodes[own] - centre[magnet]
            loads[magnet] = [*nodal[own].sum(axis=0), *np.cross(arm, nodal[own]).sum(axis=0)]
    solution = solve_loads(rigid_system, nodal.T.reshape(-1, 1))[:, 0]
    motion_unknowns = rigid_system.motion_basis.shape[1]
    expected = solution[motion_unknowns - 6 * count : motion_unknowns].reshape(count, 6)
    moved = motions_under_loads(rigid_response, loads)
    assert_allclose(moved, expected, atol=2e-3 * abs(expected).max())
    assert abs(moved[1, :3]).max() > 1e-3


def pulled_outwards(magnets, n=0.3):
    """Forces along +z on the magnets of face 1."""
    loads = np.zeros((magnets, 6))
    loads[:5, 2] = n
    return loads


def test_a_wall_holds_the_silicone_back_and_lets_go_of_what_sinks(rigid_response):
    magnets = (rigid_response.magnet_loads.stop - rigid_response.magnet_loads.start) // 6
    loads = pulled_outwards(magnets)
    free, held, far = (
        motions_under_loads(rigid_response, loads, wall) for wall in (None, (0, 0.0), (0, 5.0))
    )
    assert_allclose(far, free)
    assert (held[:5, 2] > 0.2 * free[:5, 2]).all()
    assert (held[:5, 2] < 0.7 * free[:5, 2]).all()
    face = rigid_response.face_loads(0)
    magnet = rigid_response.magnet_loads
    # The wall's pressures, the oracle: least squares without negative ones, p ≥ 0.
    sunk = rigid_response.compliance[face, magnet] @ loads.ravel()
    lower = np.linalg.cholesky(np.array(rigid_response.compliance[face, face]))
    right = -scipy.linalg.solve_triangular(lower, sunk, lower=True)
    pressure = nnls(lower.T, right)[0]
    by_wall = rigid_response.compliance[magnet, face] @ pressure
    assert_allclose(held - free, by_wall.reshape(-1, 6), atol=1e-6)
    # It presses with less than the pull, of which the core bears the rest.
    borne = pressure @ surface_weights_mm2(rigid_response.surfaces[0])
    assert 0.2 < borne / loads[:, 2].sum() < 1
    pushed = motions_under_loads(rigid_response, -loads)
    on_wall = motions_under_loads(rigid_response, -loads, (0, 0.0))
    assert np.linalg.norm(on_wall - pushed) < 0.2 * np.linalg.norm(pushed)
