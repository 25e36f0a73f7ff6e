"""Table, figure and page of a sweep."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from design.files import atomic_path
from design.tables import write_table
from instobj.commands.compare import comparison_row
from instobj.figures.saving import save_figure
from instobj.report.pages import render
from instobj.store.content import find
from instobj.store.readers import SCORES
from instobj.store.shared import URL
from instobj.sweep.study import Study, Variant

SHOWN = ("weakest place mm", "place mm", "detect N")
"""Scores that the figure draws against every changed key."""


def variant_row(variant: Variant, outcome: dict[str, Any], root: Path) -> dict[str, Any]:
    """What was changed and what came of it: the scores of `instobj compare`, or an error."""
    row: dict[str, Any] = {"object": variant.label, **variant.changes}
    if outcome["error"] or variant.spec is None:
        return row | {"error": outcome["error"] or variant.refused}
    scores = find(root, SCORES.stage, outcome["key"])
    if scores is None:
        return row | {
            "error": f"a worker made its scores, and they are not in {root}. Give all machines one store: "
            f"the same folder, or {URL}"
        }
    return row | comparison_row(variant.spec, SCORES.read(scores.folder))


def write_outcome(study: Study, rows: Sequence[dict[str, Any]], folder: Path) -> list[Path]:
    """Write `sweep.csv`, `sweep.png` where a number was changed, and `sweep.html`."""
    header = list({name: None for row in rows for name in row})
    write_table(
        folder / "sweep.csv", header, ([row.get(name, "") for name in header] for row in rows)
    )
    drawn = draw_sweep(study, rows, folder / "sweep.png")
    made = [row for row in rows if "error" not in row]
    page = render(
        "sweep.html.j2",
        name=study.name,
        keys=study.keys,
        header=header,
        rows=[[_cell(row.get(name, "")) for name in header] for row in rows],
        made=len(made),
        count=len(rows),
        best=min(made, key=lambda row: row["weakest place mm"], default=None),
        picture_path=folder / "sweep.png" if drawn else None,
    )
    with atomic_path(folder / "sweep.html") as temporary:
        temporary.write_text(page, encoding="utf-8")
    names = ("sweep.html", "sweep.csv", *(["sweep.png"] if drawn else []))
    return [folder / name for name in names]


def draw_sweep(study: Study, rows: Sequence[dict[str, Any]], path: Path) -> bool:
    """One panel for every score and every key whose values are numbers; False where there is none."""
    from matplotlib.figure import Figure

    made = [row for row in rows if "error" not in row]
    keys = [key for key in study.keys if all(_is_number(row.get(key)) for row in made)]
    if not keys or not made:
        return False
    size = (1 + 2.9 * len(keys), 2.4 * len(SHOWN))
    figure = Figure(figsize=size, layout="constrained")
    panels = figure.subplots(len(SHOWN), len(keys), squeeze=False, sharex="col", sharey="row")
    for panel_row, score in zip(panels, SHOWN, strict=True):
        for axes, key in zip(panel_row, keys, strict=True):
            x, y = (np.array([row[name] for row in made], dtype=float) for name in (key, score))
            axes.plot(x, y, "o", ms=4, color="#31688e", alpha=0.7)
            axes.grid(alpha=0.3)
            axes.set_ylim(bottom=0)
        panel_row[0].set_ylabel(score)
    for axes, key in zip(panels[-1], keys, strict=True):
        axes.set_xlabel(key)
    figure.suptitle(f"{study.name}: {len(made)} objects, each one dot")
    save_figure(figure, path)
    return True


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _cell(value: Any) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)
