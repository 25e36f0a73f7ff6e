"""Halves draw apart without an undercut, and pins draw out along their own axes."""

from functools import cache

import cadquery as cq
import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.mould.frame import FLANGE_THICKNESS_MM, mould_frame, parting
from design.layout.mould.pins import loose_pins, pin_kinds
from design.layout.mould.pouring import pour_holes
from design.layout.pockets import distance_of_segments_mm, shell_pockets
from design.mould.flange import (
    EDGE_MM,
    LEAST_GAP_MM,
    LEAST_STRETCH_MM,
    PLACES,
    Flange,
    flanges,
    roots_mm,
)
from design.mould.halves import (
    BOLT_HOLE_MM,
    DOWEL_DIAMETER_MM,
    DOWEL_HEIGHT_MM,
    OVERSHOOT_MM,
    bolt_holes,
    dowel_solid,
    flange_solid,
    make_mould_half,
)
from design.mould.one_piece import make_mould_box
from design.mould.pins import make_pin
from design.mould.plug import make_mould_plug
from design.solids.booleans import convert_to_triangles
from design.solids.shell import make_shell
from design.spec_io import load_spec, parse_spec
from tests.support.objects.shell_volume import cast_cavity
from tests.support.pages import ROOT

SKEWED = {
    "body": {"size_mm": [50.0, 46.0, 44.0]},
    "magnets": {"positions_mm": [[2.0, -1.0], [-9.0, 4.0]]},
}
TILTED = SKEWED | {"magnets": SKEWED["magnets"] | {"depth_mm": 2.4, "tilt_deg": [[8, 0], [0, -12]]}}
CONTENTS = [
    pytest.param("skewed", id="straight", marks=pytest.mark.slow),
    pytest.param("tilted", id="tilted"),
]


def parsed(azimuth=None, **content):
    mould = {"style": "split"} | ({} if azimuth is None else {"parting_azimuth_deg": azimuth})
    return parse_spec({"name": "t", "mould": mould, **content}, "test")


@cache
def spec_of(name):
    return parsed(**{"skewed": SKEWED, "tilted": TILTED}[name])


@cache
def shell_of(name):
    return make_shell(spec_of(name))


@cache
def half_of(name, side):
    return make_mould_half(spec_of(name), side)


def drawn_through(part, shell, way):
    """Volume of silicone in the way of a part that is drawn, over steps of its path."""
    steps = (0.5, 2.0, 5.0, 12.0)
    return sum(
        shell.intersect(part.translate(cq.Vector(*(step * np.asarray(way))))).Volume()
        for step in steps
    )


def test_halves_draw_apart_once_the_pins_are_out():
    shell, normal = shell_of("skewed"), parting(spec_of("skewed")).normal
    for side in (1, -1):
        half = half_of("skewed", side)
        assert_allclose(drawn_through(half, shell, side * normal), 0, rtol=0, atol=1e-6)
    assert drawn_through(half, shell, normal) > 100, "the other way it cannot go"


def test_a_seam_beside_the_edges_makes_an_undercut():
    spec = parsed(30.0, **SKEWED)
    half = make_mould_half(spec, 1)
    assert drawn_through(half, shell_of("skewed"), parting(spec).normal) > 100


def test_the_one_piece_box_cannot_be_drawn():
    box = make_mould_box(spec_of("skewed"))
    assert drawn_through(box, shell_of("skewed"), (0, 0, 1)) > 50


@pytest.mark.parametrize("content", CONTENTS)
def test_pins_draw_out_along_their_axes(content):
    spec, shell = spec_of(content), shell_of(content)
    halves = [half_of(content, side) for side in (1, -1)]
    pins = [make_pin(spec, pin) for pin in loose_pins(spec)]
    ways = [
        frame.axes @ pocket.axis
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]
    for pin, way in list(zip(pins, ways, strict=True))[::3]:
        assert_allclose(drawn_through(pin, shell, way), 0, rtol=0, atol=1e-6)
        for half in halves:
            assert_allclose(half.intersect(pin).Volume(), 0, rtol=0, atol=1e-6)
            assert_allclose(drawn_through(pin, half, way), 0, rtol=0, atol=1e-6)
        pushed = pin.translate(cq.Vector(*(-0.3 * way)))
        blocked = sum(half.intersect(pushed).Volume() for half in halves)
        assert blocked > 1, "the head must stop the pin at its depth"


@pytest.mark.parametrize("content", CONTENTS)
def test_halves_pins_and_plug_cast_the_shell(content):
    shell, cavity = shell_of(content), cast_cavity(spec_of(content))
    assert_allclose(cavity.Volume(), shell.Volume(), rtol=1e-9)
    outside = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
    assert_allclose(outside, 0, rtol=0, atol=1e-6 * shell.Volume())


def test_halves_fit_each_other_and_the_plug():
    spec = spec_of("skewed")
    a, b, plug = half_of("skewed", 1), half_of("skewed", -1), make_mould_plug(spec)
    for one, other in ((a, b), (a, plug), (b, plug)):
        assert_allclose(one.intersect(other).Volume(), 0, rtol=0, atol=1e-6)
    sideways = b.translate(cq.Vector(*(0.5 * np.cross(parting(spec).normal, [0, 0, 1]))))
    assert a.intersect(sideways).Volume() > 1, "dowels must stop the halves from sliding"


def test_pins_that_are_alike_are_counted_once():
    assert pin_kinds(loose_pins(parsed(**SKEWED))) == [("mould_pin", 0, 10)]
    assert [count for *_, count in pin_kinds(loose_pins(parsed(**TILTED)))] == [5, 5]


def test_dowels_taper_by_their_draft():
    """Volume of a truncated cone of the stated draft on a stem, by formula."""
    dowel = dowel_solid(parsed(0.0), 3.0, 4.0, 0.0)
    root, height = DOWEL_DIAMETER_MM / 2, DOWEL_HEIGHT_MM
    tip = root - height * np.tan(np.deg2rad(10.0))
    cone = np.pi * height / 3 * (root**2 + root * tip + tip**2)
    stem = np.pi * root**2 * OVERSHOOT_MM
    assert_allclose(dowel.Volume(), cone + stem, rtol=1e-6)


def test_bolts_go_through_both_flanges_at_every_second_place():
    flange = Flange(0.0, 8.0, -10.0, 30.0, ())
    holes = bolt_holes(parsed(0.0), flange)
    assert len(holes) == len(flange.places_mm[1::2]) == 2
    long = 2 * FLANGE_THICKNESS_MM + 2 * OVERSHOOT_MM
    for hole in holes:
        assert_allclose(hole.Volume(), np.pi * (BOLT_HOLE_MM / 2) ** 2 * long, rtol=1e-6)
        normal = parting(parsed(0.0)).normal
        assert abs(np.array(hole.Center().toTuple()) @ normal) < 1e-6


def test_flanges_are_notched_through_both_halves_from_their_outer_edges():
    """A slab across the mould's block of 42 mm and its walls of 1.5 mm, less what notches take up to it."""
    spec = parsed(0.0)
    low = float(mould_frame(spec).low_mm[2])
    first = Flange(-32.0, -24.0, low, 20.0, ((-9.0, -4.0), (6.0, 8.0)))
    second = Flange(24.0, 31.0, low - 6.0, 20.0, ((1.0, 4.5),))
    slab, strip = 63.0 * (20.0 - low), 7.0 * 6.0
    notches = 9.5 * (5.0 + 2.0) + 8.5 * 3.5
    solid = flange_solid(spec, first, second)
    assert_allclose(solid.Volume(), 2 * FLANGE_THICKNESS_MM * (slab + strip - notches), rtol=1e-9)


@pytest.mark.parametrize(("azimuth", "root"), [(0.0, 22.5), (45.0, 22.5 * np.sqrt(2) - 4.0)])
def test_notches_begin_where_the_block_ends_on_all_of_the_flange_s_thickness(azimuth, root):
    """4 mm beside a seam through its edges the block of 45 mm ends 4 mm sooner."""
    assert_allclose(roots_mm(parsed(azimuth)), (-root, root))


@pytest.mark.parametrize("notches", [(), ((5.0, 9.0),)])
def test_dowels_and_bolts_stand_at_their_shares_or_beside_a_notch(notches):
    flange = Flange(0.0, 8.0, -10.0, 30.0, notches)
    across, levels = np.array(flange.places_mm).T
    assert_allclose(across, 4)
    shares = -10 + 40 * np.array(PLACES)
    assert len(levels) == len(shares)
    blocked = [any(low - EDGE_MM < s < high + EDGE_MM for low, high in notches) for s in shares]
    assert_allclose(levels[~np.array(blocked)], shares[~np.array(blocked)])
    assert sum(blocked) == len(notches)
    assert np.diff(np.sort(levels)).min() >= LEAST_GAP_MM
    for low, high in notches:
        assert ((levels <= low - EDGE_MM) | (levels >= high + EDGE_MM)).all()


def test_the_pouring_hole_of_a_closed_egg_leaves_dowels_on_their_flange():
    """It leaves through the seam's corner: a dowel at its share stood in the air, 31 mm³."""
    spec = load_spec(ROOT / "examples" / "egg.toml", ["body.open_faces=[]"])
    (pour,) = pour_holes(spec)
    axis = np.stack([pour.top_mm, pour.end_mm])
    plane = parting(spec)
    aside = np.cross(mould_frame(spec).out, plane.normal)
    pierced = 0
    for flange in flanges(spec):
        pierced += np.isfinite(flange.pierced_mm)
        assert len(flange.places_mm) == len(PLACES)
        for across, level in flange.places_mm:
            place = across * aside + level * mould_frame(spec).out + plane.offset_mm * plane.normal
            gap = distance_of_segments_mm(axis, np.stack([place, place + 1e-3 * plane.normal]))
            assert gap > pour.diameter_mm / 2 + DOWEL_DIAMETER_MM / 2
    assert pierced == 1
    assert len(convert_to_triangles(make_mould_half(spec, 1)).split(only_watertight=False)) == 1


def test_dowels_stand_on_flange_that_hangs_on_the_block():
    """Pins of its faces 2 and 4 leave through the flange's lower half: what is below hung on nothing."""
    content = {
        "body": {"kind": "ellipsoid", "size_mm": [43.2, 63.6, 48.1], "bore_mm": 10.0},
        "shell": {"thickness_mm": 7.93, "pocket_diameter_mm": 6.0},
        "magnets": {"diameter_mm": 6.0, "positions_mm": [[12, 0], [6, 9.4], [-6, 9.4], [-12, 0]]},
        "contact_grid": {"count": "fill"},
        "core": {
            "recess_inner_radius_mm": 2.39,
            "recess_outer_radius_mm": 8.89,
            "wire_hole_top_diameter_mm": 2.0,
            "wall_mm": 5.5,
        },
        "sensors": {"count_per_face": 2, "radius_mm": 5.64},
    }
    spec = parse_spec({"name": "egg", **content}, "test")
    block = float(mould_frame(spec).low_mm[2])
    for flange in flanges(spec):
        assert flange.notches
        assert len(flange.places_mm) >= 3
        for _, level in flange.places_mm:
            ends = [flange.bottom_mm, *(end for _, end in flange.notches if end < level)]
            starts = [flange.top_mm, *(start for start, _ in flange.notches if start > level)]
            assert min(starts) - max(*ends, block) >= LEAST_STRETCH_MM
