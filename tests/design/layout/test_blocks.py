"""Keys on curved cores: all of their underside lies in the core; the seam of an ellipsoid."""

import numpy as np
import pytest

from design.layout.blocks import core_keys
from design.layout.body import body_of
from design.spec.object import ObjectSpec


@pytest.mark.parametrize("kind", ["sphere", "cylinder"])
@pytest.mark.parametrize("x", [-4.0, 4.0])
@pytest.mark.parametrize("y", [-4.0, 4.0])
def test_every_corner_of_a_key_s_underside_lies_in_the_core(kind, x, y):
    keys = {"positions_mm": [[x, y]], "size_mm": [3.0, 2.0, 1.5]}
    body = {"kind": kind, "size_mm": [44.0, 44.0, 44.0]}
    spec = ObjectSpec.model_validate({"name": "x", "body": body, "core": {"keys": keys}})
    found = core_keys(spec)
    assert len(found) == len(spec.body.sensed)
    for key in found:
        below = body_of(spec).core_distance_mm(key.corners_mm[:4])
        assert below.max() < -0.49
        assert body_of(spec).core_distance_mm(key.corners_mm[4:]).min() > 1.3


def test_an_ellipsoid_parts_across_its_shorter_axis():
    body = {"kind": "ellipsoid", "size_mm": [60.0, 50.0, 44.0]}
    ellipsoid = body_of(ObjectSpec.model_validate({"name": "x", "body": body}))
    for half, degrees in (((3.0, 2.0, 1.0), 90), ((2.0, 3.0, 1.0), 0), ((2.0, 2.0, 1.0), 45)):
        assert np.rad2deg(ellipsoid.parting_azimuth(np.array(half))) == pytest.approx(degrees)
