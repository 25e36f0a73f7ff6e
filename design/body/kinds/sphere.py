"""The sphere."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.base import BodyKind
from design.body.surface_chart import FaceFrame, cap_frame
from design.body.triangles import ball

if TYPE_CHECKING:
    import trimesh


class Sphere(BodyKind):
    """Six patches, of which the lowest gives way to a bore where it is open."""

    name = "sphere"
    size_rule = "three times its diameter"
    comments: ClassVar = {"body.size_mm": "the diameter, three times"}

    @classmethod
    def takes_size(cls, size_mm: tuple[float, float, float]) -> bool:
        return size_mm[0] == size_mm[1] == size_mm[2]

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        return cap_frame(number, self.half_mm - inward_mm, np.zeros(3))

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        return np.linalg.norm(points_mm, axis=1) - self.core_radius_mm

    def outer_surface(self) -> trimesh.Trimesh:
        return ball(self.radius_mm, np.zeros(3), self.envelope_mm)

    def core_surface(self) -> trimesh.Trimesh:
        return ball(self.core_radius_mm, np.zeros(3), self.envelope_mm)

    def volume_mm3(self) -> float:
        outer, inner = self.radius_mm, self.core_radius_mm
        return 4 / 3 * pi * (outer**3 - inner**3) - self._bore_volume_mm3()

    def _bore_volume_mm3(self) -> float:
        if not self.opened:
            return 0.0
        outer, inner = self.radius_mm, self.core_radius_mm
        bore = self.bore_mm / 2
        return half_ball_in_bore_mm3(outer, bore) - half_ball_in_bore_mm3(inner, bore)


def half_ball_in_bore_mm3(radius_mm: float, bore_radius_mm: float) -> float:
    """Volume of half of a ball within a cylinder through its middle."""
    return 2 / 3 * pi * (radius_mm**3 - (radius_mm**2 - bore_radius_mm**2) ** 1.5)
