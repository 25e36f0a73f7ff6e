"""Blocks, and closed triangle surfaces of blocks, boxes, cylinders and balls (mm).

Curved surfaces are triangulated so finely that edges leave them by about half of `envelope_mm`, and
enclose the same volume.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

if TYPE_CHECKING:
    import trimesh

_ICOSAHEDRON_EDGE = 1.05


@dataclass(frozen=True)
class Block:
    """A box in the object's frame: centre (mm), orthonormal axes as columns, half edges (mm)."""

    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    half_mm: Float[np.ndarray, "3"]

    @property
    def volume_mm3(self) -> float:
        return float(8 * np.prod(self.half_mm))

    @property
    def corners_mm(self) -> Float[np.ndarray, "8 3"]:
        """Corners in the object's frame, those of the lower side first."""
        signs = np.array([[x, y, z] for z in (-1, 1) for x in (-1, 1) for y in (-1, 1)])
        return self.centre_mm + (signs * self.half_mm) @ self.axes.T

    def distance_mm(self, points_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n"]:
        """Distance of points from the block; 0 within."""
        beyond = abs((points_mm - self.centre_mm) @ self.axes) - self.half_mm
        return np.linalg.norm(beyond.clip(min=0), axis=-1)

    def holds(
        self, points_mm: Float[np.ndarray, "n 3"], margin_mm: float = 0.0
    ) -> Bool[np.ndarray, "n"]:
        """Return whether points lie in the block grown by a margin on all sides."""
        local = abs((points_mm - self.centre_mm) @ self.axes)
        return np.all(local <= self.half_mm + margin_mm, axis=1)


def block_surface(block: Block) -> trimesh.Trimesh:
    """A block as a closed surface in the object's frame."""
    import trimesh

    placed = np.eye(4)
    placed[:3, :3], placed[:3, 3] = block.axes, block.centre_mm
    return trimesh.creation.box(2 * block.half_mm, placed)


def box_between(
    low_mm: Sequence[float] | np.ndarray, high_mm: Sequence[float] | np.ndarray
) -> trimesh.Trimesh:
    """A box along the axes, from its lowest to its highest corner."""
    import trimesh

    low, high = np.asarray(low_mm, float), np.asarray(high_mm, float)
    box = trimesh.creation.box(high - low)
    box.apply_translation((low + high) / 2)
    return box


def largest_edge_mm(radius_mm: float, envelope_mm: float) -> float:
    """Edge whose chord leaves a circle of that radius by half of the envelope."""
    return float(np.sqrt(4 * radius_mm * envelope_mm))


def sections_of_circle(radius_mm: float, envelope_mm: float) -> int:
    """Edges that stand for a circle, at least 24."""
    return max(24, int(np.ceil(2 * np.pi * radius_mm / largest_edge_mm(radius_mm, envelope_mm))))


def cylinder_between(
    radius_mm: float, low_mm: float, high_mm: float, envelope_mm: float
) -> trimesh.Trimesh:
    """About z; its triangles are as wide as they may be."""
    import trimesh

    sections = sections_of_circle(radius_mm, envelope_mm)
    angle = 2 * np.pi / sections
    radius = radius_mm * float(np.sqrt(angle / np.sin(angle)))
    solid = trimesh.creation.cylinder(radius, high_mm - low_mm, sections=sections)
    solid.apply_translation((0, 0, (low_mm + high_mm) / 2))
    return solid


def ball(radius_mm: float, centre_mm: np.ndarray, envelope_mm: float) -> trimesh.Trimesh:
    """A sphere."""
    import trimesh

    finest = _ICOSAHEDRON_EDGE * radius_mm / largest_edge_mm(radius_mm, envelope_mm)
    sphere = trimesh.creation.icosphere(max(2, round(float(np.log2(finest)))), radius_mm)
    sphere.apply_scale((4 / 3 * np.pi * radius_mm**3 / sphere.volume) ** (1 / 3))
    sphere.apply_translation(centre_mm)
    return sphere
