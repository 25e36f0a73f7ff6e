"""Wanted edge lengths of the mesh, on a background grid for the mesher."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from jaxtyping import Float, Int

from design.layout.body import face_frames
from design.layout.places.positions import ShellBodies, shell_body_layout
from design.spec.object import ObjectSpec

EdgeLength = Callable[[Float[np.ndarray, "point 3"]], Float[np.ndarray, "point"]]
"""Wanted edge lengths (mm) at points of the object's frame (mm)."""

_STEP_MM, _STEP_AT_RIMS_MM = 2.0, 1.0
"""Steps of the grid that holds the edge lengths; finer where rims are."""
_GRID_POINTS = 250_000
"""Points of that grid, at most about: larger bodies have larger steps."""
FINE_LAYER_MM = 0.5
"""Depth below the surface down to which its fine edges stay."""
_RIM_GROWTH = 0.7
"""Growth of the edges (mm per mm) away from the rims of rigid bodies."""


@dataclass(frozen=True)
class EdgeLengths:
    """Background mesh with the target edge length at its points."""

    points_mm: Float[np.ndarray, "point 3"]
    tets: Int[np.ndarray, "brick_tet 4"]
    length_mm: Float[np.ndarray, "point"]


def edge_length_field(
    spec: ObjectSpec, edge_length: EdgeLength | None = None, magnets: bool = True
) -> EdgeLengths:
    """Background mesh of target edge lengths, by default with fine rims where magnets are meshed."""
    half = np.asarray(spec.body.size_mm) / 2
    finest = _STEP_AT_RIMS_MM if spec.mesh.rim_edge_ratio < 1 else _STEP_MM
    step = np.clip((np.prod(2 * half + 2) / _GRID_POINTS) ** (1 / 3), finest, _STEP_MM)
    axes = [np.linspace(-h - 1, h + 1, int(np.ceil(2 * (h + 1) / step)) + 1) for h in half]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    tets = split_bricks(tuple(len(axis) for axis in axes)).astype(np.int32)
    if edge_length is None:
        rims = magnets and spec.mesh.rim_edge_ratio < 1
        edge_length = partial(_fine_at_rims if rims else fine_under_all_faces, spec)
    return EdgeLengths(points, tets, edge_length(points))


def _fine_at_rims(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    """Fine under the sensed faces, finer at the rims of rigid bodies, where stress is singular.

    P2 elements of size h leave an error of order h^1.2 there, several times that of all others: a
    right angle of something rigid in incompressible silicone has displacements like r^0.6.
    """
    rim = spec.mesh.finest_edge_mm
    from_wall = wall_distance_mm(shell_body_layout(spec), points_mm)
    return np.minimum(fine_under_all_faces(spec, points_mm), rim + _RIM_GROWTH * from_wall)


def wall_distance_mm(layout: ShellBodies, points_mm: np.ndarray) -> np.ndarray:
    """Distance of points to the nearest side wall of a rigid body."""
    distance = np.full(len(points_mm), np.inf)
    for centre, frame, body in zip(layout.centre_mm, layout.frame, layout.bodies, strict=True):
        local = abs((points_mm - centre) @ frame)
        across = body.outline.signed_distance_mm(local[:, :2])
        beyond_height = np.clip(local[:, 2] - body.height_mm / 2, 0, None)
        distance = np.minimum(distance, np.hypot(across, beyond_height))
    return distance


def fine_under_all_faces(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    """Fine under the sensed faces, coarse in the bulk."""
    below = np.full(len(points_mm), np.inf)
    for frame in face_frames(spec):
        local = frame.from_object(points_mm)
        under = frame.flat | frame.touched(local[:, :2])
        below = np.minimum(below, np.where(under, -local[:, 2], np.inf))
    below = np.clip(below - FINE_LAYER_MM, 0, None) / (spec.shell.thickness_mm / 2)
    fine, coarse = spec.mesh.surface_edge_mm, spec.mesh.edge_mm
    return fine + (coarse - fine) * np.clip(below, 0, 1)


def split_bricks(shape: tuple[int, ...]) -> np.ndarray:
    """Six tetrahedra (Kuhn) in every brick of a structured grid of `shape` points."""
    index = np.arange(int(np.prod(shape))).reshape(shape)
    cells = tuple(n - 1 for n in shape)

    def corner(offset: tuple[int, ...]) -> np.ndarray:
        window = tuple(slice(o, o + n) for o, n in zip(offset, cells, strict=True))
        return index[window].ravel()

    tets = []
    for order in itertools.permutations(range(3)):
        offset = [0, 0, 0]
        path = [corner((0, 0, 0))]
        for axis in order:
            offset[axis] = 1
            path.append(corner((offset[0], offset[1], offset[2])))
        even = order in {(0, 1, 2), (1, 2, 0), (2, 0, 1)}
        tets.append(np.stack(path if even else [path[0], path[2], path[1], path[3]], axis=1))
    return np.concatenate(tets)
