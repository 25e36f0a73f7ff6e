"""Figures of weak areas: position bounds against where their locations lie."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.measures import LONGEST_PATH_MM, MEASURES, Measure
from estimator.information.scores import PlaceScores
from estimator.information.weak_areas import WeakAreas
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MEASURE_NAMES: dict[Measure, str] = {
    "border_mm": "distance to the border, mm",
    "magnet_mm": "distance to the nearest magnet, mm",
    "path_mm": "signal path over a magnet to a sensor, mm",
    "curvature_per_mm": "mean curvature, 1/m",
}
_INK, _POINTS, _WEAK = "#1a1a1a", "#8fb3cf", "#c8553d"
_COLOURS = ("#1b6ca8", "#c8553d", "#6a994e", "#b08900", "#7d5ba6", "#3c8d8a", "#777777")


def draw_weak_areas(
    scores: PlaceScores, areas: WeakAreas, limit_mm: float, path: Path | str
) -> None:
    """Position bound of every location against each measure that varies; medians of thirds (PNG).

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
        axes.axhline(limit_mm, color="0.35", ls="--", lw=1)
        axes.set(yscale="log", ylim=(min(low, limit_mm / 1.3), max(top, limit_mm * 1.3)))
        _draw_measure(axes, name, areas, scores.judged, np.minimum(bound, top))
    for axes in panels[::columns]:
        axes.set_ylabel("position bound, mm")
    panels[0].text(
        0.99, limit_mm * 1.04, f"limit {limit_mm:g} mm", ha="right", fontsize=8, color="0.25",
        bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.5},
        transform=panels[0].get_yaxis_transform(),
    )  # fmt: skip
    handles, labels = panels[0].get_legend_handles_labels()
    once = dict(zip(labels, handles, strict=True))
    figure.legend(
        list(once.values()),
        list(once),
        loc="outside lower center",
        ncols=3,
        frameon=False,
        fontsize=9,
    )
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
        (weakest, _WEAK, "weakest tenth"),
    ):
        axes.plot(value[some], bound_mm[some], ".", ms=4, color=colour, label=label)
    for third in areas.thirds:
        if third.measure != name:
            continue
        ends = [factor * third.low, factor * third.high]
        axes.plot(
            ends,
            [min(third.bound_mm, bound_mm.max())] * 2,
            "o-",
            ms=4,
            color=_INK,
            lw=2.5,
            label="median of a third",
        )
    axes.set(xlabel=MEASURE_NAMES[name])
    axes.set_title(f"rank correlation {areas.rank_correlation[name]:+.2f}", fontsize=10)
    axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
    axes.yaxis.set_minor_formatter(lambda *_: "")
    axes.grid(alpha=0.3)


def draw_paths(
    objects: Sequence[tuple[str, Float[np.ndarray, "_"], Float[np.ndarray, "_"]]],
    rows: Sequence[dict[str, Any]],
    limit_mm: float,
    path: Path | str,
) -> None:
    """Position bounds of many objects' locations against their signal paths (PNG).

    `objects` are kind, paths and bounds (mm) of their locations, `rows` bins of all of them.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.4, 4.8), layout="constrained")
    axes = figure.subplots()
    kinds = list(dict.fromkeys(kind for kind, *_ in objects))
    for kind, colour in zip(kinds, _COLOURS, strict=False):
        some = [(away, bound) for name, away, bound in objects if name == kind]
        away, bound = (np.concatenate(part) for part in zip(*some, strict=True))
        axes.plot(away, bound, ".", ms=3, alpha=0.5, color=colour, label=kind)
    middle = [(row["from_mm"] + row["to_mm"]) / 2 for row in rows]
    low, high = ([row[end] for row in rows] for end in ("low_mm", "high_mm"))
    axes.fill_between(middle, low, high, color=_INK, alpha=0.15, label="10 to 90 % of locations")
    axes.plot(middle, [row["median_mm"] for row in rows], "-o", color=_INK, ms=4, label="median")
    axes.axhline(limit_mm, color="0.25", ls="--", lw=1, label=f"limit {limit_mm:g} mm")
    axes.axvline(LONGEST_PATH_MM, color="0.25", ls=":", lw=1, label=f"path {LONGEST_PATH_MM:g} mm")
    axes.set(yscale="log", xlabel="signal path over a magnet to a sensor, mm")
    axes.set_ylabel("position bound, mm")
    axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
    axes.grid(alpha=0.3)
    figure.legend(loc="outside right upper", frameon=False, fontsize=9)
    save_figure(figure, path)
