"""NetCDF files of results: round trips, damage, foreign files, units and names of axes."""

import json
from dataclasses import replace

import h5py
import numpy as np
import pytest
import xarray as xr

from design import netcdf
from design.errors import InputError, StoreError
from design.foreign_netcdf import read_foreign
from design.netcdf import FileKind, read_netcdf, write_netcdf

KIND = FileKind(
    "trials",
    {"force_n": ("face step", "N"), "signal": ("step axis", "count"), "extra": ("step", "mm")},
    coordinates={"face": ("face", ""), "depth_mm": ("step", "mm"), "axis": ("axis", "")},
    optional=("extra",),
    packed=("signal",),
    attributes=("seed",),
)
VALUES = {
    "force_n": np.random.default_rng(0).normal(size=(3, 4)),
    "signal": np.random.default_rng(1).normal(size=(4, 3)),
    "extra": None,
    "face": np.array([1, 3, 5]),
    "depth_mm": np.array([0.5, 1.0, 1.5, np.nan]),
    "axis": list("XYZ"),
}
DIGEST_BYTES = 48


def test_a_foreign_file_of_packed_numbers_is_read_as_what_they_stand_for(tmp_path):
    packed = {"dtype": "int16", "scale_factor": 0.01, "add_offset": 5.0, "_FillValue": -999}
    force_n = xr.DataArray([4.5, np.nan, 12.34], dims="step", attrs={"units": "N"})
    counts = xr.DataArray(np.array([3, -1, 7]), dims="step", attrs={"missing_value": -1})
    data = xr.Dataset({"force_n": force_n, "counts": counts})
    data.to_netcdf(tmp_path / "packed.nc", engine="h5netcdf", encoding={"force_n": packed})
    content, _ = netcdf.read_arrays(tmp_path / "packed.nc")
    np.testing.assert_allclose(content["force_n"].values, force_n, atol=1e-12)
    np.testing.assert_array_equal(content["counts"].values, [3, np.nan, 7])
    assert content["counts"].axes == ("step",)


@pytest.fixture
def path(tmp_path):
    write_netcdf(KIND, tmp_path / "trials.nc", VALUES, {"seed": 4, "object": "cube"})
    return tmp_path / "trials.nc"


def test_a_file_is_plain_netcdf_with_named_axes_units_and_types(path):
    wanted = xr.Dataset(
        {
            "force_n": (("face", "step"), VALUES["force_n"], {"units": "N"}),
            "signal": (("step", "axis"), VALUES["signal"].astype(np.float32), {"units": "count"}),
        },
        coords={
            "face": VALUES["face"],
            "depth_mm": (("step",), VALUES["depth_mm"], {"units": "mm"}),
            "axis": VALUES["axis"],
        },
        attrs={"schema_version": 1, "seed": 4, "object": "cube"},
    )
    with xr.open_dataset(path, engine="h5netcdf") as found:
        xr.testing.assert_identical(found.load(), wanted)
        assert {n: found[n].dtype for n in wanted} == {n: wanted[n].dtype for n in wanted}


def test_what_is_written_comes_back(path):
    write_netcdf(KIND, path, {**VALUES, "extra": np.arange(4.0)}, {"seed": 4})
    values, attributes = read_netcdf(KIND, path)
    assert values.keys() == set(KIND.arrays)
    np.testing.assert_array_equal(values["force_n"], VALUES["force_n"])
    np.testing.assert_array_equal(values["extra"], np.arange(4.0))
    assert attributes == {"schema_version": 1, "seed": 4}


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("digest", ["kept", "cut off"])
def test_a_flipped_bit_anywhere_is_told_or_changes_nothing(path, digest):
    """Without the digest, bytes that hold nothing (padding, free space) may change without an error;
    the separate process's own reading is tried here, 250 processes would take minutes."""
    rng = np.random.default_rng(2)
    write_netcdf(
        KIND,
        path,
        {**VALUES, "force_n": rng.normal(size=(3000, 4)), "face": np.arange(3000)},
        {"seed": 4},
    )
    values, _ = read_netcdf(KIND, path)
    content, told = path.read_bytes(), 0
    if digest == "cut off":
        content = content[:-DIGEST_BYTES]
    count = 250 if digest == "kept" else 60
    for place in np.linspace(0, len(content) - 1, count).astype(int):
        damaged = bytearray(content)
        damaged[place] ^= 1 << rng.integers(8)
        path.write_bytes(damaged)
        try:
            found = read_netcdf(KIND, path)[0] if digest == "kept" else _read_here(path)
        except StoreError as error:
            told += "trials.nc" in str(error) and str(error).endswith("Simulate anew")
            continue
        except ProcessOfItsOwnFailed:
            told += 1
            continue
        for name, array in values.items():
            np.testing.assert_array_equal(found[name], array)
    assert told > 0.8 * count


class ProcessOfItsOwnFailed(Exception):
    """Whatever ends the process that reads a foreign file."""


def _read_here(path):
    """Arrays of a foreign file, of which `KIND` needs all, read as the separate process does."""
    target = path.with_suffix(".npz")
    try:
        read_foreign(str(path), str(target))
        with np.load(target) as content:
            named = json.loads(str(content["description"]))["arrays"]
            return {name: content[f"values {k}"] for k, (name, *_) in enumerate(named)}
    except Exception as error:
        raise ProcessOfItsOwnFailed from error


@pytest.mark.parametrize("text", [b"cube", b"count"])
def test_a_letter_of_a_text_that_changed_is_told(path, text):
    content = path.read_bytes()
    assert content.count(text) == 1
    path.write_bytes(content.replace(text, text[:-1] + b"x"))
    with pytest.raises(StoreError, match="bytes have changed since they were written"):
        read_netcdf(KIND, path)


def test_a_file_that_other_programs_edit_loses_its_digest_and_is_read(path):
    with h5py.File(path, "a") as file:
        file["force_n"][0, 0] = 4.5
    values, _ = read_netcdf(KIND, path)
    assert values["force_n"][0, 0] == 4.5


def test_without_a_digest_a_loop_in_the_library_ends_in_one_error(path, monkeypatch):
    """A size in HDF5's heap of texts that makes its library loop; another process meets it first."""
    monkeypatch.setattr(netcdf, "FIRST_READING_S", 1.0)
    with h5py.File(path, "w", libver=("v110", "v110")) as file:
        file.attrs["schema"] = "instobj recording 1"
    content = bytearray(path.read_bytes())
    content[content.index(b"GCOL") + 24] ^= 0x55
    path.write_bytes(content)
    with pytest.raises(StoreError, match=r"separate process, it did not end within 1 s"):
        read_netcdf(KIND, path)


@pytest.mark.parametrize("share", [0.0, 0.3, 0.99])
def test_a_file_that_was_cut_off_is_damaged(path, share):
    content = path.read_bytes()
    path.write_bytes(content[: int(share * len(content))])
    with pytest.raises(StoreError, match=r"trials\.nc is not a file of trials, or is damaged"):
        read_netcdf(KIND, path)


def test_a_missing_file_says_how_to_get_one(tmp_path):
    with pytest.raises(InputError, match=r"no trials at .*none\.nc\. Simulate the presses first"):
        read_netcdf(KIND, tmp_path / "none.nc")


def test_another_kind_of_file_is_told_by_what_it_holds(path):
    kind = replace(KIND, others={"signal": "a table of signals. Give trials"})
    with pytest.raises(InputError, match=r"trials\.nc is a table of signals\. Give trials"):
        read_netcdf(kind, path)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"schema": ("schema_version", 2)}, "schema 2: missing nothing, schema 1"),
        ({"variables": {**KIND.variables, "gap": ("step", "mm")}}, "missing gap"),
        ({"attributes": ("seed", "hand")}, "missing hand"),
        ({"variables": {"force_n": ("step face", "N")}}, "force_n must lie over"),
        ({"variables": {"force_n": ("face step", "mN")}}, r"in mN; got .* in N"),
    ],
)
def test_arrays_axes_units_attributes_and_schema_must_be_those_of_the_kind(path, change, words):
    with pytest.raises(StoreError, match=words):
        read_netcdf(replace(KIND, **change), path)


def test_files_without_checksums_are_read_as_before(path):
    with h5py.File(path) as file:
        assert file["force_n"].fletcher32
    with xr.open_dataset(path, engine="h5netcdf") as data:
        plain = data.load()
    for variable in plain.variables.values():
        variable.encoding.clear()
    plain.to_netcdf(path, engine="h5netcdf")
    with h5py.File(path) as file:
        assert not file["force_n"].fletcher32
    np.testing.assert_array_equal(read_netcdf(KIND, path)[0]["force_n"], VALUES["force_n"])
