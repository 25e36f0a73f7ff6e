"""A board that a search turns over lies on the floor of its recess, and nearer the magnets."""

import pytest
from numpy.testing import assert_allclose

from design.layout.places.positions import sensor_layout
from design.search.structure import with_structure
from design.spec_io import parse_spec

START = {"recess_depth_mm": 3.2}


@pytest.mark.parametrize(("chip", "depth"), [("outward", 0.9), ("inward", 2.3)])
def test_turning_a_board_over_mirrors_the_chip_within_its_recess(chip, depth):
    spec = parse_spec({"name": "cube", "core": START}, "made up")
    turned = with_structure(spec, {"sensor_chip": chip})
    assert turned.sensors.chip == chip
    assert turned.sensors.depth_below_core_face_mm == pytest.approx(depth)
    nearer = sensor_layout(turned).position_mm[0] - sensor_layout(spec).position_mm[0]
    assert_allclose(nearer, [0, 0, 2.3 - depth], rtol=0, atol=1e-12)  # face 1 looks along +z
    back = with_structure(turned, {"sensor_chip": "inward"})
    assert back.sensors.depth_below_core_face_mm == pytest.approx(2.3)
