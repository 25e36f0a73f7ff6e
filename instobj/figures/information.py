"""Figures of identifiability: bounds by number of sensors, and the contact sets with the worst bounds."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from design.layout.body import face_frame
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.pockets import magnet_places, sensor_places
from design.spec.object import ObjectSpec
from estimator.information.identifiability import Identifiability
from instobj.figures.saving import save_figure
from instobj.figures.style import PALETTE, RED, draw_limit

_COLOURS = dict(enumerate(PALETTE[:3], start=1))
"""Colours by the number of contacts."""
_PANELS = {
    "own": "reading the pressed face's own sensors",
    "all": "reading the sensors of all faces",
}
_ARROW_PER_MM = 9.0
"""Length of an arrow over the change that it shows."""


def draw_identifiability(
    spec: ObjectSpec,
    rows: Sequence[Identifiability],
    path: Path | str,
) -> None:
    """Position bound of the worst contact of a set against sensors per face (PNG).

    Lines are medians of the bound over the sets, bands run from 10 to 90 %; crosses at the top stand
    where the median set is blind.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 4.8), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    finite = [r.bound_90_mm for r in rows if np.isfinite(r.bound_90_mm)]
    low, high = min(r.bound_10_mm for r in rows) / 1.5, 3 * max(finite)
    for axes, (channels, title) in zip(panels, _PANELS.items(), strict=True):
        for contacts in sorted({r.contacts for r in rows}):
            some = [r for r in rows if (r.channels, r.contacts) == (channels, contacts)]
            _draw_line(axes, some, high)
        draw_limit(axes, spec.limits.position_bound_mm)
        axes.set(yscale="log", ylim=(low, high), xlabel="Hall sensors per face", title=title)
        axes.set_xticks(sorted({r.sensors for r in rows}))
        axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
        axes.grid(alpha=0.3)
    panels[0].set_ylabel("bound of the worst contact (mm)")
    panels[0].legend(frameon=False, loc="lower left")
    figure.suptitle(
        f"k simultaneous contacts of {spec.score.force_n:g} N each on one face: position bound"
    )
    save_figure(figure, path)


def _draw_line(axes: Any, rows: Sequence[Identifiability], top_mm: float) -> None:
    contacts = rows[0].contacts
    colour = _COLOURS.get(contacts, "#555555")
    sensors = np.array([r.sensors for r in rows])
    low, middle, high = (
        np.array([getattr(r, f"bound_{name}_mm") for r in rows]) for name in ("10", "median", "90")
    )
    is_finite = np.isfinite(middle)
    label = f"{contacts} contact{'s' if contacts > 1 else ''} ({3 * contacts} unknowns)"
    axes.plot(sensors[is_finite], middle[is_finite], color=colour, marker="o", label=label)
    upper = np.where(np.isfinite(high), high, top_mm)
    axes.fill_between(
        sensors[is_finite], low[is_finite], upper[is_finite], color=colour, alpha=0.15, lw=0
    )
    offset = 0.06 * (contacts - 2)
    blind = sensors[~is_finite] + offset
    axes.plot(blind, np.full(len(blind), top_mm / 1.25), color=colour, marker="x", ls="", mew=2)
    if len(blind) and contacts == max(_COLOURS):
        axes.text(blind.max() + 0.12, top_mm / 1.25, "blind", va="center", fontsize=9, color="0.35")


def draw_blindest(spec: ObjectSpec, rows: Sequence[Identifiability], path: Path | str) -> None:
    """Contact sets with the worst bounds from own channels, and the change that signals hide (PNG)."""
    from matplotlib.figure import Figure

    count = spec.sensors.count_per_face
    some = [r for r in rows if r.channels == "own" and r.sensors == count]
    figure = Figure(figsize=(4.2 * len(some), 5.2), layout="constrained")
    panels = np.atleast_1d(np.asarray(figure.subplots(1, len(some)), dtype=object))
    for axes, row in zip(panels, some, strict=True):
        _draw_set(axes, spec, row)
    figure.suptitle(
        "Contact sets with the worst bounds: joint change of location (arrows, nine times larger) "
        "and force that changes the signals least"
    )
    save_figure(figure, path)


def _draw_set(axes: Any, spec: ObjectSpec, row: Identifiability) -> None:
    from matplotlib.patches import Circle, Polygon

    worst = row.worst
    frame = face_frame(spec, worst.face)
    axes.add_patch(Polygon(frame.border_mm(), fc="#f7f4ec", ec="0.5"))
    places = magnet_places(spec)[spec.body.sensed.index(worst.face)]
    for (x, y), size in zip(
        frame.from_plane(np.reshape(places, (-1, 2))), spec.magnets.sizes, strict=True
    ):
        axes.add_patch(Circle((x, y), size.half_mm[0], fill=False, ec="#1f77d0"))
    sensors = sensor_places(spec)[spec.body.sensed.index(worst.face)]
    for x, y in frame.from_plane(np.reshape([(x, y) for x, y, _ in sensors], (-1, 2))):
        axes.plot(x, y, marker="s", color="#0a8f5a", mfc="none", ms=7, ls="")
    grid = contact_grid(spec).xy_mm[contact_places(spec)[spec.body.sensed.index(worst.face)]]
    axes.plot(*grid.T, ls="", marker=".", ms=2, color="0.7")
    for xy, change in zip(worst.xy_mm, worst.direction, strict=True):
        axes.plot(*xy, marker="o", color=RED, ms=9)
        tip = xy + _ARROW_PER_MM * change[:2]
        axes.annotate("", tip, xy, arrowprops={"arrowstyle": "-|>", "color": "#1a1a1a", "lw": 1.8})
        axes.annotate(f"{change[2]:+.2f} N", xy, (0, -13), textcoords="offset points", ha="center",
                      va="top", fontsize=9)  # fmt: skip
    figure_text = f"condition {worst.condition:.3g}"
    if not np.isfinite(worst.condition):
        figure_text = f"rank {row.rank_least} of {row.unknowns}"
    axes.set(aspect="equal", xlabel=f"x of face {worst.face} (mm)", ylabel="y (mm)")
    axes.set_title(f"{row.contacts} contact{'s' if row.contacts > 1 else ''}: {figure_text}")
    axes.autoscale_view()
