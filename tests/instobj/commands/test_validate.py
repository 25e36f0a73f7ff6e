"""Commands that meet a built object: robustness, self-test and validation."""

import csv
import json

import numpy as np
import pytest

from design.layout.places.positions import live_channels
from design.spec_io import load_spec
from estimator.calibration.recorded_presses import RecordedPresses
from estimator.calibration.resting import channel_names, read_resting
from estimator.signals.presses import rest_counts
from instobj.commands.recorded.validate import (
    calibration_rows,
    calibration_texts,
    cause_rows,
    exchanged_cases,
    not_recorded_texts,
)
from tests.support.cli import CUBE, assert_one_clear_error, run
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper

SPEC = load_spec(CUBE)
NAMES = channel_names(SPEC)


def write_resting(path, counts, names=NAMES, frames=4):
    rng = np.random.default_rng(3)
    rows = np.round(counts + 15 * rng.standard_normal((frames, len(counts))), 1)
    with path.open("w", newline="") as file:
        csv.writer(file).writerows([names, *rows.tolist()])
    return path


@pytest.fixture(scope="module")
def rest():
    return rest_counts(SPEC).ravel()


def test_a_table_of_frames_is_read_in_any_order(tmp_path, rest):
    order = np.random.default_rng(1).permutation(45)
    path = write_resting(tmp_path / "rest.csv", rest[order], [NAMES[k] for k in order])
    found = read_resting(path, SPEC)
    np.testing.assert_allclose(found.counts, rest, atol=40)
    assert (found.frames, found.silent) == (4, {})


def test_silent_channels_are_named(tmp_path, rest):
    path = write_resting(tmp_path / "rest.csv", rest)
    rows = list(csv.reader(path.open()))
    for row in rows[1:]:
        row[5], row[7], row[9] = "", "123", "32767"
    path.write_text("\n".join(",".join(row) for row in rows))
    found = read_resting(path, SPEC)
    assert found.silent == {
        NAMES[5]: "no reading",
        NAMES[7]: "stuck at 123",
        NAMES[9]: "stuck at 32767",
    }
    assert np.flatnonzero(np.isnan(found.counts)).tolist() == [5, 7, 9]


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("F1-X1,F1-Y9\n1,2\n", ("F1-Y9", "missing", "F1-Z1")),
        (",".join(NAMES) + "\n1,2\n", ("rest.csv", "line 2", "45")),
        ("date,temperature\n2024-01-01,20\n2024-01-02,21\n", ("rest.csv",)),
        (None, ("no resting signals",)),
    ],
)
def test_bad_resting_signals_end_with_one_clear_error(tmp_path, content, words):
    if content is not None:
        (tmp_path / "rest.csv").write_text(content)
    assert_one_clear_error(run("bench", "selftest", CUBE, "rest.csv", cwd=tmp_path), *words)


def test_selftest_names_a_flip_and_passes_once_it_is_known(tmp_path, rest):
    (tmp_path / "unit.toml").write_text("[[magnets]]\nface = 5\nmagnet = 4\nflipped = true\n")
    flipped = load_spec(CUBE, [f"as_built={json.dumps(str(tmp_path / 'unit.toml'))}"])
    write_resting(tmp_path / "rest.csv", rest_counts(flipped).ravel())
    done = run("bench", "selftest", CUBE, "rest.csv", "--json", cwd=tmp_path)
    assert done.returncode == 1
    result = json.loads(done.stdout)
    assert result["hypotheses"][0]["hypothesis"] == "flipped magnet: magnet 4 of face 5"
    known = run(
        "bench",
        "selftest",
        CUBE,
        "rest.csv",
        "--set",
        f"as_built='{tmp_path / 'unit.toml'}'",
        cwd=tmp_path,
    )
    assert known.returncode == 0, known.stdout + known.stderr
    assert "as specified" in known.stdout


def test_dead_channels_of_the_file_beside_the_specification(tmp_path):
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    found = '[[sensors]]\nface = 4\nsensor = 3\ndead = ["X", "Y", "Z"]\n'
    (tmp_path / "cube.as_built.toml").write_text(found)
    assert live_channels(load_spec(tmp_path / "cube.toml")).sum() == 42
    done = run("check", "cube.toml", cwd=tmp_path)
    assert done.returncode == 0
    missing = run(
        "run", "cube.toml", "--to", "robustness", "--set", "as_built='none.toml'", cwd=tmp_path
    )
    assert_one_clear_error(missing, "no as-built file")


def pressed(*faces_of_cases):
    """Presses of one case each, on the given faces."""
    cases = tuple(
        tuple((face, 0.0, float(k)) for face in faces) for k, faces in enumerate(faces_of_cases)
    )
    count = len(cases)
    return RecordedPresses(
        np.zeros((count, 45)),
        np.zeros((count, 5)),
        np.arange(count),
        np.zeros(count, int),
        np.ones(count, int),
        cases,
        np.ones(3),
    )


@pytest.mark.parametrize(
    ("faces", "possible"),
    [
        ([(3,)] * 3, 5),
        ([(3,), (3,), (5,), (5,)], 3),
        ([(3, 5)] * 4, 23),
        ([(1,), (2,), (3,)], 0),
        ([(3,)] * 9, 362879),
    ],
)
def test_exchanges_of_places_differ_and_keep_the_faces(faces, possible):
    found = exchanged_cases(pressed(*faces), 19, np.random.default_rng(0))
    assert len(found) == min(19, possible)
    assert len({tuple(order) for order in found.tolist()} - {tuple(range(len(faces)))}) == len(
        found
    )
    assert all(faces[new] == faces[old] for order in found for old, new in enumerate(order))


def calibrated(permutations):
    """A calibration that helps, and beats every exchange of places."""
    before, after = {"own_cosine": 0.5, "left_share": 0.9}, {"own_cosine": 0.95, "left_share": 0.2}
    return {
        "unseen": "other places",
        "design": before,
        "after": after,
        "null": before,
        "p_own_cosine": 1 / (1 + permutations),
        "permutations": permutations,
    }


@pytest.mark.parametrize(
    ("permutations", "said"),
    [
        (19, "it helps there"),
        (5, "cannot be told (6 exchanges of places allow no p below 0.17)"),
    ],
)
def test_calibration_on_few_places_cannot_be_told(permutations, said):
    document = {"cases": [[]] * 3, "calibration_tests": [calibrated(permutations)]}
    assert calibration_texts(document)[0].endswith(said)


@pytest.mark.parametrize("permutations", [19, 5])
def test_an_object_that_is_the_drawing_is_called_so(permutations):
    found = {"own_cosine": 0.999, "left_share": 0.042}
    test = calibrated(permutations) | {"design": found, "after": found}
    said = calibration_texts({"cases": [[]] * 3, "calibration_tests": [test]})[0]
    assert said.endswith("the object is as drawn within 4.2 % of the change, noise included")
    worse = test | {"design": {"own_cosine": 0.9, "left_share": 0.3}}
    (said,) = calibration_texts({"cases": [[]] * 3, "calibration_tests": [worse]})
    assert "as drawn" not in said


def test_columns_of_causes_are_titled_as_the_figures_of_calibration():
    """`left_share` and `own_cosine` stood above columns."""
    figures = {"own_cosine": 0.9, "all_cosine": 0.8, "left_share": 0.3}
    (row,) = cause_rows({"freed": {"the design": figures}})
    test = (
        calibrated(19) | dict.fromkeys(("design", "after", "null"), figures) | {"p_left_share": 1}
    )
    titles = [row["figure"] for row in calibration_rows({"calibration_tests": [test]})]
    assert list(row) == ["cause", *titles]
    assert row["share of the change left"] == 0.3


def test_calibration_without_exchanges_is_told():
    document = {"cases": [[]] * 2, "calibration_tests": []}
    assert "cannot be told: 2 sets of places" in calibration_texts(document)[0]


def test_sensors_that_were_not_recorded_are_told_first():
    (said,) = not_recorded_texts([(2, 2), (3, 3)], 6)
    assert "sensors 2 of face 2, 3 of face 3; judged on the other 4 of 6" in said
    assert ": sensor 1 of face 5;" in not_recorded_texts([(5, 1)], 15)[0]
    assert not_recorded_texts([], 6) == []


def test_validate_refuses_what_is_no_recording(tmp_path):
    (tmp_path / "rest.csv").write_text("date,temperature\n2024-01-01,20\n2024-01-02,21\n")
    assert_one_clear_error(run("validate", CUBE, "rest.csv", cwd=tmp_path), "rest.csv")
    folder = run("validate", CUBE, tmp_path, cwd=tmp_path)
    assert_one_clear_error(folder, "without sensor.csv and states.csv")


def test_validate_refuses_a_recording_of_other_channels(tmp_path):
    write_gripper(tmp_path / "made.csv", gripper_arrays(presses=3))
    fewer = run("validate", CUBE, "made.csv", "--set", "sensors.count_per_face=4", cwd=tmp_path)
    assert_one_clear_error(fewer, "45 channels")
    assert "4 sensors on each of 5 faces" in " ".join(fewer.stderr.split())
