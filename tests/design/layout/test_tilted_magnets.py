"""Magnets in any depth and tilt: axes, pockets cut and cast, and what does not fit."""

import cadquery as cq
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

import design.layout.places.positions
import design.layout.pockets
from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout
from design.layout.pockets import distance_of_segments_mm, shell_pockets, tilted_frame
from design.mould.one_piece import make_mould_box
from design.solids.shell import make_shell
from design.spec.object import BodySpec, MagnetSpec, ObjectSpec, ShellSpec
from design.spec_io import check
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

TILTED = ObjectSpec(
    name="tilted",
    body=BodySpec(size_mm=(50.0, 46.0, 42.0)),
    shell=ShellSpec(thickness_mm=8.0, pocket_diameter_mm=5.2, pocket_depth_mm=3.5),
    magnets=MagnetSpec(
        diameter_mm=5.0,
        positions_mm=((2.0, -1.0), (-9.0, 4.0), (7.0, -9.5)),
        depth_mm=(2.5, 3.1, 4.0),
        tilt_deg=((12.0, -20.0), (0.0, 25.0), (-8.0, 3.0)),
    ),
)


def tilted_axes_by_scipy():
    turns = np.deg2rad([[a, b, 0.0] for a, b in TILTED.magnets.tilt_deg])
    return Rotation.from_rotvec(turns).apply([0.0, 0.0, 1.0])


def assert_layout_is_turned():
    spec = TILTED.model_copy()  # another object, for which nothing was worked out yet
    layout, local = magnet_layout(spec), tilted_axes_by_scipy()
    xy = np.array(spec.magnets.positions_mm)
    for index, frame in enumerate(face_frames(spec)):
        magnets = slice(3 * index, 3 * index + 3)
        assert_allclose(layout.axis[magnets], local @ frame.axes.T, rtol=0, atol=1e-12)
        place = frame.from_object(layout.centre_mm[magnets])
        assert_allclose(place[:, :2], xy, rtol=0, atol=1e-12)
        assert_allclose(place[:, 2], [-2.5, -3.1, -4.0], rtol=0, atol=1e-12)


def test_every_face_carries_the_same_turned_magnets():
    assert_layout_is_turned()


@pytest.mark.parametrize("fault", ["sign", "swapped axes", "degrees for radians"])
def test_a_wrong_tilt_is_caught(monkeypatch, fault):
    """Planted faults in the axis that the layout is given."""
    wrong = {
        "sign": lambda a, b: tilted_frame(-a, b),
        "swapped axes": lambda a, b: tilted_frame(b, a),
        "degrees for radians": lambda a, b: tilted_frame(np.rad2deg(a), np.rad2deg(b)),
    }[fault]
    monkeypatch.setattr(design.layout.pockets, "tilted_frame", wrong)
    with pytest.raises(AssertionError, match="Not equal to tolerance"):
        assert_layout_is_turned()


def test_the_shell_has_its_closed_form_volume_and_the_mould_casts_it():
    shell, cavity = make_shell(TILTED), cast_cavity(TILTED)
    sealed = 50 * 46 * 42 - 34 * 30 * 34
    cosine = tilted_axes_by_scipy()[:, 2]
    by_hand = sealed - 5 * np.pi * 2.6**2 * np.sum(0.5 + np.array([2.5, 3.1, 4.0]) / cosine)
    assert_allclose(shell_volume_mm3(TILTED), by_hand, rtol=1e-12)
    assert_allclose(shell.Volume(), by_hand, rtol=1e-8)
    difference = cavity.cut(shell).Volume() + shell.cut(cavity).Volume()
    assert_allclose(difference, 0, rtol=0, atol=1e-6 * shell.Volume())


def test_a_magnet_lies_on_the_floor_of_its_pocket_and_the_silicone_begins_beneath_it():
    shell, layout = make_shell(TILTED), magnet_layout(TILTED)
    for centre, axis in zip(layout.centre_mm, layout.axis, strict=True):
        side = np.cross(axis, [0.3, -0.5, 0.8])
        for rim in (0, 2.55 * side / np.linalg.norm(side), -2.55 * side / np.linalg.norm(side)):
            assert not shell.isInside(cq.Vector(*(centre - 0.49 * axis + rim)))
            assert shell.isInside(cq.Vector(*(centre - 0.51 * axis + rim)))


def test_tilted_bosses_do_not_pierce_the_mould():
    box = make_mould_box(TILTED).BoundingBox()
    assert_allclose([box.xmin, box.xmax, box.ymin, box.ymax], [-26.5, 26.5, -24.5, 24.5], atol=1e-6)
    assert_allclose(box.zmax, 22.5, rtol=0, atol=1e-6)


def test_the_reach_and_the_lowest_point_of_a_pocket_bound_its_solid():
    (frame, *_), local = face_frames(TILTED), shell_pockets(TILTED)[0]
    half = frame.half_extents_mm
    room = cq.Solid.makeBox(2 * half[0], 2 * half[1], 30, cq.Vector(-half[0], -half[1], -30))
    for pocket in local:
        start, end = pocket.axis_ends_mm
        axis = cq.Vector(*(end - start))
        solid = cq.Solid.makeCylinder(
            pocket.outline.radius_mm, axis.Length, cq.Vector(*start), axis
        )
        box = solid.intersect(room).BoundingBox()
        reach = [max(-box.xmin, box.xmax), max(-box.ymin, box.ymax)]
        assert_allclose(pocket.reach_mm, reach, rtol=0, atol=2e-3)
        assert_allclose(pocket.lowest_mm, box.zmin, rtol=0, atol=2e-3)


def test_the_distance_of_axes_is_that_of_many_points_on_them():
    local = shell_pockets(TILTED)[0]
    share = np.linspace(0, 1, 801)[:, None]
    for a, b in ((0, 1), (0, 2), (1, 2)):
        (p, p_end), (q, q_end) = local[a].axis_ends_mm, local[b].axis_ends_mm
        first, second = p + share * (p_end - p), q + share * (q_end - q)
        sampled = np.linalg.norm(first[:, None] - second, axis=2).min()
        distance = distance_of_segments_mm(local[a].axis_ends_mm, local[b].axis_ends_mm)
        assert_allclose(distance, sampled, rtol=0, atol=1e-3)


@pytest.mark.parametrize(
    ("magnets", "message"),
    [
        ({"tilt_deg": ((0.0, 0.0),)}, r"tilt_deg needs one entry for each of the 5"),
        ({"depth_mm": (2.5, 2.5)}, r"depth_mm needs one entry for each of the 5"),
        ({"tilt_deg": ((31.0, 0.0),) + ((0.0, 0.0),) * 4}, "less than or equal to 30"),
        ({"depth_mm": 0.5}, r"depth_mm\[0\] = 0.5 does not seal .* deeper than 0.5 and"),
        ({"depth_mm": 7.5}, r"depth_mm\[0\] = 7.5 does not seal .* less deep than 7.5 mm"),
        ({"depth_mm": 1.2, "tilt_deg": ((20.0, 0.0),) * 5}, r"deeper than 1.496"),
        ({"depth_mm": 6.8, "tilt_deg": ((20.0, 0.0),) * 5}, r"less deep than 6.504 mm"),
        (
            {"positions_mm": ((0.0, 0.0), (6.5, 0.0)), "tilt_deg": ((0.0, 15.0), (0.0, -15.0))},
            r"positions_mm\[0\] .* and magnets.positions_mm\[1\] .* touch or overlap",
        ),
        (
            {"positions_mm": ((14.8, 0.0),), "tilt_deg": ((0.0, 10.0),)},
            "reaches into the 3.513 mm zone",
        ),
        ({"positions_mm": ((17.9, 0.0),), "tilt_deg": ((0.0, 10.0),)}, "outside the shell's face"),
    ],
)
def test_magnets_that_do_not_fit_are_refused(magnets, message):
    with pytest.raises(ValueError, match=message):
        check(ObjectSpec(name="bad", magnets=MagnetSpec(**magnets)))


def test_one_depth_serves_all_magnets_and_none_seats_them_on_the_floor():
    deep = ObjectSpec(name="deep", magnets=MagnetSpec(depth_mm=4.0))
    for spec, depth in ((deep, 4.0), (ObjectSpec(name="paper"), 2.5)):
        for frame in face_frames(spec):
            centres = magnet_layout(spec).centre_mm[magnet_layout(spec).face == frame.number]
            assert_allclose(frame.from_object(centres)[:, 2], -depth, rtol=0, atol=1e-12)
