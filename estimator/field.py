"""Flux density of axially magnetised disks: point dipole, multipole series, exact cylinder.

Vectors are triples of equally broadcastable arrays (x, y, z), so that large sets of pairs stay in
cache-sized, contiguous pieces. Dipole and series use operators alone and so take NumPy arrays and
torch tensors alike (`estimator.field_torch` has the latter in batches). Lengths are in mm,
polarization and flux density in T: a magnet written with its polarization needs no conversion.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec import MagnetSpec

Vector = tuple[Any, Any, Any]
"""Components x, y, z: arrays (NumPy or any library with the same operators) of one shape."""

ModelName = Literal["dipole", "multipole", "cylinder"]
LOWEST_ORDER = 7
HIGHEST_ORDER = 25
_REFERENCE_ORDER = 61


@dataclass(frozen=True)
class DiskMagnet:
    """A disk polarized along its axis."""

    diameter_mm: float
    height_mm: float
    polarization_t: float

    @property
    def volume_mm3(self) -> float:
        return np.pi * self.diameter_mm**2 / 4 * self.height_mm

    @property
    def circumscribed_radius_mm(self) -> float:
        """Radius of the sphere about the disk; the multipole series converges outside it."""
        return float(np.hypot(self.diameter_mm, self.height_mm) / 2)


def disk_magnet(magnets: MagnetSpec) -> DiskMagnet:
    """The disk that a specification describes, at its temperature.

    Its remanence is taken as its polarization.
    """
    return DiskMagnet(magnets.diameter_mm, magnets.height_mm, magnets.working_remanence_t)


@dataclass(frozen=True)
class FieldModel:
    """A model of one disk's field; calling it gives B (T) at an offset (mm) from its centre."""

    disk: DiskMagnet
    name: ModelName
    order: int = 0

    def __call__(self, offset_mm: Vector, axis: Vector) -> Vector:
        if self.name == "multipole":
            return multipole_field(offset_mm, axis, self.disk, self.order)
        return _MODELS[self.name](offset_mm, axis, self.disk)


def field_model(
    disk: DiskMagnet, nearest_distance_mm: float, tolerance: float = 1e-3
) -> FieldModel:
    """The cheapest model whose error stays within `tolerance` beyond `nearest_distance_mm`.

    The multipole series where one of its orders will do, the exact cylinder nearer to the magnet.
    """
    try:
        order = multipole_order_for(
            nearest_distance_mm, disk.diameter_mm, disk.height_mm, tolerance
        )
    except InputError:
        return FieldModel(disk, "cylinder")
    return FieldModel(disk, "multipole", order)


def dipole_field(offset_mm: Vector, axis: Vector, disk: DiskMagnet) -> Vector:
    """Point dipole J V / (4π r³) (3 (n̂·r̂) r̂ − n̂): 13 % wrong 10 mm from a disk of Ø6 × 1.

    Parameters
    ----------
    offset_mm : three arrays, mm, from the magnet's centre to the point
    axis : three arrays, unit vector along the polarization

    Returns
    -------
    Three arrays, T.
    """
    return multipole_field(offset_mm, axis, disk, order=1)


def multipole_field(offset_mm: Vector, axis: Vector, disk: DiskMagnet, order: int) -> Vector:
    """Axisymmetric multipole series about the disk's centre up to the odd `order`.

    B = Σ a_l r^−(l+2) [P′_{l+1}(c) r̂ − P′_l(c) n̂] over odd l, c = n̂·r̂, with
    a_l = J V/(4π) l M_{l−1} and M_n the mean of rⁿ P_n(cos θ) over the disk's volume. It is the
    gradient of the scalar potential of a uniformly polarized body outside its circumscribed
    sphere (Jackson, Classical Electrodynamics, section 5.9); it diverges inside. The gradient in
    `axis` is that of this formula as written: keep the axis a unit vector.
    """
    x, y, z = offset_mm
    nx, ny, nz = axis
    inverse_squared = 1 / _dot(offset_mm, offset_mm)
    inverse_cubed = inverse_squared * inverse_squared**0.5
    along = _dot(offset_mm, axis)
    s = disk.circumscribed_radius_mm**2 * inverse_squared
    ratio = along * inverse_squared
    powers = (s, along * ratio * s, s * s)
    radial_series, axial_series = _series(disk, order)
    radial = inverse_cubed * ratio * _clenshaw(radial_series, *powers)
    axial = inverse_cubed * _clenshaw(axial_series, *powers)
    return (
        _plus_product(radial * x, axial, nx),
        _plus_product(radial * y, axial, ny),
        _plus_product(radial * z, axial, nz),
    )


def _dot(a: Vector, b: Vector) -> Any:
    return _plus_product(_plus_product(a[0] * b[0], a[1], b[1]), a[2], b[2])


def _plus_product(a: Any, b: Any, c: Any, factor: float = 1.0) -> Any:
    """a + factor b c; a tensor does it in one pass over memory."""
    if hasattr(a, "addcmul"):
        return a.addcmul(b, c, value=factor)
    product = b * c if factor == 1.0 else (factor * b) * c
    product += a
    return product


def _plus_scaled(a: Any, b: Any, factor: float) -> Any:
    """a + factor b; a tensor does it in one pass over memory."""
    return a.add(b, alpha=factor) if hasattr(a, "addcmul") else a + factor * b


@dataclass(frozen=True)
class _Series:
    """Σ w_k F_k with F_{k+1} = (s t + β_k s) F_k + γ_k s² F_{k−1}, F_0 = 1, s = (R/r)², t = c²."""

    weights: tuple[float, ...]
    shifts: tuple[float, ...]
    feedbacks: tuple[float, ...]


def _clenshaw(series: _Series, s: Any, st: Any, s_squared: Any) -> Any:
    """The sum, from its highest term down (Clenshaw, Math. Tables Aids Comput. 9, 1955)."""
    *lower, here = series.weights
    after: Any = 0.0
    for k in reversed(range(len(lower))):
        step = _plus_scaled(st, s, series.shifts[k]) * here
        if k + 3 < len(series.weights):
            step = _plus_product(step, after, s_squared, series.feedbacks[k + 1])
        elif k + 2 < len(series.weights):
            step = _plus_scaled(step, s_squared, series.feedbacks[k + 1] * after)
        step += lower[k]
        here, after = step, here
    return here


@lru_cache(maxsize=256)
def _series(disk: DiskMagnet, order: int) -> tuple[_Series, _Series]:
    """Sums that multiply c r̂ and n̂ in B r³: over P′_{l+1}(c)/c and over −P′_l(c)."""
    if order < 1 or order % 2 == 0:
        raise ValueError(f"the series has odd orders only; got {order}")
    moment = disk.polarization_t * disk.volume_mm3 / (4 * np.pi)
    means = _mean_solid_harmonics(disk.diameter_mm / 2, disk.height_mm / 2, order)
    lengths = disk.circumscribed_radius_mm ** np.arange(order)
    orders = range(1, order + 1, 2)
    strengths = [float(moment * l * means[l - 1] / lengths[l - 1]) for l in orders]
    return _gegenbauer_series(1, strengths), _gegenbauer_series(0, [-a for a in strengths])


def _gegenbauer_series(parity: int, strengths: list[float]) -> _Series:
    """Recurrence in t = c² of P′_{n+1}(c) = C_n(c), the Gegenbauer polynomials of index 3/2.

    c C_n = u_n C_{n+1} + d_n C_{n−1} with u_n = (n+1)/(2n+3) and d_n = (n+2)/(2n+3); applied twice
    it links those of one parity. They are scaled to leading coefficient 1 in t.
    """
    n = np.arange(2 * len(strengths) + 3)
    up, down = (n + 1) / (2 * n + 3), (n + 2) / (2 * n + 3)
    leading, weights, shifts, feedbacks = 1.0 + 2 * parity, [], [], []
    for k, strength in enumerate(strengths):
        m = 2 * k + parity
        weights.append(strength * leading)
        shifts.append(float(-up[m] * down[m + 1] - (down[m] * up[m - 1] if m else 0)))
        before = down[m] * down[m - 1] * up[m - 2] * up[m - 1] if k else 0
        feedbacks.append(float(-before))
        leading /= float(up[m] * up[m + 1])
    return _Series(tuple(weights), tuple(shifts), tuple(feedbacks))


def _mean_solid_harmonics(radius: float, half_height: float, count: int) -> Float[np.ndarray, "n"]:
    """Volume mean of rⁿ P_n(cos θ) for n < `count`, by Gauss quadrature exact for polynomials.

    The explicit sum over powers cancels badly for tall magnets; the recurrence does not.
    """
    nodes, weights = np.polynomial.legendre.leggauss(count // 2 + 2)
    z = half_height * nodes[:, None]
    r_squared = z**2 + radius**2 * (1 + nodes) / 2
    weights = weights[:, None] * weights / 4
    before, here = np.ones_like(r_squared), np.broadcast_to(z, r_squared.shape)
    means = []
    for n in range(count):
        means.append(np.sum(weights * before))
        before, here = here, ((2 * n + 3) * z * here - (n + 1) * r_squared * before) / (n + 2)
    return np.array(means)


@lru_cache(maxsize=256)
def multipole_order_for(
    nearest_distance_mm: float, diameter_mm: float, height_mm: float, tolerance: float = 1e-3
) -> int:
    """Smallest odd order (at least 7) whose error of B is within `tolerance` at that distance.

    The error is the largest over all directions, relative to the local |B|; it falls with
    distance.

    Raises
    ------
    InputError
        The point may be so near that no order up to 25 will do: use the exact cylinder.
    """
    disk = DiskMagnet(diameter_mm, height_mm, 1.0)
    if nearest_distance_mm > disk.circumscribed_radius_mm:
        for order in range(LOWEST_ORDER, HIGHEST_ORDER + 1, 2):
            if series_error(disk, nearest_distance_mm, order) <= tolerance:
                return order
    raise InputError(
        f"no multipole order up to {HIGHEST_ORDER} holds {tolerance:g} at "
        f"{nearest_distance_mm:.4g} mm from a magnet of Ø{diameter_mm:g} × {height_mm:g} mm. "
        "Use the exact cylinder there"
    )


def series_error(disk: DiskMagnet, distance_mm: float, order: int) -> float:
    """Largest relative error of the truncated series at a distance, against order 61."""
    angle = np.linspace(0, np.pi, 361)
    zero = np.zeros_like(angle)
    offset = (distance_mm * np.sin(angle), zero, distance_mm * np.cos(angle))
    axis = (zero, zero, zero + 1)
    exact = np.array(multipole_field(offset, axis, disk, _REFERENCE_ORDER))
    error = np.array(multipole_field(offset, axis, disk, order)) - exact
    return float(np.max(np.linalg.norm(error, axis=0) / np.linalg.norm(exact, axis=0)))


def cylinder_field(offset_mm: Vector, axis: Vector, disk: DiskMagnet) -> Vector:
    """Exact field of the uniformly polarized cylinder, valid anywhere off its rim.

    magpylib's axial solution (Derby and Olbert, Am. J. Phys. 78, 2010) works on lengths divided
    by the cylinder's radius, which here is the one place where mm end. Inside, B is the flux
    density of the magnet, polarization included.
    """
    from magpylib.core import magnet_cylinder_axial_Bfield

    radius = disk.diameter_mm / 2
    offset = np.stack(np.broadcast_arrays(*offset_mm), axis=-1).astype(float)
    direction = np.broadcast_to(np.stack(np.broadcast_arrays(*axis), axis=-1), offset.shape)
    along = np.sum(offset * direction, axis=-1)
    across = offset - along[..., None] * direction
    distance = np.linalg.norm(across, axis=-1)
    b_radial, _, b_axial = magnet_cylinder_axial_Bfield(
        z0=np.full(along.size, disk.height_mm / 2 / radius),
        r=distance.ravel() / radius,
        z=along.ravel() / radius,
    )
    outward = across / np.maximum(distance, 1e-300)[..., None]
    field = disk.polarization_t * (
        b_radial.reshape(along.shape)[..., None] * outward
        + b_axial.reshape(along.shape)[..., None] * direction
    )
    return field[..., 0], field[..., 1], field[..., 2]


def is_inside(offset_mm: Vector, axis: Vector, disk: DiskMagnet) -> Any:
    """Whether points (offsets from the centre, mm) lie in the disk or on its surface."""
    x, y, z = offset_mm
    along = x * axis[0] + y * axis[1] + z * axis[2]
    across_squared = x * x + y * y + z * z - along * along
    return (abs(along) <= disk.height_mm / 2) & (across_squared <= disk.diameter_mm**2 / 4)


def sum_over_magnets(
    points_mm: Vector, centres_mm: Vector, axes: Vector, model: FieldModel
) -> Vector:
    """Flux density (T) of all magnets together; the magnets run along the first dimension.

    Parameters
    ----------
    points_mm, centres_mm, axes : three arrays each, broadcastable to (magnet, …), mm and unit
        vectors. Speed wants a long contiguous last dimension and a size that fits the cache.

    Returns
    -------
    Three arrays of shape (…), T.
    """
    offset = tuple(p - c for p, c in zip(points_mm, centres_mm, strict=True))
    bx, by, bz = model(offset, axes)
    return bx.sum(axis=0), by.sum(axis=0), bz.sum(axis=0)


def total_field(
    points_mm: Float[np.ndarray, "point 3"],
    centres_mm: Float[np.ndarray, "magnet 3"],
    axes: Float[np.ndarray, "magnet 3"],
    model: FieldModel,
) -> Float[np.ndarray, "point 3"]:
    """Flux density (T) of all magnets together at points (mm)."""
    centres = tuple(centres_mm.T[:, :, None])
    field = sum_over_magnets(tuple(points_mm.T[:, None]), centres, tuple(axes.T[:, :, None]), model)
    return np.stack(field, axis=-1)


_MODELS = {"dipole": dipole_field, "cylinder": cylinder_field}
