"""Every column of every format: whose numbers go where, and how it is named when a cell is wrong."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import RecordingError
from estimator.frames.heatmap import label_grid_mm, label_to_pixel, pixel_to_mm
from estimator.recordings.formats.files import read_table

SENSOR = [f"{axis}{sensor}" for sensor in (1, 2, 3) for axis in "XYZ"]
GRIPPER = [f"F{face}-{name}" for face in (5, 3, 1, 2, 4) for name in SENSOR]


def gripper(tips):
    """Header and three rows of counts that tell their own column, forces 100 and 200 grams."""
    positions = [f"Probe_Pos_{k + 1}" for k in range(tips)]
    second = ["Probe_Pos_2"] if tips == 1 else positions
    header = ["Time", "Left", "Right-blue", *GRIPPER, "Probe_Face_1", *positions]
    header += ["Probe_Face_2", *second]
    places = [11 + k for k in range(tips)]
    other = [61 + k for k in range(tips)]
    rows = [
        [row, 100, 200, *(1000 * row + np.arange(45)), 2, *places, 4, *other] for row in range(3)
    ]
    return [header, *rows]


def training(tips):
    """Three rows of face 4, case 34, forces 1 to 3 N, counts 10 to 18 and places 21, 22, …"""
    places = [] if tips == 1 else [21 + k for k in range(tips)]
    return [[4, 34, 1.0 + row, *(10 * row + np.arange(10, 19)), *places] for row in range(3)]


def written(path, rows):
    path.write_text("\n".join(",".join(map(str, row)) for row in rows))
    return path


def places_mm(*labels):
    return pixel_to_mm(label_to_pixel(np.array(labels)), *label_grid_mm())


@pytest.mark.parametrize("tips", [1, 2, 3])
def test_gripper_columns_are_put_in_order_of_faces(tmp_path, tips):
    table = read_table(written(tmp_path / "a.csv", gripper(tips)))
    assert (table.kind, table.counts.shape) == ("gripper", (3, 5, 3, 3))
    for name, value in zip(GRIPPER, range(45), strict=True):
        face, axis, sensor = int(name[1]), "XYZ".index(name[3]), int(name[4])
        assert_allclose(
            table.counts[:, face - 1, sensor - 1, axis], [value + 1000 * k for k in range(3)]
        )
    assert_allclose(table.force_n, [[0.98, 1.96]] * 3)
    assert_array_equal(table.face, [[2, 4]] * 3)
    assert_allclose(table.tip_xy_mm[1, 0], places_mm(*(11 + k for k in range(tips))))
    assert_allclose(table.tip_xy_mm[2, 1], places_mm(*(61 + k for k in range(tips))))
    assert_array_equal(table.time_s, [0, 1, 2])
    assert not table.declared_rest.any()
    assert not table.case.any()
    expected = ("Probe_Pos_1", "Probe_Pos_2", "Probe_Pos_3")[:tips] if tips > 1 else ()
    assert table.duplicate_columns == expected


@pytest.mark.parametrize("tips", [1, 2, 3])
def test_training_columns_hold_one_face_and_places_of_the_case_or_of_each_tip(tmp_path, tips):
    table = read_table(written(tmp_path / "a.csv", training(tips)))
    assert (table.kind, table.counts.shape) == ("training", (3, 5, 3, 3))
    assert np.isnan(np.delete(table.counts, 3, axis=1)).all()
    assert_allclose(table.counts[2, 3].ravel(), np.arange(30, 39))
    assert_allclose(table.force_n[:, 0], [1, 2, 3])
    assert_array_equal(table.face, [[4]] * 3)
    assert_array_equal(table.case, [34] * 3)
    labels = [34] if tips == 1 else [21 + k for k in range(tips)]
    assert_allclose(table.tip_xy_mm[0, 0], places_mm(*labels))
    assert not table.declared_rest.any()


@pytest.mark.parametrize("case", [0, 101])
def test_training_cases_without_contact_have_no_places(tmp_path, case):
    rows = [[row[0], case, *row[2:]] for row in training(2)]
    table = read_table(written(tmp_path / "a.csv", rows))
    assert table.declared_rest.all()
    assert np.isnan(table.tip_xy_mm).all()


@pytest.mark.parametrize("make", [gripper, training])
@pytest.mark.parametrize("tips", [1, 2, 3])
def test_every_wrong_cell_is_named_by_its_line_and_column(tmp_path, make, tips):
    good = make(tips)
    names = good[0] if make is gripper else ["face", "case", "force", *SENSOR]
    if make is training and tips > 1:
        names = [*names, *(f"position {k + 1}" for k in range(tips))]
    assert len(names) == len(good[-1])
    for column, name in enumerate(names):
        rows = [list(row) for row in good]
        rows[-1][column] = "x"
        with pytest.raises(RecordingError) as told:
            read_table(written(tmp_path / "a.csv", rows))
        assert f"line {len(rows)}, column {name}: 'x' is not a number" in str(told.value)
    for column in (0, 1, 2):
        rows = [list(row) for row in good]
        rows[-1][column] = ""
        with pytest.raises(RecordingError, match=f"column {names[column]} is empty in data row 3"):
            read_table(written(tmp_path / "a.csv", rows))


@pytest.mark.parametrize("make", [gripper, training])
@pytest.mark.parametrize("label", [-1, 102])
def test_labels_of_places_end_at_those_that_say_nothing_touches(tmp_path, make, label):
    """0 and 101 say that nothing touches, 1 to 100 are places."""
    column = 49 if make is gripper else 12
    for inside, held in ((0, False), (1, True), (100, True), (101, False)):
        rows = [list(row) for row in make(2)]
        rows[-1][column] = inside
        table = read_table(written(tmp_path / "a.csv", rows))
        assert np.isfinite(table.tip_xy_mm[-1, 0, 0]).all() == held
    rows[-1][column] = label
    with pytest.raises(RecordingError, match=rf"must be 0…101; got \[{label}\]"):
        read_table(written(tmp_path / "a.csv", rows))


@pytest.mark.parametrize("make", [gripper, training])
def test_faces_are_one_to_five(tmp_path, make):
    column = 48 if make is gripper else 0
    for face in (0, 6):
        rows = [list(row) for row in make(2)]
        rows[-1][column] = face
        with pytest.raises(RecordingError, match=rf"must be 1…5; got \[{face}\]"):
            read_table(written(tmp_path / "a.csv", rows))


@pytest.mark.parametrize(("columns", "words"), [(11, "11"), (13, "13"), (16, "16")])
def test_training_files_have_12_14_or_15_columns(tmp_path, columns, words):
    rows = [row[:columns] for row in training(3)]
    rows = [[*row, *([1] * (columns - len(row)))] for row in rows]
    with pytest.raises(RecordingError, match=f"it has {words} columns without a header"):
        read_table(written(tmp_path / "a.csv", rows))


def test_a_training_file_may_name_its_columns_which_then_count_as_line_1(tmp_path):
    names = ["Face", "Case", "Force", *SENSOR]
    table = read_table(written(tmp_path / "a.csv", [names, *training(1)]))
    assert_allclose(table.force_n[:, 0], [1, 2, 3])
    rows = [names, *training(1)]
    rows[2][5] = "x"
    with pytest.raises(RecordingError, match="line 3, column Z1"):
        read_table(written(tmp_path / "a.csv", rows))
