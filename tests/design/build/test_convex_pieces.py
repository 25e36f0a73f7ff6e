"""Convex pieces hold a body, are convex, and reach no farther beyond it than they say."""

import numpy as np
import pytest
import trimesh

from design.build.convex_pieces import convex_pieces


def dumbbell():
    ends = [
        trimesh.creation.icosphere(2, 20).apply_translation((0, y, z)) for y, z in ((0, 0), (5, 45))
    ]
    bar = trimesh.creation.cylinder(8, 45).apply_translation((0, 2, 22))
    return trimesh.boolean.union([*ends, bar], engine="manifold")


@pytest.fixture(scope="module")
def cut():
    return dumbbell(), convex_pieces(dumbbell(), 1.0, 32)


def inside(pieces, points, margin):
    """Return whether points lie in a piece or no farther than the margin outside its planes."""
    heights = [
        (points[:, None] - piece.triangles_center) @ np.eye(3) * piece.face_normals
        for piece in pieces
    ]
    return np.any([(height.sum(axis=2) <= margin).all(axis=1) for height in heights], axis=0)


def test_a_convex_body_is_one_piece_without_error():
    convex = convex_pieces(trimesh.creation.icosphere(3, 20), 0.5, 8)
    assert (len(convex.pieces), convex.error_mm) == (1, 0.0)


def test_pieces_are_convex_and_together_hold_the_body(cut):
    body, convex = cut
    assert len(convex.pieces) > 1
    assert all(piece.is_convex for piece in convex.pieces)
    assert inside(convex.pieces, np.asarray(body.vertices), 1e-3).all()
    assert inside(convex.pieces, body.triangles_center, 1e-3).all()


def test_pieces_reach_no_farther_than_they_say(cut):
    _, convex = cut
    assert 0 < convex.error_mm <= 1.0
    points = np.concatenate(
        [trimesh.sample.sample_surface(piece, 3000, seed=1)[0] for piece in convex.pieces]
    )
    # points farther from the body than said; the ball and the bar give the distance in closed form
    to_bar = np.linalg.norm(points[:, :2] - [0, 2], axis=1) - 8
    beyond_end = abs(points[:, 2] - 22) - 22.5
    bar = np.where(beyond_end < 0, to_bar, np.hypot(to_bar.clip(0), beyond_end))
    balls = [np.linalg.norm(points - [0, y, z], axis=1) - 20 for y, z in ((0, 0), (5, 45))]
    # balls of triangles lie up to 0.25 mm within the round ones
    assert np.minimum(bar, np.min(balls, axis=0)).max() < convex.error_mm + 0.05
    assert np.minimum(bar, np.min(balls, axis=0)).max() > 0.5 * convex.error_mm


def test_fewer_pieces_than_the_tolerance_needs_say_a_larger_error(cut):
    few = convex_pieces(dumbbell(), 1.0, 2)
    assert len(few.pieces) == 2
    assert few.error_mm > cut[1].error_mm


def test_separate_bodies_are_pieces_of_their_own():
    boxes = [trimesh.creation.box((4, 4, 4)).apply_translation((x, 0, 0)) for x in (0, 10)]
    convex = convex_pieces(trimesh.util.concatenate(boxes), 0.1, 8)
    assert (len(convex.pieces), convex.error_mm) == (2, 0.0)
