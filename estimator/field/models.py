"""Flux density of magnets: multipole series, pole charges, exact bodies.

Vectors are triples of equally broadcastable arrays (`estimator.field.vectors`), so that large sets of
pairs stay in contiguous chunks of cache size. Lengths are in mm, polarization and flux density in T: a
magnet written with its polarization needs no conversion.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from jaxtyping import Int

from design.spec.magnets import MagnetSpec
from estimator.field.exact import cuboid_field, cylinder_field
from estimator.field.sources import (
    BlockMagnet,
    DiskMagnet,
    Magnet,
    from_local_coordinates,
    local_coordinates,
    magnet_sources,
)
from estimator.field.vectors import Vector, dot, plus_product

ModelName = Literal["multipole", "charges", "exact"]
LOWEST_ORDER = 7
"""Lowest order of the series that is tried (odd)."""
HIGHEST_ORDER = 25
"""Highest order that is tried; where it does not hold, the exact body is used."""
HIGHEST_CHARGES = 8
TOLERANCE = 1e-3
"""Largest error of a model, relative to the local |B|."""
_REFERENCE_ORDER = 61
"""Order of the series that stands for the exact field."""


@dataclass(frozen=True)
class FieldModel:
    """A model of one magnet's field; calling it gives B (T) at an offset (mm) from its centre.

    `order` belongs to the multipole series, `charges` the number of charges along a block's edge.
    """

    magnet: Magnet
    name: ModelName
    order: int = 0
    charges: int = 0

    @property
    def size_models(self) -> tuple[FieldModel, ...]:
        """This one alone: all magnets are of one size."""
        return (self,)

    @property
    def exact(self) -> bool:
        return self.name == "exact"

    @property
    def has_side(self) -> bool:
        """Return whether the field depends on where a magnet's side points, as a block's does."""
        return isinstance(self.magnet, BlockMagnet)

    def __call__(self, offset_mm: Vector, axis: Vector, side: Vector | None = None) -> Vector:
        if self.name == "multipole":
            return multipole_field(offset_mm, axis, self.magnet, self.order)
        if isinstance(self.magnet, DiskMagnet):
            return cylinder_field(offset_mm, axis, self.magnet)
        if self.name == "charges":
            return charges_field(offset_mm, axis, self.magnet, self.charges, side)
        return cuboid_field(offset_mm, axis, self.magnet, side)


@dataclass(frozen=True)
class MixedModel:
    """Models of magnets of several sizes, in the order of `MagnetSpec.distinct_sizes`."""

    size_models: tuple[FieldModel, ...]

    @property
    def exact(self) -> bool:
        """Return whether that of any size is."""
        return any(model.exact for model in self.size_models)

    @property
    def has_side(self) -> bool:
        return self.size_models[0].has_side


MagnetsModel = FieldModel | MixedModel


def magnets_model(magnets: MagnetSpec, nearest_distance_mm: float) -> MagnetsModel:
    """`field_model` of every size of a specification's magnets."""
    return _combined_model(
        [field_model(magnet, nearest_distance_mm) for magnet in magnet_sources(magnets)]
    )


def exact_model(magnets: MagnetSpec) -> MagnetsModel:
    """The exact bodies of a specification's magnets."""
    return _combined_model([FieldModel(magnet, "exact") for magnet in magnet_sources(magnets)])


def _combined_model(models: list[FieldModel]) -> MagnetsModel:
    return models[0] if len(models) == 1 else MixedModel(tuple(models))


def field_model(magnet: Magnet, nearest_distance_mm: float) -> FieldModel:
    """The cheapest model whose error stays within `TOLERANCE` beyond `nearest_distance_mm`.

    The multipole series where one of its orders will do (of a block only its part of rotational
    symmetry counts, which suffices at a distance), charges on a block's poles nearer to it, the
    exact body nearer still. The error is the largest over all directions, relative to the local
    |B|; it falls with distance.
    """
    for model in candidate_models(magnet):
        if _holds(model, nearest_distance_mm):
            return model
    return FieldModel(magnet, "exact")


def candidate_models(magnet: Magnet) -> list[FieldModel]:
    orders = range(LOWEST_ORDER, HIGHEST_ORDER + 1, 2)
    series = [FieldModel(magnet, "multipole", order) for order in orders]
    if isinstance(magnet, DiskMagnet):
        return series
    counts = range(2, HIGHEST_CHARGES + 1)
    return series[:2] + [FieldModel(magnet, "charges", charges=count) for count in counts]


def _holds(model: FieldModel, distance_mm: float) -> bool:
    if distance_mm <= model.magnet.circumscribed_radius_mm:
        return False
    return model_error(model, distance_mm) <= TOLERANCE


def multipole_field(offset_mm: Vector, axis: Vector, magnet: Magnet, order: int) -> Vector:
    """Axisymmetric multipole series about the magnet's centre up to the odd `order`.

    B = Σ a_l r^−(l+2) [P′_{l+1}(c) r̂ − P′_l(c) n̂] over odd l, c = n̂·r̂, with
    a_l = J V/(4π) l M_{l−1} and M_n the mean of rⁿ P_n(cos θ) over the magnet's volume. It is the
    gradient of the scalar potential of a uniformly polarized body outside its circumscribed
    sphere (Jackson, Classical Electrodynamics, section 5.9); it diverges inside. Of a block it is
    the part of rotational symmetry alone. The gradient in `axis` follows this formula as
    written: keep the axis a unit vector.
    """
    x, y, z = offset_mm
    nx, ny, nz = axis
    inverse_squared = 1 / dot(offset_mm, offset_mm)
    inverse_cubed = inverse_squared * inverse_squared**0.5
    axial_mm = dot(offset_mm, axis)
    s = magnet.circumscribed_radius_mm**2 * inverse_squared
    ratio = axial_mm * inverse_squared
    powers = (s, axial_mm * ratio * s, s * s)
    radial_series, axial_series = _series(magnet, order)
    radial = inverse_cubed * ratio * _clenshaw(radial_series, *powers)
    axial = inverse_cubed * _clenshaw(axial_series, *powers)
    return (
        plus_product(radial * x, axial, nx),
        plus_product(radial * y, axial, ny),
        plus_product(radial * z, axial, nz),
    )


def charges_field(
    offset_mm: Vector, axis: Vector, block: BlockMagnet, count: int, side: Vector | None = None
) -> Vector:
    """A block's two poles as `count`² point charges each, placed and weighed by Gauss's rule.

    The poles carry the surface charge ±J; a rule of n points an edge is exact for the multipoles
    up to order 2n, so that the error falls as (size / distance)^2n.
    """
    axial, first, second = local_coordinates(offset_mm, axis, side)
    nodes, weights = np.polynomial.legendre.leggauss(count)
    (x, y), half_height = (edge / 2 * nodes for edge in block.size_mm), block.height_mm / 2
    strength = block.polarization_t * block.size_mm[0] * block.size_mm[1] / (16 * np.pi)
    b_axial, b_first, b_second = 0.0, 0.0, 0.0
    for sign in (1.0, -1.0):
        height = axial - sign * half_height
        for i, j in np.ndindex(count, count):
            a, b = first - float(x[i]), second - float(y[j])
            inverse_squared = 1 / dot((a, b, height), (a, b, height))
            weight = float(sign * strength * weights[i] * weights[j])
            pull = weight * inverse_squared * inverse_squared**0.5
            b_axial = b_axial + pull * height
            b_first = b_first + pull * a
            b_second = b_second + pull * b
    return from_local_coordinates((b_axial, b_first, b_second), axis, side)


@dataclass(frozen=True)
class _Series:
    """Σ w_k F_k with F_{k+1} = (s t + β_k s) F_k + γ_k s² F_{k−1}, F_0 = 1, s = (R/r)², t = c²."""

    weights: tuple[float, ...]
    shifts: tuple[float, ...]
    feedbacks: tuple[float, ...]


def _clenshaw(series: _Series, s: Any, st: Any, s_squared: Any) -> Any:
    """The sum, from its highest term down (Clenshaw, Math. Tables Aids Comput. 9, 1955)."""
    # b_k = w_k + (s t + β_k s) b_{k+1} + γ_{k+1} s² b_{k+2}; the sum is b_0. `here` is b_{k+1} and
    # `after` b_{k+2}, which is zero at first and then the plain number w_last: neither needs arrays.
    *lower, here = series.weights
    after: Any = 0.0
    for k in reversed(range(len(lower))):
        step = (st + series.shifts[k] * s) * here
        if k + 3 < len(series.weights):
            step = plus_product(step, after, s_squared, series.feedbacks[k + 1])
        elif k + 2 < len(series.weights):
            step = step + (series.feedbacks[k + 1] * after) * s_squared
        step += lower[k]
        here, after = step, here
    return here


@lru_cache(maxsize=256)
def _series(magnet: Magnet, order: int) -> tuple[_Series, _Series]:
    """Sums that multiply c r̂ and n̂ in B r³: over P′_{l+1}(c)/c and over −P′_l(c)."""
    if order < 1 or order % 2 == 0:
        raise ValueError(f"the series has odd orders only; got {order}")
    moment = magnet.polarization_t * magnet.volume_mm3 / (4 * np.pi)
    means = magnet.mean_solid_harmonics(order)
    lengths = magnet.circumscribed_radius_mm ** np.arange(order)
    orders = range(1, order + 1, 2)
    strengths = [float(moment * l * means[l - 1] / lengths[l - 1]) for l in orders]
    return _gegenbauer_series(1, strengths), _gegenbauer_series(0, [-a for a in strengths])


def _gegenbauer_series(parity: int, strengths: list[float]) -> _Series:
    """Recurrence in t = c² of P′_{n+1}(c) = C_n(c), the Gegenbauer polynomials of index 3/2.

    c C_n = u_n C_{n+1} + d_n C_{n−1} with u_n = (n+1)/(2n+3) and d_n = (n+2)/(2n+3); applied twice
    it links those of one parity. They are scaled to leading coefficient 1 in t.
    """
    # t C_n = u_n u_{n+1} C_{n+2} + (u_n d_{n+1} + d_n u_{n−1}) C_n + d_n d_{n−1} C_{n−2}. Each leading
    # coefficient is 1/(u_n u_{n+1}) times the one before; divided by them, C_{n+2} has the factor 1.
    n = np.arange(2 * len(strengths) + 3)
    up, down = (n + 1) / (2 * n + 3), (n + 2) / (2 * n + 3)
    leading, weights, shifts, feedbacks = 1.0 + 2 * parity, [], [], []
    for k, strength in enumerate(strengths):
        m = 2 * k + parity
        weights.append(strength * leading)
        shifts.append(float(-up[m] * down[m + 1] - (down[m] * up[m - 1] if m else 0)))
        feedback = down[m] * down[m - 1] * up[m - 2] * up[m - 1] if k else 0
        feedbacks.append(float(-feedback))
        leading /= float(up[m] * up[m + 1])
    return _Series(tuple(weights), tuple(shifts), tuple(feedbacks))


@lru_cache(maxsize=256)
def model_error(model: FieldModel, distance_mm: float) -> float:
    """Largest relative error of a model at a distance, over all directions.

    Against the series of order 61 for round sources, which leaves out (R/r)^60 of the field, and
    against the exact block.
    """
    angle = np.linspace(0, np.pi, 181)
    around = isinstance(model.magnet, DiskMagnet)
    azimuth = np.zeros(1) if around else np.linspace(0, np.pi / 2, 13)
    x, y, z = (
        distance_mm * np.outer(polar, part).ravel()
        for polar, part in (
            (np.sin(angle), np.cos(azimuth)),
            (np.sin(angle), np.sin(azimuth)),
            (np.cos(angle), np.ones_like(azimuth)),
        )
    )
    pose: tuple[Vector, Vector, Vector] = (x, y, z), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)
    best: ModelName = "multipole" if around else "exact"
    exact = np.array(FieldModel(model.magnet, best, _REFERENCE_ORDER)(*pose))
    error = np.array(model(*pose)) - exact
    return float(np.max(np.linalg.norm(error, axis=0) / np.linalg.norm(exact, axis=0)))


def sum_over_magnets(
    points_mm: Vector,
    centres_mm: Vector,
    axes: Vector,
    model: MagnetsModel,
    sides: Vector | None = None,
    strength: Any = 1.0,
    size: Int[np.ndarray, "magnet"] | None = None,
) -> Vector:
    """Flux density (T) of all magnets together; the magnets run along the first dimension.

    Parameters
    ----------
    points_mm, centres_mm, axes : three arrays each, broadcastable to (magnet, …), mm and unit
        vectors. Speed wants a long contiguous last dimension and a size that fits the cache.
    sides : unit vectors along the first edge of blocks; round magnets need none
    strength : polarization of each magnet over the model's, broadcastable alike
    size : which of the model's sizes each magnet has, where there are several

    Raises
    ------
    ValueError
        A model of several sizes without them.

    Returns
    -------
    Three arrays of shape (…), T.
    """
    offset = tuple(p - c for p, c in zip(points_mm, centres_mm, strict=True))
    if isinstance(model, FieldModel):
        bx, by, bz = (strength * part for part in model(offset, axes, sides))
        return bx.sum(axis=0), by.sum(axis=0), bz.sum(axis=0)
    x, y, z = 0.0, 0.0, 0.0
    for size_model, rows in _models_by_size(model, size):
        each = sides and _rows(sides, rows)
        weight = strength if np.ndim(strength) == 0 or len(strength) == 1 else strength[rows]
        bx, by, bz = (weight * b for b in size_model(_rows(offset, rows), _rows(axes, rows), each))
        x, y, z = x + bx.sum(axis=0), y + by.sum(axis=0), z + bz.sum(axis=0)
    return x, y, z


def field_of_each(
    offset_mm: Vector,
    axes: Vector,
    model: MagnetsModel,
    sides: Vector | None = None,
    size: Int[np.ndarray, "magnet"] | None = None,
) -> Vector:
    """Flux density (T) of every magnet by itself, of arrays; the magnets run along the first dimension."""
    if isinstance(model, FieldModel):
        return model(offset_mm, axes, sides)
    parts, rows = [], []
    for size_model, members in _models_by_size(model, size):
        each = sides and _rows(sides, members)
        parts.append(size_model(_rows(offset_mm, members), _rows(axes, members), each))
        rows.append(members)
    back = np.argsort(np.concatenate(rows))
    x, y, z = (np.concatenate([part[k] for part in parts])[back] for k in range(3))
    return x, y, z


def _models_by_size(
    model: MixedModel, size: Int[np.ndarray, "magnet"] | None
) -> Iterator[tuple[FieldModel, Int[np.ndarray, "some"]]]:
    """The model of every size that some magnets have, and which they are."""
    if size is None:
        raise ValueError(f"a model of {len(model.size_models)} sizes needs to know which each has")
    for number, size_model in enumerate(model.size_models):
        if (size == number).any():
            yield size_model, np.flatnonzero(size == number)


def _rows(vector: Vector, those: np.ndarray) -> Vector:
    """Rows of some magnets; what all share is left as it is."""
    x, y, z = (part if len(part) == 1 else part[those] for part in vector)
    return x, y, z
