"""The surface's motion from the stored response is that of the solved shape."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import StoreError
from design.layout.body import face_frames
from fem.presses.shape import table_shapes
from fem.presses.surface_motion import inward_motion_mm, mesh_vertices
from fem.presses.table import press_places

FACE, PLACE, DEPTH_MM = 2, np.array([[6.0, -3.5]]), 1.5


def test_the_surface_moves_as_the_shape_of_the_same_pressures(
    rigid_spec, coarse_mesh, rigid_response, monkeypatch
):
    """Averages over a vertex's hat against nodal values: half of the deepest place apart at most,
    and within a few hundredths away from the tip."""
    pressure = press_places(rigid_spec, rigid_response, FACE, PLACE, np.array([DEPTH_MM]))[:, 0]
    monkeypatch.setattr("fem.presses.shape.hat_pressures", lambda *given: pressure)
    shape = table_shapes(rigid_spec, coarse_mesh, rigid_response, FACE, PLACE, DEPTH_MM)[0]
    found = inward_motion_mm(rigid_spec, rigid_response, FACE, PLACE, np.array([DEPTH_MM]))[0, 0]
    vertices, normals = mesh_vertices(rigid_spec, rigid_response, coarse_mesh.points_mm)
    node = {tuple(np.round(p, 9)): k for k, p in enumerate(shape.nodes_mm)}
    rows = [node[tuple(np.round(coarse_mesh.points_mm[v], 9))] for v in vertices]
    expected = -np.einsum("vk,vk->v", shape.displacement_mm[rows], normals)
    tip = face_frames(rigid_spec)[FACE].to_object(np.append(PLACE[0], 0.0))
    far = np.linalg.norm(coarse_mesh.points_mm[vertices] - tip, axis=1) > 9.0
    assert_allclose(found[far], expected[far], atol=0.04 * DEPTH_MM)
    assert abs(found - expected).max() < 0.5 * DEPTH_MM
    assert np.corrcoef(found, expected)[0, 1] > 0.97
    assert found.max() > 0.6 * DEPTH_MM


def test_a_response_of_another_mesh_is_refused(rigid_spec, coarse_mesh, rigid_response):
    with pytest.raises(StoreError, match="belongs to another mesh"):
        mesh_vertices(rigid_spec, rigid_response, coarse_mesh.points_mm + 5.0)
