"""Kinds that stand for a file's surface: of turned bodies, noisy ones, and those that are too far off."""

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from design.body.castable import without_noise
from design.body.kinds.registry import KINDS
from design.placement.exact_kinds import exact_kind

TURN = np.eye(4)
TURN[:3, :3] = Rotation.from_rotvec([0.3, 0.7, -0.4]).as_matrix()


def scan_of(kind, size_mm, noise_mm=0.0, edge_mm=1.5):
    """The kind's surface by small triangles, turned and moved, its corners off along their normals."""
    body = KINDS[kind](size_mm, 0.0, 0.05).outer_surface()
    corners, faces = trimesh.remesh.subdivide_to_size(body.vertices, body.faces, edge_mm, 30)[:2]
    scan = trimesh.Trimesh(corners, faces)
    off = np.random.default_rng(1).normal(0, noise_mm, (len(scan.vertices), 1))
    scan.vertices += off * scan.vertex_normals
    scan.apply_transform(TURN)
    return scan.apply_translation([10.0, -20.0, 5.0])


@pytest.mark.parametrize(
    ("kind", "size_mm"),
    [
        ("box", (30.0, 40.0, 60.0)),
        ("box", (50.0, 50.0, 50.0)),
        ("cylinder", (66.0, 66.0, 101.0)),
        # as much inertia about each axis
        ("cylinder", (50.0, 50.0, 43.3)),
        ("capsule", (44.0, 44.0, 76.0)),
        ("sphere", (60.0, 60.0, 60.0)),
        ("ellipsoid", (50.0, 62.0, 70.0)),
    ],
)
def test_a_turned_body_is_its_kind_of_its_size(kind, size_mm):
    """Within what triangles leave of curved sides."""
    exact = exact_kind(scan_of(kind, size_mm, edge_mm=5.0))
    assert exact
    assert (exact.kind, exact.size_mm) == (kind, pytest.approx(size_mm, abs=0.11))
    assert exact.off_mm < 0.1


@pytest.mark.parametrize(
    ("kind", "size_mm"), [("sphere", (60.0,) * 3), ("ellipsoid", (50.0, 62.0, 70.0))]
)
def test_a_noisy_scan_is_its_kind_once_it_is_smoothed(kind, size_mm):
    scan = scan_of(kind, size_mm, noise_mm=0.1)
    assert exact_kind(scan) is None
    exact = exact_kind(without_noise(scan)[0])
    assert exact
    assert (exact.kind, exact.size_mm) == (kind, pytest.approx(size_mm, abs=0.3))


@pytest.mark.parametrize(("depth_mm", "kind"), [(0.2, "box"), (0.4, None)])
def test_a_groove_counts_by_its_depth(depth_mm, kind):
    body = trimesh.creation.box((40, 50, 60))
    groove = trimesh.creation.box((60, 5, 10)).apply_translation([0, 27.5 - depth_mm, 0])
    exact = exact_kind(trimesh.boolean.difference([body, groove], engine="manifold"))
    assert (exact and exact.kind) == kind
    if exact:
        assert exact.off_mm == pytest.approx(depth_mm, rel=0.01)


def test_kinds_on_a_base_and_hollow_things_are_none_of_the_closed_kinds():
    bowl = trimesh.creation.icosphere(4, 30)
    bowl = trimesh.boolean.difference([bowl, trimesh.creation.icosphere(4, 29)], engine="manifold")
    lid = trimesh.creation.box((70, 70, 35)).apply_translation([0, 0, 17.5])
    bowl = trimesh.boolean.difference([bowl, lid], engine="manifold")
    for surface in (bowl, scan_of("dome", (60.0, 60.0, 40.0), edge_mm=5.0)):
        assert exact_kind(surface) is None


def test_a_fine_lump_is_of_no_kind():
    lump = trimesh.creation.icosphere(5, 30)
    lump.vertices *= 1 + 0.05 * np.sin(lump.vertices[:, :1] / 5)
    assert len(lump.faces) > 16_000
    assert exact_kind(lump) is None
