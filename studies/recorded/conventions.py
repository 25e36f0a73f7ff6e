"""`python -m studies conventions`: search for a wrong convention by which a face's recording is read."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec_io import load_spec
from instobj.commands.recorded.validate import not_recorded_texts
from instobj.stages.run import Run
from instobj.store.readers import RESPONSE

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from studies.recorded.convention_search import Found


def conventions_of(
    path: Path, recordings: list[Path], exchanges: int, overrides: list[str]
) -> dict[str, Any]:
    """Search every pressed face's conventions on one recording, judged on the other.

    Raises
    ------
    InputError
        A bad specification, other than two recordings, or recordings of another object.
    """
    from estimator.calibration.recorded_presses import (
        keep_sensed_faces,
        pressed_faces,
        recorded_presses,
        require_presses_of,
        sensors_not_recorded,
        with_all_sensors,
    )
    from estimator.recordings.reading import read_recording
    from studies.recorded.convention_search import CANDIDATES, predicted_changes, search_face

    if len(recordings) != 2:
        raise InputError(
            "conventions are chosen on one recording and judged on another; got "
            f"{len(recordings)}. Give two"
        )
    spec = load_spec(path, overrides, table=False)
    read = with_all_sensors(spec, [read_recording(one) for one in recordings])
    presses = keep_sensed_faces(spec, recorded_presses(read))
    require_presses_of(spec, presses)
    absent = sensors_not_recorded(spec, read)
    run = Run(spec)
    response = run.read(RESPONSE)
    with run.progress.stage("conventions of the recordings"):
        predicted = predicted_changes(spec, response, presses)
    rows = []
    for face in pressed_faces(presses):
        for number, name in enumerate(recordings):
            found = search_face(spec, presses, predicted, face, number, exchanges)
            rows.append({"face": face, "chosen on": name.name} | _row(found))
    searched, fitted = _resting(spec, recordings, exchanges)
    return {
        "command": "conventions",
        "texts": not_recorded_texts(absent, presses.signal_counts.shape[1] // 3),
        "candidates": CANDIDATES,
        "tables": {
            "conventions, chosen on one recording, judged on the other": rows,
            "conventions of the resting levels, all faces together": searched,
            "resting levels left by numbers common to all faces (elsewhere: each face, fitted to the "
            "others; 1: no field)": fitted,
        },
    }


def _resting(
    spec: ObjectSpec, recordings: list[Path], exchanges: int
) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    from estimator.calibration.resting import read_resting
    from studies.recorded.resting_conventions import (
        RestingObject,
        common_fits,
        search_resting,
    )

    faces, designed = len(spec.body.sensed), RestingObject(spec).designed_counts
    searched, fitted = [], []
    for path in recordings:
        levels = read_resting(path, spec).counts
        found = search_resting(designed, levels, faces, exchanges, spec.seed)
        searched.append(
            {
                "recording": path.name,
                "as documented": round(found.documented, 3),
                "p alone": round(found.p_documented, 4),
                "best": round(found.found, 3),
                "of": found.candidates,
                "boards, chips, axes": ", ".join(map(str, found.best)),
                "null of the search": round(found.null_median, 3),
                "p": round(found.p, 4),
            }
        )
        for fit in common_fits(spec, levels, faces):
            strength, depth_mm, *pose = fit.numbers
            fitted.append(
                {
                    "fitted": f"{path.stem}: {fit.name}",
                    "left": round(fit.left, 2),
                    "left elsewhere": round(fit.left_elsewhere, 2),
                    "cosine elsewhere": round(fit.cosine_elsewhere, 2),
                    "strength": round(float(np.exp(strength)), 2),
                    "depth mm": round(depth_mm, 2),
                    "shift mm": round(float(np.linalg.norm(pose[:3])), 2),
                    "turn deg": round(float(np.linalg.norm(pose[3:])), 1),
                }
            )
    return searched, fitted


def _row(found: Found) -> dict[str, Any]:
    symmetry, order, turn = found.candidate
    return {
        "as documented, there": round(found.documented_chosen_on, 3),
        "chosen, there": round(found.chosen_on, 3),
        "as documented, judged": round(found.documented, 3),
        "chosen, judged": round(found.judged, 3),
        "null of the search": round(found.null_median, 3),
        "p": round(found.p, 4),
        "labels, chips, axes": f"{symmetry}, {order}, {turn}",
    }
