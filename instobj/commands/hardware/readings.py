"""Readings of a file or a port for any estimator: zeroed, read one by one, and where results go."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, Protocol, runtime_checkable

import numpy as np

from design.errors import InputError
from design.files import require_regular_file
from design.netcdf import holds
from estimator.deploy.zeroing import ZERO_FRAMES, ZeroMode
from estimator.frames.dataset import FrameSet, load_frames
from estimator.frames.face_data import Channel
from estimator.frames.same_object import require_same_sensors
from estimator.recordings.table import FACES
from instobj.store.publish import require_writable, require_writable_folder, run_folder, run_name


@dataclass(frozen=True)
class Zeroing:
    """How raw counts become changes against rest (`estimator.deploy.zeroing`); by default they follow
    rest, except those of data sets."""

    mode: ZeroMode | None = None
    frames: int = ZERO_FRAMES

    @property
    def of_raw(self) -> tuple[ZeroMode, int]:
        """Mode and frames for raw counts."""
        return self.mode or "rest", self.frames


FOLLOW_REST = Zeroing()


@runtime_checkable
class Reader(Protocol):
    """Takes raw counts frame by frame; None while there is no zero."""

    def feed(self, raw_counts: np.ndarray, time_s: float) -> Any: ...


class LiveFrame(NamedTuple):
    """What a reader finds in a frame of a board, its number and stamp, and the state of the line."""

    number: int
    time_s: float
    found: Any
    line: dict[str, int]


def zeroed_data_set(path: Path, zeroing: Zeroing) -> FrameSet:
    """A data set, which is zeroed already.

    Raises
    ------
    InputError
        It is to be zeroed again.
    """
    if zeroing.mode not in (None, "none"):
        raise InputError(
            f"{path} is a data set, zeroed press by press; got --zero {zeroing.mode}. Leave "
            "--zero out"
        )
    return load_frames(path)


def recorded_frames(
    reader: Reader, channels: tuple[Channel, ...], path: Path, zeroing: Zeroing
) -> Iterator[tuple[int, float, Any]]:
    """Number, stamp (s) and what the reader finds of every frame of a recording after the first zero.

    Raises
    ------
    InputError
        A bad file, readings of another object, or no zero in the whole file.
    """
    from estimator.recordings.formats.files import read_table

    table = read_table(path)
    require_same_sensors(channels, table.counts, np.array(FACES), str(path))
    time_s = table.time_s if len(table.time_s) else np.full(len(table.counts), np.nan)
    read = 0
    for number, (now_s, counts) in enumerate(zip(time_s.tolist(), table.counts, strict=True)):
        found = reader.feed(counts, now_s)
        if found is not None:
            read += 1
            yield number, now_s, found
    if not read:
        raise InputError(
            f"{path} holds {len(table.counts)} frames, none of them after {zeroing.frames} that give "
            "a zero. Give a longer recording, a smaller --zero-frames or, for signals that are "
            "changes already, --zero none"
        )


def live_frames(
    reader: Reader, channels: tuple[Channel, ...], port: str, baud: int
) -> Iterator[LiveFrame]:
    """What the reader finds in the frames of a board, without end.

    Raises
    ------
    InputError
        A bad port, or readings of another object.
    """
    from estimator.recordings.boards.lines import LineDecoder
    from estimator.recordings.boards.link import board_readings

    decoder = LineDecoder()
    for number, reading in enumerate(board_readings(port, baud, decoder)):
        if number == 0:
            require_same_sensors(channels, reading.counts[None], np.array(FACES), port)
        found = reader.feed(reading.counts, reading.time_s)
        if found is not None:
            line = decoder.statistics
            told = {"damaged_lines": line.damaged_lines, "lost_frames": line.lost_frames}
            yield LiveFrame(number, reading.time_s, found, told)


def prediction_path(name: str, path: Path, out: Path | None) -> Path:
    """Where predictions of a file go; refused before any work where nothing can be written there."""
    if out is not None:
        require_writable(out)
        return run_folder(out, run_name(path)) / name
    if path.parent.is_dir():
        require_writable_folder(path.parent)
    require_regular_file(
        path, f"no recording at {path}. Give the path of a recording or a data set"
    )
    return path.with_name(f"{path.stem}.{name}")


def is_data_set(path: Path) -> bool:
    """Whether a file is a data set of instobj, by what it holds."""
    return path.suffix == ".nc" and holds(path, "press_id")
