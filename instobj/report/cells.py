"""Tables that terminal and pages share: rows of named values, which JSON keeps as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isinf, isnan
from typing import Any

_NOTHING = 1e-10
"""Magnitude below which a figure is a rounding error of what was added up."""


GO, NO_GO = "GO", "NO-GO"
"""Names of the first line of a verdict."""


@dataclass(frozen=True)
class Table:
    """Names of columns, with their units, and cells as they are shown."""

    header: list[str]
    cells: list[list[str]]


def table_of(rows: Sequence[dict[str, Any]]) -> Table:
    """Return rows as a table; what a row does not have is a dash."""
    header = list(dict.fromkeys(name for row in rows for name in row))
    return Table(header, [[shown(row.get(name)) for name in header] for row in rows])


def turned(rows: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """One row per key, one column per row, headed by the first value of each."""
    first, *others = rows[0]
    heads = [str(row[first]) for row in rows]
    if len(set(heads)) < len(heads):
        heads = [f"{number}: {head}" for number, head in enumerate(heads, start=1)]
    return [
        {first: key} | {head: row[key] for head, row in zip(heads, rows, strict=True)}
        for key in others
    ]


def percent_text(share: float) -> str:
    """Whole per cent, but all only where it is all."""
    return f"{min(round(100 * share), 99) if share < 1 else 100} %"


def shown(value: Any) -> str:
    """Text of a cell: three digits of a number, ∞ where there is no bound, a dash where nothing is known."""
    if isinstance(value, bool):
        return "yes" if value else "NO"
    if value is None or (isinstance(value, float) and isnan(value)):
        return "–"
    if not isinstance(value, float):
        return str(value)
    if isinf(value):
        return "∞" if value > 0 else "−∞"
    if abs(value) < _NOTHING:
        return "0"
    # from 1e3 on three digits would need an exponent, from 1e7 on no one reads all of them
    return f"{value:.1f}" if 1e3 <= abs(value) < 1e7 else f"{value:.3g}"
