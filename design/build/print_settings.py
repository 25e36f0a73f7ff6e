"""Print settings of a part: layer, walls, infill, supports, brim, and the side that lies on the bed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.spec.fabrication import PrinterSpec

if TYPE_CHECKING:
    import trimesh

    from design.spec.object import ObjectSpec

STEEP = float(np.cos(np.deg2rad(45.0)))
"""Surfaces that face down more than this want something below them."""
_FLAT = 1 - 1e-4
_SIDES = 24
"""Sides of the part's hull that are tried, largest first, besides the six along the axes."""
_LEAST_OVERHANG_MM2 = 30.0
"""Below it bridges and droops are left as they are."""
_BED_MM2, _SLENDER = 60.0, 3.0
"""Parts with less on the bed, or taller by this than what they stand on is wide, get a brim."""
_BRIM_MM = 4.0
"""Width of the brim round parts that stand on little or are slender."""


@dataclass(frozen=True)
class PrintSettings:
    """Settings of a slicer for one part of a printer by filament; lengths in mm.

    `down` is the direction, in the part's own frame, that points to the bed.
    """

    layer_mm: float
    walls: int
    infill_percent: int
    supports: bool
    brim_mm: float
    down: tuple[float, float, float]

    @property
    def rotation(self) -> Float[np.ndarray, "3 3"]:
        """Turns a part so that `down` becomes −z; rows are the bed's x, y, z in the part's frame."""
        up = -np.asarray(self.down)
        side = np.eye(3)[int(abs(up).argmin())]
        x = np.cross(side, up) / np.linalg.norm(np.cross(side, up))
        return np.stack([x, np.cross(up, x), up])


_USES = {
    "core": (4, 40, False),
    "shell": (3, 100, False),
    "mould_pin": (4, 100, True),
    "mould_locator": (4, 100, True),
    "mould": (3, 25, True),
    "probe": (5, 60, False),
    "jig": (4, 40, False),
    "magnet_template": (3, 25, False),
}
"""Walls, infill (%), and whether silicone copies the surface, by how a part's name begins."""


def print_settings(
    spec: ObjectSpec, name: str, mesh: trimesh.Trimesh, printed: bool
) -> PrintSettings | None:
    """Settings of a part; None where it is cast, or printed by another process than filament.

    A line is half of the printer's thinnest wall wide, a layer half as high as a line, or 0.3 of it
    where silicone copies the surface.
    """
    if spec.printer.preset.process != "fdm" or not (printed or spec.silicone.cure == "none"):
        return None
    start = next(start for start in _USES if name.startswith(start))
    walls, infill, copied = _USES[start]
    down = lying_side(mesh)
    bed, overhang, height = standing_on(mesh, np.asarray(down))
    brim = _BRIM_MM if bed < _BED_MM2 or height > _SLENDER * bed**0.5 else 0.0
    layer = layer_mm(spec.printer, copied)
    return PrintSettings(layer, walls, infill, overhang > _LEAST_OVERHANG_MM2, brim, down)


def layer_mm(printer: PrinterSpec, copied: bool) -> float:
    """Height of a layer, a multiple of 0.02 mm."""
    line = printer.wall_mm / 2
    return round(0.02 * max(1, int((0.3 if copied else 0.5) * line / 0.02 + 1e-9)), 2)


def lying_side(mesh: trimesh.Trimesh) -> tuple[float, float, float]:
    """Direction to the bed with the least surface that hangs over, less a fifth of what lies on it.

    A part comes to rest on a side of its convex hull; the largest of these are tried and the six
    directions along the axes, in this order where they are as good.
    """
    hull = mesh.convex_hull
    normals, area = np.asarray(hull.face_normals), np.asarray(hull.area_faces)
    _, first, which = np.unique(normals.round(3), axis=0, return_index=True, return_inverse=True)
    largest = np.argsort(-np.bincount(which.ravel(), area))[:_SIDES]
    tried = np.vstack([-np.eye(3)[::-1], np.eye(3), normals[first[largest]]])
    costs = [round(over - 0.2 * bed, 3) for bed, over, _ in (standing_on(mesh, d) for d in tried)]
    x, y, z = (tried[int(np.argmin(costs))] + 0.0).tolist()
    return (x, y, z)


def standing_on(mesh: trimesh.Trimesh, down: np.ndarray) -> tuple[float, float, float]:
    """Area on the bed, area that hangs over (mm², as seen from below) and height (mm)."""
    area, facing = np.asarray(mesh.area_faces), np.asarray(mesh.face_normals) @ down
    levels = np.asarray(mesh.triangles) @ -down
    low = float(levels.min())
    flat = (facing > _FLAT) & (levels.max(axis=1) < low + 0.02)
    hanging = (facing > STEEP) & ~flat
    return (
        float(area[flat].sum()),
        float((area * facing)[hanging].sum()),
        float(levels.max()) - low,
    )
