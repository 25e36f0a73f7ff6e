"""Contacts of a data set by inversion: the object's twin calibrated, judged on what it has not seen."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from instobj.commands.data_set import DataStage, Results, work_through
from instobj.commands.training import settings_of, simulated_twin, trained_networks
from instobj.store.keys import file_key
from instobj.store.progress import ProgressLine
from instobj.store.readers import INVERSION

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from instobj.stages.makers.inversion import Baselines


def invert_on_data_set(
    path: Path,
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    twin_spec: Path | None,
    on: Path | None = None,
) -> dict[str, Any]:
    """Calibrate the twin of a data set's object on its training presses, and judge its inversion on
    those held out, or on another data set `on` next to simple readings; results go to `runs/<name>`.

    Raises
    ------
    InputError
        No specification, another object than the data set's, or too few places or cases pressed.
    """
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import split_presses
    from estimator.inversion.storage import save_inversion
    from instobj.stages.makers.inversion import write_contact_metrics

    if twin_spec is None:
        raise InputError(
            f"training.model = 'inversion' inverts the model of the object in {path}. Give its "
            "specification with --twin SPEC"
        )
    _, seed = settings_of(overrides)
    frames, progress = load_frames(path), ProgressLine()
    of_inversion = [entry for entry in overrides if entry.strip().startswith("inversion.")]
    twin = simulated_twin(twin_spec, of_inversion, frames)
    inputs = {"data_set": file_key(path), "seed": seed, "twin": twin.inputs}
    split = split_presses(frames, seed)

    def calibrate(folder: Path, _: Results) -> None:
        inversion = twin.inverted(frames.select(split.train), progress.step)
        save_inversion(inversion, INVERSION.path(folder))
        twin.write(folder)

    def judge(folder: Path, made: Results) -> None:
        model = INVERSION.read(made["inversion"].folder)
        held_out = frames.select(split.test)
        write_contact_metrics(model, held_out, "whole presses held out", folder, progress.step)

    judging = DataStage("contact_metrics", "held-out presses", judge)
    if on is not None:
        trained = frames.select(split.train)
        judging = _judged_elsewhere(path, trained, on, twin.spec, overrides, progress)
    networks_of_faces = {
        "networks": DataStage("inversion", f"calibrating on {path}", calibrate),
        "metrics": judging,
    }
    return work_through(path, out, inputs, [networks_of_faces[stage] for stage in stages], progress)


def _judged_elsewhere(
    path: Path,
    trained: FrameSet,
    on: Path,
    spec: ObjectSpec,
    overrides: list[str],
    progress: ProgressLine,
) -> DataStage:
    """Contacts of another data set, next to the networks of the same training presses, matching pursuit
    and the mean of the labels."""
    from estimator.evaluation.contact_baselines import patches, pursued, training_mean
    from estimator.frames.dataset import load_frames
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import force_reference
    from instobj.stages.makers.inversion import write_contact_metrics
    from instobj.stages.makers.twin import require_same_object

    frames = load_frames(on)
    require_same_object(spec, frames)
    kept = [entry for entry in overrides if entry.partition("=")[0].strip() != "training.model"]
    networks = [entry for entry in kept if not entry.strip().startswith("inversion.")]

    def judge(folder: Path, made: Results) -> None:
        model = INVERSION.read(made["inversion"].folder)
        networks_of_faces = [
            (entry, force_reference(face_data(trained, face).heatmap_n).smallest_contact_n)
            for face, entry in trained_networks(path, networks, progress).items()
        ]
        baselines: Baselines = {
            "networks' patches": lambda rows: patches(networks_of_faces, frames, rows),
            "matching pursuit": lambda rows: pursued(model, frames.select(rows)),
            "mean of the training labels": lambda rows: training_mean(trained, len(rows)),
        }
        judged = f"{on}, of which nothing was trained"
        write_contact_metrics(model, frames, judged, folder, progress.step, baselines)

    more = {"on": file_key(on), "networks": networks}
    return DataStage("contact_metrics", f"contacts in {on}", judge, more)
