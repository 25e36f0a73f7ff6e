"""Bricks split into tetrahedra, prisms of triangles, and edges that grow below the faces."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from fem.mesh.edge_lengths import FINE_LAYER_MM, fine_under_all_faces, split_bricks
from fem.mesh.surfaces import prism_surface, surface_tolerance_mm

SPEC = ObjectSpec(name="cube")


def test_bricks_are_filled_by_six_tetrahedra_each_of_one_orientation():
    shape = (3, 2, 4)
    tets = split_bricks(shape)
    assert tets.shape == (6 * 2 * 1 * 3, 4)
    points = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), -1).reshape(-1, 3)
    corner = points[tets].astype(float)
    volume = np.linalg.det(corner[:, 1:] - corner[:, :1]) / 6
    assert_allclose(volume, 1 / 6)
    assert len(np.unique(np.sort(tets, axis=1), axis=0)) == len(tets)
    low, high = corner.min(axis=1), corner.max(axis=1)
    assert_allclose(high - low, 1.0)  # within one brick


@pytest.mark.parametrize("sides", [3, 6, 24])
def test_a_prism_is_closed_and_holds_its_volume(sides):
    turn = 2 * np.pi * np.arange(sides) / sides
    found = prism_surface(2 * np.column_stack([np.cos(turn), np.sin(turn)]), 3.0)
    assert found.is_watertight
    area = sides / 2 * 4 * np.sin(2 * np.pi / sides)
    assert_allclose(found.volume, 3 * area)
    assert_allclose(found.bounds[:, 2], [-1.5, 1.5])


def test_edges_are_fine_half_a_millimetre_deep_and_coarse_from_half_the_shell_below_that():
    frame, mesh, half = face_frame(SPEC, 3), SPEC.mesh, SPEC.shell.thickness_mm / 2
    depths = np.array([-1.0, 0.0, FINE_LAYER_MM, FINE_LAYER_MM + half / 2, FINE_LAYER_MM + half])
    points = frame.to_object(np.column_stack([0 * depths, 0 * depths, -depths]))
    fine, coarse = mesh.surface_edge_mm, mesh.edge_mm
    wanted = [fine, fine, fine, (fine + coarse) / 2, coarse]
    assert_allclose(fine_under_all_faces(SPEC, points), wanted)
    half_mm = frame.half_extents_mm
    aside = frame.to_object(np.array([[0.0, half_mm[1] - 0.3, -20.0]]))  # under a neighbour
    assert_allclose(fine_under_all_faces(SPEC, aside), fine)


@pytest.mark.parametrize(("envelope_mm", "tolerance_mm"), [(0.02, 0.1), (0.05, 0.1), (0.06, 0.12)])
def test_a_node_belongs_to_a_surface_within_two_envelopes(envelope_mm, tolerance_mm):
    spec = ObjectSpec(name="cube")
    spec = spec.changed(mesh=spec.mesh.changed(envelope_mm=envelope_mm))
    assert surface_tolerance_mm(spec) == pytest.approx(tolerance_mm)
