"""Findings of the fabrication checks as a picture: parts with each failing location marked."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from design.fabrication.finding import Finding
from instobj.figures.saving import save_figure
from instobj.render.pieces import Picture, Piece, picture_of

if TYPE_CHECKING:
    import trimesh
    from matplotlib.axes import Axes

PANELS = 6
BEHIND_MM = 1.5
_GREY = (0.72, 0.74, 0.78)
_COLOURS = {"fail": "#c1121f", "warn": "#e07b00"}
_LINE = 76
_FLATTER = 0.8
"""Share of a part's least extent along the object's axes, below which it is looked at across its own."""


def draw_findings(
    findings: list[Finding], meshes: dict[str, trimesh.Trimesh], title: str, png_path: Path
) -> Path:
    """One panel per part with what did not pass: numbered rings at the places, texts below.

    Failures come first, and at most six parts are drawn. The ring of a place that lies hidden behind
    the surface seen is dashed.
    """
    from matplotlib.figure import Figure

    marked = marked_parts(findings, meshes)
    rows, columns = (1, 1) if not marked else (-(-len(marked) // 3), min(3, len(marked)))
    figure = Figure(figsize=(6.2 * columns, 6.6 * rows + 0.5), layout="constrained")
    figure.suptitle(f"Fabrication checks of {title}", fontsize=15)
    places = np.atleast_1d(figure.subplots(rows, columns)).ravel()
    for axes in places:
        axes.set_axis_off()
    if not marked:
        places[0].text(0.5, 0.5, "nothing to mark: all checks pass", ha="center", fontsize=14)
    for axes, (part, part_findings) in zip(places, marked.items(), strict=False):
        _draw_part(axes, part, meshes[part], part_findings)
    save_figure(figure, png_path)
    return png_path


def marked_parts(
    findings: list[Finding], meshes: dict[str, trimesh.Trimesh]
) -> dict[str, list[Finding]]:
    """Findings with a place that did not pass, by part, parts with failures first."""
    order = {"fail": 0, "warn": 1}
    to_mark = [f for f in findings if f.status != "pass" and f.place_mm and f.part in meshes]
    by_part: dict[str, list[Finding]] = {}
    for finding in sorted(to_mark, key=lambda finding: order[finding.status]):
        by_part.setdefault(finding.part, []).append(finding)
    return dict(list(by_part.items())[:PANELS])


def _draw_part(axes: Axes, part: str, mesh: trimesh.Trimesh, findings: list[Finding]) -> None:
    from matplotlib.patches import Circle

    towards = viewing_direction(mesh, np.array(findings[0].place_mm))
    up = (0.0, 0.0, 1.0) if abs(towards[2]) < 0.95 else (0.0, 1.0, 0.0)
    picture = picture_of([Piece(mesh, _GREY)], tuple(towards), up)
    picture.show(axes)
    picture.add_axes_and_scale(axes)
    left, right, *_ = picture.extent_mm
    lines = []
    for number, finding in enumerate(findings, start=1):
        x, y, _ = seen_mm = picture.camera @ np.array(finding.place_mm)
        colour = _COLOURS[finding.status]
        style = (0, (2, 1.2)) if _hidden(picture, seen_mm) else "solid"
        ring = Circle(
            (x, y),
            0.028 * (right - left),
            fill=False,
            linewidth=2.4,
            linestyle=style,
            edgecolor=colour,
        )
        axes.add_patch(ring)
        axes.annotate(
            str(number), (x, y), ha="center", va="center", fontsize=11, color=colour, weight="bold"
        )
        lines.append(
            f"{number}  {finding.status}: {finding.check} {finding.value:.3g} {finding.unit} "
            f"(limit {finding.limit:.3g})"
        )
    worst = "fail" if any(finding.status == "fail" for finding in findings) else "warn"
    axes.set_title(part.replace("_", " "), fontsize=13, color=_COLOURS[worst])
    text = "\n".join(line[:_LINE] for line in lines)
    axes.text(
        0.0, -0.02, text, transform=axes.transAxes, va="top", fontsize=8.5, family="monospace"
    )


def _hidden(picture: Picture, seen_mm: np.ndarray) -> bool:
    """Return whether a place lies behind the surface that its pixel shows."""
    left, right, bottom, top = picture.extent_mm
    depth_mm = picture.image.depth_mm
    rows, columns = depth_mm.shape
    column = int((seen_mm[0] - left) / (right - left) * columns)
    row = int((top - seen_mm[1]) / (top - bottom) * rows)
    return bool(depth_mm[row, column] > seen_mm[2] + BEHIND_MM)


def viewing_direction(mesh: trimesh.Trimesh, place: np.ndarray) -> np.ndarray:
    """Direction to the viewer: obliquely over the side of the part on which the place lies, and across
    the part where it is flat."""
    axes, shares = _axes_of(mesh)
    coordinates = mesh.vertices @ axes.T
    extents = np.maximum(np.ptp(coordinates, axis=0), 1e-9)
    away = (axes @ place - (coordinates.min(axis=0) + coordinates.max(axis=0)) / 2) / extents
    side = np.where(away >= 0, 1.0, -1.0) * shares
    side[np.argmax(abs(away))] *= 1.7
    side *= np.sqrt(extents.max() / extents)
    return side / np.linalg.norm(side) @ axes


def _axes_of(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    """Axes that a part is looked at over, as rows, and how much over each: the object's, but for a part
    that is flatter across its own, as a mould half between two edges of its block."""
    spread = np.cov(mesh.triangles_center, rowvar=False, aweights=mesh.area_faces)
    part_axes = np.linalg.eigh(spread)[1].T[::-1]
    part_axes *= np.sign(part_axes[np.arange(3), abs(part_axes).argmax(axis=1)])[:, None]
    if np.ptp(mesh.vertices @ part_axes[2]) < _FLATTER * mesh.extents.min():
        return part_axes, np.array([0.4, 0.5, 0.9])
    return np.eye(3), np.array([0.8, 0.9, 0.55])
