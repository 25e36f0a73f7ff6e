"""The box."""

from __future__ import annotations

from math import prod
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.base import ALL_FACES, OVERSHOOT_MM, BodyKind
from design.body.surface_chart import FaceFrame, flat_frame
from design.body.triangles import box_between

if TYPE_CHECKING:
    import trimesh

_OPPOSITE = ([1, 6], [2, 4], [3, 5])
"""Faces that lie opposite each other, by their numbers."""


class Box(BodyKind):
    """Six flat sides, any of them open."""

    name = "box"
    openable = ALL_FACES
    opens_sides = True
    cuboid = True
    comments: ClassVar = {"body.size_mm": "edges along x, y, z, silicone and core together"}

    @classmethod
    def falls_apart(cls, closed: list[int]) -> bool:
        return closed in _OPPOSITE

    def passage_mm(self, axes: np.ndarray) -> np.ndarray:
        if self.opening == "closed":
            return np.zeros((2, 2))
        return np.sort(axes.T @ np.column_stack(self.core_span_mm(0.0)), axis=1)[:2].T

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        return flat_frame(number, self.half_mm, inward_mm)

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        return np.max(abs(points_mm) - self.core_half_mm, axis=1)

    def outer_surface(self) -> trimesh.Trimesh:
        import trimesh

        return trimesh.creation.box(self.size_mm)

    def core_surface(self) -> trimesh.Trimesh:
        return box_between(-self.core_half_mm, self.core_half_mm)

    def cavity_surface(self) -> trimesh.Trimesh:
        return box_between(*self.core_span_mm(OVERSHOOT_MM))

    def volume_mm3(self) -> float:
        low, high = self.core_span_mm(0.0)
        return prod(self.size_mm) - float(np.prod(high - low))

    def cast_surface(self, layer_mm: float, sensed: tuple[int, ...]) -> trimesh.Trimesh:
        return box_between(*self.cast_corners_mm(layer_mm, sensed))

    def end_slabs(self, width_mm: float) -> list[trimesh.Trimesh]:
        return [self._end_slab(normal, width_mm) for normal, _ in self.support_ends]

    def _end_slab(self, normal: np.ndarray, width_mm: float) -> trimesh.Trimesh:
        half = self.core_half_mm
        end, grown = normal * half, half + width_mm
        across = np.where(normal == 0, grown, 0)
        corners = np.stack([end - across, end + across + width_mm * normal])
        return box_between(corners.min(axis=0), corners.max(axis=0))
