"""Presses of known travel: pose found from a few places, judged on others, every figure beside nulls."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError, RecordingError
from estimator.calibration.known_travel.agreement import travel_agreement
from estimator.calibration.known_travel.fit import (
    calibrate,
    drawn_places,
    left_over,
    register,
)
from estimator.recordings.formats.travel import is_travel_recording, read_travel
from tests.support.recordings.travel_cases import (
    POSE,
    RESTING_MT,
    pad_model,
    pressed_places,
    presses_of,
    recorded,
    write_recording,
)


@pytest.fixture(scope="module")
def model():
    return pad_model()


@pytest.fixture(scope="module")
def recording(model, tmp_path_factory):
    tip = pressed_places()
    folder = tmp_path_factory.mktemp("recordings") / "pad"
    return read_travel(write_recording(folder, tip, recorded(model, tip)))


def test_a_recording_gives_back_what_was_written(recording, model):
    tip = pressed_places()
    assert len(recording) == len(tip) == 2 * recording.places
    assert_allclose(recording.time_s, 1.7421e9 + 4.25 * np.arange(len(tip)), rtol=0, atol=1e-3)
    assert_allclose(recording.tip_mm, tip, atol=1e-6)
    assert_allclose(recording.field_mt, recorded(model, tip), atol=1e-9)


def test_a_tenth_of_the_places_tells_pose_and_resting_level(model, recording):
    shown = drawn_places(recording, 0.1, 0)
    assert len(np.unique(recording.place_id[shown])) == 8
    fitted = register(model, recording.select(shown))
    pose = fitted.twin.pose
    assert_allclose(pose.shift_mm, POSE.shift_mm, atol=0.1)
    assert_allclose(pose.turn_rad, POSE.turn_rad, atol=0.02)
    assert_allclose(pose.contact_mm, POSE.contact_mm, atol=0.1)
    assert pose.symmetry == POSE.symmetry
    assert_allclose(fitted.resting_mt, RESTING_MT, atol=0.02)
    judged = recording.select(~shown)
    found = travel_agreement(model, fitted, recording.select(shown), judged, 5)
    assert found.all.cosine > 0.99
    assert found.all.explained > 0.99
    assert found.order_of_chips == 1
    assert max(null.explained for null in found.places_exchanged) < 0.7
    assert max(rival.between for rival in found.rivals.values()) < 0.5


def test_calibration_takes_up_magnets_off_their_seats(model):
    """Explains more of the presses that it has not seen than the designed object."""
    rng = np.random.default_rng(1)
    tip = pressed_places(7, 2)
    seats = 0.6 * rng.standard_normal((4, 3))
    field = recorded(model, tip, magnet_mm=seats)
    twin = model.design_twin(POSE)
    field += model.resting(type(twin)(POSE, seats, twin.tilt_rad)) - RESTING_MT
    rows = presses_of(tip, field)
    shown = drawn_places(rows, 0.2, 0)
    plain = register(model, rows.select(shown))
    better = calibrate(model, rows.select(shown), plain.twin)
    left = [
        np.sqrt(np.mean(left_over(model, one, rows.select(~shown)) ** 2)) for one in (plain, better)
    ]
    assert left[1] < 0.7 * left[0]


DAMAGE = {
    "a file is missing": (lambda f: (f / "states.csv").unlink(), "states.csv"),
    "a row is missing": (lambda f: edit(f / "sensor.csv", lambda rows: rows[:-1]), "161 rows.*162"),
    "rows are shifted": (
        lambda f: edit(f / "states.csv", lambda rows: [*rows[1:], rows[0]]),
        "do not belong together",
    ),
    "a cell is text": (
        lambda f: edit(f / "sensor.csv", replaced("nine")),
        "'nine' is not a number",
    ),
    "a cell is empty": (lambda f: edit(f / "sensor.csv", replaced("")), "empty in data row 4"),
    "a load in the first line alone": (
        lambda f: edit(f / "states.csv", lambda rows: [rows[0] + ",7.0", *rows[1:]]),
        "line 2: 4 cells where 5 belong",
    ),
    "a reading of the last chip beyond any field": (
        lambda f: edit(f / "sensor.csv", replaced("-2e6", 15)),
        "line 4: reading 15 is -2e.06, beyond",
    ),
    "bytes that are no text": (lambda f: (f / "sensor.csv").write_bytes(b"\xff\xfe\x00"), "text"),
}


def edit(path, change):
    path.write_text("\n".join(change(path.read_text().splitlines())) + "\n")


def replaced(cell, column=2):
    def change(rows):
        cells = rows[3].split(",")
        cells[column] = cell
        return [*rows[:3], ",".join(cells), *rows[4:]]

    return change


@pytest.mark.parametrize("damage", DAMAGE)
def test_damage_is_one_error_that_says_where(damage, tmp_path):
    tip = pressed_places()
    folder = write_recording(tmp_path / "pad", tip, np.ones((len(tip), 5, 3)))
    read_travel(folder)
    spoil, message = DAMAGE[damage]
    spoil(folder)
    assert is_travel_recording(folder)
    with pytest.raises(RecordingError, match=message):
        read_travel(folder)


def test_loads_beside_the_places_are_read_as_they_are(tmp_path):
    tip = pressed_places()
    folder = write_recording(tmp_path / "pad", tip, np.ones((len(tip), 5, 3)))
    plain = read_travel(folder)
    assert plain.load is None
    loads = ["-1.0", *(["54321.0"] * (len(tip) - 1))]
    edit(folder / "states.csv", lambda rows: [f"{a},{b}" for a, b in zip(rows, loads, strict=True)])
    loaded = read_travel(folder)
    assert_allclose(loaded.tip_mm, plain.tip_mm)
    assert np.isnan(loaded.load[0])
    assert (loaded.select(loaded.place_id == 0).load[1:] == 54321).all()


def test_an_object_of_several_faces_is_refused(model):
    from design.spec.object import ObjectSpec
    from estimator.calibration.known_travel.model import travel_model
    from tests.support.mechanics.synthetic_presses import synthetic_presses

    cube = ObjectSpec(name="cube")
    with pytest.raises(InputError, match="one sensed face"):
        travel_model(cube, synthetic_presses(cube)[1])


def test_a_curved_face_is_refused():
    """A machine goes straight down, simulated presses along the surface's normal."""
    from design.spec.object import ObjectSpec
    from estimator.calibration.known_travel.model import require_comparable

    body = {"kind": "sphere", "size_mm": [44.0] * 3, "sensed_faces": [1]}
    with pytest.raises(InputError, match="face 1 of this sphere is curved"):
        require_comparable(ObjectSpec.model_validate({"name": "ball", "body": body}))


def test_a_file_in_place_of_the_folder_is_told_so(tmp_path):
    file = tmp_path / "sensor.csv"
    file.write_text("0,1,2,3\n")
    with pytest.raises(RecordingError, match=r"is a file\. Give the folder"):
        read_travel(file)
