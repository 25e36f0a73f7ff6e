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
    from studies.recorded.travel_replay import SimulatedPresses, replay_recording, replay_row
    from studies.recorded.travel_suspects import (
        draw_residuals,
        other_mechanics,
        ranked_suspects,
        suspect_rows,
    )

    spec = load_spec(path, overrides)
    run = Run(spec)
    presses = run.read(PRESSES)
    model = travel_model(spec, presses[1])
    found = fits_and_judged(model, recording_of(spec, folder), spec.seed)
    tables = {
        f"places read, learnt where {name}": [
            {"reader": reader, **asdict(errors)}
            for reader, errors in readers(model, *parts, spec.seed).items()
        ]
        for name, parts in found.items()
    }
    fitted, _, judged = found["registered"]
    replayed = replay_recording(model, SimulatedPresses(spec, *presses), fitted, judged, spec.seed)
    tables["presses replayed through the simulated object"] = [
        replay_row(f"{spec.name}, registered", replayed)
    ]
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
    suspects = ranked_suspects(model, *found["registered"], others, spec.seed)
    tables["what the residuals point to: one assumption freed, judged on other places"] = (
        suspect_rows(suspects)
    )
    target = run_folder(out, spec.name) / "experiments" / "travel"
    target.mkdir(parents=True, exist_ok=True)
    draw_residuals(spec, model, fitted, judged, suspects, target / "residuals.png")
    return {"command": "travel", "object": spec.name, "tables": tables}


def replay_of_log(
    path: Path, log: Path, statements: list[str], overrides: list[str]
) -> dict[str, Any]:
    """Replay the presses of a log of levels of travel, at the places that the fit of `instobj adopt`
    has not seen. The fit's shift of the magnets is left out: both predictions are of the design."""
    from dataclasses import replace

    from estimator.adoption.fit import SCALES, Moving, fit_object, halves_of_places
    from estimator.adoption.identify import identify
    from estimator.calibration.known_travel.model import travel_model
    from instobj.commands.adopt import read_answers
    from instobj.commands.adopt_fit import pressed_readings
    from studies.recorded.travel_replay import SimulatedPresses, replay_log, replay_row

    spec, answers = load_spec(path, overrides), read_answers(statements)
    presses = Run(spec).read(PRESSES)
    simulated = SimulatedPresses(spec, *presses)
    thing, rows = Moving.from_table(travel_model(spec, presses[1])), []
    for face, pressed in pressed_readings(identify([log], answers), answers, spec).items():
        live = pressed.complete
        half = halves_of_places(live, spec.seed)
        fit = fit_object(thing, live.select(half))
        # the last numbers of SCALES are the shift of the magnets
        design = replace(fit, numbers=fit.numbers * (np.arange(len(SCALES)) < 6))
        replay = replay_log(simulated, design, live.select(~half), spec.seed)
        rows.append(replay_row(f"{spec.name}, face {face}", replay))
    return {
        "command": "travel",
        "object": spec.name,
        "tables": {"presses replayed through the simulated object": rows},
    }


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
