"""Figure of loads: force against depth of every press, and the signals of all sensors."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from instobj.figures.saving import save_figure
from instobj.figures.style import PALETTE, RED

if TYPE_CHECKING:
    from fem.presses.joint import JointPress

# Dark, middle and light: the bars differ in grey too.
_AXES = (("ΔX", "#0d3b66"), ("ΔY", RED), ("ΔZ", "#f4b942"))


@dataclass(frozen=True)
class Pressed:
    """Effect of loads together: a row for each, the magnets' motions, and the way there.

    `curve` holds the joint presses on the way, the last one complete.
    `alone` holds each press by itself, empty where superposition means nothing or everything.
    """

    rows: list[dict[str, Any]]
    motion: np.ndarray
    curve: list[JointPress]
    alone: list[JointPress]


def draw_loads(spec: ObjectSpec, pressed: Pressed, change: np.ndarray, path: Path) -> None:
    """Write the figure (PNG); `change` (sensor, 3) in counts."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 3.8), layout="constrained")
    travel_axes, signal_axes = figure.subplots(1, 2, width_ratios=(1, 1.5))
    _draw_travel(travel_axes, pressed)
    _draw_signals(signal_axes, spec, change)
    save_figure(figure, path)


def _draw_travel(axes: Any, pressed: Pressed) -> None:
    """Every press of the joint load; dashed, the same press alone."""
    final = pressed.curve[-1]
    for index, tip in enumerate(final.tips):
        colour = PALETTE[index % len(PALETTE)]
        travel = [0.0, *(press.depth_mm[index] for press in pressed.curve)]
        force = [0.0, *(press.force_n[index] for press in pressed.curve)]
        label = f"face {tip.face} ({tip.x_mm:g}, {tip.y_mm:g}) mm"
        axes.plot(travel, force, color=colour, label=label)
        shear = [0.0, *(np.hypot(*press.shear_n[index]) for press in pressed.curve)]
        if any(shear):
            axes.plot(travel, shear, ":", color=colour, label="shear force")
        if pressed.alone:
            alone = pressed.alone[index]
            axes.plot(alone.depth_mm, alone.force_n, "x", color=colour, ms=7)
    if pressed.alone:
        axes.plot([], [], "x", color="#555555", label="the same press alone")
    axes.set(xlabel="indentation depth (mm)", ylabel="force (N)", title="Force and depth")
    axes.set_xlim(0)
    axes.set_ylim(0)
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, fontsize=8)


def _draw_signals(axes: Any, spec: ObjectSpec, change: np.ndarray) -> None:
    faces = sensor_layout(spec).face
    place = np.arange(len(faces)) + 0.8 * (faces - 1)
    for index, (name, colour) in enumerate(_AXES):
        axes.bar(place + 0.27 * (index - 1), change[:, index], 0.25, color=colour, label=name)
    for face in np.unique(faces):
        face_places = place[faces == face]
        above = axes.get_xaxis_transform()
        axes.text(face_places.mean(), 1.01, f"face {face}", transform=above, ha="center")
    numbers = [int(np.sum(faces[:index] == face)) + 1 for index, face in enumerate(faces)]
    axes.set_xticks(place, [f"S{number}" for number in numbers], fontsize=8)
    axes.axhline(0, color="black", lw=0.6)
    axes.set(ylabel="change of signal (counts)")
    axes.set_title("Signals of the sensors", pad=18)
    axes.grid(axis="y", alpha=0.3)
    axes.legend(frameon=False, ncols=3, fontsize=8)
