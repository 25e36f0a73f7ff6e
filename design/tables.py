"""Tables as CSV files: one header, one line per row, complete or absent."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping, Sequence
from io import StringIO, TextIOBase
from pathlib import Path
from typing import Any

from design.files import atomic_path


def write_table(path: Path | str, header: Sequence[str], rows: Iterable[Sequence[Any]]) -> None:
    """Write rows under a header, in UTF-8 with lines that end in a line feed.

    Texts that begin as a formula of a spreadsheet does get an apostrophe first.

    Raises
    ------
    StoreError
        The folder cannot be made or written.
    """
    with atomic_path(path) as temporary, temporary.open("w", newline="", encoding="utf-8") as file:
        _write(file, header, rows)


def table_text(header: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """The same as text, for files that are written together with others."""
    text = StringIO()
    _write(text, header, rows)
    return text.getvalue()


def _write(file: TextIOBase, header: Sequence[str], rows: Iterable[Sequence[Any]]) -> None:
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(map(_plain_cell, header))
    writer.writerows(map(_plain_cell, row) for row in rows)


def _plain_cell(cell: Any) -> Any:
    """Return a text that a spreadsheet would take for a formula with an apostrophe before it.

    Numbers stay, also the ones that come as text.
    """
    # OWASP, "CSV Injection": these characters at the start of a cell begin a formula.
    if not isinstance(cell, str) or not cell.startswith(("=", "+", "-", "@", "\t", "\r")):
        return cell
    try:
        float(cell)
    except ValueError:
        return f"'{cell}"
    return cell


def write_records(path: Path | str, records: Sequence[Mapping[str, Any]]) -> None:
    """Write records with the same keys, which are the header. Raises as `write_table`."""
    header = list(records[0])
    write_table(path, header, ([record[name] for name in header] for record in records))
