"""Surfaces such as users bring in files: lumps, bottles, bananas, peanuts, frustums, vases."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import trimesh
from jaxtyping import Float

Points = Float[np.ndarray, "n 3"]


def foreign_shape(rng: np.random.Generator, longest_mm: float) -> trimesh.Trimesh:
    """A closed surface of a random shape, turned at random about z, half of them laid on their side.

    Its longest edge is `longest_mm`.
    """
    surface = SHAPES[rng.integers(len(SHAPES))](rng)
    if rng.random() < 0.5:
        surface.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [1, 0, 0]))
    turn = float(rng.uniform(0, 2 * np.pi))
    surface.apply_transform(trimesh.transformations.rotation_matrix(turn, [0, 0, 1]))
    return surface.apply_scale(longest_mm / max(surface.extents))


def _ball() -> tuple[trimesh.Trimesh, Points]:
    surface = trimesh.creation.icosphere(4, 1.0)
    return surface, np.array(surface.vertices)


def _lump(rng: np.random.Generator) -> trimesh.Trimesh:
    """A drawn-out ball with bumps and dents."""
    surface, points = _ball()
    radius = np.ones(len(points))
    for _ in range(int(rng.integers(2, 7))):
        middle = rng.normal(size=3)
        away = np.linalg.norm(points - middle / np.linalg.norm(middle), axis=1)
        radius += rng.uniform(-0.15, 0.3) * np.exp(-((away / rng.uniform(0.35, 0.8)) ** 2))
    surface.vertices = radius[:, None] * points * rng.uniform(0.7, 1.0, 3)
    return surface


def _peanut(rng: np.random.Generator) -> trimesh.Trimesh:
    surface, points = _ball()
    waist = rng.uniform(0.1, 0.35)
    radius = 1 + waist * (2 * points[:, 2] ** 2 - 1)
    surface.vertices = radius[:, None] * points * [1.0, rng.uniform(0.85, 1.0), 1.0]
    return surface


def _banana(rng: np.random.Generator) -> trimesh.Trimesh:
    """An ellipsoid, its long axis bent to an arc."""
    surface, points = _ball()
    slim = points * [rng.uniform(0.3, 0.5), rng.uniform(0.3, 0.5), 1.0]
    bend = rng.uniform(1.2, 3.0)  # radius of the arc over half the length
    angle, out = slim[:, 2] / bend, bend - slim[:, 0]
    surface.vertices = np.column_stack(
        [bend - out * np.cos(angle), slim[:, 1], out * np.sin(angle)]
    )
    return surface


def _bottle(rng: np.random.Generator) -> trimesh.Trimesh:
    """A round body, a shoulder and a neck."""
    z = np.linspace(0.0, 1.0, 60)
    body, neck = rng.uniform(0.2, 0.32), rng.uniform(0.45, 0.8)
    shoulder, soft = rng.uniform(0.55, 0.75), rng.uniform(0.03, 0.08)
    radius = body * (1 - (1 - neck) / (1 + np.exp(-(z - shoulder) / soft)))
    return _turned(z, radius, float(rng.uniform(0.03, 0.1)))


def _vase(rng: np.random.Generator) -> trimesh.Trimesh:
    """Belly and waist, some with flutes."""
    z = np.linspace(0.0, 1.0, 60)
    waves, phase = rng.uniform(0.4, 1.0), rng.uniform(0, 2 * np.pi)
    radius = rng.uniform(0.25, 0.4) * (
        1 + rng.uniform(0.08, 0.25) * np.sin(2 * np.pi * waves * z + phase)
    )
    surface = _turned(z, radius, float(rng.uniform(0.02, 0.08)))
    if rng.random() < 0.4:
        points = np.array(surface.vertices)
        flutes = rng.integers(5, 12) * np.arctan2(points[:, 1], points[:, 0])
        points[:, :2] *= 1 + rng.uniform(0.02, 0.05) * np.cos(flutes)[:, None]
        surface.vertices = points
    return surface


def _turned(z: np.ndarray, radius: np.ndarray, round_off: float) -> trimesh.Trimesh:
    """A profile over z from 0 to 1 turned about z, its rims rounded."""
    end = np.minimum(z, 1 - z).clip(0, round_off)
    inwards = round_off - np.sqrt(round_off**2 - (round_off - end) ** 2)
    profile = np.column_stack([radius - inwards, z])
    return trimesh.creation.revolve(np.concatenate([[[0, 0]], profile, [[0, 1]]]), sections=72)


def _frustum(rng: np.random.Generator) -> trimesh.Trimesh:
    """Of a cone or of a pyramid of four to eight sides, its top shifted."""
    sides = 64 if rng.random() < 0.4 else int(rng.integers(4, 9))
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    top = rng.uniform(0.5, 0.95) * ring + rng.uniform(-0.1, 0.1, 2)
    high = rng.uniform(0.8, 2.5)
    corners = np.vstack([np.c_[ring, np.zeros(sides)], np.c_[top, np.full(sides, high)]])
    return trimesh.Trimesh(corners).convex_hull


SHAPES: tuple[Callable[[np.random.Generator], trimesh.Trimesh], ...] = (
    _lump,
    _bottle,
    _banana,
    _peanut,
    _frustum,
    _vase,
)
