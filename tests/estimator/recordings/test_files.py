"""Damaged, foreign and truncated recordings: one InputError each, never another exception."""

import os

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from design.errors import InputError
from estimator.recordings.reading import read_recording
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper


@pytest.fixture(scope="module")
def good_text(tmp_path_factory):
    arrays = gripper_arrays(cases=((54, 57),), presses=1)
    path = write_gripper(tmp_path_factory.mktemp("g") / "a.csv", arrays, ((54, 57),))
    return path.read_text()


def message(path):
    with pytest.raises(InputError) as caught:
        read_recording(path)
    return str(caught.value)


def edited(tmp_path, text, line, column, value):
    rows = [row.split(",") for row in text.splitlines()]
    rows[line][column] = value
    path = tmp_path / "edited.csv"
    path.write_text("\n".join(",".join(row) for row in rows))
    return path


def test_a_pipe_and_a_name_that_is_none(tmp_path):
    """A pipe without a writer was read for ever."""
    os.mkfifo(tmp_path / "pipe.csv")
    assert "a pipe, socket or device" in message(tmp_path / "pipe.csv")
    assert "not a file name" in message(tmp_path / "a\0b.csv")


def test_missing_folder_and_specification(tmp_path):
    assert "no recording at" in message(tmp_path / "none.csv")
    assert "is a specification" in message(tmp_path / "cube.toml")
    assert "cannot read" in message(tmp_path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "a.csv"),
        (b"  \n\n", "a.csv"),
        (b"\xff\xfe\x00\x01" * 50, "a.csv"),
        (b"Time,Left\0,1\n1,2\n", "a.csv"),
        ("time_s,F1-X1\n0.1,5\n".encode("utf-16"), "UTF-16. Save it as UTF-8"),
    ],
)
def test_empty_and_binary(tmp_path, content, words):
    (tmp_path / "a.csv").write_bytes(content)
    assert words in message(tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("name,age\nAda,36\n", "not a recording"),
        ("Time,Left\n1,2\n", "lacks the columns Right-blue"),
        ("Time\n", "one line"),
        ("1,2,3\n4,5,6\n", "3 columns without a header"),
    ],
)
def test_foreign_csv(tmp_path, text, words):
    (tmp_path / "a.csv").write_text(text)
    assert words in message(tmp_path / "a.csv")


def test_truncated_line(tmp_path, good_text):
    (tmp_path / "a.csv").write_text(good_text[: int(len(good_text) * 0.7)].rstrip("\n,0123456789-"))
    text = message(tmp_path / "a.csv")
    assert "cells where 52 belong" in text
    assert "line " in text


@pytest.mark.parametrize(
    ("line", "column", "value", "words"),
    [
        (4, 9, "1_0", "line 5, column F5-X3: '1_0' is not a number"),
        (4, 9, "１２", "line 5, column F5-X3: '１２' is not a number"),
        (4, 49, "3.5", "3.5 in column Probe_Pos_1 is not a whole number"),
        (4, 49, "", "not a whole number"),
    ],
)
def test_bad_cells(tmp_path, good_text, line, column, value, words):
    assert words in message(edited(tmp_path, good_text, line, column, value))


def test_swapped_columns(tmp_path, good_text):
    rows = [row.split(",") for row in good_text.splitlines()]
    for row in rows:
        row[3], row[12] = row[12], row[3]
    (tmp_path / "a.csv").write_text("\n".join(",".join(row) for row in rows))
    assert "column 4 is 'F3-X1' where 'F5-X1' belongs" in message(tmp_path / "a.csv")


def test_additional_column(tmp_path, good_text):
    rows = [row + ",1" for row in good_text.splitlines()]
    (tmp_path / "a.csv").write_text("\n".join(rows))
    assert "columns that are not known: '1'" in message(tmp_path / "a.csv")


def test_no_press_and_no_rest(tmp_path):
    time, force, counts, case = gripper_arrays()
    assert "holds no press" in message(
        write_gripper(tmp_path / "a.csv", (time, 0 * force, counts, case))
    )
    always = np.abs(force).max(axis=1) > 1
    pressed = (time[always], force[always], counts[always], case[always])
    assert "at rest" in message(write_gripper(tmp_path / "b.csv", pressed))


@settings(
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.data())
def test_fuzzed_files_raise_input_errors_only(tmp_path, good_text, data):
    """Cut, overwrite or delete bytes anywhere: the file reads, or says what is wrong."""
    content = bytearray(good_text.encode())
    for _ in range(data.draw(st.integers(1, 4))):
        start = data.draw(st.integers(0, len(content) - 1))
        stop = min(len(content), start + data.draw(st.integers(1, 400)))
        content[start:stop] = data.draw(
            st.binary(max_size=12) | st.sampled_from([b",", b"\n", b"9e99"])
        )
        content = content or bytearray(b"x")
    path = tmp_path / "fuzzed.csv"
    path.write_bytes(bytes(content))
    assert outcome(path)


def outcome(path):
    """Whether the file read well, or failed with a message that names it."""
    try:
        recording = read_recording(path)
    except InputError as error:
        return "fuzzed.csv" in str(error)
    return bool(np.all(np.diff(recording.frames.time_s) > 0))
