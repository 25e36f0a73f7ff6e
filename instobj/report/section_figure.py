"""Section through the deformed shell under a press, at true scale."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.files import atomic_path
from design.layouts import FaceFrame, face_frames

if TYPE_CHECKING:
    from design.spec import ObjectSpec
    from fem.large_strain_results import LargeStrainPress
    from fem.press_shape import DeformedShape

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
    """Triangles of a section: points along x and outwards (mm), before and after the press."""

    before_mm: np.ndarray
    after_mm: np.ndarray
    triangles: np.ndarray
    magnet: np.ndarray
    size_mm: np.ndarray


def draw_sections(panels: list[SectionPanel], path: Path) -> None:
    """Each press cut along the face's x through the tip, coloured by displacement (PNG).

    The material plane is cut before the press and drawn where it went: what lies behind it may
    cover it slightly. One colour scale for all panels.
    """
    from matplotlib.figure import Figure

    cuts = [_cut(panel) for panel in panels]
    largest = max(float(cut.size_mm.max()) for cut in cuts)
    figure = Figure(figsize=(8.2, 3.5 * len(panels)), layout="constrained")
    axes = figure.subplots(len(panels), 1, squeeze=False)[:, 0]
    for panel, cut, one in zip(panels, cuts, axes, strict=True):
        image = _draw(one, panel, cut, largest)
    figure.colorbar(image, ax=list(axes), label="displacement (mm)", shrink=0.8)
    with atomic_path(path) as temporary:
        figure.savefig(temporary, dpi=130)


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


def _draw(axes: Any, panel: SectionPanel, cut: _Cut, largest_mm: float) -> Any:
    from matplotlib.patches import Circle

    silicone, inside = cut.triangles[cut.magnet < 0], cut.triangles[cut.magnet >= 0]
    image = axes.tripcolor(
        *cut.after_mm.T, silicone, cut.size_mm, shading="gouraud", cmap="viridis", vmin=0,
        vmax=largest_mm,
    )  # fmt: skip
    if len(inside):
        one = np.zeros(len(cut.after_mm))
        axes.tripcolor(*cut.after_mm.T, inside, one, cmap="binary_r", vmin=0, vmax=1)
        for a, b in _border(inside):
            axes.plot(*cut.before_mm[[a, b]].T, color="white", lw=0.9, ls=(0, (2, 1)))
    for a, b in _border(cut.triangles):
        axes.plot(*cut.before_mm[[a, b]].T, color="#888888", lw=0.7, ls=(0, (3, 2)))
        axes.plot(*cut.after_mm[[a, b]].T, color="#222222", lw=0.9)
    if panel.tip_radius_mm is not None:
        centre = (panel.xy_mm[0], panel.tip_radius_mm - panel.depth_mm)
        axes.add_patch(
            Circle(centre, panel.tip_radius_mm, fc="#dddddd", ec="#c8553d", lw=1.4, zorder=0)
        )
    x = cut.before_mm[:, 0]
    axes.set(
        xlim=(x.min() - 2, x.max() + 2), ylim=(-_BELOW_MM, _ABOVE_MM), aspect="equal",
        xlabel="x on the face (mm)", ylabel="outwards (mm)", title=panel.title,
    )  # fmt: skip
    return image


def _cut(panel: SectionPanel) -> _Cut:
    """Cut the undeformed body by the plane through the tip, across the face's y."""
    from fem.press_shape import vtk_grid

    frame, y = panel.frame, panel.xy_mm[1]
    origin = frame.to_object(np.array([0.0, y, 0.0]))
    across = np.asarray(frame.to_object(np.array([0.0, y + 1, 0.0]))) - origin
    sliced: Any = vtk_grid(panel.shape).slice(normal=across, origin=origin)
    sliced = sliced.clean().triangulate()  # cells share their points only after cleaning
    triangles = np.asarray(sliced.faces).reshape(-1, 4)[:, 1:]
    points, moved = np.asarray(sliced.points), np.asarray(sliced["displacement_mm"])
    return _Cut(
        np.asarray(frame.from_object(points))[:, [0, 2]],
        np.asarray(frame.from_object(points + moved))[:, [0, 2]],
        triangles,
        np.asarray(sliced.cell_data["magnet"]),
        np.linalg.norm(moved, axis=1),
    )


def _border(triangles: np.ndarray) -> np.ndarray:
    """Edges that belong to one triangle only."""
    edges = np.sort(
        np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    )
    unique, counts = np.unique(edges, axis=0, return_counts=True)
    return unique[counts == 1]
