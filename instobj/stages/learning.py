"""Training and evaluation of one network per pressed face, on simulated and recorded data alike."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec.object import TrainingSpec
from instobj.store.content import content_key, file_key, store_root, stored
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.frames.splits import Split
    from instobj.stages.twin import TwinOfData

_VERSION = 7


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

    The split is that of the training: same data set, same seed. Ridge regression and the constant
    mean map are evaluated beside it on the same presses.
    """
    from dataclasses import asdict

    from estimator.evaluation.evaluation import (
        evaluate_face,
        evaluate_intervals,
        linear_baseline,
        mean_map_baseline,
    )
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import split_presses
    from estimator.networks.face_model import load_model

    frames = load_frames(frames_path)
    split = split_presses(frames, seed)
    held_out = frames.select(split.test)
    rows: dict[str, list[Any]] = {
        name: [] for name in ("faces", "intervals", "ridge_regression", "mean_map")
    }
    for path in sorted(networks.glob("face_*.safetensors")):
        model = load_model(path)
        step(f"face {model.face}")
        rows["faces"].append(evaluate_face(model, held_out, dataset=frames).summary())
        intervals = asdict(evaluate_intervals(model, held_out))
        rows["intervals"].append({"face": model.face, **intervals})
        rows["ridge_regression"].append(linear_baseline(frames, model.face, split).summary())
        rows["mean_map"].append(mean_map_baseline(frames, model.face, split).summary())
    write_json({"split": "whole presses held out", **rows}, folder / "metrics.json")


def run_on_data_set(
    path: Path,
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    start: Path | None = None,
    twin_spec: Path | None = None,
) -> dict[str, Any]:
    """Train (and evaluate) on a data set file; results go to `runs/<name>`.

    Training goes on from the estimators in the folder `start`, if given, and gets presses of the
    calibrated twin of the specification `twin_spec`, if given.

    Raises
    ------
    InputError
        An override that is not `seed` or below `training`, or a bad data set.
    """
    from estimator.frames.dataset import load_frames
    from instobj.report.summary import summarize
    from instobj.stages.twin import twin_of_data
    from instobj.store.progress import ProgressLine
    from instobj.store.publish import file_rows, publish_to, run_folder, stage_row

    training, seed = _settings(overrides)
    frames = load_frames(path)
    name = path.parent.name if path.stem == "frames" else path.stem
    progress = ProgressLine()
    twin = None if twin_spec is None else twin_of_data(twin_spec, frames, training)
    inputs = {
        "data_set": file_key(path),
        "training": training.model_dump(mode="json"),
        "seed": seed,
        "start": None if start is None else _keys_of_models(start),
        "twin": None if twin is None else [twin.key, twin.spec.model_dump(mode="json")],
        "version": _VERSION,
    }
    unfinished = unfinished_folder(content_key(inputs))
    results = {}
    with progress.stage(f"training on {path}"):
        results["networks"] = stored(
            store_root(),
            "networks",
            inputs,
            lambda folder: train_networks(
                path, training, seed, folder, progress.step, unfinished, start, twin
            ),
        )
    if "metrics" in stages:
        networks = results["networks"].folder
        with progress.stage("held-out presses"):
            results["metrics"] = stored(
                store_root(),
                "metrics",
                inputs,
                lambda folder: evaluate_networks(path, networks, seed, folder, progress.step),
            )
    target = run_folder(out, name)
    files = [file for result in results.values() for file in publish_to(target, result)]
    return {
        "name": name,
        "stages": [stage_row(result) for result in results.values()],
        "summary": summarize(results),
        "files": file_rows(files),
    }


def _keys_of_models(folder: Path) -> dict[str, str]:
    paths = sorted(folder.glob("face_*.safetensors"))
    if not paths:
        raise InputError(
            f"{folder} holds no face_<n>.safetensors to start from. Give the folder that `instobj "
            "pretrain` or `instobj train` wrote"
        )
    return {path.name: file_key(path) for path in paths}


def _settings(overrides: list[str]) -> tuple[TrainingSpec, int]:
    from design.spec_io import parse_spec, with_overrides

    for override in overrides:
        key = override.partition("=")[0].strip()
        if key != "seed" and not key.startswith("training."):
            raise InputError(
                f"--set {override}: a data set takes only seed and training.* settings. Give the "
                "specification instead of the data set to change the object"
            )
    spec = parse_spec(with_overrides({"name": "data-set"}, overrides), "--set")
    return spec.training, spec.seed
