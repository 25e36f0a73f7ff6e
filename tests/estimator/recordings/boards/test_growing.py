"""A recording that grows: what an open file had, where it goes on, and what was cut off."""

from types import SimpleNamespace

import pytest

from design.errors import RecordingError
from estimator.recordings.boards import growing
from estimator.recordings.boards.growing import growing_recording

HEADER = "time_s,session,rest,F1-X1,cell1_force_n,cell1_face,cell1_x1_mm,cell1_y1_mm\n"


def opened(path, session=None):
    with growing_recording(path, ["F1-X1"], 1, 1, session) as found:
        return found.rows_before, found.session, found.last_s, found.cut_bytes


def test_a_new_file_begins_with_its_header_in_session_1(tmp_path):
    path = tmp_path / "new" / "a.csv"
    assert opened(path) == (0, 1, 0.0, 0)
    assert path.read_text() == HEADER
    assert opened(path, session=4) == (0, 4, 0.0, 0)


def test_an_unfinished_header_is_written_anew(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(HEADER[:9])
    assert opened(path) == (0, 1, 0.0, 9)
    assert path.read_text() == HEADER


def test_rows_sessions_and_times_of_the_end_are_found_and_half_a_line_cut_off(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(HEADER + "1.5,2,0,3,4,,,\n2.25,3,1,3,4,,,\n3.0,3,")
    assert opened(path) == (2, 3, 2.25, 6)
    with growing_recording(path, ["F1-X1"], 1, 1, None) as found:
        assert found.cut_bytes == 0
        found.append([3.5, 3.0, 0.0, float("nan"), 0.25, 1.0, 2.0, -3.0])
        assert found.rows_added == 1
        with pytest.raises(RecordingError, match="7"):
            found.append([0.0] * 7)
    assert path.read_text().splitlines()[1:] == [
        "1.5,2,0,3,4,,,",
        "2.25,3,1,3,4,,,",
        "3.5,3,0,,0.25,1,2,-3",
    ]


@pytest.mark.parametrize("row", ["1.5,x,0,3,4,,,", "ten,2,0,3,4,,,"])
def test_a_last_row_that_cannot_be_followed_is_refused(tmp_path, row):
    path = tmp_path / "a.csv"
    path.write_text(HEADER + row + "\n")
    with pytest.raises(RecordingError, match="last row"):
        opened(path)


@pytest.mark.parametrize(
    "content",
    [
        HEADER.replace("F1-X1", "F2-X1"),
        HEADER.replace("F1-X1", "F2-X1")[:-1],
        "notes",
        HEADER[:-1] + " ",
        HEADER[1:],
        "\n" + HEADER,
    ],
)
def test_a_file_of_other_columns_is_refused_and_left_alone(tmp_path, content):
    path = tmp_path / "a.csv"
    path.write_text(content)
    with pytest.raises(RecordingError, match="columns"):
        opened(path)
    assert path.read_text() == content


def test_rows_are_on_the_disk_once_a_while(tmp_path, monkeypatch):
    """Synchronized where more than the time between has passed since the last one, not at every row."""
    now, synced = [100.0], []
    monkeypatch.setattr(growing, "time", SimpleNamespace(monotonic=lambda: now[0]))
    path, row = tmp_path / "a.csv", [1.0, 1.0, 0.0, 5.0, 0.25, 1.0, 2.0, -3.0]
    with growing_recording(path, ["F1-X1"], 1, 1, None) as found:
        monkeypatch.setattr(
            growing.os, "fsync", lambda handle: synced.append((now[0], found.rows_added))
        )
        found.append(row)
        for later_s in (0.5, 1.0, 1.01, 1.5, 2.5):
            now[0] = 100.0 + later_s * growing.SYNC_S
            found.append(row)
        assert found.rows_added == 6
    during = [entry for entry in synced if entry[1] < 6]
    assert during == [
        (100.0, 0),
        (100.0 + 1.01 * growing.SYNC_S, 3),
        (100.0 + 2.5 * growing.SYNC_S, 5),
    ]
    assert len(path.read_text().splitlines()) == 7
