"""`python -m studies interfaces`: bonded, frictionless and friction at the core, against recorded presses."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from instobj.commands.recorded.validate import not_recorded_texts
from instobj.stages.run import Run
from instobj.store.publish import file_rows, require_writable, run_folder, stage_row
from instobj.store.readers import MESH
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from studies.recorded.interface_fits import InterfaceAgreement, Preference


def interfaces_on(
    path: Path, recordings: list[Path], out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Predict recorded presses with every interface; writes `runs/<name>/interfaces.json`.

    Raises
    ------
    InputError
        A bad specification, recordings of another object, or a core that is no plain box.
    """
    from estimator.calibration.recorded_presses import (
        keep_sensed_faces,
        recorded_presses,
        require_presses_of,
        sensors_not_recorded,
        with_all_sensors,
    )
    from estimator.recordings.reading import read_recording
    from studies.loose_core.response import loose_shell, require_plain_core
    from studies.recorded.interface_fits import INTERFACES, interface_agreement, preference

    spec = load_spec(path, overrides, table=False)
    require_plain_core(spec)
    require_writable(out)
    run = Run(spec)
    with run.progress.stage("reading recordings"):
        read = with_all_sensors(spec, [read_recording(file) for file in recordings])
        presses = keep_sensed_faces(spec, recorded_presses(read))
    require_presses_of(spec, presses)
    absent = sensors_not_recorded(spec, read)
    mesh = run.read(MESH)
    with run.progress.stage("interfaces of shell and core"):
        shell = loose_shell(mesh, spec)
        found = []
        for name, core in INTERFACES.items():
            run.progress.step(name)
            found.append(interface_agreement(spec, shell, presses, name, core))
    preferred = [preference(presses, one, found[0], spec.seed) for one in found[1:]]
    target = run_folder(out, spec.name)
    target.mkdir(parents=True, exist_ok=True)
    document = {
        "object": spec.name,
        "spec_hash": spec_hash(spec),
        "presses": len(presses),
        "sensors_not_recorded": absent,
        "interfaces": [_stored(one) for one in found],
        "preferences": [
            asdict(one) | {"p_corrected": one.corrected_p(len(preferred))} for one in preferred
        ],
    }
    write_json(document, target / "interfaces.json")
    return {
        "command": "interfaces",
        "texts": [
            *not_recorded_texts(absent, presses.signal_counts.shape[1] // 3),
            *(preference_text(one, len(preferred)) for one in preferred),
        ],
        "interfaces": document,
        "objects": [
            {
                "name": spec.name,
                "spec_hash": spec_hash(spec),
                "stages": [stage_row(stage) for stage in run.results.values()],
                "summary": {
                    "interfaces (null: places exchanged)": _rows(spec, found),
                    "against the bonded core (null: places exchanged)": [
                        preference_row(one, len(preferred)) for one in preferred
                    ],
                },
                "files": file_rows([target / "interfaces.json"]),
            }
        ],
    }


def _stored(one: InterfaceAgreement) -> dict[str, Any]:
    return {
        "name": one.name,
        "force_at_2_mm_n": one.force_at_2_mm,
        "travel_mm": one.travel_mm,
        "agreement": [asdict(part) for part in one.agreements],
    }


def _rows(spec: ObjectSpec, found: list[InterfaceAgreement]) -> list[dict[str, Any]]:
    rows = []
    for one in found:
        row: dict[str, Any] = {"interface": one.name}
        for part in one.agreements:
            row[f"{part.what}: cosine"] = round(part.cosine.value, 3)
            row[f"null, p ({part.what})"] = f"{part.cosine.null:.2f}, {part.cosine.p:.2g}"
            if part.what != "all channels":
                row[f"{part.what}: modulus MPa"] = round(part.modulus_mpa, 2)
        row["N per face at 2 mm"] = round(one.force_at_2_mm, 2)
        row["travel mm"] = round(one.travel_mm, 2)
        rows.append(row)
    return rows


def preference_row(one: Preference, tried: int) -> dict[str, Any]:
    return {
        "interface": one.name,
        "cosine gained": round(one.difference, 4),
        "null ±": round(one.null_spread, 4),
        "p, places": round(one.p_places, 4),
        "p, cases": round(one.p_cases, 4),
        "p, corrected": round(one.corrected_p(tried), 4),
        "cases better": f"{one.better} of {one.cases}",
    }


def preference_text(one: Preference, tried: int) -> str:
    """Told on p corrected for the interfaces that were tried."""
    from estimator.calibration.validation import SIGNIFICANCE

    told = "preferred to" if one.difference > 0 else "worse than"
    if one.corrected_p(tried) > SIGNIFICANCE:
        told = "not told from"
    return (
        f"{one.name}: {told} {one.other} (cosine of own faces {one.difference:+.3f}, exchanged places "
        f"±{one.null_spread:.3f}, p {one.p_places:.2g}; better in {one.better} of {one.cases} cases, p "
        f"{one.p_cases:.2g}; corrected for {tried} interfaces {one.corrected_p(tried):.2g})"
    )
