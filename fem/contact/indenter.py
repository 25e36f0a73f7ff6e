"""An indenter cut into cells of uniform pressure, and the hemisphere's profile."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from jaxtyping import Float, Int

from design.layout.tips import TipShape, tip_heights_mm, tip_places_mm, tip_shape
from design.spec.mechanics import IndenterSpec
from fem.contact.half_space import Patches

CELLS = 150
"""Cells under a tip, about, before those at its outline are halved."""
_LARGEST_CELL_MM = 1.7
"""Largest edge of a cell: of a jaw over a whole face 1.2 mm costs five times as much for 0.02 % of force."""
_FINE_BELOW_MM = 0.4
"""Height above a tip's lowest point up to which cells are halved: small contacts are there."""
_LEVEL_MM = 1e-9
"""Least distance from a circle's middle: there is no direction from it."""
_MOST_HALVED = 2 * CELLS
"""Cells of a wide jaw that are halved at most, the lowest first."""
_BORDER_SAMPLES = 400
"""Points along each side of a border: a tip that has its lowest point beyond it touches there first."""
_SAMPLES = 4
"""Samples along each edge of a cell, by which its area and moments below the tip are found."""


@dataclass(frozen=True)
class TipCells:
    """Square pieces of the face under an indenter, about the place pressed, cut at its outline.

    `height_mm` is the mean height of the indenter's surface over each cell above its lowest point, or
    above what is lowest within the border; `tip` numbers the probe's tips.
    """

    patches: Patches
    height_mm: Float[np.ndarray, "cell"]
    tip: Int[np.ndarray, "cell"]


@dataclass(frozen=True)
class Border:
    """Border of a flat face, seen from the place pressed: a rectangle's corners, or a circle in it."""

    low_mm: Float[np.ndarray, "2"]
    high_mm: Float[np.ndarray, "2"]
    round: bool = False

    def signed_distance_mm(self, points_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
        """Return how far points lie outside, negative inside."""
        middle, half = (self.low_mm + self.high_mm) / 2, (self.high_mm - self.low_mm) / 2
        away = points_mm - middle
        if self.round:
            return np.asarray(np.linalg.norm(away, axis=-1) - half.max())
        return np.asarray(np.max(abs(away) - half, axis=-1))

    def side_distances_mm(self, points_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n side"]:
        """Return how far points lie beyond each side: −x, −y, +x, +y, or the circle."""
        if self.round:
            return self.signed_distance_mm(points_mm)[:, None]
        return np.concatenate([self.low_mm - points_mm, points_mm - self.high_mm], axis=1)

    def near_sides(
        self, inside_mm: Float[np.ndarray, "n side"], reach_mm: float
    ) -> list[list[int]]:
        """Sides that some points lie next to, and pairs that meet in a corner next to some."""
        near = inside_mm < reach_mm
        single = [[int(side)] for side in np.flatnonzero(near.any(axis=0))]
        return single + [
            [a, b] for [a], [b] in combinations(single, 2) if (near[:, a] & near[:, b]).any()
        ]

    def outline_mm(
        self, low_mm: Float[np.ndarray, "2"], high_mm: Float[np.ndarray, "2"]
    ) -> Float[np.ndarray, "n 2"]:
        """Points along the border, where a box from low to high reaches it."""
        share = np.linspace(0, 1, _BORDER_SAMPLES)
        if self.round:
            middle, radius = (
                (self.low_mm + self.high_mm) / 2,
                (self.high_mm - self.low_mm).max() / 2,
            )
            angle = 2 * np.pi * share
            return middle + radius * np.column_stack([np.cos(angle), np.sin(angle)])
        low, high = np.maximum(low_mm, self.low_mm), np.minimum(high_mm, self.high_mm)
        x, y = (low + share[:, None] * (high - low)).T
        sides = [(x, 0 * x + end[1]) for end in (low, high)]
        sides += [(0 * y + end[0], y) for end in (low, high)]
        return np.concatenate([np.column_stack(side) for side in sides])

    def mirrored(
        self, points_mm: Float[np.ndarray, "n dim"], sides: Sequence[int]
    ) -> Float[np.ndarray, "n dim"]:
        """Points beyond these sides, as far outside as they were inside."""
        image = points_mm.copy()
        if self.round:
            middle = (self.low_mm + self.high_mm) / 2
            away = points_mm[:, :2] - middle
            radius = np.linalg.norm(away, axis=1, keepdims=True)
            outer = float((self.high_mm - self.low_mm).max())
            image[:, :2] = middle + away * (outer / np.maximum(radius, _LEVEL_MM) - 1)
            return image
        for side in sides:
            position = np.concatenate([self.low_mm, self.high_mm])[side]
            image[:, side % 2] = 2 * position - image[:, side % 2]
        return image


def tip_cells(indenter: IndenterSpec, border: Border | None = None) -> TipCells:
    """Cells of every tip, of what lies within a border: about 150 a tip, at most 1.7 mm wide.

    Cells are halved where the tip is not flat within 0.4 mm above its lowest point, and at the
    outline of what is flat: there small contacts and the pressures of sharp edges are.
    """
    shape, places = tip_shape(indenter), tip_places_mm(indenter)
    if border is None:
        cells = [_cells(shape)] * len(places)
    else:
        moved_by = [(border.low_mm - place, border.high_mm - place) for place in places]
        borders = [Border(*ends, border.round) for ends in moved_by]
        lowest = min(_lowest_within_mm(shape, moved_border) for moved_border in borders)
        cut = (_cells(shape, moved_border) for moved_border in borders)
        cells = [(patches, height - lowest) for patches, height in cut]
    area, variance, height = (
        np.concatenate(column)
        for column in zip(*((p.area_mm2, p.variance_mm2, h) for p, h in cells), strict=True)
    )
    centre = np.concatenate(
        [place + p.centre_mm for place, (p, _) in zip(places, cells, strict=True)]
    )
    tip = np.repeat(np.arange(len(places)), [len(h) for _, h in cells])
    return TipCells(Patches(area, centre, variance), height, tip)


def _lowest_within_mm(shape: TipShape, border: Border) -> float:
    """Height of the lowest point of a convex tip within a border; ∞ where all of it lies beyond."""
    low, high = shape.corners_mm.min(axis=0), shape.corners_mm.max(axis=0)
    inside = border.signed_distance_mm(shape.lowest_mm) <= 0
    points = np.concatenate([border.outline_mm(low, high), shape.lowest_mm[inside]])
    return float(tip_heights_mm(shape, points).min())


def moved(patches: Patches, by_mm: Float[np.ndarray, "2"]) -> Patches:
    """The same patches elsewhere on the face."""
    return replace(patches, centre_mm=patches.centre_mm + by_mm)


def hemisphere_profile_mm(
    distance_mm: Float[np.ndarray, "*n"], radius_mm: float
) -> Float[np.ndarray, "*n"]:
    """R − √(R² − r²) up to r = R; beyond, R (nothing deeper than R ever touches there)."""
    inside = np.clip(radius_mm**2 - np.minimum(distance_mm, radius_mm) ** 2, 0, None)
    return radius_mm - np.sqrt(inside)


def _cells(shape: TipShape, border: Border | None = None) -> tuple[Patches, np.ndarray]:
    low, high = shape.corners_mm.min(axis=0), shape.corners_mm.max(axis=0)
    edge = min(np.sqrt(np.prod(high - low) / CELLS), _LARGEST_CELL_MM)
    # cells end at the border: a sliver of a cell makes the compliance indefinite
    if border is not None:
        low, high = np.maximum(low, border.low_mm), np.minimum(high, border.high_mm)
    count = np.ceil((high - low) / edge).astype(int)
    size = (high - low) / count
    index = np.stack(np.meshgrid(*map(np.arange, count), indexing="ij"), axis=-1).reshape(-1, 2)
    lower = low + index * size
    size = np.broadcast_to(size, lower.shape)
    points, height = _sampled(shape, lower, size, border)
    inside = np.isfinite(height)
    lowest, highest = height.min(axis=1), np.where(inside, height, np.inf).max(axis=1)
    halved = (lowest < _FINE_BELOW_MM) & (highest > 1e-6 * edge)
    halved[np.argsort(np.where(halved, lowest, np.inf), kind="stable")[_MOST_HALVED:]] = False
    half = np.repeat(size[halved] / 2, 4, axis=0)
    quarter = np.tile([[0, 0], [0, 1], [1, 0], [1, 1]], (int(halved.sum()), 1)) * half
    fine = _sampled(shape, np.repeat(lower[halved], 4, axis=0) + quarter, half, border)
    parts = [
        cell_moments(points[~halved], height[~halved], size[~halved]),
        cell_moments(*fine, half),
    ]
    area, centre, variance, mean = (np.concatenate(column) for column in zip(*parts, strict=True))
    return Patches(area, centre, variance), mean


def _sampled(
    shape: TipShape,
    lower_mm: Float[np.ndarray, "cell 2"],
    size_mm: Float[np.ndarray, "cell 2"],
    border: Border | None,
) -> tuple[np.ndarray, np.ndarray]:
    """Points in every cell (cell, sample, 2), and the tip's heights there; ∞ beyond the border."""
    middle = (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    local = np.stack(np.meshgrid(middle, middle, indexing="ij"), axis=-1).reshape(-1, 2)
    points = lower_mm[:, None] + local * size_mm[:, None]
    height = tip_heights_mm(shape, points)
    if border is not None:
        height = np.where(border.signed_distance_mm(points) > 0, np.inf, height)
    return points, height


def cell_moments(
    points: np.ndarray, height: np.ndarray, size_mm: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Area, centroid, variance and mean height of what lies below the tip; empty cells left out."""
    inside = np.isfinite(height)
    kept = inside.any(axis=1)
    points, height, inside, size_mm = points[kept], height[kept], inside[kept], size_mm[kept]
    count = inside.sum(axis=1)
    # c cell, s sample, i coordinate: mean over the samples inside
    centre = np.einsum("cs,csi->ci", inside, points) / count[:, None]
    squared = np.sum((points - centre[:, None]) ** 2, axis=2)
    # Variance of a square of edge h along one axis: h²/12, that of a sample's own piece.
    within = np.mean((size_mm / _SAMPLES) ** 2, axis=1) / 12
    # Per axis, hence the half of the squared distance in the plane.
    variance = np.einsum("cs,cs->c", inside, squared) / count / 2 + within
    mean = np.where(inside, height, 0).sum(axis=1) / count
    area = count * np.prod(size_mm, axis=1) / _SAMPLES**2
    return area, centre, variance, mean
