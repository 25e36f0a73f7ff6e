"""How a mould stands: which open side is up, what the block holds, where it parts."""

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.layout.body import body_of
from design.layout.mould import frame as frames
from design.layout.mould.closure import clip_mm, flange_corners_mm
from design.layout.mould.frame import mould_frame, mould_style, parting, up
from design.spec.object import ObjectSpec

AXES = {1: (0, 0, 1), 2: (0, -1, 0), 3: (1, 0, 0), 4: (0, 1, 0), 5: (-1, 0, 0), 6: (0, 0, -1)}


def box(open_faces, **mould):
    body = {"size_mm": [42.0, 44.0, 46.0], "open_faces": open_faces}
    return ObjectSpec.model_validate({"name": "box", "body": body, "mould": mould})


@pytest.mark.parametrize(
    ("open_faces", "out"),
    [([6], 6), ([3], 3), ([2, 6], 6), ([6, 4], 6), ([3, 2], 2), ([1], 1), ([], 6)],
)
def test_of_open_sides_the_lowest_is_up_else_the_first(open_faces, out):
    spec = box(open_faces)
    frame = mould_frame(spec)
    assert_allclose(frame.out, AXES[out])
    assert frame.opening == ("open" if open_faces else "closed")
    assert mould_style(spec) == ("one-piece" if open_faces else "split")
    assert sorted(abs(np.column_stack([frame.across, frame.length_axis, frame.out])).sum(0)) == [
        1,
        1,
        1,
    ]
    if open_faces:
        assert_allclose(up(spec), AXES[out])


@pytest.mark.parametrize(
    ("open_faces", "across"), [([6], 0), ([5, 6], 1), ([4, 6], 0), ([2, 5, 6], 0)]
)
def test_silicone_is_poured_at_the_ends_of_the_axis_with_more_walls(open_faces, across):
    assert_allclose(abs(mould_frame(box(open_faces)).across), np.eye(3)[across])


def test_the_block_is_the_body_and_its_walls_but_for_the_open_side():
    frame = mould_frame(box([6], wall_mm=2.0))
    assert_allclose(abs(frame.low_mm), [23.0, 24.0, 25.0])
    assert_allclose(frame.high_mm, [23.0, 24.0, 23.0])
    assert frame.rim_mm == 23.0
    closed = mould_frame(box([], wall_mm=2.0))
    assert_allclose(-closed.low_mm, closed.high_mm)
    assert_allclose(closed.high_mm, [23.0, 24.0, 25.0])
    low, high = frame.corners(frame.low_mm, frame.high_mm)
    assert_allclose(low, [-23.0, -24.0, -23.0])
    assert_allclose(high, [23.0, 24.0, 25.0])


def test_the_plane_of_a_closed_box_runs_through_two_edges_and_it_stands_on_a_corner():
    spec = box([])
    plane = parting(spec)
    edge = np.array([-21.0, 22.0, 0.0])
    assert plane.offset_mm == 0
    assert abs(plane.normal @ edge) < 1e-9 or abs(plane.normal @ abs(edge)) < 1e-9
    assert_allclose(abs(up(spec)), np.array([21, 22, 23]) / np.linalg.norm([21, 22, 23]))
    assert up(spec) @ plane.normal == pytest.approx(0, abs=1e-9)
    given = parting(box([], parting_azimuth_deg=30.0))
    frame = mould_frame(spec)
    assert_allclose(
        given.normal, np.sqrt(0.75) * frame.across + 0.5 * frame.length_axis, atol=1e-12
    )


def test_a_file_s_box_of_twelve_triangles_parts_along_its_sides_not_across_its_corners():
    """Across them each triangle's middle lay on the right side of the plane; 5.3 mm hooked."""
    body = body_of(
        ObjectSpec.model_validate({"name": "a", "body": {"size_mm": (60.0, 45.0, 30.0)}})
    )
    assert len(body.outer_surface().faces) == 12
    plane = frames.silhouette_parting(body)
    assert_allclose(abs(plane.normal), [0, 1, 0], atol=1e-9)
    assert plane.offset_mm == 0


def test_clips_stand_outside_the_walls_and_the_flange_between_and_over_them():
    """Box of 42 × 44 × 46 mm with walls of 2.2 mm and a play of 0.15 mm, open at −z."""
    spec = box([6], wall_mm=2.2)
    spec = spec.changed(printer=spec.printer.changed(clearance_mm=0.15))
    along = mould_frame(spec).length_axis
    wall = float(abs(along) @ [21.0, 22.0, 23.0]) + 2.2
    assert clip_mm(spec) == pytest.approx((wall + 0.15, wall + 2.5))
    rim = mould_frame(spec).rim_mm
    boxes = [
        corners @ np.column_stack([along, mould_frame(spec).out])
        for corners in map(np.array, flange_corners_mm(spec))
    ]
    spans = [[*found.min(axis=0), *found.max(axis=0)] for found in boxes]
    inner = wall - 2.2 - 0.15
    assert_allclose(
        spans,
        [
            [wall + 0.15, rim, wall + 2.5, rim + 10],
            [-wall - 2.5, rim, -wall - 0.15, rim + 10],
            [-wall - 2.5, rim + 2, wall + 2.5, rim + 10],
            [-inner, rim, inner, rim + 10],
        ],
        atol=1e-9,
    )
    assert flange_corners_mm(box([])) == []


@pytest.mark.parametrize(("azimuth_deg", "depth_mm"), [(0.0, 0.0), (90.0, 0.0), (45.0, 0.5**0.5)])
def test_a_seam_hooks_what_faces_the_other_half(azimuth_deg, depth_mm):
    """A box with sides of 42 and 44 mm at 45°: strips of its longer sides, 1 mm wide, lean by 45°.

    Whole triangles count.
    """
    spec = box([], parting_azimuth_deg=azimuth_deg)
    assert frames.undercut_depth_mm(spec) == pytest.approx(depth_mm, rel=0.15)


def tapered(tmp_path, **mould):
    """40 × 40 × 40 mm that taper along y from their largest section, at y = −20, by 2 mm on either side."""
    x, y, z = 20.0, 20.0, 20.0
    wide = [(sx * x, -y, sz * z) for sx in (-1, 1) for sz in (-1, 1)]
    narrow = [(sx * (x - 2), y, sz * (z - 2)) for sx in (-1, 1) for sz in (-1, 1)]
    trimesh.convex.convex_hull(np.array(wide + narrow)).export(tmp_path / "tapered.stl")
    body = {"kind": "imported", "file": str(tmp_path / "tapered.stl"), "size_mm": [40.0] * 3}
    return ObjectSpec.model_validate({"name": "tapered", "body": body, "mould": mould})


def test_the_seam_of_a_file_s_body_stands_across_a_given_azimuth_where_least_hooks(tmp_path):
    """Through the middle of its box half of a taper hooked: by 0.05 · 20 mm, by hand."""
    across_y = tapered(tmp_path, parting_azimuth_deg=90.0)
    assert_allclose(abs(parting(across_y).normal), [0, 1, 0], atol=1e-12)
    assert -20.5 < parting(across_y).offset_mm * parting(across_y).normal[1] < -19
    assert frames.undercut_depth_mm(across_y) == 0
    across_x = tapered(tmp_path, parting_azimuth_deg=0.0)
    assert parting(across_x).offset_mm == 0
    assert frames.undercut_depth_mm(across_x) == 0


def test_the_depth_that_hooks_is_that_of_a_taper_by_hand(tmp_path, monkeypatch):
    """A wall that leans by 2 in 40 mm, 20 mm of it on the wrong side."""
    spec = tapered(tmp_path, parting_azimuth_deg=90.0)
    monkeypatch.setattr(frames, "parting", lambda spec: frames.Parting(np.array([0.0, 1, 0]), 0.0))
    assert_allclose(frames.undercut_depth_mm(spec), 20 * 2 / 40, rtol=0.1)


@pytest.mark.parametrize(("azimuth_deg", "offset_mm"), [(0.0, 3.0), (30.0, 7.0), (130.0, -11.0)])
def test_a_seam_beside_the_middle_begins_and_ends_where_it_crosses_the_block(
    monkeypatch, azimuth_deg, offset_mm
):
    """As found by steps of a hundredth of a millimetre along it."""
    spec = box([])
    frame, turn = mould_frame(spec), np.deg2rad(azimuth_deg)
    normal = np.cos(turn) * frame.across + np.sin(turn) * frame.length_axis
    monkeypatch.setattr(frames, "parting", lambda spec: frames.Parting(normal, offset_mm))
    at = np.arange(-200.0, 200.0, 0.01)
    line = offset_mm * normal + at[:, None] * np.cross(frame.out, normal)
    places = line @ frame.axes
    inside = np.all((places >= frame.low_mm) & (places <= frame.high_mm), axis=1)
    wanted = at[inside][[0, -1]]
    assert np.allclose(frames.seam_ends_mm(spec), wanted, atol=0.02)
