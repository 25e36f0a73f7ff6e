"""Training and evaluation of one network per pressed face, on simulated and recorded data alike."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec.object import ObjectSpec, TrainingSpec
from instobj.store.content import store_root
from instobj.store.readers import HELD_OUT_PICTURE, METRICS, OVER_TIME_PICTURE, face_model_path
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from estimator.frames.dataset import FrameSet
    from estimator.frames.splits import Split
    from estimator.networks.face_model import FaceModel
    from instobj.stages.makers.twin import TwinOfData


@dataclass(frozen=True)
class Fitting:
    """Settings by which estimators are fitted.

    Attributes
    ----------
    seed : of the split, the first weights and the batches
    unfinished : folder that keeps what an interrupted training has reached, and is gone on from
    twin : adds presses of the object's calibrated twin
    spec : of the object, where it is known: its use says what changes after the zero
    """

    training: TrainingSpec
    seed: int
    step: Step
    unfinished: Path | None = None
    twin: TwinOfData | None = None
    spec: ObjectSpec | None = None


def train_networks(frames: FrameSet, split: Split, how: Fitting, folder: Path) -> None:
    """Train an estimator for each face that the data set presses, into a folder of estimators.

    Raises
    ------
    InputError
        The data set presses no face.
    """
    from estimator.frames.heatmap import faces_pressed
    from estimator.networks.face_model import save_model

    faces = faces_pressed(frames)
    if not faces:
        raise InputError("the data set holds no contact. Give a data set with presses")
    parts = frames.select(split.train), frames.select(split.validation)
    for face in faces:
        save_model(_fitted(face, parts, how), face_model_path(folder, face))
    if how.twin is not None:
        how.twin.write(folder)
    if how.unfinished is not None:
        shutil.rmtree(how.unfinished, ignore_errors=True)


def _fitted(face: int, parts: tuple[FrameSet, FrameSet], how: Fitting) -> FaceModel:
    from estimator.networks.defaults import filled
    from estimator.networks.training.face import FitSettings, fit_estimator
    from estimator.signals.nuisances import nuisance_columns

    def progress(epoch: int, of: int, score: float) -> None:
        if epoch % 10 == 0 or epoch == of:
            how.step(f"face {face}, epoch {epoch} of {of}: validation loss {score:.3f}")

    checkpoint = None if how.unfinished is None else how.unfinished / f"face_{face}"
    training = how.training if how.twin is None else filled(how.training)
    nuisances = None
    if how.spec is not None and (columns := nuisance_columns(how.spec)).size:
        shape = (*parts[0].signal_counts.shape[1:], columns.shape[1])
        nuisances = columns.reshape(shape)
    settings = FitSettings(face, training, how.seed, checkpoint=checkpoint, nuisances=nuisances)
    shown = parts if how.twin is None else how.twin.extended(parts, face, how.step)
    return fit_estimator(*shown, settings, progress)


def unfinished_folder(key: str) -> Path:
    """Return where a training that is interrupted can go on from."""
    return store_root() / "unfinished" / key


def evaluate_networks(
    frames: FrameSet, split: Split, models: dict[int, FaceModel], folder: Path, step: Step
) -> None:
    """The paper's metrics of every face's estimator on the held-out presses of its split.

    `HELD_OUT_PICTURE` and `OVER_TIME_PICTURE` show what each network reads there. The regressions of
    `estimator.evaluation.baselines` are evaluated with it on the same presses.
    """
    from dataclasses import asdict

    from estimator.evaluation.baselines import baseline_reports, held_out_answers
    from estimator.evaluation.evaluation import (
        contact_readings,
        evaluate_face,
        evaluate_intervals,
        evaluate_travel,
    )
    from estimator.frames.splits import only_trained_places
    from instobj.figures.predictions import draw_over_time, draw_predictions

    held_out = frames.select(split.test)
    readings, answers = [], []
    rows: dict[str, list[Any]] = {
        name: [] for name in ("faces", "intervals", "baselines", "travel")
    }
    for model in models.values():
        step(f"face {model.face}")
        rows["faces"].append(evaluate_face(model, held_out, dataset=frames).summary())
        readings.append(contact_readings(model, held_out))
        intervals = asdict(evaluate_intervals(model, held_out))
        rows["intervals"].append({"face": model.face, **intervals})
        if frames.travel_mm is not None:
            errors = evaluate_travel(model, held_out, frames)
            rows["travel"].append({"face": model.face, **errors})
        answers.append(held_out_answers(model, frames, split))
        rows["baselines"] += [report.summary() for report in baseline_reports(answers[-1])]
    write_json({"split": "whole presses held out", **rows}, METRICS.path(folder))
    places = "at places of the training" if only_trained_places(frames, split) else "at new places"
    draw_predictions(readings, frames.source, places, HELD_OUT_PICTURE.path(folder))
    draw_over_time(answers, OVER_TIME_PICTURE.path(folder))
