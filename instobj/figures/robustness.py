"""Ranked bars of the robustness budget: the largest contributions of one specification."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, RED

if TYPE_CHECKING:
    from estimator.tolerances.result import Robustness

_ALL = "#5b5b5b"
_PANELS = (
    ("false_place_mm", "false_place_worst_mm", 1.0, "localisation error (mm)"),
    ("false_force_n", "false_force_worst_n", 1.0, "false force (N)"),
    ("signal", "signal_worst", 100.0, "signal change (%)"),
    ("baseline_counts", "baseline_worst_counts", 1.0, "resting level (counts)"),
)

_SHORT_BAR = 0.05
"""Share of the axis: where the longest bar is shorter, the axis is logarithmic."""


def draw_robustness(spec: ObjectSpec, budget: Robustness, path: Path) -> None:
    """One row per contribution, worst first, and all together below; one panel per consequence (PNG)."""
    from matplotlib.figure import Figure

    rows = (*budget.contributions, budget.monte_carlo)
    figure = Figure(figsize=(13, 0.34 * len(rows) + 2.2), layout="constrained")
    panels = figure.subplots(1, len(_PANELS), sharey=True)
    for axes, (median, worst, scale, label) in zip(panels, _PANELS, strict=True):
        values, largest = ([scale * getattr(row, name) for row in rows] for name in (median, worst))
        draw_panel(axes, values, largest)
        axes.set_xlabel(label)
    panels[0].set_yticks(range(len(rows)), [tolerance_text(spec, row.name) for row in rows])
    panels[0].invert_yaxis()
    handles, labels = panels[0].get_legend_handles_labels()
    title = "figures: typical / worst"
    figure.legend(handles, labels, loc="outside lower center", ncols=2, frameon=False, title=title)
    figure.suptitle(
        f"{spec.name}: effect of one standard deviation of each tolerance on a press of "
        f"{budget.force_n:g} N, read by an estimator calibrated on the design"
    )
    save_figure(figure, path)


def draw_panel(axes: Any, values: list[float], largest: list[float]) -> None:
    """Linear, but where the worst locations would leave bars of no length."""
    rows = len(values)
    colours = [BLUE] * (rows - 1) + [_ALL]
    median, worst = "median location (baseline: rms of channels)", "worst location (worst channel)"
    axes.barh(range(rows), values, color=colours, height=0.7, label=median)
    axes.plot(largest, range(rows), "|", color=RED, markersize=11, label=worst)
    for index, (value, worst_value) in enumerate(zip(values, largest, strict=True)):
        axes.annotate(
            f"{_short(value)} / {_short(worst_value)}",
            (worst_value, index),
            xytext=(5, 0),
            textcoords="offset points",
            va="center",
            fontsize=8,
            color="#333333",
        )
    axes.axhline(rows - 1.5, color="#999999", linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    if 0 < max(values) < _SHORT_BAR * max(largest):
        axes.set_xscale("log")
        axes.set_xlim(min(max(values) / 30, 1.0), 6 * max(largest))
    else:
        axes.set_xlim(0, 1.3 * max(largest))


def _short(value: float) -> str:
    if value < 0.005:
        return "0"
    return f"{value:.2f}" if value < 1 else f"{value:.1f}" if value < 10 else f"{value:.0f}"


def tolerance_text(spec: ObjectSpec, name: str) -> str:
    """Return what a row of the budget stands for, with its standard deviation."""
    from estimator.tolerances.assembly import CONTRIBUTIONS

    t = spec.tolerances
    sizes = {
        "magnet_seat": f"{t.magnet_seat_mm:g} mm",
        "magnet_depth": f"{t.magnet_seat_mm:g} mm",
        "magnet_tilt": f"{t.magnet_tilt_deg:g}°",
        "remanence": f"{100 * t.remanence_relative:g} %",
        "sensor_seat": f"{t.sensor_seat_mm:g} mm",
        "sensor_rotation": f"{t.sensor_rotation_deg:g}°",
        "sensor_gain": f"{100 * t.sensor_gain_relative:g} %",
        "sensor_offset": f"{t.sensor_offset_ut:g} µT",
        "core_shift": f"{t.core_shift_mm:g} mm",
        "core_yaw": f"{t.core_yaw_deg:g}°",
        "modulus": f"{100 * t.modulus_relative:g} %",
        "temperature": f"{t.temperature_k:g} K",
        "earth_field": f"{t.earth_field_ut:g} µT, turned",
    }
    whole = {"monte_carlo": "all together (Monte Carlo)", "together": "root sum of squares"}
    return whole.get(name) or f"{CONTRIBUTIONS[name][1]} {sizes[name]}"
