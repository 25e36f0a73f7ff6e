"""Patches of curved bodies: places, normals, and the frames that touch them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.body.surface_chart import FaceFrame, steepest_reach_mm
from design.layout.body import body_of, core_frames, face_frame, face_frames
from design.layout.places.positions import board_sinks_mm, magnet_layout, sensor_layout
from tests.support.objects.body_cases import body_spec
from tests.support.objects.worked_objects import worked

CURVED = ("cylinder", "capsule", "sphere", "solid_dome", "ellipsoid")
PLACES = np.array([[0.0, 0.0], [3.0, -2.0], [-4.0, 1.5], [5.0, 5.0]])


def _heights(places: np.ndarray) -> np.ndarray:
    return np.column_stack([places, np.array([0.0, 0.7, -1.2, 2.0])])


@pytest.mark.parametrize("name", CURVED)
def test_points_come_back_from_the_object_s_frame(name):
    for frame in face_frames(body_spec(name)):
        given = _heights(PLACES)
        assert_allclose(frame.from_object(frame.to_object(given)), given, rtol=0, atol=1e-8)


def _gradient(name: str, points: np.ndarray) -> np.ndarray:
    """Outward normals of the implicit surfaces, in closed form."""
    half = {"sphere": [22.0] * 3, "solid_dome": [12.0] * 3, "ellipsoid": [30.0, 25.0, 22.0]}
    if name == "cylinder":
        wanted = np.column_stack([points[:, :2], np.zeros(len(points))])
    elif name == "capsule":
        wanted = points - np.clip(points[:, 2:], -12, 12) * [0, 0, 1]
    else:
        centre = [0, 0, -4.0] if name == "solid_dome" else [0, 0, 0]
        wanted = (points - centre) / np.square(half[name])
    return wanted / np.linalg.norm(wanted, axis=1, keepdims=True)


@pytest.mark.parametrize("name", CURVED)
def test_normals_are_those_of_the_implicit_surface(name):
    for frame in face_frames(body_spec(name)):
        if name == "cylinder" and frame.number in (1, 6):
            continue
        surface = frame.to_object(np.column_stack([PLACES, np.zeros(len(PLACES))]))
        axes = frame.axes_at(PLACES)
        assert_allclose(axes[..., 2], _gradient(name, surface), rtol=0, atol=1e-12)
        assert_allclose(np.swapaxes(axes, 1, 2) @ axes, np.tile(np.eye(3), (4, 1, 1)), atol=1e-12)
        assert_allclose(np.linalg.det(axes), 1, rtol=1e-12)


@pytest.mark.parametrize("name", CURVED)
def test_a_tangent_frame_touches_at_its_place_and_lies_outside_a_convex_body(name):
    frame = face_frames(body_spec(name))[-1]
    place = np.array([3.0, -2.0])
    tangent = frame.tangent(place)
    assert tangent.flat
    assert_allclose(
        tangent.to_object(np.append(place, 0.0)), frame.to_object(np.append(place, 0.0)), atol=1e-12
    )
    ring = place + 2.5 * np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
    points = tangent.to_object(np.column_stack([ring, np.zeros(4)]))
    on_face = frame.project_along(points, tangent.normal)
    assert_allclose(frame.relief.evaluate(on_face[:, :2])[0], on_face[:, 2], rtol=0, atol=1e-8)
    dropped = (on_face - frame.plane_coordinates(points)) @ (tangent.normal @ frame.axes)
    assert (dropped <= 1e-12).all()
    assert dropped.min() < -0.05


def test_lines_that_miss_a_patch_are_told():
    frame = face_frame(body_spec("sphere"), 1)
    beside = np.array([[40.0, 0.0, 22.0], [0.0, 3.0, 22.0]])
    assert np.isfinite(frame.project_along(beside, frame.normal)).all(axis=1).tolist() == [
        False,
        True,
    ]


@pytest.mark.parametrize("name", ["sphere", "dome_on_core", "cylinder", "capsule"])
def test_the_core_lies_one_thickness_below_every_place(name):
    spec = body_spec(name)
    for outer, inner in zip(face_frames(spec), core_frames(spec), strict=True):
        below = outer.to_object(np.column_stack([PLACES[:2], np.full(2, -spec.shell.thickness_mm)]))
        assert_allclose(inner.from_object(below)[:, 2], 0, rtol=0, atol=1e-9)


def test_an_ellipsoid_s_sampled_core_lies_one_thickness_below_every_place():
    spec = body_spec("ellipsoid")
    for outer, inner in zip(face_frames(spec), core_frames(spec), strict=True):
        below = outer.to_object(np.column_stack([PLACES, np.full(4, -spec.shell.thickness_mm)]))
        found = inner.from_object(below)
        assert abs(found[:, 2]).max() < 0.05
        turned = inner.axes_at(found[:, :2])[..., 2]
        assert_allclose(turned, outer.axes_at(PLACES)[..., 2], rtol=0, atol=0.02)


def test_magnets_and_sensors_stand_normal_to_the_surface():
    spec = body_spec("sphere")
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    depth = spec.shell.pocket_depth_mm - spec.magnets.height_mm / 2
    assert_allclose(np.linalg.norm(magnets.centre_mm, axis=1), 22 - depth, rtol=1e-12)
    outward = magnets.centre_mm / np.linalg.norm(magnets.centre_mm, axis=1, keepdims=True)
    assert_allclose(magnets.axis, outward, rtol=0, atol=1e-12)
    sink = np.concatenate(board_sinks_mm(spec))
    radius = 22 - spec.shell.thickness_mm - spec.sensors.depth_below_core_face_mm - sink
    assert_allclose(np.linalg.norm(sensors.position_mm, axis=1), radius, rtol=1e-12)
    assert_allclose(sensors.axes[:, 2] * radius[:, None], sensors.position_mm, rtol=0, atol=1e-9)


def test_a_capsule_s_side_is_a_cylinder_s_up_to_its_ends_and_a_ball_s_beyond():
    body = body_of(body_spec("capsule"))
    side, along = body.frame(3), np.array([[11.0, 4.0], [12.0, -4.0], [19.0, 6.0], [-25.0, 3.0]])
    beyond = np.array([[0.0, 4.0], [0.0, -4.0], [7.0, 6.0], [-13.0, 3.0]])
    height, slope = side.relief.evaluate(along)
    assert_allclose(height, np.sqrt(20**2 - (beyond**2).sum(axis=1)) - 20, rtol=0, atol=1e-12)
    assert_allclose(slope, -beyond / (20 + height)[:, None], rtol=0, atol=1e-12)
    points = side.to_object(np.column_stack([along, np.zeros(4)]))
    assert_allclose(body.core_distance_mm(points), 8, rtol=0, atol=1e-12)
    steepest = np.tan(np.deg2rad(60))
    assert_allclose(side.half_extents_mm, [12 + 20 * 3**0.5 / 2, 20 * 3**0.5 / 2], rtol=1e-12)
    turn = np.linspace(0, 2 * np.pi, 50)
    rim = side.half_extents_mm * np.column_stack([np.cos(turn), np.sin(turn)])
    assert np.linalg.norm(side.relief.evaluate(rim)[1], axis=1).max() == pytest.approx(steepest)


@pytest.mark.parametrize("name", ["box", "sphere"])
def test_what_faces_share_cannot_be_written_to(name):
    body = body_of(worked(name))
    for frame in (body.frame(2), body.core_frame(3)):
        for shared in (frame.axes, frame.lengths_mm):
            with pytest.raises(ValueError, match="read-only"):
                shared[0, 0] = 1.0


def test_a_patch_reaches_to_60_degrees_and_nowhere_without_a_cap():
    """On a ball R sin 60°; on an ellipse x² / a² + z² / c² = 1 where its slope is √3."""
    assert steepest_reach_mm(10.0, 10.0) == pytest.approx(10.0 * np.sin(np.pi / 3))
    reach = steepest_reach_mm(12.0, 5.0)
    slope = 5.0 / 12.0 * (reach / 12.0) / np.sqrt(1 - (reach / 12.0) ** 2)
    assert slope == pytest.approx(np.sqrt(3.0))
    assert steepest_reach_mm(0.0, 5.0) == steepest_reach_mm(-1.0, 5.0) == 0.0


def test_a_line_that_never_meets_the_surface_keeps_no_other_waiting():
    """Newton's steps go to and fro on a root: 60 of them for that line, not for the thousand others."""
    evaluated = []

    class HalfFlat:
        """Level at y > 0; elsewhere z = x − √x, which a line z = x crosses with a step of twice x."""

        def evaluate(self, xy_mm):
            evaluated.append(len(xy_mm))
            (x, y), root = xy_mm.T, np.sqrt(abs(xy_mm[:, 0]))
            with np.errstate(divide="ignore"):
                slope = np.where(y > 0, 0.0, 1 - 0.5 / root)
            return np.where(y > 0, 0.0, x - np.sign(x) * root), np.column_stack([slope, 0 * y])

    normal, x, y = np.array([0.0, 0.0, 1.0]), np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    frame = FaceFrame(1, normal, x, y, np.zeros(3), (10.0, 10.0), HalfFlat())
    points = np.tile([0.25, 1.0, 0.25], (1001, 1))
    points[500, 1] = -1.0
    met = frame.project_along(points, np.array([1.0, 0.0, 1.0]))
    assert np.isnan(met[500]).all()
    assert np.delete(met, 500, axis=0) == pytest.approx(np.tile([0.0, 1.0, 0.0], (1000, 1)))
    assert sum(evaluated) < 5_000
