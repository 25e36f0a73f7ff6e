"""One face of a map: the score of every contact location, with the magnets and sensors that cause it.

Each face is seen from outside with its own x to the right and y up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from design.layout.body import face_frame
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.places.positions import sensor_layout
from design.layout.pockets import magnet_bodies
from design.spec.object import ObjectSpec
from instobj.figures.maps.scale import MapScale

OUTWARD = {1: "+z", 2: "−y", 3: "+x", 4: "+y", 5: "−x", 6: "−z"}
_SENSOR_EDGE_MM = 1.8
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
) -> Any:
    """Draw the coloured mesh with the parts upon it, and return the mesh.

    Places without a finite value stay blank.
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
    _draw_parts(axes, spec, face, move)
    return mesh


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


def _draw_parts(axes: Any, spec: ObjectSpec, face: int, move: Any) -> None:
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
