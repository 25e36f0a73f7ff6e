"""Maps of a score over the contact locations, with the magnets and sensors that cause it.

Each face is seen from outside with its own x to the right and y up.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float

from design.layout.body import face_frame
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.places.coverage import covered_shares
from design.layout.places.positions import sensor_layout
from design.layout.pockets import magnet_bodies
from design.spec.object import ObjectSpec
from instobj.figures.maps.scale import (
    MapScale,
    set_plain_ticks,
)
from instobj.figures.saving import drawn, save_drawn

if TYPE_CHECKING:
    from matplotlib.backends.backend_agg import FigureCanvasAgg

OUTWARD = {1: "+z", 2: "−y", 3: "+x", 4: "+y", 5: "−x", 6: "−z"}
_SENSOR_EDGE_MM = 1.8
PICTURE_INCHES = 7.2, 6.5
MAP_INCHES, BAR_INCHES = (0.7, 0.95, 5.05, 5.05), (5.85, 1.2, 0.25, 4.55)
"""Left, bottom, width, height of one face's map and of its scale; a layout engine would ask every
text for its size, which takes as long as drawing."""
_AROUND_BAR_INCHES = 5.8, 1.05, 7.2, 5.98
"""Left, bottom, right and top of the scale with its numbers and its label."""
_FACE_INCHES = 4.6, 4.6
"""Room for the face within its map."""
_LARGEST_FONT, SMALLEST_FONT = 8.5, 4.0
"""Points; numbers that do not fit their cell at the smallest are left out."""
_DIGIT_EM, _POINT_EM, _USUAL_EM = 0.64, 0.32, 2.24
"""Widths of a digit, of a decimal point and of a number such as 0.12, in font sizes."""
INK, PAPER, FRAME, BLANK = "#1a1a1a", "#fdfdfb", "#77736b", "#efece4"
_NOT_COVERED, _HATCH = "////", "#aab2bd"
_MAGNET, _SENSOR = "#1f77d0", "#0a8f5a"


@dataclass(frozen=True)
class Pose:
    """Pose of a face's map in the drawing: turned, then moved (mm)."""

    turn_deg: float
    centre_mm: tuple[float, float]

    def apply(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 2"]:
        c, s = np.cos(np.deg2rad(self.turn_deg)), np.sin(np.deg2rad(self.turn_deg))
        return xy_mm @ np.array([[c, s], [-s, c]]) + self.centre_mm

    def transform(self, axes: Any) -> Any:
        from matplotlib.transforms import Affine2D

        return Affine2D().rotate_deg(self.turn_deg).translate(*self.centre_mm) + axes.transData


class FaceMaps:
    """Pictures of single faces with magnets, sensors and axes in mm (PNG).

    What all scores of a face share is drawn once, and each score's scale once: they are copied into
    the pictures, pixel by pixel.
    """

    def __init__(self, spec: ObjectSpec) -> None:
        self._spec = spec
        self._grounds: dict[tuple[int, bool], _Ground] = {}
        self._bars: dict[MapScale, Any] = {}

    def draw(
        self,
        values: Float[np.ndarray, "place"],
        face: int,
        title: str,
        scale: MapScale,
        path: Path | str,
    ) -> None:
        """One face's map. Give every face the same scale (`map_scale` of `finite_limits` of all
        faces' values). Values that are not finite are left blank and marked ∞."""
        key = face, bool(np.isinf(values).any())
        if key not in self._grounds:
            self._grounds[key] = _ground(self._spec, *key)
        ground = self._grounds[key]
        if scale not in self._bars:
            self._bars[scale] = _bar(scale)
        for pixels in (ground.pixels, self._bars[scale]):
            ground.canvas.restore_region(pixels)
        covered = 100 * covered_shares(self._spec)[self._spec.body.sensed.index(face)]
        face_text = f"face {face} ({OUTWARD[face]}), seen from outside; {covered:.0f} % covered"
        ground.axes.set_title(
            f"{title}\n{face_text}", fontsize=11, y=1.0
        )  # given, y is not looked for
        place = Pose(0.0, (0.0, 0.0)), ground.inches_per_mm
        added = draw_values(ground.axes, values, self._spec, face, scale, *place)
        for artist in (*added, ground.axes.title):
            ground.axes.draw_artist(artist)
        save_drawn(ground.canvas, path)
        for artist in added:
            artist.remove()


@dataclass(frozen=True)
class _Ground:
    """Ground that pictures of a face share, and its `pixels`."""

    canvas: FigureCanvasAgg
    axes: Any
    inches_per_mm: float
    pixels: Any


def _ground(spec: ObjectSpec, face: int, some_blank: bool) -> _Ground:
    from matplotlib.figure import Figure

    half_x, half_y = half_mm(spec, face)
    figure = Figure(figsize=PICTURE_INCHES, facecolor=PAPER)
    axes = figure.add_axes(picture_share(MAP_INCHES))
    draw_ground(axes, spec, face, Pose(0.0, (0.0, 0.0)))
    axes.set(xlim=(-half_x - 0.5, half_x + 0.5), ylim=(-half_y - 0.5, half_y + 0.5), aspect="equal")
    axis_note = "" if face_frame(spec, face).flat else " along the surface"
    axes.set(xlabel=f"x of face {face}{axis_note} (mm)", ylabel=f"y of face {face}{axis_note} (mm)")
    _tidy(axes)
    handles = [*legend_handles(), *([_no_value_handle()] if some_blank else [])]
    figure.legend(handles=handles, loc="lower center", ncols=2, frameon=False, fontsize=9)
    canvas = drawn(figure)
    inches_per_mm = min(_FACE_INCHES[0] / half_x, _FACE_INCHES[1] / half_y) / 2
    return _Ground(canvas, axes, inches_per_mm, canvas.copy_from_bbox(figure.bbox))


def _bar(scale: MapScale) -> Any:
    """Pixels of a scale next to its map."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure
    from matplotlib.transforms import Bbox

    figure = Figure(figsize=PICTURE_INCHES, facecolor=PAPER)
    axes, colours = (
        figure.add_axes(picture_share(BAR_INCHES)),
        ScalarMappable(scale.norm, scale.colours),
    )
    set_plain_ticks(figure.colorbar(colours, cax=axes, label=scale.label), scale)
    canvas = drawn(figure)
    around = figure.dpi * np.array(_AROUND_BAR_INCHES)
    return canvas.copy_from_bbox(Bbox(around.reshape(2, 2)))


def picture_share(inches: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    """A rectangle of the picture, as shares of its width and height."""
    width, height = PICTURE_INCHES
    left_inches, bottom, wide, high = inches
    return left_inches / width, bottom / height, wide / width, high / height


def draw_ground(axes: Any, spec: ObjectSpec, face: int, pose: Pose) -> None:
    """Draw what lies under the map: the face, hatched where it has no contact location."""
    from matplotlib.patches import Polygon

    move, frame = pose.transform(axes), face_frame(spec, face)
    half = np.array(half_mm(spec, face))
    outline = Polygon(frame.border_mm(), fc=BLANK, ec=FRAME, lw=1.2)
    outline.set(hatch=_NOT_COVERED, hatchcolor=_HATCH, hatch_linewidth=0.6)
    axes.add_artist(_placed(outline, move))
    has_place = contact_places(spec)[spec.body.sensed.index(face)]
    for covered in _covered_rectangles(spec, has_place):
        axes.add_artist(_placed(covered, move, zorder=1.5))
    axes.update_datalim(pose.apply(np.stack([-half, half])))


def draw_values(
    axes: Any,
    values: Float[np.ndarray, "place"],
    spec: ObjectSpec,
    face: int,
    scale: MapScale,
    pose: Pose,
    inches_per_mm: float,
    smallest_font: float = SMALLEST_FONT,
) -> list[Any]:
    """Draw the coloured mesh, the parts and the numbers, and return them in this order.

    Numbers that would be smaller than `smallest_font` (points) in their cells are left out.
    """
    grid, move = contact_grid(spec), pose.transform(axes)
    has_place = contact_places(spec)[spec.body.sensed.index(face)]
    shown = np.ma.masked_invalid(values.reshape(grid.shape) / 10.0**scale.exponent)
    edges = [_cell_edges(axis, spec.contact_grid.pitch_mm) for axis in (grid.x_mm, grid.y_mm)]
    outlines = [
        PAPER if is_place else "none" for is_place in has_place.reshape(grid.shape).T.ravel()
    ]
    mesh = axes.pcolormesh(
        *edges, shown.T, norm=scale.norm, cmap=scale.colours, transform=move, zorder=2,
        edgecolors=PAPER if has_place.all() else outlines, linewidth=0.6,
    )  # fmt: skip
    parts = _draw_parts(axes, spec, face, move)
    cell_inches = spec.contact_grid.pitch_mm * inches_per_mm
    values_there, places = shown.ravel()[has_place], pose.apply(grid.xy_mm[has_place])
    numbers = _write_numbers(axes, places, values_there, scale, cell_inches, smallest_font)
    return [mesh, *parts, *numbers]


def half_mm(spec: ObjectSpec, face: int) -> tuple[float, float]:
    """Half the room that a face's map takes, x and y; on a curved face along the surface."""
    along_x, along_y = abs(face_frame(spec, face).lengths_mm).max(axis=0).tolist()
    return along_x, along_y


def _covered_rectangles(spec: ObjectSpec, has_place: Bool[np.ndarray, "place"]) -> list[Any]:
    """Cells of a face's contact locations: runs along y, equal neighbours joined along x."""
    from matplotlib.patches import Rectangle

    grid, pitch = contact_grid(spec), spec.contact_grid.pitch_mm
    rectangles, columns = [], has_place.reshape(grid.shape)
    for x, column in zip(grid.x_mm, columns, strict=True):
        (used,) = np.nonzero(column)
        for run in np.split(used, np.flatnonzero(np.diff(used) > 1) + 1) if len(used) else ():
            corner = (float(x) - pitch / 2, float(grid.y_mm[run[0]]) - pitch / 2)
            high = len(run) * pitch
            previous = rectangles[-1] if rectangles else None
            if previous and previous.get_y() == corner[1] and previous.get_height() == high:
                previous.set_width(previous.get_width() + pitch)
            else:
                rectangles.append(Rectangle(corner, pitch, high, fc=BLANK, ec="none"))
    return rectangles


def _draw_parts(axes: Any, spec: ObjectSpec, face: int, move: Any) -> list[Any]:
    from matplotlib.patches import Circle, Rectangle
    from matplotlib.patheffects import withStroke

    edge, frame = _SENSOR_EDGE_MM, face_frame(spec, face)
    patches: list[Any] = []
    for body in magnet_bodies(spec)[spec.body.sensed.index(face)]:
        (x, y), (half_x, half_y) = frame.from_plane(body.centre_mm[:2]), body.outline.half_mm
        if body.outline.round:
            patches.append(Circle((x, y), half_x, fill=False, ec=_MAGNET, lw=1.6))
        else:
            corner = (x - half_x, y - half_y)
            patches.append(
                Rectangle(corner, 2 * half_x, 2 * half_y, fill=False, ec=_MAGNET, lw=1.6)
            )
    patches += [
        Rectangle((x - edge / 2, y - edge / 2), edge, edge, fill=False, ec=_SENSOR, lw=2.0)
        for x, y in _sensors_under(spec, face)
    ]
    for patch in patches:
        patch.set_path_effects([withStroke(linewidth=3.4, foreground=PAPER)])
        axes.add_artist(_placed(patch, move, zorder=3))
    return patches


def _placed(patch: Any, transform: Any, zorder: float = 1) -> Any:
    """The patch, moved by a transform; it lies within the axes, so that layouts need not ask."""
    patch.set(transform=transform, zorder=zorder, in_layout=False)
    return patch


def _cell_edges(centres_mm: Float[np.ndarray, "n"], pitch_mm: float) -> Float[np.ndarray, "m"]:
    return np.append(centres_mm, centres_mm[-1] + pitch_mm) - pitch_mm / 2


def _sensors_under(spec: ObjectSpec, face: int) -> Float[np.ndarray, "sensor 2"]:
    layout, frame = sensor_layout(spec), face_frame(spec, face)
    positions_mm = layout.position_mm[layout.face == face]
    return frame.from_plane(frame.plane_coordinates(positions_mm)[:, :2])


def _write_numbers(
    axes: Any,
    xy_mm: Float[np.ndarray, "place 2"],
    shown: Any,
    scale: MapScale,
    cell_inches: float,
    smallest_font: float,
) -> list[Any]:
    """Each place's value in its cell, in the size that the longest of them allows."""
    from matplotlib import colormaps
    from matplotlib.collections import PathCollection
    from matplotlib.colors import to_rgb
    from matplotlib.transforms import Affine2D

    colours = colormaps[scale.colours](scale.norm(shown.filled(np.nan)))[:, :3]
    luminance = np.where(colours <= 0.03928, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    light = luminance @ [0.2126, 0.7152, 0.0722] > 0.18
    blank = np.ma.getmaskarray(shown)
    texts = _texts(shown)
    font_size = _fitting_font(texts, cell_inches)
    if font_size < smallest_font:
        return []
    inks = [INK if pale else "white" for pale in light | blank]
    under = np.where(blank[:, None], to_rgb(BLANK), colours)
    size = Affine2D().scale(font_size / 72) + axes.figure.dpi_scale_trans
    collections = []
    for edges in ({"edgecolors": under, "linewidths": 2.2}, {"linewidths": 0}):
        numbers = PathCollection(
            [outline_of(text) for text in texts], facecolors=inks, offsets=xy_mm,
            offset_transform=axes.transData, transform=size, zorder=6, clip_on=False, **edges,
        )  # fmt: skip
        numbers.set_in_layout(False)
        axes.add_collection(numbers, autolim=False)
        collections.append(numbers)
    return collections


@functools.cache
def outline_of(text: str) -> Any:
    """Glyphs of a number, one point high and centred.

    Drawn together as outlines they take a tenth of the time of as many texts with borders.
    """
    from matplotlib.textpath import TextPath
    from matplotlib.transforms import Affine2D

    path = TextPath((0, 0), text, size=1)
    box = path.get_extents()
    return Affine2D().translate(-(box.x0 + box.x1) / 2, -(box.y0 + box.y1) / 2).transform_path(path)


def fitting_font(
    values: Float[np.ndarray, "face place"], scale: MapScale, cell_inches: float
) -> float:
    """Points of the numbers of all faces together, as large as their cells allow."""
    return _fitting_font(
        _texts(np.ma.masked_invalid(values.ravel() / 10.0**scale.exponent)), cell_inches
    )


def _texts(shown: Any) -> list[str]:
    hidden = np.ma.getmaskarray(shown)
    return ["∞" if no else _number(float(value)) for value, no in zip(shown, hidden, strict=True)]


def _fitting_font(texts: list[str], cell_inches: float) -> float:
    """Size in points at which the longest number takes five sixths of a cell's width at most."""
    lengths = [_DIGIT_EM * len(text) - (_DIGIT_EM - _POINT_EM) * text.count(".") for text in texts]
    return min(_LARGEST_FONT, 5 / 6 * 72 * cell_inches / max(_USUAL_EM, *lengths))


def _number(value: float) -> str:
    digits = 2 if abs(value) < 0.995 else 1 if abs(value) < 9.95 else 0
    return f"{value:.{digits}f}"


def legend_handles() -> list[Any]:
    """Marks of a magnet and of a sensor, for a legend."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    common: dict[str, Any] = {"ls": "", "mfc": "none"}
    return [
        Line2D([], [], marker="o", ms=13, mec=_MAGNET, mew=1.6, label="magnet", **common),
        Line2D([], [], marker="s", ms=8, mec=_SENSOR, mew=2.0, label="Hall sensor", **common),
        Patch(
            fc=BLANK, ec=FRAME, hatch=_NOT_COVERED, hatchcolor=_HATCH, label="no contact location"
        ),
    ]


def _no_value_handle() -> Any:
    from matplotlib.lines import Line2D

    marks: dict[str, Any] = {"marker": "$\\infty$", "mfc": INK, "mec": "none", "ms": 11}
    return Line2D([], [], ls="", label="beyond the deepest press, or blind", **marks)


def _tidy(axes: Any) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_facecolor(PAPER)
