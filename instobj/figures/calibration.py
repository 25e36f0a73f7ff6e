"""Residuals of a digital twin at held-out contact locations, compared with the design's."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure

_PANELS = {"left by design %": "design", "left %": "calibrated twin"}


def draw_calibration(spec: ObjectSpec, rows: list[dict[str, Any]], path: Path) -> None:
    """A row of panels per face, one colour scale for all (PNG); nothing without a face."""
    if not rows:
        return
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.6, 0.9 + 3.9 * len(rows)), layout="constrained")
    panels = figure.subplots(len(rows), len(_PANELS), squeeze=False)
    largest = max(max(row[name]) for row in rows for name in _PANELS)
    for row, pair in zip(rows, panels, strict=True):
        places = np.array(row["places mm"])
        for (name, title), axes in zip(_PANELS.items(), pair, strict=True):
            residual_percent = np.array(row[name])
            dots = axes.scatter(
                *places.T, c=residual_percent, s=330, vmin=0, vmax=largest, cmap="viridis"
            )
            for place, value in zip(places, residual_percent, strict=True):
                colour = "white" if value < 0.6 * largest else "black"
                axes.annotate(
                    f"{value:.2g}", place, ha="center", va="center", fontsize=7, color=colour
                )
            axes.set(
                title=f"face {row['face']}, {title}: median {np.median(residual_percent):.2g} %"
            )
            axes.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
            axes.margins(0.12)
    figure.colorbar(dots, ax=panels, label="residual signal beyond noise (%, rms)", shrink=0.8)
    figure.suptitle(
        f"{spec.name}: held-out locations: residual of the calibrated twin (darker is better)"
    )
    save_figure(figure, path)
