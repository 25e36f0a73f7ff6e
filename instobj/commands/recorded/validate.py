"""`instobj bench selftest` and `instobj validate`: a specification against its built object."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from instobj.commands.recorded.validate_travel import validate_on_travel
from instobj.stages.run import Run
from instobj.store.progress import ProgressLine
from instobj.store.publish import object_row, require_writable, run_folder
from instobj.store.readers import PRESSES
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from estimator.calibration.recorded_presses import PredictedMotions, RecordedPresses
    from estimator.calibration.validation import Agreement, Predictions
    from estimator.tolerances.selftest import SelfTest

_NO_MODULUS = "labelled by travel: the ratio of moduli found tells nothing about the silicone"


def self_test_of(path: Path, resting: Path, overrides: list[str]) -> dict[str, Any]:
    """The likeliest faults behind resting signals, and what to write into `as_built`."""
    from estimator.calibration.resting import read_resting
    from estimator.tolerances.selftest import rest_model, self_test
    from instobj.commands.training import travel_forces

    spec = load_spec(path, overrides)
    rest = read_resting(resting, spec, travel_forces(spec))
    progress = ProgressLine()
    with progress.stage("self-test"):
        progress.step("resting signals of objects within tolerance")
        model = rest_model(spec, spec.sensors.drift_counts)
        progress.step("hypotheses")
        result = self_test(spec, model, rest.counts)
    hypotheses = [
        {"hypothesis": h.name, "log odds": h.log_odds, "fit": h.fit} for h in result.hypotheses
    ]
    return {
        "command": "selftest",
        "spec_hash": spec_hash(spec),
        "frames": rest.frames,
        "silent": rest.silent,
        "hypotheses": hypotheses,
        "believed": result.believed,
        "false_alarm_rate": result.false_alarm_rate,
        "healthy_objects": result.healthy_objects,
        "texts": [*_silent_texts(rest.silent), *_self_test_texts(result)],
        "passed": result.believed and not result.best.faults and not rest.silent,
    }


def _silent_texts(silent: dict[str, str]) -> list[str]:
    return [f"{name} says nothing: {why}" for name, why in silent.items()]


def _self_test_texts(result: SelfTest) -> list[str]:
    best, others = result.best, result.hypotheses[1:4]
    lines = [
        f"likeliest: {best.name} (log odds against 'as specified' {best.log_odds:.1f}; an object within "
        f"tolerance lies as far off with probability {best.fit:.2g})",
        *(f"  then: {h.name} ({h.log_odds:.1f})" for h in others),
        f"false alarms: {100 * result.false_alarm_rate:.1f} % of {result.healthy_objects} simulated "
        "objects within tolerance",
    ]
    if not result.believed:
        lines.append(
            "NOT BELIEVED: no fault that is looked for brings the resting signals within the "
            "tolerances. Measure the assembly (as_built), or widen the specification's tolerances to "
            "what is true"
        )
    return lines


def validate_on(
    path: Path, recordings: list[Path], out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Predicted against recorded presses, each figure with its permutation null.

    Results go to `runs/<name>/validation.{json,png}`.
    """
    from estimator.calibration.recorded_presses import (
        keep_sensed_faces,
        recorded_presses,
        require_presses_of,
        sensors_not_recorded,
        with_all_sensors,
    )
    from estimator.recordings.formats.travel import is_travel_recording
    from estimator.recordings.reading import read_recording
    from instobj.commands.training import travel_forces

    if any(is_travel_recording(file) for file in recordings):
        if len(recordings) > 1:
            raise InputError(
                f"of presses of known travel one recording is validated; got {len(recordings)}. Give one "
                "folder"
            )
        return validate_on_travel(path, recordings[0], out, overrides)
    folder = next((file for file in recordings if file.is_dir()), None)
    if folder is not None:
        raise InputError(
            f"{folder} is a folder without sensor.csv and states.csv. Give a recording's file, or a "
            "folder that holds both (presses of known travel)"
        )
    spec = load_spec(path, overrides)
    require_writable(out)
    run = Run(spec)
    with run.progress.stage("reading recordings"):
        mechanics = travel_forces(spec)
        read = [read_recording(file, mechanics=mechanics) for file in recordings]
        read = with_all_sensors(spec, read)
        presses = keep_sensed_faces(spec, recorded_presses(read))
    require_presses_of(spec, presses)
    absent = sensors_not_recorded(spec, read)
    moving, agreements, predictions = _compare(run, presses)
    document = _document(spec, presses, moving, agreements, predictions)
    document["sensors_not_recorded"] = absent
    document["labelled_by_travel"] = any(
        recording.frames.travel_mm is not None for recording in read
    )
    target = run_folder(out, spec.name)
    target.mkdir(parents=True, exist_ok=True)
    write_json(document, target / "validation.json")
    return _published(spec, run, presses, predictions, document, target)


def _compare(
    run: Run, presses: RecordedPresses
) -> tuple[PredictedMotions, list[Agreement], Predictions]:
    from estimator.calibration.recorded_presses import predicted_motions, pressed_faces
    from estimator.calibration.validation import agreement, predict
    from estimator.field.models import magnets_model
    from estimator.signals.field_setup import min_distance_mm
    from estimator.signals.press_states import rest_motion
    from estimator.tolerances.assembly import designed

    spec = run.spec
    forces, motions = run.read(PRESSES)
    design, rest = designed(spec), rest_motion(motions)
    nearest = min_distance_mm(design.scene, motions.all_motions)
    model = magnets_model(spec.magnets, nearest)
    moving = predicted_motions(forces, motions, presses)
    predictions = predict(spec, design, moving, rest, model)
    faces = pressed_faces(presses)
    agreements = [agreement(spec, presses, predictions, face, spec.seed) for face in (*faces, None)]
    return moving, agreements, predictions


def _document(
    spec: ObjectSpec,
    presses: RecordedPresses,
    moving: PredictedMotions,
    agreements: list[Agreement],
    predictions: Predictions,
) -> dict[str, Any]:
    from estimator.calibration.resting import channel_names
    from estimator.calibration.validation import channel_rows, verdict

    return {
        "object": spec.name,
        "spec_hash": spec_hash(spec),
        "presses": len(presses),
        "cases": [[list(contact) for contact in case] for case in presses.cases],
        "youngs_modulus_mpa": spec.silicone.youngs_modulus_mpa,
        "share_beyond_deepest_press": _share_beyond(presses, moving),
        "agreement": [asdict(agreement) for agreement in agreements],
        "verdicts": [verdict(spec, agreement) for agreement in agreements],
        "channels": channel_rows(presses, predictions, channel_names(spec)),
    }


def _share_beyond(presses: RecordedPresses, moving: PredictedMotions) -> float:
    """Share of presses whose force exceeds the deepest simulated press at the specification's E."""
    from estimator.calibration.recorded_presses import MODULUS_RATIOS

    beyond = moving.beyond[np.arange(len(presses)), presses.case]
    return float(beyond[:, np.argmin(abs(np.log(MODULUS_RATIOS)))].mean())


def _published(
    spec: ObjectSpec,
    run: Run,
    presses: RecordedPresses,
    predictions: Predictions,
    document: dict[str, Any],
    target: Path,
) -> dict[str, Any]:
    from instobj.figures.validation import draw_validation

    figure = target / "validation.png"
    draw_validation(spec, presses, predictions, document, figure)
    summary = {
        f"predicted against recorded, {document['presses']} presses of "
        f"{len(document['cases'])} sets of places (null: places exchanged)": agreement_rows(
            document
        ),
    }
    files = [target / "validation.json", figure]
    return {
        "command": "validate",
        "texts": [
            *[_NO_MODULUS] * document["labelled_by_travel"],
            *not_recorded_texts(document["sensors_not_recorded"], len(sensor_layout(spec).face)),
            *document["verdicts"],
        ],
        "validation": json.loads(json.dumps(document)),
        "objects": [object_row(spec, run.results.values(), summary, files)],
    }


def not_recorded_texts(absent: list[tuple[int, int]], sensors: int) -> list[str]:
    """Return which sensors (face, number) the figures leave out; nothing where all were recorded."""
    if not absent:
        return []
    named = ", ".join(f"{number} of face {face}" for face, number in absent)
    return [
        f"not recorded, and left out of all figures: sensor{'s' * (len(absent) > 1)} {named}; judged on the "
        f"other {sensors - len(absent)} of {sensors}"
    ]


def agreement_rows(document: dict[str, Any]) -> list[dict[str, Any]]:
    """One row per figure of merit and set of channels: value, null, p."""
    rows = []
    for agreement in document["agreement"]:
        for title, key in (
            ("cosine", "cosine"),
            ("signs right", "signs"),
            ("scatter of size ×/÷", "size_spread"),
            ("scatter of modulus ×/÷", "modulus_spread"),
        ):
            rows.append({"channels": agreement["what"], "figure": title, **agreement[key]})
        for title, key in (
            ("recorded / predicted size", "size_ratio"),
            ("effective modulus MPa", "modulus_mpa"),
        ):
            rows.append(
                {
                    "channels": agreement["what"],
                    "figure": title,
                    "value": agreement[key],
                    **dict.fromkeys(("null", "p", "exchanges")),
                }
            )
    return rows
