"""Layouts that differ from face to face: in mm, as fractions of the faces, and refused."""

import numpy as np
import pytest

from design.errors import SpecError
from design.layout.body import core_frames, face_frames
from design.layout.places.fractions import lists_by_face
from design.layout.places.positions import magnet_layout
from design.layout.pockets import magnet_places, sensor_places
from design.solids.magnet_template import template_faces
from design.spec_io import parse_spec

BOX = {
    "name": "box",
    "body": {"size_mm": [60, 44, 40]},
    "sensors": {"count_per_face": 2, "radius_mm": 6.0, "package_mm": [6.6, 3.5, 1.6]},
    "core": {"recess_outer_radius_mm": 8.0},
}
LISTS = [
    [[0, 0], [12, 3]],
    [[1, 9], [-4, -9]],
    [[2, 0], [9, 1]],
    [[0, 8], [0, -8]],
    [[3, 3], [-5, 2]],
]


def parsed(**tables):
    return parse_spec(BOX | tables, "box")


def test_every_face_has_the_magnets_of_its_own_list():
    spec = parsed(magnets={"positions_mm": LISTS})
    layout = magnet_layout(spec)
    assert spec.magnets.count == 2
    for frame, places in zip(face_frames(spec), LISTS, strict=True):
        here = layout.centre_mm[layout.face == frame.number]
        np.testing.assert_allclose(frame.plane_coordinates(here)[:, :2], places, atol=1e-9)
    assert all(len(faces) == 1 for faces in template_faces(spec).values())


def test_one_list_serves_all_faces():
    spec = parsed(magnets={"positions_mm": LISTS[0]})
    assert [list(map(list, places)) for places in magnet_places(spec)] == [LISTS[0]] * 5


def test_fractions_are_shares_of_each_face_that_the_parts_lie_under():
    share = np.array([[0.4, -0.3], [-0.5, 0.2]])
    spec = parsed(
        magnets={"positions_fraction": share.tolist()},
        sensors={
            "positions_fraction": [[0.3, 0.4]],
            "radius_mm": 6.0,
            "package_mm": [6.6, 3.5, 1.6],
        },
    )
    for frame, places in zip(face_frames(spec), magnet_places(spec), strict=True):
        np.testing.assert_allclose(places, share * frame.half_extents_mm, atol=1e-4)
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        half_x, half_y = frame.half_extents_mm
        np.testing.assert_allclose(places[0][:2], [0.3 * half_x, 0.4 * half_y], atol=1e-4)


def test_a_fraction_of_one_is_on_the_border():
    assert lists_by_face("magnets", [[-1.0, 0.2]], 5) == [[[-1.0, 0.2]]] * 5
    with pytest.raises(SpecError, match="takes pairs from -1 to 1"):
        lists_by_face("magnets", [[0.2, -1.001]], 5)


@pytest.mark.parametrize(
    ("magnets", "told"),
    [
        ({"positions_mm": LISTS[:2]}, "holds 2 lists"),
        ({"positions_mm": [*LISTS[:4], [[0, 0]]]}, "as many places on every face"),
        ({"positions_fraction": [[0.4, 1.2]]}, "pairs from -1 to 1"),
        ({"positions_fraction": [0.4, 0.2]}, "pairs from -1 to 1"),
        (
            {"positions_fraction": [[0.4, 0.2]], "positions_mm": [[0, 0]]},
            "Leave one of the two out",
        ),
        ({"positions_mm": [*LISTS[:4], [[19.9, 0], [0, 0]]]}, "face 5: .*outside the shell's face"),
    ],
)
def test_layouts_that_cannot_be_are_told(magnets, told):
    with pytest.raises(SpecError, match=told):
        parsed(magnets=magnets)
