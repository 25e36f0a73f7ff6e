"""Jigs: bored bodies stand on their core, flat on flat; closed round ones lie in a cup."""

import numpy as np
import pytest
import trimesh

from design.body.imported import body_of_file
from design.body.meshes import manifold_of
from design.layout.body import body_of
from design.layout.core_hold import core_outlet
from design.solids.body import core_solid
from design.solids.booleans import convert_to_triangles
from design.solids.core import make_core
from design.solids.jig import (
    CLEAR_MM,
    PLATE_MM,
    RECESS_MM,
    axis_marks,
    bolt_holes,
    channel_solid,
    core_post,
    cup_solid,
    flat_seat_mm,
    make_jig,
    pedestal_mm,
    recess_solid,
)
from design.solids.primitives import OVERSHOOT_MM
from design.solids.sampled import sampled_core_part
from design.solids.shell import make_shell
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.support.objects.body_cases import body_spec
from tests.support.objects.worked_objects import worked
from tests.support.pages import ROOT

BORED = {"open_faces": [6], "bore_mm": 9.0}


def manifolds(spec):
    make = sampled_core_part if body_of(spec).sampled else make_core
    return manifold_of(convert_to_triangles(make_jig(spec))), manifold_of(
        convert_to_triangles(make(spec))
    )


@pytest.mark.parametrize("name", ["capsule", "ellipsoid"])
def test_a_post_through_the_bore_carries_the_core_and_keeps_it_from_turning(name):
    spec = body_spec(name, **({"body": BORED} if name == "ellipsoid" else {}))
    jig, core = manifolds(spec)
    assert (jig ^ core).volume() < 0.02
    assert (jig ^ core.translate((0, 0, -0.3))).volume() > 0.2, "the core rests on it"
    assert (jig ^ core.rotate((0, 0, 15))).volume() > 1
    assert (jig ^ core.translate((0, 0, 40))).volume() < 1e-6, "it lifts off"
    plate = jig.bounding_box()[2] + PLATE_MM
    lowest = float(body_of(spec).outer_surface().bounds[0, 2])
    assert lowest - plate - pedestal_mm(spec) == pytest.approx(CLEAR_MM, abs=0.05)


@pytest.mark.parametrize("name", ["paper_cube", "handle"])
def test_a_post_in_the_core_carries_a_body_with_an_open_side_on_its_pedestal(name):
    """The core is centred by its cavity, with the printer's clearance all round."""
    spec = load_spec(ROOT / "examples" / f"{name}.toml")
    jig, core = manifolds(spec)
    assert (jig ^ core).volume() < 0.02
    play = spec.printer.clearance_mm
    for way in ((1, 0, 0), (0, -1, 0), (0.7, 0.7, 0)):
        assert (jig ^ core.translate(np.multiply(0.8 * play, way))).volume() < 0.02
        assert (jig ^ core.translate(np.multiply(2 * play, way))).volume() > 1
    shell = manifold_of(convert_to_triangles(make_shell(spec)))
    assert (jig ^ shell).volume() < 0.02
    assert (jig ^ shell.translate((0, 0, -0.3))).volume() > 1, "the rim rests on the pedestal"
    assert (jig ^ core.translate((0, 0, 40))).volume() < 1e-6, "it lifts off"
    assert 0 < pedestal_mm(spec) < 12, "half of three tips' plate, 5 mm beyond its tips"


def test_a_pedestal_is_as_high_as_a_probe_comes_down_below_the_seat():
    """By hand, of a cube of 42 mm pressed at z = −1.5: of three tips 20 mm apart the plate ends 5 mm below
    the lower tip, which is 5 mm wide to each side. From above nothing comes down."""
    spec = ObjectSpec(name="cube").changed(contact_grid={"count": (2, 2), "pitch_mm": 3.0})
    wanted = 1.5 + (20 / 2 + 5 + 5) - 21 + CLEAR_MM
    assert pedestal_mm(spec) == pytest.approx(wanted, abs=0.01)
    top = spec.changed(body={"sensed_faces": [1]})
    assert pedestal_mm(top) == 0


def test_a_post_carries_a_core_that_is_lowest_beside_the_flats_middle(tmp_path):
    """A ball whose lower end leans by 24°, along its flat: at the post's side the core is lower than in
    the flat's middle, where alone the seat was looked for."""
    ball = trimesh.creation.icosphere(4, 22.0)
    ball.vertices[:, 2] += 0.45 * ball.vertices[:, 1]
    ball.export(tmp_path / "lopsided.stl")
    body = {"kind": "imported", **body_of_file(tmp_path / "lopsided.stl"), "bore_mm": 8.0}
    sensors = {"positions_mm": [[0.0, 0.0]], "radius_mm": 4.0}
    core = {"recess_inner_radius_mm": 1.5, "recess_outer_radius_mm": 6.5}
    body["sensed_faces"] = [1]
    spec = ObjectSpec.model_validate(
        {"name": "lopsided", "body": body, "sensors": sensors, "core": core}
    )
    jig, core = manifolds(spec)
    assert (jig ^ core).volume() < 0.02
    assert (jig ^ core.translate((0, 0, -0.3))).volume() > 0.005, "the core rests on it"


@pytest.mark.parametrize("name", ["sphere", "ellipsoid"])
def test_a_closed_round_body_lies_in_a_cup_and_drops_in_from_above(name):
    spec = body_spec(name, body={"open_faces": []})
    jig = manifold_of(convert_to_triangles(make_jig(spec)))
    body = manifold_of(body_of(spec).outer_surface())
    for height in (0.0, 2.0, 8.0):
        assert (jig ^ body.translate((0, 0, height))).volume() < 0.05
    for way in ((0.5, 0, 0), (0, -0.5, 0), (0, 0, -0.5)):
        assert (jig ^ body.translate(way)).volume() > 1


def test_a_dome_s_base_lies_in_a_round_recess():
    spec = body_spec("dome_on_core")
    jig = manifold_of(convert_to_triangles(make_jig(spec)))
    base = manifold_of(convert_to_triangles(core_solid(spec)))
    assert (jig ^ base).volume() < 1e-3
    assert (jig ^ base.translate((0.5, 0, 0))).volume() > 5


def bounds(solid):
    box = solid.BoundingBox()
    return [box.xmin, box.xmax, box.ymin, box.ymax, box.zmin, box.zmax]


@pytest.mark.parametrize(("height", "depth"), [(42.0, 10.0), (30.0, 8.5)])
def test_a_post_reaches_into_the_core_s_cavity_as_far_as_its_wall_lets_it(height, depth):
    """The core stands on its open face; the cavity ends a wall below its top."""
    spec = ObjectSpec(name="cube").changed(body={"size_mm": (42.0, 42.0, height)})
    core, play, top = spec.core_size_mm, spec.printer.clearance_mm, -height / 2
    assert core == (26.0, 26.0, height - 16.0)
    post, passage = core_post(spec, top)
    across, reach = 13.0 - 4.5 - play, -core[2] / 2 + depth
    sides = [-across, across] * 2
    assert bounds(post) == pytest.approx([*sides, top - PLATE_MM + 1, reach], abs=1e-6)
    inside = [-across + 3, across - 3] * 2
    below, above = top - PLATE_MM - OVERSHOOT_MM, reach + OVERSHOOT_MM
    assert bounds(passage) == pytest.approx([*inside, below, above], abs=1e-6)


def test_marks_bolts_and_channel_lie_where_the_plate_ends():
    half, top = 37.0, -21.0
    found = sorted([round(one, 6) for one in bounds(mark)] for mark in axis_marks(half, top))
    near, far, low, high = half - 16 + 2, half + OVERSHOOT_MM, top - 0.8, top + 1
    assert found == sorted(
        [
            [-far, -near, -0.5, 0.5, low, high], [near, far, -0.5, 0.5, low, high],
            [-0.5, 0.5, -far, -near, low, high], [-0.5, 0.5, near, far, low, high],
        ]
    )  # fmt: skip
    holes = bolt_holes(half, top, 6.0)
    middles = sorted((round(one.Center().x, 6), round(one.Center().y, 6)) for one in holes)
    assert middles == [(-30, -30), (-30, 30), (30, -30), (30, 30)]
    for hole in holes:
        assert hole.Volume() == pytest.approx(np.pi * 2.75**2 * (6 + 2 * OVERSHOOT_MM))
        assert hole.BoundingBox().zmax == pytest.approx(top + OVERSHOOT_MM, abs=1e-6)
    below = top - PLATE_MM
    wanted = [-4, 4, -half - OVERSHOOT_MM, 0, below - OVERSHOOT_MM, below + 3]
    assert bounds(channel_solid(half, top)) == pytest.approx(wanted, abs=1e-6)


def test_the_seat_of_a_bored_core_is_where_its_outlet_s_flat_ends():
    """On a ball, at the height of the circle about its axis through the flat."""
    spec = body_spec("sphere")
    core = spec.body.size_mm[0] / 2 - spec.shell.thickness_mm
    wanted = -np.sqrt(core**2 - core_outlet(spec).flat_mm ** 2)
    assert flat_seat_mm(spec) == pytest.approx(wanted, abs=0.02)


def test_a_recess_takes_the_lower_end_of_a_body_with_play_all_round():
    pad = body_spec("pad")
    play, top = pad.printer.clearance_mm, 5.0
    wanted = [-20 - play, 20 + play, -15 - play, 15 + play, top - RECESS_MM, top + OVERSHOOT_MM]
    assert bounds(recess_solid(pad, top)) == pytest.approx(wanted, abs=1e-6)
    dome = body_spec("dome_on_core")
    radius = 20 + dome.printer.clearance_mm
    wanted = [-radius, radius] * 2 + [top - RECESS_MM, top + OVERSHOOT_MM]
    assert bounds(recess_solid(dome, top)) == pytest.approx(wanted, abs=1e-6)


@pytest.mark.parametrize("name", ["closed sphere", "closed capsule"])
def test_a_cup_leaves_play_round_the_lower_end_and_opens_straight_upwards(name):
    """As wide at its top as where the body leaves the plate, and no wider to any side."""
    spec = worked(name)
    low, high = np.asarray(body_of(spec).outer_surface().bounds)
    top = low[2] + 6.0
    found, play = np.asarray(cup_solid(spec, top).bounds), spec.printer.clearance_mm
    radius, depth = high[0], top + RECESS_MM - low[2]
    wide = np.sqrt(radius**2 - max(0.0, radius - depth) ** 2) + play
    assert (abs(found[:, :2]) < wide + 0.05).all()
    assert (abs(found[:, :2]) > wide - 0.8).all(), "between the triangles' corners"
    np.testing.assert_allclose(found[0, 2], low[2] - play, atol=0.05)
    assert abs(found[0, :2] + found[1, :2]).max() < 0.05
    assert found[1, 2] > top + RECESS_MM
