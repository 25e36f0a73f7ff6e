"""What a file says that was nearly right: one sentence with the cause and the cure."""

import pytest

from design.errors import RecordingError
from estimator.recordings.reading import read_recording

HEADER = "time_s,rest,F1-X1,F1-Y1,F1-Z1,cell1_force_n,cell1_face,cell1_x1_mm,cell1_y1_mm"
ROWS = "0.1,1,5,6,7,0.2,1,0,0", "0.2,1,6,6,7,1.2,1,0,0"
TEXT = "\n".join([HEADER, *ROWS])


def message(tmp_path, text, encoding="utf-8"):
    path = tmp_path / "file.csv"
    path.write_bytes(text.encode(encoding))
    with pytest.raises(RecordingError) as told:
        read_recording(path)
    return str(told.value).removeprefix(f"{path}: ")


@pytest.mark.parametrize(
    ("old", "new", "begins"),
    [
        (
            "cell1_force_n",
            "cell1_force [N]",
            "cell1_force_n is missing (there is 'cell1_force [N]')",
        ),
        ("cell1_face", "Cell1 Face", "cell1_face is missing (there is 'Cell1 Face')"),
        ("time_s", "Time [s]", "time_s is missing (there is 'Time [s]')"),
        ("F1-X1", "F1_X1", "column 'F1_X1' is not known: did you mean F1-X1?"),
        ("F1-Z1", "f1-z1", "column 'f1-z1' is not known: did you mean F1-Z1?"),
        ("rest", "resting", "it has columns that are not known: 'resting'"),
        (",cell1_force_n", "", "it lacks the columns cell1_force_n"),
    ],
)
def test_a_column_that_is_nearly_right_is_named_with_what_was_meant(tmp_path, old, new, begins):
    assert message(tmp_path, TEXT.replace(old, new)).startswith(begins)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("time_ms", "seconds; divide by 1000"),
        ("time [ms]", "seconds; divide by 1000"),
        ("time (µs)", "seconds; divide by 1 000 000"),
        ("t", "seconds"),
        ("timestamp", "seconds"),
    ],
)
def test_a_time_of_another_name_or_unit_is_asked_for_in_seconds(tmp_path, name, unit):
    text = message(tmp_path, TEXT.replace("time_s", name))
    assert text.startswith(f"column {name!r} is not known: did you mean time_s ({unit})? `instobj")


def test_all_columns_that_are_nearly_right_are_named_at_once(tmp_path):
    header = HEADER.replace("time_s", "time [s]").replace("force_n", "force [N]")
    text = message(tmp_path, TEXT.replace(HEADER, header.replace("rest", "resting")))
    assert text.startswith(
        "2 columns are not known: did you mean time_s for 'time [s]', cell1_force_n for 'cell1_force "
        "[N]'? Not known either: 'resting'; `instobj docs"
    )
    grams = (
        HEADER.replace("force_n", "force (g)").replace("F1-X1", "F1_X1").replace("F1-Y1", "F1_Y1")
    )
    text = message(tmp_path, TEXT.replace(HEADER, grams))
    assert "F1-X1 for 'F1_X1', F1-Y1 for 'F1_Y1', cell1_force_g for 'cell1_force (g)'? `i" in text
    assert "lacks" not in text


def test_an_own_file_whose_time_is_named_as_the_grippers_says_how_to_name_it(tmp_path):
    text = message(tmp_path, TEXT.replace("time_s", "Time"))
    assert text.startswith(
        "its first column 'Time' means the public gripper format, and it lacks the columns Left, "
        "Right-blue. In a file of your own name it time_s (seconds); `instobj docs"
    )
    both = message(tmp_path, TEXT.replace("time_s", "Time").replace("cell1_force_n", "Fz"))
    assert "name it time_s (seconds); then it has columns that are not known: 'Fz'" in both
    assert "it lacks cell1_force_n" in both


@pytest.mark.parametrize("name", ["", "Unnamed: 0"])
def test_the_index_of_pandas_is_told(tmp_path, name):
    rows = [f"{k},{row}" for k, row in enumerate(ROWS)]
    told = message(tmp_path, "\n".join([f"{name},{HEADER}", *rows]))
    assert told.startswith("a column has no name: written by pandas with its index?")
    assert "index=False" in told


def test_stamps_of_a_calendar_are_told_once(tmp_path):
    told = message(tmp_path, TEXT.replace("0.1,1,", "2026-03-01 10:00:00.000,1,"))
    assert told.startswith(
        "time_s must be seconds; got ISO stamps such as '2026-03-01 10:00:00.000'"
    )


def test_semicolons_and_tabs_are_told(tmp_path):
    european = TEXT.replace(",", ";").replace(".", ",")
    assert message(tmp_path, european).startswith("the separator is a semicolon. Use commas, and")
    assert message(tmp_path, TEXT.replace(",", "\t")).startswith("the separator is a tab")


def test_another_encoding_is_told_with_its_line(tmp_path):
    text = TEXT.replace("rest", "rést")
    assert message(tmp_path, text, "latin-1") == "it is not UTF-8 (line 1). Save it as UTF-8"
    assert "'rést'" in message(tmp_path, text, "utf-8-sig")  # a mark of the byte order is no fault


def test_a_recording_without_any_reading_is_one_error(tmp_path):
    """As `collect` writes it where no chip answers."""
    rows = [f"{k / 100},1,,,,{1 + k % 7},1,0,0" for k in range(60)]
    told = message(tmp_path, "\n".join([HEADER.replace("rest", "session"), *rows]))
    assert told.startswith("no channel has a reading in any of its 60 frames")
