"""Scans made castable: without noise, and as convex bodies that two halves of a mould let go."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.meshes import distance_mm, manifold_of

if TYPE_CHECKING:
    import trimesh

_SIMPLIFIED_MM = 0.05
"""Tolerance within which a scan's triangles are merged: less than a printed layer."""
_DIRECTIONS = 6000
"""Directions, evenly over the sphere, in which the even body is supported: 2.5° apart, so that between them a
ball of radius r is short of r by a part in 1600 at most (0.02 mm of 30 mm)."""
_SAMPLES = 3000
"""Points of the convex body at which its distance to the scan is measured."""
_NOISE_MM = 0.02
"""Noise of a scan's corners (one standard deviation) from which they are smoothed: as much as a tenth of a
printed layer."""
_FEWEST_CORNERS = 1000
"""A file of fewer corners is drawn, not scanned."""
_MOST_MOVED = 3.0
"""Times its noise by which half of a scan's corners may be moved: smoothing moves them farther where it takes
shape away, as from sharp edges."""
_REST_OF_NOISE = 1.36
"""Standard deviation of what `noise_mm` leaves of independent noise of deviation 1, where corners have six
neighbours: drawn, on meshes of 2 500 and 41 000 corners."""
_SMOOTHINGS, _SHRINK, _GROW = 20, 0.5, 0.53
"""Taubin's smoothing (1995): steps in turn towards the neighbours' mean and away from it, which keep the
volume. Twenty leave a twentieth of independent noise."""


@dataclass(frozen=True)
class CastableBody:
    """A convex body with y → −y as its mirror image: a seam in y = 0 hooks nothing.

    Attributes
    ----------
    surface : closed, along the axes of the hull's tightest box and longest along z, its middle in the
        origin
    off_mm : largest and median distance to the scan of the surface whose hollows are filled; over a deep
        hollow that is the distance to its nearest wall
    evened_mm : largest distance by which both sides were moved to be mirror images
    """

    surface: trimesh.Trimesh
    off_mm: tuple[float, float]
    evened_mm: float


def noise_mm(surface: trimesh.Trimesh) -> float:
    """Return the noise of a surface's corners along their normals: one standard deviation (mm).

    A corner's height over its neighbours' mean is curvature and noise; curvature is nearly the same at the
    neighbours. What is left of the difference is noise, by the median, which sharp edges do not move.
    """
    from trimesh.smoothing import laplacian_calculation

    neighbours = laplacian_calculation(
        surface
    )  # rows that take the mean over a corner's neighbours
    corners = np.asarray(surface.vertices)
    # a corner's height is the component of its offset along its normal
    heights = np.sum((corners - neighbours @ corners) * surface.vertex_normals, axis=1)
    rest = heights - neighbours @ heights
    # 1.4826 median deviations are one standard deviation of a normal distribution
    return float(1.4826 * np.median(abs(rest - np.median(rest)))) / _REST_OF_NOISE


def without_noise(scan: trimesh.Trimesh) -> tuple[trimesh.Trimesh, float]:
    """Return a scan smoothed, its box's middle in the origin, and how far a corner was moved at most (mm).

    The scan itself and 0 where it has no noise, or where smoothing would take shape away. Noise that
    neighbouring corners share is not seen and stays.
    """
    import trimesh

    noise = noise_mm(scan)
    if len(scan.vertices) < _FEWEST_CORNERS or noise < _NOISE_MM:
        return scan, 0.0
    smooth = scan.copy()
    trimesh.smoothing.filter_taubin(smooth, _SHRINK, _GROW, _SMOOTHINGS)
    moved = np.linalg.norm(smooth.vertices - scan.vertices, axis=1)
    if np.median(moved) > _MOST_MOVED * noise:
        return scan, 0.0
    smooth.apply_translation(-smooth.bounds.mean(axis=0))
    return smooth, float(moved.max())


def castable_body(scan: trimesh.Trimesh) -> CastableBody:
    """Return the convex hull of a closed surface, turned into its tightest box and made even.

    Minkowski's mean of a convex body and its mirror image is convex and its own mirror image; its widest
    section is then that by the mirror plane. Of the planes across the box's two shorter edges the
    one that moves the surface less is taken.
    """
    import trimesh

    simple = manifold_of(scan).simplify(_SIMPLIFIED_MM).to_mesh64()
    scan = trimesh.Trimesh(simple.vert_properties[:, :3], simple.tri_verts.astype(np.int64))
    hull = scan.convex_hull
    to_box, _ = trimesh.bounds.oriented_bounds(hull)
    hull.apply_transform(to_box)
    scan.apply_transform(to_box)
    points = trimesh.sample.sample_surface(hull, _SAMPLES, seed=0)[0]
    gaps = distance_mm(scan, np.asarray(points))
    *shorter, longest = np.argsort(hull.extents).tolist()
    evened = {axis: _evened(hull, np.eye(3)[axis]) for axis in shorter}
    mirrored = min(shorter, key=lambda axis: evened[axis][1])
    surface, moved_mm = evened[mirrored]
    surface.apply_transform(_axes_to_y_and_z(mirrored, longest))
    surface.apply_translation(-surface.bounds.mean(axis=0))
    return CastableBody(surface, (float(gaps.max()), float(np.median(gaps))), moved_mm)


def _evened(hull: trimesh.Trimesh, normal: Float[np.ndarray, "3"]) -> tuple[trimesh.Trimesh, float]:
    """Return Minkowski's mean of a hull and its mirror image, and the Hausdorff distance to the hull.

    By its points of support, in even directions and along the normals of the facets of both.
    """
    import trimesh

    corners, facets = np.asarray(hull.vertices), np.asarray(hull.face_normals)
    ways = np.concatenate([even_directions(_DIRECTIONS), facets, _mirrored(facets, normal)])
    support = corners[np.argmax(ways @ corners.T, axis=1)]
    mirrored_support = _mirrored(
        corners[np.argmax(_mirrored(ways, normal) @ corners.T, axis=1)], normal
    )
    points = (support + mirrored_support) / 2
    # the distance of convex bodies is the largest difference of their support functions
    moved = float(np.max(abs(np.sum((support - points) * ways, axis=1))))
    both = np.concatenate([points, _mirrored(points, normal)])
    return trimesh.convex.convex_hull(both), moved


def _mirrored(
    vectors: Float[np.ndarray, "n 3"], normal: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "n 3"]:
    return vectors - 2 * np.outer(vectors @ normal, normal)


def even_directions(count: int) -> Float[np.ndarray, "way 3"]:
    """Return unit vectors along a spiral."""
    steps = np.arange(count) + 0.5
    z, turn = 1 - 2 * steps / count, np.pi * (1 + np.sqrt(5)) * steps
    level = np.sqrt(1 - z**2)
    return np.column_stack([level * np.cos(turn), level * np.sin(turn), z])


def _axes_to_y_and_z(mirrored: int, longest: int) -> Float[np.ndarray, "4 4"]:
    """Return the turn that takes one axis to y and another to z."""
    turn = np.zeros((4, 4))
    turn[[0, 1, 2, 3], [3 - mirrored - longest, mirrored, longest, 3]] = 1.0
    # a turn, not a mirror image: its determinant is 1
    turn[0] *= np.linalg.det(turn)
    return turn
