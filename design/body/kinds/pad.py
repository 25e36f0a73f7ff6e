"""The pad: a slab of silicone on a rigid plate."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.base import BodyKind
from design.body.surface_chart import FaceFrame, flat_frame
from design.body.triangles import box_between

if TYPE_CHECKING:
    import trimesh


class Pad(BodyKind):
    """The slab is `thickness_mm` thick and as wide as its plate; nothing passes through a mould."""

    name = "pad"
    faces = (1,)
    openable = ()
    on_base = True
    takes_keys = False
    comments: ClassVar = {
        "body.size_mm": "the slab's edges along x and y, its height with the plate under it"
    }

    @property
    def base_top_mm(self) -> float:
        """Height z of the plate's upper side."""
        return self.size_mm[2] / 2 - self.thickness_mm

    @property
    def outside(self) -> Pad:
        """The slab is as thick as the shell."""
        return replace(self, opened=(), bore_mm=0.0, inside="core")

    @property
    def corners_mm(self) -> tuple[np.ndarray, np.ndarray]:
        return np.array([*-self.half_mm[:2], self.base_top_mm]), self.half_mm

    @property
    def room_for_recesses(self) -> tuple[float, str]:
        return self.base_top_mm + self.size_mm[2] / 2, "the rigid base"

    def passage_mm(self, axes: np.ndarray) -> np.ndarray:
        return np.zeros((2, 2))

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        wide = flat_frame(number, self.half_mm)
        return replace(wide, centre_mm=wide.centre_mm - inward_mm * wide.normal)

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        return points_mm[:, 2] - self.base_top_mm

    def outer_surface(self) -> trimesh.Trimesh:
        return box_between(*self.corners_mm)

    def cast_surface(self, layer_mm: float, sensed: tuple[int, ...]) -> trimesh.Trimesh:
        return box_between(*self.cast_corners_mm(layer_mm, sensed))

    def core_surface(self) -> None:
        return None

    def volume_mm3(self) -> float:
        x, y, z = self.size_mm
        return x * y * (z / 2 - self.base_top_mm)
