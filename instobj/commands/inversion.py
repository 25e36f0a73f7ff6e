"""Contacts of a data set by inversion: the object's twin calibrated, judged on what it has not seen."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.errors import InputError
from instobj.commands.data_set import DataStage, Results, work_through
from instobj.commands.training import settings_of, simulated_twin
from instobj.store.keys import file_key
from instobj.store.progress import ProgressLine
from instobj.store.readers import INVERSION


def invert_on_data_set(
    path: Path,
    stages: tuple[str, ...],
    out: Path,
    overrides: list[str],
    twin_spec: Path | None,
) -> dict[str, Any]:
    """Calibrate the twin of a data set's object on its training presses, and judge its inversion on
    those held out; results go to `runs/<name>`.

    Raises
    ------
    InputError
        No specification, another object than the data set's, or too few places pressed one by one.
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

    stages_by_name = {
        "networks": DataStage("inversion", f"calibrating on {path}", calibrate),
        "metrics": DataStage("contact_metrics", "held-out presses", judge),
    }
    return work_through(path, out, inputs, [stages_by_name[stage] for stage in stages], progress)
