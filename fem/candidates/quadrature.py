"""Points and weights over the rigid bodies in the silicone: their cross-section and their skin."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.layout.pockets import Outline


def outline_quadrature(
    outline: Outline, radial: int, around: int
) -> tuple[Float[np.ndarray, "point 2"], Float[np.ndarray, "point"]]:
    """Mean over a cross-section, weights summing to 1.

    A disk takes `radial` circles of `around` points, exact for polynomials up to degree
    min(2 radial, around) − 1; a rectangle takes `around // 2` Gauss points each way.
    """
    if not outline.round:
        node, weight = np.polynomial.legendre.leggauss(max(2, around // 2))
        x, y = np.meshgrid(node * outline.half_mm[0], node * outline.half_mm[1], indexing="ij")
        return np.column_stack([x.ravel(), y.ravel()]), np.outer(weight, weight).ravel() / 4
    node, weight = np.polynomial.legendre.leggauss(radial)
    radius = outline.half_mm[0] * np.sqrt((node + 1) / 2)
    theta = 2 * np.pi * (np.arange(around) + 0.5) / around
    points = np.stack([np.outer(radius, np.cos(theta)), np.outer(radius, np.sin(theta))], axis=-1)
    return points.reshape(-1, 2), np.repeat(weight / 2 / around, around)


def skin_quadrature(
    outline: Outline, height_mm: float, radial: int = 8, around: int = 24
) -> tuple[Float[np.ndarray, "point 3"], Float[np.ndarray, "point"]]:
    """Mean over the closed surface of a body about its centre, weights summing to 1."""
    flat, flat_weight = outline_quadrature(outline, radial, around)
    rim, rim_weight = _rim_quadrature(outline, around)
    level, level_weight = np.polynomial.legendre.leggauss(2)
    half = height_mm / 2
    points = [np.column_stack([flat, np.full(len(flat), side * half)]) for side in (1, -1)]
    points += [np.column_stack([rim, np.full(len(rim), z * half)]) for z in level]
    weights = [flat_weight * outline.area_mm2] * 2
    weights += [rim_weight * weight * half for weight in level_weight]
    weight = np.concatenate(weights)
    return np.concatenate(points), weight / weight.sum()


def _rim_quadrature(outline: Outline, around: int) -> tuple[np.ndarray, np.ndarray]:
    """Points along the outline and the length (mm) that each stands for."""
    if outline.round:
        theta = 2 * np.pi * (np.arange(around) + 0.5) / around
        radius = outline.half_mm[0]
        points = radius * np.column_stack([np.cos(theta), np.sin(theta)])
        return points, np.full(around, 2 * np.pi * radius / around)
    node, weight = np.polynomial.legendre.leggauss(max(2, around // 4))
    x, y = outline.half_mm
    ones = np.ones_like(node)
    sides = [(x * ones, y * node, y), (-x * ones, y * node, y), (x * node, y * ones, x)]
    sides.append((x * node, -y * ones, x))
    points = np.concatenate([np.column_stack([a, b]) for a, b, _ in sides])
    return points, np.concatenate([half * weight for *_, half in sides])
