"""`instobj conventions`: search for a wrong convention by which a face's recording is read."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec_io import load_spec
from instobj.stages.run import Run
from instobj.store.readers import RESPONSE

if TYPE_CHECKING:
    from estimator.calibration.conventions import Found


def conventions_of(
    path: Path, recordings: list[Path], exchanges: int, overrides: list[str]
) -> dict[str, Any]:
    """Search every pressed face's conventions on one recording, judged on the other.

    Raises
    ------
    InputError
        A bad specification, other than two recordings, or recordings of another object.
    """
    from estimator.calibration.conventions import CANDIDATES, predicted_changes, search_face
    from estimator.calibration.recorded_presses import (
        on_sensed_faces,
        pressed_faces,
        recorded_presses,
        require_presses_of,
    )
    from estimator.recordings.reading import read_recording

    if len(recordings) != 2:
        raise InputError(
            "conventions are chosen on one recording and judged on another; got "
            f"{len(recordings)}. Give two"
        )
    spec = load_spec(path, overrides, table=False)
    presses = on_sensed_faces(spec, recorded_presses([read_recording(one) for one in recordings]))
    require_presses_of(spec, presses)
    run = Run(spec)
    response = run.read(RESPONSE)
    with run.progress.stage("conventions of the recordings"):
        predicted = predicted_changes(spec, response, presses)
    rows = []
    for face in pressed_faces(presses):
        for number, name in enumerate(recordings):
            found = search_face(spec, presses, predicted, face, number, exchanges)
            rows.append({"face": face, "chosen on": name.name} | _row(found))
    return {
        "command": "conventions",
        "candidates": CANDIDATES,
        "tables": {"conventions, chosen on one recording, judged on the other": rows},
    }


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
