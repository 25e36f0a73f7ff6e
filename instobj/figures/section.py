"""Section through the deformed shell under a press, at true scale."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from instobj.figures.saving import save_figure

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from fem.large_strain.results import LargeStrainPress
    from fem.presses.shape import DeformedShape

_BELOW_MM = 16.0
_ABOVE_MM = 6.0


@dataclass(frozen=True)
class SectionPanel:
    """One press to draw: its shape, where it is, and the tip (radius None: not drawn)."""

    title: str
    shape: DeformedShape
    frame: FaceFrame
    xy_mm: tuple[float, float]
    depth_mm: float
    tip_radius_mm: float | None


@dataclass(frozen=True)
class _Cut:
    """A section: points along x and outwards (mm) where the press has put them, triangles."""

    points_mm: np.ndarray
    triangles: np.ndarray
    magnet: np.ndarray
    size_mm: np.ndarray


def draw_sections(panels: list[SectionPanel], path: Path) -> None:
    """Each press cut along the face's x through the tip, coloured by displacement (PNG).

    The material plane is cut before the press and drawn where it went: what lies behind it may
    cover it slightly. One colour scale for all panels.
    """
    from matplotlib.figure import Figure

    sizes = [np.linalg.norm(panel.shape.displacement_mm, axis=1) for panel in panels]
    largest = max(float(size.max()) for size in sizes)
    figure = Figure(figsize=(8.2, 3.5 * len(panels)), layout="constrained")
    axes = figure.subplots(len(panels), 1, squeeze=False)[:, 0]
    images = [
        _draw(panel_axes, panel, largest) for panel, panel_axes in zip(panels, axes, strict=True)
    ]
    figure.colorbar(images[0], ax=list(axes), label="displacement (mm)", shrink=0.8)
    save_figure(figure, path)


def draw_press_sections(spec: ObjectSpec, press: LargeStrainPress, path: Path) -> None:
    """Sections of both models at the last depth (PNG)."""
    frame = next(frame for frame in face_frames(spec) if frame.number == press.face)
    depth, place = press.converged_depth_mm, (press.x_mm, press.y_mm)
    models = ((f"{press.material.name}, large deformation", press.shape, press.force_n[-1]),
              ("linear, small strain", press.linear_shape, press.linear_force_n[-1]))  # fmt: skip
    draw_sections(
        [
            SectionPanel(
                f"Face {press.face}, ({place[0]:g}, {place[1]:g}) mm, {depth:g} mm deep: {name}, "
                f"{force:.2f} N",
                shape,
                frame,
                place,
                depth,
                spec.indenter.radius_mm,
            )
            for name, shape, force in models
        ],
        path,
    )


def _draw(axes: Any, panel: SectionPanel, largest_mm: float) -> Any:
    from matplotlib.collections import LineCollection
    from matplotlib.patches import Circle

    cut, (outline_before, outline_after) = _cut(panel), _outline(panel)
    silicone, inside = cut.triangles[cut.magnet < 0], cut.triangles[cut.magnet >= 0]
    image = axes.tripcolor(
        *cut.points_mm.T, silicone, cut.size_mm, shading="gouraud", cmap="viridis", vmin=0,
        vmax=largest_mm,
    )  # fmt: skip
    if len(inside):
        zeros = np.zeros(len(cut.points_mm))
        axes.tripcolor(*cut.points_mm.T, inside, zeros, cmap="binary_r", vmin=0, vmax=1)
    axes.add_collection(
        LineCollection(list(outline_before), colors="#bbbbbb", lw=0.9, ls=(0, (3, 2)))
    )
    axes.add_collection(LineCollection(list(outline_after), colors="#111111", lw=0.9))
    if panel.tip_radius_mm is not None:
        radius = panel.tip_radius_mm
        centre = (panel.xy_mm[0], radius - panel.depth_mm)
        axes.add_patch(Circle(centre, radius, fc="#dddddd", ec="#c8553d", lw=1.4, zorder=0))
    ends = outline_before[..., 0].min() - 2, outline_before[..., 0].max() + 2
    axes.set(
        xlim=ends, ylim=(-_BELOW_MM, _ABOVE_MM), aspect="equal", xlabel="x on the face (mm)",
        ylabel="outwards (mm)", title=panel.title,
    )  # fmt: skip
    return image


def _cut(panel: SectionPanel) -> _Cut:
    from fem.presses.shape import vtk_grid

    sliced = _sliced(panel, vtk_grid(panel.shape)).triangulate()
    moved = np.asarray(sliced["displacement_mm"])
    return _Cut(
        _section_coordinates(panel, np.asarray(sliced.points) + moved),
        np.asarray(sliced.faces).reshape(-1, 4)[:, 1:],
        np.asarray(sliced.cell_data["magnet"]),
        np.linalg.norm(moved, axis=1),
    )


def _outline(panel: SectionPanel) -> tuple[np.ndarray, np.ndarray]:
    """Segments (segment, 2, 2) of the silicone's border, magnets' included, before and after."""
    from fem.presses.shape import vtk_grid

    grid = vtk_grid(panel.shape)
    surface: Any = grid.extract_cells(panel.shape.magnet < 0).extract_surface(algorithm=None)
    sliced = _sliced(panel, surface)
    ends = np.asarray(sliced.lines).reshape(-1, 3)[:, 1:]
    points, moved = np.asarray(sliced.points), np.asarray(sliced["displacement_mm"])
    return _section_coordinates(panel, points)[ends], _section_coordinates(panel, points + moved)[
        ends
    ]


def _sliced(panel: SectionPanel, body: Any) -> Any:
    """The undeformed body cut by the plane through the tip, across the face's y."""
    frame, y = panel.frame, panel.xy_mm[1]
    origin = np.asarray(frame.to_object(np.array([0.0, y, 0.0])))
    across = np.asarray(frame.to_object(np.array([0.0, y + 1, 0.0]))) - origin
    return body.slice(normal=across, origin=origin)


def _section_coordinates(panel: SectionPanel, points_mm: np.ndarray) -> np.ndarray:
    return np.asarray(panel.frame.from_object(points_mm))[:, [0, 2]]
