"""Predicted compared with recorded change of every chip over a pad, from presses of one travel."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from estimator.calibration.known_travel.fit import Fitted
    from estimator.calibration.known_travel.model import TravelModel
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
