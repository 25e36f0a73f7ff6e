"""Magnets in random poses: the field of all together, and magpylib's as an independent oracle."""

import magpylib
import numpy as np
from scipy.spatial.transform import Rotation

from estimator.field.models import sum_over_magnets
from estimator.field.sources import DiskMagnet

DISKS = [DiskMagnet(6.0, 1.0, 1.43), DiskMagnet(4.0, 5.0, 1.1), DiskMagnet(9.0, 0.5, -1.2)]
POSES = 1500


def random_poses(disk, nearest_mm, rng, count=POSES):
    """Magnets anywhere, turned anyhow, and points from `nearest_mm` outward."""
    turn = Rotation.random(count, rng=rng)
    centre = rng.uniform(-20, 20, (count, 3))
    direction = rng.standard_normal((count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    distance = nearest_mm * rng.uniform(1, 3, (count, 1))
    return turn, centre, centre + distance * direction


def magpylib_field(disk, turn, centre, point):
    """Independent oracle: magpylib's own poses, lengths in metres."""
    field = [
        magpylib.magnet.Cylinder(
            polarization=(0, 0, disk.polarization_t),
            dimension=(disk.diameter_mm / 1e3, disk.height_mm / 1e3),
            position=c / 1e3,
            orientation=r,
        ).getB(p / 1e3)
        for r, c, p in zip(turn, centre, point, strict=True)
    ]
    return np.array(field)


def relative_error(field, exact):
    return np.linalg.norm(field - exact, axis=1) / np.linalg.norm(exact, axis=1)


def total_field(points, centres, axes, model, sides=None):
    """Flux density (T) of all magnets together at points (mm), both (many, 3)."""
    centre, axis = (tuple(given.T[:, :, None]) for given in (centres, axes))
    side = None if sides is None else tuple(sides.T[:, :, None])
    return np.stack(sum_over_magnets(tuple(points.T[:, None]), centre, axis, model, side), axis=-1)
