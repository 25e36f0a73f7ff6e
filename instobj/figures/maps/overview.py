"""Overview of a map: all faces in one picture, the object unfolded about face 1.

Neighbouring edges of two maps are one edge of the object. Scale, legend and caption have a column
next to the net, as wide and as high as they need: nothing lies on a map, whatever the body.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.places.coverage import covered_share
from design.spec.object import ObjectSpec
from instobj.figures.maps.heatmaps import (
    FRAME,
    INK,
    OUTWARD,
    PAPER,
    Pose,
    draw_ground,
    draw_values,
    half_mm,
    legend_handles,
)
from instobj.figures.maps.scale import (
    BOUND_COLOURS,
    MapScale,
    finite_limits,
    map_scale,
    set_plain_ticks,
)
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_NET = {1: (0, 0, 0), 2: (-90, 0, -1), 3: (0, 1, 0), 4: (90, 0, 1), 5: (180, -1, 0), 6: (0, 0, 2)}
"""Face → turn of its map (degrees) and direction of its place in the net about face 1."""
GAP_MM = 4.0
_GAP_INCHES = 0.36
"""At least, between maps: the faces' names and axes stand there."""
_CELL_INCHES = 0.26
_LARGEST_NET_INCHES = 15.0
_COLUMN_INCHES = 3.9
_MARGIN_INCHES = 0.3
_TITLE_POINTS, _CAPTION_POINTS = 16.0, 11.5
_CAPTION_WIDTH, _LINE_INCHES, _TITLE_LINE_INCHES = 42, 0.26, 0.33
_ABOVE_CAPTION_INCHES = 2.1
"""Height of scale and legend in the column."""
_NAME_POINTS = 10.5
_ARROW_MM = 5.0


@dataclass(frozen=True)
class FaceMap:
    """A score of every contact location of the sensed faces, and how it is drawn.

    Attributes
    ----------
    values : (face, place); what is not finite stays blank
    limits : ends of the scale, by default the least and the largest finite value
    note : caption, wrapped to its column
    direction_deg : (face, place), from each face's x, drawn as a line through blank places
    marked : (face, place), places that get a cross
    """

    title: str
    unit: str
    values: Float[np.ndarray, "face place"]
    log: bool = True
    colours: str = BOUND_COLOURS
    limits: tuple[float, float] | None = None
    note: str = ""
    direction_deg: Float[np.ndarray, "face place"] | None = None
    marked: Bool[np.ndarray, "face place"] | None = None

    @property
    def scale(self) -> MapScale:
        """Colours of all faces. Raises InputError as `map_scale` and `finite_limits` do."""
        limits = self.limits or finite_limits(self.values)
        return map_scale(self.unit, *limits, self.log, self.colours)


@dataclass(frozen=True)
class _Page:
    """The figure, axes in mm for the net, inches for a mm, and where the column begins (inches)."""

    figure: Any
    axes: Any
    inches_per_mm: float
    column_left: float
    column_top: float

    def place(self, left_inches: float, bottom: float, width: float, height: float) -> Any:
        """A rectangle in inches as shares of the figure."""
        across, up = self.figure.get_size_inches()
        return left_inches / across, bottom / up, width / across, height / up


def draw_overview(spec: ObjectSpec, face_map: FaceMap, path: Path | str) -> Figure:
    """All faces in one picture and on one scale (PNG).

    Raises
    ------
    InputError
        No value is finite, or the limits of the scale are out of order.
    """
    scale = face_map.scale
    covered = f"Contact locations cover {100 * covered_share(spec):.0f} % of the sensed surface."
    blank = contact_places(spec) & ~np.isfinite(face_map.values)
    direction_text = ", along the line" if face_map.direction_deg is not None else ""
    blank_text = (
        f"Blank: blind, or beyond the deepest press{direction_text}." if blank.any() else ""
    )
    lines = [*face_map.note.splitlines(), blank_text, covered]
    caption = [part for line in lines for part in wrap(line, _CAPTION_WIDTH)]
    page = _page(spec, face_map.title, len(caption))
    meshes = []
    for index, (row, number) in enumerate(zip(face_map.values, spec.body.sensed, strict=True)):
        pose = net_pose(spec, number, _gap_mm(page.inches_per_mm))
        draw_ground(page.axes, spec, number, pose)
        meshes.append(draw_values(page.axes, row, spec, number, scale, pose))
        if face_map.direction_deg is not None:
            draw_directions(page.axes, spec, face_map.direction_deg[index], blank[index], pose)
        if face_map.marked is not None:
            _draw_crosses(page.axes, spec, face_map.marked[index], pose)
        _name(page.axes, spec, number, pose)
        _draw_axes_arrows(page, spec, number, pose)
    _fill_column(page, meshes[0], scale, caption)
    save_figure(page.figure, path)
    return page.figure


def net_pose(spec: ObjectSpec, face: int, gap_mm: float = GAP_MM) -> Pose:
    """Return where a face lies in the net about face 1; face 6 joins face 4."""
    turn, right, up = _NET[face]
    top, face_half = half_mm(spec, spec.body.sensed[0]), half_mm(spec, face)
    if face == 6:
        side = half_mm(spec, 4)[0]
        return Pose(turn, (0.0, top[1] + 2 * side + face_half[1] + 2 * gap_mm))
    return Pose(
        turn, (right * (top[0] + face_half[0] + gap_mm), up * (top[1] + face_half[0] + gap_mm))
    )


def _page(spec: ObjectSpec, title: str, caption_lines: int) -> _Page:
    """A figure as large as net, column and title need."""
    from matplotlib.figure import Figure

    plain_low, plain_high = _net_ends(spec, GAP_MM)
    inches_per_mm = min(
        _CELL_INCHES / spec.contact_grid.pitch_mm,
        _LARGEST_NET_INCHES / float((plain_high - plain_low).max()),
    )
    gap = _gap_mm(inches_per_mm)
    low, high = _net_ends(spec, gap)
    low, high = low - gap, high + gap
    net = (high - low) * inches_per_mm
    across = net[0] + _COLUMN_INCHES + 2 * _MARGIN_INCHES
    titled = wrap(title, int(across * 72 / (0.62 * _TITLE_POINTS)))
    body = max(net[1], _ABOVE_CAPTION_INCHES + _LINE_INCHES * caption_lines)
    up = body + _TITLE_LINE_INCHES * len(titled) + 2 * _MARGIN_INCHES
    figure = Figure(figsize=(across, up), facecolor=PAPER)
    top = _MARGIN_INCHES + body
    axes = figure.add_axes(
        (_MARGIN_INCHES / across, (top - net[1]) / up, net[0] / across, net[1] / up)
    )
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))
    axes.axis("off")
    figure.text(
        0.5, 1 - 0.6 * _MARGIN_INCHES / up, "\n".join(titled), ha="center", va="top",
        fontsize=_TITLE_POINTS, fontweight="bold", color=INK,
    )  # fmt: skip
    return _Page(figure, axes, inches_per_mm, net[0] + 1.4 * _MARGIN_INCHES, top)


def _gap_mm(inches_per_mm: float) -> float:
    return max(GAP_MM, _GAP_INCHES / inches_per_mm)


def _net_ends(
    spec: ObjectSpec, gap_mm: float
) -> tuple[Float[np.ndarray, "2"], Float[np.ndarray, "2"]]:
    """Least and greatest x and y (mm) of all maps."""
    corners = []
    for number in spec.body.sensed:
        half = np.array(half_mm(spec, number))
        corners.append(net_pose(spec, number, gap_mm).apply(np.stack([-half, half])))
    all_corners = np.concatenate(corners)
    return all_corners.min(axis=0), all_corners.max(axis=0)


def _fill_column(page: _Page, mesh: Any, scale: MapScale, caption: list[str]) -> None:
    """Colour scale, legend and caption, from the top."""
    width = _COLUMN_INCHES - _MARGIN_INCHES
    slot = page.figure.add_axes(
        page.place(page.column_left, page.column_top - 0.7, 0.92 * width, 0.24)
    )
    bar = page.figure.colorbar(mesh, cax=slot, orientation="horizontal")
    set_plain_ticks(bar, scale)
    slot.set_title(scale.label, fontsize=12, color=INK)
    legend_left, legend_top, *_ = page.place(page.column_left, page.column_top - 1.1, 0, 0)
    page.figure.legend(
        handles=legend_handles(), loc="upper left", bbox_to_anchor=(legend_left, legend_top),
        frameon=False, fontsize=12, borderaxespad=0,
    )  # fmt: skip
    _, caption_top, *_ = page.place(0, page.column_top - _ABOVE_CAPTION_INCHES, 0, 0)
    page.figure.text(
        legend_left, caption_top, "\n".join(caption), fontsize=_CAPTION_POINTS, color=INK, va="top",
        linespacing=1.5,
    )  # fmt: skip


def _name(axes: Any, spec: ObjectSpec, face: int, pose: Pose) -> None:
    """The face's name above its map."""
    half_x, half_y = half_mm(spec, face)
    upward = half_y if pose.turn_deg in (0, 180) else half_x
    axes.annotate(
        f"face {face} ({OUTWARD[face]})", (pose.centre_mm[0], pose.centre_mm[1] + upward), (0, 3),
        textcoords="offset points", ha="center", va="bottom", fontsize=_NAME_POINTS,
        fontweight="bold", color=INK,
    )  # fmt: skip


def draw_directions(
    axes: Any,
    spec: ObjectSpec,
    direction_deg: Float[np.ndarray, "place"],
    blind: Bool[np.ndarray, "place"],
    pose: Pose,
) -> None:
    from matplotlib.collections import LineCollection
    from matplotlib.patheffects import withStroke

    turn = np.deg2rad(direction_deg[blind])
    half = 0.45 * spec.contact_grid.pitch_mm * np.column_stack([np.cos(turn), np.sin(turn)])
    centre = contact_grid(spec).xy_mm[blind]
    ends = np.stack([pose.apply(centre - half), pose.apply(centre + half)], axis=1)
    lines = LineCollection(list(ends), colors=INK, linewidths=1.3, zorder=4)
    lines.set_path_effects([withStroke(linewidth=2.6, foreground=PAPER)])
    axes.add_collection(lines)


def _draw_crosses(
    axes: Any, spec: ObjectSpec, marked: Bool[np.ndarray, "place"], pose: Pose
) -> None:
    """Crosses in the cells of marked places; squares would look like sensors."""
    from matplotlib.collections import LineCollection
    from matplotlib.patheffects import withStroke

    half = 0.22 * spec.contact_grid.pitch_mm
    strokes = half * np.array([[[-1, -1], [1, 1]], [[-1, 1], [1, -1]]])
    centres = contact_grid(spec).xy_mm[marked]
    lines = [pose.apply(centre + stroke) for centre in centres for stroke in strokes]
    crosses = LineCollection(lines, colors=PAPER, linewidths=1.2, zorder=5)
    crosses.set_path_effects([withStroke(linewidth=2.4, foreground=INK)])
    axes.add_collection(crosses)


def _draw_axes_arrows(page: _Page, spec: ObjectSpec, face: int, pose: Pose) -> None:
    """The face's own x and y, outside its corner of smallest x and y."""
    out = _gap_mm(page.inches_per_mm) / 3
    start = -np.array(half_mm(spec, face)) - out
    for direction, name in (((_ARROW_MM, 0.0), "x"), ((0.0, _ARROW_MM), "y")):
        tail, tip = pose.apply(start), pose.apply(start + direction)
        arrow = {"arrowstyle": "-|>", "color": FRAME, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
        page.axes.annotate("", tip, tail, arrowprops=arrow, zorder=5)
        label_mm = pose.apply(start + 1.28 * np.array(direction))
        page.axes.text(
            *label_mm, name, ha="center", va="center", fontsize=9, color=FRAME, style="italic"
        )
