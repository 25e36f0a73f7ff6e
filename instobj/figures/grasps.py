"""Figure of grasps: forces over time, and the measure that grippers are ranked by."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from instobj.figures.saving import save_figure


class GroupPicture(NamedTuple):
    """One gripper: force curves (s, N), its measure (grasp, value and ends), and the median's interval."""

    name: str
    curves: Sequence[tuple[np.ndarray, np.ndarray]]
    values: np.ndarray
    median: tuple[float, float, float]


def draw_grasps(groups: Sequence[GroupPicture], axis: str, path: Path) -> None:
    """Total force of every grasp over time, and the measure of each grasp with the median (PNG)."""
    from matplotlib import colormaps
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 4.4), layout="constrained")
    forces, measures = figure.subplots(1, 2)
    colours = colormaps["viridis"](np.linspace(0.05, 0.8, len(groups)))
    for row, (group, colour) in enumerate(zip(groups, colours, strict=True)):
        for number, (time_s, force_n) in enumerate(group.curves):
            label = group.name if number == 0 else None
            forces.plot(time_s, force_n, color=colour, lw=0.9, alpha=0.6, label=label)
        value, low, high = group.values.T
        shift = np.linspace(-0.25, 0.25, len(value)) if len(value) > 1 else np.zeros(len(value))
        ends = np.nan_to_num([value - low, high - value]).clip(0.0)
        measures.errorbar(row + shift, value, ends, fmt="o", ms=4, color=colour, lw=0.8, alpha=0.7)
        median, least, most = group.median
        measures.plot([row - 0.35, row + 0.35], [median, median], color="#222222", lw=1.8)
        if np.isfinite(least):
            measures.fill_between(
                [row - 0.35, row + 0.35], least, most, color="#222222", alpha=0.15, lw=0
            )
    forces.set(xlabel="time since touch (s)", ylabel="sum of normal forces (N)", ylim=(0, None))
    forces.set_title("every grasp", fontsize=10)
    forces.legend(frameon=False, fontsize=8)
    measures.set(ylabel=axis, xlim=(-0.6, len(groups) - 0.4))
    measures.set_xticks(range(len(groups)), [group.name for group in groups])
    measures.set_title("points: grasps, 90 %; line and band: median, 95 %", fontsize=10)
    for axes in (forces, measures):
        axes.grid(alpha=0.3)
    save_figure(figure, path)
