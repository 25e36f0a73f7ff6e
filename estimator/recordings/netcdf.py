"""The generic recording as NetCDF: what the CSV holds, with named dimensions and units."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from design.errors import InputError
from design.files import atomic_path
from estimator.recordings.generic import content_digest, face_labels, tip_places
from estimator.recordings.table import FACES, RawTable
from estimator.recordings.text import FORMATS, check_complete, read_bytes, whole

SCHEMA = "instobj recording 1"
_VARIABLES = {
    "time_s": (("frame",), "s"),
    "counts": (("frame", "face", "sensor", "axis"), "count"),
    "force_n": (("frame", "cell"), "N"),
    "shear_n": (("frame", "cell", "plane"), "N"),
    "face": (("frame", "cell"), "1"),
    "tip_xy_mm": (("frame", "cell", "tip", "plane"), "mm"),
    "case": (("frame",), "1"),
    "declared_rest": (("frame",), "1"),
    "grid_x_mm": (("grid_x",), "mm"),
    "grid_y_mm": (("grid_y",), "mm"),
}
_FILE_NAMES = {
    "face": "cell_face",
    "force_n": "cell_force_n",
    "shear_n": "cell_shear_n",
    "case": "session",
}
"""Names in the file where they differ from those of `RawTable`."""
_OPTIONAL = ("shear_n",)
"""Left out of the file where nobody measured it."""


def write_generic_netcdf(table: RawTable, path: Path | str) -> None:
    """Write a recording as NetCDF4 with named dimensions and units."""
    import xarray as xr

    variables = {
        _FILE_NAMES.get(name, name): (dims, getattr(table, name), {"unit": unit})
        for name, (dims, unit) in _VARIABLES.items()
        if getattr(table, name) is not None
    }
    data = xr.Dataset(variables, attrs={"schema": SCHEMA})
    encoding = {"counts": {"zlib": True, "complevel": 1, "dtype": "float32"}}
    with atomic_path(path) as temporary:
        data.to_netcdf(temporary, engine="h5netcdf", encoding=encoding)


def read_generic_netcdf(path: Path) -> RawTable:
    """Read a NetCDF written by `write_generic_netcdf`, or by others with the same variables.

    Raises
    ------
    InputError
        Missing, damaged, or of another schema.
    """
    import xarray as xr

    read_bytes(path)
    try:
        with xr.open_dataset(path, engine="h5netcdf", decode_timedelta=False) as data:
            data = data.load()
    except (OSError, ValueError, KeyError, RuntimeError, TypeError, AttributeError) as error:
        raise InputError(f"{path} is not a NetCDF recording ({error}). {FORMATS}") from None
    if "signal_counts" in data.variables:
        raise InputError(
            f"{path} is a data set, already zeroed and labelled. Give it to `instobj train`"
        )
    names = {name: _FILE_NAMES.get(name, name) for name in _VARIABLES}
    names = {n: f for n, f in names.items() if f in data.variables or n not in _OPTIONAL}
    missing = [file_name for file_name in names.values() if file_name not in data.variables]
    if missing or data.attrs.get("schema") != SCHEMA:
        raise InputError(
            f"{path} is not of schema {SCHEMA!r}: missing {', '.join(missing) or 'nothing'}, schema "
            f"{data.attrs.get('schema')!r}. {FORMATS}"
        )
    values = {name: np.asarray(data[file_name].values) for name, file_name in names.items()}
    return _checked(path, values)


def _checked(path: Path, values: dict[str, np.ndarray]) -> RawTable:
    """A table of arrays that have the right number of dimensions, types and labels."""
    frames, cells = values["force_n"].shape if values["force_n"].ndim == 2 else (0, 0)
    for name, array in values.items():
        dims, _ = _VARIABLES[name]
        right = array.ndim == len(dims) and array.dtype.kind in "fiub"
        if not right or (dims[0] == "frame" and len(array) != frames):
            raise InputError(
                f"{path}: {_FILE_NAMES.get(name, name)} must hold numbers over ({', '.join(dims)}); "
                f"got {array.dtype} of shape {array.shape}. {FORMATS}"
            )
    floats = {name: array.astype(float) for name, array in values.items()}
    shear = floats.get("shear_n", np.zeros((frames, cells, 2)))
    shapes = floats["counts"].shape[1::2], floats["tip_xy_mm"].shape[1::2], floats["face"].shape[1]
    right = shapes == ((len(FACES), 3), (cells, 2), cells) and shear.shape[1:] == (cells, 2)
    if not right or not frames:
        raise InputError(
            f"{path} must hold frames with 5 faces, 3 axes, and places and shear (x, y) for each of "
            f"its {cells} load cells; got {shapes} and {shear.shape[1:]} in {frames} frames. {FORMATS}"
        )
    for name in {"time_s", "force_n", "shear_n", "grid_x_mm", "grid_y_mm"} & set(floats):
        rows = floats[name].reshape(len(floats[name]), -1)
        check_complete(path, rows, [name] * max(rows.shape[1], 1))
    labelled = np.concatenate(
        [floats["face"][..., None], floats["tip_xy_mm"].reshape(frames, cells, -1)], axis=2
    )
    shear_n = floats.get("shear_n")
    case = whole(path, floats["case"][:, None], ["session"])[:, 0]
    return RawTable(
        kind="generic",
        **{
            name: floats[name] for name in ("time_s", "force_n", "counts", "grid_x_mm", "grid_y_mm")
        },
        face=face_labels(path, floats["face"]),
        tip_xy_mm=tip_places(path, labelled),
        case=case,
        declared_rest=floats["declared_rest"] == 1,
        duplicate_columns=(),
        digest=content_digest(floats["time_s"], floats["force_n"], floats["counts"], shear_n),
        shear_n=shear_n,
    )
