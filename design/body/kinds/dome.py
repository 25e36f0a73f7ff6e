"""The dome: a hemisphere on a rigid base."""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from design.body.kinds.base import BodyKind
from design.body.surface_chart import FaceFrame, cap_frame, face_axes
from design.body.triangles import ball, box_between

if TYPE_CHECKING:
    import trimesh


class Dome(BodyKind):
    """One patch; inside it a rigid dome, silicone down to the base, or air."""

    name = "dome"
    faces = (1,)
    openable = ()
    on_base = True
    insides = ("core", "silicone", "air")
    size_rule = "x and y alike, the diameter, and z above half of it"
    round_below = True
    comments: ClassVar = {"body.size_mm": "the diameter twice, the height with the rigid base"}

    @classmethod
    def takes_size(cls, size_mm: tuple[float, float, float]) -> bool:
        return size_mm[0] == size_mm[1] and size_mm[2] > size_mm[0] / 2

    @property
    def base_top_mm(self) -> float:
        """Height z of the plane on which the dome stands."""
        return self.size_mm[2] / 2 - self.radius_mm

    @property
    def centre_mm(self) -> np.ndarray:
        """Middle of the sphere."""
        return np.array([0.0, 0.0, self.base_top_mm])

    @property
    def corners_mm(self) -> tuple[np.ndarray, np.ndarray]:
        return np.array([*-self.half_mm[:2], self.base_top_mm]), self.half_mm

    @property
    def silicone_mm(self) -> float:
        return self.radius_mm if self.inside == "silicone" else self.thickness_mm

    @property
    def room_for_recesses(self) -> tuple[float, str]:
        return self.base_top_mm + self.size_mm[2] / 2, "the rigid base"

    @property
    def thickness_below_mm(self) -> float:
        return float("inf") if self.inside == "silicone" else self.radius_mm

    def passage_mm(self, axes: np.ndarray) -> np.ndarray:
        return np.zeros((2, 2)) if self.inside == "silicone" else super().passage_mm(axes)

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        radii = np.full(3, self.radius_mm - inward_mm)
        return cap_frame(number, radii, self.centre_mm)

    def core_frame(self, number: int) -> FaceFrame:
        if self.inside == "core":
            return self.frame(number, self.thickness_mm)
        extents = (self.radius_mm, self.radius_mm)
        normal, x, y = face_axes(number)
        return FaceFrame(number, normal, x, y, self.centre_mm, extents, round=True)

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        base = points_mm[:, 2] - self.base_top_mm
        if self.inside != "core":
            return base
        away = np.linalg.norm(points_mm - self.centre_mm, axis=1) - self.core_radius_mm
        return np.minimum(base, away)

    def outer_surface(self) -> trimesh.Trimesh:
        reach = 2 * self.radius_mm
        above = box_between(self.centre_mm - [reach, reach, 0], self.centre_mm + reach)
        return ball(self.radius_mm, self.centre_mm, self.envelope_mm).intersection(above)

    def core_surface(self) -> trimesh.Trimesh | None:
        """A whole ball: what lies under the base's plane cuts no silicone."""
        if self.inside == "silicone":
            return None
        return ball(self.core_radius_mm, self.centre_mm, self.envelope_mm)

    def volume_mm3(self) -> float:
        inner = 0.0 if self.inside == "silicone" else self.core_radius_mm
        return 2 / 3 * pi * (self.radius_mm**3 - inner**3)
