"""Boards and chips that do not go into their recesses, or meet each other."""

import re

import pytest

from design.fit.boards import boards_across_edges
from design.fit.everything import problems_of
from design.spec.object import ObjectSpec

TABLES = {
    "box": {"body": {"size_mm": [50.0, 50.0, 50.0]}},
    "cylinder": {"body": {"kind": "cylinder", "size_mm": [50.0, 50.0, 50.0]}},
}
TOO_LARGE = {
    "core.recess_width_mm": {"sensors": {"package_mm": [7.4, 6.2, 1.6]}},
    "core.recess_outer_radius_mm": {"sensors": {"package_mm": [6.6, 6.9, 1.6]}},
    "core.recess_depth_mm": {"sensors": {"package_mm": [6.6, 6.2, 1.8]}},
}
FITS = {
    "core.recess_width_mm": 7.4,
    "core.recess_outer_radius_mm": 11.4,
    "core.recess_depth_mm": 3.05,
}


def _problems(kind="box", **tables):
    return problems_of(ObjectSpec.model_validate({"name": "x", **TABLES[kind], **tables}))


@pytest.mark.parametrize("kind", TABLES)
@pytest.mark.parametrize("key", TOO_LARGE)
def test_a_board_larger_than_its_recess_is_told_with_the_recess_that_takes_it(kind, key):
    (told,) = _problems(kind, **TOO_LARGE[key])
    assert float(re.findall(r"(?:Make it|outer one) ([\d.]+) or more", told)[0]) == FITS[key]
    _, name = key.split(".")
    wide = {"core": {name: FITS[key]}}
    assert not _problems(kind, **TOO_LARGE[key], **wide), "the value that was named does not work"
    assert _problems(kind, **TOO_LARGE[key], core={name: FITS[key] - 0.01})


def test_a_chip_beside_its_recess_is_told():
    outer = {"sensors": {"radius_mm": 9.8}}
    (told,) = _problems(**outer)
    assert "the chip reaches from 8.4 to 11.2 mm" in told
    assert not _problems(**outer, core={"recess_outer_radius_mm": 11.2})


@pytest.mark.parametrize(("apart_mm", "meet"), [(6.19, True), (6.21, False)])
def test_boards_of_one_face_that_meet_are_told_once_for_all_faces(apart_mm, meet):
    """Boards of 6.6 × 6.2 mm, one beyond the other along x."""
    row = [[4.0, 0.0], [4.0 + apart_mm, 0.0]]
    core = {"recess_inner_radius_mm": 0.75, "recess_outer_radius_mm": 7.25, "wall_mm": 4.0}
    sensors = {"count_per_face": 2, "radius_mm": 4.0, "positions_mm": row}
    told = [one for one in _problems(core=core, sensors=sensors) if "boards" in one]
    assert len(told) == meet
    if meet:
        assert "sensors 1 and 2 on faces 1, 2, 3, 4, 5 meet, by 0.01 mm" in told[0]


def test_boards_of_neighbouring_faces_that_meet_are_told_beside_the_problems():
    """Recesses of the paper's cube meet at its edges; boards on their floors do, flush ones not."""
    cube = ObjectSpec(name="cube")
    assert boards_across_edges(cube) is None
    sensors = cube.sensors.changed(chip="outward", depth_below_core_face_mm=0.7)
    turned = cube.changed(sensors=sensors)
    assert not problems_of(turned)
    told = boards_across_edges(turned)
    assert told is not None
    assert "sensor 1 of face 1 and sensor 1 of face 2 (by 0.85 mm)" in told
