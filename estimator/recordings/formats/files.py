"""Files of recordings, whatever their format, read into one table in this package's order.

Gripper files have a header: Time (whole s), two load cells (grams-force), 15 sensors × XYZ counts
in the order of faces 5, 3, 1, 2, 4, then for each load cell the face pressed and one position
label per tip. Training files have no header: face, case, force (N, any sign and offset), the
face's nine channels, then position labels (none for one tip, two or three otherwise). The generic
format (`estimator.recordings.formats.generic`) names its columns.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from jaxtyping import Float, Int

from design.errors import RecordingError
from estimator.frames.heatmap import NO_CONTACT_LABELS, label_grid_mm, label_to_pixel, pixel_to_mm
from estimator.recordings.formats.generic import (
    CHANNEL,
    check_header,
    generic_motion,
    generic_signals,
    generic_table,
    is_generic_header,
    is_unlabelled,
    missing_marker,
)
from estimator.recordings.formats.netcdf import read_generic_netcdf
from estimator.recordings.formats.text import (
    FORMATS,
    check_complete,
    csv_rows,
    is_number,
    naming,
    numbers,
    read_bytes,
    whole,
)
from estimator.recordings.table import RawTable, check_plausible, check_signals

NEWTON_PER_GRAM_FORCE = 9.8e-3
"""Newton per gram-force as these files' own programs take it."""
_FACES, _FILE_FACES = (1, 2, 3, 4, 5), (5, 3, 1, 2, 4)
_HEAD = ("Time", "Left", "Right-blue")
_CHANNELS = tuple(f"F{f}-{a}{s}" for f in _FILE_FACES for s in (1, 2, 3) for a in "XYZ")
_OTHER_MARKS = {";": "semicolon", "\t": "tab"}
_TRAINING_TIPS = {12: 1, 14: 2, 15: 3}
"""Tips of a probe by the number of a file's columns."""


def read_table(path: Path | str) -> RawTable:
    """Read any of the formats; the suffix `.nc` and the first line tell which.

    Raises
    ------
    RecordingError
        No such file, damaged, implausible, or not one of the formats; the message names line and
        column.
    """
    path = Path(path)
    with naming(path):
        if path.suffix == ".nc":
            read_bytes(path)  # says what is no file, or empty
            table = read_generic_netcdf(path)
        else:
            table = _csv_table(*_rows_of(path))
        check_plausible(table)
    return table


def read_signals(
    path: Path | str,
) -> tuple[Float[np.ndarray, "stamp"], Float[np.ndarray, "frame face sensor 3"]]:
    """Stamps (s; none where the format has none) and raw counts alone: of any recording, and of a generic
    CSV without the columns of load cells.

    Raises
    ------
    RecordingError
        As `read_table`.
    """
    path = Path(path)
    if path.suffix == ".nc":
        table = read_table(path)
        return table.time_s, table.counts
    with naming(path):
        rows, missing, digest = _rows_of(path)
        if is_unlabelled([cell.strip() for cell in rows[0]]):
            time_s, counts = generic_signals(rows, missing)
            check_signals(time_s, counts)
            return time_s, counts
        table = _csv_table(rows, missing, digest)
        check_plausible(table)
    return table.time_s, table.counts


def read_motion_columns(
    path: Path | str,
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame 6"]] | None:
    """Stamps (s) and the IMU's columns of any recording; None where it has none.

    Raises
    ------
    RecordingError
        As `read_signals`.
    """
    path = Path(path)
    if has_load_cells(path):
        table = read_table(path)
        return None if table.motion is None else (table.time_s, table.motion)
    with naming(path):
        rows, missing, _ = _rows_of(path)
        return generic_motion(rows, missing)


def has_load_cells(path: Path) -> bool:
    """Return whether a recording is of a format with load cells; raises as `read_table`."""
    if path.suffix == ".nc":
        return True
    with naming(path):
        rows, *_ = _rows_of(path)
    return not is_unlabelled([cell.strip() for cell in rows[0]])


def _rows_of(path: Path) -> tuple[list[list[str]], float | None, str]:
    """Rows of a CSV without its remark, the number that the remark says stands for no reading, and the
    SHA-256 of the file."""
    rows, digest = csv_rows(read_bytes(path))
    missing = missing_marker(rows)
    return (rows if missing is None else rows[1:]), missing, digest


def _csv_table(rows: list[list[str]], missing: float | None, digest: str) -> RawTable:
    header = [cell.strip() for cell in rows[0]]
    _check_separator(rows)
    if missing is not None:
        return generic_table(rows, missing)
    if is_number(header[0]):
        return _training_table(rows, digest, first_line=1)
    if header[0] == _HEAD[0]:
        return _gripper_table(rows, digest)
    if is_generic_header(header):
        return generic_table(rows)
    if len(rows[1]) in _TRAINING_TIPS and len(rows[0]) == len(rows[1]):
        return _training_table(rows[1:], digest, first_line=2)
    raise RecordingError(
        f"it is not a recording: its first column is {header[0][:40]!r}, expected 'Time', "
        f"'time_s' or a face number. {FORMATS}"
    )


def _check_separator(rows: list[list[str]]) -> None:
    for mark, name in _OTHER_MARKS.items():
        parts = [cell.strip() for cell in rows[0][0].split(mark)]
        if len(rows[0]) == 1 and len(parts) > 1 and (is_generic_header(parts) or "Time" in parts):
            raise RecordingError(
                f"the separator is a {name}. Use commas, and a decimal point in numbers"
            )


def _gripper_table(rows: list[list[str]], digest: str) -> RawTable:
    header = [cell.strip() for cell in rows[0]]
    tips = _check_gripper_header(header)
    values = numbers(rows[1:], header, first_line=2)
    channels = slice(len(_HEAD), len(_HEAD) + len(_CHANNELS))
    labels = whole(values[:, channels.stop :], header[channels.stop :])
    labels = labels.reshape(len(values), 2, 1 + tips)
    check_complete(values[:, : channels.start], header)
    in_file_order = values[:, channels].reshape(len(values), len(_FACES), 3, 3)
    order = [_FILE_FACES.index(face) for face in _FACES]
    x_mm, y_mm = label_grid_mm()
    return RawTable(
        kind="gripper",
        time_s=values[:, 0],
        force_n=values[:, 1:3] * NEWTON_PER_GRAM_FORCE,
        counts=in_file_order[:, order],
        face=_checked_faces(labels[:, :, 0]),
        tip_xy_mm=places_mm(labels[:, :, 1:]),
        case=np.zeros(len(values), dtype=int),
        declared_rest=np.zeros(len(values), dtype=bool),
        grid_x_mm=x_mm,
        grid_y_mm=y_mm,
        duplicate_columns=tuple(sorted({name for name in header if header.count(name) > 1})),
        digest=digest,
    )


def _check_gripper_header(header: list[str]) -> int:
    """Number of tips, if the header is exactly that of a gripper recording."""
    tips = (len(header) - len(_HEAD) - len(_CHANNELS) - 2) // 2
    positions = [f"Probe_Pos_{tip + 1}" for tip in range(max(tips, 1))]
    second = ["Probe_Pos_2"] if tips == 1 else positions
    expected = [*_HEAD, *_CHANNELS, "Probe_Face_1", *positions, "Probe_Face_2", *second]
    if cells := [name for name in _HEAD if name not in header]:
        raise RecordingError(_own_file_text(header, cells))
    missing = [name for name in (*_HEAD, *_CHANNELS) if name not in header]
    if missing:
        raise RecordingError(f"it lacks the columns {', '.join(missing[:6])}. {FORMATS}")
    allowed = {*expected, *_CHANNELS, "Probe_Pos_1", "Probe_Pos_2", "Probe_Pos_3"}
    if extra := [name for name in header if name not in allowed]:
        raise RecordingError(
            f"it has columns that are not known: {', '.join(map(repr, extra[:5]))}. Take them out; {FORMATS}"
        )
    for number, (given, wanted) in enumerate(zip(header, expected, strict=False), start=1):
        if given != wanted:
            raise RecordingError(
                f"column {number} is {given!r} where {wanted!r} belongs. Put the "
                "columns into the recording's own order"
            )
    if len(header) != len(expected) or tips > 3:
        raise RecordingError(
            f"it has {len(header)} columns; expected 52, 54 or 56 (one, two or three "
            f"positions a face). {FORMATS}"
        )
    return tips


def _own_file_text(header: list[str], cells: list[str]) -> str:
    """One sentence on a file that begins with the gripper's time and has no such load cells."""
    text = (
        f"its first column {_HEAD[0]!r} means the public gripper format, and it lacks the columns "
        f"{', '.join(cells)}. In a file of your own name it time_s (seconds)"
    )
    renamed = ["time_s", *header[1:]]
    if is_generic_header(header[1:]):
        try:
            check_header(renamed, labelled=not all(map(CHANNEL.fullmatch, header[1:])))
        except RecordingError as error:
            return f"{text}; then {error}"
    return f"{text}; {FORMATS}"


def _training_table(rows: list[list[str]], digest: str, first_line: int) -> RawTable:
    if len(rows[0]) not in _TRAINING_TIPS:
        raise RecordingError(
            f"it has {len(rows[0])} columns without a header; a training recording has 12 (one "
            f"tip), 14 (two) or 15 (three). {FORMATS}"
        )
    tips = _TRAINING_TIPS[len(rows[0])]
    names = ["face", "case", "force", *(f"{a}{s}" for s in (1, 2, 3) for a in "XYZ")]
    names += [f"position {tip + 1}" for tip in range(len(rows[0]) - 12)]
    values = numbers(rows, names, first_line)
    check_complete(values[:, :3], names)
    face, case = whole(values[:, :2], names[:2]).T
    face = _checked_faces(face[:, None])
    if tips == 1:
        position = case[:, None, None]
    else:
        position = whole(values[:, 12:], names[12:])[:, None]
        position = np.where(np.isin(case, NO_CONTACT_LABELS)[:, None, None], 0, position)
    counts = np.full((len(values), len(_FACES), 3, 3), np.nan)
    counts[np.arange(len(values)), face[:, 0] - 1] = values[:, 3:12].reshape(-1, 3, 3)
    x_mm, y_mm = label_grid_mm()
    return RawTable(
        kind="training",
        time_s=np.empty(0),
        force_n=values[:, 2:3],
        counts=counts,
        face=face,
        tip_xy_mm=places_mm(position),
        case=case,
        declared_rest=np.isin(case, NO_CONTACT_LABELS),
        grid_x_mm=x_mm,
        grid_y_mm=y_mm,
        duplicate_columns=(),
        digest=digest,
    )


def _checked_faces(face: Int[np.ndarray, "row cell"]) -> Int[np.ndarray, "row cell"]:
    wrong = ~np.isin(face, _FACES)
    if wrong.any():
        raise RecordingError(
            f"face labels must be 1…5; got {np.unique(face[wrong]).tolist()[:5]}. Fix the "
            "label column"
        )
    return face


def places_mm(position: Int[np.ndarray, "row cell tip"]) -> Float[np.ndarray, "row cell tip 2"]:
    """Places of snake labels; NaN where the label says that nothing touches."""
    wrong = (position < 0) | (position > NO_CONTACT_LABELS[1])
    if wrong.any():
        raise RecordingError(
            f"position labels must be 0…101; got "
            f"{np.unique(position[wrong]).tolist()[:5]}. Fix the label column"
        )
    held = ~np.isin(position, NO_CONTACT_LABELS)
    xy_mm = pixel_to_mm(label_to_pixel(np.where(held, position, 1)), *label_grid_mm())
    return np.where(held[..., None], xy_mm, np.nan)
