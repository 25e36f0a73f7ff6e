"""Data sets of recordings, and estimators trained on them."""

from __future__ import annotations

from dataclasses import asdict, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import TrainingSpec
from instobj.commands.data_set import (
    DataStage,
    Results,
    stage_key,
    work_through,
)
from instobj.commands.next_step import next_step
from instobj.store.keys import file_key
from instobj.store.progress import ProgressLine
from instobj.store.publish import TWIN, file_rows, require_writable, run_folder
from instobj.store.readers import FRAMES, MODELS, PRESSES, SHEAR, SIGNALS

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.frames.splits import Split
    from estimator.recordings.checks.limits import Limits
    from estimator.recordings.reading import Grid
    from estimator.recordings.travel_labels import TravelForces
    from instobj.stages.makers.twin import TwinOfData

_NO_SPEC = (
    "read without the object's specification: add --spec SPEC.toml to `assess` grasps by networks of it, or "
    "to train with --twin"
)
_TWINS = 10
"""Objects that `train --twin` simulates, within what labelled presses leave possible."""


def read_recordings(files: list[Path], out: Path, spec: Path | None = None) -> dict[str, Any]:
    """Read recordings into one data set, `runs/<stems>/frames.nc`, and say what was found.

    Where `out` is NAME.mcap or NAME.lerobot, one recording is written there as a bag, or as a data set of
    LeRobot, as it is.

    `spec` gives the contact grid, the sensed faces, the chip's range and the size of an object that
    is not the paper's cube.

    Raises
    ------
    InputError
        A file that is no recording, or is given twice, or an invalid specification.
    """
    from estimator.frames.dataset import save_frames
    from estimator.recordings.combine import combine, faults_between
    from estimator.recordings.reading import read_recording

    if out.suffix in (".mcap", ".lerobot"):
        return _converted(files, out)
    require_writable(out)
    progress = ProgressLine()
    grid_mm, limits, recorded_object = (
        (None, None, None) if spec is None else _specified_checks(spec)
    )
    mechanics = None if recorded_object is None else travel_forces(recorded_object)
    recordings = []
    for path in files:
        with progress.stage(f"reading {path}"):
            recordings.append(read_recording(path, grid_mm, limits, mechanics))
    frames = recordings[0].frames if len(recordings) == 1 else combine(recordings)
    frames, absent = (
        (frames, []) if recorded_object is None else models_of_object(frames, recorded_object)
    )
    between = faults_between(recordings)
    target = run_folder(out, "+".join(path.stem for path in files)) / FRAMES.name
    save_frames(frames, target)
    return {
        "command": "recordings",
        "reports": [asdict(recording.report) for recording in recordings],
        "between": [vars(fault) for fault in between],
        "texts": [
            *(str(recording.report) for recording in recordings),
            *map(str, between),
            *absent,
            *([] if spec is not None else [_NO_SPEC]),
        ],
        "files": file_rows([target]),
        "next": _recordings_step(frames, target, out),
    }


def _recordings_step(frames: FrameSet, target: Path, out: Path) -> str:
    """Return the next step: training, or what recordings must hold where they are too few to train on."""
    from estimator.frames.splits import split_presses

    try:
        split_presses(frames, seed=0)
    except InputError:
        return next_step("recordings too few")
    return next_step("recordings", target, out=out)


def _converted(files: list[Path], out: Path) -> dict[str, Any]:
    from estimator.recordings.formats.robot import write_bag, write_lerobot

    if len(files) != 1:
        raise InputError(f"{out} takes one recording; got {len(files)}. Convert one at a time")
    write = write_bag if out.suffix == ".mcap" else write_lerobot
    write(files[0], out)
    return {"command": "recordings", "files": file_rows([out])}


def travel_forces(spec: ObjectSpec) -> TravelForces:
    """Return the mechanics of an object for labels of travel and doubted labels of faces; presses come from
    the store or are made where they are asked for."""
    from estimator.recordings.travel_labels import TravelForces
    from instobj.stages.run import Run

    spread = spec.silicone.relative_spread or (np.nan, np.nan)
    return TravelForces(
        lambda: Run(spec).read(PRESSES)[0], np.array(spread), cache(lambda: Run(spec).read(SIGNALS))
    )


def run_on_data_set(
    path: Path,
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    twin_spec: Path | None = None,
) -> dict[str, Any]:
    """Train (and evaluate) on a data set file; results go to `runs/<name>`.

    Training gets presses of the calibrated twin of the specification `twin_spec`, if given: such
    estimators lie in a folder of their own below it, `twin`.

    Raises
    ------
    InputError
        An override that is not `seed` or below `training`, or a bad data set.
    """
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import only_trained_places, split_presses
    from instobj.report.summary import NETWORKS_TITLE  # loads mechanics
    from instobj.stages.makers.learning import (
        Fitting,
        evaluate_networks,
        train_networks,
        unfinished_folder,
    )

    training, seed = settings_of(overrides)
    frames, progress = load_frames(path), ProgressLine()
    twin = None if twin_spec is None else twin_of_data(twin_spec, frames, training)
    inputs = {
        "data_set": file_key(path),
        "training": training.model_dump(mode="json"),
        "seed": seed,
        "twin": None if twin is None else twin.inputs,
    }
    unfinished = unfinished_folder(stage_key("networks", inputs))
    spec = None if twin is None else twin.spec
    how = Fitting(training, seed, progress.step, unfinished, twin, spec)
    split = split_presses(frames, seed)

    def train(folder: Path, _: Results) -> None:
        train_networks(frames, split, how, folder)

    def evaluate(folder: Path, made: Results) -> None:
        evaluate_networks(
            frames, split, MODELS.read(made["networks"].folder), folder, progress.step
        )

    stages_in_order = (
        DataStage("networks", f"training on {path}", train),
        DataStage("metrics", "held-out presses", evaluate),
    )
    chosen = [stage for stage in stages_in_order if stage.name in (*stages, "networks")]
    folder = "" if twin is None else TWIN
    document = work_through(path, out, inputs, chosen, progress, folder)
    summary = document["summary"]
    if NETWORKS_TITLE in summary and only_trained_places(frames, split):
        summary[NETWORKS_TITLE]["holds for"] = (
            "places that were trained on; at others errors can be tens of times larger "
            "(instobj docs estimators)"
        )
    summary |= {"presses of the data set": data_parts(frames, split)}
    return document


def data_parts(frames: FrameSet, split: Split) -> list[dict[str, Any]]:
    """Return what each part of the split holds; frames that are not used are left out."""
    rows = []
    for use, part in (
        ("training", split.train),
        ("stopping, interval widths", split.validation),
        ("held out: judged above", split.test),
    ):
        pressed = part & frames.valid & (frames.place_id >= 0)
        rows.append(
            {
                "used for": use,
                "presses": len(np.unique(frames.press_id[pressed])),
                "contact cases": len(np.unique(frames.place_id[pressed])),
                "frames pressed": int(pressed.sum()),
                "at rest": int((part & frames.valid).sum() - pressed.sum()),
            }
        )
    return rows


def twin_of_data(path: Path, frames: FrameSet, training: TrainingSpec) -> TwinOfData:
    """Simulated presses of a specification, from the store or made.

    Raises
    ------
    InputError
        Another object than the data set's, settings that presses of a twin do not serve, or no face
        with enough places pressed one by one.
    """
    from instobj.stages.makers.twin import require_settings

    require_settings(training)
    return simulated_twin(path, [], frames, _TWINS)


def simulated_twin(
    path: Path, overrides: list[str], frames: FrameSet, draws: int = 0
) -> TwinOfData:
    """Simulated presses of the specification of a data set's object; raises as `twin_of_data`."""
    from design.spec_io import load_spec
    from estimator.information.shear import shear_signals
    from instobj.stages.makers.twin import TwinOfData, require_same_object, require_some_face
    from instobj.stages.run import Run

    spec = load_spec(path, overrides)
    require_same_object(spec, frames)
    require_some_face(spec, frames)
    run = Run(spec)
    presses, shear = run.read(PRESSES), None
    if spec.inversion.tangential_share:
        shear = shear_signals(spec, presses[1], run.read(SHEAR))
    return TwinOfData(spec, presses, run.results[PRESSES.stage].origin, draws, shear)


def models_of_object(frames: FrameSet, spec: ObjectSpec) -> tuple[FrameSet, list[str]]:
    """Frames with the faces and sensors of an object, and what is said of sensors that they lack.

    Raises
    ------
    InputError
        Readings of sensors, or presses of faces, that it does not have.
    """
    from estimator.frames.dataset import NO_FACE

    frames, count = frames.select_faces(spec.body.sensed), spec.sensors.count_per_face
    pressed = set(np.unique(frames.contact_face).tolist()) - {NO_FACE}
    if pressed and not pressed & set(spec.body.sensed):
        raise InputError(
            f"labels say that face {min(pressed)} is pressed; {spec.name} senses {list(spec.body.sensed)}. "
            "Fix the labels' face, or give the specification of the object that was recorded"
        )
    sensors = frames.signal_counts.shape[2]
    if np.isfinite(frames.signal_counts[:, :, count:]).any():
        raise InputError(
            f"the recording has readings of {sensors} sensors on a face; {spec.name} has {count}. Give the "
            "specification of the object that was recorded"
        )
    room = ((0, 0), (0, 0), (0, max(0, count - sensors)), (0, 0))
    signals = np.pad(frames.signal_counts[:, :, :count], room, constant_values=np.nan)
    said = [
        f"dead sensor: sensor {number} of every face: {spec.name} has it, the recording has no column "
        "of it; taken as without readings"
        for number in range(sensors + 1, count + 1)
    ]
    read = frames.faces[np.isfinite(signals).any(axis=(0, 2, 3))].tolist()
    silent = [face for face in spec.body.sensed if face not in read]
    if silent:
        said.append(
            f"dead faces: faces {silent}: {spec.name} senses them, the recording has no reading of them"
        )
    return replace(frames, signal_counts=signals), said


def _specified_checks(path: Path) -> tuple[Grid, Limits, ObjectSpec]:
    """Contact grid and limits of an object, and the object."""
    from design.layout.places.contact_grid import contact_grid
    from design.spec_io import load_spec
    from estimator.recordings.checks.limits import Limits
    from estimator.signals.hall import full_scale_counts

    spec = load_spec(path, [])
    grid = contact_grid(spec)
    limits = Limits(full_scale_counts(spec.sensors) + 1, max(spec.body.size_mm) / 2)
    return (grid.x_mm, grid.y_mm), limits, spec


def settings_of(overrides: list[str]) -> tuple[TrainingSpec, int]:
    """Training and seed that a data set is given on the command line.

    Raises
    ------
    InputError
        Overrides of the object, which only its specification has.
    """
    from design.spec_io import parse_spec, with_overrides

    for override in overrides:
        key = override.partition("=")[0].strip()
        if key != "seed" and not key.startswith(("training.", "inversion.")):
            raise InputError(
                f"--set {override}: a data set takes only seed, training.* and inversion.* settings. "
                "Give the specification instead of the data set to change the object"
            )
    content = {"name": "data-set", "training": {"model": "compact"}}
    spec = parse_spec(with_overrides(content, overrides), "--set")
    return spec.training, spec.seed
