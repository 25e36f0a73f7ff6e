"""Tables as text: CSV files with one header and one line per row, and TOML."""

from __future__ import annotations

import csv
import json
import re
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


def toml_text(tables: Mapping[str, Any], above: str = "") -> str:
    """Keys, then tables of a TOML file; `above` is the dotted name of the table that holds them.

    Lists of tables stand in their line.
    """
    inner = {name: value for name, value in tables.items() if isinstance(value, Mapping)}
    lines = [f"{_key(k)} = {toml_value(v)}\n" for k, v in tables.items() if k not in inner]
    for name, table in inner.items():
        dotted = f"{above}{_key(name)}"
        lines += [f"\n[{dotted}]\n", toml_text(table, f"{dotted}.")]
    return "".join(lines)


def toml_value(value: Any) -> str:
    """Return a text, number, truth value, list or table of them as TOML writes it within a line."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        # JSON escapes what TOML does, but for the character 127
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007F")
    if isinstance(value, Mapping):
        pairs = (f"{_key(key)} = {toml_value(inside)}" for key, inside in value.items())
        return f"{{{', '.join(pairs)}}}"
    if isinstance(value, Sequence):
        return f"[{', '.join(map(toml_value, value))}]"
    return repr(value)


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else toml_value(name)
