"""Measures of where a contact location lies on the body; they need no mechanics.

Weak locations go with them (`estimator.information.weak_areas`): the distance to the border of the
patch, to the spot over the nearest magnet and on to a sensor, and the surface's curvature.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.places.positions import (
    SensorLayout,
    magnet_layout,
    sensor_layout,
    shell_body_layout,
)
from design.layout.pockets import shell_bodies
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

Measure = Literal["border_mm", "magnet_mm", "path_mm", "curvature_per_mm"]
MEASURES: tuple[Measure, ...] = ("border_mm", "magnet_mm", "path_mm", "curvature_per_mm")
SENSOR_SHARE = 0.6
"""Share of a magnet's distance to its nearest sensor, in the signal path (docs/measured/studies.md)."""
LONGEST_PATH_MM = 15.0
"""Signal path to which position bounds keep 1.5 mm at 8 N, in the median (docs/measured/studies.md)."""
_BORDER_POINTS = 120
"""Points round the border of a place."""
_PATH_STEPS = 12
"""Pieces into which a path along the surface is cut."""
_SLOPE_STEP_MM = 0.05
"""Half the distance of the points whose difference quotient is a slope."""


@dataclass(frozen=True)
class PlaceMeasures:
    """Measures of where every contact location lies on the body; NaN at places that a face has not.

    Attributes
    ----------
    border_mm : along the surface, to the border of the location's patch (a box's edge)
    magnet_mm : straight, to the point of the surface over the nearest magnet of any face; in the
        reverse arrangement over the nearest sensor board, which moves in a magnet's place
    path_mm : the signal path: `magnet_mm` and 0.6 of that magnet's distance to the nearest sensor
        of the pressed face, for the magnet of which this is least
    curvature_per_mm : mean curvature of the surface: 0 on a plane, 1/R on a ball, 1/(2 R) round a
        cylinder, negative in a hollow
    """

    border_mm: Float[np.ndarray, "face place"]
    magnet_mm: Float[np.ndarray, "face place"]
    path_mm: Float[np.ndarray, "face place"]
    curvature_per_mm: Float[np.ndarray, "face place"]


@cached_geometry
def place_measures(spec: ObjectSpec) -> PlaceMeasures:
    """Measures of every contact location of every sensed face; needs no mechanics."""
    xy, frames = contact_grid(spec).xy_mm, face_frames(spec)
    spots, moving = spots_over_bodies(spec), shell_body_layout(spec).centre_mm
    fixed = sensor_layout(spec) if spec.arrangement == "sensors-in-core" else magnet_layout(spec)
    centres = fixed.position_mm if isinstance(fixed, SensorLayout) else fixed.centre_mm
    measures = np.full((len(MEASURES), len(frames), len(xy)), np.nan)
    for row, (frame, has_place) in enumerate(zip(frames, contact_places(spec), strict=True)):
        plane_mm = frame.to_plane(xy[has_place])
        touched = frame.to_object(np.column_stack([plane_mm, np.zeros(len(plane_mm))]))
        away = np.linalg.norm(touched[:, None] - spots, axis=-1)
        path = signal_paths_mm(away, moving, centres[fixed.face == frame.number])
        measures[:, row, has_place] = (
            border_distance_mm(frame, plane_mm),
            away.min(axis=1),
            path,
            curvature(frame, plane_mm),
        )
    return PlaceMeasures(*measures)


def spots_over_bodies(spec: ObjectSpec) -> Float[np.ndarray, "body 3"]:
    """Points of the surface over what moves with the silicone, face by face (mm)."""
    return np.concatenate(
        [
            frame.to_object(np.array([(*body.centre_mm[:2], 0.0) for body in bodies]))
            for frame, bodies in zip(face_frames(spec), shell_bodies(spec), strict=True)
        ]
    )


def signal_paths_mm(
    away_mm: Float[np.ndarray, "place body"],
    moving_mm: Float[np.ndarray, "body 3"],
    fixed_mm: Float[np.ndarray, "part 3"],
) -> Float[np.ndarray, "place"]:
    """Signal paths, from distances between places and moving bodies, and centres of both parts."""
    between = np.linalg.norm(moving_mm[:, None] - fixed_mm, axis=-1).min(axis=1)
    return np.asarray((away_mm + SENSOR_SHARE * between).min(axis=1))


def border_distance_mm(frame: FaceFrame, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    """Shortest way along the surface to the patch's border, straight in the frame's plane."""
    half = np.asarray(frame.half_extents_mm)
    if frame.round:
        turn = np.linspace(0, 2 * np.pi, _BORDER_POINTS, endpoint=False)
        ring = half * np.column_stack([np.cos(turn), np.sin(turn)])
        ends = np.broadcast_to(ring, (len(xy_mm), *ring.shape))
    else:
        ends = np.repeat(xy_mm[:, None], 4, axis=1)
        ends[:, 0, 0], ends[:, 1, 0], ends[:, 2, 1], ends[:, 3, 1] = (
            half[0],
            -half[0],
            half[1],
            -half[1],
        )
    share = np.linspace(0, 1, _PATH_STEPS + 1)[:, None]
    way = xy_mm[:, None, None] + share * (ends - xy_mm[:, None])[:, :, None]
    height, _ = frame.relief.evaluate(way * (1 - 1e-9))
    points = np.concatenate([way, height[..., None]], axis=-1)
    steps = np.linalg.norm(np.diff(points, axis=2), axis=-1)
    return np.asarray(steps.sum(axis=2).min(axis=1))


def curvature(frame: FaceFrame, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
    """Mean curvature of the surface at places, 1/mm, positive where it bulges out."""
    _, slope = frame.relief.evaluate(xy_mm)
    bend = np.stack(
        [
            (frame.relief.evaluate(xy_mm + step)[1] - frame.relief.evaluate(xy_mm - step)[1])
            / (2 * _SLOPE_STEP_MM)
            for step in _SLOPE_STEP_MM * np.eye(2)
        ],
        axis=1,
    )
    p, q = slope.T
    cross = (bend[:, 0, 1] + bend[:, 1, 0]) / 2
    top = (1 + q**2) * bend[:, 0, 0] - 2 * p * q * cross + (1 + p**2) * bend[:, 1, 1]
    return 0.0 - top / (2 * (1 + p**2 + q**2) ** 1.5)
