"""Comparison of layouts: one table and one figure of their scores."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from design.layout.places.coverage import covered_share
from design.spec.object import ObjectSpec
from estimator.information.scores import PlaceScores, weakest_place
from estimator.information.weak_areas import bound_of_most, weak_areas
from instobj.figures.saving import save_figure
from instobj.store.publish import file_rows, run_folder
from instobj.store.readers import SCORES


def compare_scores(specs: list[ObjectSpec], out: Path) -> dict[str, Any]:
    """Rows and a figure from the `scores.csv` that every specification has in `runs/<name>`."""
    scores = [SCORES.read(run_folder(out, spec.name)) for spec in specs]
    figure = comparison_picture(specs, out)
    draw_comparison(specs, scores, figure)
    rows = [comparison_row(spec, places) for spec, places in zip(specs, scores, strict=True)]
    return {"rows": rows, "files": file_rows([figure])}


def comparison_picture(specs: list[ObjectSpec], out: Path) -> Path:
    """Return where the figure of a comparison lies, and all else that is written of it."""
    return run_folder(out, "+".join(spec.name for spec in specs)) / "comparison.png"


def comparison_row(spec: ObjectSpec, scores: PlaceScores) -> dict[str, Any]:
    """Scores of one object as tables show them."""
    judged, weakest = scores.judged, weakest_place(scores)
    bound = scores.position_bound_mm[judged]
    return {
        "object": spec.name,
        "press N": spec.score.force_n,
        "places that reach it %": round(100 * judged.sum() / scores.places.sum(), 1),
        "surface covered %": round(100 * covered_share(spec)),
        "bounds read": spec.score.channels,
        "place mm": float(np.median(bound)),
        "place, 95 % below mm": bound_of_most(bound),
        "weakest place mm": weakest.position_bound_mm,
        "on face": weakest.face,
        "edge ratio": weak_areas(spec, scores).edge_ratio,
        "places within limit %": round(
            100 * float(np.mean(bound <= spec.limits.position_bound_mm)), 1
        ),
        "place after 15 min mm": float(np.median(scores.position_bound_drifted_mm[judged])),
        "force N": float(np.median(scores.force_bound_n[judged])),
        "detect N": float(np.median(scores.detectable_force_n[judged])),
        "own channels": 3 * spec.sensors.count_per_face,
        "δ, counts^channels/N": float(np.median(scores.delta_raw[judged])),
    }


def draw_comparison(specs: list[ObjectSpec], scores: list[PlaceScores], path: Path) -> None:
    """Share of contact locations whose position bound is below a value, one line per object (PNG)."""
    from matplotlib import colormaps
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 4.6), layout="constrained")
    axes = figure.subplots()
    colours = colormaps["viridis"](np.linspace(0.05, 0.85, len(specs)))
    for spec, places, colour in zip(specs, scores, colours, strict=True):
        for name, style in (("position_bound_mm", "-"), ("position_bound_drifted_mm", ":")):
            bound = np.sort(getattr(places, name)[places.judged])
            share = 100 * np.arange(1, bound.size + 1) / bound.size
            label = spec.name if style == "-" else None
            axes.plot(bound, share, color=colour, ls=style, label=label)
    axes.set(xscale="log", ylim=(0, 100), xlabel="position bound (mm)")
    axes.set_ylabel("contact locations with bound ≤ x (%)")
    axes.set_title(
        "How well contacts can be located: freshly zeroed (solid), after 15 min (dotted)"
    )
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False, loc="lower right")
    save_figure(figure, path)
