"""Predicted compared with recorded change of every chip over a pad, from presses of one travel."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from estimator.calibration.known_travel.fit import Fitted
    from estimator.calibration.known_travel.model import TravelModel
    from estimator.calibration.known_travel.suspects import FreedAssumption
    from estimator.recordings.formats.travel import TravelRecording

_HALF_BAND_MM = 0.5
"""Half the range of travels that a figure shows together."""


def draw_travel(
    spec: ObjectSpec,
    model: TravelModel,
    fitted: Fitted,
    recording: TravelRecording,
    document: dict[str, Any],
    path: Path,
) -> None:
    """Maps of all channels, recorded above predicted, of presses about the middle travel (PNG)."""
    from matplotlib.figure import Figure

    xy, travel = fitted.twin.pose.locate_tips(recording.tip_mm)
    middle = float(np.quantile(travel, 0.75))
    rows = abs(travel - middle) < _HALF_BAND_MM
    maps = {
        "recorded": recording.field_mt[rows] - fitted.resting_mt,
        "predicted": model.pressed(fitted.twin, recording.tip_mm[rows]),
    }
    sensors = recording.field_mt.shape[1]
    figure = Figure(figsize=(2.1 * sensors + 1.2, 11.5), layout="constrained")
    panels = figure.subplots(6, sensors, sharex=True, sharey=True, squeeze=False)
    for axis, letter in enumerate("XYZ"):
        largest = float(np.quantile(abs(maps["recorded"][:, :, axis]), 0.995))
        for line, (name, change) in enumerate(maps.items()):
            for sensor in range(sensors):
                panel = panels[2 * axis + line, sensor]
                shown = panel.scatter(
                    *xy[rows].T, c=change[:, sensor, axis], s=9, marker="s", cmap="RdBu_r",
                    vmin=-largest, vmax=largest,
                )  # fmt: skip
                panel.set_aspect("equal")
                panel.set_title(f"chip {sensor + 1} {letter}, {name}", fontsize=8)
                if not sensor:
                    panel.set_ylabel("y, mm")
        figure.colorbar(shown, ax=panels[2 * axis : 2 * axis + 2], label=f"change of {letter}, mT")
    for panel in panels[-1]:
        panel.set_xlabel("x, mm")
    agreement = document["agreement"]["registered"]["all"]
    figure.suptitle(
        f"{spec.name}: {int(rows.sum())} presses {middle - _HALF_BAND_MM:.1f} to "
        f"{middle + _HALF_BAND_MM:.1f} mm deep, registered on 5 % of the places\n"
        f"all travels: median cosine {agreement['cosine']:.2f}, "
        f"{100 * agreement['explained']:.0f} % of the change explained, no modulus"
    )
    save_figure(figure, path)


def draw_residuals(
    spec: ObjectSpec,
    model: TravelModel,
    fitted: Fitted,
    judged: TravelRecording,
    suspects: list[FreedAssumption],
    path: Path,
) -> Figure:
    """Return where the residuals of the judged presses lie, chip by chip, and what they point to (PNG)."""
    from matplotlib.figure import Figure

    xy = fitted.twin.pose.locate_tips(judged.tip_mm)[0]
    recorded = judged.field_mt - fitted.resting_mt
    residual = recorded - model.pressed(fitted.twin, judged.tip_mm)
    place = judged.place_id
    count = np.bincount(place)
    has_press = np.flatnonzero(count)
    mean_place = np.stack(
        [np.bincount(place, weights=c)[has_press] / count[has_press] for c in xy.T]
    )

    def rms_per_place(values: np.ndarray) -> np.ndarray:
        return np.sqrt(np.bincount(place, weights=values)[has_press] / count[has_press])

    sensors = residual.shape[1]
    figure = Figure(figsize=(2.4 * sensors + 1.2, 5.6), layout="constrained")
    grid = figure.add_gridspec(2, sensors, height_ratios=(1.1, 1))
    panels = [figure.add_subplot(grid[0, k]) for k in range(sensors)]
    maps = [rms_per_place(np.sum(residual[:, k] ** 2, axis=1)) for k in range(sensors)]
    largest = float(np.quantile(np.concatenate(maps), 0.99))
    for number, (panel, values) in enumerate(zip(panels, maps, strict=True), start=1):
        shown = panel.scatter(
            *mean_place, c=values, s=8, marker="s", cmap="viridis", vmin=0, vmax=largest
        )
        share = np.sum(residual[:, number - 1] ** 2) / np.sum(recorded[:, number - 1] ** 2)
        panel.set(aspect="equal", xlabel="x, mm")
        panel.set_title(f"chip {number}: {100 * share:.0f} % unexplained", fontsize=8)
    panels[0].set_ylabel("y, mm")
    figure.colorbar(shown, ax=panels, label="left over, mT (rms)")
    axes = figure.add_subplot(grid[1, :])
    names = [f"{suspect.name} ({suspect.numbers}): {suspect.finding}" for suspect in suspects][::-1]
    gains = np.array(
        [
            [suspect.gained, suspect.gained - suspect.low, suspect.high - suspect.gained]
            for suspect in suspects
        ]
    )
    axes.barh(names, 100 * gains[::-1, 0], xerr=100 * gains[::-1, 1:].T, color="#31688e", capsize=3)
    axes.axvline(0, color="black", lw=0.8)
    axes.set_xlabel(
        "% of the change explained more, on judged places, with this assumption freed (90 % of places "
        "drawn anew)"
    )
    axes.tick_params(labelsize=8)
    figure.suptitle(
        f"{spec.name}: what is left of {len(judged)} presses, and what it points to", fontsize=11
    )
    save_figure(figure, path)
    return figure
