"""The cylinder about z."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.base import OVERSHOOT_MM, BodyKind
from design.body.surface_chart import Cap, FaceFrame, flat_frame, steepest_reach_mm
from design.body.triangles import cylinder_between

if TYPE_CHECKING:
    import trimesh


class Cylinder(BodyKind):
    """Flat round ends 1 and 6, which may be open, and four patches round its side."""

    name = "cylinder"
    openable = (1, 6)
    opens_sides = True
    size_rule = "x and y alike, the diameter"
    round_below = True
    comments: ClassVar = {
        "body.size_mm": "the diameter twice, the height; along z",
        "body.open_faces": "[6], [1] or both: ends at which the core's cavity runs out; []: closed",
        "shell.slits": "relief slits halfway between the sides 2 to 5",
        "shell.slits.depth_mm": "from the surface inwards; 0: none",
    }

    @classmethod
    def takes_size(cls, size_mm: tuple[float, float, float]) -> bool:
        return size_mm[0] == size_mm[1]

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        frame = flat_frame(number, self.half_mm, inward_mm)
        if number in (1, 6):
            return replace(frame, round=True)
        radius = self.radius_mm - inward_mm
        extents = (frame.half_extents_mm[0], steepest_reach_mm(radius, radius))
        return replace(frame, half_extents_mm=extents, relief=Cap((np.inf, radius, radius)))

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        across = np.hypot(points_mm[:, 0], points_mm[:, 1]) - self.core_radius_mm
        return np.maximum(across, abs(points_mm[:, 2]) - self.core_half_mm[2])

    def outer_surface(self) -> trimesh.Trimesh:
        return self._about_z(self.radius_mm, -self.half_mm[2], self.half_mm[2])

    def core_surface(self) -> trimesh.Trimesh:
        return self._about_z(self.core_radius_mm, -self.core_half_mm[2], self.core_half_mm[2])

    def cavity_surface(self) -> trimesh.Trimesh:
        low, high = self.core_span_mm(OVERSHOOT_MM)
        return self._about_z(self.core_radius_mm, low[2], high[2])

    def _about_z(self, radius_mm: float, low_mm: float, high_mm: float) -> trimesh.Trimesh:
        return cylinder_between(float(radius_mm), float(low_mm), float(high_mm), self.envelope_mm)

    def volume_mm3(self) -> float:
        low, high = self.core_span_mm(0.0)
        hollow = self.core_radius_mm**2 * float((high - low)[2])
        return pi * (self.radius_mm**2 * self.size_mm[2] - hollow)

    def cast_measures_mm(
        self, layer_mm: float, sensed: tuple[int, ...]
    ) -> tuple[float, float, float]:
        """Radius and levels of the ends without a layer all round, and on the ends that are sensed."""
        radius, half = self.radius_mm, self.size_mm[2] / 2
        round_it = not {1, 6}.issuperset(sensed)
        return (
            radius - round_it * layer_mm,
            (6 in sensed) * layer_mm - half,
            half - (1 in sensed) * layer_mm,
        )

    def cast_surface(self, layer_mm: float, sensed: tuple[int, ...]) -> trimesh.Trimesh:
        return self._about_z(*self.cast_measures_mm(layer_mm, sensed))

    def end_slabs(self, width_mm: float) -> list[trimesh.Trimesh]:
        return [self._end_slab(normal, width_mm) for normal, _ in self.support_ends]

    def _end_slab(self, normal: np.ndarray, width_mm: float) -> trimesh.Trimesh:
        end = float((normal * self.core_half_mm)[2])
        low, high = sorted((end, end + width_mm * float(normal[2])))
        return self._about_z(self.core_radius_mm + width_mm, low, high)
