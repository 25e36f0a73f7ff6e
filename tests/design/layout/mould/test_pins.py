"""Loose pins as numbers: which pockets they form, and how far they reach out of the block."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.mould import pins
from design.layout.mould.frame import mould_frame, parting
from design.layout.mould.pins import PIN_HEAD_MM, loose_pins, pins_by_kind
from design.layout.pockets import Body, Outline, Pocket, shell_pockets, tilted_frame
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec

PLACES = [(2.0, -1.5), (-9.0, 4.0)]


def closed(**parts):
    content = {
        "name": "closed",
        "body": {"size_mm": [50.0, 46.0, 44.0], "open_faces": []},
        "magnets": {"positions_mm": PLACES},
    }
    return ObjectSpec.model_validate(content | parts)


def test_every_pocket_that_leaves_the_pull_has_a_pin_of_its_kind():
    spec = closed(magnets={"positions_mm": [(9.0, -8.0), (-9.0, 4.0)]})
    kinds = pins_by_kind(spec)
    plain = [kind for kind in kinds if not kind.holds_core]
    held = [kind for kind in kinds if kind.holds_core]
    assert [kind.name for kind in plain] == ["mould_pin"]
    assert [kind.name for kind in held] == ["mould_locator_1", "mould_locator_2"]
    formed = {place for kind in plain for place in kind.places}
    assert formed == {(face, x, y) for face in range(1, 7) for x, y in ((9.0, -8.0), (-9.0, 4.0))}
    assert [(kind.count, len(kind.places)) for kind in kinds] == [(12, 12), (1, 1), (1, 1)]
    for kind in held:
        (((_, x, y),),) = (kind.places,)
        assert (x, y) == (0, 0)


def test_a_pin_that_meets_a_pocket_forms_it_too():
    kinds = pins_by_kind(closed())
    held = [place for kind in kinds if kind.holds_core for place in kind.places]
    assert {place[1:] for place in held} == {(2.0, -1.5)}
    plain = [place for kind in kinds if not kind.holds_core for place in kind.places]
    assert len(plain) + len(held) == 12
    assert not set(plain) & set(held)


@pytest.mark.parametrize("name", ["sphere", "closed_box"])
def test_heads_rest_a_wall_above_the_surface_and_reach_out_of_the_block_in_whole_steps(name):
    spec = body_spec(name, body={"open_faces": []})
    frame = mould_frame(spec)
    low, high = frame.corners(frame.low_mm, frame.high_mm)
    pockets = sum(len(face) for face in shell_pockets(spec))
    plain = [pin for pin in loose_pins(spec) if pin.locator is None]
    assert 0 < len(plain) <= pockets
    for pin in plain:
        assert pin.seat_mm == spec.mould.wall_mm
        sunk = pin.top_mm - pin.seat_mm - PIN_HEAD_MM
        assert sunk == pytest.approx(round(sunk))
        assert sunk >= 0
        floor, top = pin.axis_mm
        assert_allclose(top - floor, np.linalg.norm(top - floor) * pin.way, atol=1e-9)
        assert_allclose(pin.head_axis_mm[1], top)
        edge = np.vstack(
            [top + pin.radius_mm * way for way in np.eye(3) - np.outer(pin.way, pin.way)]
        )
        outside = ((edge > high - 1e-6) | (edge < low + 1e-6)).any(axis=1)
        assert outside.all(), "the head's end is out of the block all round"
        before = pin.top_mm - 1.0 - PIN_HEAD_MM
        assert bool(sunk) == (name == "sphere")
        if sunk:
            start = top - (pin.top_mm - before) * pin.way
            assert ((start < high) & (start > low)).all(), "a step less would stay inside"
    assert abs(parting(spec).normal @ plain[0].way) < 1


def test_rims_end_below_a_plug_s_clips_where_heads_stand_under_its_flange(monkeypatch):
    """Of a flange from −10 to 10 mm across, on walls 20 mm along, with clips down to the rim at 30."""
    frame = SimpleNamespace(
        plugged=True, axes=np.eye(3), high_mm=np.array([25.0, 20.0, 30.0]), rim_mm=30.0
    )
    monkeypatch.setattr(pins, "mould_frame", lambda spec: frame)
    monkeypatch.setattr(pins, "flange_span_mm", lambda spec: (-10.0, 10.0))
    spec = closed()

    def rim(across, along, out, lean=0.0, radius=3.0):
        """Of a head 2 mm long that rises by `lean` along its axis."""
        end = np.array([across, along, out])
        start = end - np.array([0.0, np.sign(along) * 2.0, lean * 2.0])
        pin = SimpleNamespace(head_axis_mm=np.stack([start, end]), radius_mm=radius)
        return pins.rim_below_clips_mm.__wrapped__(spec, [pin])

    clear = 1.5 + 0.1 + 3.0
    assert rim(0.0, 21.0, 30 - clear + 0.4) == pytest.approx(1.1)
    assert rim(0.0, -21.0, 30 - clear + 0.4) == pytest.approx(1.1)
    assert rim(0.0, 21.0, 29.0) == 0.0
    leaning = np.sqrt(2) * (30 - 0.1 - 27.0) - 3.0
    assert rim(0.0, 21.0, 27.0, lean=1.0) == pytest.approx(leaning), "at 45° it reaches less high"
    assert rim(0.0, 21.0, 26.0, lean=-1.0) == pytest.approx(leaning), (
        "highest 1 mm back, at the wall"
    )
    assert rim(0.0, 22.5, 25.0, lean=-1.0) == pytest.approx(leaning), "or at its seat"
    for free in (
        (0.0, 19.9, 29.0),
        (10 + clear + 0.1, 21.0, 29.0),
        (-10 - clear - 0.1, 21.0, 29.0),
    ):
        assert rim(*free) == 1.5
    for under in ((10 + clear - 0.1, 21.0, 29.0), (-10 - clear + 0.1, 21.0, 29.0)):
        assert rim(*under) == 0.0
    frame.plugged = False
    assert rim(0.0, 21.0, 29.0) == 1.5


@pytest.mark.parametrize(
    ("gap", "rim"), [(9.0, 1.5), (3.6, 1.3), (1.82, 0.41), (1.7, 0.8), (0.5, 0.2), (-1.0, 0.0)]
)
def test_rims_leave_a_wall_between_heads_or_run_together(monkeypatch, gap, rim):
    """A wall of 0.8 mm and 0.1 mm of play on both sides, while rims keep 0.4 mm."""
    made = [
        SimpleNamespace(head_axis_mm=np.array([[x, 0.0, 0], [x, 0, 2]]), radius_mm=3.0)
        for x in (0.0, 6.0 + gap)
    ]
    assert pins.common_rim_mm.__wrapped__(closed(), made) == pytest.approx(rim)
    assert pins.common_rim_mm.__wrapped__(closed(), made[:1]) == 1.5


@pytest.mark.parametrize("lean", [(0.3, 0.1), (-0.3, 0.2), (0.1, 0.25), (-0.2, -0.4)], ids=str)
def test_a_head_ends_out_of_the_block_where_its_rim_is_deepest_in_it(monkeypatch, lean):
    """A block that ends at a plane which leans over the face; heads in steps of a micrometre."""
    monkeypatch.setattr(pins, "HEAD_STEP_MM", 1e-3)
    spec = closed()
    frame, pocket = face_frames(spec)[2], shell_pockets(spec)[2][1]
    slopes = frame.axes @ [*lean, -1.0]

    def leaves(spec, start_mm, way):
        assert_allclose(way, frame.normal)
        return 7.0 + float((start_mm - frame.centre_mm) @ slopes)

    monkeypatch.setattr(pins, "exit_mm", leaves)
    pin = pins.pin_of(spec, frame, pocket, 0.5)
    radius = pocket.outline.radius_mm + 1.5
    highest = 7.0 + np.array(PLACES[1]) @ lean + radius * np.max(np.abs(lean))
    assert pin.seat_mm == pytest.approx(spec.mould.wall_mm + 0.5 * radius)
    assert pin.top_mm - PIN_HEAD_MM == pytest.approx(max(highest, pin.seat_mm), abs=2e-3)
    assert highest > spec.mould.wall_mm


def test_a_locating_pin_forms_the_outer_half_of_its_hole():
    spec = closed(magnets={"positions_mm": [(9.0, -8.0), (-9.0, 4.0)]})
    held = [pin for pin in loose_pins(spec) if pin.locator is not None]
    assert len(held) == 2
    for pin in held:
        hole = pin.locator
        floor = hole.frame.centre_mm - hole.depth_mm / 2 * hole.frame.normal
        assert_allclose(pin.axis_mm[0], floor, atol=1e-9)
        assert pin.pocket.lowest_mm == pytest.approx(-hole.depth_mm / 2)
        assert_allclose(pin.pocket.outline.half_mm, hole.radius_mm)


def test_pins_are_alike_where_their_shapes_are_but_locating_pins_are_not():
    """Whatever their number among the pins is; the third's head is longer, the fifth's pocket leans."""
    spec = closed()
    pin = next(pin for pin in loose_pins(spec) if pin.locator is None)
    locating = replace(pin, locator=loose_pins(spec)[-1].locator)
    body = replace(pin.pocket.body, frame=tilted_frame(0.0, 1.0))
    leaning = replace(pin, pocket=replace(pin.pocket, body=body))
    longer = replace(pin, top_mm=pin.top_mm + 1)
    made = [pin, locating, longer, pin, leaning, locating]
    assert pins.pins_of_kinds(made) == [
        ("mould_pin_1", [0, 3]),
        ("mould_pin_2", [2]),
        ("mould_pin_3", [4]),
        ("mould_locator_1", [1]),
        ("mould_locator_2", [5]),
    ]


def test_the_circle_round_a_pin_holds_all_pockets_that_it_forms():
    """A locating pin of radius 3 with round pockets of radius 2 beside it, 4 and 2.2 mm off its axis."""
    spec = closed()
    pin = next(pin for pin in loose_pins(spec) if pin.locator is None)

    def pocket(x, y, radius):
        outline = Outline((radius, radius), True)
        body = Body(np.array([x, y, -2.0]), np.eye(3), outline, 1.0, "a magnet")
        return Pocket(body, outline)

    beside = (pocket(5.0, -1.0, 2.0), pocket(1.0, 1.2, 2.0))
    held = replace(pin, pocket=pocket(1.0, -1.0, 3.0), locator=SimpleNamespace(pockets=beside))
    assert held.radius_mm == pytest.approx(6.0)
    assert replace(held, locator=SimpleNamespace(pockets=beside[1:])).radius_mm == pytest.approx(
        4.2
    )
    assert replace(held, locator=None).radius_mm == 3.0


@pytest.mark.parametrize("round_", [True, False])
def test_shank_and_head_of_a_leaning_pin_are_prisms_between_planes_along_the_face(round_):
    """Their sections along the face are their own over the cosine of the lean, about the axis."""
    spec = closed()
    plain = next(pin for pin in loose_pins(spec) if pin.locator is None)
    outline = Outline((3.0, 3.0 if round_ else 2.0), round_)
    body = Body(np.array([4.0, -2.0, -2.5]), tilted_frame(20.0, -10.0), outline, 1.0, "a magnet")
    pin = replace(plain, pocket=Pocket(body, outline), seat_mm=3.0, top_mm=7.0, rim_mm=0.5)
    area, wide = (9 * np.pi, 3.5**2 * np.pi) if round_ else (24.0, 35.0)
    up = body.frame[2, 2]
    for part, volume, low, high in (
        (pin.shank(), area / up * 3, 0.0, 3.0),
        (pin.head(), wide / up * 4, 3.0, 7.0),
    ):
        assert part.volume() == pytest.approx(volume, rel=1e-6)
        corners = pin.frame.from_object(np.array(part.to_mesh().vert_properties[:, :3], float))
        assert_allclose([corners[:, 2].min(), corners[:, 2].max()], [low, high], atol=1e-4)
        middle = corners.min(axis=0) / 2 + corners.max(axis=0) / 2
        axis = body.centre_mm + (middle[2] - body.centre_mm[2]) / up * body.frame[:, 2]
        assert_allclose(middle, axis, atol=0.02 if round_ else 1e-4)
