"""Faces that share a layout in a search: of one size, all, or none; names and ranges of their variables."""

import pytest

from design.search.faces import group_labels, layout_groups
from design.search.space import search_space, start_params, with_layout
from design.spec_io import parse_spec

BOX = {"body": {"size_mm": [60.0, 44.0, 40.0]}, "core": {"wall_mm": 5.0}}
HANDLE = {
    "body": {"kind": "cylinder", "size_mm": [42.0, 42.0, 60.0]},
    "sensors": {"positions_mm": [[9, 0], [-9, 0]]},
    "contact_grid": {"count": "fill", "pitch_mm": 4.0},
}


def specification(content, **vary):
    vary = {"magnet_reach_mm": 19.0, "magnet_depth_mm": [2.0, 5.0], "sensor_reach_mm": 9.0} | vary
    magnets = {"magnets": {"positions_mm": [[0, 0], [10, 0]], "depth_mm": [2.5, 2.5]}}
    return parse_spec({"name": "t"} | magnets | content | {"search": {"vary": vary}}, "made up")


@pytest.mark.parametrize(
    ("content", "way", "groups"),
    [
        ({}, "per size", ((1, 2, 3, 4, 5),)),
        ({}, "per face", ((1,), (2,), (3,), (4,), (5,))),
        (BOX, "per size", ((1,), (2, 4), (3, 5))),
        (BOX, "one", ((1, 2, 3, 4, 5),)),
        (HANDLE, "per size", ((1,), (2, 3, 4, 5), (6,))),
    ],
)
def test_faces_share_a_layout_by_their_size(content, way, groups):
    spec = specification(content, layouts=way)
    assert layout_groups(spec)[: len(groups)] == groups[: len(layout_groups(spec))]
    assert len(group_labels(spec)) == len(layout_groups(spec))
    assert group_labels(spec)[0] == ("" if len(layout_groups(spec)) == 1 else "face1_")


def test_places_of_every_size_are_variables_within_their_faces_and_depths_are_shared():
    space = search_space(specification(BOX))
    ends = {v.name: v.high for v in space.variables}
    assert len(ends) == 3 * (2 * 2 + 3 * 2) + 2
    assert ends["face1_magnet1_x_mm"] == 19.0
    assert ends["face3_magnet2_y_mm"] == 19.0
    assert ends["magnet2_depth_mm"] == 5.0
    wide = search_space(specification(BOX, magnet_reach_mm=40.0))
    ends = {v.name: v.high for v in wide.variables}
    assert (ends["face1_magnet1_x_mm"], ends["face1_magnet1_y_mm"]) == (30.0, 22.0)
    assert (ends["face2_magnet1_x_mm"], ends["face2_magnet1_y_mm"]) == (20.0, 30.0)


def test_a_layout_for_each_size_is_written_face_by_face_and_read_back():
    spec = specification(BOX)
    space = search_space(spec)
    params = start_params(space)
    assert params is not None
    params |= {"face2_magnet2_x_mm": 9.0, "face3_magnet2_x_mm": 11.0}
    found = with_layout(spec, params)
    lists = found.magnets.lists
    assert [places[1][0] for places in lists] == [10.0, 9.0, 11.0, 9.0, 11.0]
    again = start_params(search_space(found))
    assert {name: value for name, value in again.items() if "magnet" in name} == {
        name: value for name, value in params.items() if "magnet" in name
    }
