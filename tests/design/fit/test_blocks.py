"""Keys, slits and a bay of a cylinder, each at its border: blocks by hand in place of the derived ones."""

import numpy as np
import pytest

from design.body.triangles import Block
from design.fit import blocks as fit_blocks
from design.fit import parts
from design.fit.blocks import check_bay, check_keys, check_slits
from design.layout.body import core_frames
from design.layout.pockets import shell_pockets
from design.spec.object import ObjectSpec
from tests.support.objects.worked_objects import worked

CYLINDER = {
    "body": {"kind": "cylinder", "size_mm": [44.0, 44.0, 60.0]},
    "core": {
        "recess_inner_radius_mm": 5.0,
        "recess_outer_radius_mm": 9.0,
        "keys": {"positions_mm": [[0.0, 0.0]], "size_mm": [3.0, 3.0, 1.5]},
    },
    "sensors": {"radius_mm": 7.0},
    "shell": {"slits": {"depth_mm": 4.0}},
    "magnets": {"positions_mm": [[0.0, 0.0]]},
}
"""Core of Ø28, 44 mm high, open below; shell of 8 mm."""


def cylinder(**changes):
    content = {name: dict(table) for name, table in CYLINDER.items()}
    for table, values in changes.items():
        content[table] = content.get(table, {}) | values
    return ObjectSpec.model_validate({"name": "x", **content})


def block(*centre, half=(1.0, 1.0, 1.0)):
    return Block(np.array(centre, float), np.eye(3), np.array(half))


@pytest.fixture
def given(monkeypatch):
    def put(**blocks):
        for name in ("core_keys", "relief_slits", "cuts_of_core"):
            monkeypatch.setattr(fit_blocks, name, lambda spec, name=name: blocks.get(name, ()))

    return put


def told(check, words, spec=None):
    return [text for text in check(spec or cylinder()) if words in text]


def test_keys_must_not_touch_each_other_nor_what_is_cut_into_the_core(given):
    for x, meets in ((1.99, True), (2.0, True), (2.01, False)):
        keys = (block(6.0, 0, -20), block(6.0 + x, 0, -20))
        given(core_keys=keys)
        assert bool(told(check_keys, "meets key")) == meets, x
        given(core_keys=keys[:1], cuts_of_core=[block(6.0 + x, 0, -20)])
        assert bool(told(check_keys, "stands over a sensor's recess")) == meets, x
    given(core_keys=(block(6.0, 0, -20), block(6.0, 1, -20)))
    (text,) = told(check_keys, "meets")
    assert text.startswith("core.keys: key 1 of face 1 meets key 1 of face 2")


def test_keys_of_two_faces_may_meet_within_the_core():
    """Near an edge their roots do, 0.5 mm below either face, and what stands above the core does not."""
    keys = {"positions_mm": [[-11.5, 11.0]], "size_mm": [2.0, 3.0, 1.5]}
    spec = ObjectSpec.model_validate({"name": "x", "core": {"keys": keys}})
    assert not told(check_keys, "meets key", spec)


def test_keys_stand_beside_wire_holes(given):
    """Holes of Ø4 at most, hub of Ø4: along the axes of top and sides."""
    for away, over in ((2.99, True), (3.01, False)):
        given(core_keys=(block(away, 0.0, 25.0),))
        assert bool(told(check_keys, "over the wire hole of face 1")) == over
        given(core_keys=(block(16.0, away, 0.0),))
        assert bool(told(check_keys, "over the wire hole of face 3")) == over
        assert not told(check_keys, "over the wire hole of face 1")


def test_keys_reach_into_a_pocket_that_is_over_them(given):
    """Pocket of Ø6 and 3 mm on the top at z = 30: its floor is at 27."""
    pocket = shell_pockets(cylinder())[0][0]
    assert pocket.outline.radius_mm == 3
    for x, top, meets in (
        (3.9, 27.1, True), (4.1, 27.1, False), (3.9, 26.9, False), (0.0, 26.9, False), (0.0, 27.1, True),
    ):  # fmt: skip
        given(core_keys=(block(x, 0.0, top - 1.0),))
        assert bool(told(check_keys, "into the pocket")) == meets, (x, top)


def test_keys_lie_on_their_patches_and_below_the_surface(given):
    given()
    frame = min(
        (f for f in core_frames(cylinder()) if not f.round), key=lambda f: f.half_extents_mm[1]
    )
    reach, words = (
        frame.half_extents_mm[1],
        f"reaches past the core's patch of face {frame.number} ",
    )
    for y, beyond in ((reach - 1.51, False), (reach - 1.49, True)):
        core = CYLINDER["core"] | {"keys": CYLINDER["core"]["keys"] | {"positions_mm": [[0.0, y]]}}
        assert bool(told(check_keys, words, cylinder(core=core))) == beyond
    for height, refused in ((7.99, False), (8.0, True)):
        core = CYLINDER["core"] | {
            "keys": CYLINDER["core"]["keys"] | {"size_mm": [3.0, 3.0, height]}
        }
        assert bool(told(check_keys, "must be below shell.thick", cylinder(core=core))) == refused


def test_slits_keep_silicone_over_the_core_all_along(given):
    """The floor, at +y of the block, is 15 mm from the axis, then 14.99: 1 mm of silicone is the least."""
    for floor, refused in ((15.01, False), (14.99, True)):
        axes = np.column_stack([[0.0, 0, 1], [0, -1, 0], [1, 0, 0]])
        slit = Block(np.array([0.0, floor + 4.0, 0.0]), axes, np.array([20.0, 4.0, 0.01]))
        given(relief_slits=(slit,))
        assert bool(told(check_slits, "of silicone over the core")) == refused
        ends = Block(np.array([0.0, floor + 4.0, 12.0]), axes, np.array([20.0, 4.0, 0.01]))
        given(relief_slits=(ends,))
        assert bool(told(check_slits, "of silicone over the core")) == refused


def test_slits_must_not_meet_keys_or_pockets(given):
    slit = block(0.0, 19.0, 0.0, half=(1.0, 2.0, 1.0))
    for x, meets in ((2.0, True), (2.01, False), (2.9, False)):
        given(relief_slits=(slit,), core_keys=(block(x, 19.0, 0.0),))
        assert bool(told(check_slits, "meets a key of the core")) == meets, x
    for x, meets in ((3.99, True), (4.01, False)):
        given(relief_slits=(block(x, 0.0, 28.0),))
        assert bool(told(check_slits, "meets a relief slit")) == meets, x


def test_slits_end_before_the_middle(given):
    """8 mm before either end, as the shell is thick."""
    given(relief_slits=(block(0.0, 22.0, 0.0),))
    for height, refused in ((16.01, False), (16.0, True)):
        flat = cylinder(body=CYLINDER["body"] | {"size_mm": [44.0, 44.0, height]})
        assert bool(told(check_slits, "which leaves no slit", flat)) == refused
    given()
    assert told(check_slits, "this cylinder has none")


def test_a_bay_leaves_a_printed_wall_to_the_core_s_side_its_top_and_its_cuts(given):
    """Corners of a square bay lie at half its edge times √2 from the axis; the core ends at 14 and 22."""
    given()
    wall = cylinder().printer.wall_mm

    def bay(edge, high=10.0):
        return cylinder(core=CYLINDER["core"] | {"bay_mm": [edge, edge, high]})

    edge = (14.0 - wall) * np.sqrt(2)
    for change, refused in ((-0.01, False), (0.01, True)):
        assert bool(told(check_bay, "at its upper corners", bay(edge + change))) == refused
        high = bay(8.0, 44.0 - wall + change)
        assert bool(told(check_bay, "at its upper corners", high)) == refused
        low = fit_blocks.bay_block(bay(10.0)).centre_mm[2]
        given(cuts_of_core=[block(6.0 + wall - change, 0.0, low)])
        assert bool(told(check_bay, "within", bay(10.0))) == refused
        given()
    assert not list(check_bay(cylinder()))


def test_channels_are_judged_where_they_pass_under_their_board(monkeypatch):
    """Half a millimetre of wall is left there, none a millimetre farther along."""
    spec = worked("box")
    wall = spec.core.wall_mm
    monkeypatch.setattr(
        parts, "channel_heights_mm", lambda spec, frame, xy, along: np.array([0.5 - wall - along])
    )
    assert list(parts.check_channels(spec)) == []
    monkeypatch.setattr(parts, "channel_heights_mm", lambda *_: np.array([-wall]))
    (said,) = parts.check_channels(spec)
    assert "channel" in said
