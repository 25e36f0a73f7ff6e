"""Readings of trained estimators on presses held out: force against the true one, localisation errors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from estimator.networks.prediction import ContactReadings

_BLUE, _RED, _GREY = "#1b6ca8", "#c8553d", "#777777"


def draw_predictions(
    readings: Sequence[ContactReadings], source: Literal["simulated", "recorded"], path: Path
) -> None:
    """One column per face: predicted against true force above, share of localisation errors below (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(max(3.3 * len(readings), 5.2), 7.2), layout="constrained")
    panels = figure.subplots(2, len(readings), squeeze=False, sharey="row", sharex="row")
    largest = max(max(one.true_force_n.max(), one.force_n.max()) for one in readings)
    for one, (force_axes, place_axes) in zip(readings, panels.T, strict=True):
        _draw_forces(force_axes, one, 1.05 * float(largest))
        _draw_place_errors(place_axes, one)
    panels[0, 0].set_ylabel("predicted total force (N)")
    panels[1, 0].set_ylabel("contact frames with error ≤ x (%)")
    figure.suptitle(f"{source.capitalize()} held-out presses: every frame with contact")
    save_figure(figure, path)


def _draw_forces(axes: Any, one: ContactReadings, end_n: float) -> None:
    error = np.median(np.abs(one.force_n - one.true_force_n))
    axes.plot([0, end_n], [0, end_n], color=_GREY, lw=0.9, label="equal")
    axes.plot(one.true_force_n, one.force_n, ".", color=_BLUE, ms=3, alpha=0.4)
    axes.set(xlim=(0, end_n), ylim=(0, end_n), aspect="equal", xlabel="true total force (N)")
    axes.set_title(f"Face {one.face}: median error {error:.2f} N", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="upper left")


def _draw_place_errors(axes: Any, one: ContactReadings) -> None:
    away = np.sort(one.away_mm)
    share = 100 * np.arange(1, len(away) + 1) / len(away)
    axes.plot(away, share, color=_BLUE)
    for level, style in ((50, "--"), (90, ":")):
        at = float(np.percentile(away, level))
        axes.axvline(at, color=_RED, ls=style, lw=1, label=f"{level} %: {at:.2f} mm")
    axes.set(xlabel="localisation error (mm)", ylim=(0, 102))
    axes.set_xlim(left=0)
    axes.set_title(f"{len(away)} frames of {one.presses} presses", fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, fontsize=8, loc="lower right")
