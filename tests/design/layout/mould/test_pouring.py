"""Pouring holes of split moulds keep clear of pins."""

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.layout.mould import pouring
from design.layout.mould.closure import flange_span_mm
from design.layout.mould.frame import flange_width_mm, mould_frame, up
from design.layout.mould.pins import loose_pins
from design.layout.mould.pouring import (
    Hole,
    hole_thins_the_seam,
    is_clear,
    pour_holes,
    thin_beside_others,
)
from design.spec_io import parse_spec
from tests.support.objects.body_cases import body_spec
from tests.support.objects.worked_objects import worked

LOW_MAGNETS = {
    "name": "t",
    "body": {"kind": "ellipsoid", "size_mm": [61.6, 45.2, 54.5], "open_faces": []},
    "magnets": {"diameter_mm": 6.0, "positions_mm": [[-15.06, 0.0], [0.0, 0.0], [15.06, 0.0]]},
    "contact_grid": {"count": "fill", "pitch_mm": 3.0},
    "indenter": {"radius_mm": 5.0},
    "core": {
        "recess_inner_radius_mm": 0.25,
        "recess_outer_radius_mm": 6.75,
        "wire_hole_top_diameter_mm": 2.0,
        "wire_hole_side_diameter_mm": 1.8,
        "wall_mm": 4.32,
    },
    "sensors": {"count_per_face": 1, "radius_mm": 3.5, "positions_mm": [[0.0, 0.0]]},
}


def test_a_pouring_hole_goes_down_from_the_upper_corner_until_no_pin_is_in_its_way():
    """The pin of a magnet low on a side stood in it."""
    spec = parse_spec(LOW_MAGNETS, "t")
    cylinder = trimesh.creation.cylinder
    pins = [
        solid
        for pin in loose_pins(spec)
        for solid in (
            cylinder(pin.radius_mm, segment=pin.axis_mm),
            cylinder(pin.radius_mm + pin.rim_mm, segment=pin.head_axis_mm),
        )
    ]
    (hole,) = pour_holes(spec)
    assert not any(len(hole.surface().intersection(pin).faces) for pin in pins)


def test_pouring_holes_of_a_bored_body_move_along_its_holder_together(monkeypatch):
    """Turned about the rod they came under the holder's flange (0.7 mm³ of a ball of 32 mm)."""
    spec = body_spec("ellipsoid", body={"open_faces": [6], "bore_mm": 9.0})
    usual = pour_holes(spec)
    frame, aside = mould_frame(spec), abs(usual[0].top_mm[0])
    monkeypatch.setattr(
        pouring, "is_clear", lambda hole, pins: abs(hole.top_mm @ frame.length_axis) > 0.7 * aside
    )
    one, other = pour_holes(spec)
    assert_allclose(one.top_mm[:2], -other.top_mm[:2], atol=1e-9)
    assert_allclose(abs(one.top_mm @ frame.across), aside)
    assert_allclose(abs(one.top_mm @ frame.length_axis), 0.75 * aside)
    right = flange_span_mm(spec)[1]
    assert_allclose(abs(one.top_mm @ frame.across) - one.diameter_mm / 2, right)


def test_pouring_holes_move_along_the_holder_where_walls_to_the_seam_are_thin(monkeypatch):
    spec = body_spec("sphere", body={"open_faces": [6]})
    frame, (usual, _) = mould_frame(spec), pour_holes(spec)
    aside = abs(usual.top_mm @ frame.across)

    def thin_near_the_middle(spec, hole):
        return abs(hole.top_mm @ frame.length_axis) < 0.7 * aside

    monkeypatch.setattr(pouring, "hole_thins_the_seam", thin_near_the_middle)
    for hole in pour_holes(spec):
        assert_allclose(abs(hole.top_mm @ frame.length_axis), 0.75 * aside)
    monkeypatch.setattr(pouring, "hole_thins_the_seam", lambda spec, hole: True)
    assert_allclose(pour_holes(spec)[0].top_mm, usual.top_mm)


@pytest.mark.parametrize("at_head", [False, True])
def test_a_hole_passes_pins_and_their_heads_at_their_radius_and_its_own(at_head):
    """Holes of Ø3 that come to a pin's floor or its head's top from aside, or go across it."""
    (pin, *_) = loose_pins(worked("closed capsule"))
    place = (pin.head_axis_mm if at_head else pin.axis_mm)[int(at_head)]
    side = np.cross(pin.way, [0.0, 0.0, 1.0])
    side /= np.linalg.norm(side)
    radius = pin.radius_mm + (pin.rim_mm if at_head else 0.0)
    for away, clear in ((radius + 1.49, False), (radius + 1.51, True), (-5.0, False)):
        hole = Hole("pour", place + away * side, place + 9 * side, place + 20 * side, 3.0)
        assert is_clear(hole, (pin,)) is clear
    assert is_clear(hole, ())


@pytest.mark.parametrize(
    ("away_mm", "thin"),
    [(7.2, False), (8.05, True), (8.15, True), (8.85, True), (8.95, False)],
)
def test_a_hole_beside_that_of_the_rod_leaves_a_wall_or_a_clear_opening(away_mm, thin):
    """A hole of R 3 mm and one of R 5 mm and 0.1 mm of play that meet under 15° at 8.04 mm, part at 8.1 mm,
    and have 0.8 mm between them at 8.9 mm: moved by a quarter of its way a lump's left 0.15 mm."""
    spec = body_spec("sphere", body={"open_faces": [6], "bore_mm": 10.0})
    top, way = np.array([0.6, 0.8, 0.0]) * away_mm - [0.0, 0.0, 20.0], up(spec)
    hole = Hole("pour", top - 6 * way, top, top + 100 * way, 6.0)
    assert thin_beside_others(spec, hole, ()) is thin


def test_a_hole_beside_that_of_a_pin_s_head_leaves_a_wall():
    spec = worked("closed capsule")
    (pin, *_), side = loose_pins(spec), np.array([0.0, 0.0, 1.0])
    side = np.cross(pin.way, side) / np.linalg.norm(np.cross(pin.way, side))
    head = pin.radius_mm + pin.rim_mm + spec.printer.clearance_mm
    for gap, thin in ((0.85, False), (0.75, True), (0.02, True), (-0.8, False)):
        top = pin.head_axis_mm[0] + (head + 0.5 + gap) * side
        hole = Hole("vent", top - pin.way, top, top + 50 * pin.way, 1.0)
        assert thin_beside_others(spec, hole, (pin,)) is thin


@pytest.mark.parametrize(
    ("aside_mm", "beside_mm", "thin"),
    [
        (2.6, 2.0, False),
        (2.8, 2.0, True),
        (-3.4, 2.0, True),
        (3.6, 2.0, False),
        (3.4, -0.6, False),
        (3.4, -0.4, True),
        (3.4, 8.4, True),
        (3.4, 8.6, False),
    ],
)
def test_a_hole_through_a_flange_leaves_a_wall_to_its_sides(aside_mm, beside_mm, thin):
    """A hole of Ø1 mm beside the block, through a flange 8 mm wide that reaches 4 mm to both sides of a seam
    across x: a pouring hole of random design 7052 left 0.14 mm."""
    spec = body_spec("sphere", body={"open_faces": [6]}, mould={"parting_azimuth_deg": 0.0})
    assert flange_width_mm(spec) == 8.0
    way, frame = up(spec), mould_frame(spec)
    top = np.array([aside_mm, float(frame.high_mm[1]) + beside_mm, 0.0])
    hole = Hole("vent", top - way, top, top + 100 * way, 1.0)
    assert hole_thins_the_seam(spec, hole) is thin


def test_silicone_lies_under_all_of_a_pouring_hole_s_rim_by_hand():
    """Beside the rod of a ball of R 22 mm a hole's rim ends where the ball does, at 22 mm: it was judged by
    its middle, so that one that reached 4 mm past the ball passed."""
    rod, usual = 4.0, body_spec("sphere", body={"open_faces": [6]})
    for width, finds_room in ((17.8, True), (18.4, False), (25.0, False)):
        ball = usual.changed(mould=usual.mould.changed(pour_mm=width))
        assert (rod + width < 22) is finds_room
        places = [*pouring.pour_places(ball, True)]
        assert bool(places) is finds_room, width
        for top in places[0] if places else ():
            assert np.hypot(*top[:2]) + width / 2 <= 22
