"""Results of a run as xarray holds them, with an error for a misspelt name that lists the right ones."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from design.netcdf import read_arrays

_OF_THE_FILE = ("coordinates", "_FillValue")
"""Attributes that say how a file keeps an array."""


class Results(xr.Dataset):
    """Variables with units, by name."""

    __slots__ = ()

    def __repr__(self) -> str:
        """Name every variable with its dimensions, its unit and its range."""
        sizes = ", ".join(f"{name} {size}" for name, size in self.sizes.items())
        rows = [
            (
                str(name),
                f"({', '.join(map(str, variable.dims))})",
                variable.attrs.get("units", ""),
                _range(variable),
            )
            for name, variable in self.data_vars.items()
        ]
        widths = [max((len(row[k]) for row in rows), default=0) for k in range(3)]
        lines = ["  ".join([*map(str.ljust, row[:3], widths), row[3]]).rstrip() for row in rows]
        return "\n".join([f"Results: {sizes}", *(f"  {line}" for line in lines)])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # xarray asks an object that is not yet filled
            raise AttributeError(name)
        try:
            return super().__getattr__(name)
        except AttributeError:
            names = ", ".join(map(str, self.variables))
            # a name of its own, so that Python proposes no other quantity by its spelling
            raise AttributeError(f"there is no {name!r}; there are {names}", name="") from None


def results_in(path: Path) -> Results:
    """Return what a NetCDF file of ours holds; `coordinates` of a variable, and labels, are coordinates."""
    arrays, attributes = read_arrays(path)
    labels = {name for name, array in arrays.items() if array.axes == (name,)}
    for array in arrays.values():
        labels.update(array.attributes.get("coordinates", "").split())
    taken = {
        name: (array.axes, array.values, _content_attributes(array.attributes))
        for name, array in arrays.items()
    }
    return Results(taken, attrs=attributes).set_coords(labels)


def _content_attributes(attributes: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in attributes.items() if name not in _OF_THE_FILE}


def _range(variable: xr.DataArray) -> str:
    """Return the least and the largest finite value, as "0.38 to 1.5"; "" without numbers."""
    if variable.dtype == bool:
        return f"{int(variable.sum())} of {variable.size} true"
    if not np.issubdtype(variable.dtype, np.number):
        return ""
    finite = variable.values[np.isfinite(variable.values)]
    if not finite.size:
        return "nothing finite"
    least, largest = f"{finite.min():.4g}", f"{finite.max():.4g}"
    return least if least == largest else f"{least} to {largest}"
