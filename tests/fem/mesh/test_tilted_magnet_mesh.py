"""Tilted magnets in the mesh: prisms follow them, pockets are full, mechanics turn with the frame."""

import numpy as np
import scipy.sparse as sp
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation
from skfem import MeshTet

from design.layout.places.positions import magnet_layout, shell_body_layout
from design.layout.surface import sealed_body_surface
from fem.linear.elements import assemble, saddle_point_matrix, taylor_hood
from fem.linear.factorization import solve_symmetric
from fem.linear.magnets import rigid_motion_basis
from fem.linear.material import lame_constants
from fem.mesh.surfaces import body_surfaces, points_in_body
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA, box_mesh
from tests.support.objects.small_object import small_spec

SPEC = small_spec()
TURN = Rotation.from_rotvec([0.4, -0.7, 0.9])


def test_prisms_lie_along_the_tilted_axes():
    layout = magnet_layout(SPEC)
    for surface, centre, axis in zip(
        body_surfaces(SPEC), layout.centre_mm, layout.axis, strict=True
    ):
        height = (surface.vertices - centre) @ axis
        assert_allclose(abs(height), 0.5, rtol=0, atol=1e-9)
        assert_allclose(surface.volume, np.pi * 9, rtol=1e-12)


def test_pockets_are_full_of_silicone_in_the_mesh():
    """Above each magnet, off its axis too: within the body, and in no magnet."""
    layout, bodies, body = magnet_layout(SPEC), shell_body_layout(SPEC), sealed_body_surface(SPEC)
    aside = np.cross(layout.axis, [0.2, 0.5, -0.7])
    aside /= np.linalg.norm(aside, axis=1, keepdims=True)
    for height, sideways in ((0.6, 0.0), (1.2, 2.0), (1.2, -2.0)):
        points = layout.centre_mm + height * layout.axis + sideways * aside
        assert body.contains(points).all()
        for index in range(len(bodies.face)):
            assert not points_in_body(points, bodies, index, SPEC).any()


def magnet_compliance(turn, tilted=True):
    """Motions of a tilted rigid disk in a block, per force and moment on it, in a turned frame."""
    mesh = box_mesh((5, 4, 4), (10.0, 8.0, 6.0), 0.2)
    centre = np.array([4.7, 4.2, 3.3])
    axis = Rotation.from_rotvec([0.5, -0.3, 0.0]).apply([0, 0, 1]) if tilted else np.eye(3)[2]
    points = turn.apply(mesh.p.T)
    space = taylor_hood(MeshTet(points.T, mesh.t))
    original = turn.inv().apply(space.nodes_mm)
    along = (original - centre) @ axis
    across = np.linalg.norm(original - centre - along[:, None] * axis, axis=1)
    owner = np.where((abs(along) < 1.0) & (across < 2.4), 0, -1)
    assert (owner == 0).sum() > 8
    free = (original[:, 2] > 1e-9) & (owner < 0)
    basis = rigid_motion_basis(space.nodes_mm, free, owner, turn.apply(centre)[None])
    operators = assemble(space, lame_constants(YOUNGS_MODULUS_MPA, 0.4999))
    matrix = saddle_point_matrix(operators, basis, space.pressure_nodes)
    last = np.arange(basis.shape[1] - 6, basis.shape[1])
    loads = sp.csr_matrix((np.ones(6), (last, np.arange(6))), (matrix.shape[0], 6)).toarray()
    return solve_symmetric(matrix, loads)[last]


def turned(compliance, turn):
    both = np.kron(np.eye(2), turn.as_matrix())
    return both @ compliance @ both.T


def test_a_tilted_magnet_s_mechanics_turn_with_the_frame():
    still, moved = magnet_compliance(Rotation.identity()), magnet_compliance(TURN)
    assert_allclose(moved, turned(still, TURN), rtol=0, atol=1e-9 * abs(still).max())
