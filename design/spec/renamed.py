"""Renamed keys of a specification: the older name still reads, with a warning."""

from __future__ import annotations

import warnings
from typing import Any

from design.errors import SpecError

_OBJECTIVES = {"cross_face_sigma": "median_false_force_n"}
RENAMED = {
    "training": {"members": "ensemble", "interval_cover": "coverage"},
    "search.objectives": _OBJECTIVES,
    "search.limits.times_start": _OBJECTIVES,
}
"""Table (or list) → older key → its name now; tables after those that hold them."""


def name_now(table: str, key: str) -> str:
    """The key's name now; warns where `key` is an older one."""
    now = RENAMED.get(table, {}).get(key)
    if now is None:
        return key
    warnings.warn(
        f"{table}.{key} is now called {table}.{now}. Rename it",
        FutureWarning,
        stacklevel=2,
    )
    return now


def under_names_now(table: str, given: Any) -> Any:
    """The table (or list) `given` with every key under its name now; anything else comes back as it is.

    Raises
    ------
    SpecError
        A key is given under both names.
    """
    if isinstance(given, list | tuple):
        return [name_now(table, one) if isinstance(one, str) else one for one in given]
    if not isinstance(given, dict):
        return given
    for older, now in RENAMED[table].items():
        if older in given and now in given:
            raise SpecError(
                f"{table}.{older} is the older name of {table}.{now}; got both, "
                f"{given[older]!r} and {given[now]!r}. Keep {table}.{now}"
            )
    return {name_now(table, key): value for key, value in given.items()}
