"""Figure of a layout search: how it converged."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from instobj.figures.saving import save_figure
from instobj.search.outcome.history import History, best_so_far

_PAPER, _GREY = "#fdfdfb", "#9a968d"
_BEST, _START = "#1f77d0", "#77736b"
LABELS = {
    "worst_position_bound_mm": "worst location, position bound (mm)",
    "percentile_99_position_bound_mm": "99th percentile of locations, position bound (mm)",
    "percentile_95_position_bound_mm": "95th percentile of locations, position bound (mm)",
    "median_position_bound_mm": "median location, position bound (mm)",
    "position_over_limit": "position bound over its limit, mean of what is beyond",
    "worst_force_bound_n": "worst location, force bound (N)",
    "median_false_force_n": "false force by the next face (N), median",
    "percentile_95_false_force_n": "false force by the next face (N), 95th percentile",
    "sensitivity_ratio": "δ, 5th over 50th percentile",
    "saturation_margin": "share of the sensors' range left free, by the design",
    "objects_margin": "the same of 95 % of the virtual objects",
}


def draw_convergence(history: History, path: Path) -> None:
    """Best feasible first objective against layouts scored (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8.2, 4.6), facecolor=_PAPER, layout="constrained")
    axes = figure.subplots()
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_facecolor(_PAPER)
    name, values = history.names[0], history.values[:, 0]
    scorings = history.scorings
    axes.plot(scorings[history.feasible], values[history.feasible], ".", color=_GREY, ms=4,
              label="trials within all limits")  # fmt: skip
    axes.step(scorings, best_so_far(name, values, history.feasible), where="post", color=_BEST, lw=2.2,
              label="best so far")  # fmt: skip
    axes.axhline(history.start[0], color=_START, ls="--", lw=1.4, label="start")
    axes.set(xscale="log", yscale="log", xlabel="layouts scored at the lowest fidelity level")
    axes.set(ylabel=LABELS[name], title="Convergence at the lowest fidelity level")
    _plain(axes.yaxis)
    figure.legend(loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    save_figure(figure, path)


def _plain(axis: Any) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator

    axis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(FuncFormatter(lambda *_: ""))
