"""Scores of variants beside each other, as multiples of the first one's."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from instobj.figures.saving import save_figure

_SCORES = {
    "worst place mm": "position, worst location",
    "median place mm": "position, median location",
    "worst force N": "force, worst location",
    "false N": "false force by the next face",
}


def draw_variants(rows: list[dict[str, Any]], force_n: float, path: Path) -> None:
    """One line per variant, one mark per score; left of 1 is better (PNG)."""
    from matplotlib import colormaps
    from matplotlib.figure import Figure
    from matplotlib.ticker import FuncFormatter, NullFormatter

    figure = Figure(figsize=(8.5, 1.9 + 0.55 * len(rows)), layout="constrained")
    axes = figure.subplots()
    colours = colormaps["viridis"](np.linspace(0.0, 0.85, len(_SCORES)))
    lanes = np.linspace(-0.24, 0.24, len(_SCORES))
    first, largest = rows[0], 1.3
    for (name, label), colour, lane in zip(_SCORES.items(), colours, lanes, strict=True):
        ratio = np.array([row[name] / first[name] for row in rows])
        largest = max(largest, *ratio, *(1 / ratio))
        level = np.arange(len(rows)) + lane
        axes.barh(level, ratio - 1, left=1, height=0.13, color=colour, label=label)
    axes.axvline(1, color="0.3", lw=1)
    axes.set(xscale="log", xlim=(1 / (1.1 * largest), 1.1 * largest), ylim=(len(rows) - 0.5, -0.5))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    every = (0.1, 0.2, 0.3, 0.5, 0.7, 0.8, 0.9, 1, 1.1, 1.25, 1.5, 2, 3, 5, 10)
    near = (0.8, 0.9, 1.1, 1.25)
    ticks = [t for t in every if 1 / largest <= t <= largest and (largest < 1.7 or t not in near)]
    axes.set_xticks(ticks)
    axes.set_yticks(range(len(rows)), [_label(row) for row in rows])
    axes.grid(axis="x", alpha=0.3)
    axes.set_xlabel(f"ratio to the first variant (bounds at {force_n:g} N; lower is better)")
    figure.legend(loc="outside upper center", ncols=4, frameon=False, fontsize=9)
    save_figure(figure, path)


def _label(row: dict[str, Any]) -> str:
    worst, median = row["worst place mm"], row["median place mm"]
    return f"{row['variant']}\n{worst:.2f} mm worst, {median:.2f} median"
