"""Columns of a foreign log: labels, stamps and the three axes of every chip.

Names decide where a header gives them. Without names, values do: labels are small whole numbers that stay
for many rows, stamps only rise, and what is left must be three columns per chip. What two readings of a
table fit alike is asked for, not guessed.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import RecordingError
from estimator.adoption.findings import CERTAIN, EXCHANGES, Finding, share_as_high
from estimator.adoption.text_table import TextTable

ORDER_OF_COLUMNS = "order of columns"
ROLES = ("time", "face", "place", "level", "force", "-", "chips")
MOST_FACES, MOST_PLACES = 6, 1000
"""Largest number of a face, and of a place, that a label holds."""
_CALM = 0.5
"""Share of rows in which a label changes, at most."""
_RISING = 0.999
"""Share of steps that do not fall, of a stamp."""
_MOST_COUNT = 1e6
"""Number that no chip of 20 bits writes: nanoseconds go beyond."""
_ROWS = 3000
"""Rows from which the activity of channels is taken."""
_WORDS = {
    "face": ("face", "side"),
    "place": ("pos", "position", "place", "location", "point", "spot", "case"),
    "force": ("force", "load", "newton", "fz", "weight", "left", "right", "gram", "grams"),
    "level": ("level", "travel", "depth", "step", "height"),
    "time": (
        "time",
        "stamp",
        "t",
        "sec",
        "secs",
        "seconds",
        "nanosec",
        "ms",
        "millis",
        "timestamp",
    ),
}
_CHANNEL = re.compile(r"(.*?)([xyz])[ _.-]?(\d+)$|(.*?\d)[ _.-]?([xyz])$", re.IGNORECASE)


@dataclass(frozen=True)
class ForeignLog:
    """A log with named columns; NaN where a cell is empty.

    Attributes
    ----------
    channels : (row, 3 · chips), in the order of the file
    by_chip : whether x, y, z of a chip stand together; None where names do not say
    face, place : (row, contact) labels as written; no columns where there are none
    label : (row, cell) forces, levels or travels, in the unit of the file
    stated : name of the label's columns where a header gives one
    """

    channels: Float[np.ndarray, "row channel"]
    by_chip: bool | None
    face: Float[np.ndarray, "row named"]
    place: Float[np.ndarray, "row placed"]
    label: Float[np.ndarray, "row cell"]
    time_s: Float[np.ndarray, "row"] | None
    stated: str
    notes: tuple[str, ...]


def tell_columns(table: TextTable, columns: str | None = None) -> ForeignLog:
    """Tell labels from channels.

    Parameters
    ----------
    columns : text, optional
        Roles in the order of the file, such as `time,face,place,level,chips` (`-` leaves one out).

    Raises
    ------
    RecordingError
        The columns fit no log, or two kinds of log: the message says what to state.
    """
    width = table.values.shape[1]
    if columns is not None:
        roles, source = _stated(columns, width), "as stated"
    elif table.names is not None and (named := _roles_of_names(table.names)):
        roles, source = named, "by their names"
    else:
        roles, source = _roles_of_values(table.values), "by their values"
    columns_of = {role: [k for k, given in enumerate(roles) if given == role] for role in ROLES}
    chips = columns_of["chips"]
    if not chips or len(chips) % 3:
        raise RecordingError(
            f"{len(chips)} of its {width} columns are left for chips, sensors of three "
            "columns each. State the columns: --known columns=time,face,place,level,chips (- leaves one out)"
        )
    by_chip = None
    if table.names is not None:
        chips, by_chip = _ordered(table.names, chips)
    values, labels = table.values, columns_of["force"] or columns_of["level"]
    time_s = values[:, columns_of["time"][0]] if columns_of["time"] else None
    for first, second in pairwise(columns_of["time"]):
        if _is_nanoseconds(values[:, first], values[:, second]):
            time_s = values[:, first] + 1e-9 * values[:, second]
    said = [f"{len(columns_of[role])} {role}" for role in ROLES[:-1] if columns_of[role]]
    note = f"columns told {source}: {', '.join([*said, f'{len(chips) // 3} chips of three axes'])}"
    stated = "" if table.names is None else " ".join(table.names[k] for k in labels)
    return ForeignLog(
        values[:, chips], by_chip, values[:, columns_of["face"]], values[:, columns_of["place"]],
        values[:, labels], time_s, stated, (*table.notes, note),
    )  # fmt: skip


def _stated(columns: str, width: int) -> list[str]:
    roles = [role.strip() for role in columns.split(",")]
    wrong = [role for role in roles if role not in ROLES]
    if wrong or roles.count("chips") != 1:
        raise RecordingError(
            f"columns={columns}: {', '.join(wrong) or 'chips'} cannot be placed. Name once each column "
            f"before and after the chips' ({', '.join(ROLES[:-1])}), and `chips` for all of theirs"
        )
    first, many = roles.index("chips"), width - len(roles) + 1
    if many < 3:
        raise RecordingError(f"columns={columns} leaves {many} of {width} columns for the chips")
    return [*roles[:first], *["chips"] * many, *roles[first + 1 :]]


def _roles_of_names(names: tuple[str, ...]) -> list[str] | None:
    """Return a role per column; None where names leave one open."""
    roles = []
    for name in names:
        words = re.findall("[a-z]+", name.lower())
        role = next((r for r, vocabulary in _WORDS.items() if set(words) & set(vocabulary)), "")
        if not role and _CHANNEL.fullmatch(name):
            role = "chips"
        roles.append(role)
    return roles if "chips" in roles and "" not in roles else None


def _ordered(names: tuple[str, ...], chips: list[int]) -> tuple[list[int], bool | None]:
    """Return the channels chip by chip, x, y, z, where every name says chip and axis."""
    keys: dict[tuple[str, str], dict[str, int]] = {}
    for column in chips:
        match = _CHANNEL.fullmatch(names[column])
        if match is None:
            return chips, None
        prefix, axis, number, alone, last = match.groups()
        key = (prefix, number) if axis else (alone, "")
        keys.setdefault(key, {})[(axis or last).lower()] = column
    if any(len(axes) != 3 for axes in keys.values()):
        return chips, None
    return [axes[a] for axes in keys.values() for a in "xyz"], True


def _roles_of_values(values: Float[np.ndarray, "row column"]) -> list[str]:
    width = values.shape[1]
    kinds = [_kind(values[:, column]) for column in range(width)]
    for column in range(1, width):
        if _is_nanoseconds(values[:, column - 1], values[:, column]):
            kinds[column - 1 : column + 1] = ["time", "time"]
    head = next((k for k, kind in enumerate(kinds) if not kind), width)
    # the first chips may never answer, three columns each; other columns of zeros say nothing
    zeros = next((k for k in range(head) if not _is_silent(values[:, head - 1 - k])), head)
    head -= zeros - zeros % 3
    kinds[:head] = [
        "constant" if _is_silent(values[:, k]) else kind for k, kind in enumerate(kinds[:head])
    ]
    tail = next((k for k, kind in enumerate(kinds[::-1]) if kind not in ("label", "time")), 0)
    # the last chips may never answer: columns of zeros at the end are no labels
    while tail and _is_silent(values[:, width - tail]):
        tail -= 1
    forces = _continuous_labels(values, head, width - tail)
    roles = [*kinds[:head], *["chips"] * (width - head - tail), *kinds[width - tail :]]
    for column in forces:
        roles[column] = "force"
    labels = [k for k, role in enumerate(roles) if role == "label"]
    for column, role in zip(labels, _label_roles(values[:, labels], bool(forces)), strict=True):
        roles[column] = role
    return ["-" if role == "constant" else role for role in roles]


def _is_silent(column: Float[np.ndarray, "row"]) -> bool:
    return bool(np.isin(column, (0.0, -1.0)).all())


def _is_nanoseconds(seconds: Float[np.ndarray, "row"], rest: Float[np.ndarray, "row"]) -> bool:
    """Return whether two columns are one stamp, as ROS 2 writes it: whole seconds, then nanoseconds."""
    if not (np.isfinite(seconds).all() and np.isfinite(rest).all()) or rest.max() <= _MOST_COUNT:
        return False
    whole = np.all(seconds == np.round(seconds)) and np.all(rest == np.round(rest))
    # subtracted first: 1.7e9 s leave no room for nanoseconds in 64 bits
    step = np.diff(seconds) + 1e-9 * np.diff(rest)
    rises = np.all(np.diff(seconds) >= 0) and np.mean(step >= 0) > _RISING
    return bool(whole and rises and rest.min() >= 0 and rest.max() < 1e9)


def _kind(column: Float[np.ndarray, "row"]) -> str:
    """Return time, label or nothing, from one column's values alone."""
    readings = column[np.isfinite(column)]
    if not len(readings):
        return "constant"
    step, whole = np.diff(readings), bool(np.all(readings == np.round(readings)))
    distinct = len(np.unique(readings))
    rising = len(step) > 0 and float(np.mean(step >= 0)) > _RISING and distinct > 1
    if rising and (not whole or distinct > MOST_PLACES or readings.max() > _MOST_COUNT):
        return "time"
    calm = len(step) > 0 and float(np.mean(step != 0)) < _CALM
    if whole and calm and readings.min() >= 0 and readings.max() <= MOST_PLACES:
        return "label"
    return ""


def _continuous_labels(values: Any, head: int, end: int) -> list[int]:
    """Return columns of forces next to the chips': of another grain than those, or one or two too many.

    Raises
    ------
    RecordingError
        They may stand before the chips or behind them.
    """
    grain = [bool(np.all(v == np.round(v))) for v in (c[np.isfinite(c)] for c in values.T)]
    usual = float(np.mean(grain[head:end])) > 0.5
    first_chip = next((k for k in range(head, end) if grain[k] == usual), head)
    behind = next((k for k in range(end, head, -1) if grain[k - 1] == usual), end)
    forces = [*range(head, first_chip), *range(behind, end)]
    if (end - head - len(forces)) % 3:
        raise RecordingError(
            f"{end - head} columns are no labels, which is no multiple of three: forces may stand before "
            "the chips or behind them. State the columns: --known columns=force,chips,face,place"
        )
    return forces


def _label_roles(labels: Float[np.ndarray, "row label"], with_force: bool) -> list[str]:
    """Return face, place and level: faces have few numbers, places more, levels change most often.

    Raises
    ------
    RecordingError
        Labels that may be one or the other.
    """
    many = [len(np.unique(c[np.isfinite(c) & (c > 0)])) for c in labels.T]
    changes = [int(np.sum(np.diff(c[np.isfinite(c)]) != 0)) for c in labels.T]
    few = [np.nanmax(c) <= MOST_FACES for c in labels.T]
    if with_force and labels.shape[1] and few[0]:
        return ["face" if is_few else "place" for is_few in few]
    if labels.shape[1] == 1:
        return ["place"]
    if labels.shape[1] == 2 and not few[int(np.argmin(changes))]:
        return _place_and_level(many, changes)
    if labels.shape[1] == 3 and any(few):
        # a face stays while places change; of two such labels (levels may stay, too) the first
        face = next((k for k in range(3) if few[k] and changes[k] < max(changes)), few.index(True))
        others = [k for k in range(3) if k != face]
        roles = _place_and_level([many[k] for k in others], [changes[k] for k in others])
        roles.insert(face, "face")
        return roles
    if labels.shape[1] == 0:
        return []
    raise RecordingError(
        f"{labels.shape[1]} columns hold labels of {many} values: which are faces, places and levels is not "
        "clear. State the columns: --known columns=face,place,level,chips"
    )


def _place_and_level(many: list[int], changes: list[int]) -> list[str]:
    """Return which of two labels numbers the places: that of twice the numbers, else the calmer one."""
    plain = max(many) >= 2 * min(many)
    place = int(np.argmax(many) if plain else np.argmin(changes))
    return ["place", "level"] if place == 0 else ["level", "place"]


def group_axes(
    log: ForeignLog, given: str | None
) -> tuple[Float[np.ndarray, "row chip 3"], Finding]:
    """Return counts chip by chip, and how the columns hold x, y and z.

    Axes of one chip are active in the same rows. The null groups the columns by threes at random.

    Raises
    ------
    RecordingError
        `given` is neither `chip` (x, y, z of a chip stand together) nor `axis` (all x first).
    """
    if given not in (None, "chip", "axis"):
        raise RecordingError(
            f"axes={given} is neither chip (x1, y1, z1, x2, …) nor axis (x1, x2, …)"
        )
    chips = log.channels.shape[1] // 3
    orders = {
        "chip": np.arange(3 * chips).reshape(-1, 3),
        "axis": np.arange(3 * chips).reshape(3, -1).T,
    }
    words = {"chip": "x, y, z of a chip stand together", "axis": "x of all chips, then y, then z"}
    if given or log.by_chip:
        name, finding = given or "chip", ("as stated" if given else "the header names them")
        return log.channels[:, orders[name]], Finding(ORDER_OF_COLUMNS, words[name], finding)
    alike = _alike(log.channels)
    fits = {name: _axis_agreement(alike, order) for name, order in orders.items()}
    rng = np.random.default_rng(33)
    null = [
        _axis_agreement(alike, rng.permutation(3 * chips).reshape(-1, 3)) for _ in range(EXCHANGES)
    ]
    name = max(fits, key=lambda key: fits[key])
    alternative, p = min(fits.values()), share_as_high(null, fits[name])
    finding = Finding(
        ORDER_OF_COLUMNS,
        words[name] if p <= CERTAIN else f"{words[name]}, assumed: state it with --known axes",
        f"axes of a chip active together: correlation {fits[name]:.2f}, the other way {alternative:.2f}",
        f"{np.median(null):.2f}",
        p,
    )
    return log.channels[:, orders[name]], finding


def _alike(channels: Float[np.ndarray, "row channel"]) -> Float[np.ndarray, "channel channel"]:
    """Return correlations of how far channels are from their medians, over rows spread evenly."""
    some = channels[:: max(1, len(channels) // _ROWS)]
    # channels that never answer have no level: they go with nothing
    some = np.where(np.isfinite(some).any(axis=0), some, 0.0)
    off = np.log1p(np.abs(some - np.nanmedian(some, axis=0)))
    off = np.nan_to_num(off - np.nanmean(off, axis=0))
    length = np.maximum(np.linalg.norm(off, axis=0), 1e-9)
    return off.T @ off / (length[:, None] * length)


def _axis_agreement(alike: np.ndarray, groups: np.ndarray) -> float:
    pairs = ((0, 1), (0, 2), (1, 2))
    return float(np.mean([alike[groups[:, a], groups[:, b]] for a, b in pairs]))
