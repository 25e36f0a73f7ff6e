"""Training and evaluation of one network per pressed face, on simulated and recorded data alike."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec.object import TrainingSpec
from instobj.store.content import store_root
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.frames.splits import Split
    from instobj.stages.twin import TwinOfData


def train_networks(
    frames_path: Path,
    training: TrainingSpec,
    seed: int,
    folder: Path,
    step: Step,
    unfinished: Path | None = None,
    start: Path | None = None,
    twin: TwinOfData | None = None,
) -> None:
    """Train each face that the data set presses; writes `face_<n>.safetensors`.

    `unfinished` keeps what an interrupted training has reached, and is gone on from; `start` is a
    folder of estimators to begin with; `twin` adds presses of the object's calibrated twin.

    Raises
    ------
    InputError
        The data set presses no face, or too few presses to split.
    """
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import split_presses

    frames = load_frames(frames_path)
    split = split_presses(frames, seed)
    fit_faces(frames, split, training, seed, folder, step, unfinished, start, twin)
    if twin is not None:
        twin.write(folder)


def fit_faces(
    frames: FrameSet,
    split: Split,
    training: TrainingSpec,
    seed: int,
    folder: Path,
    step: Step,
    unfinished: Path | None = None,
    start: Path | None = None,
    twin: TwinOfData | None = None,
) -> None:
    """Fit an estimator for each face that is pressed; as `train_networks`."""
    import torch

    from estimator.frames.heatmap import faces_pressed
    from estimator.networks.face_model import load_model, save_model
    from estimator.networks.training import FitSettings, fit_estimator

    torch.set_num_threads(1)  # a second thread gains nothing on networks this small
    faces = faces_pressed(frames)
    if not faces:
        raise InputError("the data set holds no contact. Give a data set with presses")
    parts = frames.select(split.train), frames.select(split.validation)
    for face in faces:

        def progress(epoch: int, of: int, score: float, face: int = face) -> None:
            if epoch % 10 == 0 or epoch == of:
                step(f"face {face}, epoch {epoch} of {of}: validation loss {score:.3f}")

        checkpoint = None if unfinished is None else unfinished / f"face_{face}"
        settings = FitSettings(face, training, seed, checkpoint=checkpoint)
        begin = None if start is None else load_model(start / f"face_{face}.safetensors")
        shown = parts if twin is None else twin.extended(parts, face, step)
        model = fit_estimator(*shown, settings, begin, progress)
        save_model(model, folder / f"face_{face}.safetensors")
    if unfinished is not None:
        shutil.rmtree(unfinished, ignore_errors=True)


def unfinished_folder(key: str) -> Path:
    """Where a training that is interrupted can go on from."""
    return store_root() / "unfinished" / key


def evaluate_networks(
    frames_path: Path, networks: Path, seed: int, folder: Path, step: Step
) -> None:
    """The paper's metrics of every face's network on held-out presses; writes `metrics.json`.

    `metrics/held_out.png` shows what each network reads there. The split is that of the training: same
    data set, same seed. Ridge regression and the constant mean map are evaluated beside it on the same
    presses.
    """
    from dataclasses import asdict

    from estimator.evaluation.evaluation import (
        contact_readings,
        evaluate_face,
        evaluate_intervals,
        linear_baseline,
        mean_map_baseline,
    )
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import split_presses
    from estimator.networks.face_model import load_model
    from instobj.figures.predictions import draw_predictions

    frames = load_frames(frames_path)
    split = split_presses(frames, seed)
    held_out = frames.select(split.test)
    readings = []
    rows: dict[str, list[Any]] = {
        name: [] for name in ("faces", "intervals", "ridge_regression", "mean_map")
    }
    for path in sorted(networks.glob("face_*.safetensors")):
        model = load_model(path)
        step(f"face {model.face}")
        rows["faces"].append(evaluate_face(model, held_out, dataset=frames).summary())
        readings.append(contact_readings(model, held_out))
        intervals = asdict(evaluate_intervals(model, held_out))
        rows["intervals"].append({"face": model.face, **intervals})
        rows["ridge_regression"].append(linear_baseline(frames, model.face, split).summary())
        rows["mean_map"].append(mean_map_baseline(frames, model.face, split).summary())
    write_json({"split": "whole presses held out", **rows}, folder / "metrics.json")
    draw_predictions(readings, frames.source, folder / "metrics" / "held_out.png")
