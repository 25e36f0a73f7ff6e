"""Scans made castable: without noise, and as bodies that two halves of a mould let go."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float
from scipy.ndimage import gaussian_filter, map_coordinates

from design.body.imported import FEWEST_CORNERS, GRID_POINTS, MERGED_MM
from design.body.meshes import distance_mm, simplified
from design.body.sampled import contour_of, measured_on_grid

if TYPE_CHECKING:
    import trimesh

_SMOOTHED_STEPS = 0.7
"""Standard deviation, in steps of the grid, by which distances are smoothed: noise that neighbouring corners
share goes, and edges lose some tenths of a millimetre."""
_NEARLY_CONVEX, _SHALLOW = 1.1, 0.1
"""Volume of a body's convex hull over its own, and depth of hollows over its shortest edge, up to which the
hull is taken: those of cans with rims, not of bottles with a neck."""
_SAMPLES = 3000
"""Points of a surface at which its distance to another is measured."""
_AS_LITTLE_MM = 1.0
"""Distance by which a scan may stand farther out of one body than of another that counts as good."""
_NOISE_MM = 0.02
"""Noise of a scan's corners (one standard deviation) from which it is a scan: a tenth of a printed layer."""
_ASKEW, _LONGER = 1.2, 1.05
"""Volume of a scan's box over that of its tightest one, and longest extent along its axes of inertia over
that along x, y and z, beyond which it lies askew."""
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
    """A body with y → −y as its mirror image that lines along y meet in one piece: a seam in y = 0 hooks
    nothing.

    Attributes
    ----------
    surface : closed, no longer along x than along z, its box's middle in the origin
    off_mm : distances to the scan of points evenly over `surface`; over a deep hollow that is filled, to its
        nearest wall
    evened_mm : largest distance by which the scan stands out of it
    changed_mm3 : volume that is in one of both alone
    """

    surface: trimesh.Trimesh
    off_mm: Float[np.ndarray, "point"]
    evened_mm: float
    changed_mm3: float


def noise_mm(surface: trimesh.Trimesh) -> float:
    """Return the noise of a surface's corners along their normals: one standard deviation (mm).

    A corner's height over its neighbours' mean is curvature and noise; curvature is nearly the same at the
    neighbours. What is left of the difference is noise, by the median, which sharp edges do not move.
    """
    from trimesh.smoothing import laplacian_calculation

    # rows that take the mean over a corner's neighbours
    neighbours = laplacian_calculation(surface)
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
    if len(scan.vertices) < FEWEST_CORNERS or noise < _NOISE_MM:
        return scan, 0.0
    smooth = scan.copy()
    trimesh.smoothing.filter_taubin(smooth, _SHRINK, _GROW, _SMOOTHINGS)
    moved = np.linalg.norm(smooth.vertices - scan.vertices, axis=1)
    if np.median(moved) > _MOST_MOVED * noise:
        return scan, 0.0
    smooth.apply_translation(-smooth.bounds.mean(axis=0))
    return smooth, float(moved.max())


def traits_of_scan(surface: trimesh.Trimesh) -> str:
    """Say what a file's surface has that scans have and drawn bodies lack, noise or axes askew; or nothing.

    It lies askew where its tightest box is clearly smaller than that along x, y and z, or where its axes of
    inertia show it longer.
    """
    import trimesh

    if len(surface.vertices) < FEWEST_CORNERS:
        return ""
    if without_noise(surface)[1]:
        return f"this scan is noisy, by {noise_mm(surface):.2g} mm"
    _, tightest = trimesh.bounds.oriented_bounds(surface.convex_hull)
    turned = surface.vertices @ surface.principal_inertia_vectors.T
    askew = np.prod(surface.extents) > _ASKEW * np.prod(tightest)
    longer = np.ptp(turned, axis=0).max() > _LONGER * max(surface.extents)
    return "this scan lies askew" if askew or longer else ""


def castable_body(scan: trimesh.Trimesh) -> CastableBody:
    """Return a closed surface as a body that the halves of a mould let go, along axes of its own.

    The seam's plane lies across an axis of the tightest box or of inertia. Of those out of which the scan
    stands little farther than out of the best, it is that which changes the least volume, but not across the
    longest edge.
    """
    import trimesh

    scan = simplified(scan, MERGED_MM)
    box_axes, _ = trimesh.bounds.oriented_bounds(scan.convex_hull)
    tried = [
        body
        for axes in (box_axes, scan.principal_inertia_transform)
        for body in _evened_bodies(scan.copy().apply_transform(axes))
    ]
    most = min(body.evened_mm for body in tried) + _AS_LITTLE_MM
    even = [body for body in tried if body.evened_mm <= most]
    # a seam along the longest edge has flat lids at its ends, where air would stay in hollow ones
    lying = [body for body in even if body.surface.extents[1] < max(body.surface.extents)]
    return min(lying or even, key=lambda body: body.changed_mm3)


def _evened_bodies(scan: trimesh.Trimesh) -> Iterator[CastableBody]:
    """Yield bodies that planes across x, y and z mirror.

    On a grid the signed distance becomes the mean of the scan's and its mirror image's, then the least from
    there outwards along the normal. Lines along the normal then meet the body in one piece.
    """
    import trimesh

    scan.apply_translation(-scan.bounds.mean(axis=0))
    distance, origin, step = measured_on_grid(scan, scan.extents, GRID_POINTS)
    between = trimesh.sample.sample_surface(scan, _SAMPLES, seed=0)[0]
    places = (np.concatenate([scan.vertices, between]) - origin).T / step
    for axis in range(3):
        across = np.moveaxis(distance, axis, 0)
        middle = len(across) // 2  # of an odd number of points: it lies in the plane
        outward = (across[middle:] + across[middle::-1]) / 2
        outward = np.minimum.accumulate(outward[::-1])[::-1]
        even = np.moveaxis(np.concatenate([outward[:0:-1], outward]), 0, axis)
        even = gaussian_filter(even, _SMOOTHED_STEPS, mode="nearest")  # lines stay in one piece
        standing_out = float(map_coordinates(even, places, order=1).max())
        changed = float(np.sum((even < 0) != (distance < 0))) * step**3
        surface = simplified(contour_of(even, origin, step), MERGED_MM)
        if _has_shallow_hollows(surface):
            surface = surface.convex_hull  # air rises to one place of it
        samples = trimesh.sample.sample_surface(surface, _SAMPLES, seed=0)[0]
        off_mm = distance_mm(scan, np.asarray(samples))
        surface.apply_transform(_axes_to_y_and_z(axis, scan.extents))
        surface.apply_translation(-surface.bounds.mean(axis=0))
        yield CastableBody(surface, off_mm, max(standing_out, 0.0), changed)


def _has_shallow_hollows(surface: trimesh.Trimesh) -> bool:
    """Return whether the convex hull adds little volume and nowhere much depth."""
    import trimesh

    hull = surface.convex_hull
    if hull.volume > _NEARLY_CONVEX * surface.volume:
        return False
    samples = trimesh.sample.sample_surface(hull, _SAMPLES, seed=0)[0]
    deepest_mm = float(distance_mm(surface, np.asarray(samples)).max())
    return deepest_mm < _SHALLOW * float(min(surface.extents))


def _axes_to_y_and_z(mirrored: int, extents_mm: Float[np.ndarray, "3"]) -> Float[np.ndarray, "4 4"]:
    """Return the turn that takes an axis to y, and the longer of the others to z."""
    across, longest = sorted({0, 1, 2} - {mirrored}, key=lambda axis: extents_mm[axis])
    turn = np.zeros((4, 4))
    turn[[0, 1, 2, 3], [across, mirrored, longest, 3]] = 1.0
    # a turn, not a mirror image: its determinant is 1
    turn[0] *= np.linalg.det(turn)
    return turn
