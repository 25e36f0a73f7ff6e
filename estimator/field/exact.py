"""Exact fields of uniformly polarized cylinders and cuboids, by magpylib, valid up to the edges.

B per polarization depends on ratios of lengths alone, so that mm need no conversion. Inside a magnet
B is its flux density, polarization included.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from jaxtyping import Float

from estimator.field.sources import (
    BlockMagnet,
    DiskMagnet,
    from_local_coordinates,
    local_coordinates,
)
from estimator.field.vectors import Vector


def cylinder_field(offset_mm: Vector, axis: Vector, disk: DiskMagnet) -> Vector:
    """Exact field of a disk or a ring (outer less inner cylinder).

    magpylib's axial solution (Derby and Olbert, Am. J. Phys. 78, 2010) works on lengths divided
    by the cylinder's radius. Three arrays, T.
    """
    offset = np.stack(np.broadcast_arrays(*offset_mm), axis=-1).astype(float)
    direction = np.broadcast_to(np.stack(np.broadcast_arrays(*axis), axis=-1), offset.shape)
    axial = np.sum(offset * direction, axis=-1)
    across = offset - axial[..., None] * direction
    distance = np.linalg.norm(across, axis=-1)
    parts = [
        weight * _axial_field(radius, disk.height_mm / 2, distance, axial)
        for radius, weight in disk.cylinders
    ]
    b_radial, b_axial = disk.polarization_t * np.sum(parts, axis=0)
    outward = across / np.maximum(distance, 1e-300)[..., None]
    field = b_radial[..., None] * outward + b_axial[..., None] * direction
    return field[..., 0], field[..., 1], field[..., 2]


def _axial_field(
    radius: float, half_height: float, distance: np.ndarray, axial: np.ndarray
) -> Float[np.ndarray, "2 *any"]:
    """Radial and axial B per T of polarization."""
    from magpylib.core import magnet_cylinder_axial_Bfield

    b_radial, _, b_axial = magnet_cylinder_axial_Bfield(
        z0=np.full(axial.size, half_height / radius),
        r=distance.ravel() / radius,
        z=axial.ravel() / radius,
    )
    return np.stack([b_radial, b_axial]).reshape(2, *axial.shape)


def cuboid_field(
    offset_mm: Vector, axis: Vector, block: BlockMagnet, side: Vector | None = None
) -> Vector:
    """Exact field of a block (Yang et al., Supercond. Sci. Technol. 3, 1990). Three arrays, T."""
    from magpylib.core import magnet_cuboid_Bfield

    axial, first, second = np.broadcast_arrays(*local_coordinates(offset_mm, axis, side))
    points = np.stack([first, second, axial], axis=-1).reshape(-1, 3)
    local: Any = magnet_cuboid_Bfield(
        observers=points,
        dimensions=np.tile([*block.size_mm, block.height_mm], (len(points), 1)),
        polarizations=np.tile([0.0, 0.0, block.polarization_t], (len(points), 1)),
    )
    x, y, z = (local[:, i].reshape(axial.shape) for i in range(3))
    return from_local_coordinates((z, x, y), axis, side)
