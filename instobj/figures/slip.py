"""Cost of a slipped core: baseline changes of the sensors, and shares of errors."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, draw_shares_within

if TYPE_CHECKING:
    from estimator.information.slip_cost import SlipCost

_SMALLEST_SHOWN = 0.03


def draw_slip(spec: ObjectSpec, cost: SlipCost, path: Path, title: str) -> None:
    """Resting signal of every sensor, and shares of localisation and force errors (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 7), layout="constrained")
    grid = figure.add_gridspec(2, 2)
    _draw_sensors(figure.add_subplot(grid[0, :]), spec, cost)
    _draw_shares(figure.add_subplot(grid[1, 0]), cost, "place_mm", "localisation error (mm)")
    _draw_shares(figure.add_subplot(grid[1, 1]), cost, "force_n", "force error (N)")
    figure.suptitle(f"{spec.name}: {title}", fontsize=13)
    save_figure(figure, path)


def _draw_sensors(axes: Any, spec: ObjectSpec, cost: SlipCost) -> None:
    from design.layout.places.positions import sensor_layout

    face = sensor_layout(spec).face
    place = np.arange(len(face)) + 0.6 * face
    axes.bar(place, cost.baseline_sigma, 0.8, color=BLUE)
    axes.set_xticks(
        place, [f"{f}·{index % spec.sensors.count_per_face + 1}" for index, f in enumerate(face)]
    )
    axes.set(xlabel="face · sensor", ylabel="change of baseline (σ of white noise)")
    axes.spines[["top", "right"]].set_visible(False)


def _draw_shares(axes: Any, cost: SlipCost, what: str, label: str) -> None:
    """Share of contact locations with an error of at most a limit, with the old and a new baseline."""
    for prefix, style, zero in (("rezeroed", "-", "new baseline"), ("false", ":", "old baseline")):
        errors = getattr(cost, f"{prefix}_{what}")[cost.places]
        draw_shares_within(axes, errors, style, color=BLUE, label=zero)
    axes.set_xscale("log")
    axes.set(xlabel=label, ylabel="contact locations with error ≤ x (%)")
    axes.set_xlim(left=_SMALLEST_SHOWN)
    axes.legend(frameon=False, fontsize=8, loc="upper left")
