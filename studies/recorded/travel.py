"""`python -m studies travel`: places read from the field of a pad, and the bound of the place."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec_io import load_spec
from instobj.commands.recorded.validate_travel import recording_of
from instobj.stages.run import Run
from instobj.store.publish import run_folder
from instobj.store.readers import PRESSES

if TYPE_CHECKING:
    from studies.recorded.travel_bound import BoundTest


def travel_of(
    path: Path, folder: Path, repeats: Path | None, out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Readers of the place learnt from the places of a fit and judged on all others; with a recording
    of repeated presses on the same machine, the model's bound against their scatter.

    Also what the residuals point to; they are drawn in `experiments/travel/residuals.png`.
    """
    from estimator.calibration.known_travel.fit import fits_and_judged
    from estimator.calibration.known_travel.model import travel_model
    from studies.recorded.travel_bound import bound_test
    from studies.recorded.travel_places import readers
    from studies.recorded.travel_suspects import (
        draw_residuals,
        other_mechanics,
        ranked_suspects,
        suspect_rows,
    )

    spec = load_spec(path, overrides)
    run = Run(spec)
    model = travel_model(spec, run.read(PRESSES)[1])
    found = fits_and_judged(model, recording_of(spec, folder), spec.seed)
    tables = {
        f"places read, learnt where {name}": [
            {"reader": reader, **asdict(errors)}
            for reader, errors in readers(model, *parts, spec.seed).items()
        ]
        for name, parts in found.items()
    }
    if repeats is not None:
        again = recording_of(spec, repeats)
        tests = {name: bound_test(model, fitted, again) for name, (fitted, *_) in found.items()}
        tables["bound of the place against the scatter of repeats"] = [
            _bound_row(name, test) for name, test in tests.items()
        ]
    others = {
        name: (travel_model(other.spec, other.read(PRESSES)[1]), words)
        for name, (other, words) in other_mechanics(run).items()
    }
    fitted, _, judged = found["registered"]
    suspects = ranked_suspects(model, *found["registered"], others, spec.seed)
    tables["what the residuals point to: one assumption freed, judged on other places"] = (
        suspect_rows(suspects)
    )
    target = run_folder(out, spec.name) / "experiments" / "travel"
    target.mkdir(parents=True, exist_ok=True)
    draw_residuals(spec, model, fitted, judged, suspects, target / "residuals.png")
    return {"command": "travel", "object": spec.name, "tables": tables}


def _bound_row(name: str, test: BoundTest) -> dict[str, Any]:
    return {
        "object": name,
        "places": len(test.bound_mm),
        "median bound mm": float(np.median(test.bound_mm)),
        "median scatter mm": float(np.median(test.scatter_mm)),
        "scatter over bound": test.size_ratio,
        "its spread ×/÷": test.size_spread,
        "rank correlation": test.rank_correlation,
        "null of places exchanged, 95 %": test.null,
        "attainable with these repeats": test.attainable,
    }
