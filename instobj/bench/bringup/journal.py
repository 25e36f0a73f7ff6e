"""The file of a bring-up: every finished recording and every skipped question, as they come.

A CSV that only grows. A recording is appended with one write when it is complete and forced to disk;
what a power cut left of one is cut off when the file is opened again. The last recording of a name
counts, so that a step can be repeated after soldering.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from design.errors import InputError, StoreError
from design.files import require_regular_file, write_whole
from design.spec.object import ObjectSpec
from estimator.calibration.resting import channel_names
from estimator.recordings.formats.generic import cell_text
from instobj.bench.bringup.asking.asked import Recording, asked_of

_FORMAT = "# instobj bench bringup 1"
_OWN = ("recording", "row", "rows", "sequence", "board_ms", "damaged_lines", "bus_errors")
_SECTIONS = ("arrangement", "body", "shell", "core", "sensors", "magnets")


def identity_of(spec: ObjectSpec) -> str:
    """Name and hash of what a bring-up depends on."""
    sections = spec.model_dump(mode="json", include=set(_SECTIONS))
    digest = hashlib.sha256(json.dumps(sections, sort_keys=True).encode()).hexdigest()
    return f"{spec.name},{digest[:16]}"


@dataclass
class Journal:
    """Content so far: recordings by name, names of skipped questions, bytes cut off at its end."""

    path: Path
    recordings: dict[str, Recording] = field(default_factory=dict)
    skipped: set[str] = field(default_factory=set)
    cut_bytes: int = 0

    def append(self, recording: Recording) -> None:
        """Keep a complete recording.

        Raises
        ------
        StoreError
            The disk is full; the file stays as it was, but for an unfinished end.
        """
        self._write("".join(f"{','.join(row)}\n" for row in _rows(recording)))
        self.recordings[recording.name] = recording
        self.skipped.discard(recording.name)

    def skip(self, name: str) -> None:
        """Keep that a question was skipped."""
        self._write(f"{name},0,0\n")
        self.skipped.add(name)
        self.recordings.pop(name, None)

    def _write(self, text: str) -> None:
        try:
            with self.path.open("ab", buffering=0) as file:
                write_whole(file.fileno(), text.encode())
                os.fsync(file.fileno())
        except OSError as error:
            raise StoreError(f"cannot write {self.path}: {error.strerror}. Make room") from None


def _rows(recording: Recording) -> Iterator[list[str]]:
    count = str(len(recording.counts))
    errors = [str(recording.damaged_lines), _text(recording.bus_errors)]
    for row, counts in enumerate(recording.counts.reshape(len(recording.counts), -1), start=1):
        frame = [str(recording.sequence[row - 1]), str(recording.board_ms[row - 1])]
        cells = [cell_text(float(value)) for value in counts]
        yield [recording.name, str(row), count, *frame, *errors, *cells]


def _text(errors: int | None) -> str:
    return "" if errors is None else str(errors)


def open_journal(path: Path, spec: ObjectSpec) -> Journal:
    """The journal of an object, made where there is none; an unfinished end is cut off.

    Raises
    ------
    InputError
        It is of another object, or damaged.
    StoreError
        It cannot be written.
    """
    if not path.exists():
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"{_first_line(spec)}\n{_header(spec)}\n")
        except OSError as error:
            raise StoreError(f"cannot write {path}: {error.strerror}. Choose --out") from None
        return Journal(path)
    journal, sound_bytes = _read(path, spec)
    journal.cut_bytes = path.stat().st_size - sound_bytes
    if journal.cut_bytes:
        os.truncate(path, sound_bytes)
    return journal


def read_journal(path: Path, spec: ObjectSpec) -> Journal:
    """The journal that `--replay` names; it is left as it is.

    Raises
    ------
    InputError
        There is none, it is of another object, or damaged.
    """
    require_regular_file(path, f"no bring-up at {path}. Give a file bringup.csv of this object")
    return _read(path, spec)[0]


def _first_line(spec: ObjectSpec) -> str:
    return f"{_FORMAT},{identity_of(spec)}"


def _header(spec: ObjectSpec) -> str:
    return ",".join([*_OWN, *channel_names(spec)])


def _read(path: Path, spec: ObjectSpec) -> tuple[Journal, int]:
    """The journal, and how many bytes of it are whole recordings."""
    lines = path.read_bytes().decode("utf-8", "replace").splitlines(keepends=True)
    _require_own(path, spec, [line.rstrip("\n") for line in lines[:2]])
    names = {question.name for question in asked_of(spec)}
    journal, position = Journal(path), 2
    sound = sum(len(line.encode()) for line in lines[:2])
    while position < len(lines):
        name, row, count, *_ = [*lines[position].rstrip("\n").split(","), "", "", ""]
        complete = lines[position].endswith("\n")
        if complete and (name not in names or not count.isdigit() or row not in ("0", "1")):
            raise InputError(
                f"{path}, line {position + 1}: {lines[position][:40]!r}… begins no recording of {spec.name}. "
                "Remove that line, or the file to begin anew"
            )
        block = lines[position : position + max(int(count or 1), 1)]
        if not complete or len(block) < int(count or 1) or not block[-1].endswith("\n"):
            break
        if row == "0":
            journal.skipped.add(name)
            journal.recordings.pop(name, None)
        else:
            journal.recordings[name] = _recording(path, spec, position, block)
            journal.skipped.discard(name)
        sound, position = sound + sum(len(line.encode()) for line in block), position + len(block)
    return journal, sound


def _require_own(path: Path, spec: ObjectSpec, lines: list[str]) -> None:
    if not lines or not lines[0].startswith(_FORMAT):
        raise InputError(f"{path} is no file of a bring-up. Give bringup.csv, or another --out")
    if lines != [_first_line(spec), _header(spec)]:
        theirs = lines[0].removeprefix(f"{_FORMAT},")
        raise InputError(
            f"{path} is of another object ({theirs}; this is {identity_of(spec)}: name, hash of body, "
            "shell, core, sensors and magnets). Give its specification, or another --out"
        )


def _recording(path: Path, spec: ObjectSpec, position: int, block: list[str]) -> Recording:
    """One recording from its lines; `position` is the number of lines before it."""
    rows = [line.rstrip("\n").split(",") for line in block]
    width = len(_OWN) + len(channel_names(spec))
    for k, row in enumerate(rows):
        if len(row) != width or row[:3] != [rows[0][0], str(k + 1), str(len(rows))]:
            raise InputError(
                f"{path}, line {position + k + 1}: got {','.join(row)[:50]!r}…, expected row {k + 1} of "
                f"{len(rows)} of {rows[0][0]!r} with {width} cells. Remove the file to begin anew"
            )
    try:
        numbers = np.array([[float(cell or "nan") for cell in row[3:]] for row in rows])
    except ValueError as error:
        raise InputError(
            f"{path}, lines {position + 1} to {position + len(rows)}: {error}. Fix it"
        ) from None
    errors = numbers[0, 3]
    return Recording(
        rows[0][0],
        numbers[:, 4:].reshape(len(rows), -1, 3),
        numbers[:, 0].astype(int),
        numbers[:, 1].astype(int),
        int(numbers[0, 2]),
        None if np.isnan(errors) else int(errors),
    )
