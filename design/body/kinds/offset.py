"""Bodies that are known by their triangles: the core is an offset of the surface."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from design.body.kinds.base import BodyKind
from design.body.sampled import outer_distance_mm, sampled_core, sampled_frame
from design.body.surface_chart import FaceFrame

if TYPE_CHECKING:
    import trimesh


class OffsetBody(BodyKind):
    """A kind that gives its `outer_surface`; all else follows from the distance to it."""

    sampled = True

    @property
    def core_floor_mm(self) -> float:
        core = sampled_core(self)
        hits, _, _ = core.ray.intersects_location([[0.0, 0.0, 0.0]], [[0.0, 0.0, -1.0]])
        return float(np.min(hits[:, 2])) if len(hits) else float(core.bounds[0, 2])

    def frame(self, number: int, inward_mm: float = 0.0) -> FaceFrame:
        return sampled_frame(self, number, inward_mm)

    def core_distance_mm(self, points_mm: np.ndarray) -> np.ndarray:
        return outer_distance_mm(self, points_mm) + self.thickness_mm

    def core_surface(self) -> trimesh.Trimesh:
        return sampled_core(self)

    def cast_surface(self, layer_mm: float, sensed: tuple[int, ...]) -> trimesh.Trimesh:
        if not layer_mm:
            return self.outer_surface()
        return sampled_core(replace(self, thickness_mm=layer_mm))

    def volume_mm3(self) -> float:
        """That of the triangles."""
        return _volume_mm3(self)


@lru_cache(maxsize=16)
def _volume_mm3(body: OffsetBody) -> float:
    silicone = body.outer_surface().difference(body.with_bore(body.core_surface()))
    return float(silicone.volume)
