"""The generic recording: the same presses as CSV and NetCDF, in any order, damaged in any way."""

import csv
from dataclasses import replace

import h5py
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from estimator.recordings.combine import combine
from estimator.recordings.files import read_table
from estimator.recordings.generic import generic_columns
from estimator.recordings.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording
from tests.support.generic_csv import write_generic_csv
from tests.support.made_recordings import gripper_arrays, write_gripper

CASES = ((54, 57), (23, 28))


@pytest.fixture(scope="module")
def gripper(tmp_path_factory):
    return write_gripper(tmp_path_factory.mktemp("g") / "g.csv", gripper_arrays(CASES), CASES)


@pytest.fixture(scope="module")
def table(gripper):
    return read_table(gripper)


@pytest.fixture(scope="module")
def good(table, tmp_path_factory):
    """A short CSV of two load cells, one tip each."""
    path = tmp_path_factory.mktemp("c") / "good.csv"
    write_generic_csv(table, path)
    return path.read_text()


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
    with pytest.raises(InputError, match="3 and 4 sensors per face"):
        combine([own, other])
    grid = np.arange(7) * 5.0 - 15.0, np.arange(3) * 4.0 - 4.0
    louder = replace(own, frames=replace(own.frames, spec_hash="other", grid_x_mm=grid[0]))
    with pytest.raises(InputError, match="one contact grid"):
        combine([own, louder])


def edited(tmp_path, text, old, new, count=1):
    assert old in text
    path = tmp_path / "edited.csv"
    path.write_text(text.replace(old, new, count))
    return path


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("time_s", "time_ms", "'time_ms'"),
        ("cell1_force_n", "cell1_force_kg", "'cell1_force_kg'"),
        ("cell2_x1_mm", "cell2_x1_cm", "'cell2_x1_cm'"),
        ("cell2_x1_mm,", "cell2_y1_mm,", "twice"),
        ("F1-X1", "F7-X1", "'F7-X1'"),
        ("F1-X1", "F1-Y1", "twice"),
        ("cell1_force_n,cell1_face", "cell1_face,cell1_y9_mm", "not known|lacks"),
    ],
)
def test_headers_with_one_mistake(tmp_path, good, old, new, words):
    with pytest.raises(InputError, match=words):
        read_recording(edited(tmp_path, good, old, new))


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
        (PLACES, 1e3, "places in mm"),
        (["time_s"], 1e3, "not ms"),
        (["F3-X1"], 1e7, "raw counts"),
        (["cell1_face"], 1.5, "whole number"),
        (["cell1_face"], 3, "face labels must be 1…5"),
    ],
)
def test_other_units_are_noticed(tmp_path, good, names, factor, words):
    with pytest.raises(InputError, match=words):
        read_recording(scaled(tmp_path, good, names, factor))


def test_half_a_label_is_an_error(tmp_path, good):
    rows = list(csv.reader(good.splitlines()))
    for name, words in (("cell1_x1_mm", "an x without its y"), ("cell1_face", "a face without")):
        damaged = [list(row) for row in rows]
        damaged[5][rows[0].index(name)] = ""
        with (tmp_path / "a.csv").open("w", newline="") as file:
            csv.writer(file).writerows(damaged)
        with pytest.raises(InputError, match=words):
            read_recording(tmp_path / "a.csv")


SHEAR_SHARE = np.array([[0.3, -0.2], [-0.1, 0.25]])
SHEAR_REST_N = np.array([[1.5, 0.0], [0.0, -0.7]])


def with_shear(table, late_frames=0):
    """Cells of three axes that are pulled in proportion, each with a resting level of its own."""
    force = np.roll(table.force_n, late_frames, axis=0)[..., None]
    return replace(table, shear_n=force * SHEAR_SHARE + SHEAR_REST_N)


@pytest.fixture(scope="module")
def sheared(table, tmp_path_factory):
    """The short CSV with tangential forces."""
    path = tmp_path_factory.mktemp("s") / "sheared.csv"
    write_generic_csv(with_shear(table), path)
    return path.read_text()


def test_tangential_forces_survive_both_forms(table, sheared, tmp_path):
    (tmp_path / "a.csv").write_text(sheared)
    as_csv = read_table(tmp_path / "a.csv")
    assert_allclose(as_csv.shear_n, with_shear(table).shear_n, atol=2e-6)
    write_generic_netcdf(as_csv, tmp_path / "a.nc")
    as_netcdf = read_table(tmp_path / "a.nc")
    assert_array_equal(as_netcdf.shear_n, as_csv.shear_n)
    assert as_netcdf.digest == as_csv.digest
    write_generic_csv(as_netcdf, tmp_path / "b.csv")
    assert (tmp_path / "b.csv").read_text() == sheared
    write_generic_netcdf(replace(as_csv, shear_n=-as_csv.shear_n), tmp_path / "c.nc")
    assert read_table(tmp_path / "c.nc").digest != as_csv.digest
    write_generic_netcdf(table, tmp_path / "plain.nc")
    assert read_table(tmp_path / "plain.nc").shear_n is None


@pytest.mark.parametrize("late_frames", [0, 4])
def test_tangential_labels_stand_beside_the_normal_ones(table, tmp_path, late_frames):
    """Rest level off, lag corrected; planted fault: tangential forces 4 frames later than those."""
    write_generic_netcdf(with_shear(table, late_frames), tmp_path / "a.nc")
    frames = read_recording(tmp_path / "a.nc").frames
    error_n = []
    for cell in range(2):
        force = frames.force_n[frames.valid & (frames.contact_face[:, cell] > 0), cell]
        assert force[:, 2].max() > 10
        error_n.append(np.abs(force[:, :2] - force[:, 2:] * SHEAR_SHARE[cell]).max())
    assert (max(error_n) < 0.05) == (late_frames == 0)
    assert np.isnan(frames.force_n[frames.contact_face == 0]).all()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("cell1_shear_x_n", "cell1_shear_x_mn", "'cell1_shear_x_mn'"),
        ("cell1_shear_x_n", "cell3_shear_x_n", "'cell3_shear_x_n'"),
        ("cell2_shear_y_n", "cell2_shear_x_n", "twice"),
        (",cell2_shear_y_n", "", "lacks the columns cell2_shear_y_n"),
    ],
)
def test_headers_with_a_mistake_in_tangential_forces(tmp_path, sheared, old, new, words):
    with pytest.raises(InputError, match=words):
        read_recording(edited(tmp_path, sheared, old, new))


@pytest.mark.parametrize(
    ("value", "words"),
    [("", "cell1_shear_y_n is empty"), ("much", "not a number"), ("4e3", "shear forces")],
)
def test_impossible_tangential_forces(tmp_path, sheared, value, words):
    rows = list(csv.reader(sheared.splitlines()))
    rows[9][rows[0].index("cell1_shear_y_n")] = value
    with (tmp_path / "a.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    with pytest.raises(InputError, match=words):
        read_recording(tmp_path / "a.csv")


def outcome(path):
    """Whether the file read well, or failed with one message that names it."""
    try:
        recording = read_recording(path)
    except InputError as error:
        return path.name in str(error) and len(str(error)) < 700
    return len(recording.frames) > 0 and bool(np.isfinite(recording.frames.time_s).all())


@settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.data())
def test_fuzzed_csv_gives_one_clear_error(tmp_path, good, sheared, data):
    """Truncated, reordered, text in numbers, empty, NaN, huge or binary."""
    lines = data.draw(st.sampled_from([good, sheared])).splitlines()[:260]
    for _ in range(data.draw(st.integers(1, 3))):
        kind = data.draw(st.sampled_from(["cell", "cut", "swap", "drop", "bytes"]))
        row = data.draw(st.integers(0, len(lines) - 1))
        if kind == "cell":
            cells = lines[row].split(",")
            column = data.draw(st.integers(0, len(cells) - 1))
            odd = ["", "abc", "nan", "inf", "-1e308", "9e99", "1,2", "0x1F", "½", "1e-400", "-0"]
            cells[column] = data.draw(st.sampled_from(odd) | st.text(max_size=8))
            lines[row] = ",".join(cells)
        elif kind == "cut":
            lines = [*lines[:row], lines[row][: data.draw(st.integers(0, len(lines[row])))]]
        elif kind == "swap":
            other = data.draw(st.integers(0, len(lines) - 1))
            lines[row], lines[other] = lines[other], lines[row]
        elif kind == "drop":
            del lines[row]
        else:
            lines[row] = data.draw(st.binary(max_size=60)).decode("latin-1")
        lines = lines or [""]
    path = tmp_path / "fuzzed.csv"
    path.write_bytes("\n".join(lines).encode("utf-8", "surrogatepass"))
    assert outcome(path)


@settings(
    max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(content=st.binary(max_size=400))
def test_any_bytes_at_all(tmp_path, content):
    for name in ("any.csv", "any.nc"):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(InputError, match=name):
            read_recording(tmp_path / name)


@pytest.mark.parametrize("missing", ["counts", "cell_face", "time_s", "schema"])
def test_netcdf_without_something(tmp_path, table, missing):
    write_generic_netcdf(table, tmp_path / "a.nc")
    with h5py.File(tmp_path / "a.nc", "a") as file:
        if missing == "schema":
            del file.attrs["schema"]
        else:
            del file[missing]
    with pytest.raises(InputError, match=rf"a\.nc.*{'schema' if missing == 'schema' else missing}"):
        read_recording(tmp_path / "a.nc")


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("face", 3.5, "whole number"),
        ("time_s", np.nan, "time_s is empty"),
        ("force_n", np.inf, "forces"),
        ("counts", np.inf, "counts"),
    ],
)
def test_netcdf_with_impossible_values(tmp_path, table, name, value, words):
    write_generic_netcdf(table, tmp_path / "a.nc")
    file_name = {"face": "cell_face", "force_n": "cell_force_n"}.get(name, name)
    with h5py.File(tmp_path / "a.nc", "a") as file:
        values = file[file_name][:].astype(float)
        values[7] = value
        del file[file_name]
        file[file_name] = values
        for axis, dim in enumerate(("frame", "face", "sensor", "axis") if values.ndim == 4 else
                                   ("frame", "cell")[: values.ndim]):  # fmt: skip
            file[file_name].dims[axis].attach_scale(file[dim])
    with pytest.raises(InputError, match=words):
        read_recording(tmp_path / "a.nc")


def test_truncated_netcdf(tmp_path, table):
    write_generic_netcdf(table, tmp_path / "a.nc")
    content = (tmp_path / "a.nc").read_bytes()
    for size in (10, len(content) // 3, len(content) - 4000):
        (tmp_path / "b.nc").write_bytes(content[:size])
        with pytest.raises(InputError, match=r"b\.nc"):
            read_recording(tmp_path / "b.nc")


def test_a_data_set_is_told_from_a_recording(tmp_path, gripper):
    from estimator.frames.dataset import save_frames

    save_frames(read_recording(gripper).frames, tmp_path / "frames.nc")
    with pytest.raises(InputError, match="instobj train"):
        read_recording(tmp_path / "frames.nc")
