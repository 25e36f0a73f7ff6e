"""Identification of an object from its log: columns, chips, faces and places, in this order."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from pathlib import Path

import numpy as np

from design.errors import InputError, RecordingError
from estimator.adoption.chips import clean_chips
from estimator.adoption.columns import group_axes, tell_columns
from estimator.adoption.faces import chips_under_faces
from estimator.adoption.findings import CERTAIN, Finding
from estimator.adoption.places import PlaceOrder, order_of_places
from estimator.adoption.presses import ForeignPresses, find_presses, label_kind
from estimator.adoption.text_table import read_text_table
from estimator.recordings.formats.text import naming

ANSWERING = "chips that answer"
"""Question to a log that names no face: which chips see presses at all."""


@dataclass(frozen=True)
class Known:
    """Statements of a user about a log; None where it is to be found or does not matter.

    Attributes
    ----------
    columns : roles of the columns in the order of the file, `columns.tell_columns`
    axes : `chip` or `axis`, how the columns hold x, y and z
    label : `force`, `level` or `travel`
    step_mm : travel from one level to the next
    pitch_mm : distance of places from row to row, and within a row
    """

    columns: str | None = None
    axes: str | None = None
    label: str | None = None
    step_mm: float | None = None
    pitch_mm: tuple[float, float] | None = None

    @classmethod
    def read(cls, given: dict[str, object]) -> Known:
        """Check what was given.

        Raises
        ------
        InputError
            Another key, or a value of another kind.
        """
        keys = [field.name for field in fields(cls)]
        if unknown := [key for key in given if key not in keys]:
            raise InputError(
                f"--known {unknown[0]} is not asked for. Give one of {', '.join(keys)}"
            )
        checked = dict(given)
        for key, many in (("step_mm", 1), ("pitch_mm", 2)):
            if key in checked:
                checked[key] = _lengths(key, checked[key], many)
        for key in ("columns", "axes", "label"):
            if key in checked and not isinstance(checked[key], str):
                raise InputError(f"--known {key} must be text; got {checked[key]!r}")
        return cls(**checked)  # pyright: ignore[reportArgumentType]


def _lengths(key: str, value: object, many: int) -> float | tuple[float, ...]:
    numbers = value if isinstance(value, list) else [value]
    good = [n for n in numbers if isinstance(n, int | float) and 0 < n < 1000]
    if len(good) != len(numbers) or len(good) not in (1, many):
        shape = "a length" if many == 1 else f"one length or {many}"
        raise InputError(f"--known {key} must be {shape} in mm, such as 7.8; got {value!r}")
    return float(good[0]) if many == 1 else tuple(float(n) for n in (good * many)[:many])


@dataclass(frozen=True)
class Identified:
    """Content of one log, or of several of one object.

    Attributes
    ----------
    presses : one table a log; chips in the order of the columns
    kind : `level`, `travel`, `force` or `none`: what the label is
    chips_of_face : pressed face → its chips, counted from 0
    orders : (log, face) → order of its places
    """

    paths: tuple[Path, ...]
    presses: tuple[ForeignPresses, ...]
    kind: str
    chips_of_face: dict[int, list[int]]
    orders: dict[tuple[int, int], PlaceOrder]
    findings: tuple[tuple[str, Finding], ...]
    notes: tuple[tuple[str, str], ...]

    @property
    def all_presses(self) -> ForeignPresses:
        """Presses of all logs in one table."""
        return _joined(list(self.presses))


def identify(paths: list[Path], answers: Known) -> Identified:
    """Read logs of one object and identify it.

    Raises
    ------
    RecordingError
        A file that is no log, logs of unlike objects, or columns that need to be stated.
    """
    tables, kinds, findings, notes = [], [], [], []
    for path in paths:
        with naming(path):
            log = tell_columns(read_text_table(path), answers.columns)
            counts, order = group_axes(log, answers.axes)
            clean = clean_chips(counts)
            kind, label = label_kind(log, answers.label)
            presses, lag = find_presses(log, clean.counts, kind)
        notes += [(path.name, note) for note in log.notes]
        findings += [(path.name, finding) for finding in (order, *clean.findings, label, *lag)]
        tables.append(presses)
        kinds.append(kind)
    _require_alike(paths, tables, kinds)
    joined = _joined(tables)
    chips, of_faces = chips_under_faces(joined)
    if not joined.labelled:
        chips, of_faces = {}, [replace(finding, question=ANSWERING) for finding in of_faces]
    where = paths[0].name if len(paths) == 1 else "all logs"
    findings += [(where, finding) for finding in of_faces]
    orders = {}
    for number, presses in enumerate(tables):
        for face, chips_of in chips.items():
            order = order_of_places(presses, chips_of, face)
            if order is not None:
                if order.p <= CERTAIN:
                    orders[number, face] = order
                findings.append((paths[number].name, order.finding(face)))
    return Identified(
        tuple(paths), tuple(tables), kinds[0], chips, orders, tuple(findings), tuple(notes)
    )


def _require_alike(paths: list[Path], tables: list[ForeignPresses], kinds: list[str]) -> None:
    for path, table, kind in zip(paths, tables, kinds, strict=True):
        alike = (table.change.shape[1], table.labelled, kind)
        if alike != (tables[0].change.shape[1], tables[0].labelled, kinds[0]):
            raise RecordingError(
                f"{path} holds {table.change.shape[1]} chips and {kind} labels, {paths[0]} "
                f"{tables[0].change.shape[1]} and {kinds[0]}. Adopt logs of one object and kind together"
            )


def _joined(tables: list[ForeignPresses]) -> ForeignPresses:
    if len(tables) == 1:
        return tables[0]
    contacts = max(table.face.shape[1] for table in tables)
    places = max(table.place.shape[1] for table in tables)
    cells = max(table.label.shape[1] for table in tables)

    def stacked(name: str, width: int) -> np.ndarray:
        parts = [getattr(table, name) for table in tables]
        return np.concatenate([np.pad(p, ((0, 0), (0, width - p.shape[1]))) for p in parts])

    return ForeignPresses(
        stacked("face", contacts), stacked("place", places), stacked("label", cells),
        np.concatenate([table.change for table in tables]),
        np.mean([table.resting for table in tables], axis=0),
        np.concatenate([table.rest_scatter for table in tables]),
    )  # fmt: skip
