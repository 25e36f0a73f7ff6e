"""The judge of ways: each planted fault is told, and sound parts pass."""

import manifold3d
import numpy as np
import pytest
import trimesh

from design.body.meshes import manifold_of
from design.build.parts import parts_of
from design.layout.boards import wire_channels
from design.layout.body import body_of
from design.layout.places.positions import board_places
from design.mould.openings import mould_holes
from design.solids import booleans
from design.solids.booleans import convert_to_triangles
from design.spec_io import parse_spec
from tests.random_designs.openings import (
    _blocked_sides,
    _rod,
    blocked_ways,
    left_over,
    meeting_pins,
    placed_pins,
    stray_pieces,
    thin_covers,
)

BALL = {
    "name": "ball",
    "body": {"kind": "sphere", "size_mm": [50.0, 50.0, 50.0], "sensed_faces": [1, 3]},
    "magnets": {"positions_mm": [[-6.0, 0.0], [7.0, 0.0]]},
    "contact_grid": {"count": "fill"},
    "core": {
        "recess_inner_radius_mm": 2.4,
        "recess_outer_radius_mm": 8.9,
        "wire_hole_top_diameter_mm": 2.0,
        "wall_mm": 5.5,
    },
    "sensors": {"count_per_face": 2, "radius_mm": 5.6},
}
BOX = {
    "name": "box",
    "body": {"kind": "box", "size_mm": [40.0, 40.0, 40.0], "sensed_faces": [1]},
    "magnets": {"positions_mm": [[0.0, 0.0]]},
    "sensors": {"count_per_face": 1},
    "core": {"wire_channel_mm": [2.0, 1.0]},
}


COARSE = (0.02, 0.2)
"""Triangles within 20 µm, of which the ball's parts have a quarter as many as within 5 µm."""


def made(content):
    spec = parse_spec(content, "test")
    wanted = {p.name: p for p in parts_of(spec) if p.name.startswith(("core", "shell", "mould"))}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(booleans, "FINENESS", COARSE)
        parts = {name: convert_to_triangles(part.make()) for name, part in wanted.items()}
    solids = {name: manifold_of(mesh) for name, mesh in parts.items()}
    return spec, solids, placed_pins(spec, parts)


@pytest.fixture(scope="module")
def ball():
    return made(BALL)


@pytest.fixture(scope="module")
def box():
    return made(BOX)


def all_told(spec, solids, pins):
    thin = thin_covers(spec, body_of(spec).outer_surface())
    left = left_over(spec, solids, pins)
    return [*thin, *blocked_ways(spec, solids, pins), *meeting_pins(solids, pins), *left]


def ball_at(place, radius=0.8):
    return manifold3d.Manifold.sphere(radius, 24).translate(tuple(place))


def channels_of(spec):
    ((frame, places),) = board_places(spec)
    return frame, [place for place, _ in places]


def test_a_sound_ball_and_box_are_sound(ball, box):
    assert all_told(*ball) == []
    assert all_told(*box) == []


def test_what_stands_in_a_hole_of_the_mould_is_told(ball):
    spec, solids, pins = ball
    for k, hole in enumerate(mould_holes(spec), start=1):
        way = hole.end_mm - hole.top_mm
        plugged = ball_at(hole.top_mm + 3.0 * way / np.linalg.norm(way)) + solids["mould_half_a"]
        told = blocked_ways(spec, solids | {"mould_half_a": plugged}, pins)
        assert [text[: text.index(":")] for text in told] == [
            f"mould_half_a is in the way of {hole.use} hole {k}"
        ]


def test_a_core_without_its_wire_holes_is_told(ball, box):
    spec, solids, pins = ball
    told = blocked_ways(spec, solids | {"core": solids["core"].hull()}, pins)
    assert [text.split(": ")[0].split("of ", 1)[1] for text in told] == [
        "wire hole of face 1",
        "wire hole of face 3",
        "the outlet of the wires",
    ]
    spec, solids, pins = box
    (channel,) = wire_channels(spec, *channels_of(spec), 0.0)
    filled = solids["core"] + ball_at(channel.centre_mm)
    (told,) = blocked_ways(spec, solids | {"core": filled}, pins)
    assert told.startswith("core is in the way of channel 1 of face 1")


def test_a_side_that_nothing_leads_out_of_is_told(box):
    """Of a box open at −z, and by made-up solids of one open at +x and +y, where one way is enough."""
    spec, solids, pins = box
    for part in ("core", "shell"):
        shut = solids | {part: solids[part] + ball_at(np.array([0.0, 0.0, -12.0]))}
        (told,) = blocked_ways(spec, shut, pins)
        assert told.startswith(f"{part} is in the way of the way out of side 6"), told
    spec = spec.changed(body=spec.body.changed(open_faces=[3, 4]))
    across, along = (_rod(np.zeros(3), 30 * way, 2.0) for way in np.eye(3)[:2])
    block = manifold3d.Manifold.cube((30.0, 30.0, 30.0), True)
    for open_ways, count in (([across], 0), ([along], 0), ([across, along], 0), ([], 2)):
        core = block - manifold3d.Manifold.batch_boolean(open_ways, manifold3d.OpType.Add)
        assert len(_blocked_sides(spec, {"core": core})) == count


def test_pins_that_meet_each_other_or_the_mould_are_told(ball):
    _, solids, pins = ball
    longer = pins | {"pin 1": pins["pin 2"].translate((0.5, 0.0, 0.0))}
    told = meeting_pins(solids, longer)
    assert any(text.startswith("pin 2 is in the way of pin 1") for text in told)
    told = meeting_pins(solids, pins | {"pin 1": pins["pin 1"].translate((0.0, 0.0, -1.0))})
    assert any(text.startswith("shell is in the way of pin 1") for text in told)
    assert len(pins) == 4


def test_room_that_the_mould_leaves_is_told(ball, box):
    spec, solids, pins = ball
    (told,) = left_over(spec, solids, {name: pins[name] for name in list(pins)[1:]})
    assert told.startswith("the mould leaves")
    spec, solids, pins = box
    (plugless,) = left_over(
        spec, {name: solid for name, solid in solids.items() if name != "mould_plug"}, pins
    )
    assert plugless.startswith("the mould leaves")
    shrunk = solids["shell"].trim_by_plane((1.0, 0.0, 0.0), -19.0)
    assert left_over(spec, solids | {"shell": shrunk}, pins)


def test_a_plug_without_slots_is_told(box):
    spec, solids, pins = box
    lid = manifold3d.Manifold.cube((40.0, 40.0, 2.0), True).translate((0.0, 0.0, -21.5))
    told = blocked_ways(spec, solids | {"mould_plug": solids["mould_plug"] + lid}, pins)
    assert told == ["no slot to pour into is left"]


def test_silicone_over_a_magnet_thinner_than_told_is_told(ball):
    spec, _, _ = ball
    outer = body_of(spec).outer_surface()
    dented = outer.difference(
        trimesh.creation.cylinder(1.0, 1.0, sections=32).apply_translation([7.0, 0.0, 24.0])
    )
    assert thin_covers(spec, dented)[0].endswith("mm told")
    assert "magnet" in thin_covers(spec, dented)[0]


def test_silicone_beside_a_deep_magnet_is_a_wall_and_no_cover():
    """Of seed 65 of the second generator: the side of a pad lies nearer than its face."""
    pad = {
        "name": "pad",
        "body": {"kind": "pad", "size_mm": [54.0, 54.0, 38.0]},
        "shell": {"thickness_mm": 31.0, "pocket_depth_mm": 20.0},
        "sensors": {"positions_mm": [[0.0, 0.0]]},
    }
    spec = parse_spec(pad | {"magnets": {"positions_mm": [[21.0, 0.0]]}}, "test")
    outer = body_of(spec).outer_surface()  # 3.0 mm to the side, 4.7 on the way of the judge's rays
    assert thin_covers(spec, outer) == []
    (told,) = thin_covers(spec.changed(silicone={"thinnest_wall_mm": 5.5}), outer)
    assert "mm of silicone beside magnets.positions_mm[0]" in told


def test_a_wire_hole_of_a_core_without_a_cavity_ends_at_its_axis():
    """Of seed 202 of the second generator: its wall is thicker than the core's radius, and the wires
    leave along the axis."""
    spec = parse_spec(
        {
            "name": "stick",
            "body": {"kind": "cylinder", "size_mm": [22.8, 22.8, 86.9], "sensed_faces": [2]},
            "shell": {"thickness_mm": 6.0, "pocket_diameter_mm": 4.0},
            "magnets": {"diameter_mm": 4.0, "positions_mm": [[0.0, 0.0]]},
            "core": {
                "wall_mm": 5.5,
                "wire_hole_top_diameter_mm": 2.5,
                "wire_hole_side_diameter_mm": 3.0,
            },
            "sensors": {"positions_mm": [[-8.24, 0.0], [8.24, 0.0]]},
            "press": {"depths_mm": [0.5, 1.0]},
        },
        "test",
    )
    core = next(part for part in parts_of(spec) if part.name == "core")
    solid = manifold_of(convert_to_triangles(core.make()))
    assert blocked_ways(spec, {"core": solid}, {}) == []
    plugged = solid + ball_at([0.0, -3.0, 0.0])
    (told,) = blocked_ways(spec, {"core": plugged}, {})
    assert told.startswith("core is in the way of wire hole of face 2")


def test_a_piece_that_lies_in_a_part_is_no_room_left_over():
    """As a boolean of walls upon walls gave one that lay in the shell of random design 602."""
    shell = manifold3d.Manifold.cube((10.0, 10.0, 10.0))
    within = manifold3d.Manifold.cube((2.0, 2.0, 2.0)).translate((4.0, 4.0, 4.0))
    beside = within.translate((20.0, 0.0, 0.0))
    half_out = within.translate((5.0, 0.0, 0.0))
    assert not stray_pieces(within, [shell])
    ((volume, place),) = stray_pieces(within + beside, [shell])
    assert volume == pytest.approx(8.0)
    np.testing.assert_allclose(place, [25.0, 5.0, 5.0])
    ((volume, _),) = stray_pieces(half_out, [shell])
    assert volume == pytest.approx(4.0)
