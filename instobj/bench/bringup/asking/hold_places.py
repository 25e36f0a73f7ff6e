"""Places at which a bring-up asks for the magnet: over every chip, then between neighbouring chips."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from design.layout.body import core_frames
from design.layout.places.positions import sensor_layout
from design.layout.pockets import sensor_places
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import sensor_names

OVER_MM, BETWEEN_MM = 10.0, 6.0
"""Heights above the core's surface, as the questions ask: over a chip, and between two."""
_LEAST_COSINE = -0.1
"""Least cosine of the normals at two neighbours: chips around one edge are, opposite ones are not."""
_ONE_PLACE_MM = 1e-3
"""Distance below which two places are one."""


@dataclass(frozen=True)
class HoldPlace:
    """Place at which the magnet is to be held.

    Attributes
    ----------
    chips : the one under it, or the two between which it is
    face : number of the face above which it is
    stated_mm, height_mm : of the magnet's centre, in the object's frame and above the core's surface
    axes : columns, the third pointing out of the core
    """

    chips: tuple[str, ...]
    face: int
    stated_mm: Float[np.ndarray, "3"]
    height_mm: float
    axes: Float[np.ndarray, "3 3"]

    @property
    def foot_mm(self) -> Float[np.ndarray, "3"]:
        """Return the foot of the magnet on the core's surface."""
        return self.stated_mm - self.height_mm * self.axes[:, 2]


@cached_geometry
def hold_places(spec: ObjectSpec) -> tuple[HoldPlace, ...]:
    """Over every chip in the order of the sensors, then between every two that are neighbours."""
    over = tuple(_places_over_chips(spec))
    return (*over, *_places_between_chips(over))


def _places_over_chips(spec: ObjectSpec) -> Iterator[HoldPlace]:
    names = iter(sensor_names(sensor_layout(spec).face))
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for x, y, _ in places:
            stated, axes = (
                frame.to_object(np.array([x, y, OVER_MM])),
                frame.axes_at(np.array([x, y])),
            )
            yield HoldPlace((next(names),), frame.number, stated, OVER_MM, axes)


def _places_between_chips(over: tuple[HoldPlace, ...]) -> Iterator[HoldPlace]:
    """Half way along the surface, which is taken for the planes that touch it at both chips."""
    for pair in combinations(over, 2):
        normals = np.stack([place.axes[:, 2] for place in pair])
        feet = np.stack([place.foot_mm for place in pair])
        if normals[0] @ normals[1] < _LEAST_COSINE:
            continue
        out = normals.sum(axis=0) / np.linalg.norm(normals.sum(axis=0))
        below_mm = ((feet - feet.mean(axis=0)) * normals).sum(axis=1) / (normals @ out)
        nearer = pair[int(np.argmin(below_mm))]
        normal = nearer.axes[:, 2]
        offset = (feet[1] - feet[0]) - normal * (normal @ (feet[1] - feet[0]))
        length = float(np.linalg.norm(offset))
        if length < _ONE_PLACE_MM:
            continue
        axes = np.column_stack([offset / length, np.cross(normal, offset / length), normal])
        stated = feet.mean(axis=0) + below_mm.min() * out + BETWEEN_MM * normal
        yield HoldPlace((*pair[0].chips, *pair[1].chips), nearer.face, stated, BETWEEN_MM, axes)
