"""The mesh of the real object is sound, and the gate refuses one that is not."""

import os
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import SolverError
from design.layout.places.positions import magnet_layout
from fem.mesh.quality import dihedral_angles_deg, mesh_quality, require_quality
from fem.mesh.tetrahedra import (
    SILICONE,
    TetMesh,
    load_mesh,
    mesh_sha256,
    positively_oriented,
    save_mesh,
    tet_volumes_mm3,
)

DISK_MM3 = np.pi * 9 * 1.0


def test_the_coarse_mesh_passes_its_gate_with_room(coarse_mesh, rigid_spec):
    quality = mesh_quality(coarse_mesh, rigid_spec)
    require_quality(quality)
    assert quality.min_dihedral_deg > 6
    assert abs(quality.volume_error) < 5e-4
    assert quality.magnet_volume_error < 0.01


def test_every_tetrahedron_has_positive_volume(coarse_mesh):
    assert (tet_volumes_mm3(coarse_mesh) > 0).all()


def test_turned_tetrahedra_are_turned_back(coarse_mesh):
    turned = coarse_mesh.tets.copy()
    turned[::3] = turned[::3][:, [1, 0, 2, 3]]
    mesh = replace(coarse_mesh, tets=turned)
    assert (tet_volumes_mm3(mesh) < 0).any()
    corrected = replace(mesh, tets=positively_oriented(mesh.points_mm, turned.copy()))
    assert_allclose(tet_volumes_mm3(corrected), tet_volumes_mm3(coarse_mesh), rtol=1e-9)


def test_every_magnet_has_elements_of_its_own_volume_and_place(coarse_mesh, rigid_spec):
    volume = tet_volumes_mm3(coarse_mesh)
    centroid = coarse_mesh.points_mm[coarse_mesh.tets].mean(axis=1)
    centres = magnet_layout(rigid_spec).centre_mm
    assert set(coarse_mesh.magnet) == {SILICONE, *range(25)}
    for index, centre in enumerate(centres):
        own = coarse_mesh.magnet == index
        assert_allclose(volume[own].sum(), DISK_MM3, rtol=0.01)
        mean = volume[own] @ centroid[own] / volume[own].sum()
        assert_allclose(mean, centre, rtol=0, atol=0.03)


def test_the_mesh_has_vertices_on_the_line_where_the_support_ends(coarse_mesh, rigid_spec):
    """All round the core's end, with no gap much longer than an edge of the bulk."""
    x, y, z = coarse_mesh.points_mm.T
    for across, along in ((x, y), (y, x)):
        for side in (-13, 13):
            line = (abs(across - side) < 0.06) & (abs(z + 13) < 0.06) & (abs(along) < 13.06)
            stops = np.sort(along[line])
            assert stops[0] < -12.9
            assert stops[-1] > 12.9
            assert np.diff(stops).max() < 1.5 * rigid_spec.mesh.edge_mm


def test_a_saved_mesh_comes_back_alike(coarse_mesh, tmp_path):
    save_mesh(coarse_mesh, tmp_path / "mesh.npz")
    loaded = load_mesh(tmp_path / "mesh.npz")
    for name in ("points_mm", "tets", "magnet"):
        saved, read = getattr(coarse_mesh, name), getattr(loaded, name)
        assert saved.dtype == read.dtype
        np.testing.assert_array_equal(saved, read)
    assert os.listdir(tmp_path) == ["mesh.npz"]


def test_the_hash_of_a_mesh_is_that_of_its_content(tmp_path):
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    mesh = TetMesh(points, np.arange(4)[None], np.array([SILICONE]))
    save_mesh(mesh, tmp_path / "mesh.npz")
    moved = points.copy()
    moved[3, 2] = np.nextafter(1, 2)
    others = [
        replace(mesh, points_mm=moved),
        replace(mesh, tets=mesh.tets[:, [1, 2, 0, 3]]),
        replace(mesh, magnet=np.array([0])),
    ]
    assert mesh_sha256(load_mesh(tmp_path / "mesh.npz")) == mesh_sha256(mesh)
    assert len({mesh_sha256(each) for each in (mesh, *others)}) == 4


def test_dihedral_angles_of_two_known_tetrahedra():
    regular = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
    corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    points, tets = np.vstack([regular, corner]), np.array([[0, 2, 1, 3], [4, 5, 6, 7]])
    angles = np.sort(dihedral_angles_deg(TetMesh(points, tets, np.array([-1, -1]))), axis=1)
    assert_allclose(angles[0], np.degrees(np.arccos(1 / 3)), rtol=1e-12)
    oblique = np.degrees(np.arccos(1 / np.sqrt(3)))
    assert_allclose(angles[1], [oblique] * 3 + [90] * 3, rtol=1e-12)


def with_sliver(mesh):
    """The vertex of an element pushed to the plane of the opposite three."""
    points, tet = mesh.points_mm.copy(), mesh.tets[np.argmax(mesh.magnet == SILICONE)]
    points[tet[3]] = points[tet[:3]].mean(axis=0) + 0.01 * (points[tet[3]] - points[tet[0]])
    return replace(mesh, points_mm=points)


def without_a_layer(mesh):
    kept = mesh.points_mm[mesh.tets].mean(axis=1)[:, 2] < 20.3
    return replace(mesh, tets=mesh.tets[kept], magnet=mesh.magnet[kept])


def with_a_lost_half_magnet(mesh):
    own = np.flatnonzero(mesh.magnet == 7)
    magnet = mesh.magnet.copy()
    magnet[own[: len(own) // 2]] = SILICONE
    return replace(mesh, magnet=magnet)


@pytest.mark.parametrize(
    ("damage", "complaint"),
    [
        (with_sliver, "dihedral"),
        (without_a_layer, "relative volume error"),
        (with_a_lost_half_magnet, "magnet volume"),
    ],
)
def test_the_gate_refuses_a_damaged_mesh(coarse_mesh, rigid_spec, damage, complaint):
    with pytest.raises(SolverError, match=complaint):
        require_quality(mesh_quality(damage(coarse_mesh), rigid_spec))


def test_the_gate_refuses_what_is_not_a_number(coarse_mesh, rigid_spec):
    quality = replace(mesh_quality(coarse_mesh, rigid_spec), volume_error=float("nan"))
    with pytest.raises(SolverError, match="volume error"):
        require_quality(quality)
