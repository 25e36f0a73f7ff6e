"""Contacts of a data set by inversion: the object's twin calibrated, judged on presses held out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from instobj.commands.training import settings_of
from instobj.store.content import store_root, stored
from instobj.store.keys import file_key
from instobj.store.progress import ProgressLine
from instobj.store.publish import file_rows, publish_to, run_folder, run_name, stage_row
from instobj.store.readers import INVERSION, INVERTED_TWIN, INVERTED_TWIN_PICTURE, PRESSES
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from fem.presses.results import MagnetMotions, PressForces


def invert_on_data_set(
    path: Path, stages: tuple[str, ...], out: Path, overrides: list[str], twin_spec: Path | None
) -> dict[str, Any]:
    """Calibrate the twin of a data set's object on its training presses, and judge its inversion on
    those held out; results go to `runs/<name>`.

    Raises
    ------
    InputError
        No specification, another object than the data set's, or no face with enough places pressed
        one by one.
    """
    from design.spec_io import load_spec
    from estimator.frames.dataset import load_frames
    from estimator.frames.splits import split_presses
    from instobj.report.summary import summarize
    from instobj.stages.makers.inversion import write_contact_metrics
    from instobj.stages.makers.twin import require_same_object, require_some_face
    from instobj.stages.run import Run
    from instobj.stages.table import STAGES

    if twin_spec is None:
        raise InputError(
            f"training.model = 'inversion' inverts the model of the object in {path}. Give its "
            "specification with --twin SPEC"
        )
    _, seed = settings_of(overrides)
    spec = load_spec(twin_spec, [one for one in overrides if one.strip().startswith("inversion.")])
    frames = load_frames(path)
    require_same_object(spec, frames)
    require_some_face(spec, frames)
    run, progress = Run(spec), ProgressLine()
    presses = run.read(PRESSES)
    inputs = {
        "data_set": file_key(path),
        "seed": seed,
        "twin": [run.results[PRESSES.stage].origin, spec.model_dump(mode="json")],
    }
    split = split_presses(frames, seed)
    results = {}

    def calibrate(folder: Path) -> None:
        _calibrate(spec, presses, frames.select(split.train), folder, progress.step)

    def judge(folder: Path) -> None:
        model = INVERSION.read(results["inversion"].folder)
        held_out = frames.select(split.test)
        write_contact_metrics(model, held_out, "whole presses held out", folder, progress.step)

    makers = {"networks": ("inversion", calibrate), "metrics": ("contact_metrics", judge)}
    for name in stages:
        stage, make = makers[name]
        with progress.stage(STAGES[stage].title):
            key = inputs | {"version": STAGES[stage].version}
            results[stage] = stored(store_root(), stage, key, make, progress.say)
    target = run_folder(out, run_name(path))
    files = [file for result in results.values() for file in publish_to(target, result)]
    return {
        "name": run_name(path),
        "stages": [stage_row(result) for result in results.values()],
        "summary": summarize(results),
        "files": file_rows(files),
    }


def _calibrate(
    spec: ObjectSpec,
    presses: tuple[PressForces, MagnetMotions],
    frames: FrameSet,
    folder: Path,
    step: Step,
) -> None:
    """`INVERSION` of the twins of all faces with enough labelled places, and what they leave."""
    from estimator.calibration.digital_twin import calibrate, places_left_out
    from estimator.calibration.inverted_twin import inverted_twin
    from estimator.calibration.pressed_places import pressed_places, within_reach
    from estimator.frames.heatmap import faces_pressed
    from estimator.inversion.storage import save_inversion
    from instobj.figures.calibration import draw_calibration
    from instobj.stages.makers.twin import calibration_row, rms_left

    twins, left, rows = {}, {}, []
    for face in faces_pressed(frames):
        try:
            seen = pressed_places(spec, within_reach(frames, presses[0], face), face)
        except InputError as error:
            rows.append({"face": face, "places": 0, "helps": f"not used: {error}"})
            continue
        step(f"face {face}: calibrating the twin on {len(seen)} locations")
        twins[face] = calibrate(spec, *presses, seen)
        shares = places_left_out(
            spec, *presses, seen, lambda text, f=face: step(f"face {f}: {text}")
        )
        rows.append(calibration_row(twins[face], seen, *shares))
        left[face] = rms_left(shares[0])
    step("tables of presses")
    save_inversion(inverted_twin(spec, *presses, twins, left), INVERSION.path(folder))
    write_json({"object": spec.name, "faces": rows}, INVERTED_TWIN.path(folder))
    judged = [row for row in rows if row["places"]]
    draw_calibration(spec, judged, INVERTED_TWIN_PICTURE.path(folder))
