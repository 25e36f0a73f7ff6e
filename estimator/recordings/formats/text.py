"""CSV files of numbers: read whole, with one error that names line and column."""

from __future__ import annotations

import codecs
import csv
import hashlib
import re
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError, RecordingError
from design.files import require_regular_file
from estimator.recordings.formats.robot import is_robot_file, robot_csv

_GZIP = b"\x1f\x8b"
"""First bytes of a gzip file, whatever its name."""
_GZIP_WBITS = 31
"""A window of 2^15 bytes, 15, with the head of gzip, 16 (zlib's manual)."""
_LARGEST_BYTES = 1 << 30
"""Unpacked size, at most."""
FORMATS = "`instobj docs recordings` describes the formats that are read"
_BINARY = set(range(32)) - set(b"\t\n\r\f\v")
"""Bytes that no text holds, in Latin-1 neither."""
_ISO = re.compile(r"\d{4}-\d\d-\d\d([ T].*)?")


@contextmanager
def naming(path: Path | str) -> Iterator[None]:
    """Put the name of the file before the text of a `RecordingError` raised inside that lacks it."""
    try:
        yield
    except RecordingError as error:
        text = str(error)
        raise RecordingError(text if str(path) in text else f"{path}: {text}") from None


def csv_rows(content: bytes) -> tuple[list[list[str]], str]:
    """All rows of a CSV file that hold anything, and the SHA-256 of its content.

    Raises
    ------
    RecordingError
        Not text, or fewer than two rows.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
            raise RecordingError("it is text in UTF-16. Save it as UTF-8") from None
        if set(content) & _BINARY:
            raise RecordingError(f"it is not a text file. {FORMATS}") from None
        line = content[: error.start].count(b"\n") + 1
        raise RecordingError(f"it is not UTF-8 (line {line}). Save it as UTF-8") from None
    if "\0" in text:
        raise RecordingError(f"it holds null characters, so it is not a text file. {FORMATS}")
    try:
        rows = [row for row in csv.reader(text.splitlines()) if row]
    except csv.Error as error:
        raise RecordingError(f"it is not a CSV file ({error}). {FORMATS}") from None
    if len(rows) < 2:
        lines = "one line" if len(rows) == 1 else "no line"
        raise RecordingError(f"it holds {lines}, too few for a recording. {FORMATS}")
    return rows, hashlib.sha256(content).hexdigest()


def read_bytes(path: Path) -> bytes:
    """Return the file's content; of a bag or a LeRobot data set, the same as a generic CSV.

    Raises
    ------
    RecordingError
        It is no file that can be read to its end, is empty, or is a specification.
    """
    if is_robot_file(path):
        return robot_csv(path)
    if path.suffix == ".toml":
        raise RecordingError(
            f"{path} is a specification. Give recordings (CSV or NetCDF), and the specification by --spec"
        )
    try:
        missing = f"no recording at {path}. Give the path of a recording"
        content = require_regular_file(path, missing).read_bytes()
    except InputError as error:
        message = str(error)
        raise RecordingError(
            message if message.startswith("no ") else f"cannot read it: {message}"
        ) from None
    except OSError as error:
        raise RecordingError(
            f"cannot read {path}: {error.strerror}. Give a readable file"
        ) from None
    content = _unpacked(path, content) if content.startswith(_GZIP) else content
    if not content.strip():
        raise RecordingError(f"{path} is empty. {FORMATS}")
    return content


def _unpacked(path: Path, content: bytes) -> bytes:
    """Return what a gzip file holds; a bound keeps a small file from filling the memory."""
    unpacker = zlib.decompressobj(wbits=_GZIP_WBITS)
    try:
        text = unpacker.decompress(content, _LARGEST_BYTES)
    except zlib.error as error:
        raise RecordingError(f"{path} is a damaged gzip file ({error}). Copy it anew") from None
    if not unpacker.eof:
        raise RecordingError(
            f"{path} is a gzip file that is cut off or damaged, or holds more than "
            f"{_LARGEST_BYTES >> 20} MiB. Copy it anew, or unpack it and give its parts"
        )
    return text


def numbers(
    rows: list[list[str]], names: list[str], first_line: int
) -> Float[np.ndarray, "row column"]:
    """Cells as numbers, NaN where empty.

    Raises
    ------
    RecordingError
        A row of another length, text in a cell, or an infinite value.
    """
    for number, row in enumerate(rows, start=first_line):
        if len(row) != len(names):
            raise RecordingError(
                f"line {number}: {len(row)} cells where {len(names)} belong. The file is "
                "cut off or damaged there: delete the line or copy the file anew"
            )
    try:
        values = _parse_numbers([cell for row in rows for cell in row]).reshape(-1, len(names))
    except ValueError:
        raise _first_bad_cell(rows, names, first_line) from None
    if np.isinf(values).any():
        row, column = np.argwhere(np.isinf(values))[0]
        raise RecordingError(
            f"line {row + first_line}, column {names[column]}: infinite value. Fix that cell"
        )
    return values


def _first_bad_cell(rows: list[list[str]], names: list[str], first_line: int) -> RecordingError:
    for number, row in enumerate(rows, start=first_line):
        for name, cell in zip(names, row, strict=True):
            if _ISO.fullmatch(cell):
                return RecordingError(
                    f"{name} must be seconds; got ISO stamps such as {cell[:40]!r}. In pandas: "
                    "(stamp - stamp.iloc[0]).dt.total_seconds()"
                )
            if cell and not is_number(cell):
                return RecordingError(
                    f"line {number}, column {name}: {cell[:40]!r} is not a number. Fix "
                    "that cell or delete the line"
                )
    return RecordingError(f"it holds a cell that is not a number. {FORMATS}")


def whole(
    values: Float[np.ndarray, "row column"], names: list[str]
) -> Int[np.ndarray, "row column"]:
    """Labels as integers.

    Raises
    ------
    RecordingError
        A large, fractional or empty label.
    """
    good = np.isfinite(values) & (np.abs(values) < 1e6)
    good &= np.where(good, values, 0.5) % 1 == 0
    if not good.all():
        row, column = np.argwhere(~good)[0]
        raise RecordingError(
            f"label {values[row, column]:g} in column {names[column]} is not a whole "
            "number. Fix the label column"
        )
    return values.astype(int)


def check_complete(values: Float[np.ndarray, "row column"], names: list[str]) -> None:
    """Raise RecordingError where a cell that every frame needs is empty."""
    if np.isnan(values).any():
        row, column = np.argwhere(np.isnan(values))[0]
        raise RecordingError(
            f"column {names[column]} is empty in data row {row + 1}. Every frame needs it: "
            "fix the cell or delete the line"
        )


def parse_number(cell: str) -> float:
    """A cell as a number, NaN where empty; what only Python takes for one (1_0, １０) is none.

    Raises
    ------
    ValueError
        Not a number.
    """
    if "_" in cell or not cell.isascii():
        raise ValueError(f"{cell!r} is not a number")
    return float(cell or "nan")


def _parse_numbers(cells: list[str]) -> Float[np.ndarray, "cell"]:
    """`parse_number` of each: what no number may hold is looked for in all of them at once."""
    together = "".join(cells)
    if "_" in together or not together.isascii():
        raise ValueError("a cell is not a number")
    if "" in cells:
        cells = [cell or "nan" for cell in cells]
    return np.fromiter(map(float, cells), float, len(cells))


def is_number(cell: str) -> bool:
    """Return whether a cell that is not empty is a number."""
    try:
        parse_number(cell or "empty")
    except ValueError:
        return False
    return True
