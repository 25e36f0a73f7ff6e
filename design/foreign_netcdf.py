"""Reader of NetCDF files that this user's instobj did not write, run as a program.

    python -m design.foreign_netcdf FILE OUT.npz

Writes the arrays, and a JSON description of their names, axes and attributes. `design.netcdf` calls
it with limits of time and memory: HDF5 can loop, crash or fill the memory on a damaged file. Before
anything is read the whole file is walked, and refused where reading it would open another file or
run code that is not HDF5's own.
"""

# pyright: reportAttributeAccessIssue=false
from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from design.errors import InputError
from design.netcdf import NamedArray, arrays_of

DESCRIPTION = "description"
_MISSING = ("_FillValue", "missing_value")
"""Attributes with a value that stands for none."""
LARGEST_BYTES = 4 * 2**30
"""Largest size of all arrays of a file as it declares them: an hour of 45 channels at 500 Hz takes a
sixth."""
_AXIS_MARKS = (b"DIMENSION_LIST", b"REFERENCE_LIST")
"""Attributes by which NetCDF names axes: references to objects of the same file."""


def read_foreign(path: str, target: str) -> None:
    """Read a file that was walked before; all of it goes to `target` as NumPy arrays.

    Raises
    ------
    InputError
        The file is not self-contained, uses a filter that is not allowed, or declares too much.
    """
    import h5py

    with h5py.File(path) as file:
        require_self_contained(file)
        content, attributes = arrays_of(file)
    described = json.dumps(
        {
            "arrays": [
                [name, array.axes, _plain(array.attributes)] for name, array in content.items()
            ],
            "attributes": _plain(attributes),
        }
    )
    values = {f"values {k}": _unpacked(array) for k, array in enumerate(content.values())}
    np.savez(target, allow_pickle=False, **{DESCRIPTION: np.array(described)}, **values)


def _unpacked(array: NamedArray) -> np.ndarray:
    """Return values as they were before they were packed: scaled, with NaN for what is missing (CF, 8.1)."""
    attributes, values = array.attributes, array.values
    if values.dtype.kind not in "iuf":
        return values
    missing = np.isin(values, [attributes[name] for name in _MISSING if name in attributes])
    if "scale_factor" in attributes or "add_offset" in attributes:
        values = values * attributes.get("scale_factor", 1.0) + attributes.get("add_offset", 0.0)
    return np.where(missing, np.nan, values) if missing.any() else values


def require_self_contained(file: Any) -> None:
    """Refuse what makes HDF5 open other files, load plugins, or make arrays beyond all measure.

    Raises
    ------
    InputError
        A link that is not a hard one, external storage, a virtual array, a filter other than
        deflate, shuffle and Fletcher checksums, a type other than numbers and texts, or more than
        4 GiB of declared arrays.
    """
    import h5py

    declared = 0
    for name, item in _objects(file.id):
        _check_attributes(name, item)
        if isinstance(item, h5py.h5d.DatasetID):
            _check_storage(name, item)
            declared += math.prod(item.shape) * item.get_type().get_size()
        if declared > LARGEST_BYTES:
            raise InputError(
                f"it declares arrays of more than {LARGEST_BYTES / 2**30:g} GiB. Cut it into "
                "shorter recordings"
            )


def _objects(root: Any) -> Iterator[tuple[str, Any]]:
    """The root and every object below it, each once, by hard links alone."""
    import h5py

    waiting, met = [("/", root)], set()
    while waiting:
        name, item = waiting.pop()
        address = h5py.h5o.get_info(item).addr
        if address in met:
            continue
        met.add(address)
        yield name, item
        if not isinstance(item, h5py.h5g.GroupID):
            continue
        for inside in item:
            where = f"{name.rstrip('/')}/{inside.decode(errors='replace')}"
            if item.links.get_info(inside).type != h5py.h5l.TYPE_HARD:
                raise InputError(
                    f"{where} is a link to another place or file, which is not followed. Write the "
                    "array itself into the file"
                )
            waiting.append((where, h5py.h5o.open(item, inside)))


def _check_storage(name: str, item: Any) -> None:
    """The layout comes first: asking a virtual array for its shape opens its sources."""
    from h5py import h5d, h5z

    how = item.get_create_plist()
    if how.get_layout() == h5d.VIRTUAL:
        raise InputError(
            f"{name} is a virtual array, made of others. Write its numbers into the file"
        )
    if how.get_external_count():
        raise InputError(f"{name} is stored in another file. Write its numbers into this file")
    allowed = {h5z.FILTER_DEFLATE, h5z.FILTER_SHUFFLE, h5z.FILTER_FLETCHER32}
    filters = {how.get_filter(number)[0] for number in range(how.get_nfilters())}
    if filters - allowed:
        raise InputError(
            f"{name} is packed by HDF5's filter {min(filters - allowed)}. Write it with gzip, "
            "shuffle and Fletcher checksums, or none of them"
        )
    _check_type(name, item.get_type())


def _check_attributes(name: str, item: Any) -> None:
    from h5py import h5a

    for number in range(h5a.get_num_attrs(item)):
        attribute = h5a.open(item, index=number)
        if attribute.name not in _AXIS_MARKS:
            _check_type(f"{name}@{attribute.name.decode(errors='replace')}", attribute.get_type())


def _check_type(name: str, kind: Any) -> None:
    from h5py import h5t

    if kind.get_class() not in (h5t.INTEGER, h5t.FLOAT, h5t.STRING, h5t.ENUM):
        raise InputError(f"{name} holds neither numbers nor texts (HDF5's references, records, …)")


def _plain(attributes: Any) -> dict[str, Any]:
    """Attributes as JSON has them; NumPy's numbers and arrays as Python's."""
    return {
        str(name): value.tolist() if isinstance(value, np.ndarray | np.generic) else value
        for name, value in attributes.items()
    }


def main(source: str, target: str) -> int:
    """Exit code: 0, or 1 with the reason on standard error."""
    try:
        read_foreign(source, str(Path(target)))
    except InputError as error:
        print(error, file=sys.stderr)
    except Exception as error:  # a damaged file can fail in any layer of the libraries
        print(f"{type(error).__name__}: {error}".splitlines()[0][:200], file=sys.stderr)
    else:
        return 0
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
