"""docs/architecture.md says what the code does: rooms, floors, axes of faces and chips, azimuths."""

import re
import sys

import numpy as np
import pytest

from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from tests.support.pages import DOCS

sys.path.insert(0, str(DOCS))
import rooms

PAGE = (DOCS / "architecture.md").read_text()
AXES = {name: np.eye(3)[k] for k, name in enumerate("xyz")}
STALE = "run `python docs/rooms.py`"


def _axis(text: str, axes=AXES) -> np.ndarray:
    """−z as a vector."""
    sign = -1.0 if text[0] == "−" else 1.0
    return sign * axes[text[-1]]


def _closed_cube(**sensors) -> ObjectSpec:
    body = {"open_faces": [], "size_mm": [42.0, 42.0, 42.0]}
    return ObjectSpec.model_validate({"name": "closed", "body": body, "sensors": sensors})


def test_the_tables_of_rooms_are_those_of_the_code():
    assert rooms.page_with_table(PAGE) == PAGE, STALE


def test_the_figure_of_floors_is_that_of_the_contracts():
    assert (DOCS / "rooms.svg").read_text() == rooms.figure(), STALE


def test_every_room_stands_on_one_floor():
    for package in rooms.PACKAGES:
        placed = [name for floor in rooms.floors(package) for name in floor]
        outer = {room for room in rooms.rooms(package) if room.count(".") == 1}
        assert len(placed) == len(set(placed))
        assert outer <= set(placed)


def test_the_first_line_of_every_room_fits_a_table():
    for package in rooms.PACKAGES:
        for room in rooms.rooms(package):
            assert re.fullmatch(r"[^|\n]{10,100}\.", rooms.first_line(room)), room


def test_the_faces_have_the_axes_that_the_page_states():
    rows = re.findall(r"^\| ([1-6]) \| ([+−][xyz]) \| ([+−][xyz]) \| ([+−][xyz]) \|$", PAGE, re.M)
    frames = face_frames(_closed_cube())
    assert [int(row[0]) for row in rows] == [frame.number for frame in frames] == [1, 2, 3, 4, 5, 6]
    for (_, normal, x, y), frame in zip(rows, frames, strict=True):
        np.testing.assert_array_equal(_axis(normal), frame.normal)
        np.testing.assert_array_equal(_axis(x), frame.x)
        np.testing.assert_array_equal(_axis(y), frame.y)
        np.testing.assert_array_equal(np.cross(_axis(x), _axis(y)), _axis(normal))


@pytest.mark.parametrize("first_deg", [0.0, 30.0, 240.0])
def test_azimuths_run_from_x_towards_y_counter_clockwise_from_outside(first_deg):
    spec = _closed_cube(first_azimuth_deg=[first_deg])
    layout, count = sensor_layout(spec), spec.sensors.count_per_face
    for frame in face_frames(spec):
        place = layout.position_mm[layout.face == frame.number] @ frame.axes[:, :2]
        angle = np.deg2rad(first_deg + 360 / count * np.arange(count))
        expected = spec.sensors.radius_mm * np.column_stack([np.cos(angle), np.sin(angle)])
        np.testing.assert_allclose(place, expected, atol=1e-9)


@pytest.mark.parametrize(
    ("chip", "sentence"),
    [
        ("inward", r"At a = 0 that is X = (.\w), Y = (.\w), Z = (.\w)\."),
        ("outward", r"Facing outward, .*: X = \+tangential, Z = (−n)\."),
    ],
)
def test_chips_have_the_axes_that_the_page_states(chip, sentence):
    spec = _closed_cube(first_azimuth_deg=[0.0], chip=chip)
    layout = sensor_layout(spec)
    stated = re.search(sentence, PAGE)
    assert stated
    for frame in face_frames(spec):
        axes = {"x": frame.x, "y": frame.y, "n": frame.normal}
        first = layout.axes[layout.face == frame.number][0]
        names = stated.groups() if chip == "inward" else ("+y", "+x", stated[1])
        for name, row in zip(names, first, strict=True):
            np.testing.assert_allclose(row, _axis(name, axes), atol=1e-12)


def test_chips_of_a_ring_turn_with_their_azimuth():
    spec = _closed_cube()
    layout, count = sensor_layout(spec), spec.sensors.count_per_face
    for frame, first in zip(face_frames(spec), [*spec.sensors.first_azimuth_deg, 240], strict=True):
        local = layout.axes[layout.face == frame.number] @ frame.axes
        for k, chip in enumerate(local):
            a = np.deg2rad(first + 360 / count * k)
            expected = [[np.sin(a), -np.cos(a), 0], [np.cos(a), np.sin(a), 0], [0, 0, 1]]
            np.testing.assert_allclose(chip, expected, atol=1e-12)


def test_magnets_point_outward_and_tilt_about_the_faces_axes():
    magnets = {"positions_mm": [[0, 0], [10, 0]], "tilt_deg": [[0, 0], [0, 10]]}
    spec = ObjectSpec.model_validate({"name": "tilted", "magnets": magnets})
    layout = magnet_layout(spec)
    for frame in face_frames(spec):
        straight, tilted = layout.axis[layout.face == frame.number]
        np.testing.assert_allclose(straight, frame.normal, atol=1e-12)
        ten = np.deg2rad(10)
        expected = np.cos(ten) * frame.normal + np.sin(ten) * frame.x
        np.testing.assert_allclose(tilted, expected, atol=1e-12)
