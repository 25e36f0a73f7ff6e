"""Sources of field that magnets are: round ones and blocks, polarized along their height."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from jaxtyping import Float

from design.catalogue.magnets import NDFEB_RECOIL_PERMEABILITY
from design.spec.magnets import MagnetSize, MagnetSpec
from estimator.field.demagnetisation import block_factor, cylinders_factor
from estimator.field.vectors import Vector, cross, dot, plus_product


@dataclass(frozen=True)
class DiskMagnet:
    """A disk polarized along its axis, or a ring of that outline.

    Attributes
    ----------
    diameter_mm, height_mm : outline, mm
    polarization_t : T
    inner_diameter_mm : of a ring's hole
    """

    diameter_mm: float
    height_mm: float
    polarization_t: float
    inner_diameter_mm: float = 0.0

    @cached_property
    def cylinders(self) -> tuple[tuple[float, float], ...]:
        """Radii (mm) and weights of the full cylinders of this height that sum to the source."""
        outer, inner = self.diameter_mm / 2, self.inner_diameter_mm / 2
        return ((outer, 1.0), (inner, -1.0)) if inner else ((outer, 1.0),)

    @property
    def volume_mm3(self) -> float:
        """Moment per polarization, mm³; of a disk or ring its volume."""
        return float(np.pi * self.height_mm * sum(w * r**2 for r, w in self.cylinders))

    @property
    def circumscribed_radius_mm(self) -> float:
        """Radius of the sphere about the outline; the multipole series converges outside it."""
        return float(np.hypot(self.diameter_mm, self.height_mm) / 2)

    @property
    def demagnetising_factor(self) -> float:
        return cylinders_factor(self.cylinders, self.height_mm)

    @property
    def description(self) -> str:
        hole = f"/{self.inner_diameter_mm:g}" if self.inner_diameter_mm else ""
        kind = "ring" if hole else "disk"
        return f"a {kind} of Ø{self.diameter_mm:g}{hole} × {self.height_mm:g} mm"

    def mean_solid_harmonics(self, count: int) -> Float[np.ndarray, "n"]:
        """Mean of rⁿ P_n(cos θ) over the source, n < `count`."""
        parts = [
            (w * r**2, _cylinder_means(r, self.height_mm / 2, count)) for r, w in self.cylinders
        ]
        weights = np.array([v for v, _ in parts])
        return weights @ np.array([mean for _, mean in parts]) / weights.sum()

    def holds(self, offset_mm: Vector, axis: Vector, side: Vector | None = None) -> Any:
        """Return whether points (offsets from the centre, mm) lie in the outline; a hole counts as full."""
        del side
        axial_mm = dot(offset_mm, axis)
        across_squared = dot(offset_mm, offset_mm) - axial_mm * axial_mm
        return (abs(axial_mm) <= self.height_mm / 2) & (across_squared <= self.diameter_mm**2 / 4)


@dataclass(frozen=True)
class BlockMagnet:
    """A cuboid polarized along its height; `size_mm` are its edges along `side` and across it."""

    size_mm: tuple[float, float]
    height_mm: float
    polarization_t: float

    @property
    def volume_mm3(self) -> float:
        return self.size_mm[0] * self.size_mm[1] * self.height_mm

    @property
    def circumscribed_radius_mm(self) -> float:
        """Radius of the sphere about the block."""
        return float(np.linalg.norm((*self.size_mm, self.height_mm)) / 2)

    @property
    def demagnetising_factor(self) -> float:
        return block_factor(*self.size_mm, self.height_mm)

    @property
    def description(self) -> str:
        x, y = self.size_mm
        return f"a block of {x:g} × {y:g} × {self.height_mm:g} mm"

    def mean_solid_harmonics(self, count: int) -> Float[np.ndarray, "n"]:
        """Mean of rⁿ P_n(cos θ) over the block, n < `count`: its part of rotational symmetry."""
        nodes, weights = np.polynomial.legendre.leggauss(count // 2 + 2)
        x, y = (edge / 2 * nodes for edge in self.size_mm)
        across_squared = np.add.outer(x**2, y**2).ravel()
        weight = np.outer(weights, weights).ravel() / 4
        z = self.height_mm / 2 * nodes[:, None]
        return _means(z, across_squared, weights[:, None] / 2 * weight, count)

    def holds(self, offset_mm: Vector, axis: Vector, side: Vector | None = None) -> Any:
        """Return whether points (offsets from the centre, mm) lie in the block or on its surface."""
        axial_mm, first, second = local_coordinates(offset_mm, axis, side)
        x, y = self.size_mm
        return (
            (abs(axial_mm) <= self.height_mm / 2) & (abs(first) <= x / 2) & (abs(second) <= y / 2)
        )


Magnet = DiskMagnet | BlockMagnet
_Body = TypeVar("_Body", DiskMagnet, BlockMagnet)


def magnet_sources(magnets: MagnetSpec) -> tuple[Magnet, ...]:
    """The magnets that a specification describes, one of each of its `distinct_sizes`, at its
    working point.

    All are of a face's first magnet's grade; others have their fields times their `strengths`.
    """
    return tuple(_source(magnets, size) for size in magnets.distinct_sizes)


def magnet_source(magnets: MagnetSpec) -> Magnet:
    """The same where all magnets are of one size.

    Raises
    ------
    ValueError
        Several sizes.
    """
    (source,) = magnet_sources(magnets)
    return source


def _source(magnets: MagnetSpec, size: MagnetSize) -> Magnet:
    hole, height = size.inner_diameter_mm, size.height_mm
    remanence_t = magnets.remanences_t[0]
    if size.shape == "block":
        return self_demagnetised(BlockMagnet(size.edges_mm, height, 1.0), remanence_t)
    return self_demagnetised(DiskMagnet(size.diameter_mm, height, 1.0, hole), remanence_t)


def self_demagnetised(
    outline: _Body, remanence_t: float, recoil_permeability: float = NDFEB_RECOIL_PERMEABILITY
) -> _Body:
    """A magnet that demagnetises itself: its mean polarization in place of the outline's.

    On the recoil line J = B_r + (μ_r − 1) μ0 H, and the mean of μ0 H inside a magnet that is alone
    is −N J; hence J = B_r / (1 + N (μ_r − 1)). J is taken as uniform, which is exact to first
    order in μ_r − 1. docs/measured/field.md says how wrong that is, and what other magnets and steel add.
    """
    opposed = outline.demagnetising_factor * (recoil_permeability - 1)
    return replace(outline, polarization_t=remanence_t / (1 + opposed))


def local_coordinates(offset_mm: Vector, axis: Vector, side: Vector | None) -> Vector:
    """Components along the axis, along a block's side and across both."""
    first, second = _edges(axis, side)
    return dot(offset_mm, axis), dot(offset_mm, first), dot(offset_mm, second)


def from_local_coordinates(local: Vector, axis: Vector, side: Vector | None) -> Vector:
    """Undo `local_coordinates`."""
    (axial, first, second), (u, v) = local, _edges(axis, side)
    x, y, z = (
        plus_product(plus_product(axial * axis[k], first, u[k]), second, v[k]) for k in range(3)
    )
    return x, y, z


def _edges(axis: Vector, side: Vector | None) -> tuple[Vector, Vector]:
    if side is None:
        raise ValueError("a block's field needs the direction of its side")
    return side, cross(axis, side)


def _cylinder_means(radius: float, half_height: float, count: int) -> Float[np.ndarray, "n"]:
    """Volume means of rⁿ P_n(cos θ) of a full cylinder."""
    nodes, weights = np.polynomial.legendre.leggauss(count // 2 + 2)
    weight = weights[:, None] * weights / 4
    return _means(half_height * nodes[:, None], radius**2 * (1 + nodes) / 2, weight, count)


def _means(z: Any, across_squared: Any, weight: Any, count: int) -> Float[np.ndarray, "n"]:
    """Gauss quadrature, exact for these polynomials.

    The explicit sum over powers cancels badly for tall magnets; the recurrence does not.
    """
    r_squared = z**2 + across_squared
    previous, current = np.ones_like(r_squared), np.broadcast_to(z, r_squared.shape)
    means = []
    for n in range(count):
        means.append(np.sum(weight * previous))
        previous, current = (
            current,
            ((2 * n + 3) * z * current - (n + 1) * r_squared * previous) / (n + 2),
        )
    return np.array(means)
