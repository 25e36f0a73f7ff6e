"""Pins that hold a core that is cast in, where the surface leans in the middle of a face."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from design.layout.body import core_frames, face_frames
from design.layout.core_hold import (
    LEAST_FLOOR,
    Locator,
    Outlet,
    common_area_mm2,
    core_outlet,
    locator_in,
    locators,
    why_no_mould,
)
from design.layout.pockets import Body, Outline, Pocket
from design.spec_io import parse_spec

SPEC = parse_spec({"name": "closed", "body": {"open_faces": []}}, "test")


@dataclass(frozen=True)
class Slope:
    """A plane through the middle of the patch that rises along x."""

    per_mm: float

    def evaluate(self, xy_mm):
        xy = np.asarray(xy_mm, float)
        return self.per_mm * xy[..., 0], np.stack(
            [np.full(xy.shape[:-1], self.per_mm), np.zeros(xy.shape[:-1])], axis=-1
        )


def leaning(number, per_mm):
    frame, core = (
        f[SPEC.body.sensed.index(number)] for f in (face_frames(SPEC), core_frames(SPEC))
    )
    return replace(frame, relief=Slope(per_mm)), core


def pocket_at(x_mm):
    body = Body(np.array([x_mm, 0.0, -1.5]), np.eye(3), Outline((3.0, 3.0), True), 3.0, "a magnet")
    return Pocket(body, Outline((3.0, 3.0), True))


@pytest.mark.parametrize("per_mm", [0.0, 0.3])
def test_a_pin_runs_through_the_middles_of_face_and_core(per_mm):
    """Along the leaning surface's normal it missed the core's hole: 51 mm³ of core on a closed pear."""
    face, core = leaning(3, per_mm)
    locator = locator_in(SPEC, face, core, ())
    for share in (0.0, 0.5, 1.0):
        at = locator.frame.to_object(np.array([0.0, 0.0, -share * locator.depth_mm]))
        expected = face.centre_mm + share * (core.centre_mm - face.centre_mm)
        np.testing.assert_allclose(at, expected, atol=1e-12)
    np.testing.assert_allclose(locator.frame.tangent(np.zeros(2)).normal, face.normal)


def test_a_pocket_in_the_middle_is_one_with_the_pin_only_where_the_surface_is_level():
    level, core = leaning(3, 0.0)
    assert len(locator_in(SPEC, level, core, (pocket_at(0.0),)).pockets) == 1
    steep, core = leaning(3, 0.3)
    assert locator_in(SPEC, steep, core, (pocket_at(0.0),)) is None


def test_a_pin_keeps_further_from_pockets_that_lean_towards_it():
    """Hole of Ø4, pocket of Ø6, gap 0.8 mm: 5.8 mm apart on a level face, 8.1 mm at a slope of 0.3."""
    face, core = leaning(3, 0.3)
    assert locator_in(SPEC, face, core, (pocket_at(7.5),)) is None
    assert locator_in(SPEC, face, core, (pocket_at(8.3),)).pockets == ()
    level, core = leaning(3, 0.0)
    assert locator_in(SPEC, level, core, (pocket_at(6.0),)).pockets == ()


def block_at(x_mm, half_mm=(3.0, 2.5)):
    body = Body(np.array([x_mm, 0.0, -1.5]), np.eye(3), Outline(half_mm, False), 3.0, "a magnet")
    return Pocket(body, Outline(half_mm, False))


def flat_face():
    index = SPEC.body.sensed.index(3)
    return face_frames(SPEC)[index], core_frames(SPEC)[index]


def lens_mm2(r, other, away):
    """Common area of two circles, by strips."""
    x = np.linspace(-r, r, 200_001)
    half = np.sqrt(r**2 - x**2)
    beside = np.sqrt(np.clip(other**2 - (x - away) ** 2, 0, None))
    return 2 * np.trapezoid(np.minimum(half, beside), x)


@pytest.mark.parametrize("away", [0.0, 0.9, 1.0, 1.1, 2.5, 3.0, 4.0, 4.9, 5.0, 6.0])
def test_a_pin_s_and_a_pocket_s_sections_share_a_lens(away):
    """Pin of Ø4 and pocket of Ø6, and a pin of Ø8 round it."""
    assert common_area_mm2(2.0, pocket_at(away)) == pytest.approx(
        lens_mm2(2.0, 3.0, away), abs=2e-3
    )
    assert common_area_mm2(4.0, pocket_at(away)) == pytest.approx(
        lens_mm2(4.0, 3.0, away), abs=2e-3
    )


def test_silicone_that_is_missing_round_a_pin_leaves_out_what_the_pocket_takes():
    face, core = flat_face()
    alone = locator_in(SPEC, face, core, ())
    assert (alone.radius_mm, alone.place, alone.rise_mm) == (2.0, (3, 0.0, 0.0), 0.0)
    assert alone.depth_mm == pytest.approx(SPEC.shell.thickness_mm)
    assert alone.hole_mm == pytest.approx(21.0 - SPEC.shell.thickness_mm)
    assert alone.volume_mm3 == pytest.approx(np.pi * 4 * 8)
    met = locator_in(SPEC, face, core, (pocket_at(0.0),))
    assert met.volume_mm3 == pytest.approx(np.pi * 4 * (8 - 3))


def test_a_block_s_pocket_must_hold_the_whole_pin():
    face, core = flat_face()
    assert len(locator_in(SPEC, face, core, (block_at(0.5),)).pockets) == 1
    assert locator_in(SPEC, face, core, (block_at(0.51),)) is None
    assert locator_in(SPEC, face, core, (block_at(0.0, (1.9, 5.0)),)) is None


def test_a_pin_leaves_a_third_of_a_magnet_s_floor_free():
    face, core = flat_face()
    half = 2.0 * (np.pi / 4 / (1 - LEAST_FLOOR)) ** 0.5
    assert len(locator_in(SPEC, face, core, (block_at(0.0, (half * 1.01,) * 2),)).pockets) == 1
    assert locator_in(SPEC, face, core, (block_at(0.0, (half * 0.99,) * 2),)) is None


def test_a_tilted_pocket_is_never_one_with_the_pin():
    face, core = flat_face()
    turn = np.array([[1.0, 0, 0], [0, np.cos(0.1), -np.sin(0.1)], [0, np.sin(0.1), np.cos(0.1)]])
    for x, kept in ((0.0, False), (30.0, False)):
        body = replace(pocket_at(x).body, frame=turn)
        found = locator_in(SPEC, face, core, (replace(pocket_at(x), body=body),))
        assert (found is not None) == kept
    assert locator_in(SPEC, face, core, (pocket_at(5.81),)).pockets == ()
    assert len(locator_in(SPEC, face, core, (pocket_at(5.79),)).pockets) == 1, "less than the gap"


def test_a_round_pocket_off_the_middle_is_met_on_flat_faces_alone():
    face, core = flat_face()
    assert len(locator_in(SPEC, face, core, (pocket_at(2.0),)).pockets) == 1
    level, core = leaning(3, 0.0)
    assert locator_in(SPEC, level, core, (pocket_at(2.0),)) is None


def test_an_outlet_s_flat_nose_and_key_follow_from_its_radius_and_wall():
    outlet = Outlet(5.0, -13.0, 4.5)
    assert outlet.flat_mm == pytest.approx(3.5)
    assert outlet.nose_mm == pytest.approx(-13 + 4.5 + 4)
    assert Outlet(5.0, -6.0, 4.5).nose_mm == pytest.approx(-6 + 0.8 * 6)
    low, high = outlet.key_mm
    np.testing.assert_allclose(low, [3.5, -6, -19])
    np.testing.assert_allclose(high, [6, 6, -8.5])


def test_an_outlet_is_narrower_than_its_core_and_its_wall_half_of_it():
    ball = {"name": "ball", "body": {"kind": "sphere"}, "magnets": {"positions_mm": [[0.0, 0.0]]}}
    wide = parse_spec(ball, "test")
    floor = wide.body.size_mm[2] / 2 - wide.shell.thickness_mm
    outlet = core_outlet(wide)
    assert outlet.radius_mm == pytest.approx(wide.body.bore_mm / 2)
    assert outlet.floor_mm == pytest.approx(-floor, abs=1.1)
    assert outlet.wall_mm == pytest.approx(min(wide.core.wall_mm, floor / 2))


def test_two_pins_at_right_angles_hold_a_closed_cube():
    """Wide holes first: of the sides', Ø4, not the top's, Ø2."""
    nothing = parse_spec({"name": "open"}, "test")
    assert locators(nothing) == ()
    assert why_no_mould(nothing) is None
    free = parse_spec(
        {"name": "closed", "body": {"open_faces": []}, "magnets": {"positions_mm": [[12.0, 0.0]]}},
        "test",
    )
    first, second = locators(free)
    assert isinstance(first, Locator)
    assert (first.frame.number, second.frame.number) == (2, 3)
    assert (first.radius_mm, second.radius_mm) == (2.0, 2.0)
    assert abs(first.frame.normal @ second.frame.normal) < 1e-9
    assert first.socket is None
    assert second.socket is None
    assert why_no_mould(free) is None


def test_pins_that_meet_pockets_find_no_place_where_a_layer_is_poured_over_these():
    content = {
        "name": "closed",
        "body": {"open_faces": []},
        "magnets": {"positions_mm": [[4.0, 0.0]]},
    }
    found = locators(parse_spec(content, "test"))
    assert [(pin.socket, len(pin.pockets)) for pin in found] == [(None, 1), (None, 1)]
    sealed = parse_spec(content | {"shell": {"seal_layer_mm": 1.0}}, "test")
    assert locators(sealed) == ()
    assert "pockets leave no room for one" in (why_no_mould(sealed) or "")
