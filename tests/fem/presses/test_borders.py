"""Presses at a face's border and over its edges, on the coarse mesh of the paper's cube."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frame
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from fem.contact.half_space import Patches, normal_compliance
from fem.contact.indenter import Border, moved, tip_cells
from fem.contact.refined import cells_compliance, refined_face, spread_cells, wide_block
from fem.presses.joint import Tip, press_tips
from fem.presses.over_edge import EdgePlace, edge_place, edge_presser
from fem.presses.shape import hat_pressures
from fem.presses.table import cells_over, press_face, resting_gap_mm, surface_weights_mm2

RADIUS, HALF = 5.0, 21.0
DEPTHS = np.array([1.0, 2.0])
AT_BORDER = [(21.0, 3.0), (19.4, -20.3), (21.0, 21.0)]


def test_a_cut_tip_is_what_lies_within_the_border():
    """Half a tip, and one cut by a corner: areas and centroids of half and quarter disks."""
    indenter = ObjectSpec(name="c").indenter
    far = np.array([9.0, 9.0])
    disk = np.pi * RADIUS**2
    half = tip_cells(indenter, Border(-far, np.array([0.0, 9.0]))).patches
    quarter = tip_cells(indenter, Border(-far, np.zeros(2))).patches
    assert_allclose(half.area_mm2.sum(), disk / 2, rtol=0.005)
    assert_allclose(quarter.area_mm2.sum(), disk / 4, rtol=0.005)
    mean = half.area_mm2 @ half.centre_mm / half.area_mm2.sum()
    assert_allclose(mean, [-4 * RADIUS / (3 * np.pi), 0.0], atol=0.02)
    within = tip_cells(indenter, Border(-far, np.array([0.37, 9.0]))).patches.centre_mm
    assert within[:, 0].max() < 0.37
    circle = Border(np.array([-2.0, -1.0]), np.array([2.0, 3.0]), round=True)
    cells = tip_cells(indenter, circle).patches
    assert_allclose(cells.area_mm2.sum(), np.pi * 4, rtol=0.03)


def test_patches_are_mirrored_beyond_sides_corners_and_circles():
    points = np.array([[1.0, -0.5, 7.0]])
    border = Border(np.array([-4.0, -3.0]), np.array([2.0, 5.0]))
    assert_allclose(border.mirrored(points, [2]), [[3.0, -0.5, 7.0]])
    assert_allclose(border.mirrored(points, [1, 2]), [[3.0, -5.5, 7.0]])
    assert_allclose(border.side_distances_mm(points[:, :2]), [[-5.0, -2.5, -1.0, -5.5]])
    assert border.near_sides(-border.side_distances_mm(points[:, :2]), 2.6) == [[1], [2], [1, 2]]
    circle = Border(np.array([-2.0, -2.0]), np.array([2.0, 2.0]), round=True)
    assert_allclose(circle.mirrored(np.array([[0.0, 1.5]]), [0]), [[0.0, 2.5]])


def test_inside_nothing_of_the_tip_is_cut_and_the_border_is_not_felt(rigid_spec, rigid_response):
    """The same cells and compliance as on a face without a border; at 16 mm the tip is flush."""
    face, tip = refined_face(rigid_response, 0, rigid_spec), tip_cells(rigid_spec.indenter)
    without = refined_face(rigid_response, 0, rigid_spec)
    without.__dict__["border"] = None
    assert cells_over(face, rigid_spec.indenter, tip, np.array([16.0, 0.0])) is tip
    assert cells_over(face, rigid_spec.indenter, tip, np.array([16.1, 0.0])) is not tip
    for x, felt in ((13.0, False), (16.0, True)):
        place = np.array([x, 2.0])
        a, b = (
            wide_block(spread_cells(f, moved(tip.patches, place), place)) for f in (face, without)
        )
        assert (a != b).any() == felt
    force = press_face(
        rigid_spec, rigid_response, 0, np.array([[15.99, 1.0], [16.01, 1.0]]), DEPTHS
    )
    assert_allclose(force.force_n[0], force.force_n[1], rtol=0.003)


@pytest.mark.parametrize("place", AT_BORDER)
def test_contact_conditions_hold_at_the_border(rigid_spec, rigid_response, place):
    """Compliance symmetric and positive, pressure ≥ 0, gap ≥ 0 and never both; force by its cells."""
    face, xy = refined_face(rigid_response, 2, rigid_spec), np.array(place)
    cut = cells_over(face, rigid_spec.indenter, tip_cells(rigid_spec.indenter), xy)
    spread = spread_cells(face, moved(cut.patches, xy), xy)
    compliance = wide_block(spread) + cells_compliance(cut.patches, rigid_spec)
    assert_allclose(compliance, compliance.T, rtol=0, atol=1e-9 * compliance.max())
    assert np.linalg.eigvalsh(compliance).min() > 0
    pressed = press_tips(rigid_spec, rigid_response, [Tip(3, *place)], DEPTHS[:1])
    table = press_face(rigid_spec, rigid_response, 2, xy[None], DEPTHS)
    assert_allclose(pressed.force_n, table.force_n[0, :1], rtol=1e-9)
    hats = surface_weights_mm2(rigid_response.surfaces[2])
    assert_allclose(table.vertex_mpa[0] @ hats, table.force_n[0], rtol=1e-6)
    assert (resting_gap_mm(cut, spread) >= 0).all()


def test_force_falls_smoothly_towards_an_edge_and_a_corner(rigid_spec, rigid_response):
    """NGSolve: a third of the force at 13.5 mm on the edge, an eighth on the corner."""
    x = np.arange(13.5, 21.01, 0.75)
    edge = press_face(rigid_spec, rigid_response, 0, np.column_stack([x, 0 * x]), DEPTHS).force_n
    corner = press_face(rigid_spec, rigid_response, 0, np.column_stack([x, x]), DEPTHS).force_n
    for force, share in ((edge, 0.327), (corner, 0.135)):
        assert (np.diff(force, axis=0) < 0).all()
        assert abs(np.diff(force, 2, axis=0)).max() < 0.06 * force.max()
        assert_allclose(force[-1, 0] / edge[0, 0], share, rtol=0.1)


def test_a_quarter_space_gives_way_by_its_mirror_image(rigid_spec, rigid_response):
    """One cell on the border: what is added is ψ H of its image less that of its hats."""
    face = refined_face(rigid_response, 0, rigid_spec)
    nu = rigid_spec.silicone.poisson_ratio
    cell = Patches(np.array([0.2]), np.array([[20.9, 1.3]]), np.array([0.02]))
    spread, bare = spread_cells(face, cell, cell.centre_mm[0]), replace(face)
    bare.__dict__["border"] = None
    added = wide_block(spread) - wide_block(replace(spread, face=bare))
    image = replace(spread.patches, centre_mm=spread.patches.centre_mm * [-1, 1, 1] + [42.0, 0, 0])
    here = normal_compliance(spread.patches, image, *face.elastic)
    hats = replace(
        face.hats,
        area_mm2=face.hats.area_mm2[spread.rows],
        centre_mm=face.hats.centre_mm[spread.rows],
        variance_mm2=face.hats.variance_mm2[spread.rows],
    )
    beyond = replace(hats, centre_mm=hats.centre_mm * [-1, 1, 1] + [42.0, 0, 0])
    wide = spread.matrix.T @ normal_compliance(hats, beyond, *face.elastic) @ spread.matrix
    # the mesh leaves the plane of the border by its envelope
    psi = 1.29 - (0.08 - 0.5 * nu) / (1 - nu)
    assert_allclose(added, psi * (here - wide), rtol=0.02)


def test_a_place_over_an_edge_leans_as_far_as_the_tip_has_rolled(rigid_spec):
    quarter = RADIUS * np.pi / 4
    assert edge_place(rigid_spec, Tip(1, 21.0, -3.0)) is None
    over = edge_place(rigid_spec, Tip(1, HALF + quarter, -3.0))
    assert_allclose(over.point_mm, [21.0, -3.0, 21.0], atol=1e-9)
    assert_allclose(over.outward, np.array([1, 0, 1]) / np.sqrt(2), atol=1e-9)
    assert_allclose(over.axes.T @ over.axes, np.eye(3), atol=1e-12)
    assert np.linalg.det(over.axes) == pytest.approx(1.0)
    corner = edge_place(rigid_spec, Tip(1, HALF + 2.0, HALF + 2.0))
    assert_allclose(corner.point_mm, [21.0, 21.0, 21.0], atol=1e-9)
    assert np.arccos(corner.outward[2]) == pytest.approx(np.sqrt(8) / RADIUS)
    with pytest.raises(InputError, match="rolled by more than 90°"):
        edge_place(rigid_spec, Tip(1, HALF + 7.9, 0.0))
    flat = rigid_spec.changed(indenter=rigid_spec.indenter.changed(kind="flat"))
    assert edge_place(flat, Tip(1, HALF + 1.0, 0.0)) is None
    finger = rigid_spec.changed(indenter=rigid_spec.indenter.changed(kind="ellipsoid"))
    with pytest.raises(InputError, match="one hemisphere"):
        edge_place(finger, Tip(1, HALF + 1.0, 0.0))


def test_along_a_face_s_normal_it_is_the_contact_of_the_face_s_hats(
    rigid_spec, rigid_response, coarse_mesh
):
    """The same unknowns, loads and gaps, by another way through the code."""
    frame, xy = face_frame(rigid_spec, 3), np.array([4.0, -3.0])
    place = EdgePlace(Tip(3, *xy), frame.to_object(np.append(xy, 0.0)), frame.axes)
    pressed = edge_presser(rigid_spec, coarse_mesh, place)(np.array([1.5]))
    hats = hat_pressures(rigid_spec, rigid_response, 2, xy[None], 1.5)[0]
    force = hats @ surface_weights_mm2(rigid_response.surfaces[2])
    assert_allclose(pressed.force_n[0], force, rtol=1e-3)
    rows = rigid_response.compliance[rigid_response.magnet_loads, rigid_response.face_loads(2)]
    motion = (rows @ hats).reshape(-1, 6)
    assert_allclose(pressed.motion, motion, rtol=0, atol=2e-3 * abs(motion).max())


def test_a_press_along_the_bisector_moves_both_faces_alike(rigid_spec, coarse_mesh):
    """x and z of the object change places; the coarse mesh is not symmetric."""
    place = edge_place(rigid_spec, Tip(1, HALF + RADIUS * np.pi / 4, 0.0))
    press = edge_presser(rigid_spec, coarse_mesh, place)
    shallow, deep = press(np.array([2.0])), press(np.array([3.0]))
    assert 1.5 < deep.force_n[0] / shallow.force_n[0] < 3
    layout = magnet_layout(rigid_spec)
    for top in np.flatnonzero(layout.face == 1):
        swapped = layout.centre_mm[top][[2, 1, 0]]
        side = int(np.argmin(np.linalg.norm(layout.centre_mm - swapped, axis=1)))
        difference = deep.motion[top, :3] - deep.motion[side, [2, 1, 0]]
        assert abs(difference).max() < 0.1 * abs(deep.motion[:, :3]).max()
    slides = rigid_spec.changed(mechanics=rigid_spec.mechanics.changed(interface="frictionless"))
    with pytest.raises(InputError, match="bonded core only"):
        edge_presser(slides, coarse_mesh, place)
