"""Table, figure and page of a sweep."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from design.spec.object import ObjectSpec
from design.tables import write_table
from instobj.commands.compare import comparison_row
from instobj.figures.saving import save_figure
from instobj.report.pages import write_page
from instobj.store.content import StoredResult, find
from instobj.store.publish import publish_to, run_folder
from instobj.store.readers import FRAMES, METRICS, SCORES
from instobj.store.shared import URL
from instobj.sweep.study import Study, Variant

SHOWN = {
    "weakest place mm": "position bound,\nweakest (mm)",
    "place mm": "position bound,\nmedian (mm)",
    "detect N": "detectable force,\nmedian (N)",
    "read place mm": "error of place,\nestimator (mm)",
    "read force %": "error of force,\nestimator (%)",
}
"""Scores that the figure draws against every changed key, where there are any, and their axes' names."""
BEST = "weakest place mm"
"""Score by which the page names the best specification."""


def variant_row(
    variant: Variant, outcomes: dict[str, dict[str, Any]], root: Path, out: Path
) -> dict[str, Any]:
    """Return what was changed and what came of it: numbers of every stage, or an error.

    Frames and estimators are copied to `runs/<object>` below `out`.
    """
    row: dict[str, Any] = {"object": variant.label, **variant.changes}
    if variant.spec is None:
        return row | {"error": variant.refused}
    for stage, outcome in outcomes.items():
        if outcome["error"]:
            return row | {"error": outcome["error"]}
        result = find(root, stage, outcome["key"])
        if result is None:
            return row | {
                "error": f"a worker made its {stage}, which are not in {root}. Give all machines one "
                f"store: the same folder, or {URL}"
            }
        row |= _numbers(variant.spec, result)
        if stage != SCORES.stage:
            publish_to(run_folder(out, variant.label), result)
    return row


def _numbers(spec: ObjectSpec, result: StoredResult) -> dict[str, Any]:
    if result.stage == SCORES.stage:
        return comparison_row(spec, SCORES.read(result.folder))
    if result.stage == METRICS.stage:
        return _estimators(METRICS.read(result.folder))
    return {"frames": len(FRAMES.read(result.folder))}


def _estimators(metrics: dict[str, Any]) -> dict[str, Any]:
    """Means over the faces, on held-out presses, compared with the best of the simple regressions."""
    means = {}
    for unit, name in (("force %", "total_force_percent"), ("place mm", "place_mm")):
        rows = [row for row in metrics["baselines"] if row[name] is not None]
        model = {row["face"]: row[name] for row in rows if row["name"] == "model"}
        simple = [
            min(row[name] for row in rows if row["face"] == face and row["name"] != "model")
            for face in model
        ]
        means[f"read {unit}"] = float(np.mean([*model.values()]))
        means[f"best simple {unit}"] = float(np.mean(simple))
    covered = [row["position_cover"] for row in metrics["intervals"]]
    return means | {"places in 90 % region %": round(100 * float(np.mean(covered)), 1)}


def write_outcome(study: Study, rows: Sequence[dict[str, Any]], folder: Path) -> list[Path]:
    """Write `sweep.csv`, `sweep.png` where a number was changed, and `sweep.html`."""
    header = list({name: None for row in rows for name in row})
    write_table(
        folder / "sweep.csv", header, ([row.get(name, "") for name in header] for row in rows)
    )
    drawn = draw_sweep(study, rows, folder / "sweep.png")
    made = [row for row in rows if "error" not in row]
    write_page(
        folder / "sweep.html",
        "sweep.html.j2",
        name=study.name,
        stages=study.stages,
        keys=study.keys,
        rows=rows,
        made=len(made),
        count=len(rows),
        best=min((row for row in made if BEST in row), key=lambda row: row[BEST], default=None),
        picture_path=folder / "sweep.png" if drawn else None,
    )
    names = ("sweep.html", "sweep.csv", *(["sweep.png"] if drawn else []))
    return [folder / name for name in names]


def draw_sweep(study: Study, rows: Sequence[dict[str, Any]], path: Path) -> bool:
    """One panel for every score and every key whose values are numbers; False where there is none."""
    from matplotlib.figure import Figure

    made = [row for row in rows if "error" not in row]
    keys = [key for key in study.keys if all(_is_number(row.get(key)) for row in made)]
    shown = [score for score in SHOWN if made and all(score in row for row in made)]
    if not keys or not shown:
        return False
    size = (1 + 2.9 * len(keys), 2.4 * len(shown))
    figure = Figure(figsize=size, layout="constrained")
    panels = figure.subplots(len(shown), len(keys), squeeze=False, sharex="col", sharey="row")
    for panel_row, score in zip(panels, shown, strict=True):
        for axes, key in zip(panel_row, keys, strict=True):
            x, y = (np.array([row[name] for row in made], dtype=float) for name in (key, score))
            axes.plot(x, y, "o", ms=4, color="#31688e", alpha=0.7)
            axes.grid(alpha=0.3)
            axes.set_ylim(0, 1.1 * y[np.isfinite(y)].max(initial=0.0) or 1)
        panel_row[0].set_ylabel(SHOWN[score])
    for axes, key in zip(panels[-1], keys, strict=True):
        axes.set_xlabel(key)
    figure.suptitle(f"{study.name}: {len(made)} objects, each one dot")
    save_figure(figure, path)
    return True


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
