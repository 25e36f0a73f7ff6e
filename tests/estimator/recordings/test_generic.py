"""The generic recording: the same presses as CSV and NetCDF, in any order and other units."""

import csv
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from estimator.recordings.combine import combine
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.generic import generic_columns, is_unlabelled
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.presses import LagReport
from estimator.recordings.reading import read_recording
from tests.support.recordings.generic_csv import write_generic_csv


def test_both_forms_hold_what_the_gripper_file_holds(table, tmp_path):
    write_generic_csv(table, tmp_path / "a.csv")
    write_generic_netcdf(table, tmp_path / "a.nc")
    as_csv, as_netcdf = read_table(tmp_path / "a.csv"), read_table(tmp_path / "a.nc")
    for name in ("time_s", "force_n", "counts", "face", "tip_xy_mm", "grid_x_mm"):
        assert_allclose(getattr(as_csv, name), getattr(table, name), atol=2e-6)
        assert_allclose(getattr(as_netcdf, name), getattr(table, name), atol=1e-6)
    assert as_csv.kind == as_netcdf.kind == "generic"


def test_the_same_content_is_known_as_the_same_recording(table, tmp_path):
    write_generic_csv(table, tmp_path / "a.csv")
    written = read_table(tmp_path / "a.csv")
    write_generic_netcdf(written, tmp_path / "a.nc")
    assert read_table(tmp_path / "a.nc").digest == written.digest
    louder = replace(written, counts=written.counts + 1.0)
    write_generic_netcdf(louder, tmp_path / "b.nc")
    assert read_table(tmp_path / "b.nc").digest != written.digest


def test_the_data_set_is_that_of_the_gripper_file(gripper, table, tmp_path):
    write_generic_netcdf(table, tmp_path / "a.nc")
    own, generic = read_recording(gripper), read_recording(tmp_path / "a.nc")
    assert generic.report.places == own.report.places
    assert generic.report.presses == own.report.presses
    assert generic.report.lag.frames == own.report.lag.frames == 8
    both = own.frames.valid & generic.frames.valid
    assert both.sum() > 0.95 * own.frames.valid.sum()
    assert_allclose(own.frames.signal_counts[both], generic.frames.signal_counts[both], atol=40)
    assert_array_equal(own.frames.contact_xy_mm[both], generic.frames.contact_xy_mm[both])


def test_columns_in_any_order_and_missing_channels(good, table, tmp_path):
    rows = list(csv.reader(good.splitlines()))
    order = np.random.default_rng(4).permutation(len(rows[0]))
    order = [k for k in order if rows[0][k] not in ("F1-X1", "session", "rest")]
    with (tmp_path / "a.csv").open("w", newline="") as file:
        csv.writer(file).writerows([[row[k] for k in order] for row in rows])
    read = read_table(tmp_path / "a.csv")
    assert np.isnan(read.counts[:, 0, 0, 0]).all()
    assert_array_equal(read.counts[:, 4], table.counts[:, 4])
    assert_allclose(read.force_n, table.force_n, atol=2e-6)
    assert set(read.case) == {1}
    assert not read.declared_rest.any()


def made(tmp_path, sensors=4, label_rest=True, tips=1):
    """An object with other sensors: presses of face 2 at two places, one load cell."""
    rng = np.random.default_rng(8)
    names = [f"F{f}-{a}{s}" for f in (1, 2) for s in range(1, sensors + 1) for a in "XYZ"]
    gain = rng.uniform(20, 60, (2, len(names))) * rng.choice([-1, 1], (2, len(names)))
    gain[:, : 3 * sensors] *= 0.05
    shape = np.concatenate([np.zeros(30), np.linspace(0, 1, 30) ** 2, np.linspace(1, 0, 30)])
    rows = []
    for press in range(8):
        place = press % 2
        for k, level in enumerate(shape):
            force = (6 + press) * level
            counts = 200 + gain[place] * force + rng.normal(0, 12, len(names))
            label = [2, -3.5, 6.25] if place else [2, 4.0, 0.0]
            stated = label if label_rest or force > 0 else ["", "", ""]
            stated = [*stated, *[""] * (2 * tips - 2)]
            rows.append(
                [
                    f"{9 * press + k / 10:.3f}",
                    1 + press // 4,
                    0,
                    *np.round(counts),
                    f"{force:.4f}",
                    *stated,
                ]
            )
    with (tmp_path / "made.csv").open("w", newline="") as file:
        csv.writer(file).writerows([generic_columns(names, 1, tips), *rows])
    return tmp_path / "made.csv"


def test_frames_without_any_reading_of_a_face_or_of_all_are_not_used(tmp_path):
    path = made(tmp_path)
    rows = [line.split(",") for line in path.read_text().splitlines()]
    whole = read_recording(path).frames
    one = [k for k, name in enumerate(rows[0]) if name.startswith("F1-")]
    every = [k for k, name in enumerate(rows[0]) if name.startswith("F")]
    for row, columns in ((50, one), (51, every), (200, every)):
        for k in columns:
            rows[row + 1][k] = ""
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    found = read_recording(path).frames
    assert np.flatnonzero(whole.valid & ~found.valid).tolist() == [50, 51, 200]


def test_a_pressed_face_without_channels_is_told(tmp_path):
    path = made(tmp_path)
    rows = [line.split(",") for line in path.read_text().splitlines()]
    for row in rows[1:]:
        row[-3] = "4"
    path.write_text("\n".join(",".join(row) for row in rows) + "\n")
    (fault,) = read_recording(path).report.faults
    assert (fault.kind, fault.where) == ("pressed face without readings", "face 4")


def test_rest_labelled_with_a_place_is_no_press_and_a_lag_that_cannot_be_told_is_not_0(tmp_path):
    path = made(tmp_path)
    lines = path.read_text().splitlines()
    rest = [line.split(",") for line in lines[-31:-1]]
    for k, row in enumerate(rest):
        row[0], row[-3:] = f"{80 + k / 10:.1f}", ["1", "-6", "-6"]
        row[-4] = "0"
    path.write_text("\n".join([*lines, *(",".join(row) for row in rest)]) + "\n")
    report = read_recording(path).report
    assert report.presses == 8
    assert "force lag: 0 frames" in str(report)
    untold = replace(report, lag=LagReport(0, (), 0.0, 1.0, 1.0, False))
    assert "force lag: not known, so not corrected" in str(untold)


@pytest.mark.parametrize("label_rest", [True, False])
def test_another_object_with_other_sensors(tmp_path, label_rest):
    """Four sensors on two faces, continuous places, one load cell; places stated always or only
    while pressed."""
    recording = read_recording(made(tmp_path, label_rest=label_rest))
    frames, report = recording.frames, recording.report
    assert frames.signal_counts.shape == (720, 5, 4, 3)
    assert report.places == (((2, -3.5, 6.25),), ((2, 4.0, 0.0),))
    assert (report.presses, report.sessions, report.tips) == (8, 2, 1)
    assert not report.lag.corrected
    assert not report.faults
    assert_allclose(np.nanmax(frames.force_n[..., 2]), 13.0, atol=0.1)
    loaded = frames.valid & (frames.place_id >= 0)
    assert loaded.sum() > 300
    assert_allclose(frames.signal_counts[frames.place_id < 0][:, 1].mean(), 0, atol=5)


def test_the_grid_of_an_object_of_its_own(tmp_path):
    grid = np.arange(7) * 5.0 - 15.0, np.arange(3) * 4.0 - 4.0
    frames = read_recording(made(tmp_path), grid).frames
    assert_array_equal(frames.grid_x_mm, grid[0])
    assert_array_equal(frames.grid_y_mm, grid[1])


def test_recordings_of_different_objects_are_not_combined(tmp_path, gripper):
    own, other = read_recording(gripper), read_recording(made(tmp_path))
    with pytest.raises(InputError, match="5 × 3 and 5 × 4"):
        combine([own, other])
    grid = np.arange(7) * 5.0 - 15.0, np.arange(3) * 4.0 - 4.0
    louder = replace(own, frames=replace(own.frames, spec_hash="other", grid_x_mm=grid[0]))
    with pytest.raises(InputError, match="one contact grid"):
        combine([own, louder])


def scaled(tmp_path, good, names, factor):
    rows = list(csv.reader(good.splitlines()))
    for column in (k for k, name in enumerate(rows[0]) if name in names):
        for row in rows[1:]:
            row[column] = f"{float(row[column] or 'nan') * factor:.9g}".replace("nan", "")
    with (tmp_path / "scaled.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    return tmp_path / "scaled.csv"


def test_forces_in_grams_are_read_as_newtons(tmp_path, good):
    names = ["cell1_force_n", "cell2_force_n"]
    path = scaled(tmp_path, good, names, 1 / 9.80665e-3)
    path.write_text(path.read_text().replace("_force_n", "_force_g"))
    frames, expected = read_recording(path).frames, read_table_of(tmp_path, good)
    assert_allclose(frames.force_n, expected.force_n, atol=2e-5)


def read_table_of(tmp_path, text):
    path = tmp_path / "as_it_is.csv"
    path.write_text(text)
    return read_recording(path).frames


def test_a_named_number_stands_for_no_reading(tmp_path, good):
    rows = list(csv.reader(good.splitlines()))
    column = {name: k for k, name in enumerate(rows[0])}
    rows[40][column["F3-Y1"]], empty = "-1", [list(row) for row in rows]
    empty[40][column["F3-Y1"]] = ""
    rows[40][column["cell1_x1_mm"]] = empty[40][column["cell1_x1_mm"]] = "-1"
    for name in ("cell2_face", "cell2_x1_mm", "cell2_y1_mm"):
        rows[50][column[name]], empty[50][column[name]] = "-1", ""
    for row in empty[1:]:  # readings that are −1 by chance are taken for the marker, too
        row[:] = [
            "" if cell == "-1" and name.startswith("F") else cell
            for name, cell in zip(empty[0], row, strict=True)
        ]
    text = "\n".join(map(",".join, rows))
    marked, plain = tmp_path / "marked.csv", tmp_path / "plain.csv"
    marked.write_text(f"# missing = -1\n{text}")
    plain.write_text("\n".join(map(",".join, empty)))
    found, expected = read_table(marked), read_table(plain)
    assert_array_equal(found.counts, expected.counts)
    assert_array_equal(found.tip_xy_mm, expected.tip_xy_mm)
    assert_array_equal(found.face, expected.face)
    assert np.isnan(found.counts[39, 2, 0, 1])
    assert found.tip_xy_mm[39, 0, 0, 0] == -1.0


@pytest.mark.parametrize("remark", ["# missing = none", "# made by hand", "# missing = 1_0"])
def test_another_remark_before_the_header_is_refused(tmp_path, good, remark):
    path = tmp_path / "remark.csv"
    path.write_text(f"{remark}\n{good}")
    with pytest.raises(InputError, match="only `# missing = NUMBER` may"):
        read_recording(path)


PLACES = [f"cell{c}_{a}1_mm" for c in (1, 2) for a in "xy"]


@pytest.mark.parametrize(
    ("names", "factor", "words"),
    [
        (["cell1_force_n"], 1000 / 9.8, "forces in N"),
        (PLACES, 1e-3, "not in m"),
        (PLACES[2:], 1e-3, "load cell 2 .* not in m"),
        (PLACES, 1e3, "places in mm"),
        (["time_s"], 1e3, "not ms"),
        (["F3-X1"], 1e7, "raw counts"),
        (["cell1_face"], 1.5, "whole number"),
    ],
)
def test_other_units_are_noticed(tmp_path, good, names, factor, words):
    with pytest.raises(InputError, match=words):
        read_recording(scaled(tmp_path, good, names, factor))


@pytest.mark.parametrize(
    ("header", "unlabelled"),
    [
        ("time_s,F1-X1,F1-Y1", True), ("rest,time_s,F1-X1", True), ("F1-X1,F1-Y1", False),
        ("time_s,session", False), ("time_s,F1-X1,cell1_force_n", False),
        ("time_s,F1-X1,cell1_force_n,cell1_face", False), ("time,F1-X1", False),
    ],
)  # fmt: skip
def test_stamps_and_channels_without_load_cells_are_unlabelled(header, unlabelled):
    assert is_unlabelled(header.split(",")) == unlabelled
