"""The ellipsoid."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.offset import OffsetBody
from design.body.surface_chart import FaceFrame, cap_frame

if TYPE_CHECKING:
    import trimesh


class Ellipsoid(OffsetBody):
    """Three diameters; patches of its outside are exact, its core is an offset of the triangles."""

    name = "ellipsoid"
    comments: ClassVar = {"body.size_mm": "the diameters along x, y, z"}

    def parting_azimuth(self, half_mm: np.ndarray) -> float:
        """Across the shorter axis."""
        if half_mm[0] == half_mm[1]:
            return float(np.pi / 4)
        return 0.0 if half_mm[0] < half_mm[1] else float(np.pi / 2)

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        if inward_mm:
            return super().frame(number, inward_mm)
        return cap_frame(number, self.half_mm, np.zeros(3))

    def outer_surface(self) -> trimesh.Trimesh:
        import trimesh

        half = self.half_mm
        edge = np.sqrt(4 * half.min() ** 2 / half.max() * self.envelope_mm)
        finest = 1.05 * half.max() / edge
        sphere = trimesh.creation.icosphere(max(2, round(float(np.log2(finest)))), 1.0)
        sphere.apply_scale(half * (4 / 3 * np.pi / sphere.volume) ** (1 / 3))
        return sphere
