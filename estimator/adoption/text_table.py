"""Any text table of numbers: separator, header, brackets and text columns found and stated.

Nothing is executed or unpickled: every cell is a number, a time stamp, or text that is left out.
"""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

import numpy as np
from jaxtyping import Float

from design.errors import RecordingError
from estimator.recordings.formats.text import is_number, naming, read_bytes

MOST_BYTES = 400_000_000
"""Largest text that is read, unpacked: a log of some hours."""
MOST_COLUMNS = 3000
"""Columns of a row, at most: a thousand chips."""
_SAMPLE = 200
"""Rows from which separator and width are taken."""
_DROPPED = 0.05
"""Share of rows that may be damaged; where more are, the file is another."""
_SEPARATORS = {",": "comma", ";": "semicolon", "\t": "tab", "|": "bar", " ": "blank"}
_SEVERAL = ", "
"""Labels behind blanks or semicolons and tuples behind commas stand in one row."""
_ANY = re.compile(r"\s*[,;|]\s*|\s+")
_MONITOR = re.compile(r"\d\d:\d\d:\d\d\.\d{3} -> ")
"""Time that Arduino's serial monitor writes before a line."""
_NOTHING = re.compile(r"\b(?:null|None)\b")
_CALL = re.compile(r"[A-Za-z_][\w.]*(?=[\[(])")
_KEY = re.compile(r"(?<!\w)[\"']?[A-Za-z_]\w*[\"']?\s*[:=]\s*")
_BRACKETS = str.maketrans(dict.fromkeys("()[]{}<>\"'", " "))
_DECIMAL_COMMA = re.compile(r"[-+]?\d+,\d+(e[-+]?\d+)?", re.IGNORECASE)
_STAMP = re.compile(r"\d{4}-\d\d-\d\d[ T]\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:?\d\d)?")


@dataclass(frozen=True)
class TextTable:
    """Numbers of a file, NaN where a cell is empty; names of the columns where a header gives them.

    `notes` state what was assumed; rows count from 0 below the header.
    """

    values: Float[np.ndarray, "row column"]
    names: tuple[str, ...] | None
    notes: tuple[str, ...]


def read_text_table(path: Path) -> TextTable:
    """Read a table of numbers, packed by gzip or not.

    Raises
    ------
    RecordingError
        No such file, no text, too large, or no table of numbers.
    """
    with naming(path):
        lines = _records(_text(path))
        if len(lines) < 2:
            raise RecordingError(f"it holds {len(lines)} rows. Give a table with a row per reading")
        return _table(lines)


def _text(path: Path) -> str:
    content = read_bytes(path)
    if len(content) > MOST_BYTES:
        raise RecordingError(f"it holds more than {MOST_BYTES / 1e6:g} MB of text. Split it")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise RecordingError("it is no text in UTF-8. Export the log as a table of text (CSV)")
    return text


def _records(text: str) -> list[str]:
    """Return the rows: lines, or blocks between lines of `---` as ROS 2 prints messages."""
    lines = [_MONITOR.sub("", line.strip("\r\n"), count=1) for line in text.splitlines()]
    if sum(line.strip() == "---" for line in lines) > 1:
        blocks, block = [], []
        for line in [*lines, "---"]:
            if line.strip() != "---":
                block.append(line.strip().removeprefix("- "))
            elif block:
                blocks.append(",".join(part for part in block if part and part[-1] != ":"))
                block = []
        lines = blocks
    return [line for line in lines if line.strip() and not line.lstrip().startswith("#")]


def _table(lines: list[str]) -> TextTable:
    plain = [
        _NOTHING.sub("nan", _KEY.sub("", _CALL.sub("", line)).translate(_BRACKETS))
        for line in lines
    ]
    middle = plain[len(plain) // 4 :][:_SAMPLE]
    separator, width = _layout(middle)
    if width > MOST_COLUMNS:
        raise RecordingError(f"its rows have {width} cells, at most {MOST_COLUMNS} are read")
    name = _SEPARATORS.get(separator, "several")
    notes = [f"separator: {name}, {width} columns"]
    if any(plain[k] != line for k, line in enumerate(lines[:_SAMPLE])):
        notes.append("brackets, quotes and names before values are left out")
    comma = "," not in separator and _has_decimal_commas([_cells(row, separator) for row in middle])
    if comma:
        notes.append("commas inside numbers are decimal commas")
    names, first = _header(lines, separator, width)
    rows = [_cells(row, separator) for row in plain[first:]]
    if comma:
        rows = [[cell.replace(",", ".") for cell in row] for row in rows]
    kept = [row for row in rows if len(row) == width]
    columns = [column for column in range(width) if _is_numeric(kept, column)]
    stamps = [c for c in range(width) if c not in columns and _is_stamp(kept, c)]
    used = sorted([*columns, *stamps])
    values = [_row(row, used, stamps) for row in kept]
    good = [row for row in values if row is not None]
    if not used or len(good) < 2 or len(good) < (1 - _DROPPED) * len(rows):
        raise RecordingError(
            f"{len(rows) - len(good) * bool(used)} of its {len(rows)} rows are no rows of {width} numbers, "
            f"first {_first_bad(rows, width)}. Give a log with one reading of all chips per row"
        )
    if len(good) < len(rows):
        notes.append(
            f"{len(rows) - len(good)} damaged rows left out, first {_first_bad(rows, width)}"
        )
    text = [c for c in range(width) if c not in used]
    if text:
        shown = ", ".join(f"{c + 1} ({kept[0][c][:20]!r})" for c in text[:4])
        notes.append(f"{len(text)} columns of text left out: {shown}")
    labels = None if names is None else tuple(names[c] for c in used)
    return TextTable(np.array(good, float), labels, tuple(notes))


def _layout(sample: list[str]) -> tuple[str, int]:
    """Return the separator that gives most rows one width with most numbers, and that width.

    Two separators at once are taken where no single one leaves as few cells of text.
    """
    best, choice, most_numeric = 0.0, (" ", 1), 0.0
    for separator in (*_SEPARATORS, _SEVERAL):
        rows = [_cells(row, separator) for row in sample]
        width, times = Counter(map(len, rows)).most_common(1)[0]
        cells = [cell for row in rows if len(row) == width for cell in row] or ["no number"]
        numeric = float(np.mean([not cell or _is_value(cell) for cell in cells]))
        # more columns win over fewer where both are tables of numbers
        score = times / len(rows) * numeric**4 * np.log2(1 + width)
        # "1,5 2,0" is two decimal commas by blanks alone, four numbers by both
        if separator == _SEVERAL and numeric <= most_numeric:
            continue
        if score > best * 1.001:
            best, choice, most_numeric = score, (separator, width), numeric
    return choice


def _is_value(cell: str) -> bool:
    return is_number(cell) or bool(_DECIMAL_COMMA.fullmatch(cell) or _STAMP.fullmatch(cell))


def _cells(row: str, separator: str) -> list[str]:
    if separator == " ":
        return row.split()
    if separator == _SEVERAL:
        row = ",".join(_ANY.split(row.strip()))
        separator = ","
    cells = [cell.strip() for cell in row.split(separator)]
    return cells[:-1] if len(cells) > 1 and not cells[-1] else cells


def _has_decimal_commas(rows: list[list[str]]) -> bool:
    return any(_DECIMAL_COMMA.fullmatch(cell) for row in rows for cell in row)


def _header(lines: list[str], separator: str, width: int) -> tuple[list[str] | None, int]:
    """Return names and the first row of numbers: lines of text above them are no rows."""
    for number, line in enumerate(lines[:20]):
        cells = [cell.strip("\"' ") for cell in _cells(line.translate(_BRACKETS), separator)]
        text = sum(bool(cell) and not _is_value(cell) for cell in cells)
        if 2 * text <= len(cells):
            above = (
                [c.strip("\"' ") for c in _cells(lines[number - 1], separator)] if number else []
            )
            return (above if len(above) == width else None), number
    return None, 0


def _is_numeric(rows: list[list[str]], column: int) -> bool:
    step = max(1, len(rows) // _SAMPLE)
    cells = [row[column] for row in rows[::step]] or ["no number"]
    return bool(np.mean([not cell or is_number(cell) for cell in cells]) > 1 - _DROPPED)


def _is_stamp(rows: list[list[str]], column: int) -> bool:
    return all(_STAMP.fullmatch(row[column]) for row in rows[:_SAMPLE])


def _row(row: list[str], used: list[int], stamps: list[int]) -> list[float] | None:
    try:
        return [
            datetime.fromisoformat(row[c]).timestamp() if c in stamps else float(row[c] or "nan")
            for c in used
        ]
    except ValueError:
        return None


def _first_bad(rows: list[list[str]], width: int) -> str:
    for number, row in enumerate(rows):
        if len(row) != width:
            return f"data row {number} with {len(row)} cells"
    return "one with text among its numbers"
