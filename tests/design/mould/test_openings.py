"""Vents of moulds, and solids of holes."""

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.body.meshes import Trap
from design.layout.mould.frame import up
from design.layout.mould.pouring import Hole
from design.mould import openings
from design.mould.openings import hole_solid, vent_for
from tests.support.objects.body_cases import body_spec
from tests.support.objects.worked_objects import worked


def vent_of(radius_mm, aside_mm, along_mm=9.0, azimuth_deg=0.0):
    """Of a high point of a round surface, beside a seam across x and a flange from -4 to 4 mm."""
    mould = {"parting_azimuth_deg": azimuth_deg}
    spec = body_spec("sphere", body={"open_faces": [6]}, mould=mould)
    shell = trimesh.creation.icosphere(5, radius_mm)
    place = np.array([aside_mm, along_mm, -20.0])
    shell.apply_translation([*place[:2], place[2] + radius_mm])
    vent = openings.vent_for(spec, shell, (), Trap(place, up(spec), 1.0))
    assert vent is not None
    assert vent.diameter_mm == 1.0
    return spec, place, vent


@pytest.mark.parametrize("aside_mm", [0.0, 0.45, 1.35, -1.35])
def test_a_vent_that_leaves_walls_stands_on_its_high_point(aside_mm):
    _, place, vent = vent_of(40.0, aside_mm)
    assert_allclose(vent.top_mm, place)


@pytest.mark.parametrize("aside_mm", [0.55, 1.2, -0.9])
def test_a_vent_beside_the_seam_moves_until_a_wall_is_left_or_the_seam_cuts_it(aside_mm):
    """Walls of 0.8 mm beside a vent of 1 mm; half a millimetre on a ball of 40 mm, in
    triangles, costs up to 0.015 mm."""
    spec, place, vent = vent_of(40.0, aside_mm)
    moved, lower = np.linalg.norm((vent.top_mm - place)[:2]), (place - vent.top_mm) @ up(spec)
    assert moved == pytest.approx(0.5)
    assert 0 < lower < 0.015
    assert abs(vent.top_mm[0]) >= 1.3 or abs(vent.top_mm[0]) <= 0.5
    assert_allclose(vent.end_mm[:2], vent.top_mm[:2], atol=1e-9)


def test_a_vent_beside_a_side_of_the_flange_moves_too():
    for aside in (3.1, 4.7):
        _, _, vent = vent_of(40.0, aside)
        gap = abs(vent.top_mm[0] - 4.0)
        assert not 0.5 < gap < 1.3, gap


def test_on_a_narrow_ridge_a_vent_stays_on_its_high_point():
    """A wall of 0.4 mm is left to the seam: half a millimetre aside lies 0.13 mm lower, under air."""
    _, place, vent = vent_of(1.0, 0.9)
    assert_allclose(vent.top_mm, place)


@pytest.mark.parametrize(
    ("azimuth_deg", "thin"), [(45.0, False), (127.0, True), (135.0, False), (143.0, True)]
)
def test_holes_beside_the_seam_are_told(monkeypatch, azimuth_deg, thin):
    """A vent of 1 mm, 6 mm from the axis at 45°: 0.84 mm beside a seam whose normal is at 45° ± 82°."""
    mould = {"parting_azimuth_deg": azimuth_deg}
    spec = body_spec("sphere", body={"open_faces": [6]}, mould=mould)
    top = np.array([6 / np.sqrt(2), 6 / np.sqrt(2), -20.0])
    start, end = (top + height * up(spec) for height in (-1.0, 90.0))
    vent = Hole("vent", start, top, end, 1.0)
    monkeypatch.setattr(openings, "mould_holes", lambda spec: (vent,))
    assert openings.holes_thin_walls(spec) is thin


def beside_a_bore():
    """Silicone round a bore of 10 mm, its rim at −20 from where it slopes, and pouring holes of 6 mm."""
    spec = body_spec("sphere", body={"open_faces": [6], "bore_mm": 10.0})
    spec = spec.changed(mould=spec.mould.changed(parting_azimuth_deg=90.0))
    profile = np.array([[5.0, -20.0], [14.0, -16.0], [14.0, -8.0], [5.0, -8.0], [5.0, -20.0]])
    ring = trimesh.creation.revolve(profile, sections=144)
    tops = [np.array([sign * 8.0, sign * 4.0, -20.0]) for sign in (-1, 1)]
    pour = [Hole("pour", top, top, top + 90 * up(spec), 6.0) for top in tops]
    return spec, ring, pour


def test_a_vent_beside_a_pouring_hole_goes_round_the_bore_until_a_wall_is_left():
    """Of `instobj new` for a ball of 34.5 mm with nine magnets: 0.58 mm between both, at 18° of the bore."""
    spec, ring, pour = beside_a_bore()
    place = 5.0 * np.array([-np.cos(np.deg2rad(17.7)), -np.sin(np.deg2rad(17.7)), -4.0])
    trap = Trap(place, up(spec), 1.0)
    alone = vent_for(spec, ring, (), trap)
    assert_allclose(alone.top_mm, place)
    gap = np.linalg.norm(alone.top_mm[:2] - pour[0].top_mm[:2]) - 3.5
    assert 0.5 < gap < 0.7
    moved = vent_for(spec, ring, (), trap, pour)
    away = [np.linalg.norm(moved.top_mm[:2] - hole.top_mm[:2]) - 3.5 for hole in pour]
    assert min(away) > spec.printer.wall_mm
    assert np.hypot(*moved.top_mm[:2]) == pytest.approx(5.05)
    assert moved.top_mm[2] == pytest.approx(-20.0 + 0.05 * 4 / 9, abs=1e-3)


def test_a_thin_wall_between_two_holes_is_told(monkeypatch):
    spec, _, pour = beside_a_bore()
    for away, thin in ((4.1, True), (4.4, False)):
        start = pour[1].top_mm + np.array([0.0, away, 0.0])
        vent = Hole("vent", start, start, start + 90 * up(spec), 1.0)
        monkeypatch.setattr(openings, "mould_holes", lambda spec, v=vent: (*pour, v))
        assert openings.holes_thin_walls(spec) is thin, away


def test_a_vent_goes_straight_up_where_nothing_is_above():
    """`up` is −z. Silicone of 20 mm edges, its high point in the middle of the side at −10; with a second
    piece over all of it there is no way."""
    spec = worked("box")
    body = trimesh.creation.box((20.0, 20.0, 20.0))
    above = trimesh.creation.box(bounds=[[-60.0, -60, -20], [60.0, 60, -15]])
    place, upwards = np.array([0.0, 0.0, -10.0]), np.array([0.0, 0.0, -1.0])
    plain = vent_for(spec, body, (), Trap(place, upwards, 0.5))
    assert plain is not None
    assert_allclose(plain.top_mm, place)
    way = plain.end_mm - plain.start_mm
    assert_allclose(way / np.linalg.norm(way), upwards, atol=1e-12)
    assert plain.diameter_mm == spec.printer.hole_mm == 1.0
    assert_allclose(plain.start_mm, [0.0, 0.0, -9.0])
    covered = trimesh.util.concatenate([body, above])
    assert vent_for(spec, covered, (), Trap(place, upwards, 0.5)) is None


def test_a_hole_is_as_wide_as_it_is_told():
    """By its volume, that of a prism with 48 sides."""
    start, end = np.array([1.0, 2.0, 3.0]), np.array([4.0, 6.0, 15.0])
    hole = Hole("vent", start, start + (end - start) / 2, end, 2.6)
    prism = 24 * np.sin(2 * np.pi / 48) * 1.3**2
    assert hole.surface().volume == pytest.approx(13 * prism)
    assert hole.outside.surface().volume == pytest.approx(6.5 * prism)
    assert_allclose(hole.surface().center_mass, (start + end) / 2)
    assert hole_solid(hole).Volume() == pytest.approx(13 * np.pi * 1.3**2)
