"""Curves of the report: force against depth, and signal against force, from the border inwards."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.layout.places.contact_grid import grid_places_in_lattice
from design.layout.places.contact_places import contact_places
from design.layout.places.measures import place_measures
from design.spec.object import ObjectSpec
from estimator.information.weak_areas import thirds_of
from instobj.figures.saving import save_figure
from instobj.figures.style import BLUE, GREEN, RED

if TYPE_CHECKING:
    from estimator.signals.presses import Signals

_THIRDS = {
    1: (("all locations", BLUE),),
    2: (("nearer the border", RED), ("inner", BLUE)),
    3: (("third nearest the border", RED), ("between", GREEN), ("innermost third", BLUE)),
}
"""Names and colours of the thirds of the contact locations; faces with few rows have fewer of them."""


def draw_press_curves(spec: ObjectSpec, signals: Signals, path: Path) -> None:
    """Median over the locations of a third, by their distance from the border, as the edge ratio has it; the
    band from least to most (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.6), layout="constrained")
    force_axes, signal_axes = figure.subplots(1, 2)
    has_place, lattice_places = contact_places(spec), grid_places_in_lattice(spec)
    force = signals.force_n[:, lattice_places][has_place]
    size = _whitened_size(spec, signals)[:, lattice_places][has_place]
    thirds = thirds_of(place_measures(spec).border_mm[has_place])
    for inside, (label, colour) in zip(thirds, _THIRDS[len(thirds)], strict=True):
        _band(force_axes, signals.depth_mm, force[inside], colour, label)
        mean_force = np.median(force[inside], axis=0)
        _band(signal_axes, mean_force, size[inside], colour, label)
    force_axes.set(xlabel="indentation depth (mm)", ylabel="force (N)", title="Force and depth")
    signal_axes.set(
        xlabel="force (N, median of the third)",
        ylabel="signal change (σ of a fresh baseline)",
        title="Signal of the face's own sensors",
    )
    for axes in (force_axes, signal_axes):
        axes.grid(alpha=0.3)
        axes.set_xlim(0)
        axes.set_ylim(0)
        axes.legend(frameon=False)
    save_figure(figure, path)


def _band(axes: Any, x: np.ndarray, flat: np.ndarray, colour: str, label: str) -> None:
    x = np.append(0, x)
    low, middle, high = (np.append(0, q) for q in np.quantile(flat, (0, 0.5, 1), axis=0))
    axes.plot(x, middle, color=colour, label=label)
    axes.fill_between(x, low, high, color=colour, alpha=0.18, lw=0)


def _whitened_size(spec: ObjectSpec, signals: Signals) -> np.ndarray:
    """Length of each face's own signal change in standard deviations of a fresh baseline."""
    from design.layout.places.positions import sensor_layout

    sigma = np.hypot(np.asarray(spec.sensors.noise_counts), spec.sensors.zeroing_counts)
    owner = sensor_layout(spec).face
    sizes = []
    for index, face in enumerate(signals.faces):
        whitened = signals.delta_counts[index][:, :, owner == face] / sigma
        sizes.append(np.sqrt((whitened**2).sum(axis=(-2, -1))))
    return np.stack(sizes)
