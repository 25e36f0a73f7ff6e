"""The generic recording of any object: one row per frame, columns by name, as CSV or NetCDF.

CSV columns, in any order: `time_s`; a channel each (F1-X1 … F6-Z24, raw counts; missing channels
have no reading); for each load cell n from 1: `celln_force_n`, `celln_face`, and for each of its
tips k from 1 `celln_xk_mm`, `celln_yk_mm` (face and places empty where nothing is pressed);
optional `celln_shear_x_n` and `celln_shear_y_n` for every load cell (three-axis cells), `session`
(whole number, 1 throughout if absent), `rest` (1: nothing touches) and `travel_mm` (how far a machine
has its tip below the height at which it first touched). Without a load cell leave `cell1_force_n` out:
`travel_mm` is then the label, or `level_1.5_mm`, a number of steps of 1.5 mm.
An IMU has `acceleration_x_m_s2` … `rate_z_rad_s`, all six.
`celln_force_g` in place of `celln_force_n` gives grams-force. A first line `# missing = -1` says that
this number in a channel or a face is no reading.
`estimator.recordings.formats.netcdf` holds the same with named dimensions and units.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from itertools import compress

import numpy as np
from jaxtyping import Float, Int

from design.catalogue.bus_parts import MOTION
from design.errors import RecordingError
from estimator.frames.dataset import NO_FACE
from estimator.frames.heatmap import label_grid_mm
from estimator.recordings.formats.text import (
    FORMATS,
    check_complete,
    is_number,
    numbers,
    parse_number,
    whole,
)
from estimator.recordings.table import LEAST_FACES, MOST_FACES, RawTable, with_pressed_faces

TRAVEL = "travel_mm"
CHANNEL = re.compile(r"F([1-6])-([XYZ])([1-9]\d?)")
_LEVEL = re.compile(r"level_(\d+(?:\.\d+)?)_mm")
_GRAMS = re.compile(r"cell[1-9]_force_g")
_NEWTON_PER_GRAM = 9.80665e-3
"""Newton per gram-force, by standard gravity."""
_MISSING = re.compile(r"#\s*missing\s*=\s*(\S+)\s*")
_CELL = re.compile(r"cell([1-9])_(?:force_n|face)")
_FACE = re.compile(r"cell([1-9])_face")
_TIP = re.compile(r"cell([1-9])_x([1-9])_mm")
_SHEAR = re.compile(r"cell[1-9]_shear_[xy]_n")
_TIME = re.compile(r"(?:t|time|timestamp)(s|sec|seconds|ms|us|ns)?")
"""Letters of a column that looks like the time, with its unit."""
_OF_SECOND = {"ms": "1000", "us": "1 000 000", "ns": "1 000 000 000"}
_ANY_CHANNEL = "F1-X1 …"
_MOST_NAMED = 8
"""Columns that an error names one by one."""


def is_generic_header(header: list[str]) -> bool:
    """Return whether a CSV's first line is of the generic format, perhaps with errors in it."""
    return any(_meant(name) == "time_s" or CHANNEL.fullmatch(_meant(name)) for name in header)


def _meant(name: str) -> str:
    """The name of a column as this format spells it: `F1_X1`, `f1-x1` and `cell1_force [N]` are clear, and
    `t` or `time_ms` look like the time."""
    letters = _letters(name)
    if _TIME.fullmatch(letters):
        return "time_s"
    channel = re.fullmatch(r"f([1-6])([xyz])([1-9]\d?)", letters)
    if channel:
        return f"F{channel[1]}-{channel[2].upper()}{channel[3]}"
    spelt = ["time_s", "session", "rest", TRAVEL, *MOTION, *_cell_columns(1, 9), *_shear_columns(1)]
    spelt.append("cell1_force_g")
    cell = re.match(r"cell([1-9])", letters)
    alike = {re.sub(r"[^a-z0-9]", "", column): column for column in spelt}
    meant = alike.get("cell1" + letters[5:] if cell else letters, name)
    return meant.replace("cell1", f"cell{cell[1]}", 1) if cell else meant


def _letters(name: str) -> str:
    """Letters and digits of a name, small; micro is u."""
    return re.sub(r"[^a-z0-9]", "", re.sub("[µμ]", "u", name.lower()))


def generic_columns(
    channels: list[str],
    cells: int,
    tips: int,
    shear: bool = False,
    travel: bool = False,
    force: bool = True,
) -> list[str]:
    """Header of a generic CSV; `shear` adds tangential forces of every load cell at its end, `travel`
    that of a machine. Without `force` the travel is the label."""
    labels = [
        name
        for cell in range(1, cells + 1)
        for name in _cell_columns(cell, tips)
        if force or not name.endswith("_force_n")
    ]
    tangential = _shear_columns(cells) if shear else []
    of_machine = [TRAVEL] if travel else []
    return ["time_s", "session", "rest", *channels, *labels, *tangential, *of_machine]


def _cell_columns(cell: int, tips: int) -> list[str]:
    places = [f"cell{cell}_{axis}{tip}_mm" for tip in range(1, tips + 1) for axis in "xy"]
    return [f"cell{cell}_force_n", f"cell{cell}_face", *places]


def _shear_columns(cells: int) -> list[str]:
    return [f"cell{cell}_shear_{axis}_n" for cell in range(1, cells + 1) for axis in "xy"]


def missing_marker(rows: list[list[str]]) -> float | None:
    """The number that stands for no reading, if the first line is a remark that names it.

    Raises
    ------
    RecordingError
        The remark names no number, or is another one.
    """
    if not rows[0][0].lstrip().startswith("#"):
        return None
    remark = ",".join(rows[0])
    match = _MISSING.fullmatch(remark.strip())
    if match is None or not is_number(match[1]):
        raise RecordingError(
            f"its first line is {remark[:40]!r}. Before the header only `# missing = NUMBER` may "
            f"stand, such as `# missing = -1`; {FORMATS}"
        )
    return parse_number(match[1])


def is_unlabelled(header: list[str]) -> bool:
    """Return whether a CSV's first line has stamps and channels, and nothing of load cells."""
    return (
        "time_s" in header
        and any(map(CHANNEL.fullmatch, header))
        and not any(name.startswith("cell") for name in header)
    )


def generic_signals(
    rows: list[list[str]], missing: float | None = None
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame face sensor 3"]]:
    """Stamps (s) and raw counts of a generic CSV without labels, header first.

    Raises
    ------
    RecordingError
        As `generic_table`.
    """
    column = _unlabelled_columns(rows, missing)
    check_complete(column["time_s"][:, None], ["time_s"])
    return column["time_s"], counts_of_column(column, len(column["time_s"]))


def generic_motion(
    rows: list[list[str]], missing: float | None = None
) -> tuple[Float[np.ndarray, "frame"], Float[np.ndarray, "frame 6"]] | None:
    """Stamps (s) and the IMU's columns of a generic CSV without labels; None where it has none.

    Raises
    ------
    RecordingError
        As `generic_table`.
    """
    column = _unlabelled_columns(rows, missing)
    motion = motion_of(column)
    return None if motion is None else (column["time_s"], motion)


def _unlabelled_columns(
    rows: list[list[str]], missing: float | None
) -> dict[str, Float[np.ndarray, "frame"]]:
    header = [cell.strip() for cell in rows[0]]
    check_header(header, labelled=False)
    return _columns(rows, header, missing)


def generic_table(rows: list[list[str]], missing: float | None = None) -> RawTable:
    """Read the rows of a generic CSV, header first; `missing` stands for no reading.

    Raises
    ------
    RecordingError
        Missing, unknown or repeated columns, damaged cells, or labels that cannot be.
    """
    header = [cell.strip() for cell in rows[0]]
    grams = [bool(_GRAMS.fullmatch(name)) for name in header]
    header = [name[:-1] + "n" if gram else name for name, gram in zip(header, grams, strict=True)]
    steps = next((float(match[1]) for match in map(_LEVEL.fullmatch, header) if match), 1.0)
    header = [TRAVEL if _LEVEL.fullmatch(name) else name for name in header]
    cells, tips = check_header(header)
    column = _columns(rows, header, missing)
    for name in compress(header, grams):
        column[name] = _NEWTON_PER_GRAM * column[name]
    if TRAVEL in column:
        column[TRAVEL] = steps * column[TRAVEL]
    frames = len(column["time_s"])
    labels = [name for cell in range(1, cells + 1) for name in _cell_columns(cell, tips)]
    empty = np.full(frames, np.nan)
    by_cell = np.stack([column.get(name, empty) for name in labels], 1).reshape(frames, cells, -1)
    shear = _shear_columns(cells) if any(map(_SHEAR.fullmatch, header)) else []
    weighed = range(1 + _is_unweighed(header), cells + 1)
    needed = ["time_s", *(f"cell{cell}_force_n" for cell in weighed), *shear]
    check_complete(np.stack([column[name] for name in needed], axis=1), needed)
    x_mm, y_mm = label_grid_mm()
    face, force_n, shear_n = face_labels(by_cell[:, :, 1]), by_cell[:, :, 0], None
    counts = with_pressed_faces(counts_of_column(column, frames), face)
    if shear:
        shear_n = np.stack([column[name] for name in shear], axis=1).reshape(frames, cells, 2)
    return RawTable(
        kind="generic",
        time_s=column["time_s"],
        force_n=force_n,
        counts=counts,
        face=face,
        tip_xy_mm=tip_places(by_cell[:, :, 1:]),
        case=_labels(column, "session", 1, frames),
        declared_rest=_labels(column, "rest", 0, frames) == 1,
        grid_x_mm=x_mm,
        grid_y_mm=y_mm,
        duplicate_columns=(),
        digest=content_digest(
            column["time_s"], column[TRAVEL] if _is_unweighed(header) else force_n, counts, shear_n
        ),
        shear_n=shear_n,
        travel_mm=column.get(TRAVEL),
        motion=motion_of(column),
    )


def motion_of(
    column: Mapping[str, Float[np.ndarray, "frame"]],
) -> Float[np.ndarray, "frame 6"] | None:
    """Acceleration (m/s²) and angular rate (rad/s) of an IMU; None where there is none."""
    return np.stack([column[name] for name in MOTION], axis=1) if MOTION[0] in column else None


def _columns(
    rows: list[list[str]], header: list[str], missing: float | None
) -> dict[str, Float[np.ndarray, "frame"]]:
    values = numbers(rows[1:], header, first_line=2 if missing is None else 3)
    if missing is not None:
        values = without_marker(values, header, missing)
    return {name: values[:, k] for k, name in enumerate(header)}


def without_marker(
    values: Float[np.ndarray, "frame column"], header: list[str], missing: float
) -> Float[np.ndarray, "frame column"]:
    """NaN in place of the marker in channels and faces, and in the places that belong to such a face."""
    values = values.copy()
    for k, name in enumerate(header):
        if CHANNEL.fullmatch(name):
            values[values[:, k] == missing, k] = np.nan
        elif match := _FACE.fullmatch(name):
            absent = values[:, k] == missing
            tips = re.compile(rf"cell{match[1]}_[xy]\d_mm")
            places = [j for j, column in enumerate(header) if tips.fullmatch(column)]
            values[np.ix_(absent, [k, *places])] = np.nan
    return values


def content_digest(
    time_s: np.ndarray, force_n: np.ndarray, counts: np.ndarray, shear_n: np.ndarray | None
) -> str:
    """SHA-256 of the content, so that a CSV and its NetCDF are known to be the same recording."""
    digest = hashlib.sha256()
    with np.errstate(over="ignore"):
        stored_counts = counts.astype(np.float32)
    arrays = (time_s, force_n, stored_counts)
    for values in arrays if shear_n is None else (*arrays, shear_n):
        digest.update(np.ascontiguousarray(np.where(np.isnan(values), 0.0, values)).tobytes())
    return digest.hexdigest()


def _is_unweighed(header: list[str]) -> bool:
    """Return whether travel is the label, and no load cell a force."""
    return TRAVEL in header and "cell1_force_n" not in header


def check_header(header: list[str], labelled: bool = True) -> tuple[int, int]:
    """Number of load cells and of tips; without labels there may be none."""
    repeated = sorted({name for name in header if header.count(name) > 1})
    if repeated:
        raise RecordingError(f"it names {', '.join(repeated[:5])} twice. Name each column once")
    cells = max((int(m[1]) for m in map(_CELL.fullmatch, header) if m), default=0)
    tips = max((int(m[2]) for m in map(_TIP.fullmatch, header) if m), default=0)
    shear = _shear_columns(cells) if any(map(_SHEAR.fullmatch, header)) else []
    needed = [
        name for cell in range(1, max(cells, labelled) + 1) for name in _cell_columns(cell, 1)
    ]
    motion = MOTION if set(MOTION) & set(header) else ()
    known_columns = {"time_s", "session", "rest", TRAVEL, *needed, *shear, *motion}
    known_columns |= {name for cell in range(1, cells + 1) for name in _cell_columns(cell, tips)}
    if _is_unweighed(header) and cells == 1:
        needed.remove("cell1_force_n")
    unknown = [name for name in header if name not in known_columns and not CHANNEL.fullmatch(name)]
    missing = [name for name in ("time_s", *needed, *shear, *motion) if name not in header]
    if not any(CHANNEL.fullmatch(name) for name in header):
        missing.append(_ANY_CHANNEL)
    if unknown:
        raise RecordingError(_unknown_text(unknown, missing))
    if missing:
        raise RecordingError(f"it lacks the columns {', '.join(missing[:6])}. {FORMATS}")
    return cells, tips


def _unknown_text(unknown: list[str], missing: list[str]) -> str:
    """One sentence on all columns whose names are wrong."""
    nameless = [name for name in unknown if not name or name.startswith("Unnamed: ")]
    if nameless:
        return (
            "a column has no name: written by pandas with its index? `to_csv(path, index=False)` leaves "
            f"it out. {FORMATS}"
        )
    meant = {name: column for name in unknown if (column := _meant(name)) != name}
    strange = [name for name in unknown if name not in meant]
    supplied = {column.replace("force_g", "force_n") for column in meant.values()}
    supplied |= {_ANY_CHANNEL for column in supplied if CHANNEL.fullmatch(column)}
    absent = [name for name in missing if name not in supplied]
    lacking = f"it lacks {', '.join(absent[:6])}" if absent else ""
    if not meant:
        return (
            f"it has columns that are not known: {', '.join(map(repr, strange[:5]))}"
            f"{lacking and f'; {lacking}'}. Take notes and other columns out; units stand in the names "
            f"(cell1_force_n, cell1_x1_mm); {FORMATS}"
        )
    others = f"not known either: {', '.join(map(repr, strange[:5]))}" if strange else ""
    text, more = _meant_text(meant, missing), "; ".join(filter(None, [others, lacking, FORMATS]))
    return f"{text} {more[0].upper() if text.endswith('?') else more[0]}{more[1:]}"


def _meant_text(meant: dict[str, str], missing: list[str]) -> str:
    """All names that are nearly right, with what was meant; of the time also what to divide it by."""
    (name, column), *more = meant.items()
    if not more and column in missing and "(" not in _spelt(name, column):
        return f"{column} is missing (there is {name!r}). Name it {column};"
    if not more:
        return f"column {name!r} is not known: did you mean {_spelt(name, column)}?"
    named = [f"{_spelt(*pair)} for {pair[0]!r}" for pair in list(meant.items())[:_MOST_NAMED]]
    others = " and so on" if len(meant) > _MOST_NAMED else ""
    return f"{len(meant)} columns are not known: did you mean {', '.join(named)}{others}?"


def _spelt(name: str, column: str) -> str:
    """The right name of a column; of a time also its unit."""
    match = _TIME.fullmatch(_letters(name))
    if match is None or match[1] in ("s", "sec", "seconds"):
        return column
    of_second = _OF_SECOND.get(match[1])
    return f"{column} (seconds{f'; divide by {of_second}' if of_second else ''})"


def counts_of_column(
    column: Mapping[str, Float[np.ndarray, "frame"]], frames: int
) -> Float[np.ndarray, "frame face sensor 3"]:
    """Readings by face, sensor and axis; NaN where there is no such channel."""
    named = [
        (match, values) for name, values in column.items() if (match := CHANNEL.fullmatch(name))
    ]
    faces = max(LEAST_FACES, *(int(match[1]) for match, _ in named))
    counts = np.full((frames, faces, max(int(match[3]) for match, _ in named), 3), np.nan)
    for match, values in named:
        counts[:, int(match[1]) - 1, int(match[3]) - 1, "XYZ".index(match[2])] = values
    return counts


def face_labels(face: Float[np.ndarray, "frame cell"]) -> Int[np.ndarray, "frame cell"]:
    """Faces as whole numbers, `NO_FACE` where none is stated; anything else is an RecordingError."""
    names = [f"cell{cell + 1}_face" for cell in range(face.shape[1])]
    number = whole(np.nan_to_num(face, nan=NO_FACE), names)
    wrong = ~np.isin(number, range(NO_FACE, MOST_FACES + 1))
    if wrong.any():
        raise RecordingError(
            f"face labels must be 1…6, or 0 or empty for none; got "
            f"{np.unique(number[wrong]).tolist()[:5]}. Fix the label column"
        )
    return number


def tip_places(
    face_and_tips: Float[np.ndarray, "frame cell column"],
) -> Float[np.ndarray, "frame cell tip 2"]:
    """Places of tips; a face without a place, or half a place, is an error."""
    frames, cells, columns = face_and_tips.shape
    xy = face_and_tips[:, :, 1:].reshape(frames, cells, (columns - 1) // 2, 2)
    stated = np.nan_to_num(face_and_tips[:, :, 0], nan=NO_FACE) != NO_FACE
    is_finite = np.isfinite(xy)
    half = np.any(is_finite[..., 0] != is_finite[..., 1], axis=2)
    lone = stated != is_finite.any(axis=(2, 3))
    for wrong, what in ((half, "an x without its y"), (lone, "a face without a place, or a place")):
        if wrong.any():
            row, cell = np.argwhere(wrong)[0]
            raise RecordingError(
                f"data row {row + 1}: load cell {cell + 1} has {what} alone. Give face, x "
                "and y together, or leave all empty"
            )
    return xy


def _labels(
    column: dict[str, Float[np.ndarray, "frame"]], name: str, absent: int, frames: int
) -> Int[np.ndarray, "frame"]:
    values = column.get(name, np.full(frames, float(absent)))
    return whole(values[:, None], [name])[:, 0]


def cell_text(value: float) -> str:
    """A number as short as it can be read back to the microsecond and the millinewton."""
    return "" if np.isnan(value) else f"{value:.6f}".rstrip("0").rstrip(".")
