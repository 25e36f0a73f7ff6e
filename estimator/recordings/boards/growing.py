"""Recordings that grow line by line and survive Ctrl-C, kill -9 and power cuts.

The CSV (generic format) only ever grows: every frame is one write, forced to disk once a second. A
line that a power cut left unfinished is cut off when the file is opened again.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from design.errors import RecordingError, StoreError
from design.files import write_whole
from estimator.recordings.formats.generic import cell_text, generic_columns
from estimator.recordings.formats.netcdf import write_generic_netcdf

SYNC_S = 1.0
"""Time after which what is written is forced onto the disk."""


@dataclass
class GrowingRecording:
    """An open CSV: rows it had and got, the session that goes on, and bytes cut off at its end.

    `last_s` is the time of the last row that it had, 0 without one.
    """

    path: Path
    columns: list[str]
    rows_before: int
    session: int
    cut_bytes: int
    last_s: float
    _handle: int
    rows_added: int = 0
    _synced_s: float = 0.0

    def append(self, values: Sequence[float]) -> None:
        """Write one row (NaN becomes an empty cell).

        Raises
        ------
        RecordingError
            Another number of values than columns.
        StoreError
            The disk is full.
        """
        if len(values) != len(self.columns):
            raise RecordingError(
                f"{self.path} has {len(self.columns)} columns; got {len(values)} values. Give a "
                "separate file to another board"
            )
        line = ",".join(map(cell_text, values)) + "\n"
        try:
            write_whole(self._handle, line.encode())
            if time.monotonic() - self._synced_s > SYNC_S:
                os.fsync(self._handle)
                self._synced_s = time.monotonic()
        except OSError as error:
            raise StoreError(f"cannot write {self.path}: {error.strerror}. Make room") from None
        self.rows_added += 1


@contextmanager
def growing_recording(
    path: Path,
    channels: Sequence[str],
    cells: int,
    tips: int,
    session: int | None = None,
    travel: bool = False,
    force: bool = True,
) -> Iterator[GrowingRecording]:
    """Open a recording to append to; its last session goes on unless another is given. `travel` adds
    the column of a machine's travel; without `force` that is the label.

    Raises
    ------
    RecordingError
        The file has other columns (another board, other numbers of load cells or tips), or is not
        a recording.
    StoreError
        It cannot be written.
    """
    columns = generic_columns(list(channels), cells, tips, travel=travel, force=force)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o644)
    except OSError as error:
        raise StoreError(f"cannot write {path}: {error.strerror}. Choose another folder") from None
    try:
        rows, last, last_s, cut = _resume(handle, path, columns)
        yield GrowingRecording(path, columns, rows, session or last, cut, last_s, handle)
        os.fsync(handle)
    finally:
        os.close(handle)


def _resume(handle: int, path: Path, columns: list[str]) -> tuple[int, int, float, int]:
    """Rows, last session and last time of what is there, and bytes of an unfinished line, now cut off."""
    content = path.read_bytes()
    whole = content.rfind(b"\n") + 1
    header = ",".join(columns)
    if whole == 0 and header.encode().startswith(content):
        os.ftruncate(handle, 0)
        write_whole(handle, f"{header}\n".encode())
        return 0, 1, 0.0, len(content)
    first, *rows = content[:whole].decode("utf-8", "replace").splitlines() or [""]
    if first != header:
        raise RecordingError(
            f"{path} is there with other columns ({first[:60]}…; wanted {header[:60]}…). Give "
            "another name, or the same channels, load cells and tips"
        )
    os.ftruncate(handle, whole)
    return len(rows), *_last(path, rows), len(content) - whole


def _last(path: Path, rows: list[str]) -> tuple[int, float]:
    """Session and time of the last row."""
    if not rows:
        return 1, 0.0
    time_s, cell = rows[-1].split(",")[:2]
    if not cell.isdigit():
        raise RecordingError(f"{path}: the last row's session is {cell!r}. Fix or remove that row")
    try:
        return int(cell), float(time_s)
    except ValueError:
        raise RecordingError(
            f"{path}: the last row's time is {time_s!r}. Fix or remove that row"
        ) from None


def finish_recording(csv_path: Path, target: Path) -> int:
    """Write the whole recording as NetCDF under its final name; returns its frames.

    Raises
    ------
    RecordingError
        The recording holds no frame, or a damaged one.
    """
    from estimator.recordings.formats.files import read_table

    table = read_table(csv_path)
    write_generic_netcdf(table, target)
    return len(table.force_n)
