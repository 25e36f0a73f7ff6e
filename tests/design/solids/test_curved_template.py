"""Templates that hug curved faces: they lie on the body, open over every pocket and tell poles apart."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.mould_frame import play_mm
from design.solids.curved_template import curved_template_faces, make_curved_template
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
    template, play = make_curved_template(ball, 2), play_mm(ball)
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
        assert not template.contains(frame.in_plane(along)).any()
    beside = frame.to_object(np.array([[-12.0, -4.0, 1.5], [4.0, -5.0, 1.5]]))
    assert template.contains(frame.in_plane(beside)).all()


def test_minus_lacks_the_second_bar_of_plus(ball):
    other = parsed("sphere", [60.0, 60.0, 60.0], north=["outward"] * 3)
    removed = make_curved_template(ball, 2).volume - make_curved_template(other, 2).volume
    assert_allclose(removed, 2 * 1.05 * 0.9 * 0.8, rtol=0.05)


def test_faces_of_other_curvature_have_templates_of_their_own():
    capsule = parsed("capsule", [50.0, 50.0, 80.0], faces=[1, 2, 3])
    assert curved_template_faces(capsule) == {1: (1,), 2: (2, 3)}
