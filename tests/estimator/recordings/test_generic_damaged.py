"""The generic recording, damaged in any way."""

import h5py
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from design.errors import InputError
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording


def outcome(path):
    """Whether the file read well, or failed with one message that names it."""
    try:
        recording = read_recording(path)
    except InputError as error:
        return path.name in str(error) and len(str(error)) < 700
    return len(recording.frames) > 0 and bool(np.isfinite(recording.frames.time_s).all())


@settings(
    max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
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
    max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
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
