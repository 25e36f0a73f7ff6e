"""NetCDF files of results: named axes, units and checksums, by one codec for all of them.

A SHA-256 of the whole file stands behind its content, where HDF5 ignores it; programs that edit the
file cut it off. What this user's instobj did not write (`design.seal`) is foreign, with a SHA-256 or
without: a separate process reads it, with limits of time and memory, and hands back plain arrays
(`design.foreign_netcdf`). Also, arrays of numbers carry Fletcher checksums, and the format of HDF5
1.10 one for each piece of metadata.
"""

from __future__ import annotations

import io
import json
import tempfile
from collections.abc import Container, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError, StoreError
from design.files import atomic_path
from design.processes import ChildFailed, run_child
from design.seal import end_seal, is_own

Axes = Mapping[str, tuple[str, str]]
"""Axes, with a space between, and unit of each array by name; the unit is empty for labels."""

_HDF5_FORMAT = ("v110", "v110")
_OF_THE_FORMAT = (
    "CLASS",
    "NAME",
    "DIMENSION_LIST",
    "REFERENCE_LIST",
    "_Netcdf4Dimid",
    "_Netcdf4Coordinates",
    "_NCProperties",
)
"""Attributes by which NetCDF keeps axes and itself in HDF5."""
_AXIS_ALONE = b"This is a netCDF dimension but not a netCDF variable."
_LARGEST_CHUNK_BYTES = 2**30
FIRST_READING_S, _FIRST_READING_BYTES_PER_S = 120.0, 2e7
"""Limit of time of the separate process that reads a foreign file."""
MEMORY_GIB = 8.0
"""Limit of its memory, on Linux; elsewhere what the file declares is limited alone (4 GiB)."""


@dataclass(frozen=True)
class FileKind:
    """Content of files of one kind.

    Attributes
    ----------
    title : name of the kind in the plural, for messages
    variables, coordinates : axes and units of the arrays; coordinates label axes
    optional : variables that a file may lack
    packed : variables kept as compressed 32-bit floats
    attributes : names of attributes that a file must have
    schema : name and value of the attribute that names the kind and its version
    unit_name : attribute that holds the unit
    origin : how to get such a file
    remedy : what to do about a damaged one
    others : a sentence for each variable by which a file of another kind is known
    """

    title: str
    variables: Axes
    coordinates: Axes = field(default_factory=dict)
    optional: tuple[str, ...] = ()
    packed: tuple[str, ...] = ()
    attributes: tuple[str, ...] = ()
    schema: tuple[str, int | str] = ("schema_version", 1)
    unit_name: str = "units"
    origin: str = "Simulate the presses first"
    remedy: str = "Simulate anew"
    others: Mapping[str, str] = field(default_factory=dict)

    @property
    def arrays(self) -> Axes:
        """All arrays, coordinates last."""
        return {**self.variables, **self.coordinates}


def write_netcdf(
    kind: FileKind,
    path: Path | str,
    values: Mapping[str, Any],
    attributes: Mapping[str, Any] | None = None,
) -> None:
    """Write arrays as NetCDF4 with checksums.

    Parameters
    ----------
    values : array of each name of the kind; None leaves an optional one out

    Raises
    ------
    StoreError
        The folder cannot be written.
    """
    import h5py

    arrays = {
        name: (tuple(dims.split()), np.asarray(values[name]), unit)
        for name, (dims, unit) in kind.arrays.items()
        if name not in kind.optional or values[name] is not None
    }
    sizes = {
        axis: size
        for dims, array, _ in arrays.values()
        for axis, size in zip(dims, array.shape, strict=True)
    }
    for name, (dims, array, _) in arrays.items():
        if array.shape != (needed := tuple(sizes[axis] for axis in dims)):
            raise ValueError(f"{name} has shape {array.shape}, its axes {dims} {needed}")
    image = io.BytesIO()  # HDF5 on a disk that fills leaves files open and crashes at exit
    with h5py.File(image, "w", libver=_HDF5_FORMAT, track_order=True) as file:
        for name, value in {**(attributes or {}), kind.schema[0]: kind.schema[1]}.items():
            file.attrs[name] = np.atleast_1d(value) if isinstance(value, int | float) else value
        for name, (_, array, unit) in arrays.items():
            unit_attribute = {kind.unit_name: unit} if unit else {}
            variable = _write_array(file, name, array, name in kind.packed)
            variable.attrs.update(unit_attribute | _labels(kind, name))
        _write_axes(file, sizes, {name: dims for name, (dims, _, _) in arrays.items()})
    with atomic_path(path) as temporary, temporary.open("wb") as stream:
        stream.write(image.getbuffer())
        stream.write(end_seal(image.getbuffer()))


def _write_axes(file: Any, sizes: Mapping[str, int], axes: Mapping[str, tuple[str, ...]]) -> None:
    """Mark the axes of arrays as NetCDF4 does: HDF5's dimension scales, numbered in one order."""
    for number, (axis, size) in enumerate(sizes.items()):
        if axes.get(axis) != (axis,):  # no labels: an array without values stands for the axis
            file.create_dataset(axis, (size,), ">f4")
            file[axis].make_scale(f"{_AXIS_ALONE.decode()}{size:10d}")
        else:
            file[axis].make_scale(axis)
        file[axis].attrs["_Netcdf4Dimid"] = np.int32(number)
    for name, dims in axes.items():
        if dims != (name,):
            for number, axis in enumerate(dims):
                file[name].dims[number].attach_scale(file[axis])


def _write_array(file: Any, name: str, array: np.ndarray, packed: bool) -> Any:
    """Write an array as xarray does, which would import pandas and Dask for that: half a second."""
    import h5py

    how = _encoding(array, packed)
    written, fill = how.pop("dtype", array.dtype), None
    if array.dtype.kind == "f":
        fill = np.dtype(written).type(np.nan)
    elif array.dtype.kind == "b":
        written = np.int8
    elif array.dtype.kind == "U":
        written, array = h5py.string_dtype(), array.astype(object)
    data = array.astype(written, copy=False)
    variable = file.create_dataset(name, data=data, dtype=written, fillvalue=fill, **how)
    if fill is not None:
        variable.attrs["_FillValue"] = np.array([fill])
    if array.dtype.kind == "b":
        variable.attrs["dtype"] = "bool"
    return variable


def _labels(kind: FileKind, name: str) -> dict[str, str]:
    """Return which coordinates label the axes of a variable by the CF conventions, besides those called like
    an axis."""
    axes = set(kind.arrays[name][0].split())
    labels = [
        label
        for label, (dims, _) in kind.coordinates.items()
        if label != dims and name not in kind.coordinates and set(dims.split()) <= axes
    ]
    return {"coordinates": " ".join(sorted(labels))} if labels else {}


def _encoding(array: np.ndarray, packed: bool) -> dict[str, Any]:
    if array.dtype.kind not in "fiub" or not array.size or not array.ndim:
        return {}
    if packed:
        deflated = {"compression": "gzip", "compression_opts": 1}
        return {"fletcher32": True, "dtype": "float32", **deflated}
    if array.nbytes > _LARGEST_CHUNK_BYTES:
        return {"fletcher32": True}
    return {"fletcher32": True, "chunks": array.shape}  # read whole: one chunk, no padding


def read_netcdf(kind: FileKind, path: Path | str) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Arrays and attributes that `write_netcdf` wrote; optional arrays may be missing.

    Raises
    ------
    InputError
        No such file, or one of another kind.
    StoreError
        Damaged, or of another schema.
    """
    if not Path(path).is_file():
        raise InputError(f"no {kind.title} at {path}. {kind.origin}")
    try:
        content, attributes = read_arrays(path)
    except StoreError as error:
        raise StoreError(
            f"{path} is not a file of {kind.title}, or is damaged ({error}). {kind.remedy}"
        ) from None
    for name, sentence in kind.others.items():
        if name in content:
            raise InputError(f"{path} is {sentence}")
    _check_kind(kind, path, content, attributes)
    return {name: content[name].values for name in kind.arrays if name in content}, attributes


@dataclass(frozen=True)
class NamedArray:
    """Array that a file holds under one name."""

    axes: tuple[str, ...]
    values: np.ndarray
    attributes: dict[str, Any]


def read_arrays(path: Path | str) -> tuple[dict[str, NamedArray], dict[str, Any]]:
    """Arrays and attributes of any NetCDF file, with labels of axes.

    Raises
    ------
    StoreError
        Not NetCDF, damaged, or foreign and refused; the text says what is wrong.
    """
    if not Path(path).stat().st_size:
        raise StoreError("it is empty")
    with _damage_told():
        if is_own(np.memmap(path, np.uint8, "r")):
            return _read_own(path)
        return _read_apart(Path(path))


@contextmanager
def _damage_told() -> Iterator[None]:
    """A damaged file can fail in any layer of the library."""
    try:
        yield
    except MemoryError:
        raise
    except Exception as error:
        raise StoreError(str(error) or type(error).__name__) from None


def _read_own(path: Path | str) -> tuple[dict[str, NamedArray], dict[str, Any]]:
    """Return what `write_netcdf` wrote."""
    import h5py

    with h5py.File(path) as file:
        return arrays_of(file)


def arrays_of(file: Any) -> tuple[dict[str, NamedArray], dict[str, Any]]:
    """Arrays and attributes of an open file, by HDF5 alone: the layers of others ask for each axis dozens
    of times, which takes three times as long."""
    import h5py

    arrays = {
        name: _array(file, name)
        for name, item in file.items()
        if isinstance(item, h5py.Dataset)
        and not item.attrs.get("NAME", b"").startswith(_AXIS_ALONE)
    }
    return arrays, _attributes(file.attrs)


def _array(file: Any, name: str) -> NamedArray:
    attributes, values = _attributes(file[name].attrs), _content(file[name])
    if attributes.pop("dtype", "") == "bool":  # NetCDF has none
        values = values.astype(bool)
    return NamedArray(_axes_of(file, name), values, attributes)


def _axes_of(file: Any, name: str) -> tuple[str, ...]:
    axes = file[name].attrs.get("DIMENSION_LIST")
    if axes is None:
        return (name,) * file[name].ndim  # labels of the axis of their name
    return tuple(file[references[0]].name.removeprefix("/") for references in axes)


def _content(item: Any) -> Any:
    return np.asarray(item.asstr()[()], str) if item.dtype.kind == "O" else item[()]


def _attributes(attributes: Any) -> dict[str, Any]:
    """Those of the content; single numbers are kept as arrays of one."""
    return {
        name: value[0] if isinstance(value, np.ndarray) and value.shape == (1,) else value
        for name, value in attributes.items()
        if name not in _OF_THE_FORMAT
    }


def holds(path: Path | str, name: str) -> bool:
    """Return whether a file is NetCDF with a variable or an attribute of this name.

    False also for a damaged one: whoever reads it says so.
    """
    if not Path(path).is_file():
        return False
    try:
        content, attributes = _names_of(path)
    except StoreError:
        return False
    return name in content or name in attributes


def _names_of(path: Path | str) -> tuple[Container[str], Container[str]]:
    """Names of arrays and attributes; of an own file without reading them."""
    import h5py

    with _damage_told():
        if not is_own(np.memmap(path, np.uint8, "r")):
            return _read_apart(Path(path))
        with h5py.File(path) as file:
            return set(file), set(file.attrs)


def _read_apart(path: Path) -> tuple[dict[str, NamedArray], dict[str, Any]]:
    """Return what a foreign file holds, read by a separate process; this one meets NumPy's arrays alone."""
    import h5py

    if not h5py.is_hdf5(path):
        raise StoreError("it is not HDF5")
    seconds = FIRST_READING_S + path.stat().st_size // _FIRST_READING_BYTES_PER_S
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "arrays.npz"
        command = ("-P", "-m", "design.foreign_netcdf", str(path.resolve()), str(target))
        try:
            run_child(command, Path(folder), seconds, MEMORY_GIB)
        except ChildFailed as failure:
            raise StoreError(f"read in a separate process, {failure}") from None
        with np.load(target, allow_pickle=False) as content:
            described = json.loads(str(content["description"]))
            arrays = {
                name: NamedArray(tuple(axes), content[f"values {number}"], attributes)
                for number, (name, axes, attributes) in enumerate(described["arrays"])
            }
    return arrays, described["attributes"]


def _check_kind(
    kind: FileKind, path: Path | str, content: dict[str, NamedArray], attributes: dict[str, Any]
) -> None:
    name, version = kind.schema
    needed = [array for array in kind.arrays if array not in kind.optional]
    missing = [array for array in needed if array not in content]
    missing += [attribute for attribute in kind.attributes if attribute not in attributes]
    if missing or attributes.get(name) != version:
        raise StoreError(
            f"{path} is not a file of {kind.title} of schema {version}: missing "
            f"{', '.join(missing) or 'nothing'}, schema {attributes.get(name)}. {kind.remedy}"
        )
    for array, (dims, unit) in kind.arrays.items():
        if array not in content:
            continue
        axes, stored_unit = content[array].axes, content[array].attributes.get(kind.unit_name, "")
        if axes != tuple(dims.split()) or stored_unit != unit:
            raise StoreError(
                f"{path} is damaged: {array} must lie over ({dims}) in {unit or 'no unit'}; got "
                f"{axes} in {stored_unit or 'no unit'}. {kind.remedy}"
            )
