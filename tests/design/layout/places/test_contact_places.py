"""Contact locations that each face has: filled, given, and what is pressed round them."""

from types import SimpleNamespace

import numpy as np
import pytest

from design.errors import SpecError
from design.layout.body import face_frames
from design.layout.places import contact_places as contact_places_module
from design.layout.places.contact_grid import contact_grid, press_lattice
from design.layout.places.contact_places import (
    all_around,
    contact_places,
    grid_count,
    nodes_of_parity,
    pressed_nodes,
    shared_counts,
    stays_on_patch,
    tip_stays,
    touched_reach_mm,
)
from design.layout.places.coverage import covered_share, covered_shares
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec
from tests.support.objects.body_cases import body_spec

FILL = {"contact_grid": {"count": "fill"}}
BOX = ObjectSpec.model_validate({"name": "box", "body": {"size_mm": (60.0, 40.0, 30.0)}} | FILL)


def test_a_face_of_a_box_has_all_locations_whose_margin_stays_on_it():
    grid = contact_grid(BOX).xy_mm
    for frame, there in zip(face_frames(BOX), contact_places(BOX), strict=True):
        room = np.array(frame.half_extents_mm)
        fits = (abs(grid) + 1.5 <= room + 1e-9).all(axis=1)
        np.testing.assert_array_equal(there, fits)
    assert grid_count(BOX) == (20, 19)
    assert shared_counts(BOX) == (10, 13)
    assert covered_share(BOX) > 0.9


def test_an_object_without_a_count_is_filled():
    other = ObjectSpec.model_validate({"name": "box", "body": BOX.body.model_dump()})
    assert other.contact_grid.count == "fill"
    np.testing.assert_array_equal(contact_places(other), contact_places(BOX))


def test_the_papers_cube_is_judged_on_all_of_its_sensed_surface():
    """The paper's own ten by ten locations lie among the fourteen by fourteen."""
    cube = load_spec("examples/paper_cube.toml")
    paper = cube.changed(contact_grid=cube.contact_grid.changed(count=(10, 10)))
    assert grid_count(cube) == (14, 14)
    assert covered_share(cube) > 0.99
    assert covered_share(paper) == pytest.approx((30 / 42) ** 2, abs=0.01)
    everywhere, own = (contact_grid(spec).xy_mm for spec in (cube, paper))
    assert (abs(everywhere[:, None] - own).max(axis=2).min(axis=0) < 1e-9).all()


def test_where_slits_cut_the_edges_whole_tips_stay_on_the_face():
    slits = BOX.changed(shell=BOX.shell.changed(slits=BOX.shell.slits.changed(depth_mm=3.0)))
    reach = abs(press_lattice(slits).xy_mm[pressed_nodes(slits)[0]]).max(axis=0)
    assert (reach + 5.0 <= [30.0, 20.0]).all()


def _stays(frame, place, reach):
    """A disk on the tangent plane, its rim dropped onto the surface along the normal, by itself."""
    if not frame.covers(place):
        return False
    turn = np.linspace(0, 2 * np.pi, 24)
    tangent = frame.tangent(place)
    ring = np.column_stack([reach * np.cos(turn), reach * np.sin(turn), 0 * turn])
    rim = frame.project_along(tangent.to_object(ring + np.append(place, 0.0)), tangent.normal)
    return bool(np.all(frame.touched(rim[:, :2])))


@pytest.mark.parametrize("name", ["sphere", "capsule", "ellipsoid", "hollow_dome"])
def test_tips_stay_on_curved_faces_all_round(name):
    spec = body_spec(name, contact_grid={"count": "fill", "pitch_mm": 2.5})
    reach, nodes = touched_reach_mm(spec), press_lattice(spec).xy_mm
    for frame, pressed in zip(face_frames(spec), pressed_nodes(spec), strict=True):
        found = stays_on_patch(frame, nodes, reach)
        some = np.random.default_rng(frame.number).integers(len(nodes), size=12)
        plane = frame.to_plane(nodes[some])
        assert found[some].tolist() == [_stays(frame, node, reach) for node in plane]
        assert found[pressed].all()
    assert not contact_places(spec).all()


@pytest.mark.parametrize("spec", [BOX, body_spec("sphere", contact_grid={"count": "fill"})])
def test_each_location_is_pressed_with_its_eight_neighbours_and_nothing_else_is(spec):
    lattice, places = press_lattice(spec).xy_mm, contact_grid(spec).xy_mm
    for there, pressed in zip(contact_places(spec), pressed_nodes(spec), strict=True):
        steps = abs(lattice[:, None] - places[there]).max(axis=2)
        np.testing.assert_array_equal(pressed, (steps < 0.51 * spec.contact_grid.pitch_mm).any(1))


def test_given_counts_are_the_same_on_all_faces():
    spec = body_spec("cylinder")
    assert contact_places(spec).all()
    assert pressed_nodes(spec).all()
    assert grid_count(spec) == (2, 2)


def test_a_face_without_room_is_told_with_what_would_help():
    with pytest.raises(SpecError, match=r"room for 1 × 1 locations on face 1.*pitch_mm"):
        parse_spec({"name": "cube", "contact_grid": {"count": "fill", "pitch_mm": 25.0}}, "cube")


def test_a_pitch_that_would_take_hundreds_of_locations_is_refused():
    fine = BOX.changed(contact_grid=BOX.contact_grid.changed(pitch_mm=0.01))
    with pytest.raises(SpecError, match=r"a pitch of 0\.59 or more"):
        contact_places(fine)


@pytest.mark.parametrize("spec", [BOX, body_spec("sphere", contact_grid={"count": "fill"})])
def test_covered_shares_agree_with_points_strewn_over_the_surface(spec):
    """Points of equal density on the surface: those within half a pitch of a location, face by face."""
    rng, pitch = np.random.default_rng(4), spec.contact_grid.pitch_mm
    places, found, areas = contact_grid(spec).xy_mm, [], []
    for frame, there in zip(face_frames(spec), contact_places(spec), strict=True):
        half = np.array(frame.half_extents_mm)
        xy = rng.uniform(-half, half, (6000, 2))
        xy = xy[frame.covers(xy)]
        _, slope = frame.relief.evaluate(xy)
        weight = np.hypot(1, np.linalg.norm(slope, axis=1))
        cells = abs(frame.from_plane(xy)[:, None] - places[there]).max(axis=2) <= pitch / 2
        found.append(weight[cells.any(axis=1)].sum() / weight.sum())
        areas.append(weight.sum() * half.prod())
    np.testing.assert_allclose(covered_shares(spec), found, atol=0.03)
    if spec is BOX:
        assert covered_share(spec) == pytest.approx(np.average(found, weights=areas), abs=0.015)


def test_tips_land_up_to_the_ends_of_a_cylinder_and_up_to_its_patches_sides():
    spec = body_spec("cylinder", indenter={"radius_mm": 4.0})
    side = next(frame for frame in face_frames(spec) if not frame.flat)
    along = side.ends.index(True)
    half, turn = np.array(side.half_lengths_mm), np.eye(2)
    assert side.ends == tuple(np.arange(2) == along)
    for axis in (along, 1 - along):
        places = np.outer([0.0, half[axis] - 0.5, half[axis] + 0.5], turn[axis])
        assert tip_stays(spec, side, places).tolist() == [True, True, False]


def test_each_of_two_tips_lands_on_a_cylinder():
    """Along the axis the outer tip's lowest point stays on the side, however far the probe reaches."""
    tips = {"radius_mm": 4.0, "tip_count": 2}
    spec = body_spec("cylinder", indenter=tips)
    side = next(frame for frame in face_frames(spec) if not frame.flat)
    straight = side.ends.index(True)
    spec = spec.changed(indenter=spec.indenter.changed(turn_deg=(90.0 * straight, 0.0, 0.0)))
    half, way = side.half_lengths_mm[straight], np.eye(2)[straight]
    places = np.outer([0.0, half - 8.0, half - 7.0], way)
    assert tip_stays(spec, side, places).tolist() == [True, True, False]


def test_what_several_patches_share_counts_once():
    """Random points of a ball: those within half a pitch of a location of any patch that has them."""
    ball = body_spec("sphere", contact_grid={"count": "fill"})
    radius, pitch = ball.body.size_mm[0] / 2, ball.contact_grid.pitch_mm
    points = np.random.default_rng(5).normal(size=(8000, 3))
    points *= radius / np.linalg.norm(points, axis=1)[:, None]
    on_any, covered = np.zeros((2, len(points)), bool)
    for frame, there in zip(face_frames(ball), contact_places(ball), strict=True):
        steep = points @ frame.normal / radius
        on = steep >= 0.5
        place = frame.from_plane((points[on] - frame.centre_mm) @ frame.axes[:, :2])
        near = abs(place[:, None] - contact_grid(ball).xy_mm[there]).max(axis=2) <= pitch / 2
        on_any |= on
        covered[on] |= near.any(axis=1)
    assert covered_share(ball) == pytest.approx(covered.sum() / on_any.sum(), abs=0.02)
    few = body_spec("sphere", contact_grid={"count": [9, 9]})
    assert covered_share(few) > 1.2 * np.mean(covered_shares(few))


@pytest.mark.parametrize("name", ["ball", "capsule", "egg", "pear", "handle", "hollow_dome"])
def test_what_ships_is_judged_on_eight_tenths_of_its_patches_at_least(name):
    assert covered_share(load_spec(f"examples/{name}.toml")) > 0.8


def test_a_tip_may_touch_the_surface_round_a_patch_but_not_the_bore():
    """At 60° a tip touches up to 75°, where the bore of a ball begins 15° from its lowest point."""
    narrow, wide = (body_spec("sphere", body={"bore_mm": bore}) for bore in (8.0, 20.0))
    for spec, touched in ((narrow, True), (wide, False)):
        side = face_frames(spec)[2]
        radius, lean = spec.body.size_mm[0] / 2, np.deg2rad(74)
        down = side.axes[:, :2].T @ [0.0, 0.0, -1.0] * radius * np.sin(lean)
        assert side.touched(down) == touched
        assert not side.covers(down)
        assert side.touched(-down)


def test_a_tip_stays_within_the_circle_of_a_flat_round_face():
    """Its radius is 20 mm less 0.1 mm; one tip lands by its lowest point, two 7.5 mm next to it."""
    spec, reach = body_spec("cylinder", indenter={"radius_mm": 5.0}), 0.0
    end = next(frame for frame in face_frames(spec) if frame.number == 1)
    turn = np.linspace(0, 2 * np.pi, 12)
    way = np.column_stack([np.cos(turn), np.sin(turn)])
    for away, stays in ((0.0, True), (19.9 - reach - 0.05, True), (19.9 - reach + 0.05, False)):
        found = tip_stays(spec, end, away * way)
        assert found.all() if stays else not found.any()
    two = spec.changed(indenter=spec.indenter.changed(tip_count=2))
    assert tip_stays(two, end, np.array([[12.3, 0.0], [12.5, 0.0]])).tolist() == [True, False]


def test_a_node_is_all_around_free_with_its_eight_neighbours():
    free = np.ones((1, 5, 4), bool)
    free[0, 4, 3] = False
    wanted = np.zeros((5, 4), bool)
    wanted[1:4, 1:3] = True
    wanted[3, 2] = False
    np.testing.assert_array_equal(all_around(free)[0], wanted)


@pytest.mark.parametrize(
    ("odd", "count"), [((True, True), (5, 3)), ((False, True), (4, 3)), ((False, False), (4, 4))]
)
def test_every_second_node_is_a_location_as_far_out_as_any_face_uses(odd, count):
    """Of 11 × 9 nodes; one face uses places up to 4 nodes from the middle along x and 3 along y, the
    other fewer and not all of its row."""
    free = np.zeros((2, 11, 9), bool)
    free[0, 1:10, 1:8] = True
    free[1, 4:7, 3:6] = True
    free[1, 5, 4] = False
    found = nodes_of_parity(free, odd)
    assert found.count == count == found.places.shape[1:]
    x = np.arange(11) - 5
    y = np.arange(9) - 4
    rows = [k for k in range(11) if (x[k] % 2 == 0) == odd[0] and abs(x[k]) < count[0]]
    columns = [k for k in range(9) if (y[k] % 2 == 0) == odd[1] and abs(y[k]) < count[1]]
    np.testing.assert_array_equal(found.places, free[np.ix_([0, 1], rows, columns)])


def test_a_lattice_without_room_keeps_two_locations_or_three():
    nowhere = np.zeros((1, 11, 9), bool)
    assert nodes_of_parity(nowhere, (False, False)).count == (2, 2)
    assert nodes_of_parity(nowhere, (True, False)).count == (3, 2)
    assert not nodes_of_parity(nowhere, (True, True)).places.any()


@pytest.mark.parametrize(
    ("widest_mm", "least_mm", "most_mm"),
    [(2.0, 1.98, 2.0), (0.7, 0.68, 0.7), (2.9, 2.88, 2.9), (0.01, None, None)],
)
def test_the_largest_pitch_that_works_is_found_to_two_hundredths(
    monkeypatch, widest_mm, least_mm, most_mm
):
    """Of a body that has 2 × 2 locations up to a pitch, and 1 × 2 beyond it."""

    def filled(spec, pitch):
        places = np.zeros((2, 3, 3), bool)
        places[:, : 2 if pitch <= widest_mm else 1, :2] = True
        return SimpleNamespace(places=places)

    monkeypatch.setattr(contact_places_module, "filled_places", filled)
    found = contact_places_module.nearest_pitch_mm(BOX)
    if least_mm is None:
        assert found is None
    else:
        assert least_mm <= found <= most_mm
