"""Jigs: bored bodies stand on their core, flat on flat; closed round ones lie in a cup."""

import pytest

from design.body.meshes import manifold_of
from design.layout.body import body_of
from design.solids.body import core_solid
from design.solids.booleans import as_triangles
from design.solids.core import make_core
from design.solids.jig import CLEAR_MM, PLATE_MM, make_jig
from design.solids.sampled import sampled_core_part
from tests.support.objects.body_cases import body_spec

BORED = {"open_faces": [6], "bore_mm": 9.0}


def manifolds(spec):
    make = sampled_core_part if body_of(spec).sampled else make_core
    return manifold_of(as_triangles(make_jig(spec))), manifold_of(as_triangles(make(spec)))


@pytest.mark.parametrize("name", ["sphere", "capsule", "ellipsoid"])
def test_a_post_through_the_bore_carries_the_core_and_keeps_it_from_turning(name):
    spec = body_spec(name, **({"body": BORED} if name == "ellipsoid" else {}))
    jig, core = manifolds(spec)
    assert (jig ^ core).volume() < 0.02
    assert (jig ^ core.translate((0, 0, -0.3))).volume() > 0.2, "the core rests on it"
    assert (jig ^ core.rotate((0, 0, 15))).volume() > 1
    assert (jig ^ core.translate((0, 0, 40))).volume() < 1e-6, "it lifts off"
    plate = jig.bounding_box()[2] + PLATE_MM
    lowest = float(body_of(spec).outer_surface().bounds[0, 2])
    assert lowest - plate == pytest.approx(CLEAR_MM, abs=0.05)


@pytest.mark.parametrize("name", ["sphere", "ellipsoid"])
def test_a_closed_round_body_lies_in_a_cup_and_drops_in_from_above(name):
    spec = body_spec(name, body={"open_faces": []})
    jig = manifold_of(as_triangles(make_jig(spec)))
    body = manifold_of(body_of(spec).outer_surface())
    for height in (0.0, 2.0, 8.0):
        assert (jig ^ body.translate((0, 0, height))).volume() < 0.05
    for way in ((0.5, 0, 0), (0, -0.5, 0), (0, 0, -0.5)):
        assert (jig ^ body.translate(way)).volume() > 1


def test_a_dome_s_base_lies_in_a_round_recess():
    spec = body_spec("dome_on_core")
    jig = manifold_of(as_triangles(make_jig(spec)))
    base = manifold_of(as_triangles(core_solid(spec)))
    assert (jig ^ base).volume() < 1e-3
    assert (jig ^ base.translate((0.5, 0, 0))).volume() > 5
