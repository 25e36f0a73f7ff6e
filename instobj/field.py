"""Fields of magnets, as pure functions: whole objects, single disks and blocks, working points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike

__all__ = ["block_field", "disk_field", "magnet_field", "polarization"]


def magnet_field(spec: ObjectSpec, points_mm: ArrayLike) -> xr.DataArray:
    """Flux density of all magnets at rest, at any points outside them.

    Exact for uniformly polarized disks, rings and blocks. Earth's field, steel plates and other
    surroundings are left out: see `[environment]` for what sensors feel of them.

    Parameters
    ----------
    spec : ObjectSpec
    points_mm : array_like (point, 3)
        Points in the object's frame, mm.

    Returns
    -------
    DataArray (point, axis)
        Flux density, T, along x, y, z of the object's frame.

    Raises
    ------
    InputError
        The points are not of that shape, or not finite.

    Examples
    --------
    Above the middle of the top face, whose magnets point alternately inwards and outwards:

    >>> import instobj
    >>> cube = instobj.ObjectSpec(name="cube")
    >>> field = instobj.magnet_field(cube, [[0.0, 0.0, 10.0], [0.0, 0.0, 30.0]])
    >>> field.dims, field.attrs["units"]
    (('point', 'axis'), 'T')
    >>> bool(abs(field).max() < 0.1)
    True
    """
    from design.layout.places.positions import magnet_layout
    from estimator.field.models import exact_model, sum_over_magnets

    points = _points(points_mm)
    layout = magnet_layout(spec)
    x, y, z = points.T[:, None]
    centres, axes, sides = (
        tuple(given.T[:, :, None]) for given in (layout.centre_mm, layout.axis, layout.side)
    )
    model = exact_model(spec.magnets)
    field_t = sum_over_magnets(
        (x, y, z), centres, axes, model, sides, layout.strength[:, None], layout.size
    )
    return _named(np.stack(field_t, axis=-1))


def disk_field(
    points_mm: ArrayLike,
    diameter_mm: float,
    height_mm: float,
    polarization_t: float,
    inner_diameter_mm: float = 0.0,
) -> xr.DataArray:
    """Flux density of one disk or ring at the origin, polarized along +z.

    Exact for uniform polarization (Derby and Olbert, Am. J. Phys. 78, 2010), by magpylib.

    Parameters
    ----------
    points_mm : array_like (point, 3)
        Points outside the magnet, mm.
    diameter_mm, height_mm : float
        Outline, mm.
    polarization_t : float
        Polarization J, T. `polarization` works it out of a remanence.
    inner_diameter_mm : float
        Diameter of a ring's hole, mm.

    Returns
    -------
    DataArray (point, axis)
        Flux density, T, along x, y, z.

    Raises
    ------
    InputError
        Points of another shape or not finite, or a length that is not positive.

    Examples
    --------
    On the axis the closed form of a cylinder holds:

    >>> from math import hypot
    >>> import instobj
    >>> field = instobj.field.disk_field([[0, 0, 5.0]], 6.0, 1.0, 1.4)
    >>> closed_form = 1.4 / 2 * (5.5 / hypot(5.5, 3) - 4.5 / hypot(4.5, 3))
    >>> bool(abs(field.sel(axis="z") - closed_form).item() < 1e-12)
    True
    """
    from estimator.field.exact import cylinder_field
    from estimator.field.sources import DiskMagnet

    _require_positive(diameter_mm=diameter_mm, height_mm=height_mm)
    if not 0 <= inner_diameter_mm < diameter_mm:
        raise InputError(
            f"inner_diameter_mm must be 0 or more and below {diameter_mm:g}; got {inner_diameter_mm:g}"
        )
    lengths = float(diameter_mm), float(height_mm)
    disk = DiskMagnet(*lengths, float(polarization_t), float(inner_diameter_mm))
    return _named(np.stack(cylinder_field(_columns(points_mm), _UP, disk), axis=-1))


def block_field(
    points_mm: ArrayLike, size_mm: Sequence[float], polarization_t: float
) -> xr.DataArray:
    """Flux density of one block at the origin, polarized along +z.

    Exact for uniform polarization (Yang et al., Supercond. Sci. Technol. 3, 1990), by magpylib.

    Parameters
    ----------
    points_mm : array_like (point, 3)
        Points outside the magnet, mm.
    size_mm : three floats
        Edges along x, y and z, mm.
    polarization_t : float
        Polarization J, T.

    Returns
    -------
    DataArray (point, axis)
        Flux density, T, along x, y, z.

    Raises
    ------
    InputError
        Points of another shape or not finite, or not three positive edges.

    Examples
    --------
    Far away a block is a dipole of its volume:

    >>> import instobj
    >>> far = instobj.field.block_field([[0, 0, 200.0]], (8, 4, 2), 1.4)
    >>> dipole = 1.4 * 8 * 4 * 2 / (2 * 3.141592653589793 * 200.0**3)
    >>> bool(abs(far.sel(axis="z").item() / dipole - 1) < 1e-3)
    True
    """
    from estimator.field.exact import cuboid_field
    from estimator.field.sources import BlockMagnet

    if len(size_mm) != 3:
        raise InputError(f"size_mm must be three edges, x, y, z; got {list(size_mm)}")
    x, y, z = (float(edge) for edge in size_mm)
    _require_positive(**{"x edge": x, "y edge": y, "z edge": z})
    block = BlockMagnet((x, y), z, float(polarization_t))
    field_t = cuboid_field(_columns(points_mm), _UP, block, _ALONG_X)
    return _named(np.stack(field_t, axis=-1))


def polarization(
    remanence_t: float,
    size_mm: Sequence[float],
    recoil_permeability: float = 1.05,
) -> float:
    """Mean polarization of a magnet that demagnetises itself, T.

    J = Bᵣ / (1 + N (μᵣ − 1)), N the mean demagnetising factor of the shape (Joseph 1966 for disks,
    Aharoni 1998 for blocks).

    Parameters
    ----------
    remanence_t : float
        Remanence Bᵣ, T.
    size_mm : two or three floats
        Diameter and height of a disk, or the three edges of a block, the last along the
        polarization, mm.
    recoil_permeability : float
        μᵣ, 1 or more.

    Returns
    -------
    float
        Polarization, T.

    Raises
    ------
    InputError
        Neither two nor three lengths, a length that is not positive, or μᵣ below 1.

    Examples
    --------
    A cube demagnetises itself by a third, whatever its size:

    >>> import instobj
    >>> round(instobj.field.polarization(1.2, (5, 5, 5), 1.06), 6) == round(1.2 / 1.02, 6)
    True
    """
    from estimator.field.sources import BlockMagnet, DiskMagnet, self_demagnetised

    if len(size_mm) not in (2, 3):
        raise InputError(
            "size_mm must be (diameter, height) of a disk or (x, y, height) of a block; got "
            f"{list(size_mm)}"
        )
    _require_positive(
        remanence_t=remanence_t, **{f"size_mm[{k}]": v for k, v in enumerate(size_mm)}
    )
    if recoil_permeability < 1:
        raise InputError(f"recoil_permeability must be 1 or more; got {recoil_permeability:g}")
    *edges, height = map(float, size_mm)
    outline: Any = DiskMagnet(edges[0], height, 1.0)
    if len(edges) == 2:
        outline = BlockMagnet((edges[0], edges[1]), height, 1.0)
    at_work = self_demagnetised(outline, float(remanence_t), float(recoil_permeability))
    return float(at_work.polarization_t)


_UP = (np.array(0.0), np.array(0.0), np.array(1.0))
"""Direction of polarization of single magnets: +z."""
_ALONG_X = (np.array(1.0), np.array(0.0), np.array(0.0))
"""Direction of a single block's first edge: +x."""


def _points(points_mm: ArrayLike) -> np.ndarray:
    points = np.asarray(points_mm, dtype=float)
    if points.ndim != 2 or points.shape[1] != 3 or not np.isfinite(points).all():
        raise InputError(
            f"points_mm must be finite numbers of shape (point, 3); got shape {points.shape}. "
            "Give one row x, y, z in mm per point"
        )
    return points


def _columns(points_mm: ArrayLike) -> Any:
    x, y, z = _points(points_mm).T
    return x, y, z


def _require_positive(**values: float) -> None:
    for name, value in values.items():
        if not (np.isfinite(value) and value > 0):
            raise InputError(f"{name} must be positive; got {value:g}")


def _named(field_t: np.ndarray) -> xr.DataArray:
    import xarray as xr

    return xr.DataArray(
        field_t,
        dims=("point", "axis"),
        coords={"axis": list("xyz")},
        attrs={"units": "T"},
        name="flux_density",
    )
