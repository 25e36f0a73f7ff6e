"""The capsule: a cylinder about z with spherical ends (a bottle, a courgette)."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING, ClassVar

import numpy as np
from jaxtyping import Float

from design.body.kinds.base import BodyKind
from design.body.kinds.sphere import half_ball_in_bore_mm3
from design.body.surface_chart import (
    LARGEST_SQUARE,
    FaceFrame,
    cap_frame,
    face_axes,
    steepest_reach_mm,
)
from design.body.triangles import sections_of_circle

if TYPE_CHECKING:
    import trimesh


@dataclass(frozen=True)
class CapsuleSide:
    """Height of a capsule's side over the plane that touches it along a line, x along the capsule.

    A cylinder of `radius_mm` up to |x| = `straight_mm`, beyond it a ball of that radius.
    """

    radius_mm: float
    straight_mm: float

    def evaluate(
        self, xy_mm: Float[np.ndarray, "*n 2"]
    ) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n 2"]]:
        """Height (mm) and its slopes along x and y; NaN where the patch does not reach."""
        x, y = xy_mm[..., 0], xy_mm[..., 1]
        beyond = x - np.clip(x, -self.straight_mm, self.straight_mm)
        across = np.stack([beyond, y], axis=-1) / self.radius_mm
        square = across[..., 0] ** 2 + across[..., 1] ** 2
        root = np.asarray(np.sqrt(1 - np.where(square <= LARGEST_SQUARE, square, np.nan)))
        return np.asarray(self.radius_mm * (root - 1)), -across / root[..., None]


class Capsule(BodyKind):
    """Ends 1 and 6, of which 6 gives way to a bore where it is open, and four patches round it."""

    name = "capsule"
    size_rule = "x and y alike, the diameter, and z above it"
    comments: ClassVar = {"body.size_mm": "the diameter twice, the whole length along z"}

    @classmethod
    def takes_size(cls, size_mm: tuple[float, float, float]) -> bool:
        return size_mm[0] == size_mm[1] < size_mm[2]

    @property
    def straight_mm(self) -> float:
        """Half of the cylinder's length; the ends' middles lie so far above and below the origin."""
        return self.size_mm[2] / 2 - self.radius_mm

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        radius, straight = self.radius_mm - inward_mm, self.straight_mm
        normal, x, y = face_axes(number)
        if number in (1, 6):
            return cap_frame(number, np.full(3, radius), straight * normal)
        reach = steepest_reach_mm(radius, radius)
        extents, relief = (straight + reach, reach), CapsuleSide(radius, straight)
        return FaceFrame(number, normal, x, y, radius * normal, extents, relief, round=True)

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        axis_height_mm = np.clip(points_mm[:, 2], -self.straight_mm, self.straight_mm)
        from_axis = points_mm - axis_height_mm[:, None] * np.array([0.0, 0.0, 1.0])
        return np.linalg.norm(from_axis, axis=1) - self.core_radius_mm

    def outer_surface(self) -> trimesh.Trimesh:
        return self._triangles(self.radius_mm)

    def core_surface(self) -> trimesh.Trimesh:
        return self._triangles(self.core_radius_mm)

    def _triangles(self, radius_mm: float) -> trimesh.Trimesh:
        """A profile turned about z and widened until it encloses the capsule's volume."""
        import trimesh

        sections = sections_of_circle(radius_mm, self.envelope_mm)
        angle = np.linspace(0, np.pi / 2, sections // 4 + 1)
        arc = radius_mm * np.column_stack([np.sin(angle), -np.cos(angle)])
        arc[0, 0] = 0.0
        above = np.array([0.0, self.straight_mm])
        profile = np.concatenate([arc - above, arc[::-1] * [1, -1] + above])
        solid = trimesh.creation.revolve(profile, sections=sections)
        volume = 4 / 3 * pi * radius_mm**3 + 2 * pi * self.straight_mm * radius_mm**2
        wider = np.sqrt(volume / float(solid.volume))
        solid.apply_scale([wider, wider, 1.0])
        return solid

    def volume_mm3(self) -> float:
        outer, inner = self.radius_mm, self.core_radius_mm
        ends = 4 / 3 * pi * (outer**3 - inner**3)
        side = 2 * pi * self.straight_mm * (outer**2 - inner**2)
        if not self.opened:
            return ends + side
        bore = self.bore_mm / 2
        bored = half_ball_in_bore_mm3(outer, bore) - half_ball_in_bore_mm3(inner, bore)
        return ends + side - bored
