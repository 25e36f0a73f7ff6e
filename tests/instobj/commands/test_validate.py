"""Commands that meet a built object: robustness, self-test and validation."""

import csv
import json

import numpy as np
import pytest

from design.layout.places.positions import live_channels
from design.spec_io import load_spec
from estimator.calibration.resting import channel_names, read_resting
from estimator.signals.presses import rest_counts
from instobj.commands.recorded.validate import not_recorded_texts
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
