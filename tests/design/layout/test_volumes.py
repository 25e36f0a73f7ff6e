"""The sealed body's volume by formula: keys and slits are left out; against its triangles."""

import pytest
from numpy.testing import assert_allclose

from design.layout.surface import sealed_body_surface
from design.layout.volumes import sealed_volume_mm3
from design.spec.object import ObjectSpec

KEYS = {"positions_mm": [[3.0, 9.0], [-9.0, 2.0]], "size_mm": [3.0, 2.0, 1.5]}
SLITS = {"width_mm": 1.5, "depth_mm": 4.0}


def volume(body, **parts):
    spec = ObjectSpec.model_validate({"name": "x", "body": body, **parts})
    found = sealed_volume_mm3(spec)
    assert_allclose(sealed_body_surface(spec).volume, found, rtol=2e-3)
    return found


def test_keys_of_a_box_take_their_own_volume_on_every_face():
    box = {"size_mm": [42.0, 44.0, 46.0]}
    assert volume(box) - volume(box, core={"keys": KEYS}) == pytest.approx(5 * 2 * 3 * 2 * 1.5)


def test_keys_of_a_ball_take_what_of_them_stands_out_of_the_core():
    """A little more than on a flat face: the core sinks beside their middle."""
    ball = {"kind": "sphere", "size_mm": [44.0, 44.0, 44.0]}
    taken = volume(ball) - volume(ball, core={"keys": KEYS})
    assert 1.0 < taken / (5 * 2 * 9.0) < 1.2


@pytest.mark.parametrize(("open_faces", "edges"), [([6], 8), ([], 12)])
def test_slits_run_along_the_edges_between_sensed_faces(open_faces, edges):
    """Triangles of 4 mm less half of them, 1.5 mm wide, from 8 mm off the corners or an open face."""
    box = {"size_mm": [42.0, 44.0, 46.0], "open_faces": open_faces}
    plain, slit = volume(box), volume(box, shell={"slits": SLITS})
    along = {"x": 42 - 16, "y": 44 - 16, "z": 46 - (16 if not open_faces else 8)}
    level = 4 if not open_faces else 2
    length = level * (along["x"] + along["y"]) + 4 * along["z"]
    assert edges == 2 * level + 4
    deep = 4.0 * 1.5 - 1.5**2 / 4  # the edge itself is a right angle
    assert plain - slit == pytest.approx(length * deep, rel=0.02)
