"""The ellipsoid."""

from __future__ import annotations

from functools import lru_cache
from math import ceil
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.offset import OffsetBody
from design.body.surface_chart import FaceFrame, cap_frame

if TYPE_CHECKING:
    import trimesh

_ICOSAHEDRON_EDGE = 1.05
"""Over its radius (1 / sin 72°); every subdivision halves it."""


class Ellipsoid(OffsetBody):
    """Three diameters; patches of its outside are exact, its core is an offset of the triangles."""

    name = "ellipsoid"
    mirrored = True
    comments: ClassVar = {"body.size_mm": "the diameters along x, y, z"}

    def parting_azimuth(self, size_mm: np.ndarray) -> float:
        """Across the shorter axis."""
        if size_mm[0] == size_mm[1]:
            return float(np.pi / 4)
        return 0.0 if size_mm[0] < size_mm[1] else float(np.pi / 2)

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        if inward_mm:
            return super().frame(number, inward_mm)
        return cap_frame(number, self.half_mm, np.zeros(3))

    def outer_surface(self) -> trimesh.Trimesh:
        half = self.half_mm
        # a triangle of edge h leaves the unit ball by up to h²/6, and stretched it leaves the ellipsoid by
        # no more than that times the longest semi-axis, however pointed its ends are: half the envelope
        edge = np.sqrt(3 * self.envelope_mm / half.max())
        sphere, volume = _ball(max(2, ceil(np.log2(_ICOSAHEDRON_EDGE / edge))))
        return sphere.copy().apply_scale(half * (4 / 3 * np.pi / volume) ** (1 / 3))


@lru_cache(maxsize=4)
def _ball(subdivisions: int) -> tuple[trimesh.Trimesh, float]:
    """An icosahedron's subdivisions, corners at radius 1, and its volume."""
    import trimesh

    sphere = trimesh.creation.icosphere(subdivisions, 1.0)
    return sphere, float(sphere.volume)
