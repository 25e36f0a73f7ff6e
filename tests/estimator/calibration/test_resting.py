"""Resting levels from a plain table: means, and what makes a channel silent, on both sides of each limit."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names, read_resting
from estimator.signals.hall import full_scale_counts

SPEC = ObjectSpec(name="cube")
NAMES = channel_names(SPEC)
FULL = full_scale_counts(SPEC.sensors)


def written(tmp_path, rows, names=NAMES):
    path = tmp_path / "rest.csv"
    lines = [",".join(names), *(",".join(f"{cell:g}" for cell in row) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
    return path


def rows_of(count):
    """Levels of 1, 2, 3, … counts, with frames beside them by turns."""
    return np.arange(1.0, 46.0) + np.resize([0.5, -0.5], count)[:, None]


def test_channels_are_named_face_by_face_and_read_in_any_order(tmp_path):
    assert NAMES[:7] == ["F1-X1", "F1-Y1", "F1-Z1", "F1-X2", "F1-Y2", "F1-Z2", "F1-X3"]
    assert len(NAMES) == 45
    found = read_resting(written(tmp_path, rows_of(4)[:, ::-1], NAMES[::-1]), SPEC)
    assert_allclose(found.counts, np.arange(1, 46))
    assert (found.frames, found.silent) == (4, {})


@pytest.mark.parametrize(("frames", "silent"), [(2, False), (3, True)])
def test_three_equal_frames_are_stuck(tmp_path, frames, silent):
    rows = rows_of(frames)
    rows[:, 4] = 7.0
    found = read_resting(written(tmp_path, rows), SPEC)
    assert found.silent == ({"F1-Y2": "stuck at 7"} if silent else {})
    assert np.isnan(found.counts[4]) == silent


def test_levels_at_full_scale_and_channels_without_readings_are_silent(tmp_path):
    rows = rows_of(4)
    rows[:, 0] = FULL + np.array([1.0, -1, 1, -1])
    rows[:, 1] = -FULL + np.array([1.0, -1, 1, -1])
    rows[:, 2] = FULL - 1 + np.array([0.5, -0.5, 0.5, -0.5])
    rows[:, 3] = np.nan
    rows[:2, 5] = np.nan
    found = read_resting(written(tmp_path, rows), SPEC)
    assert found.silent == {
        "F1-X1": "at full scale",
        "F1-Y1": "at full scale",
        "F1-X2": "no reading",
    }
    assert np.flatnonzero(np.isnan(found.counts)).tolist() == [0, 1, 3]
    assert_allclose(found.counts[5], 6)


def test_a_recording_gives_the_levels_of_the_sensed_faces_alone(tmp_path):
    """Face 3 of a cube that senses faces 1 and 3; the recording also knows face 2."""
    names = ["F1-Y1", "F2-X1", "F3-X1", "F3-Z3"]
    force = np.tile(np.r_[np.zeros(12), np.linspace(0.5, 8, 12)], 3)
    levels, gains = np.array([100.0, 200, 300, 400]), np.array([1.0, 0, 30, -20])
    counts = levels + gains * force[:, None] + 5 * np.resize([1, -1], len(force))[:, None]
    path = tmp_path / "pressed.csv"
    rows = [
        [f"{0.1 * k:.1f}", *(f"{one:.0f}" for one in row), f"{newton:.2f}", "3", "0", "0"]
        for k, (row, newton) in enumerate(zip(counts, force, strict=True))
    ]
    header = ["time_s", *names, "cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm"]
    path.write_text("\n".join(",".join(row) for row in [header, *rows]) + "\n")
    spec = ObjectSpec.model_validate({"name": "two", "body": {"sensed_faces": [1, 3]}})
    found = read_resting(path, spec)
    expected = dict.fromkeys(channel_names(spec), np.nan)
    expected |= {"F1-Y1": 100.0, "F3-X1": 300.0, "F3-Z3": 400.0}
    assert_allclose(found.counts, list(expected.values()), atol=4)
    assert set(found.silent) == {name for name, level in expected.items() if np.isnan(level)}


def test_wrong_tables_are_refused(tmp_path):
    for rows, names, said in (
        (rows_of(3), ["F6-X1", *NAMES[1:]], "unknown: F6-X1; missing: F1-X1"),
        (rows_of(3)[:, :44], NAMES[:44], "missing: F5-Z3"),
        (rows_of(3), [*NAMES[:44], NAMES[0]], "each once"),
        (rows_of(3)[:0], NAMES, "holds one line"),
        (rows_of(3)[:, :44], NAMES, "line 2: 44 cells where 45 belong"),
    ):
        with pytest.raises(InputError, match=said):
            read_resting(written(tmp_path, rows, names), SPEC)
