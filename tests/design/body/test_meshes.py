"""What triangle meshes of parts tell, on solids whose walls, edges and peaks are known by hand."""

import time

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.body.meshes import (
    distance_mm,
    height_mm,
    high_points,
    is_surface_triangle,
    largest_ceiling,
    least_draft_deg,
    least_width_mm,
    one_closed_surface,
    peaks_and_saddles,
    sharpest_edge,
    thinnest_wall,
    undercut,
)
from design.errors import NotOneSolid

UP = np.array([0.0, 0.0, 1.0])


def stairs():
    """10 mm long: a foot 3 mm wide, a step 5 mm wide, and a top 20 mm wide."""
    blocks = []
    for low, high, left in ((0, 4, 0.0), (4, 8, 3.0), (8, 12, 8.0)):
        block = trimesh.creation.box((28.0 - left, 10.0, high - low))
        block.apply_translation(((28.0 + left) / 2, 5.0, (low + high) / 2))
        blocks.append(block)
    return trimesh.boolean.union(blocks)


def test_the_deepest_undercut_is_one_ledge_and_not_two_across_a_wall():
    mesh = stairs()
    below = mesh.triangles_center[:, 2] < 11.9
    found = undercut(mesh, UP, below)
    assert_allclose(found.area_mm2, 10 * (3 + 5))
    assert_allclose(found.depth_mm, 5)
    assert_allclose(found.place_mm[2], 8)


def test_ends_of_vents_and_slivers_hook_nothing():
    """Ledges of 0.17 mm² where vents end in a rod, and triangles 1e-6 mm high in a mould's half, failed
    `check --fabrication` with 0.33 and 0.47 mm of undercut."""
    for width, hooks in ((0.8, True), (0.6, False)):  # 0.64 and 0.36 mm²
        ledge = trimesh.creation.box((width, width, 1.0))
        assert (undercut(ledge, UP, ledge.face_normals[:, 2] > 0.5).depth_mm > 0) == hooks
    for height, hooks in ((0.5, True), (0.005, False)):
        sliver = hull((0, 0, 9), (0, height, 9), (300, 0, 9), (0, 0, 0))
        found = undercut(sliver, UP, sliver.face_normals[:, 2] > 0.5)
        assert (found.depth_mm > 0, found.area_mm2 > 0) == (hooks, hooks)


def test_walls_along_the_pull_are_no_undercut():
    mesh = stairs()
    upright = np.abs(mesh.face_normals[:, 2]) < 0.5
    assert undercut(mesh, UP, upright).depth_mm == 0


def hull(*points):
    return trimesh.convex.convex_hull(np.array(points, float))


def frustum(bottom, top, height):
    """Square, centred on z, from a half edge below to another above."""
    corners = [(x, y) for x in (-1, 1) for y in (-1, 1)]
    return hull(
        *((x * bottom, y * bottom, 0) for x, y in corners),
        *((x * top, y * top, height) for x, y in corners),
    )


def moved(mesh, *by):
    return mesh.copy().apply_translation(by)


def prism(degrees, length, reach=8.0):
    """A wedge along y whose edge is at x = 0."""
    rise = reach * np.tan(np.deg2rad(degrees))
    return hull(*((x, y, z) for y in (0, length) for x, z in ((0, 0), (reach, 0), (reach, rise))))


def test_the_thinnest_wall_is_found_with_its_middle():
    plate = trimesh.creation.box((10.0, 12.0, 2.0))
    found = thinnest_wall(plate)
    assert_allclose(found.thickness_mm, 2.0, atol=1e-6)
    assert_allclose(found.place_mm[2], 0.0, atol=1e-6)
    hollow = trimesh.boolean.difference(
        [trimesh.creation.box((20, 20, 20)), moved(trimesh.creation.box((14, 15, 14)), 0.5, 0, 0)]
    )
    found = thinnest_wall(hollow)
    assert_allclose(found.thickness_mm, 2.5, atol=1e-6)
    middle = np.sort(np.abs(found.place_mm))
    assert_allclose(middle[2], 8.75, atol=1e-6)


def plate_with_a_film(depth=1e-5):
    """20 × 12 × 2 mm; 0.1 mm from its right end its top steps down, by less than booleans are exact."""
    x, y, z = 10.0, 6.0, 1.0
    left = [(-x, -y, -z), (-x, y, -z), (-x, y, z), (-x, -y, z)]
    right = [(x, py, pz) for _, py, pz in left]
    step = [(x - 0.1, -y, z), (x - 0.1, y, z), (x - 0.1, 0.0, z - depth)]
    sides = [(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6), (0, 5, 1), (0, 4, 5)]
    front = [(0, 3, 8), (0, 8, 7), (0, 7, 4)]
    back = [(1, 9, 2), (1, 6, 9), (1, 5, 6)]
    top = [(3, 10, 8), (3, 2, 10), (2, 9, 10), (8, 6, 7), (8, 9, 6), (8, 10, 9)]
    mesh = trimesh.Trimesh([*left, *right, *step], sides + front + back + top, process=False)
    mesh.fix_normals()
    assert mesh.is_volume
    return mesh


def test_triangles_without_height_have_no_walls():
    """Their normals are those of rounding: of a lump's mould half one told 0.37 mm beside a flange's end."""
    assert_allclose(thinnest_wall(plate_with_a_film()).thickness_mm, 2.0, atol=1e-4)
    assert thinnest_wall(plate_with_a_film(depth=0.01)).thickness_mm < 0.11, "a step is a wall"


def test_slivers_that_face_as_none_of_their_neighbours_do_have_no_walls():
    """Where a core was drawn by fewer triangles one was left 0.008 mm high, across its slope: 0.75 mm beside
    a recess were told of an ellipsoid (random request 213) whose core has 1.85 mm or more."""
    assert_allclose(thinnest_wall(plate_with_a_film(depth=0.008)).thickness_mm, 2.0, atol=0.01)
    strips = trimesh.creation.box((0.009, 4.0, 4.0))
    assert is_surface_triangle(strips).all(), "two that make one side"


def test_walls_of_fine_surfaces_are_measured_in_seconds():
    """41 000 rays: 0.6 s of processor time; through Manifold half a minute or more."""
    outside, inside = (trimesh.creation.icosphere(5, radius) for radius in (30.0, 22.0))
    hollow = trimesh.boolean.difference([outside, moved(inside, 3.0, 0, 0)])
    started = time.process_time()
    found = thinnest_wall(hollow)
    assert time.process_time() - started < 8
    assert_allclose(found.thickness_mm, 5.0, atol=0.01)
    assert_allclose(found.place_mm, [27.5, 0, 0], atol=0.7)


def test_a_wedge_is_a_wall_up_to_15_degrees():
    assert thinnest_wall(prism(16.0, 40.0, 30.0)).thickness_mm > 20, "from end to end"
    assert thinnest_wall(prism(14.0, 40.0, 30.0)).thickness_mm < 1


def test_the_sharpest_convex_edge_is_told_with_its_middle():
    angle, place = sharpest_edge(prism(30.0, 6.0))
    assert_allclose(angle, 30.0, atol=1e-6)
    assert_allclose(place, [0, 3, 0], atol=1e-9)
    assert_allclose(sharpest_edge(trimesh.creation.box((1, 2, 3)))[0], 90.0, atol=1e-6)
    step = stairs()
    assert_allclose(sharpest_edge(step)[0], 90.0, atol=1e-6, err_msg="concave edges are none")


def test_edges_shorter_than_a_fifth_of_a_millimetre_and_slivers_say_nothing():
    assert_allclose(sharpest_edge(prism(30.0, 0.21))[0], 30.0, atol=1e-6)
    assert sharpest_edge(prism(30.0, 0.19))[0] > 55
    thin = trimesh.creation.box((0.009, 0.15, 0.15))
    assert sharpest_edge(thin) is None


def test_a_triangle_s_height_stands_on_its_longest_edge():
    mesh = trimesh.Trimesh([[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 1]], [[0, 1, 2], [0, 1, 3]])
    assert_allclose(height_mm(mesh), [2.4, 3 / np.sqrt(10)])


def test_a_wall_that_leans_hooks_by_its_height_times_the_tangent():
    """Pulled up, a frustum that is wider above is free; one that is wider below hooks by its lean."""
    for bottom, top, height in ((11.0, 10.0, 8.0), (10.1, 10.0, 5.0)):
        mesh = frustum(bottom, top, height)
        sides = np.abs(mesh.face_normals[:, 2]) < 0.9
        found = undercut(mesh, UP, sides)
        assert_allclose(found.depth_mm, bottom - top, rtol=1e-6)
        slant = np.hypot(height, bottom - top)
        assert_allclose(found.area_mm2, 4 * (bottom + top) * slant, rtol=1e-6)
        assert undercut(mesh, -UP, sides).area_mm2 == 0
    steep = frustum(14.0, 4.0, 5.0)
    sides = np.abs(steep.face_normals[:, 2]) < 0.95
    assert undercut(steep, UP, sides).depth_mm > 10, "a ledge must give way by its width"


def test_a_wall_that_runs_slantwise_hooks_by_what_is_along_the_pull():
    """2 mm of it along x, 20 mm across, 22 mm in all, rising by 1 in 20: 0.1 mm, and not 1.1. Facets along
    the seam of a capsule of 144 mm, which hooks nothing, failed with 0.21 mm of 0.16."""
    flat = [(0.0, 0.0), (2.0, 0.0), (22.0, 20.0), (20.0, 20.0)]
    ramp = hull(*((x, y, z) for x, y in flat for z in (0.0, 10.0 + 0.05 * x)))
    found = undercut(ramp, np.array([-1.0, 0.0, 0.0]), ramp.face_normals[:, 2] > 0.5)
    assert_allclose(found.depth_mm, 0.1, rtol=0.15)


def test_the_draft_of_a_pin_that_leans_is_zero_not_what_rounding_leaves():
    axis = np.array([1.0, 2.0, -0.5])
    for angle in np.linspace(0.1, 1.5, 15):
        pin = trimesh.creation.cylinder(2.0, 9.0, sections=64)
        turn = trimesh.transformations.rotation_matrix(angle, axis)
        sides = np.abs(pin.face_normals[:, 2]) < 0.5
        leaning = trimesh.Trimesh(trimesh.transform_points(pin.vertices, turn), pin.faces)
        found = least_draft_deg(leaning, turn[:3, 2], sides)
        assert found is not None
        assert found[0] == 0


def test_half_a_degree_is_no_undercut_and_draft_is_counted_from_there():
    for degrees, hooks in ((0.45, False), (0.55, True)):
        mesh = frustum(10 + 10 * np.tan(np.deg2rad(degrees)), 10.0, 10.0)
        sides = np.abs(mesh.face_normals[:, 2]) < 0.9
        assert (undercut(mesh, UP, sides).area_mm2 > 0) == hooks
        assert (least_draft_deg(mesh, UP, sides) is None) == hooks
        if not hooks:
            assert least_draft_deg(mesh, UP, sides)[0] == 0
        drafted, place = least_draft_deg(mesh, -UP, sides)
        assert_allclose(drafted, degrees, atol=1e-3)
        assert 0 < place[2] < 10
    assert least_draft_deg(mesh, UP, np.zeros(len(mesh.faces), bool)) is None
    wide, narrow = (10.0 + 10 * np.tan(np.deg2rad(d)) for d in (5.0, 2.0))
    below = [(x * wide, y * narrow, 0) for x in (-1, 1) for y in (-1, 1)]
    mesh = hull(*below, *((x, y, 10) for x in (-10, 10) for y in (-10, 10)))
    drafted, place = least_draft_deg(mesh, -UP, np.abs(mesh.face_normals[:, 2]) < 0.9)
    assert_allclose(drafted, 2.0, atol=1e-4)
    assert abs(place[1]) > 9


def test_the_largest_ceiling_is_flat_within_a_degree_and_below_the_rim():
    mesh = stairs()
    area, place = largest_ceiling(mesh, UP, 12.0)
    assert_allclose(area, 50.0)
    assert_allclose(place, [5.5, 5, 8])
    area, place = largest_ceiling(mesh, UP, 13.0)
    assert_allclose(area, 200.0)
    assert largest_ceiling(mesh, UP, 4.0) is None
    assert_allclose(largest_ceiling(frustum(10.0, 5.0, 5.0), UP, 9.0)[0], 100.0)
    for degrees, flat in ((0.9, True), (1.1, False)):
        roof = prism(degrees, 10.0, 10.0)
        assert (largest_ceiling(roof, UP, 9.0) is not None) == flat


def test_air_stays_under_every_peak_but_the_one_that_drains():
    """Two pyramids on a plate: 3 mm and 2 mm over it; the rim lets the higher one out."""
    plate = moved(trimesh.creation.box((30, 12, 2)), 0, 0, -1)
    tents = [
        hull((x - 4, -4, 0), (x + 4, -4, 0), (x - 4, 4, 0), (x + 4, 4, 0), (x, 0, high))
        for x, high in ((-8, 3.0), (8, 2.0))
    ]
    mesh = trimesh.boolean.union([plate, *tents])
    both = high_points(mesh, UP, 9.0)
    assert_allclose(sorted(trap.place_mm[2] for trap in both), [2.0, 3.0], atol=1e-6)
    lower = min(both, key=lambda trap: trap.place_mm[2])
    assert_allclose(lower.depth_mm, 2.0, atol=2e-3)
    assert lower.normal[2] > 0.9
    assert np.isinf(max(trap.depth_mm for trap in both))
    assert [trap.place_mm[0] for trap in high_points(mesh, UP, 3.0)] == [8.0]
    assert len(high_points(mesh, UP, 3.002)) == 2
    assert len(high_points(mesh, UP, 9.0, 1.99)) == 2
    assert len(high_points(mesh, UP, 9.0, 2.01)) == 1


def test_peaks_join_at_their_saddles():
    height = np.array([0.0, 3.0, 1.0, 2.0, 0.5, 2.5, 0.0])
    edges = np.array([[k, k + 1] for k in range(6)])
    assert sorted(peaks_and_saddles(height, edges)) == [(1, -np.inf), (3, 1.0), (5, 0.5)]
    apart = np.array([[0, 1], [1, 2], [4, 5], [5, 6]])
    assert sorted(peaks_and_saddles(height, apart)) == [(1, -np.inf), (3, -np.inf), (5, -np.inf)]


def test_distances_to_a_surface_are_unsigned():
    box = trimesh.creation.box((2, 4, 6))
    points = np.array([[0.0, 0, 0], [3, 0, 0], [1, 2, 5], [4, 6, 3]])
    assert_allclose(distance_mm(box, points), [1, 2, 2, 5], atol=1e-6)


def test_crumbs_are_left_out_and_voids_stay():
    box = trimesh.creation.box((10, 10, 10))
    void = moved(trimesh.creation.box((2, 2, 2)), 1, 1, 1)
    void.invert()
    hollow = trimesh.util.concatenate([box, void])
    assert one_closed_surface(hollow, "part") is hollow
    crumb = moved(trimesh.creation.box((0.9, 1.0, 1.0)), 8, 0, 0)
    inside = moved(trimesh.creation.box((0.3, 0.3, 0.3)), 8, 0, 0)
    inside.invert()
    kept = one_closed_surface(trimesh.util.concatenate([hollow, crumb, inside]), "part")
    assert_allclose(kept.volume, 992.0)
    piece = moved(trimesh.creation.box((1.1, 1.0, 1.0)), 8, 0, 0)
    with pytest.raises(NotOneSolid, match=r"part must be one closed body; .* give 2 \(closed\)"):
        one_closed_surface(trimesh.util.concatenate([hollow, piece]), "part")
    torn = box.copy()
    torn.update_faces(np.arange(11))
    with pytest.raises(NotOneSolid, match=r"not closed"):
        one_closed_surface(torn, "part")


@pytest.mark.parametrize("pull", [UP, -UP, np.array([1.0, 0.0, 0.0])], ids=str)
def test_the_least_width_of_a_bar_is_its_own_in_any_direction_to_a_step(pull):
    """20 × 1 mm across the pull and 7 along it: exact in steps of 2.5°, half a step beside them by its
    corners."""
    ends = np.array([[x, y, z] for x in (-10, 10) for y in (-0.5, 0.5) for z in (0, 7)], float)
    onto = Rotation.align_vectors([pull], [UP])[0]

    def width(degrees):
        turned = Rotation.from_rotvec(pull * np.deg2rad(degrees)).apply(onto.apply(ends))
        return least_width_mm(turned, pull)

    half = np.deg2rad(1.25)
    for degrees in (0.0, 2.5, 42.5, 90.0, 117.5, 177.5):
        assert width(degrees) == pytest.approx(1.0)
        assert width(degrees + 1.25) == pytest.approx(np.cos(half) + 20 * np.sin(half))
