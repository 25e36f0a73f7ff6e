"""Position bound and position error beside maximum likelihood by force.

    python benchmarks/position_error.py [--quick] [--out FOLDER]

121 contact locations of the paper's cube: the 60 with the largest bounds, and others by chance. Noisy frames
of presses there are read by the best of four fits that begin at the stored presses nearest to the frame
(`tests/support/maximum_likelihood.py`). Own channels, fresh baseline, standing still; 8 N, 4 N, and two
sensors per face. The mechanics come from the store, or are made first. Writes `position_error.json`: for
locations of equal error over bound how far reading is off, in bounds and in errors, and how much of that the
draws scatter.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from harness import Result, machine, run

from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.information.scores import PlaceScores, score_places
from estimator.signals.presses import Signals, press_signals
from instobj.stages.run import Run
from instobj.store.readers import PRESSES
from tests.support.maximum_likelihood import FaceReader, simulated_errors_mm

EXAMPLES = Path(__file__).parents[1] / "examples"
CASES: dict[str, dict[str, Any]] = {
    "8 N": {"score": {"force_n": 8.0}},
    "4 N": {"score": {"force_n": 4.0}},
    "8 N, two sensors per face": {"score": {"force_n": 8.0}, "sensors": {"count_per_face": 2}},
}
GROUPS = (0.0, 1.05, 1.2, 1.5, np.inf)
"""Limits of error over bound."""
_PLACES, _DRAWS, _FAR_MM = 121, 600, 10.0


def measure(quick: bool) -> Result:
    """Rows for every case and group of locations; seconds of a whole object's errors and scores."""
    example = "gallery/small_cube.toml" if quick else "paper_cube.toml"
    spec = load_spec(EXAMPLES / example, ["score.channels=own", "limits.use=bench"])
    presses = Run(spec).read(PRESSES)
    draws, rows = 60 if quick else _DRAWS, []
    for name, changes in CASES.items():
        changed = {part: getattr(spec, part).changed(**values) for part, values in changes.items()}
        case = spec.changed(**changed)
        signals = press_signals(case, *presses)
        rows += [{"case": name, **row} for row in _rows(case, signals, draws)]
    about = {"machine": machine(1, ["numpy", "scipy"]), "quick": quick, "draws": draws}
    return {**about, "rows": rows}


def _rows(spec: ObjectSpec, signals: Signals, draws: int) -> list[Result]:
    scores, rng = score_places(spec, signals), np.random.default_rng(spec.seed)
    chosen = _chosen(scores, rng)
    error, bound = scores.position_error_mm[chosen], scores.position_bound_mm[chosen]
    read, scatter = np.zeros(len(error)), np.zeros(len(error))
    far = np.zeros(len(error))
    for index, face in enumerate(scores.faces.tolist()):
        here = np.flatnonzero(chosen[0] == index)
        force = np.full(len(here), spec.score.force_n)
        contact = np.column_stack([scores.grid.xy_mm[chosen[1][here]], force])
        reader = FaceReader(spec, signals, face)
        read[here], scatter[here], distance = simulated_errors_mm(reader, contact, draws, rng)
        far[here] = (distance > _FAR_MM).mean(axis=1)
    rows = []
    for low, high in ((0.0, np.inf), *pairwise(GROUPS)):
        of = (error / bound >= low) & (error / bound < high)
        if of.any():
            rows.append(
                {
                    "error_over_bound": [low, high if np.isfinite(high) else None],
                    "places": int(of.sum()),
                    "read_over_bound": _spread(read[of] / bound[of]),
                    "read_over_error": _spread(read[of] / error[of]),
                    "largest_read_over_bound": round(float((read[of] / bound[of]).max()), 2),
                    "scatter_of_draws": round(float(np.median(scatter[of] / read[of])), 3),
                    "farther_than_10_mm": round(float(far[of].mean()), 4),
                }
            )
    return rows


def _chosen(scores: PlaceScores, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Half of them with the largest bounds, the others by chance."""
    known = scores.judged & np.isfinite(scores.position_bound_mm)
    places = np.argwhere(known)
    order = np.argsort(-scores.position_bound_mm[known])
    some = min(_PLACES, len(places))
    chance = rng.permutation(order[some // 2 :])[: some - some // 2]
    face, place = places[np.concatenate([order[: some // 2], chance])].T
    return face, place


def _spread(ratio: np.ndarray) -> list[float]:
    """Geometric mean, and the factor of one standard deviation."""
    log = np.log(ratio)
    return [round(float(np.exp(value)), 3) for value in (log.mean(), log.std())]


def report(result: Result) -> str:
    """One line for each group of locations."""
    lines = []
    for row in result["rows"]:
        low, high = row["error_over_bound"]
        above = "more" if high is None else f"{high:g}"
        of = f"error over bound {low:g} to {above}" if low or high else "all"
        read = (
            f"read / {what} {ratio:.2f} x/÷ {spread:.2f}"
            for what in ("bound", "error")
            for ratio, spread in [row[f"read_over_{what}"]]
        )
        lines.append(
            f"{row['case']}, {of}, {row['places']} places: {', '.join(read)}, at most "
            f"{row['largest_read_over_bound']:.1f} bounds, {100 * row['farther_than_10_mm']:.1f} % "
            f"of presses > 10 mm off, draws ± {100 * row['scatter_of_draws']:.0f} %"
        )
    return "\n".join(lines)


if __name__ == "__main__":
    run(measure, report)
