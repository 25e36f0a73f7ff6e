"""Wanted edge lengths of the mesh, on a background grid for the mesher."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from jaxtyping import Float, Int

from design.layout.body import face_frames
from design.spec.object import ObjectSpec

EdgeLength = Callable[[Float[np.ndarray, "point 3"]], Float[np.ndarray, "point"]]
"""Wanted edge lengths (mm) at points of the object's frame (mm)."""

_SIZING_STEP_MM = 2.0
FINE_LAYER_MM = 0.5


@dataclass(frozen=True)
class EdgeLengths:
    """Background mesh with the target edge length at its points."""

    points_mm: Float[np.ndarray, "point 3"]
    tets: Int[np.ndarray, "brick_tet 4"]
    length_mm: Float[np.ndarray, "point"]


def edge_length_field(spec: ObjectSpec, edge_length: EdgeLength | None = None) -> EdgeLengths:
    """Background mesh of target edge lengths."""
    half = np.asarray(spec.body.size_mm) / 2
    axes = [
        np.linspace(-h - 1, h + 1, int(np.ceil(2 * (h + 1) / _SIZING_STEP_MM)) + 1) for h in half
    ]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    tets = _split_bricks(tuple(len(axis) for axis in axes)).astype(np.int32)
    edge_length = edge_length or partial(_fine_under_all_faces, spec)
    return EdgeLengths(points, tets, edge_length(points))


def _fine_under_all_faces(spec: ObjectSpec, points_mm: np.ndarray) -> np.ndarray:
    """Fine under the sensed faces, coarse in the bulk."""
    below = np.full(len(points_mm), np.inf)
    for frame in face_frames(spec):
        local = frame.from_object(points_mm)
        under = frame.flat | frame.covers(local[:, :2])
        below = np.minimum(below, np.where(under, -local[:, 2], np.inf))
    below = np.clip(below - FINE_LAYER_MM, 0, None) / (spec.shell.thickness_mm / 2)
    fine, coarse = spec.mesh.surface_edge_mm, spec.mesh.edge_mm
    return fine + (coarse - fine) * np.clip(below, 0, 1)


def _split_bricks(shape: tuple[int, ...]) -> np.ndarray:
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
