"""Exported estimators at work: on a file of readings, or frame by frame on a board's port."""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain, islice
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from design.errors import InputError, RecordingError
from design.tables import write_table
from estimator.deploy.runtime import DeployedModel, LiveReader, load_deployed, predict_with_gaps
from estimator.frames.dataset import FrameSet, load_frames
from estimator.frames.face_data import frames_with_readings
from estimator.frames.same_object import require_same_object
from estimator.inversion.condition import object_condition
from estimator.networks.prediction import NOVEL_FROM, Prediction
from instobj.commands.next_step import next_step
from instobj.commands.readings import (
    FOLLOW_REST,
    LiveFrame,
    Zeroing,
    is_data_set,
    is_trained_on,
    is_unexplained,
    live_frames,
    prediction_path,
    recorded_frames,
    recorded_stream,
    training_frames,
    training_set,
    unexplained_text,
    zeroed_data_set,
)
from instobj.store.publish import (
    OWN_FOLDERS,
    file_rows,
    own_folder_of,
    require_writable_folder,
    run_folder,
)
from instobj.store.readers import INVERSION, face_model_paths

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


def predict_file(
    model_path: Path, path: Path, out: Path = Path(), zeroing: Zeroing = FOLLOW_REST
) -> dict[str, Any]:
    """Read every frame of a file; writes `out/runs/<name>/prediction_face_<n>.csv`, named by `run_name`.

    Models in a folder of their own (`own_folder_of`) name it too: `prediction_twin_face_<n>.csv`.
    Every row has the number of its frame in the file and its time stamp, as the file has it to 1 µs.

    Data sets of instobj are changes against rest already. Recordings of any other format are zeroed
    like a board's readings, by default by following rest; frames before the first zero are left out, and
    so are, counted, frames that lack a reading of a channel which gives readings elsewhere, or have one that
    checks do not believe. Where the file has labels, errors of force and place are given, with those of a
    simple regression where the model's training data set lies in its folder.

    Raises
    ------
    InputError
        A bad model or file, a model of another object, channels that the model uses without
        readings, no zero in the whole file, or a data set to be zeroed again.
    StoreError
        A folder that cannot be written to.
    """
    model = load_deployed(model_path)
    kind = f"{folder}_" if (folder := own_folder_of(model_path)) else ""
    target = prediction_path(f"prediction_{kind}face_{model.face}.csv", path, out)
    texts: list[str] = []
    if is_data_set(path):
        frames = zeroed_data_set(path, zeroing)
        grid_mm = model.grid_x_mm, model.grid_y_mm
        require_same_object(model.channels, grid_mm, frames, str(path))
        readable, prediction = predict_with_gaps(model, frames)
        rows = _rows(np.flatnonzero(readable), frames.time_s[readable], prediction)
        unread, first_frame = int(np.sum(~readable)), 0
    else:
        reader = LiveReader(model, *zeroing.raw_settings)
        stream = recorded_stream(path)
        read, texts = recorded_frames(reader, model.channels, stream, zeroing), stream.texts
        rows = [
            _row(number, time_s, prediction)
            for number, time_s, prediction in read
            if prediction is not None
        ]
        unread = len(read) - len(rows)
        first_frame = read[0][0] if read else 0
    write_table(target, list(COLUMNS), ([row[name] for name in COLUMNS] for row in rows))
    forces, labelled = [row["force_n"] for row in rows], _labelled(path)
    labels = None if labelled is None else _pressed_labels(labelled, model.face, rows)
    summary = {
        "face": model.face,
        "frames": len(rows),
        "frames that lack a reading": unread,
        "frames before a zero": first_frame,
        "frames with contact": sum(row["contact"] > 0.5 for row in rows),
        "novel frames": (novel := sum(row["novelty"] > NOVEL_FROM for row in rows)),
        "condition of the object": str(object_condition(novel / max(len(rows), 1))),
        "largest force N": max(forces, default=0.0),
        "force interval should hold": model.interval_cover,
        **_measured_cover(labels, model.face),
    }
    unexplained, cause = is_unexplained(novel, len(rows)), ""
    training = None if labelled is None else training_set(model_path)
    if unexplained and labelled is not None and training is not None:
        cause = _more_tips_text(training, model.face, labelled)
    texts = [*texts, *unexplained_text(path, novel, len(rows), cause)]
    tables: dict[str, list[dict[str, Any]]] = {f"{path.name}, {model_path.name}": [summary]}
    if labelled is not None and labels is not None and labels.rows:
        faces = (model.face,)
        trained_on = is_trained_on(labelled, training_frames(training, faces), faces)
        judged = [_errors_row(model_path.name, labels, *_read_by(labels.rows))]
        if trained_on:
            texts.append(
                f"{path.name} is what {model_path.name} was trained on: these figures hold for no other "
                "recording"
            )
        elif training is not None:
            judged += _simple_rows(model, training, labelled, labels)
            texts += _simpler_text(judged)
        texts += _novel_text(path, labels)
        rival = " beside simple regressions" if len(judged) > 1 else ""
        tables[f"against the labels of {path.name}{rival}, frames pressed on face {model.face}"] = (
            judged
        )
    return {
        "command": "predict",
        "texts": texts,
        "tables": tables,
        "files": file_rows([target]),
        "next": next_step(
            "predict several tips" if cause else "predict unexplained" if unexplained else "predict"
        ),
    }


def _more_tips_text(training: FrameSet, face: int, frames: FrameSet) -> str:
    """Say that more tips press a face together than in the training of the model; nothing where not."""
    tips, trained_tips = _most_tips(frames, face), _most_tips(training, face)
    if tips < 2 or tips <= trained_tips:
        return ""
    trained = f"up to {trained_tips}" if trained_tips > 1 else "one"
    return (
        f"A likely cause: this recording has up to {_TIPS.get(tips, tips)} tips on face {face}; the network "
        f"was trained on {trained}. It reads one contact a face. Its place error is the distance from the "
        "labelled centre of force of the tips"
    )


_TIPS = {2: "two", 3: "three"}


def _most_tips(frames: FrameSet, face: int) -> int:
    """Return the most contacts that one frame has on a face."""
    return int((frames.contact_face == face).sum(axis=1).max(initial=0))


@dataclass(frozen=True)
class _PressedLabels:
    """Labels of the frames pressed on a face: rows that were read of them, total force, centre of force."""

    rows: list[dict[str, float]]
    force_n: Float[np.ndarray, "row"]
    xy_mm: Float[np.ndarray, "row 2"]

    def held(self, novel: bool | None = None) -> Bool[np.ndarray, "some"]:
        """Return whether each force lies in its interval; of novel frames, of the others, or of all."""
        low_n, high_n = (self.column(name) for name in ("force_low_n", "force_high_n"))
        held = (low_n <= self.force_n) & (self.force_n <= high_n)
        return held if novel is None else held[self.are_novel == novel]

    def widths_n(self, novel: bool) -> Float[np.ndarray, "some"]:
        """Return the widths of the intervals of novel frames, or of the others."""
        widths_n = self.column("force_high_n") - self.column("force_low_n")
        return widths_n[self.are_novel == novel]

    @property
    def are_novel(self) -> Bool[np.ndarray, "row"]:
        return self.column("novelty") > NOVEL_FROM

    def column(self, name: str) -> Float[np.ndarray, "row"]:
        return np.array([row[name] for row in self.rows])


def _pressed_labels(
    frames: FrameSet, face: int, rows: list[dict[str, float]]
) -> _PressedLabels | None:
    """Return the labels of the rows pressed on a face; None where nothing was read."""
    if not rows:
        return None
    number = np.array([row["frame"] for row in rows], int)
    on_face = frames.contact_face[number] == face
    pressed = np.asarray(on_face.any(axis=1)) & frames.valid[number]
    weight_n = np.where(on_face, np.nan_to_num(frames.force_n[number, :, 2]), 0.0)[pressed]
    total_n = weight_n.sum(axis=1)
    places_mm = np.where(on_face[..., None], frames.contact_xy_mm[number], 0.0)[pressed]
    # centre of force: Σ F x / Σ F; a press labelled with no force has no centre
    moment = np.sum(weight_n[..., None] * places_mm, axis=1)
    with np.errstate(invalid="ignore"):
        centre_mm = moment / np.where(total_n > 0, total_n, np.nan)[:, None]
    return _PressedLabels([rows[k] for k in np.flatnonzero(pressed).tolist()], total_n, centre_mm)


def _measured_cover(labels: _PressedLabels | None, face: int) -> dict[str, Any]:
    """Share of the frames pressed on a face whose force lies in its interval, by the file's load cells."""
    if labels is None:
        return {"force interval held": "not known, without load cells"}
    if not labels.rows:
        return {"force interval held": f"not known, no press on face {face}"}
    return {
        "force interval held": round(float(labels.held().mean()), 3),
        "of frames pressed": len(labels.rows),
    }


def _novel_text(path: Path, labels: _PressedLabels) -> list[str]:
    """Say how far intervals held in pressed frames that nothing explains; nothing without such frames."""
    sentences = list[str]()
    for novel, what in (
        (True, "pressed frames that nothing explains"),
        (False, "other pressed frames"),
    ):
        held = labels.held(novel)
        if novel and not len(held):
            return []
        if len(held):
            width_n = np.median(labels.widths_n(novel)) / 2
            sentences.append(
                f"Of {len(held)} {what}, {held.mean():.0%} have the labelled force in their interval (median "
                f"± {width_n:.2g} N)."
            )
    return [f"{path.name}: {' '.join(sentences)} A wide interval holds easily and says little."]


def _simpler_text(judged: list[dict[str, Any]]) -> list[str]:
    """Say that the simple regression reads force better than the network, where it does."""
    title = "force error, median N"
    network_n, *others_n = (row[title] for row in judged)
    if not others_n or network_n <= others_n[0]:
        return []
    return [
        f"A simple regression ({judged[1]['read by']}) reads force better than {judged[0]['read by']} here: "
        f"the median error is {others_n[0]:.3g} instead of {network_n:.3g} N"
    ]


def _read_by(rows: list[dict[str, float]]) -> tuple[np.ndarray, np.ndarray]:
    """Return the forces (N) and places (mm) of rows."""
    force_n = np.array([row["force_n"] for row in rows])
    return force_n, np.array([[row["x_mm"], row["y_mm"]] for row in rows])


def _errors_row(
    name: str, labels: _PressedLabels, force_n: np.ndarray, xy_mm: np.ndarray
) -> dict[str, Any]:
    """Return median and 95th percentile of errors against labels; None where no label has a place."""
    missed_n = np.abs(force_n - labels.force_n)
    away_mm = np.linalg.norm(xy_mm - labels.xy_mm, axis=1)
    away_mm = away_mm[np.isfinite(away_mm)]
    ends: list[float | None] = np.percentile(missed_n, [50, 95]).round(3).tolist()
    ends += np.percentile(away_mm, [50, 95]).round(3).tolist() if len(away_mm) else [None, None]
    titles = ("force error, median N", "95 % below, N", "place error, median mm", "95 % below, mm")
    return {"read by": name, **dict(zip(titles, ends, strict=True)), "frames": len(missed_n)}


def _simple_rows(
    model: DeployedModel, training: FrameSet, frames: FrameSet, labels: _PressedLabels
) -> list[dict[str, Any]]:
    """Return errors of simple regressions that are fitted to the data set of the model, least in force first.

    No row where that does not show the face, and on a robot, which has no libraries to fit with.
    """
    try:
        from estimator.evaluation.baselines import simple_answers
    except ModuleNotFoundError:
        return []
    readable, wide = frames_with_readings(frames, model.channels, model.history_frames)
    number = labels.column("frame").astype(int)
    kept = readable[number]
    if not kept.any():
        return []
    # `wide` holds the complete frames alone: numbers among these
    chosen = (np.cumsum(readable) - 1)[number[kept]]
    judged = _PressedLabels(
        [labels.rows[k] for k in np.flatnonzero(kept).tolist()],
        labels.force_n[kept],
        labels.xy_mm[kept],
    )
    of_model = model.face, model.channels, model.history_frames
    try:
        answers = simple_answers(training, wide.select(chosen), *of_model)
    except InputError:  # the data set in the folder is of another object or face
        return []
    rows = [_errors_row(answer.name, judged, answer.force_n, answer.xy_mm) for answer in answers]
    return sorted(rows, key=lambda row: row["force error, median N"])


def _labelled(path: Path) -> FrameSet | None:
    """Return a file's frames with the forces of its load cells; None where it has none that can be used."""
    from estimator.recordings.formats.files import has_load_cells
    from estimator.recordings.reading import read_recording

    if is_data_set(path):
        return load_frames(path)
    try:
        return read_recording(path).frames if has_load_cells(path) else None
    except (
        RecordingError
    ):  # forces by travel need mechanics, others a press: the signals are read anyway
        return None


def predict_port(
    model_path: Path, port: str, zeroing: Zeroing, count: int | None, baud: int = 115_200
) -> Iterator[str]:
    """One JSON document per frame from a board, `count` of them or without end.

    Each also has how many lines came damaged, how many frames were lost and how many lacked a reading
    since the start.

    Raises
    ------
    InputError
        A bad model or port, a model of another object, or a channel that the model uses without
        readings.
    """
    model = load_deployed(model_path)
    reader = LiveReader(model, *zeroing.raw_settings)
    frames = islice(live_frames(reader, model.channels, port, baud), count)
    return (_document(frame) for frame in frames)


def _document(frame: LiveFrame) -> str:
    novel = {"novel": bool(frame.reading.novel[0])}
    return json.dumps(_row(frame.number, frame.time_s, frame.reading) | novel | frame.line)


def _row(number: int, time_s: float, prediction: Prediction) -> dict[str, float]:
    return _rows(np.array([number]), np.array([time_s]), prediction)[0]


def _rows(number: np.ndarray, time_s: np.ndarray, prediction: Prediction) -> list[dict[str, float]]:
    columns = {
        "frame": number,
        "time_s": time_s,
        "contact": prediction.contact,
        "force_n": prediction.force_n,
        "force_low_n": np.maximum(prediction.force_n - prediction.force_halfwidth_n, 0.0),
        "force_high_n": prediction.force_n + prediction.force_halfwidth_n,
        "x_mm": prediction.xy_mm[:, 0],
        "y_mm": prediction.xy_mm[:, 1],
        "position_radius_mm": prediction.position_radius_mm,
        "novelty": prediction.novelty,
    }
    rounded = [np.round(columns[name], _DIGITS.get(name, 3)).tolist() for name in COLUMNS]
    return [dict(zip(COLUMNS, values, strict=True)) for values in zip(*rounded, strict=True)]


def export_models(models: list[Path], out: Path | None = None) -> dict[str, Any]:
    """Write an ONNX file for each trained estimator, next to it or in `out`; a folder is its estimators,
    with those of the folders of their own in it (`own_folder_of`), which are kept apart in `out` too.

    One that inverts the forward model is what the robot reads already: it is read once, and copied to
    `out`.

    Raises
    ------
    InputError
        A file that is no estimator, a folder without any, or two that would be one file.
    """
    targets = _targets(list(chain.from_iterable(map(_models_at, models))), out)
    for folder in {target.parent for target in targets.values()}:
        require_writable_folder(folder)  # before estimators are loaded, which takes seconds
    for path, target in targets.items():
        _export(path, target)
    document: dict[str, Any] = {"command": "export", "files": file_rows([*targets.values()])}
    first, exported = next(iter(targets.items()))
    if _inverts(first):
        document["next"] = next_step("predict")
    else:
        runs_out = first.parent.parent.parent  # predictions go to the same folder
        is_run = run_folder(runs_out, first.parent.name) == first.parent
        kept = ["--out", str(runs_out)] if is_run and runs_out != Path() else []
        words = ["instobj", "predict", str(exported), "RECORDING", *kept]
        document["texts"] = [f"judge it on another recording of this object: {shlex.join(words)}"]
        document["next"] = next_step("export")
    return document


def _targets(models: list[Path], out: Path | None) -> dict[Path, Path]:
    """Return where each model goes, before any is written."""
    targets: dict[Path, Path] = {}
    for path in models:
        name = path.name if _inverts(path) else f"{path.stem}.onnx"
        target = path.parent / name if out is None else out / own_folder_of(path) / name
        taken = {other_target.resolve(): model for model, other_target in targets.items()}.get(
            target.resolve()
        )
        if taken is not None and taken.resolve() != path.resolve():
            raise InputError(
                f"{taken} and {path} would both become {target}. Leave --out out, or export one at a time "
                "into folders of their own"
            )
        if taken is None:
            targets[path] = target
    return targets


def _export(path: Path, target: Path) -> None:
    from estimator.deploy.export import export_onnx
    from estimator.inversion.storage import load_inversion, save_inversion
    from estimator.networks.face_model import load_model

    if not _inverts(path):
        export_onnx(load_model(path), target)
        return
    model = load_inversion(path)
    if target.resolve() != path.resolve():
        save_inversion(model, target)


def _inverts(path: Path) -> bool:
    from estimator.inversion.storage import is_inversion

    return is_inversion(path)


def _models_at(path: Path) -> list[Path]:
    if not path.is_dir():
        return [path]
    folders = (path, *(path / name for name in OWN_FOLDERS))
    model_paths = [
        model
        for folder in folders
        for model in (*face_model_paths(folder), *folder.glob(INVERSION.name))
    ]
    if not model_paths:
        raise InputError(
            f"{path} holds no trained estimator (face_<n>.safetensors or {INVERSION.name}). Give the "
            "folder that `instobj train` wrote to, or its files"
        )
    return model_paths
