"""A rigid indenter cut into cells of uniform pressure, and the hemisphere's profile."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from design.layout.tips import TipShape, tip_heights_mm, tip_places_mm, tip_shape
from design.spec.mechanics import IndenterSpec
from fem.contact.half_space import Patches

CELLS = 150
"""Cells under a tip, about, before those at its outline are halved."""
_LARGEST_CELL_MM = 1.2
"""Largest edge of a cell."""
_FINE_BELOW_MM = 0.4
"""Height above a tip's lowest point up to which cells are halved: small contacts are there."""
_SAMPLES = 4
"""Samples along each edge of a cell, by which its area and moments below the tip are found."""


@dataclass(frozen=True)
class TipCells:
    """Square pieces of the face under an indenter, about the place pressed, cut at its outline.

    `height_mm` is the mean height of the indenter's surface over each cell above its lowest point;
    `tip` numbers the probe's tips.
    """

    patches: Patches
    height_mm: Float[np.ndarray, "cell"]
    tip: Int[np.ndarray, "cell"]


def tip_cells(indenter: IndenterSpec) -> TipCells:
    """Cells of every tip: about 150 a tip, at most 1.2 mm wide.

    Cells are halved where the tip is not flat within 0.4 mm above its lowest point, and at the
    outline of what is flat: there small contacts and the pressures of sharp edges are.
    """
    shape = tip_shape(indenter)
    patches, height = _cells(shape)
    places = tip_places_mm(indenter)
    count = len(places)
    return TipCells(
        Patches(
            np.tile(patches.area_mm2, count),
            (places[:, None] + patches.centre_mm).reshape(-1, 2),
            np.tile(patches.variance_mm2, count),
        ),
        np.tile(height, count),
        np.repeat(np.arange(count), len(height)),
    )


def patch_cells(radius_mm: float) -> TipCells:
    """Cells of a disk: a patch of uniform pressure."""
    return tip_cells(IndenterSpec(kind="flat", radius_mm=radius_mm))


def moved(patches: Patches, by_mm: Float[np.ndarray, "2"]) -> Patches:
    """The same patches elsewhere on the face."""
    return replace(patches, centre_mm=patches.centre_mm + by_mm)


def hemisphere_profile_mm(
    distance_mm: Float[np.ndarray, "*n"], radius_mm: float
) -> Float[np.ndarray, "*n"]:
    """R − √(R² − r²) up to r = R; beyond, R (nothing deeper than R ever touches there)."""
    inside = np.clip(radius_mm**2 - np.minimum(distance_mm, radius_mm) ** 2, 0, None)
    return radius_mm - np.sqrt(inside)


def _cells(shape: TipShape) -> tuple[Patches, np.ndarray]:
    low, high = shape.corners_mm.min(axis=0), shape.corners_mm.max(axis=0)
    edge = min(np.sqrt(np.prod(high - low) / CELLS), _LARGEST_CELL_MM)
    count = np.ceil((high - low) / edge).astype(int)
    size = (high - low) / count
    index = np.stack(np.meshgrid(*map(np.arange, count), indexing="ij"), axis=-1).reshape(-1, 2)
    lower = low + index * size
    points, height = _sampled(shape, lower, size)
    inside = np.isfinite(height)
    lowest, highest = height.min(axis=1), np.where(inside, height, np.inf).max(axis=1)
    halved = (lowest < _FINE_BELOW_MM) & (highest > 1e-6 * edge)
    quarter = np.array([[0, 0], [0, 1], [1, 0], [1, 1]]) * size / 2
    fine = _sampled(shape, (lower[halved, None] + quarter).reshape(-1, 2), size / 2)
    parts = [
        cell_moments(points[~halved], height[~halved], size),
        cell_moments(*fine, size / 2),
    ]
    area, centre, variance, mean = (np.concatenate(column) for column in zip(*parts, strict=True))
    return Patches(area, centre, variance), mean


def _sampled(
    shape: TipShape, lower_mm: np.ndarray, size_mm: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Points in every cell (cell, sample, 2), and the tip's heights there."""
    middle = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    local = np.stack(np.meshgrid(middle, middle, indexing="ij"), axis=-1).reshape(-1, 2)
    points = lower_mm[:, None] + local * size_mm
    return points, tip_heights_mm(shape, points)


def cell_moments(
    points: np.ndarray, height: np.ndarray, size_mm: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Area, centroid, variance and mean height of what lies below the tip; empty cells left out."""
    inside = np.isfinite(height)
    kept = inside.any(axis=1)
    points, height, inside = points[kept], height[kept], inside[kept]
    count = inside.sum(axis=1)
    # c cell, s sample, i coordinate: mean over the samples inside
    centre = np.einsum("cs,csi->ci", inside, points) / count[:, None]
    squared = np.sum((points - centre[:, None]) ** 2, axis=2)
    # Variance of a square of edge h along one axis: h²/12, that of a sample's own piece.
    within = np.mean((size_mm / _SAMPLES) ** 2) / 12
    # Per axis, hence the half of the squared distance in the plane.
    variance = np.einsum("cs,cs->c", inside, squared) / count / 2 + within
    mean = np.where(inside, height, 0).sum(axis=1) / count
    area = count * np.prod(size_mm) / _SAMPLES**2
    return area, centre, variance, mean
