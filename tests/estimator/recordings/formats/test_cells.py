"""Cells, labels and headers of recordings, at both sides of what is taken; refusals with their numbers."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from design.errors import RecordingError
from estimator.recordings.formats import files, generic, text
from estimator.recordings.formats.travel import read_travel

NAN = np.nan


def test_rows_without_cells_do_not_count_and_two_are_the_fewest():
    rows, digest = text.csv_rows(b"\xef\xbb\xbfa,b\r\n\r\n1,2\n")
    assert rows == [["a", "b"], ["1", "2"]]
    assert len(digest) == 64
    with pytest.raises(RecordingError, match="it holds one line"):
        text.csv_rows(b"a,b\n\n")


def test_numbers_tell_the_line_and_column_of_what_is_none():
    rows = [["1", "2"], ["", "-4e1"]]
    assert_array_equal(text.numbers(rows, ["a", "b"], 5), [[1, 2], [NAN, -40]])
    for spoiled, told in (
        ([["1", "2"], ["3"]], "line 6: 1 cells where 2 belong"),
        ([["1", "2"], ["3", "x"]], "line 6, column b: 'x' is not a number"),
        ([["inf", "2"]], "line 5, column a: infinite"),
    ):
        with pytest.raises(RecordingError, match=told):
            text.numbers(spoiled, ["a", "b"], 5)


@pytest.mark.parametrize(
    ("value", "good"),
    [(999_999.0, True), (1e6, False), (-999_999.0, True), (0.5, False), (NAN, False)],
)
def test_labels_are_whole_numbers_below_a_million(value, good):
    values = np.array([[1.0, value]])
    if good:
        assert text.whole(values, ["a", "b"]).tolist() == [[1, int(value)]]
    else:
        with pytest.raises(RecordingError, match="in column b is not a whole number"):
            text.whole(values, ["a", "b"])


def test_an_empty_cell_that_every_frame_needs_is_told_by_its_data_row():
    text.check_complete(np.ones((2, 2)), ["a", "b"])
    with pytest.raises(RecordingError, match="column b is empty in data row 2"):
        text.check_complete(np.array([[1.0, 2.0], [3.0, NAN]]), ["a", "b"])


def test_cells_are_written_as_short_as_they_can_be_read_back():
    cells = [generic.cell_text(value) for value in (1.5, 2.0, -0.1234567, NAN, 1e-7)]
    assert cells == ["1.5", "2", "-0.123457", "", "0"]


def test_columns_of_cells_tips_pulls_and_travel_stand_in_order():
    assert generic.generic_columns(["F1-X1"], 2, 2, shear=True, travel=True) == [
        "time_s", "session", "rest", "F1-X1",
        "cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm", "cell1_x2_mm", "cell1_y2_mm",
        "cell2_force_n", "cell2_face", "cell2_x1_mm", "cell2_y1_mm", "cell2_x2_mm", "cell2_y2_mm",
        "cell1_shear_x_n", "cell1_shear_y_n", "cell2_shear_x_n", "cell2_shear_y_n", "travel_mm",
    ]  # fmt: skip
    assert generic.generic_columns([], 1, 1) == [
        "time_s", "session", "rest", "cell1_force_n", "cell1_face", "cell1_x1_mm", "cell1_y1_mm",
    ]  # fmt: skip


def test_a_header_tells_its_cells_and_tips_and_what_it_lacks():
    whole = generic.generic_columns(["F5-Z12"], 2, 3, shear=True, travel=True)
    assert generic.check_header(whole) == (2, 3)
    assert generic.check_header(generic.generic_columns(["F1-X1"], 1, 1)) == (1, 1)
    for spoiled, told in (
        ([*whole, "F5-Z12"], "it names F5-Z12 twice"),
        ([*whole, "F7-X1"], "columns that are not known: 'F7-X1'"),
        ([*whole, "cell2_x4_mm"], "lacks|not known"),
        ([name for name in whole if name != "cell2_face"], "lacks the columns cell2_face"),
        (
            [name for name in whole if name != "cell1_shear_y_n"],
            "lacks the columns cell1_shear_y_n",
        ),
        ([name for name in whole if name != "F5-Z12"], "lacks the columns F1-X1"),
        (["time_s", "F1-X1"], "cell1_force_n, cell1_face, cell1_x1_mm, cell1_y1_mm"),
    ):
        if told == "lacks|not known":
            assert generic.check_header(spoiled) == (2, 4)
            continue
        with pytest.raises(RecordingError, match=told):
            generic.check_header(spoiled)


def test_a_place_needs_its_face_and_both_coordinates():
    def found(*cells):
        return generic.tip_places(np.array([[cells]], float))

    assert_array_equal(found(3, 1, 2, NAN, NAN), [[[[1, 2], [NAN, NAN]]]])
    assert_array_equal(found(0, NAN, NAN), [[[[NAN, NAN]]]])
    assert_array_equal(found(NAN, NAN, NAN), [[[[NAN, NAN]]]])
    for cells, told in (
        ((3, 1, NAN), "an x without its y"), ((3, 1, 2, NAN, 4), "an x without its y"),
        ((3, NAN, NAN), "a face without a place"), ((0, 1, 2), "a face without a place"),
        ((NAN, 1, 2), "a face without a place"),
    ):  # fmt: skip
        with pytest.raises(RecordingError, match=f"data row 1: load cell 1 has {told}"):
            found(*cells)
    late = np.full((3, 2, 3), NAN)
    late[2, 1] = [5, 1, NAN]
    with pytest.raises(RecordingError, match="data row 3: load cell 2 has"):
        generic.tip_places(late)


def test_faces_are_one_to_six_and_none_is_zero_or_empty():
    assert generic.face_labels(np.array([[1.0, 6], [0, NAN]])).tolist() == [[1, 6], [0, 0]]
    for wrong in (7.0, -1.0):
        with pytest.raises(RecordingError, match=f"got \\[{wrong:.0f}\\]"):
            generic.face_labels(np.array([[wrong]]))


def test_counts_stand_at_face_sensor_and_axis():
    column = {"F1-X1": np.array([1.0, 2]), "F5-Y3": np.array([3.0, 4]), "time_s": np.zeros(2)}
    found = generic.counts_of_column(column, 2)
    assert found.shape == (2, 5, 3, 3)
    assert found[:, 0, 0, 0].tolist() == [1, 2]
    assert found[:, 4, 2, 1].tolist() == [3, 4]
    assert np.isfinite(found).sum() == 4
    assert generic.counts_of_column({"F6-Z24": np.zeros(2)}, 2).shape == (2, 6, 24, 3)


def test_the_marker_of_no_reading_empties_channels_and_faces_with_their_places_alone():
    header = [
        "time_s",
        "F1-X1",
        "cell1_force_n",
        "cell1_face",
        "cell1_x1_mm",
        "cell2_face",
        "cell2_x1_mm",
    ]
    values = np.array([[-1.0, -1, -1, -1, 2, 3, -1], [1, 5, -1, 3, -1, -1, 8]])
    found = generic.without_marker(values, header, -1.0)
    assert_array_equal(found, [[-1, NAN, -1, NAN, NAN, 3, -1], [1, 5, -1, 3, -1, NAN, NAN]])
    assert values[0, 1] == -1
    assert generic.missing_marker([["# missing = -9.5"]]) == -9.5
    assert generic.missing_marker([["time_s"]]) is None


def test_snake_labels_are_places_and_0_and_101_are_none():
    found = files.places_mm(np.array([[[0, 1]], [[100, 101]]]))
    assert np.isnan(found[0, 0, 0]).all()
    assert np.isnan(found[1, 0, 1]).all()
    assert abs(found[0, 0, 1]).tolist() == abs(found[1, 0, 0]).tolist() == [13.5, 13.5]
    for wrong in (-1, 102):
        with pytest.raises(RecordingError, match=f"got \\[{wrong}\\]"):
            files.places_mm(np.array([[[wrong]]]))


def travel(folder, sensor, state):
    folder.mkdir(exist_ok=True)
    (folder / "sensor.csv").write_text("\n".join(sensor) + "\n")
    (folder / "states.csv").write_text("\n".join(state) + "\n")
    return read_travel(folder)


def test_readings_of_known_travel_are_taken_up_to_their_limits(tmp_path):
    sensor = ["0,1e6,-1e6,3", "11,4,5,6", "12,0,0,0"]
    state = ["1,1e4,-1e4,0,-1", "10,1.4,2,3,7.5", "12,0.6,2.4,1,-2"]
    found = travel(tmp_path, sensor, state)
    assert len(found) == 3
    assert_array_equal(found.field_mt[0, 0], [1000, -1000, 0.003])
    assert_array_equal(found.tip_mm[1], [1.4, 2, 3])
    assert_array_equal(found.load, [NAN, 7.5, -2])
    assert found.places == 2
    assert found.place_id[1] == found.place_id[2]
    some = found.select(np.array([False, True, True]))
    assert (len(some), some.load.tolist()) == (2, [7.5, -2])


@pytest.mark.parametrize(
    ("sensor", "state", "told"),
    [
        ("3,1,2,3", "4.01,0,0,0", "row 2: sensor.csv and states.csv are 1.01 s apart"),
        ("3,1,2,1.01e6", "3,0,0,0", r"line 2: reading 3 is 1.01e\+06, beyond ±1e\+06"),
        ("3,1,2,3", "3,0,-10001,0", r"line 2: y is -10001, beyond ±10000"),
        ("3,1,2", "3,0,0,0", "line 2: 3 cells where 4 belong"),
    ],
)
def test_readings_beyond_them_are_told_by_line_and_column(tmp_path, sensor, state, told):
    with pytest.raises(RecordingError, match=told):
        travel(tmp_path, ["0,1,2,3", sensor], ["0,0,0,0", state])


@pytest.mark.parametrize(
    ("cells", "sound"), [(3, False), (4, True), (5, False), (6, False), (7, True)]
)
def test_a_line_holds_a_time_and_three_readings_for_every_chip(tmp_path, cells, sound):
    line = ",".join(["0"] * cells)
    if sound:
        assert travel(tmp_path, [line] * 2, ["0,0,0,0"] * 2).field_mt.shape[1] == (cells - 1) // 3
    else:
        with pytest.raises(RecordingError, match=f"line 1 holds {cells} cells"):
            travel(tmp_path, [line] * 2, ["0,0,0,0"] * 2)


@pytest.mark.parametrize(("cells", "sound"), [(3, False), (4, True), (5, True), (6, False)])
def test_a_state_holds_time_place_and_perhaps_a_load(tmp_path, cells, sound):
    line = ",".join(["0"] * cells)
    if sound:
        assert (travel(tmp_path, ["0,1,2,3"] * 2, [line] * 2).load is None) == (cells == 4)
    else:
        with pytest.raises(RecordingError, match=f"line 1 holds {cells} cells"):
            travel(tmp_path, ["0,1,2,3"] * 2, [line] * 2)
