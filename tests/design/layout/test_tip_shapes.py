"""Probes of every kind of indenter: the solid's underside is the profile that contact uses."""

import cadquery as cq
import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.tips import (
    footprint_mm,
    tip_heights_mm,
    tip_positions_mm,
    tip_shape,
    tips_overlap,
)
from design.solids.probes import make_probe
from design.spec.object import ContactGridSpec, IndenterSpec, ObjectSpec

PYRAMID = ((0.0, 0.0, 0.0), (5.0, 1.0, 7.0), (-4.0, 3.0, 7.0), (-3.0, -4.0, 7.0))
KINDS = [
    {"kind": "flat", "radius_mm": 4.0},
    {"kind": "flat", "radius_mm": 4.0, "fillet_mm": 1.5, "turn_deg": (0.0, 0.0, 8.0)},
    {"kind": "cylinder", "radius_mm": 3.0, "size_mm": (8.0, 9.0), "turn_deg": (35.0, 0.0, 0.0)},
    {"kind": "cuboid", "size_mm": (9.0, 5.0), "fillet_mm": 1.0, "turn_deg": (0.0, -6.0, 4.0)},
    {"kind": "ellipsoid", "size_mm": (12.0, 8.0), "radius_mm": 6.0, "turn_deg": (0.0, 15.0, -10.0)},
    {"kind": "stl", "vertices_mm": PYRAMID, "turn_deg": (20.0, 0.0, 0.0)},
]


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind["kind"])
def test_the_solid_s_underside_is_the_profile(kind):
    indenter = IndenterSpec(**kind)
    grid = ContactGridSpec(count=(4, 4))
    probe = make_probe(ObjectSpec(name="probe", indenter=indenter, contact_grid=grid), 1)
    assert probe.isValid()
    assert_allclose(probe.BoundingBox().zmin, 0, rtol=0, atol=2e-3)
    low, high = footprint_mm(indenter)
    places = np.random.default_rng(5).uniform(0.9 * low, 0.9 * high, (4000, 2))
    heights = tip_heights_mm(tip_shape(indenter), places)
    touching = np.flatnonzero(heights < 0.6)[:40]
    assert len(touching) > 5
    for x, y, z in np.column_stack([places, heights])[touching].tolist():
        assert probe.isInside(cq.Vector(x, y, z + 0.02))
        assert not probe.isInside(cq.Vector(x, y, z - 0.02))


def test_the_rim_belongs_to_the_tip():
    square = tip_shape(IndenterSpec(kind="cuboid", size_mm=(9.0, 5.0)))
    rim = np.array([(x, y) for x in (-4.5, 0.0, 4.5) for y in (-2.5, 2.5)])
    assert_allclose(tip_heights_mm(square, rim), 0, rtol=0, atol=1e-9)
    assert np.isinf(tip_heights_mm(square, 1.001 * rim)).all()


def test_three_cuboids_stand_where_the_paper_s_tips_stand():
    indenter = IndenterSpec(kind="cuboid", size_mm=(4.0, 2.0), tip_count=3)
    spec = ObjectSpec(name="probe", indenter=indenter, contact_grid=ContactGridSpec(count=(6, 6)))
    probe = make_probe(spec, 3)
    radius = 20 / np.sqrt(3)
    for angle in np.deg2rad([90, 210, 330]):
        x, y = radius * np.cos(angle), radius * np.sin(angle)
        assert probe.isInside(cq.Vector(x + 1.9, y - 0.9, 0.01))
        assert not probe.isInside(cq.Vector(x + 2.1, y, 0.01))


@pytest.mark.parametrize(
    ("tips", "offset_mm", "overlap"),
    [
        (1, (4.0, 0.0), False),
        (1, (3.99, 0.0), True),
        (1, (0.0, -2.0), False),
        (1, (0.0, -1.99), True),
        (1, (3.9, 1.9), True),
        (2, (4.01, 0.0), False),
        (2, (10.99, 0.0), False),
        (2, (-11.01, 0.0), True),
        (2, (18.99, 0.0), True),
        (2, (19.01, 0.0), False),
        (2, (15.0, 2.01), False),
        (3, (10.0, 15.31), False),
        (3, (10.0, 15.33), True),
    ],
)
def test_cuboids_overlap_where_any_two_of_their_tips_do(tips, offset_mm, overlap):
    """Tips of 4 × 2 mm, one, two 15 mm apart along x, or three (rows 10√3 = 17.32 mm apart)."""
    indenter = IndenterSpec(kind="cuboid", size_mm=(4.0, 2.0), tip_count=tips)
    assert tips_overlap(indenter, np.array(offset_mm)) is overlap


@pytest.mark.parametrize(
    ("radius_mm", "spacing_mm", "two", "three"),
    [(4.9, None, 15.0, 20.0), (5.1, None, 15.3, 20.4), (2.0, 7.0, 7.0, 7.0)],
)
def test_tips_are_15_or_20_mm_apart_or_3_and_4_radii(radius_mm, spacing_mm, two, three):
    assert_allclose(tip_positions_mm(1, radius_mm, spacing_mm), [[0, 0]])
    assert_allclose(tip_positions_mm(2, radius_mm, spacing_mm), [[-two / 2, 0], [two / 2, 0]])
    places = tip_positions_mm(3, radius_mm, spacing_mm)
    apart = np.linalg.norm(places - np.roll(places, 1, axis=0), axis=1)
    assert_allclose(apart, three)
    assert_allclose(places.sum(axis=0), 0, atol=1e-12)
    assert_allclose(places[0], [0, three / np.sqrt(3)], atol=1e-12)
