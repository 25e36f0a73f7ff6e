"""Pins of a mould against what closes it and against each other, before anything is built."""

import re
from dataclasses import replace

import numpy as np
import pytest

from design.body.surface_chart import FACE_AXES, FaceFrame
from design.errors import InputError
from design.fit import mould
from design.fit.everything import problems_of
from design.layout.mould.closure import flange_corners_mm
from design.layout.mould.frame import mould_frame
from design.layout.mould.pins import Pin, loose_pins
from design.layout.pockets import Body, Outline, Pocket, tilted_frame
from design.spec.object import ObjectSpec

BALL = {
    "name": "ball",
    "body": {
        "kind": "sphere",
        "size_mm": [50, 50, 50],
        "bore_mm": 12,
        "sensed_faces": [2, 3, 4, 5],
    },
    "contact_grid": {"count": [3, 3]},
    "sensors": {"positions_mm": [[0, 6]], "radius_mm": 6.0},
}


def ball(x_mm, **body):
    """A magnet on each side, `x_mm` towards the bore, and one beyond the middle."""
    magnets = {"positions_mm": [[x_mm, 0], [-8, 0]]}
    return ObjectSpec.model_validate(BALL | {"magnets": magnets, "body": BALL["body"] | body})


def flange_problems(spec):
    return [text for text in problems_of(spec, table=False) if "in the flange" in text]


def test_a_pin_s_head_in_the_way_of_a_holder_s_clip_is_told_with_a_place_that_works():
    """16 mm³ of a clip, on both sides that the flange lies over, and nothing else that does not fit."""
    problems = problems_of(ball(18.0), table=False)
    assert problems == flange_problems(ball(18.0))
    assert [re.findall(r"face (\d) stands", text) for text in problems] == [["2"], ["4"]]
    x, y = map(float, re.findall(r"as to \(([\d.]+), ([\d.]+)\)", problems[0])[0])
    assert y == 0
    assert 14.0 < x < 16.0
    assert problems_of(ball(x), table=False) == []
    assert min(pin.rim_mm for pin in loose_pins(ball(x))) >= 0.4, "the least rim of a head"
    assert flange_problems(ball(x + 1.5)), "or the place is not the nearest"


def test_a_magnet_beyond_its_patch_is_told_once_with_a_place_that_works_on_every_face():
    """Patch, cover and flange had a line and a place each, on every face again."""
    (problem,) = problems_of(ball(24.0), table=False)
    assert "outside faces 2, 3, 4, 5" in problem
    x, y = map(float, re.findall(r"as to \(([\d.]+), ([\d.]+)\)", problem)[0])
    assert y == 0
    assert problems_of(ball(x), table=False) == []
    assert problems_of(ball(x + 1.5), table=False), "or the place is not the nearest"


def test_heads_clear_of_the_flange_are_not_told():
    assert flange_problems(ball(18.0, sensed_faces=[3, 5])) == [], "sides beside the flange"
    assert flange_problems(ball(18.0, open_faces=[])) == [], "nothing hangs over a closed mould"


def test_a_flange_is_two_clips_a_bar_over_the_walls_and_a_bridge_between_them():
    """Of a rod of 12 mm: clips 2.5 mm thick outside walls at 27 mm, of 0.1 mm of play, the rim at 27."""
    spec = ball(8.0)
    frame = mould_frame(spec)
    assert frame.rim_mm == frame.high_mm[1] == pytest.approx(25 + spec.mould.wall_mm)
    wall = frame.rim_mm
    local = [
        np.sort(frame.axes.T @ np.column_stack(corners), axis=1)
        for corners in flange_corners_mm(spec)
    ]
    ends = np.array([[-6.0, 6.0], [wall + 0.1, wall + 2.5], [wall, wall + 10]])
    mirrored, bar, bridge = ends.copy(), ends.copy(), ends.copy()
    mirrored[1] = -ends[1, ::-1]
    bar[1:] = [-wall - 2.5, wall + 2.5], [wall + 2, wall + 10]
    inside = wall - spec.mould.wall_mm - 0.1
    bridge[1] = -inside, inside
    for found, wanted in zip(local, (ends, mirrored, bar, bridge), strict=True):
        assert found == pytest.approx(wanted)


def pin(x_mm=0.0, tilt_deg=0.0, outline=None, rim_mm=1.5):
    """On top of a plane at z = 10 mm: a seat 2 mm and a top 5 mm above it."""
    normal, x, y = (np.array(axis, float) for axis in FACE_AXES[1])
    frame = FaceFrame(1, normal, x, y, np.array([0, 0, 10.0]), (20.0, 20.0))
    outline = outline or Outline((3.0, 3.0), True)
    body = Body(np.array([x_mm, 0.0, -2.0]), tilted_frame(0.0, tilt_deg), outline, 2.0, "a magnet")
    return Pin(frame, Pocket(body, outline), 2.0, 5.0, rim_mm)


@pytest.mark.parametrize("tilt_deg", [0.0, 12.0])
@pytest.mark.parametrize(
    ("outline", "area"),
    [(Outline((3.0, 3.0), True), np.pi * 4.5**2), (Outline((2.0, 3.0), False), 7.0 * 9.0)],
)
def test_a_head_is_its_outline_with_the_rim_between_seat_and_top(outline, area, tilt_deg):
    """Between planes along the face a leaning prism's section is larger by 1 / cos of its tilt."""
    head = pin(1.0, tilt_deg, outline).head()
    assert head.volume() == pytest.approx(3.0 * area / np.cos(np.deg2rad(tilt_deg)), rel=1e-6)
    low, high = np.reshape(head.bounding_box(), (2, 3))
    assert [low[2], high[2]] == pytest.approx([12.0, 15.0])
    middle = 1.0 + np.tan(np.deg2rad(tilt_deg)) * (3.5 + 2.0)
    assert (low[0] + high[0]) / 2 == pytest.approx(middle, abs=0.02)


def test_pins_that_lean_towards_each_other_are_told(monkeypatch):
    """Pockets 10 mm apart, 4 mm of them silicone: at 30° the shanks meet beyond the surface."""
    lean = [pin(-5.0, 30.0, rim_mm=0.0), replace(pin(5.0, -30.0, rim_mm=0.0))]
    monkeypatch.setattr(mould, "loose_pins", lambda spec: lean)
    (told,) = mould.check_pins_apart(ball(8.0))
    assert "share" in told
    assert "beyond the silicone" in told
    monkeypatch.setattr(mould, "loose_pins", lambda spec: [pin(-5.0), pin(4.1)])
    assert not [*mould.check_pins_apart(ball(8.0))], "9.1 mm apart: rims of 9 mm together"
    monkeypatch.setattr(mould, "loose_pins", lambda spec: [pin(-5.0), pin(3.9)])
    assert [*mould.check_pins_apart(ball(8.0))]


def pouring_problems(spec):
    return [text for text in mould.check_mould(spec) if "pouring holes" in text]


def test_holes_that_nothing_can_be_poured_through_are_told_with_the_widest_that_find_room():
    """`build` alone refused them. Of a ball's four sides, their magnets far from its bore."""
    spec = ball(8.0)
    wide = spec.changed(mould=spec.mould.changed(pour_mm=30.0))
    (problem,) = pouring_problems(wide)
    width = float(re.findall(r"mould.pour_mm = ([\d.]+) finds room", problem)[0])
    assert 6 < width < 30
    assert pouring_problems(spec) == []
    assert pouring_problems(spec.changed(mould=spec.mould.changed(pour_mm=width))) == []
    assert pouring_problems(spec.changed(mould=spec.mould.changed(pour_mm=width + 0.5)))


@pytest.mark.parametrize(
    ("in_the_way", "told"), [(1, r"face 2 is in the way. Move .* to"), (2, "")]
)
def test_where_no_hole_is_narrow_enough_the_magnet_in_the_way_is_told(
    monkeypatch, in_the_way, told
):
    """Magnets more than 12 mm from their face's middle, of one face or of two."""
    faces = {pin.frame.number for pin in loose_pins(ball(15.0))}
    blocked = sorted(faces)[:in_the_way]

    def pour_holes(spec, first, pins=None):
        for pin in loose_pins(spec) if pins is None else pins:
            if pin.frame.number in blocked and pin.pocket.body.centre_mm[0] > 12:
                raise InputError("no holes")
        return ()

    monkeypatch.setattr(mould, "pour_holes", pour_holes)
    (problem,) = mould.check_pouring(ball(15.0))
    if told:
        assert re.search(told, problem)
        (x,) = map(float, re.findall(r"as to \(([\d.]+), 0\)", problem))
        assert 11.5 < x <= 12
    else:
        assert problem.endswith("or leave a face out with body.sensed_faces")
