"""Figures of weak areas: position bounds against where their locations lie."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.measures import MEASURES, Measure
from estimator.information.scores import PlaceScores
from estimator.information.weak_areas import WeakAreas
from instobj.figures.saving import save_figure
from instobj.figures.style import RED, draw_limit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MEASURE_NAMES: dict[Measure, str] = {
    "border_mm": "distance to the border, mm",
    "magnet_mm": "distance to the nearest magnet, mm",
    "path_mm": "signal path over a magnet to a sensor, mm",
    "curvature_per_mm": "mean curvature, 1/m",
}
_INK, _POINTS = "#1a1a1a", "#8fb3cf"


def draw_weak_areas(
    scores: PlaceScores, areas: WeakAreas, limit_mm: float, path: Path | str
) -> None:
    """Position bound of every location against each measure that varies; the bound that 95 % of each
    third keep (PNG).

    Blind locations stand at the top edge.
    """
    from matplotlib.figure import Figure

    shown: list[Measure] = [name for name in MEASURES if name in areas.rank_correlation]
    if not shown:  # one location, or some that lie alike: there is nothing to draw against
        figure = Figure(figsize=(5.0, 1.0))
        figure.text(0.5, 0.5, "All contact locations lie alike", ha="center", va="center")
        save_figure(figure, path)
        return
    rows, columns = -(-len(shown) // 2), min(2, len(shown))
    figure = Figure(figsize=(5.0 * columns, 3.6 * rows + 0.4), layout="constrained")
    panels = figure.subplots(rows, columns, sharey=True, squeeze=False).ravel()
    for empty in panels[len(shown) :]:
        empty.set_axis_off()
    bound = scores.position_bound_mm[scores.judged]
    finite_bounds = bound[np.isfinite(bound)]
    top = 1.3 * float(finite_bounds.max()) if len(finite_bounds) else 1.0
    low = float(finite_bounds.min()) / 1.3 if len(finite_bounds) else 0.1
    for axes, name in zip(panels, shown, strict=False):
        draw_limit(axes, limit_mm)
        axes.set(yscale="log", ylim=(min(low, limit_mm / 1.3), max(top, limit_mm * 1.3)))
        _draw_measure(axes, name, areas, scores.judged, np.minimum(bound, top))
    for axes in panels[::columns]:
        axes.set_ylabel("position bound, mm")
    handles, labels = panels[0].get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    place: dict[str, Any] = {"loc": "outside lower center", "ncols": 3, "frameon": False}
    figure.legend(list(once.values()), list(once), fontsize=9, **place)
    save_figure(figure, path)


def _draw_measure(
    axes: Axes,
    name: Measure,
    areas: WeakAreas,
    places: Bool[np.ndarray, "face place"],
    bound_mm: Float[np.ndarray, "_"],
) -> None:
    """Bounds of the locations against one measure, blind ones at the greatest."""
    weakest = bound_mm >= np.quantile(bound_mm, 0.9, method="lower")
    factor = 1000.0 if name == "curvature_per_mm" else 1.0
    value = factor * getattr(areas.measures, name)[places]
    for some, colour, label in (
        (~weakest, _POINTS, "contact location"),
        (weakest, RED, "weakest tenth"),
    ):
        axes.plot(value[some], bound_mm[some], ".", ms=4, color=colour, label=label)
    for third in areas.thirds:
        if third.measure != name:
            continue
        ends = [factor * third.low, factor * third.high]
        middle = [min(third.bound_mm, bound_mm.max())] * 2
        axes.plot(
            ends, middle, "o-", ms=4, color=_INK, lw=2.5, label="bound that 95 % of a third keep"
        )
    axes.set(xlabel=MEASURE_NAMES[name])
    axes.set_title(f"rank correlation {areas.rank_correlation[name]:+.2f}", fontsize=10)
    axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
    axes.yaxis.set_minor_formatter(lambda *_: "")
    axes.grid(alpha=0.3)
