"""NetCDF files of others: what makes HDF5 leave the file, or fill the memory, is refused in words."""

import sys
import time

import h5py
import numpy as np
import pytest

from design.errors import InputError, StoreError
from design.foreign_netcdf import require_self_contained
from design.netcdf import FileKind, holds, read_arrays, read_netcdf, write_netcdf
from tests.support.foreign_hdf5 import FOREIGN, external_storage, sealed

KIND = FileKind("trials", {"force_n": ("step", "N")})


def made(make, folder):
    with h5py.File(folder / "trials.nc", "w") as file:
        file.attrs["schema_version"] = 1
        make(file, folder)
    return folder / "trials.nc"


@pytest.mark.parametrize("make", FOREIGN, ids=lambda make: make.__name__)
def test_what_leaves_the_file_is_refused_before_it_is_read(make, tmp_path):
    with h5py.File(made(make, tmp_path)) as file, pytest.raises(InputError, match=FOREIGN[make]):
        require_self_contained(file)


@pytest.mark.parametrize(
    "make", [make for make in FOREIGN if make.__name__ in ("external_pipe", "external_link")]
)
def test_a_checksum_that_anybody_can_append_proves_nothing(make, tmp_path):
    path, started = made(make, tmp_path), time.perf_counter()
    path.write_bytes(sealed(path.read_bytes()))
    with pytest.raises(StoreError, match=FOREIGN[make]):
        read_netcdf(KIND, path)
    assert not holds(path, "force_n")
    assert time.perf_counter() - started < 60


def test_an_own_file_that_others_seal_anew_is_foreign_and_read_all_the_same(tmp_path):
    write_netcdf(KIND, tmp_path / "trials.nc", {"force_n": np.arange(4.0)})
    with h5py.File(tmp_path / "trials.nc", "a") as file:
        file["force_n"][0] = 7.5
        external_storage(file.create_group("beside"), tmp_path)
    path = tmp_path / "trials.nc"
    path.write_bytes(sealed(path.read_bytes()))
    with pytest.raises(StoreError, match=r"/beside/force_n is stored in another file"):
        read_netcdf(KIND, path)
    with h5py.File(path, "a") as file:
        del file["beside"]
    path.write_bytes(sealed(path.read_bytes()))
    values, _ = read_netcdf(KIND, path)
    np.testing.assert_array_equal(values["force_n"], [7.5, 1, 2, 3])


def test_a_foreign_file_says_what_an_own_one_says(tmp_path, monkeypatch):
    """Of another user: the same bytes, and none of them on this user's list."""
    kind = FileKind(
        "trials",
        {
            "force_n": ("step", "N"),
            "face": ("step", ""),
            "held": ("step", ""),
            "part": ("step", ""),
        },
        coordinates={"depth_mm": ("step", "mm")},
        packed=("force_n",),
    )
    values = {
        "force_n": np.array([1.5, np.nan]),
        "face": np.array([1, 5]),
        "held": np.array([True, False]),
        "part": np.array(["N45", "Öse"]),
        "depth_mm": np.array([0.5, 1.0]),
    }
    path = tmp_path / "trials.nc"
    write_netcdf(kind, path, values, {"seed": 4, "object": "cube"})
    own, own_attributes = read_arrays(path)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    foreign, attributes = read_arrays(path)
    assert attributes == own_attributes
    assert foreign.keys() == own.keys()
    for name, array in own.items():
        np.testing.assert_array_equal(foreign[name].values, array.values)
        assert foreign[name].values.dtype.kind == array.values.dtype.kind
        assert foreign[name].axes == array.axes
        assert foreign[name].attributes.get("units") == array.attributes.get("units")


@pytest.mark.skipif(sys.platform == "win32", reason="permissions are others there")
def test_a_list_that_others_may_write_proves_nothing(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    path = tmp_path / "trials.nc"
    write_netcdf(KIND, path, {"force_n": np.arange(4.0)})
    (listed,) = (tmp_path / "instobj").iterdir()
    assert listed.stat().st_mode & 0o077 == 0
    listed.chmod(0o666)
    monkeypatch.setattr("design.netcdf.FIRST_READING_S", 1e-3)
    with pytest.raises(StoreError, match="did not end within"):
        read_netcdf(KIND, path)
    listed.chmod(0o600)
    np.testing.assert_array_equal(read_netcdf(KIND, path)[0]["force_n"], np.arange(4.0))


@pytest.mark.skipif(sys.platform != "linux", reason="the limit of memory is Linux's")
def test_a_file_that_unpacks_beyond_the_limit_of_memory_is_one_error(tmp_path, monkeypatch):
    """Three GB of zeros in three MB: less than may be declared, more than the process may take."""
    with h5py.File(tmp_path / "trials.nc", "w") as file:
        file.create_dataset("force_n", (3, 2**27), "f8", chunks=(1, 2**22), compression="gzip")
        file["force_n"][0, : 2**22] = 0
    monkeypatch.setattr("design.netcdf.MEMORY_GIB", 2.0)
    with pytest.raises(StoreError, match="needs more than 2 GiB of memory"):
        read_netcdf(KIND, tmp_path / "trials.nc")
