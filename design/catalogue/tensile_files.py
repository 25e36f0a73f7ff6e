"""Files of tensile tests: tables of strain and nominal stress, as written by hand or as published."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.files import require_regular_file

FIT_TO_STRETCH = 2.0
"""Points beyond it do not count for the modulus."""
LEAST_POINTS = 6
"""Points of a test, at least."""
_LEAST_STRETCH = 1.1
"""Stretch that a test must reach."""
_HEADER_LINES = 100
"""Lines of a file among which the line of titles is sought."""
_STRETCH_COLUMNS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "stretch": lambda value: value,
    "strain": lambda value: 1 + value,
    "strain_percent": lambda value: 1 + value / 100,
    "Engineering Strain": lambda value: 1 + value,
}
_STRESS_COLUMNS = {
    "nominal_stress_mpa": 1.0,
    "nominal_stress_kpa": 1e-3,
    "Engineering Stress (MPa)": 1.0,
}


@dataclass(frozen=True)
class TensileTest:
    """Stretch (1 at rest, increasing) and nominal stress (force over undeformed area, MPa).

    `details` is what stands above the table, name → value.
    """

    stretch: Float[np.ndarray, "point"]
    nominal_stress_mpa: Float[np.ndarray, "point"]
    details: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class _Table:
    """Cells of the two columns, and the number of the line that each stands in."""

    strain: str
    stress: str
    cells: list[tuple[str, str]]
    lines: list[int]
    details: dict[str, str]


def read_tensile_test(path: Path) -> TensileTest:
    """Read a CSV with a column `stretch`, `strain` or `strain_percent`, and one
    `nominal_stress_mpa` or `nominal_stress_kpa`.

    Files of the Soft Robotics Materials Database (Marechal et al., Soft Robotics 8 (2021) 284) are read
    as they are: semicolons, `Engineering Strain` and `Engineering Stress (MPa)` below lines of details.

    Raises
    ------
    InputError
        An unreadable file, missing columns, too few points, or points that are not numbers, not
        sorted, compressive, or of negative stress.
    """
    table = _table(path)
    strain, stress = (_numbers(table, index, path) for index in (0, 1))
    stretch = _STRETCH_COLUMNS[table.strain](strain)
    test = TensileTest(stretch, stress * _STRESS_COLUMNS[table.stress], table.details)
    _require_sound(test, table.lines, path)
    return test


def _table(path: Path) -> _Table:
    missing = f"cannot read tensile data from {path}: no such file. Give the path of a CSV file"
    require_regular_file(path, missing)
    try:
        text = path.read_text(encoding="utf-8-sig").splitlines()
        table = _found(text)
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InputError(f"cannot read tensile data from {path}: {error}") from None
    if table is None or not table.cells:
        columns = text[0].split(",") if text else []
        raise InputError(
            f"{path} has the columns {columns}; tensile data need one of {list(_STRETCH_COLUMNS)} and "
            f"one of {list(_STRESS_COLUMNS)}, and numbers below them. Name them in one line, separated by "
            "commas or semicolons"
        )
    return table


def _found(text: list[str]) -> _Table | None:
    """The table below the first line that names both columns; lines without either cell are blank."""
    for top, line in enumerate(text[:_HEADER_LINES]):
        for delimiter in ",;":
            names = [name.strip() for name in line.split(delimiter)]
            strain = next((name for name in _STRETCH_COLUMNS if name in names), None)
            stress = next((name for name in _STRESS_COLUMNS if name in names), None)
            if strain is None or stress is None:
                continue
            columns = names.index(strain), names.index(stress)
            rows = list(csv.reader(text[top + 1 :], delimiter=delimiter))
            cells = [tuple(row[k].strip() if k < len(row) else "" for k in columns) for row in rows]
            kept = [(a, b, top + 2 + k) for k, (a, b) in enumerate(cells) if a or b]
            details = dict(
                cut[:2] for cut in (above.split(delimiter) for above in text[:top]) if len(cut) > 1
            )
            return _Table(
                strain, stress, [(a, b) for a, b, _ in kept], [n for *_, n in kept], details
            )
    return None


def _numbers(table: _Table, index: int, path: Path) -> np.ndarray:
    try:
        return np.array([float(cells[index]) for cells in table.cells])
    except ValueError as error:
        name = (table.strain, table.stress)[index]
        raise InputError(
            f"{path}, column {name}: {error}. Every line needs a number with a decimal point"
        ) from None


def _require_sound(test: TensileTest, lines: list[int], path: Path) -> None:
    stretch, stress = test.stretch, test.nominal_stress_mpa
    if not (np.isfinite(stretch).all() and np.isfinite(stress).all()):
        raise InputError(f"{path} holds values that are not finite. Remove those lines")
    if stretch.min() < 1 or stress.min() < 0:
        row = int(np.argmax((stretch < 1) | (stress < 0)))
        raise InputError(
            f"{path}, line {lines[row]}: stretch {stretch[row]:g}, stress {stress[row]:g} MPa. "
            "Tension is needed: stretch ≥ 1 and stress ≥ 0. Zero the load cell, drop those lines"
        )
    if (np.diff(stretch) <= 0).any():
        row = int(np.argmax(np.diff(stretch) <= 0)) + 1
        raise InputError(
            f"{path}, line {lines[row]}: the stretch {stretch[row]:g} does not exceed the one before. "
            "Give one pull, sorted by stretch; leave unloading out"
        )
    usable = int((stretch <= FIT_TO_STRETCH).sum())
    if usable < LEAST_POINTS or stretch[-1] < _LEAST_STRETCH:
        raise InputError(
            f"{path} has {usable} points up to a stretch of {min(stretch[-1], FIT_TO_STRETCH):g}; at "
            f"least {LEAST_POINTS} that reach {_LEAST_STRETCH:g} are needed. Pull further or keep more"
        )
