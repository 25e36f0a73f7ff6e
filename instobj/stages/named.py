"""Results of a run as xarray holds them, with an error for a misspelt name that lists the right ones."""

from __future__ import annotations

from typing import Any

import xarray as xr


class Results(xr.Dataset):
    """Variables with units, by name."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # xarray asks an object that is not yet filled
            raise AttributeError(name)
        try:
            return super().__getattr__(name)
        except AttributeError:
            names = ", ".join(map(str, self.variables))
            # a name of its own, so that Python proposes no other quantity by its spelling
            raise AttributeError(f"there is no {name!r}; there are {names}", name="") from None
