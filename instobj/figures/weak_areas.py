"""Figures of weak areas: position bounds against where their locations lie."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from design.layout.places.measures import MEASURES, Measure
from estimator.information.scores import PlaceScores
from estimator.information.weak_areas import WeakAreas
from instobj.figures.saving import save_figure

MEASURE_NAMES: dict[Measure, str] = {
    "border_mm": "distance to the border, mm",
    "magnet_mm": "distance to the nearest magnet, mm",
    "curvature_per_mm": "mean curvature, 1/mm",
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
    figure = Figure(figsize=(4.2 * len(shown) + 0.6, 4.0), layout="constrained")
    panels = figure.subplots(1, len(shown), sharey=True, squeeze=False)[0]
    bound = scores.position_bound_fresh_mm[scores.places]
    known = bound[np.isfinite(bound)]
    top = 1.3 * float(known.max()) if len(known) else 1.0
    low = float(known.min()) / 1.3 if len(known) else 0.1
    weakest = bound >= np.quantile(bound, 0.9, method="lower")
    for axes, name in zip(panels, shown, strict=True):
        value = getattr(areas.measures, name)[scores.places]
        for some, colour, label in (
            (~weakest, _POINTS, "contact location"),
            (weakest, _WEAK, "weakest tenth"),
        ):
            axes.plot(
                value[some], np.minimum(bound[some], top), ".", ms=4, color=colour, label=label
            )
        for third in areas.thirds:
            if third.measure != name:
                continue
            ends = [third.low, third.high]
            axes.plot(
                ends,
                [min(third.bound_mm, top)] * 2,
                "o-",
                ms=4,
                color=_INK,
                lw=2.5,
                label="median of a third",
            )
        axes.axhline(limit_mm, color="0.35", ls="--", lw=1)
        axes.set(yscale="log", ylim=(min(low, limit_mm / 1.3), max(top, limit_mm * 1.3)))
        axes.set(xlabel=MEASURE_NAMES[name])
        axes.set_title(f"rank correlation {areas.rank_correlation[name]:+.2f}", fontsize=10)
        axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
        axes.yaxis.set_minor_formatter(lambda *_: "")
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("position bound, mm")
    panels[0].text(
        0.99, limit_mm * 1.04, f"limit {limit_mm:g} mm", ha="right", fontsize=8, color="0.35",
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


def draw_reach(
    objects: Sequence[tuple[str, float, Float[np.ndarray, "_"], Float[np.ndarray, "_"]]],
    reach: Sequence[dict[str, Any]],
    path: Path | str,
) -> None:
    """Bounds over the object's own near a magnet, against the distance to the nearest (PNG).

    `objects` are kind, shell (mm), distances (mm) and ratios of their locations.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.4, 4.8), layout="constrained")
    axes = figure.subplots()
    kinds = list(dict.fromkeys(kind for kind, *_ in objects))
    for kind, colour in zip(kinds, _COLOURS, strict=False):
        some = [(away, ratio) for name, _, away, ratio in objects if name == kind]
        axes.plot(
            np.concatenate([away for away, _ in some]), np.concatenate([ratio for _, ratio in some]),
            ".", ms=3, alpha=0.5, color=colour, label=kind,
        )  # fmt: skip
    middle = [(row["from_mm"] + row["to_mm"]) / 2 for row in reach]
    axes.fill_between(
        middle, [row["low"] for row in reach], [row["high"] for row in reach], color=_INK, alpha=0.15,
        label="10 to 90 % of the objects",
    )  # fmt: skip
    axes.plot(
        middle, [row["median"] for row in reach], "-o", color=_INK, ms=4, label="median object"
    )
    axes.set(yscale="log", xlabel="distance to the nearest magnet along the face, mm")
    axes.set_ylabel("position bound / the object's own within 3 mm of a magnet")
    axes.yaxis.set_major_formatter(lambda number, _: f"{number:g}")
    axes.yaxis.set_minor_formatter(lambda *_: "")
    axes.set_yticks([0.5, 1, 2, 3, 5, 10, 20])
    axes.grid(alpha=0.3)
    figure.legend(loc="outside right upper", frameon=False, fontsize=9)
    save_figure(figure, path)
