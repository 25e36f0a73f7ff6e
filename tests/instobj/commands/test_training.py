"""Recordings read with the specification of their object, and what a training tells of them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.frames.dataset import NO_FACE
from estimator.frames.splits import split_presses
from instobj.commands.training import data_parts, models_of_object, read_recordings
from tests.support.recordings.pressed_frames import made_frames
from tests.support.recordings.synthetic_frames import synthetic_frames

FRAMES = made_frames()
"""One sensor on each of five faces, presses of face 3."""


def specified(sensors, faces=(1, 2, 3, 4, 5)):
    body, sensed = {"sensed_faces": list(faces)}, {"count_per_face": sensors}
    return ObjectSpec.model_validate({"name": "cube", "body": body, "sensors": sensed})


def test_sensors_without_a_column_are_dead_ones_and_named():
    """Twins and validation called such a recording one of another object."""
    every_face = replace(FRAMES, signal_counts=np.nan_to_num(FRAMES.signal_counts))
    frames, said = models_of_object(every_face, specified(3))
    assert frames.signal_counts.shape == (*FRAMES.signal_counts.shape[:2], 3, 3)
    np.testing.assert_array_equal(frames.signal_counts[:, :, :1], every_face.signal_counts)
    assert np.isnan(frames.signal_counts[:, :, 1:]).all()
    assert [text.split(":")[1] for text in said] == [
        " sensor 2 of every face",
        " sensor 3 of every face",
    ]
    same, said = models_of_object(every_face, specified(1))
    np.testing.assert_array_equal(same.signal_counts, every_face.signal_counts)
    assert said == []


def test_sensed_faces_without_a_reading_are_named():
    """Only sensors that no face has were named: a recording of one face looked complete."""
    counts = np.nan_to_num(FRAMES.signal_counts)
    counts[:, [1, 4]] = np.nan
    _, said = models_of_object(replace(FRAMES, signal_counts=counts), specified(1))
    assert [text.split(":")[1] for text in said] == [" faces [2, 5]"]


def test_readings_of_sensors_that_an_object_does_not_have_are_refused():
    more = np.pad(FRAMES.signal_counts, ((0, 0), (0, 0), (0, 3), (0, 0)))
    with pytest.raises(InputError, match="4 sensors on a face; cube has 3"):
        models_of_object(replace(FRAMES, signal_counts=more), specified(3))
    more[:, :, 3] = np.nan
    frames, _ = models_of_object(replace(FRAMES, signal_counts=more), specified(3))
    assert frames.signal_counts.shape[2] == 3


def test_presses_of_faces_that_are_not_sensed_are_refused_where_there_are_no_others():
    with pytest.raises(InputError, match=r"face 3 is pressed; cube senses \[1\]"):
        models_of_object(FRAMES, specified(1, [1]))
    both = FRAMES.contact_face.copy()
    both[np.flatnonzero(both[:, 0] != NO_FACE)[:10]] = 1
    models_of_object(replace(FRAMES, contact_face=both), specified(1, [1]))


def test_parts_of_a_data_set_are_told_by_what_they_are_used_for():
    frames = synthetic_frames(faces=(2,), presses=4, rest=3, loaded=5, places=(0, 7))
    split = split_presses(frames, 0)
    frames.valid[np.flatnonzero(split.train & (frames.place_id >= 0))[:2]] = False
    rows = data_parts(frames, split)
    assert [row["used for"] for row in rows] == [
        *("training", "stopping, interval widths", "held out: judged above")
    ]
    assert sum(row["presses"] for row in rows) == 8
    assert {row["contact cases"] for row in rows} == {2}
    for row, lost in zip(rows, (2, 0, 0), strict=True):
        assert row["frames pressed"] == 5 * row["presses"] - lost
        assert row["at rest"] == 3 * row["presses"]


def test_a_recording_read_without_its_specification_says_what_needs_one(tmp_path, monkeypatch):
    """`assess --spec` refused networks of such a data set, and no step named the option before."""
    monkeypatch.chdir(tmp_path)
    rows = ["time_s,F1-X1,F1-Y1,F1-Z1,cell1_force_n,cell1_face,cell1_x1_mm,cell1_y1_mm"]
    rows += [f"{k / 10},{1000 + k % 3},{500 - k % 2},{-300 + k % 2},0.0,,," for k in range(10)]
    rows += [f"{1 + k / 10},{1045 + k},{478 - k},{-210 + k},1.0,1,3.0,-1.5" for k in range(5)]
    rows += [f"{1.5 + k / 10},{1000 + k % 3},500,-300,0.0,,," for k in range(5)]
    (tmp_path / "press.csv").write_text("\n".join(rows) + "\n")
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    without, described = (
        read_recordings([Path("press.csv")], tmp_path, spec)["texts"]
        for spec in (None, Path("cube.toml"))
    )
    assert any("add --spec SPEC.toml to `assess` grasps" in text for text in without)
    assert not any("--spec" in text for text in described)
