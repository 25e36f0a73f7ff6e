"""What `python -m studies conventions` makes of recordings without columns of some sensors."""

from dataclasses import replace

import numpy as np
import pytest

from design.errors import InputError
from estimator.recordings.formats.files import read_table
from instobj.stages.run import Run
from studies.recorded import convention_search as searched
from studies.recorded import conventions
from studies.recorded.resting_conventions import RestingSearch
from tests.support.recordings.generic_csv import write_generic_csv
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper

SEARCH = RestingSearch(0.1, 0.2, (0, 0, 0), 9, 0.2, 0.5, 0.5)


def without(folder, dead):
    """Two recordings that lack sensors: dead[face, sensor]."""
    files = []
    for number in (1, 2):
        table = read_table(write_gripper(folder / "own.csv", gripper_arrays(presses=number)))
        counts = table.counts.copy()
        counts[:, dead] = np.nan
        files.append(folder / f"{number}.csv")
        write_generic_csv(replace(table, counts=counts), files[-1])
    return files


@pytest.fixture
def searched_on(tmp_path, monkeypatch):
    """The command on recordings that lack sensors; what the mechanics would say is made up."""
    (tmp_path / "cube.toml").write_text('name = "cube"\n')

    def predicted(spec, response, presses):
        shape = 8, len(presses), len(presses.cases), presses.signal_counts.shape[1]
        return np.random.default_rng(1).normal(size=shape)

    levels = {}

    def resting(designed, counts, *others):
        levels["silent"] = np.flatnonzero(np.isnan(counts)).tolist()
        return SEARCH

    monkeypatch.setattr(searched, "predicted_changes", predicted)
    monkeypatch.setattr(Run, "read", lambda run, stage: None)
    monkeypatch.setattr("studies.recorded.resting_conventions.search_resting", resting)
    monkeypatch.setattr("studies.recorded.resting_conventions.common_fits", lambda *_: ())

    def call(dead):
        files = without(tmp_path, dead)
        return conventions.conventions_of(tmp_path / "cube.toml", files, 1, []), levels

    return call


def test_sensors_without_columns_are_told_and_count_nothing(searched_on):
    dead = np.zeros((5, 3), bool)
    dead[2, 2] = True
    found, levels = searched_on(dead)
    assert "sensor 3 of face 3; judged on the other 14 of 15" in found["texts"][0]
    assert levels["silent"] == [24, 25, 26]
    (rows, *_) = found["tables"].values()
    assert {row["face"] for row in rows} == {3, 5}
    assert all(np.isfinite(row["chosen, judged"]) for row in rows)


def test_recordings_without_columns_for_any_third_sensor_are_read(searched_on):
    dead = np.zeros((5, 3), bool)
    dead[:, 2] = True
    found, levels = searched_on(dead)
    assert found["texts"][0].endswith("judged on the other 10 of 15")
    assert levels["silent"] == [9 * face + channel for face in range(5) for channel in (6, 7, 8)]


def test_a_pressed_face_without_any_sensor_is_refused(searched_on):
    dead = np.zeros((5, 3), bool)
    dead[2] = True
    with pytest.raises(InputError, match="face 3"):
        searched_on(dead)
