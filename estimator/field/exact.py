"""Exact fields of uniformly polarized cylinders and cuboids, valid up to the edges.

B per polarization depends on ratios of lengths alone, so that mm need no conversion. Inside a magnet
B is its flux density, polarization included.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from jaxtyping import Float
from scipy.special import elliprf, elliprj

from estimator.field.sources import BlockMagnet, DiskMagnet, in_space, local_coordinates
from estimator.field.vectors import Vector

_NOTHING = 1e-100
"""Length that stands for 0 in a denominator: its square is still a number."""


def cylinder_field(offset_mm: Vector, axis: Vector, disk: DiskMagnet) -> Vector:
    """Exact field of a disk or a ring (outer less inner cylinder). Three arrays, T."""
    offset = np.stack(np.broadcast_arrays(*offset_mm), axis=-1).astype(float)
    direction = np.broadcast_to(np.stack(np.broadcast_arrays(*axis), axis=-1), offset.shape)
    along = np.sum(offset * direction, axis=-1)
    across = offset - along[..., None] * direction
    distance = np.linalg.norm(across, axis=-1)
    parts = [
        weight * _axial_field(disk.height_mm / 2 / radius, distance / radius, along / radius)
        for radius, weight in disk.cylinders
    ]
    b_radial, b_axial = disk.polarization_t * np.sum(parts, axis=0)
    outward = across / np.maximum(distance, 1e-300)[..., None]
    field = b_radial[..., None] * outward + b_axial[..., None] * direction
    return field[..., 0], field[..., 1], field[..., 2]


def _axial_field(
    half_height: float, distance: np.ndarray, along: np.ndarray
) -> Float[np.ndarray, "2 *any"]:
    """Radial and axial B per T of a cylinder polarized along its axis; lengths in its radii.

    Derby and Olbert, Am. J. Phys. 78 (2010) 229: one generalised complete elliptic
    integral for each end of the cylinder.
    """
    gamma = (1 - distance) / (1 + distance)
    squared = np.maximum(gamma**2, _NOTHING)  # at the radius itself its factor below is 0
    radial, axial = np.zeros_like(distance), np.zeros_like(distance)
    for sign in (1, -1):
        end = along + sign * half_height
        edge = np.hypot(end, 1 + distance)
        modulus = np.maximum((end**2 + (1 - distance) ** 2) / edge**2, _NOTHING)
        radial += sign * _cel(modulus, 1.0, -1.0) / edge
        axial += sign * end * _cel(modulus, squared, gamma) / edge
    return np.stack([radial, axial / (1 + distance)]) / np.pi


def _cel(kc_squared: np.ndarray, p: np.ndarray | float, b: np.ndarray | float) -> np.ndarray:
    """Bulirsch's integral cel(kc, p, 1, b) by Carlson's forms (DLMF 19.25.2)."""
    rest = (b - p) / 3 * elliprj(0, kc_squared, 1, p)
    return elliprf(0, kc_squared, 1) + rest


def cuboid_field(
    offset_mm: Vector, axis: Vector, block: BlockMagnet, side: Vector | None = None
) -> Vector:
    """Exact field of a block: that of its two charged faces, the polarization inside. Three arrays, T.

    Integrals of a rectangle of charge, Akoun and Yonnet, IEEE Trans. Magn. 20 (1984) 1962.
    """
    along, first, second = np.broadcast_arrays(*local_coordinates(offset_mm, axis, side))
    x, y, z = (np.zeros(along.shape) for _ in range(3))
    a, b, c = (length / 2 for length in (*block.size_mm, block.height_mm))
    for i, j, k in product((1, -1), repeat=3):
        sign, u, v, w = i * j * k, first + i * a, second + j * b, along + k * c
        # asinh(v / h) is ln(v + r) less ln h, which the other corner of the edge takes away again
        x += sign * np.arcsinh(v / np.maximum(np.hypot(u, w), _NOTHING))
        y += sign * np.arcsinh(u / np.maximum(np.hypot(v, w), _NOTHING))
        # the solid angle of a face jumps by 4π where a point passes to its other side: atan2 does too
        z -= sign * np.arctan2(u * v, w * np.sqrt(u**2 + v**2 + w**2))
    scale = block.polarization_t / (4 * np.pi)
    return in_space((scale * z, scale * x, scale * y), axis, side)
