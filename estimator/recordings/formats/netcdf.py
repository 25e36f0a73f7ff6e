"""The generic recording as NetCDF: what the CSV holds, with named dimensions and units."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from design.errors import RecordingError, StoreError
from design.netcdf import FileKind, read_arrays, write_netcdf
from estimator.recordings.formats.generic import content_digest, face_labels, tip_places
from estimator.recordings.formats.text import FORMATS, check_complete, whole
from estimator.recordings.table import LEAST_FACES, MOST_FACES, RawTable, with_pressed_faces

_FILE_NAMES = {
    "face": "cell_face",
    "force_n": "cell_force_n",
    "shear_n": "cell_shear_n",
    "case": "session",
}
"""Names in the file where they differ from those of `RawTable`."""
_RECORDING = FileKind(
    "recordings",
    {
        "time_s": ("frame", "s"),
        "counts": ("frame face sensor axis", "count"),
        "cell_force_n": ("frame cell", "N"),
        "cell_shear_n": ("frame cell plane", "N"),
        "cell_face": ("frame cell", "1"),
        "tip_xy_mm": ("frame cell tip plane", "mm"),
        "session": ("frame", "1"),
        "declared_rest": ("frame", "1"),
        "travel_mm": ("frame", "mm"),
        "motion": ("frame imu_axis", "m/s², then rad/s"),
        "grid_x_mm": ("grid_x", "mm"),
        "grid_y_mm": ("grid_y", "mm"),
    },
    optional=("cell_force_n", "cell_shear_n", "travel_mm", "motion"),
    packed=("counts",),
    schema=("schema", "instobj recording 1"),
    unit_name="unit",
)
_FIELDS = {_FILE_NAMES.get(name, name): name for name in RawTable.__dataclass_fields__}


def write_generic_netcdf(table: RawTable, path: Path | str) -> None:
    """Write a recording as NetCDF4 with named dimensions and units."""
    values = {name: getattr(table, _FIELDS[name]) for name in _RECORDING.variables}
    if table.labelled_by_travel:
        values["cell_force_n"] = None
    write_netcdf(_RECORDING, path, values)


def read_generic_netcdf(path: Path) -> RawTable:
    """Read a NetCDF written by `write_generic_netcdf`, or by others with the same variables.

    Raises
    ------
    RecordingError
        Missing, damaged, or of another schema.
    """
    try:
        data, attributes = read_arrays(path)
    except StoreError as error:
        raise RecordingError(f"it is not a NetCDF recording ({error}). {FORMATS}") from None
    if "signal_counts" in data:
        raise RecordingError(
            "it is a data set, already zeroed and labelled. Give it to `instobj train`"
        )
    needed = [name for name in _RECORDING.variables if name not in _RECORDING.optional]
    missing = [name for name in needed if name not in data]
    if not {"cell_force_n", "travel_mm"} & set(data):
        missing.append("cell_force_n")
    _, schema = _RECORDING.schema
    if missing or attributes.get("schema") != schema:
        raise RecordingError(
            f"it is not of schema {schema!r}: missing {', '.join(missing) or 'nothing'}, schema "
            f"{attributes.get('schema')!r}. {FORMATS}"
        )
    present = [name for name in _RECORDING.variables if name in data]
    return _checked({name: data[name].values for name in present})


def _checked(in_file: dict[str, np.ndarray]) -> RawTable:
    """A table of arrays that have the right number of dimensions, types and labels."""
    labels = in_file["cell_face"]
    frames, cells = labels.shape if labels.ndim == 2 else (0, 0)
    for name, array in in_file.items():
        dims = _RECORDING.variables[name][0].split()
        right = array.ndim == len(dims) and array.dtype.kind in "fiub"
        if not right or (dims[0] == "frame" and len(array) != frames):
            raise RecordingError(
                f"{name} must hold numbers over ({', '.join(dims)}); got {array.dtype} of shape "
                f"{array.shape}. {FORMATS}"
            )
    floats = {_FIELDS[name]: array.astype(float) for name, array in in_file.items()}
    shear = floats.get("shear_n", np.zeros((frames, cells, 2)))
    force_n = floats.get("force_n", np.full((frames, cells), np.nan))
    shapes = floats["counts"].shape[1::2], floats["tip_xy_mm"].shape[1::2], floats["face"].shape[1]
    right = shapes[1:] == ((cells, 2), cells) and shear.shape[1:] == (cells, 2)
    right &= floats.get("motion", np.zeros((frames, 6))).shape == (frames, 6)
    right &= shapes[0] in ((LEAST_FACES, 3), (MOST_FACES, 3)) and force_n.shape == (frames, cells)
    if not right or not frames:
        raise RecordingError(
            "it must hold frames with 5 or 6 faces, 3 axes, places and shear (x, y) for each of its "
            f"{cells} load cells, and 6 numbers of any IMU; got {shapes} and {shear.shape[1:]} in {frames} "
            f"frames. {FORMATS}"
        )
    for name in {"time_s", "force_n", "shear_n", "grid_x_mm", "grid_y_mm"} & set(floats):
        rows = floats[name].reshape(len(floats[name]), -1)
        check_complete(rows, [name] * max(rows.shape[1], 1))
    labelled = np.concatenate(
        [floats["face"][..., None], floats["tip_xy_mm"].reshape(frames, cells, -1)], axis=2
    )
    shear_n, face = floats.get("shear_n"), face_labels(floats["face"])
    counts = with_pressed_faces(floats["counts"], face)
    label = floats["force_n" if "force_n" in floats else "travel_mm"]
    case = whole(floats["case"][:, None], ["session"])[:, 0]
    return RawTable(
        kind="generic",
        **{name: floats[name] for name in ("time_s", "grid_x_mm", "grid_y_mm")},
        force_n=force_n,
        counts=counts,
        face=face,
        tip_xy_mm=tip_places(labelled),
        case=case,
        declared_rest=floats["declared_rest"] == 1,
        duplicate_columns=(),
        digest=content_digest(floats["time_s"], label, counts, shear_n),
        shear_n=shear_n,
        travel_mm=floats.get("travel_mm"),
        motion=floats.get("motion"),
    )
