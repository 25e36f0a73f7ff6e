"""`instobj validate` on presses of known travel: predicted against recorded field over a whole pad."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from instobj.stages.run import Run
from instobj.store.publish import object_row, require_writable, run_folder
from instobj.store.readers import PRESSES
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from estimator.calibration.known_travel.agreement import TravelAgreement
    from estimator.calibration.known_travel.fit import Fitted
    from estimator.recordings.formats.travel import TravelRecording

EXCHANGES = 19
"""Permutations of the null: 1 of 20 is the p that judgements ask for."""


def validate_on_travel(path: Path, folder: Path, out: Path, overrides: list[str]) -> dict[str, Any]:
    """Registered on 5 % and calibrated on 10 % of the places, judged on all others.

    Results go to `runs/<name>/travel.{json,png}`.
    """
    from estimator.calibration.known_travel.agreement import travel_agreement
    from estimator.calibration.known_travel.fit import fits_and_judged
    from estimator.calibration.known_travel.model import require_comparable, travel_model
    from instobj.figures.travel import draw_travel

    spec = load_spec(path, overrides)
    require_comparable(spec)
    require_writable(out)
    run = Run(spec)
    with run.progress.stage("reading the recording"):
        recording = recording_of(spec, folder)
    model = travel_model(spec, run.read(PRESSES)[1])
    with run.progress.stage("registration, calibration, nulls"):
        judged = fits_and_judged(model, recording, spec.seed)
        agreements = {
            name: travel_agreement(model, *parts, EXCHANGES, seed=spec.seed)
            for name, parts in judged.items()
        }
    fits = {name: fit for name, (fit, *_) in judged.items()}
    document = _document(spec, folder, agreements, fits)
    target = run_folder(out, spec.name)
    target.mkdir(parents=True, exist_ok=True)
    write_json(document, target / "travel.json")
    draw_travel(spec, model, fits["registered"], recording, document, target / "travel.png")
    return _published(spec, run, document, target)


def recording_of(spec: ObjectSpec, folder: Path) -> TravelRecording:
    """The presses of a folder, of as many chips as the object has.

    Raises
    ------
    InputError
        Another number of chips, or a damaged recording.
    """
    from estimator.recordings.formats.travel import read_travel

    recording = read_travel(folder)
    sensors = recording.field_mt.shape[1]
    if sensors != spec.sensors.count_per_face:
        raise InputError(
            f"{folder} holds {sensors} chips; {spec.name} has {spec.sensors.count_per_face} on its "
            "face. Validate the specification of the recorded object"
        )
    return recording


def _document(
    spec: ObjectSpec,
    folder: Path,
    agreements: dict[str, TravelAgreement],
    fits: dict[str, Fitted],
) -> dict[str, Any]:
    return {
        "object": spec.name,
        "spec_hash": spec_hash(spec),
        "recording": folder.name,
        "fits": {
            name: {
                "twin": {
                    "shift_mm": fitted.twin.pose.shift_mm.tolist(),
                    "turn_rad": fitted.twin.pose.turn_rad,
                    "contact_mm": fitted.twin.pose.contact_mm,
                    "symmetry": fitted.twin.pose.symmetry,
                    "magnet_mm": fitted.twin.magnet_mm.tolist(),
                    "tilt_rad": fitted.twin.tilt_rad.tolist(),
                    "strength": fitted.twin.strength,
                },
                "resting_mt": fitted.resting_mt.tolist(),
                "left_mt": fitted.left_mt,
            }
            for name, fitted in fits.items()
        },
        "agreement": {name: judged.summary() for name, judged in agreements.items()},
    }


def _published(
    spec: ObjectSpec, run: Run, document: dict[str, Any], target: Path
) -> dict[str, Any]:
    agreement = document["agreement"]
    tables = {
        f"{name}, judged on all other places": agreement_rows(judged)
        for name, judged in agreement.items()
    }
    files = [target / "travel.json", target / "travel.png"]
    return {
        "command": "validate",
        "texts": [_text(name, judged) for name, judged in agreement.items()],
        "validation": json.loads(json.dumps(document)),
        "objects": [object_row(spec, run.results.values(), tables, files)],
    }


def _text(name: str, judged: dict[str, Any]) -> str:
    null = judged["nulls, median and best"]["places exchanged"]
    whole = judged["all"]
    return (
        f"{name}: median cosine {whole['cosine']:.3f} (places exchanged {null['cosine'][0]:.3f}), "
        f"{100 * whole['explained']:.0f} % of the change explained ({100 * null['explained'][0]:.0f} %), "
        f"{100 * whole['between']:.0f} % of what differs between presses "
        f"({100 * null['between'][0]:.0f} %); order of chips number {judged['order of chips']}"
    )


def agreement_rows(judged: dict[str, Any]) -> list[dict[str, Any]]:
    """One row a group of presses, rival or null."""
    beyond = next(key for key in judged if key.startswith("beyond"))
    rows = [{"presses of": "all", **judged["all"]}, {"presses of": beyond, **judged[beyond]}]
    rows += [{"presses of": name, **figures} for name, figures in judged["by travel"].items()]
    rows += [{"presses of": name, **figures} for name, figures in judged["rivals"].items()]
    for name, null in judged["nulls, median and best"].items():
        for place, which in enumerate(("median", "best")):
            rows.append(
                {
                    "presses of": f"{name} ({which})",
                    "presses": judged["all"]["presses"],
                    **{figure: values[place] for figure, values in null.items()},
                    "size": None,
                }
            )
    return rows
