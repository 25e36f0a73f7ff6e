"""Maps of a score over the contact places, with the magnets and sensors that cause it.

Each face is seen from outside with its own x to the right and y up; the overview unfolds the
object about face 1, so that neighbouring edges of two maps are one edge of the object.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int

from design.files import atomic_path
from design.layout.body import face_frame, face_frames
from design.layout.pockets import magnet_bodies
from design.layout.positions import contact_grid, sensor_layout
from design.spec.object import ObjectSpec
from instobj.figures.map_scale import (
    BOUND_COLOURS,
    GAIN_COLOURS,
    MapScale,
    finite_limits,
    map_scale,
    set_plain_ticks,
)

__all__ = [
    "BOUND_COLOURS",
    "GAIN_COLOURS",
    "draw_face_heatmap",
    "draw_overview",
    "finite_limits",
]

_NET = {1: (0, 0, 0), 2: (-90, 0, -1), 3: (0, 1, 0), 4: (90, 0, 1), 5: (180, -1, 0), 6: (0, 3, 0)}
"""Face → turn of its map (degrees) and direction of its place in the net about face 1."""
_OUTWARD = {1: "+z", 2: "−y", 3: "+x", 4: "+y", 5: "−x", 6: "−z"}
_GAP_MM = 3.0
_SENSOR_EDGE_MM = 1.8
_NOTE_WIDTH = 44
_INK, _PAPER, _FRAME, _BLANK = "#1a1a1a", "#fdfdfb", "#77736b", "#efece4"
_MAGNET, _SENSOR = "#1f77d0", "#0a8f5a"


@dataclass(frozen=True)
class _Pose:
    """Where a face's map lies in the drawing: turned, then moved (mm)."""

    turn_deg: float
    centre_mm: tuple[float, float]

    def apply(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 2"]:
        c, s = np.cos(np.deg2rad(self.turn_deg)), np.sin(np.deg2rad(self.turn_deg))
        return xy_mm @ np.array([[c, s], [-s, c]]) + self.centre_mm

    def transform(self, axes: Any) -> Any:
        from matplotlib.transforms import Affine2D

        return Affine2D().rotate_deg(self.turn_deg).translate(*self.centre_mm) + axes.transData


def draw_face_heatmap(
    values: Float[np.ndarray, "place"],
    spec: ObjectSpec,
    face: int,
    title: str,
    unit: str,
    vmin: float,
    vmax: float,
    path: Path | str,
    *,
    log: bool = False,
    colours: str = BOUND_COLOURS,
) -> None:
    """One face's map with magnets, sensors and axes in mm (PNG).

    Give every face the same `vmin` and `vmax` (`finite_limits` of all faces' values). Values that
    are not finite are left blank and marked ∞. Raises as `map_scale` does.
    """
    from matplotlib.figure import Figure

    scale = map_scale(unit, vmin, vmax, log, colours)
    figure = Figure(figsize=(7.2, 6.4), dpi=150, facecolor=_PAPER, layout="constrained")
    axes = figure.add_subplot()
    pose = _Pose(0.0, (0.0, 0.0))
    mesh = _draw_face(axes, values, spec, face, scale, pose, font_size=8.5)
    half_x, half_y = face_frame(spec, face).half_extents_mm
    axes.set(xlim=(-half_x - 0.5, half_x + 0.5), ylim=(-half_y - 0.5, half_y + 0.5), aspect="equal")
    axes.set(xlabel=f"x of face {face} (mm)", ylabel=f"y of face {face} (mm)")
    axes.set_title(f"{title}\nface {face} ({_OUTWARD[face]}), seen from outside", fontsize=11)
    _tidy(axes)
    bar = figure.colorbar(mesh, ax=axes, label=scale.label, shrink=0.9)
    set_plain_ticks(bar, scale)
    figure.legend(handles=_legend(), loc="outside lower center", ncols=2, frameon=False, fontsize=9)
    _save(figure, path)


def draw_overview(
    values: Float[np.ndarray, "face place"],
    faces: Int[np.ndarray, "face"],
    spec: ObjectSpec,
    title: str,
    unit: str,
    vmin: float,
    vmax: float,
    path: Path | str,
    *,
    log: bool = True,
    colours: str = BOUND_COLOURS,
    note: str = "",
    direction_deg: Float[np.ndarray, "face place"] | None = None,
) -> None:
    """All faces in one picture and on one scale, the object unfolded about face 1 (PNG).

    `note` is printed beside the net, wrapped to the room there; `direction_deg` from each face's x
    is drawn as a line through places without a finite value. Raises as `map_scale` does.
    """
    from matplotlib.figure import Figure

    scale = map_scale(unit, vmin, vmax, log, colours)
    figure = Figure(figsize=(13.0, 13.4), dpi=120, facecolor=_PAPER)
    axes = figure.add_axes((0.02, 0.01, 0.96, 0.93))
    meshes = []
    for row, number in zip(values, faces, strict=True):
        half_x, half_y = face_frame(spec, int(number)).half_extents_mm
        pose = _net_pose(spec, int(number))
        meshes.append(_draw_face(axes, row, spec, int(number), scale, pose, font_size=7.4))
        if direction_deg is not None:
            turns = direction_deg[list(faces).index(number)]
            _draw_directions(axes, spec, turns, ~np.isfinite(row), pose)
        name = pose.apply(np.array([0.0, 0.0]))
        upward = half_y if _NET[int(number)][0] in (0, 180) else half_x
        axes.text(
            name[0], name[1] + upward - 1.0, f"face {number}  ({_OUTWARD[int(number)]})",
            ha="center", va="top", fontsize=12, fontweight="bold", color=_INK,
        )  # fmt: skip
        _draw_axes_arrows(axes, pose, half_x, half_y)
    axes.set_aspect("equal")
    axes.margins(0.01)
    axes.autoscale_view()
    axes.axis("off")
    figure.suptitle(title, fontsize=19, fontweight="bold", color=_INK, y=0.975)
    slot = figure.add_axes((0.685, 0.83, 0.28, 0.022))
    bar = figure.colorbar(meshes[0], cax=slot, orientation="horizontal")
    set_plain_ticks(bar, scale)
    slot.set_title(scale.label, fontsize=12, color=_INK)
    figure.legend(
        handles=_legend(), loc="upper left", bbox_to_anchor=(0.03, 0.88), frameon=False, fontsize=12
    )
    lines = [part for line in note.splitlines() for part in wrap(line, _NOTE_WIDTH)]
    low = 0.27 if len(faces) > 1 else 0.12
    figure.text(0.675, low, "\n".join(lines), fontsize=11.5, color=_INK, va="top", linespacing=1.6)
    _save(figure, path)


def _net_pose(spec: ObjectSpec, face: int) -> _Pose:
    turn, right, up = _NET[face]
    top, own = face_frames(spec)[0].half_extents_mm, face_frame(spec, face).half_extents_mm
    distance_x, distance_y = top[0] + own[0] + _GAP_MM, top[1] + own[0] + _GAP_MM
    return _Pose(turn, (right * distance_x, up * distance_y))


def _draw_face(
    axes: Any,
    values: Float[np.ndarray, "place"],
    spec: ObjectSpec,
    face: int,
    scale: MapScale,
    pose: _Pose,
    font_size: float,
) -> Any:
    from matplotlib.patches import Ellipse, Rectangle

    grid, move, frame = contact_grid(spec), pose.transform(axes), face_frame(spec, face)
    half_x, half_y = frame.half_extents_mm
    outline = Rectangle((-half_x, -half_y), 2 * half_x, 2 * half_y, fc=_BLANK, ec=_FRAME, lw=1.2)
    if frame.round:
        outline = Ellipse((0, 0), 2 * half_x, 2 * half_y, fc=_BLANK, ec=_FRAME, lw=1.2)
    axes.add_patch(_placed(outline, move))
    corners = pose.apply(np.array([[-half_x, -half_y], [half_x, half_y]]))
    axes.update_datalim(corners)
    shown = np.ma.masked_invalid(values.reshape(grid.shape) / 10.0**scale.exponent)
    edges = [_cell_edges(axis, spec.contact_grid.pitch_mm) for axis in (grid.x_mm, grid.y_mm)]
    mesh = axes.pcolormesh(
        *edges, shown.T, norm=scale.norm, cmap=scale.colours, transform=move, zorder=2,
        edgecolors=_PAPER, linewidth=0.6,
    )  # fmt: skip
    _draw_parts(axes, spec, face, move)
    _write_numbers(axes, pose.apply(grid.xy_mm), shown.ravel(), scale, font_size)
    return mesh


def _draw_directions(
    axes: Any,
    spec: ObjectSpec,
    direction_deg: Float[np.ndarray, "place"],
    blind: Bool[np.ndarray, "place"],
    pose: _Pose,
) -> None:
    from matplotlib.collections import LineCollection
    from matplotlib.patheffects import withStroke

    turn = np.deg2rad(direction_deg[blind])
    half = 0.45 * spec.contact_grid.pitch_mm * np.column_stack([np.cos(turn), np.sin(turn)])
    centre = contact_grid(spec).xy_mm[blind]
    ends = np.stack([pose.apply(centre - half), pose.apply(centre + half)], axis=1)
    lines = LineCollection(list(ends), colors=_INK, linewidths=1.3, zorder=4)
    lines.set_path_effects([withStroke(linewidth=2.6, foreground=_PAPER)])
    axes.add_collection(lines)


def _draw_parts(axes: Any, spec: ObjectSpec, face: int, move: Any) -> None:
    from matplotlib.patches import Circle, Rectangle
    from matplotlib.patheffects import withStroke

    edge = _SENSOR_EDGE_MM
    patches: list[Any] = []
    for body in magnet_bodies(spec)[spec.body.sensed.index(face)]:
        (x, y), (half_x, half_y) = body.centre_mm[:2], body.outline.half_mm
        if body.outline.round:
            patches.append(Circle((x, y), half_x, fill=False, ec=_MAGNET, lw=1.6))
        else:
            corner = (x - half_x, y - half_y)
            patches.append(
                Rectangle(corner, 2 * half_x, 2 * half_y, fill=False, ec=_MAGNET, lw=1.6)
            )
    patches += [
        Rectangle((x - edge / 2, y - edge / 2), edge, edge, fill=False, ec=_SENSOR, lw=2.0)
        for x, y in _sensors_in_plane(spec, face)
    ]
    for patch in patches:
        patch.set_path_effects([withStroke(linewidth=3.4, foreground=_PAPER)])
        axes.add_patch(_placed(patch, move, zorder=3))


def _placed(patch: Any, transform: Any, zorder: float = 1) -> Any:
    patch.set(transform=transform, zorder=zorder)
    return patch


def _cell_edges(centres_mm: Float[np.ndarray, "n"], pitch_mm: float) -> Float[np.ndarray, "m"]:
    return np.append(centres_mm, centres_mm[-1] + pitch_mm) - pitch_mm / 2


def _sensors_in_plane(spec: ObjectSpec, face: int) -> Float[np.ndarray, "sensor 2"]:
    layout = sensor_layout(spec)
    own = layout.position_mm[layout.face == face]
    return face_frame(spec, face).in_plane(own)[:, :2]


def _write_numbers(
    axes: Any, xy_mm: Float[np.ndarray, "place 2"], shown: Any, scale: MapScale, font_size: float
) -> None:
    from matplotlib import colormaps
    from matplotlib.patheffects import withStroke

    colours = colormaps[scale.colours](scale.norm(shown.filled(np.nan)))[:, :3]
    luminance = np.where(colours <= 0.03928, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    light = luminance @ [0.2126, 0.7152, 0.0722] > 0.18
    blank = np.ma.getmaskarray(shown)
    for place, (x, y) in enumerate(xy_mm):
        text = "∞" if blank[place] else _number(float(shown[place]))
        ink = _INK if light[place] or blank[place] else "white"
        number = axes.text(
            x, y, text, ha="center", va="center", fontsize=font_size, color=ink, zorder=6
        )
        under = _BLANK if blank[place] else colours[place]
        number.set_path_effects([withStroke(linewidth=2.2, foreground=under)])


def _number(value: float) -> str:
    digits = 2 if abs(value) < 0.995 else 1 if abs(value) < 9.95 else 0
    return f"{value:.{digits}f}"


def _draw_axes_arrows(axes: Any, pose: _Pose, half_x: float, half_y: float) -> None:
    """The face's own x and y, from its corner of smallest x and y."""
    start = np.array([1.5 - half_x, 1.5 - half_y])
    for direction, name in (((5.0, 0.0), "x"), ((0.0, 5.0), "y")):
        tail, tip = pose.apply(start), pose.apply(start + direction)
        axes.annotate(
            "", tip, tail, arrowprops={"arrowstyle": "-|>", "color": _FRAME, "lw": 1.2}, zorder=5
        )
        at = pose.apply(start + 1.28 * np.array(direction))
        axes.text(*at, name, ha="center", va="center", fontsize=9, color=_FRAME, style="italic")


def _legend() -> list[Any]:
    from matplotlib.lines import Line2D

    common: dict[str, Any] = {"ls": "", "mfc": "none"}
    return [
        Line2D([], [], marker="o", ms=13, mec=_MAGNET, mew=1.6, label="magnet", **common),
        Line2D([], [], marker="s", ms=8, mec=_SENSOR, mew=2.0, label="Hall sensor", **common),
    ]


def _tidy(axes: Any) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_facecolor(_PAPER)


def _save(figure: Any, path: Path | str) -> None:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    with atomic_path(path) as temporary:
        FigureCanvasAgg(figure).print_png(temporary, metadata={"Software": None})
