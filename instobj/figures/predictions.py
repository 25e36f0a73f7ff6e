"""Readings of trained estimators on presses held out: force against the true one, localisation errors."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, GREY, RED, draw_equality, draw_shares_within

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from estimator.networks.prediction import ContactAnswers, ContactReadings, HeldOutAnswers

_BLACK = "#222222"
_MOST_COLUMNS = 3
_MOST_PRESSES = 12
"""Presses drawn over time; all are drawn on the face."""


def draw_predictions(
    readings: Sequence[ContactReadings],
    source: Literal["simulated", "recorded"],
    location: str,
    path: Path,
) -> Figure:
    """A panel per face, predicted against true force, and below it the share of localisation errors
    (PNG); three faces side by side, so that words stay readable. `location` says where the presses are."""
    from matplotlib.figure import Figure

    columns = min(len(readings), _MOST_COLUMNS)
    blocks = -(-len(readings) // columns)
    figure = Figure(figsize=(max(3.3 * columns, 5.2), 7.2 * blocks), layout="constrained")
    panels = figure.subplots(2 * blocks, columns, squeeze=False)
    forces, places = panels[::2].ravel(), panels[1::2].ravel()
    largest = max(max(reading.true_force_n.max(), reading.force_n.max()) for reading in readings)
    furthest = max(float(reading.away_mm.max(initial=0.0)) for reading in readings)
    for reading, force_axes, place_axes in zip(readings, forces, places, strict=False):
        _draw_forces(force_axes, reading, 1.05 * float(largest))
        _draw_place_errors(place_axes, reading)
        place_axes.set_xlim(0, 1.05 * furthest or 1.0)
    for axes in (*forces[len(readings) :], *places[len(readings) :]):
        axes.remove()
    for first in range(0, len(readings), columns):
        forces[first].set_ylabel("predicted total force (N)")
        places[first].set_ylabel("contact frames with error ≤ x (%)")
    figure.suptitle(f"{source.capitalize()} held-out presses {location}: every frame with contact")
    save_figure(figure, path)
    return figure


def _draw_forces(axes: Any, reading: ContactReadings, end_n: float) -> None:
    error = np.median(np.abs(reading.force_n - reading.true_force_n))
    draw_equality(axes, 0, end_n)
    axes.plot(reading.true_force_n, reading.force_n, ".", color=BLUE, ms=3, alpha=0.4)
    axes.set(xlabel="true total force (N)")
    axes.set_title(f"Face {reading.face}: median error {error:.2f} N", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="upper left")


def _draw_place_errors(axes: Any, reading: ContactReadings) -> None:
    away = reading.away_mm
    draw_shares_within(axes, away, color=BLUE)
    for level, style in ((50, "--"), (90, ":")):
        percentile_mm = float(np.percentile(away, level))
        axes.axvline(
            percentile_mm, color=RED, ls=style, lw=1, label=f"{level} %: {percentile_mm:.2f} mm"
        )
    axes.set(xlabel="localisation error (mm)")
    axes.set_title(f"{len(away)} frames of {reading.presses} presses", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="lower right")


def draw_over_time(held_out: Sequence[HeldOutAnswers], path: Path) -> Figure:
    """Labelled and read force over time, and labelled and read places on the face, of held-out
    presses (PNG): one row per face, the model and the baseline of the least force error."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(12, 3.4 * len(held_out)), layout="constrained")
    panels = figure.subplots(
        len(held_out), 2, squeeze=False, gridspec_kw={"width_ratios": (2.6, 1)}
    )
    for answers_of_face, (time_axes, face_axes) in zip(held_out, panels, strict=True):
        model, *baselines = answers_of_face.answers
        best = min(
            baselines, key=lambda it: np.abs(it.force_n - answers_of_face.true_force_n).mean()
        )
        _draw_force_over_time(time_axes, answers_of_face, model, best)
        _draw_places(face_axes, answers_of_face, model, best)
    figure.suptitle("Held-out presses, contact frames: model and best baseline")
    save_figure(figure, path)
    return figure


def _draw_force_over_time(
    axes: Any, held_out: HeldOutAnswers, model: ContactAnswers, best: ContactAnswers
) -> None:
    """Presses one after another: what lies between them is left out."""
    presses = np.unique(held_out.press_id)[:_MOST_PRESSES]
    shown = np.flatnonzero(np.isin(held_out.press_id, presses))
    frame = np.arange(len(shown))
    low = np.maximum(model.force_n - held_out.force_halfwidth_n, 0)[shown]
    high = (model.force_n + held_out.force_halfwidth_n)[shown]
    for start in np.flatnonzero(np.diff(held_out.press_id[shown])) + 1:
        axes.axvline(start - 0.5, color=GREY, lw=0.6, ls=":")
    interval = f"model's {100 * held_out.interval_cover:.0f} % interval"
    axes.fill_between(frame, low, high, color=BLUE, alpha=0.18, lw=0, label=interval)
    axes.plot(frame, held_out.true_force_n[shown], color=_BLACK, lw=1.6, label="labelled")
    axes.plot(frame, best.force_n[shown], color=RED, lw=0.9, label=best.name)
    axes.plot(frame, model.force_n[shown], color=BLUE, lw=0.9, label="model")
    axes.set(xlabel="contact frame of the held-out presses", ylabel="total force (N)")
    axes.set_xlim(0, max(1, len(shown) - 1))
    axes.set_ylim(0, 1.2 * float(high.max()))
    axes.set_title(
        f"Face {held_out.face}: {len(presses)} of {len(np.unique(held_out.press_id))} held-out presses",
        fontsize=10,
    )
    axes.legend(frameon=False, fontsize=8, ncols=4, loc="upper right")


def _draw_places(
    axes: Any, held_out: HeldOutAnswers, model: ContactAnswers, best: ContactAnswers
) -> None:
    grid = np.meshgrid(held_out.grid_x_mm, held_out.grid_y_mm, indexing="ij")
    axes.plot(*(axis.ravel() for axis in grid), ".", color=GREY, ms=1.5, alpha=0.6)
    axes.plot(*best.xy_mm.T, ".", color=RED, ms=2.5, alpha=0.4, label=best.name)
    axes.plot(*model.xy_mm.T, ".", color=BLUE, ms=2.5, alpha=0.4, label="model")
    circle = {"mfc": "none", "mec": _BLACK, "ms": 9, "mew": 1.2, "ls": "none"}
    axes.plot(*held_out.true_xy_mm.T, "o", label="labelled", **circle)
    axes.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal")
    axes.set_title("Centre of force on the face", fontsize=10)
    axes.legend(frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.02, 0.5))
