"""Edges along the support's end, on structured meshes that know nothing of that line."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from skfem import FacetBasis, Functional, MeshTet

from design.spec.object import ObjectSpec
from fem.mesh.support_line import bisect_edges, with_support_lines
from fem.mesh.tetrahedra import TetMesh, tet_volumes_mm3

EDGE_MM = 3.0
HALF_CORE_MM = 13.0


def spec_of(kind, open_faces=(6,)):
    body = {"kind": kind, "size_mm": [42.0, 42.0, 42.0], "open_faces": list(open_faces)}
    content = {
        "name": kind,
        "body": body,
        "magnets": {"positions_mm": [[0.0, 0.0]]},
        "contact_grid": {"pitch_mm": 1.0},
        "mesh": {"edge_mm": EDGE_MM},
    }
    return ObjectSpec.model_validate(content)


def structured_mesh(round_about_z, cells, jiggle, open_both_ends):
    """A cube of 42 mm without its core of 26 mm and the opening below; or the same made round."""
    inner = np.linspace(-HALF_CORE_MM, HALF_CORE_MM, cells)
    plan = np.concatenate([[-21], inner, [21]])
    mesh = MeshTet.init_tensor(plan, plan, np.array([-21, -16.3, -8.9, -2, 4, 11.7, 13, 21]))
    points, tets = mesh.p.T.copy(), mesh.t.T
    centre = points[tets].mean(axis=1)
    top = 99 if open_both_ends else HALF_CORE_MM
    cavity = (abs(centre[:, :2]) < HALF_CORE_MM).all(axis=1) & (centre[:, 2] < top)
    inside = abs(points[:, 2]) < 12
    points[inside, 2] += np.random.default_rng(4).uniform(-jiggle, jiggle, inside.sum())
    if round_about_z:
        reach = np.linalg.norm(points[:, :2], axis=1)
        square = abs(points[:, :2]).max(axis=1)
        points[:, :2] *= np.divide(square, reach, out=np.ones_like(reach), where=reach > 0)[:, None]
    tets = tets[~cavity]
    turned = np.linalg.det(points[tets[:, 1:]] - points[tets[:, :1]]) < 0
    tets[turned] = tets[turned][:, [0, 2, 1, 3]]
    used, tets = np.unique(tets, return_inverse=True)
    return points[used], tets.reshape(-1, 4)


CASES = {
    "box": ("box", (6,), 7, 1.0),
    "box of long edges": ("box", (6,), 3, 0.0),
    "cylinder": ("cylinder", (6,), 13, 1.0),
    "cylinder open at both ends": ("cylinder", (1, 6), 13, 0.5),
}


@pytest.fixture(params=CASES.values(), ids=CASES.keys())
def before_and_after(request):
    kind, opened, cells, jiggle = request.param
    spec = spec_of(kind, opened)
    points, tets = structured_mesh(kind == "cylinder", cells, jiggle, 1 in opened)
    return spec, (points, tets), with_support_lines(points, tets, spec)


def wall_triangles(points, tets, kind):
    """Boundary triangles on the four walls, or on the round one, of the whole cavity."""
    mesh = MeshTet(points.T, tets.T)
    corner = points[mesh.facets[:, mesh.boundary_facets()].T]
    plan = abs(corner[..., :2])
    reach = plan.max(axis=2) if kind == "box" else np.linalg.norm(plan, axis=2)
    return corner[(abs(reach - HALF_CORE_MM) < 0.1).all(axis=1) & (np.ptp(corner[..., 2], 1) > 0)]


def edges_in_plane(triangles, level):
    """End points of the distinct edges within 0.1 mm of a plane of z."""
    sides = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
    sides = sides[(abs(sides[..., 2] - level) < 0.1).all(axis=1)]
    _, first = np.unique(np.round(sides.mean(axis=1), 6), axis=0, return_index=True)
    return sides[first]


def test_no_triangle_of_the_wall_lies_on_both_sides_of_the_line(before_and_after):
    spec, before, after = before_and_after
    for face in spec.body.opened:
        level = HALF_CORE_MM if face == 1 else -HALF_CORE_MM
        crossing = []
        for points, tets in (before, after):
            z = wall_triangles(points, tets, spec.body.kind)[..., 2] - level
            crossing.append(((z.max(axis=1) > 0.1) & (z.min(axis=1) < -0.1)).sum())
        assert crossing[0] > 0 or face == 1
        assert crossing[1] == 0


def test_edges_run_all_round_the_line_and_none_is_long(before_and_after):
    spec, _, (points, tets) = before_and_after
    triangles = wall_triangles(points, tets, spec.body.kind)
    round_mm = 8 * HALF_CORE_MM if spec.body.kind == "box" else 2 * np.pi * HALF_CORE_MM
    for face in spec.body.opened:
        edges = edges_in_plane(triangles, HALF_CORE_MM if face == 1 else -HALF_CORE_MM)
        length = np.linalg.norm(edges[:, 0] - edges[:, 1], axis=1)
        assert_allclose(length.sum(), round_mm, rtol=0.005)
        assert length.max() <= 4 / 3 * EDGE_MM


def test_bisection_moves_no_vertex_and_leaves_the_body_as_it_was(before_and_after):
    _, (points, tets), (finer, finer_tets) = before_and_after
    np.testing.assert_array_equal(finer[: len(points)], points)
    old = tet_volumes_mm3(TetMesh(points, tets, np.zeros(len(tets), int)))
    new = tet_volumes_mm3(TetMesh(finer, finer_tets, np.zeros(len(finer_tets), int)))
    assert (new > 0).all()
    assert_allclose(new.sum(), old.sum(), rtol=1e-12)


def test_the_finer_mesh_is_conforming(before_and_after):
    """A hanging vertex would open inner triangles: the boundary's area would grow."""
    _, before, after = before_and_after
    area = [
        Functional(lambda w: 1 + 0 * w.x[0]).assemble(
            FacetBasis(mesh, mesh.elem(), facets=mesh.boundary_facets(), intorder=1)
        )
        for mesh in (MeshTet(points.T, tets.T) for points, tets in (before, after))
    ]
    assert_allclose(area[1], area[0], rtol=1e-12)


def test_edges_of_one_tetrahedron_are_cut_where_it_is_asked():
    points = np.array([[0, 0, 0], [4.0, 0, 0], [0, 1, 0], [0, 0, 1]])
    edges = np.array([[0, 1], [2, 3]])
    finer, tets = bisect_edges(points, np.arange(4)[None], edges, np.array([0.25, 0.5]))
    assert_allclose(finer[4:], [[1, 0, 0], [0, 0.5, 0.5]])
    volumes = tet_volumes_mm3(TetMesh(finer, tets, np.zeros(4, int)))
    assert_allclose(np.sort(volumes), np.array([0.125, 0.125, 0.375, 0.375]) * 4 / 6)


def test_a_body_on_a_base_has_no_such_line():
    spec = spec_of("sphere")
    points, tets = structured_mesh(False, 5, 0.0, False)
    same, unchanged = with_support_lines(points, tets, spec)
    np.testing.assert_array_equal(same, points)
    np.testing.assert_array_equal(unchanged, tets)
