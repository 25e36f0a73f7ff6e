"""Joint presses along a path: as single ones, corrected face by face, and refused where unknown."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from fem.large_strain.correction import StrainCorrection, corrected_joint
from fem.presses.joint import Tip, press_path, press_tips, refined_faces
from fem.presses.to_force import press_to_force, squeeze_path
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import coarse_spec

SPEC = coarse_spec(silicone={"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.4999})
TIPS = (Tip(2, -7.0, 1.0), Tip(2, 8.0, -2.0), Tip(3, 0.5, 3.0))
DEPTHS = np.array([[0.6, 0.8, 0.4], [1.5, 2.0, 1.0]])


@pytest.fixture(scope="module")
def response():
    return half_space_response(SPEC, 13, between_faces=0.2)


def test_a_path_is_its_presses(response):
    faces = refined_faces(SPEC, response)
    path = press_path(SPEC, response, TIPS, DEPTHS, faces)
    for depths, press in zip(DEPTHS, path, strict=True):
        alone = press_tips(SPEC, response, TIPS, depths)
        assert_allclose(press.force_n, alone.force_n, rtol=1e-10)
        assert_allclose(press.motion, alone.motion, atol=1e-12)


def test_a_squeeze_from_a_warm_start_is_the_same(response):
    jaws = ((Tip(3, -7.5, 2.0), Tip(3, 7.5, 2.0)), (Tip(5, 0.0, -2.0),))
    path = squeeze_path(SPEC, response, jaws, (1.0, 4.0))
    for force, press in zip((1.0, 4.0), path, strict=True):
        cold = press_to_force(SPEC, response, jaws, force)
        assert_allclose(press.force_n[:2].sum(), force, rtol=3e-6)
        assert_allclose(press.force_n[2], force, rtol=3e-6)
        assert_allclose(press.depth_mm, cold.depth_mm, rtol=1e-4)


def test_each_face_is_corrected_with_its_own_depth(response):
    """F (1 + x a) and ω (1 + e x), with x the depth of the face over the shell's thickness."""
    path = press_path(SPEC, response, TIPS, DEPTHS)
    force = np.stack([press.force_n for press in path])
    motion = np.stack([press.motion for press in path])
    faces = np.array([tip.face for tip in TIPS])
    correction = StrainCorrection(8.0, (0.4, 0.0), (0.0, 0.0), (0.3,))
    found, moved = corrected_joint(SPEC, faces, DEPTHS, force, motion, correction)
    deepest = np.stack([DEPTHS[:, :2].max(axis=1)] * 2 + [DEPTHS[:, 2]], axis=1)
    assert_allclose(found, force * (1 + 0.4 * deepest / 8), rtol=1e-12)
    owner = np.asarray(shell_body_layout(SPEC).face)
    for face, depth in ((2, deepest[:, 0]), (3, deepest[:, 2])):
        expected = motion[:, owner == face, 3:] * (1 + 0.3 * depth / 8)[:, None, None]
        assert_allclose(moved[:, owner == face, 3:], expected, rtol=1e-12)
    assert_allclose(moved[..., :3], motion[..., :3], rtol=1e-12)
    assert {frame.number for frame in face_frames(SPEC)} >= {2, 3}


def test_no_correction_changes_nothing(response):
    (press,) = press_path(SPEC, response, TIPS, DEPTHS[1:])
    faces = np.array([tip.face for tip in TIPS])
    arrays = (press.force_n[None], press.motion[None])
    found = corrected_joint(SPEC, faces, DEPTHS[1:], *arrays, StrainCorrection(8.0))
    for one, other in zip(found, arrays, strict=True):
        np.testing.assert_array_equal(one, other)
