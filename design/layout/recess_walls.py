"""How much of the core is left between the recesses of its sensor boards, face by face and round
the core's edges."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from jaxtyping import Float

from design.layout.pockets import sensor_places
from design.layout.positions import core_frames
from design.spec.object import ObjectSpec


@dataclass(frozen=True)
class Recess:
    """The box of one sensor's recess: centre (mm), axes as columns, half edges (mm)."""

    face: int
    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    half_mm: Float[np.ndarray, "3"]


def sensor_recesses(spec: ObjectSpec) -> tuple[Recess, ...]:
    """Every recess of the core, face by face, in the object's frame (sensors in the core)."""
    core = spec.core
    length = core.recess_outer_radius_mm - core.recess_inner_radius_mm
    half = np.array([length, core.recess_width_mm, core.recess_depth_mm]) / 2
    found = []
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for x, y, azimuth in places:
            cosine, sine = np.cos(azimuth), np.sin(azimuth)
            turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
            aside = core.recess_inner_radius_mm + length / 2 - spec.sensors.radius_mm
            local = np.array([x + aside * cosine, y + aside * sine, -core.recess_depth_mm / 2])
            found.append(
                Recess(frame.number, np.asarray(frame.to_object(local)), frame.axes @ turn, half)
            )
    return tuple(found)


def smallest_recess_wall_mm(spec: ObjectSpec) -> float:
    """Largest gap that a plane between two recesses has, for the two that are nearest.

    Negative where recesses meet, by how far one must move. Not above the true distance of two
    boxes, and less than it where they face each other with two edges or corners.
    """
    pairs = combinations(sensor_recesses(spec), 2)
    return min(_gap_mm(a, b) for a, b in pairs)


def _gap_mm(a: Recess, b: Recess) -> float:
    """Of the separating-axis theorem: the largest gap along any normal or product of edges."""
    crossed = np.cross(a.axes.T[:, None], b.axes.T[None]).reshape(-1, 3)
    directions = np.concatenate([a.axes.T, b.axes.T, crossed])
    length = np.linalg.norm(directions, axis=1)
    directions = directions[length > 1e-9] / length[length > 1e-9, None]
    apart = abs(directions @ (b.centre_mm - a.centre_mm))
    reach = abs(directions @ a.axes) @ a.half_mm + abs(directions @ b.axes) @ b.half_mm
    return float((apart - reach).max())
