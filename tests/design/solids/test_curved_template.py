"""Templates that hug curved faces: they lie on the body, open over every pocket and tell poles apart."""

from dataclasses import replace

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.body.meshes import thinnest_wall
from design.body.sampled import measured_distance_mm
from design.layout.body import face_frames
from design.layout.template_marks import pockets_by_face
from design.solids.curved_template import (
    curved_template_faces,
    make_curved_template,
    ring_lattice,
    row_lattice,
    sheet_half_mm,
)
from design.solids.magnet_template import PLATE_MM
from design.spec.object import ObjectSpec

PLACES = [[0, 0], [11, 0], [-7, 6]]


def parsed(kind, size, faces=(2, 3), **magnets):
    content = {"positions_mm": PLACES, "north": ["outward", "inward", "outward"], **magnets}
    body = {"kind": kind, "size_mm": size, "sensed_faces": list(faces)}
    return ObjectSpec.model_validate({"name": "t", "body": body, "magnets": content})


@pytest.fixture(scope="module")
def ball():
    return parsed("sphere", [60.0, 60.0, 60.0])


def test_a_template_of_a_ball_is_a_shell_of_its_radius(ball):
    assert curved_template_faces(ball) == {2: (2, 3)}
    template, play = make_curved_template(ball, 2), ball.printer.clearance_mm
    middle = np.array([0.0, 0.0, -30.0])
    radius = np.linalg.norm(np.asarray(template.vertices) - middle, axis=1)
    at_hand = radius[(abs(radius - 30) < 0.5)]
    assert_allclose(at_hand, 30 + play, atol=0.02)
    assert_allclose(radius.max(), 30 + play + PLATE_MM, atol=0.02)
    assert template.is_watertight
    assert len(template.split()) == 1


def test_it_opens_along_the_axis_of_every_pocket(ball):
    template, (frame, _) = make_curved_template(ball, 2), face_frames(ball)
    for xy in PLACES:
        along = frame.to_object(np.array([[*xy, 0.3], [*xy, PLATE_MM - 0.3]]))
        assert not template.contains(frame.plane_coordinates(along)).any()
    beside = frame.to_object(np.array([[-12.0, -4.0, 1.5], [4.0, -5.0, 1.5]]))
    assert template.contains(frame.plane_coordinates(beside)).all()


def test_minus_lacks_the_second_bar_of_plus(ball):
    other = parsed("sphere", [60.0, 60.0, 60.0], north=["outward"] * 3)
    removed = make_curved_template(ball, 2).volume - make_curved_template(other, 2).volume
    assert_allclose(removed, 2 * 1.05 * 0.9 * 0.8, rtol=0.05)


def test_faces_of_other_curvature_have_templates_of_their_own():
    capsule = parsed("capsule", [50.0, 50.0, 80.0], faces=[1, 2, 3])
    assert curved_template_faces(capsule) == {1: (1,), 2: (2, 3)}


@pytest.mark.parametrize(
    ("lattice", "area"), [(row_lattice(5), 4.0), (ring_lattice(8), 16 / 2 * np.sin(2 * np.pi / 16))]
)
def test_triangles_cover_the_sheet_once_and_the_rim_runs_round_it(lattice, area):
    """Seen from outside all turn to the left; the rim is as long as the sheet's border."""
    a, b, c = lattice.share[lattice.triangles].transpose(1, 0, 2)
    (u, v), (w, t) = (b - a).T, (c - a).T
    turned = (u * t - v * w) / 2
    assert turned.min() > 1e-6
    assert_allclose(turned.sum(), area)
    assert set(lattice.triangles.ravel()) == set(range(len(lattice.share)))
    border = lattice.share[lattice.rim]
    x, y = border.T
    assert_allclose(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) / 2, area)
    assert len(set(lattice.rim.tolist())) == len(lattice.rim)
    edges = np.sort(
        np.concatenate([lattice.triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1
    )
    times = np.unique(edges, axis=0, return_counts=True)[1]
    assert set(times) == {1, 2}
    assert (times == 1).sum() == len(lattice.rim)


def test_a_sheet_as_large_as_its_face_keeps_within_what_is_known_of_the_surface(ball):
    """Of a body from a file nothing is known beyond the ellipse, where rounding had put some of the rim."""
    (frame, pockets), _ = pockets_by_face(ball)
    share, beyond = ring_lattice(49).share, 0
    for half in ((16.1, 15.3), (16.14, 15.14), (16.23, 15.35), (16.17, 15.29)):
        small = replace(frame, half_extents_mm=half)
        sheet = np.array(sheet_half_mm(small, pockets))
        assert_allclose(sheet, half, rtol=1e-8)
        inside = (share * sheet / half) ** 2
        assert inside.sum(axis=1).max() <= 1
        beyond += int(np.sum((share**2).sum(axis=1) > 1))
    assert beyond > 0, "the rim itself is on the border, to rounding"


def test_marks_keep_off_a_round_rim():
    """The second bars of + are what templates of − have more; a rim beyond them is 1.25 mm wide at least."""
    places = [[0, 0], [27.7, 8.2], [-27.7, 8.2], [-27.7, -8.2], [27.7, -8.2]]
    plus, minus = (
        parsed("ellipsoid", [95.0, 50.0, 194.0], [3], positions_mm=places, north=[north] * 5)
        for north in ("outward", "inward")
    )
    bars = trimesh.boolean.difference(
        [make_curved_template(minus, 3), make_curved_template(plus, 3)], engine="manifold"
    )
    ((frame, pockets),) = pockets_by_face(plus)
    half = np.array(sheet_half_mm(frame, pockets))
    ring = np.column_stack([np.cos(angle := np.linspace(0, 2 * np.pi, 400)), np.sin(angle)]) * half
    ends = np.asarray(bars.vertices)[:, :2]
    assert np.linalg.norm(ends / half, axis=1).max() < 1
    assert np.linalg.norm(ends[:, None] - ring, axis=2).min() > 1.25


def test_a_sheet_on_a_rounded_edge_can_be_printed_and_keeps_its_play(tmp_path):
    """Pockets reach to the edges of a carton's narrow face, where normals cross each other.

    Half of the play is left in the middle of triangles, which cut the edge short.
    """
    corners = trimesh.creation.box((70.9, 25.4, 82.8)).vertices
    balls = [trimesh.creation.icosphere(3, 1.5) for _ in corners]
    points = [ball.vertices + corner for ball, corner in zip(balls, corners, strict=True)]
    carton = trimesh.convex.convex_hull(np.concatenate(points))
    carton.export(tmp_path / "carton.stl")
    places = [[0, 0], [19.35, 7.46], [-19.35, 7.46], [-19.35, -7.46], [19.35, -7.46]]
    body = {"kind": "imported", "file": str(tmp_path / "carton.stl"), "sensed_faces": [1, 3]}
    spec = ObjectSpec.model_validate(
        {
            "name": "t",
            "body": body | {"size_mm": carton.extents.tolist()},
            "magnets": {"positions_mm": places},
            "shell": {"thickness_mm": 7.0, "pocket_depth_mm": 4.0},
        }
    )
    play = spec.printer.clearance_mm
    for frame in face_frames(spec):
        template = make_curved_template(spec, frame.number)
        wall = thinnest_wall(template)
        assert wall is not None
        assert wall.thickness_mm > spec.printer.wall_mm
        corners, middles, edges = (
            measured_distance_mm(carton, frame.centre_mm + points @ frame.axes.T).min()
            for points in (
                template.vertices,
                template.triangles_center,
                template.vertices[template.edges_unique].mean(axis=1),
            )
        )
        assert corners > 0.95 * play
        assert min(middles, edges) > 0.5 * play
