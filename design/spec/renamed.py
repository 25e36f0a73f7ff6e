"""Renamed keys of a specification: the older name still reads, with a warning."""

from __future__ import annotations

import warnings
from typing import Any

from design.errors import SpecError

RENAMED = {"training": {"members": "ensemble", "interval_cover": "coverage"}}
"""Table → older key → its name now."""


def name_now(table: str, key: str) -> str:
    """The key's name now; warns where `key` is an older one."""
    now = RENAMED.get(table, {}).get(key)
    if now is None:
        return key
    warnings.warn(
        f"{table}.{key} is now called {table}.{now}. Rename it in the specification or --set",
        FutureWarning,
        stacklevel=2,
    )
    return now


def under_names_now(table: str, given: Any) -> Any:
    """The table `given` with every key under its name now; anything but a dict comes back as it is.

    Raises
    ------
    SpecError
        A key is given under both names.
    """
    if not isinstance(given, dict):
        return given
    for older, now in RENAMED[table].items():
        if older in given and now in given:
            raise SpecError(
                f"{table}.{older} is the older name of {table}.{now}; got both, "
                f"{given[older]!r} and {given[now]!r}. Keep {table}.{now}"
            )
    return {name_now(table, key): value for key, value in given.items()}
