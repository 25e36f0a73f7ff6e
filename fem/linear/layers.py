"""Stiffness of the elements of a layered body: the mean over each tetrahedron, by layers."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.layout.body import body_of
from design.spec.object import ObjectSpec

_DIVISIONS = 6
"""Points along an edge at which an element is asked for its layer: 84 in all."""


def layer_stiffness(
    corners_mm: Float[np.ndarray, "tet 4 3"], spec: ObjectSpec
) -> Float[np.ndarray, "tet"] | None:
    """Mean Young's modulus of every element over the body's; None without layers.

    Layers end at equal distances from the core, wherever the mesh has its nodes: an element that two
    of them share takes the mean by volume, an upper bound of its stiffness.
    """
    layers = spec.silicone.layers
    if not layers:
        return None
    body = body_of(spec)
    ends = body.thickness_mm - np.cumsum([depth_mm for depth_mm, _ in layers])
    ratios = np.array([*(ratio for _, ratio in layers), 1.0])
    total = np.zeros(len(corners_mm))
    points = inner_points()
    for weights in points:
        # A point of each tet by its barycentric weights: k corner, t tet, d coordinate
        distance = body.core_distance_mm(np.einsum("k,tkd->td", weights, corners_mm))
        total += ratios[np.sum(distance[:, None] < ends, axis=1)]
    return total / len(points)


def inner_points() -> Float[np.ndarray, "point 4"]:
    """Barycentric coordinates spread evenly over a tetrahedron, none on its surface."""
    n = _DIVISIONS
    grid = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    inner = grid[grid.sum(axis=1) < n] + 0.25
    shares = inner / n
    return np.column_stack([shares, 1 - shares.sum(axis=1)])
