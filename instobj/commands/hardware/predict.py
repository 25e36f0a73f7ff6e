"""Exported estimators at work: on a file of readings, or frame by frame on a board's port."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.tables import write_table
from estimator.deploy.runtime import DeployedModel, LiveReader, load_deployed, predict_frames
from estimator.deploy.zeroing import ZERO_FRAMES, ZeroMode
from estimator.frames.dataset import load_frames
from estimator.frames.same_object import require_same_object, require_same_sensors
from estimator.networks.prediction import NOVEL_FROM, Prediction
from estimator.recordings.table import FACES
from instobj.store.publish import (
    file_rows,
    require_writable,
    require_writable_folder,
    run_folder,
    run_name,
)

if TYPE_CHECKING:
    from estimator.boards.lines import LineStatistics
    from estimator.boards.link import Reading

COLUMNS: tuple[str, ...] = (
    "frame",
    "time_s",
    "contact",
    "force_n",
    "force_low_n",
    "force_high_n",
    "x_mm",
    "y_mm",
    "position_radius_mm",
    "novelty",
)
"""`frame` counts the readings of the file (or port) from 0, those without a prediction included."""
_DIGITS = {"frame": 0, "time_s": 6, "contact": 4}


@dataclass(frozen=True)
class Zeroing:
    """How raw counts become changes against rest (`estimator.deploy.zeroing`); by default they follow
    rest, except those of data sets."""

    mode: ZeroMode | None = None
    frames: int = ZERO_FRAMES

    def reader(self, model: DeployedModel) -> LiveReader:
        """A reader of raw counts."""
        return LiveReader(model, self.mode or "rest", self.frames)


_FOLLOW_REST = Zeroing()


def predict_file(
    model_path: Path, path: Path, out: Path | None = None, zeroing: Zeroing = _FOLLOW_REST
) -> dict[str, Any]:
    """Read every frame of a file; writes `<stem>.prediction_face_<n>.csv` beside it.

    With a folder `out` it is `out/runs/<name>/prediction_face_<n>.csv`, named as `run_name` says.
    Every row tells the number of its frame in the file and its time stamp, as the file has it to 1 µs.

    Data sets of instobj are changes against rest already. Recordings of any other format are zeroed
    like a board's readings, by default by following rest; frames before the first zero are left out.

    Raises
    ------
    InputError
        A bad model or file, a model of another object, channels that the model uses without
        readings, no zero in the whole file, or a data set to be zeroed again.
    StoreError
        A folder that cannot be written to.
    """
    model = load_deployed(model_path)
    target = prediction_path(f"prediction_face_{model.face}.csv", path, out)
    if is_data_set(path):
        if zeroing.mode not in (None, "none"):
            raise InputError(
                f"{path} is a data set, zeroed press by press; got --zero {zeroing.mode}. Leave "
                "--zero out"
            )
        frames = load_frames(path)
        grid_mm = model.grid_x_mm, model.grid_y_mm
        require_same_object(model.channels, grid_mm, frames, str(path))
        rows = _rows(np.arange(len(frames)), frames.time_s, predict_frames(model, frames))
    else:
        rows = list(_read_recording(model, path, zeroing))
    write_table(target, list(COLUMNS), ([row[name] for name in COLUMNS] for row in rows))
    forces = [row["force_n"] for row in rows]
    summary = {
        "face": model.face,
        "frames": len(rows),
        "frames with contact": sum(row["contact"] > 0.5 for row in rows),
        "novel frames": sum(row["novelty"] > NOVEL_FROM for row in rows),
        "largest force N": max(forces, default=0.0),
        "interval cover": model.interval_cover,
    }
    return {
        "command": "predict",
        "tables": {f"{path.name}, {model_path.name}": [summary]},
        "files": file_rows([target]),
    }


def prediction_path(name: str, path: Path, out: Path | None) -> Path:
    """Where predictions of a file go; refused before any work where nothing can be written there."""
    if out is not None:
        require_writable(out)
        return run_folder(out, run_name(path)) / name
    if path.parent.is_dir():
        require_writable_folder(path.parent)
    return path.with_name(f"{path.stem}.{name}")


def predict_port(
    model_path: Path, port: str, zeroing: Zeroing, count: int | None, baud: int = 115_200
) -> Iterator[str]:
    """One JSON document per frame from a board, `count` of them or without end.

    Each also tells how many lines came damaged and how many frames were lost since the start.

    Raises
    ------
    InputError
        A bad model or port, a model of another object, or a channel that the model uses without
        readings.
    """
    from estimator.boards.lines import LineDecoder
    from estimator.boards.link import board_readings

    reader, decoder = zeroing.reader(load_deployed(model_path)), LineDecoder()
    readings = board_readings(port, baud, decoder)
    return islice(_live(reader, readings, decoder.statistics, port), count)


def _live(
    reader: LiveReader, readings: Iterator[Reading], line: LineStatistics, port: str
) -> Iterator[str]:
    for number, reading in enumerate(readings):
        if number == 0:
            require_same_sensors(reader.model.channels, reading.counts[None], np.array(FACES), port)
        found = reader.feed(reading.counts, reading.time_s)
        if found is not None:
            row = _rows(np.array([number]), np.array([reading.time_s]), found)[0]
            told = {"novel": bool(found.novel[0])}
            told |= {"damaged_lines": line.damaged_lines, "lost_frames": line.lost_frames}
            yield json.dumps(row | told)


def is_data_set(path: Path) -> bool:
    """Whether a file is a data set of instobj, by what it holds."""
    import h5py

    if path.suffix != ".nc" or not path.is_file() or not h5py.is_hdf5(path):
        return False
    with h5py.File(path) as file:
        return "press_id" in file


def _read_recording(
    model: DeployedModel, path: Path, zeroing: Zeroing
) -> Iterator[dict[str, float]]:
    from estimator.recordings.files import read_table

    table = read_table(path)
    require_same_sensors(model.channels, table.counts, np.array(FACES), str(path))
    reader, read = zeroing.reader(model), 0
    time_s = table.time_s if len(table.time_s) else np.full(len(table.counts), np.nan)
    for number, (now_s, counts) in enumerate(zip(time_s.tolist(), table.counts, strict=True)):
        found = reader.feed(counts, now_s)
        if found is not None:
            read += 1
            yield _rows(np.array([number]), np.array([now_s]), found)[0]
    if not read:
        raise InputError(
            f"{path} holds {len(table.counts)} frames, none of them after {zeroing.frames} that give "
            "a zero. Give a longer recording, a smaller --zero-frames or, for signals that are "
            "changes already, --zero none"
        )


def _rows(number: np.ndarray, time_s: np.ndarray, found: Prediction) -> list[dict[str, float]]:
    columns = {
        "frame": number,
        "time_s": time_s,
        "contact": found.contact,
        "force_n": found.force_n,
        "force_low_n": np.maximum(found.force_n - found.force_halfwidth_n, 0.0),
        "force_high_n": found.force_n + found.force_halfwidth_n,
        "x_mm": found.xy_mm[:, 0],
        "y_mm": found.xy_mm[:, 1],
        "position_radius_mm": found.position_radius_mm,
        "novelty": found.novelty,
    }
    rounded = [np.round(columns[name], _DIGITS.get(name, 3)).tolist() for name in COLUMNS]
    return [dict(zip(COLUMNS, values, strict=True)) for values in zip(*rounded, strict=True)]


def export_models(models: list[Path], out: Path) -> dict[str, Any]:
    """Write an ONNX file for each trained estimator, in `out` or beside it.

    One that inverts the forward model is what the robot reads already: it is read once, and copied to
    `out`.
    """
    from estimator.deploy.export import export_onnx
    from estimator.inversion.storage import is_inversion
    from estimator.networks.face_model import load_model

    written = []
    for path in models:
        if is_inversion(path):
            written.append(_checked_inversion(path, out))
            continue
        target = (path.parent if out == Path() else out) / f"{path.stem}.onnx"
        export_onnx(load_model(path), target)
        written.append(target)
    return {"command": "export", "files": file_rows(written)}


def _checked_inversion(path: Path, out: Path) -> Path:
    from estimator.inversion.storage import load_inversion, save_inversion

    model = load_inversion(path)
    if out == Path() or out.resolve() == path.parent.resolve():
        return path
    save_inversion(model, out / path.name)
    return out / path.name
