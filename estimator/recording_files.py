"""The two file formats of the public recordings, read into one table in this package's order.

Gripper files have a header: Time (whole s), two load cells (grams-force), 15 sensors × XYZ counts
in the order of faces 5, 3, 1, 2, 4, then for each load cell the face pressed and one position
label a tip. Training files have no header: face, case, force (N, any sign and offset), the
face's nine channels, then position labels (none for one tip, two or three otherwise).
"""

from __future__ import annotations

import csv
import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from estimator.heatmap import NO_CONTACT_LABELS

NEWTON_PER_GRAM_FORCE = 9.8e-3
FACES = (1, 2, 3, 4, 5)
_FILE_FACES = (5, 3, 1, 2, 4)
_HEAD = ("Time", "Left", "Right-blue")
_CHANNELS = tuple(f"F{f}-{a}{s}" for f in _FILE_FACES for s in (1, 2, 3) for a in "XYZ")
_TRAINING_TIPS = {12: 1, 14: 2, 15: 3}
_HELP = "Give an unchanged recording of the instrumented cube (gripper or training format)"


@dataclass(frozen=True)
class RawTable:
    """A file's content in face order 1…5, before any fault is mended.

    Attributes
    ----------
    kind : "gripper" or "training"
    time_s : (frame,) stamps as written; empty where the format has none
    force_n : (frame, cell) one column a load cell
    counts : (frame, face, sensor, axis) raw counts, NaN where the file has none
    face_label : (frame, cell) face that the load cell is said to press
    position_label : (frame, cell, tip) snake labels, 0 and 101 mean no contact
    case_label : (frame,) the training format's case, 0 in gripper files
    duplicate_columns : header names that occur twice
    digest : SHA-256 of the file
    """

    kind: str
    time_s: Float[np.ndarray, "stamp"]
    force_n: Float[np.ndarray, "frame cell"]
    counts: Float[np.ndarray, "frame 5 3 3"]
    face_label: Int[np.ndarray, "frame cell"]
    position_label: Int[np.ndarray, "frame cell tip"]
    case_label: Int[np.ndarray, "frame"]
    duplicate_columns: tuple[str, ...]
    digest: str


def read_table(path: Path | str) -> RawTable:
    """Read either format; the first line tells which.

    Raises
    ------
    InputError
        No such file, not text, or not one of the two formats; the message names line and column.
    """
    path = Path(path)
    text, digest = _read_text(path)
    rows = [row for row in csv.reader(text.splitlines()) if row]
    if len(rows) < 2:
        raise InputError(f"{path} holds {len(rows)} lines, too few for a recording. {_HELP}")
    if _is_number(rows[0][0]):
        return _training_table(path, rows, digest, first_line=1)
    if rows[0][0].strip() == _HEAD[0]:
        return _gripper_table(path, rows, digest)
    if len(rows[1]) in _TRAINING_TIPS and len(rows[0]) == len(rows[1]):
        return _training_table(path, rows[1:], digest, first_line=2)
    raise InputError(
        f"{path} is not a recording: its first column is {rows[0][0][:40]!r}, expected 'Time' or a "
        f"face number. {_HELP}"
    )


def _read_text(path: Path) -> tuple[str, str]:
    try:
        content = path.read_bytes()
    except FileNotFoundError:
        raise InputError(f"no recording at {path}. Give the path of a CSV file") from None
    except OSError as error:
        raise InputError(
            f"cannot read {path}: {error.strerror}. Give a readable CSV file"
        ) from None
    if not content.strip():
        raise InputError(f"{path} is empty. {_HELP}")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise InputError(f"{path} is not a text file. {_HELP}") from None
    if "\0" in text:
        raise InputError(f"{path} holds null characters, so it is not a text file. {_HELP}")
    return text, hashlib.sha256(content).hexdigest()


def _gripper_table(path: Path, rows: list[list[str]], digest: str) -> RawTable:
    header = [cell.strip() for cell in rows[0]]
    tips = _check_gripper_header(path, header)
    values = _numbers(path, rows[1:], header, first_line=2)
    channels = slice(len(_HEAD), len(_HEAD) + len(_CHANNELS))
    labels = _whole(path, values[:, channels.stop :], header[channels.stop :])
    labels = labels.reshape(len(values), 2, 1 + tips)
    _check_labels(path, labels[:, :, 0], labels[:, :, 1:])
    _check_complete(path, values[:, : channels.start], header)
    in_file_order = values[:, channels].reshape(len(values), len(FACES), 3, 3)
    order = [_FILE_FACES.index(face) for face in FACES]
    return RawTable(
        kind="gripper",
        time_s=values[:, 0],
        force_n=values[:, 1:3] * NEWTON_PER_GRAM_FORCE,
        counts=in_file_order[:, order],
        face_label=labels[:, :, 0],
        position_label=labels[:, :, 1:],
        case_label=np.zeros(len(values), dtype=int),
        duplicate_columns=tuple(sorted({name for name in header if header.count(name) > 1})),
        digest=digest,
    )


def _check_gripper_header(path: Path, header: list[str]) -> int:
    """Number of tips, if the header is exactly that of a gripper recording."""
    tips = (len(header) - len(_HEAD) - len(_CHANNELS) - 2) // 2
    positions = [f"Probe_Pos_{tip + 1}" for tip in range(max(tips, 1))]
    second = ["Probe_Pos_2"] if tips == 1 else positions
    expected = [*_HEAD, *_CHANNELS, "Probe_Face_1", *positions, "Probe_Face_2", *second]
    missing = [name for name in (*_HEAD, *_CHANNELS) if name not in header]
    if missing:
        raise InputError(f"{path} lacks the columns {', '.join(missing[:6])}. {_HELP}")
    for number, (found, wanted) in enumerate(zip(header, expected, strict=False), start=1):
        if found != wanted:
            raise InputError(
                f"{path}: column {number} is {found!r} where {wanted!r} belongs. Put the "
                "columns into the recording's own order"
            )
    if len(header) != len(expected) or tips > 3:
        raise InputError(
            f"{path} has {len(header)} columns; expected 52, 54 or 56 (one, two or three "
            f"positions a face). {_HELP}"
        )
    return tips


def _training_table(path: Path, rows: list[list[str]], digest: str, first_line: int) -> RawTable:
    if len(rows[0]) not in _TRAINING_TIPS:
        raise InputError(
            f"{path} has {len(rows[0])} columns without a header; a training recording has 12 (one "
            f"tip), 14 (two) or 15 (three). {_HELP}"
        )
    tips = _TRAINING_TIPS[len(rows[0])]
    names = ["face", "case", "force", *(f"{a}{s}" for s in (1, 2, 3) for a in "XYZ")]
    names += [f"position {tip + 1}" for tip in range(len(rows[0]) - 12)]
    values = _numbers(path, rows, names, first_line)
    _check_complete(path, values[:, :3], names)
    face, case = _whole(path, values[:, :2], names[:2]).T
    if tips == 1:
        position = case[:, None, None]
    else:
        position = _whole(path, values[:, 12:], names[12:])[:, None]
        position = np.where(np.isin(case, NO_CONTACT_LABELS)[:, None, None], 0, position)
    _check_labels(path, face[:, None], position)
    counts = np.full((len(values), len(FACES), 3, 3), np.nan)
    counts[np.arange(len(values)), face - 1] = values[:, 3:12].reshape(-1, 3, 3)
    return RawTable(
        kind="training",
        time_s=np.empty(0),
        force_n=values[:, 2:3],
        counts=counts,
        face_label=face[:, None],
        position_label=position,
        case_label=case,
        duplicate_columns=(),
        digest=digest,
    )


def _numbers(
    path: Path, rows: list[list[str]], names: list[str], first_line: int
) -> Float[np.ndarray, "row column"]:
    """Cells as numbers, NaN where empty."""
    for number, row in enumerate(rows, start=first_line):
        if len(row) != len(names):
            raise InputError(
                f"{path}, line {number}: {len(row)} cells where {len(names)} belong. The file is "
                "cut off or damaged there: delete the line or copy the file anew"
            )
    try:
        values = np.array([[float(cell or "nan") for cell in row] for row in rows])
    except ValueError:
        raise _first_bad_cell(path, rows, names, first_line) from None
    if np.isinf(values).any():
        row, column = np.argwhere(np.isinf(values))[0]
        raise InputError(
            f"{path}, line {row + first_line}, column {names[column]}: infinite value. Mend "
            "that cell"
        )
    return values


def _first_bad_cell(
    path: Path, rows: list[list[str]], names: list[str], first_line: int
) -> InputError:
    for number, row in enumerate(rows, start=first_line):
        for name, cell in zip(names, row, strict=True):
            if cell and not _is_number(cell):
                return InputError(
                    f"{path}, line {number}, column {name}: {cell[:40]!r} is not a number. Mend "
                    "that cell or delete the line"
                )
    return InputError(f"{path} holds a cell that is not a number. {_HELP}")


def _whole(
    path: Path, values: Float[np.ndarray, "row column"], names: list[str]
) -> Int[np.ndarray, "row column"]:
    """Labels as integers: large, fractional or empty ones are errors."""
    good = np.isfinite(values) & (np.abs(values) < 1e6)
    good &= np.where(good, values, 0.5) % 1 == 0
    if not good.all():
        row, column = np.argwhere(~good)[0]
        raise InputError(
            f"{path}: label {values[row, column]:g} in column {names[column]} is not a whole "
            "number. Mend the label column"
        )
    return values.astype(int)


def _check_complete(path: Path, values: Float[np.ndarray, "row column"], names: list[str]) -> None:
    if np.isnan(values).any():
        row, column = np.argwhere(np.isnan(values))[0]
        raise InputError(
            f"{path}: column {names[column]} is empty in data row {row + 1}. Every frame needs it: "
            "mend the cell or delete the line"
        )


def _check_labels(
    path: Path, face: Int[np.ndarray, "row cell"], position: Int[np.ndarray, "row cell tip"]
) -> None:
    wrong_face = ~np.isin(face, FACES)
    if wrong_face.any():
        raise InputError(
            f"{path}: face labels must be 1…5; got "
            f"{np.unique(face[wrong_face]).tolist()[:5]}. Mend the label column"
        )
    wrong = (position < 0) | (position > NO_CONTACT_LABELS[1])
    if wrong.any():
        raise InputError(
            f"{path}: position labels must be 0…101; got "
            f"{np.unique(position[wrong]).tolist()[:5]}. Mend the label column"
        )


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True
