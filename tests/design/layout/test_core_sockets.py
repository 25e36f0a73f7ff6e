"""Sockets for the pins that hold a core whose wire holes lie under magnets."""

from types import SimpleNamespace

import cadquery as cq
import numpy as np
import pytest

from design.errors import InputError
from design.layout import core_sockets
from design.layout.boards import passage_radius_mm, sensor_recesses
from design.layout.body import body_of, face_frames
from design.layout.core_hold import locators, why_no_mould
from design.layout.core_sockets import (
    CLEAR_MM,
    OUT_MM,
    Ways,
    core_depth_mm,
    flat_frame,
    off_pour,
    places_on,
    room_mm,
    segment_distance_mm,
    ways_to_wires,
    wire_targets,
)
from design.layout.mould.frame import up
from design.layout.mould.pins import loose_pins
from design.layout.places.positions import magnet_layout
from design.layout.pockets import axis_in_object_mm, shell_pockets
from design.mould.pins import make_pin
from design.solids.booleans import common, volume_mm3
from design.solids.core import make_core
from design.solids.sampled import sampled_core_part
from design.spec_io import load_spec, parse_spec
from tests.support.objects.body_cases import BESIDE_AN_EDGE, body_spec
from tests.support.pages import ROOT

BLOCKED = {"magnets": {"positions_mm": [[3.0, 0.0]]}}
CLOSED = {"body": {"open_faces": []}}


def closed(name):
    if name == "pear":
        return load_spec(ROOT / "examples/pear.toml", ["body.open_faces=[]"])
    return body_spec(name, **({} if name == "ellipsoid" else CLOSED | BLOCKED))


NAMES = ("sphere", "capsule", "cylinder", "ellipsoid", "pear")


@pytest.mark.parametrize("name", NAMES)
def test_two_pins_well_aside_hold_the_core_clear_of_all_else(name):
    spec = closed(name)
    assert why_no_mould(spec) is None
    one, other = held = locators(spec)
    assert abs(one.frame.normal @ other.frame.normal) < 0.6
    for locator in held:
        if locator.socket is None:
            continue
        face, x, y = locator.place
        frame = {f.number: f for f in face_frames(spec)}.get(face) or body_of(spec).frame(face)
        np.testing.assert_allclose(
            frame.to_object(np.array([x, y, 0.0])), locator.frame.centre_mm, atol=1e-9
        )
        axis = locator.frame.centre_mm - np.linspace(0, 1, 60)[:, None] * (
            locator.frame.centre_mm - locator.socket.end_mm
        )
        core = body_of(spec).core_distance_mm(axis)
        in_core = np.linalg.norm(axis - locator.frame.centre_mm, axis=1) > locator.depth_mm
        assert ((core < 0.05) == in_core).mean() > 0.97
        layout = magnet_layout(spec)
        least = locator.radius_mm + spec.shell.pocket_diameter_mm / 2 + CLEAR_MM
        for centre, along in zip(layout.centre_mm, layout.axis, strict=True):
            above = (axis[~in_core] - centre) @ along * np.sign(centre @ along) > -0.5
            away = np.linalg.norm(np.cross(axis[~in_core] - centre, along), axis=1)
            assert (away[above] > least - 1e-6).all()
        for recess in sensor_recesses(spec):
            beside = (abs((axis[in_core] - recess.centre_mm) @ recess.axes) - recess.half_mm).clip(
                0
            )
            room = np.linalg.norm(beside, axis=1).min() - locator.radius_mm
            assert room > spec.printer.wall_mm


@pytest.mark.parametrize("name", ["cylinder", "ellipsoid"])
def test_the_core_has_the_holes_and_pins_fit_them(name):
    spec = closed(name)
    sampled = body_of(spec).sampled
    core = sampled_core_part(spec) if sampled else make_core(spec)
    for pin in loose_pins(spec):
        locator = pin.locator
        if locator is None or locator.socket is None:
            continue
        middle = locator.frame.centre_mm - (locator.depth_mm + 3.0) * locator.frame.normal
        inside = core.contains([middle])[0] if sampled else core.isInside(cq.Vector(*middle))
        assert not inside
        assert volume_mm3(common(core, make_pin(spec, pin))) < 0.02 if sampled else 1e-6


def test_bodies_that_are_open_have_no_sockets():
    assert locators(body_spec("sphere")) == ()


def feet():
    """For each pin how much deeper the core's surface is on one side of its foot than on the other."""
    spec = parse_spec(BESIDE_AN_EDGE, "a box")
    turn = np.linspace(0, 2 * np.pi, 60)[:, None]
    for pin in locators(spec):
        frame, radius = pin.frame, pin.radius_mm
        rim = frame.centre_mm + radius * (np.cos(turn) * frame.x + np.sin(turn) * frame.y)
        depths = pin.depth_mm + np.linspace(-4, 4, 1601)
        points = rim - depths[:, None, None] * frame.normal
        inside = body_of(spec).core_distance_mm(points.reshape(-1, 3)).reshape(1601, 60) < 0
        yield np.ptp(depths[inside.argmax(axis=0)]), 2 * radius * pin.rise_mm


def test_a_pin_stands_on_one_face_of_the_core_with_all_of_its_foot():
    for found_mm, wanted_mm in feet():
        assert found_mm == pytest.approx(wanted_mm, abs=0.01)


def way_down(x, y, z=21.0, lean=0.0):
    """Ways straight down from (x, y, z) towards the middle plane."""
    start = np.array([[x, y, z]])
    one = np.array([0])
    up_ = np.array([[0.0, 0.0, 1.0]])
    return Ways(one + 1, start[:, :2], start, up_, start * [1, 1, 0], one + lean)


def test_ways_are_square_to_the_surface_and_end_where_wire_holes_run():
    spec = closed("sphere")
    ways = ways_to_wires(spec)
    targets, axes = wire_targets(spec)
    core = spec.body.size_mm[0] / 2 - spec.shell.thickness_mm
    faces = len(spec.body.sensed)
    assert len(targets) == 1 + 4 * faces
    np.testing.assert_allclose(targets[0], 0)
    np.testing.assert_allclose(
        np.linalg.norm(targets[1:].reshape(faces, 4, 3), axis=2),
        core * np.array([[0.25, 0.4, 0.55, 0.7]] * faces),
    )
    np.testing.assert_allclose(np.linalg.norm(axes[0], axis=1), 1)
    np.testing.assert_allclose(axes[3, 0], targets[3] / np.linalg.norm(targets[3]), atol=1e-12)
    assert not axes[3, 1:].any()
    on_surface = np.linalg.norm(ways.start_mm, axis=1)
    np.testing.assert_allclose(on_surface, spec.body.size_mm[0] / 2, rtol=1e-6)
    np.testing.assert_allclose(np.linalg.norm(ways.way, axis=1), 1)
    straight = (ways.start_mm - ways.end_mm) / np.linalg.norm(
        ways.start_mm - ways.end_mm, axis=1, keepdims=True
    )
    np.testing.assert_allclose(ways.way, straight, atol=1e-12)
    normal = ways.start_mm / on_surface[:, None]
    np.testing.assert_allclose(np.cos(ways.lean), np.sum(normal * ways.way, axis=1), atol=1e-9)
    assert ways.lean.max() < np.deg2rad(20)
    for frame in face_frames(spec):
        to_hole = ways.way @ frame.normal
        meets = np.linalg.norm(ways.end_mm, axis=1) < 1e-9
        assert (to_hole[meets] <= np.cos(np.deg2rad(38)) + 1e-9).all()
    on_core = ways.start_mm - core_depth_mm(spec, ways)[:, None] * ways.way
    np.testing.assert_allclose(np.linalg.norm(on_core, axis=1), core, rtol=1e-6)


def test_places_fill_the_face_from_its_middle():
    frame = face_frames(closed("cylinder"))[0]
    places = places_on(frame)
    np.testing.assert_allclose(places[0], 0, atol=1e-12)
    away = np.linalg.norm(places, axis=1)
    assert (np.diff(away) >= 0).all()
    assert frame.covers(places).all()
    reach = abs(places).max(axis=0) / frame.half_extents_mm
    assert (reach > 0.9).all()
    assert (reach <= 0.95 + 1e-9).all()


def test_room_beside_a_pin_is_what_is_left_to_the_next_pocket():
    """Closed cylinder, one magnet 3 mm off the middle of its top: a pin of Ø4 straight down beside it.

    The seam along x = −y costs up to 0.3 mm and a little more within the pin, lean half of its radians.
    """
    spec = closed("cylinder")
    pocket, frame = shell_pockets(spec)[0][0], face_frames(spec)[0]
    centre = frame.to_object(np.append(pocket.body.centre_mm[:2], 0.0))
    depth = np.array([spec.shell.thickness_mm])
    for degrees, away in ((300, 6.0), (300, 7.0), (300, 9.0), (60, 8.0), (60, 12.0)):
        along = np.array([np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))])
        x, y = centre[:2] + away * along
        room = min(away - pocket.outline.radius_mm - 2.0 - CLEAR_MM, 2.5)
        seam = max(1 - (abs(x + y) / np.sqrt(2) - 2.0) / 8.0, 0)
        for lean in (0.0, 0.1):
            found = room_mm(spec, way_down(x, y, centre[2], lean), depth, 2.0)[0]
            assert found == pytest.approx(room - 0.3 * seam - 0.5 * lean, abs=1e-6)


def test_room_beside_a_pin_is_left_as_far_as_it_reaches_out_of_the_mould():
    """Above its end the next pin's foot may come nearer: 6 mm aside and 3, 4 mm above it."""
    spec = closed("cylinder")
    pocket, frame = shell_pockets(spec)[0][0], face_frames(spec)[0]
    x, y, z = frame.to_object(np.append(pocket.body.centre_mm[:2], 0.0)) + np.array(
        [3.0, -3 * 3**0.5, 0]
    )
    end = axis_in_object_mm(frame, pocket)[1, 2] + spec.mould.wall_mm + OUT_MM
    assert end > z + spec.mould.wall_mm
    depth = np.array([spec.shell.thickness_mm])
    seam = max(1 - (abs(x + y) / np.sqrt(2) - 2.0) / 8.0, 0)
    for above in (-3.0, 0.0, 3.0, 4.0):
        away = np.hypot(6.0, max(above, 0.0))
        room = min(away - pocket.outline.radius_mm - 2.0 - CLEAR_MM, 2.5)
        found = room_mm(spec, way_down(x, y, end + above + depth[0]), depth, 2.0)[0]
        assert found == pytest.approx(room - 0.3 * seam, abs=1e-6)


def test_a_pin_over_a_recess_or_a_wire_hole_has_no_room():
    """Places all over the top of a closed cylinder, against distances of their own from every recess."""
    spec = closed("cylinder")
    top, least = spec.body.size_mm[2] / 2, 2.0 + 1.25 * spec.printer.wall_mm
    xy = np.array([(x, y) for x in np.arange(-12, 12.1, 0.8) for y in np.arange(-12, 12.1, 0.8)])
    start = np.column_stack([xy, np.full(len(xy), top)])
    up_, none = np.tile([0.0, 0, 1], (len(xy), 1)), np.zeros(len(xy))
    ways = Ways(none.astype(int) + 1, xy, start, up_, start * [1, 1, 0], none)
    depth = np.full(len(xy), spec.shell.thickness_mm)
    room = room_mm(spec, ways, depth, 2.0)
    on_core = start - [0, 0, spec.shell.thickness_mm]
    free = np.hypot(*xy.T) > least + passage_radius_mm(spec)
    for recess in sensor_recesses(spec):
        below = on_core[:, None] - [0, 0, 1] * np.linspace(0, 17, 35)[:, None]
        beside = (abs((below - recess.centre_mm) @ recess.axes) - recess.half_mm).clip(0)
        free &= np.linalg.norm(beside, axis=2).min(axis=1) > least
    free &= off_pour(spec, ways, 2.0)
    assert 0.1 < free.mean() < 0.7
    assert (np.isfinite(room) == free).mean() > 0.99


def test_points_of_ways_are_so_far_from_a_straight_piece():
    points = np.array([[[0.0, 0, 0], [5, 3, 0]], [[-4, 3, 0], [14, 0, 3]]])
    ends = np.array([[0.0, 0, 0], [10, 0, 0]])
    np.testing.assert_allclose(segment_distance_mm(points, ends), [0, 5])
    np.testing.assert_allclose(segment_distance_mm(points[:, 1:], ends), [3, 5])
    ways = way_down(1.0, 2.0)
    np.testing.assert_allclose(
        ways.points_at(np.array([[-3.0, 0.5]])), [[[1, 2, 18], [1, 2, 21.5]]], atol=1e-12
    )
    assert ways.select(np.array([False])).start_mm.shape == (0, 3)


def test_pins_keep_off_the_corner_that_silicone_is_poured_in_by():
    spec = closed("cylinder")
    way = up(spec)
    side = np.cross(way, [1.0, 0.0, 0.0] if abs(way[0]) < 0.9 else [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side)
    needed = 2.0 + spec.mould.pour_mm / 2 + 2 * spec.mould.wall_mm
    shifts = [0.0, needed - 0.01, needed + 0.01, 0.0, 0.0]
    heights = [20.0, 20.0, 20.0, 9.9, 10.1]
    start = np.array([h * way + s * side for h, s in zip(heights, shifts, strict=True)])
    zero = np.zeros(5)
    ways = Ways(zero.astype(int), start[:, :2], start, start, start, zero)
    assert off_pour(spec, ways, 2.0).tolist() == [False, False, True, True, False]


def test_a_flat_frame_is_right_handed_about_its_way():
    for way in np.random.default_rng(0).normal(size=(5, 3)):
        unit = way / np.linalg.norm(way)
        frame = flat_frame(3, np.array([1.0, 2.0, 3.0]), unit)
        np.testing.assert_allclose(frame.axes.T @ frame.axes, np.eye(3), atol=1e-12)
        assert np.linalg.det(frame.axes) == pytest.approx(1)
        np.testing.assert_allclose(frame.axes[:, 2], unit, atol=1e-12)
        np.testing.assert_allclose(frame.to_object(np.zeros(3)), [1, 2, 3])


def test_a_body_none_of_whose_faces_has_a_patch_has_no_ways(monkeypatch):
    def frame(number):
        raise InputError("no patch")

    body = SimpleNamespace(faces=(1, 2), frame=frame)
    monkeypatch.setattr(core_sockets, "body_of", lambda spec: body)
    monkeypatch.setattr(
        core_sockets, "wire_targets", lambda spec: (np.zeros((1, 3)), np.eye(3)[None])
    )
    ways = core_sockets.ways_to_wires(body_spec("closed_box"))
    assert {name: getattr(ways, name).shape for name in ("face", "xy_mm", "start_mm", "lean")} == {
        "face": (0,), "xy_mm": (0, 2), "start_mm": (0, 3), "lean": (0,),
    }  # fmt: skip
