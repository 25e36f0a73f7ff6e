"""Mechanics, as pure functions: presses of an object, rigid shapes on a half-space, constants."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from fem.linear.material import lame_constants

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import ArrayLike

__all__ = ["indent_half_space", "lame_constants", "press"]

_MOST_CELLS = 6000
"""Cells that may touch: their mutual compliance is a dense matrix of 8 bytes an entry, 0.3 GB."""


def press(
    spec: ObjectSpec, tips: Sequence[tuple[int, float, float]], depth_mm: ArrayLike
) -> xr.Dataset:
    """Press the indenter of a specification at one place or several at once, without friction.

    Small strain. The mesh and its response are made first, or read from the store of `Run`.

    Parameters
    ----------
    spec : ObjectSpec
        The object; its `[indenter]` is the tip.
    tips : sequence of (face, x, y)
        Where each tip lands, mm in the face's frame.
    depth_mm : float or array_like (tip,)
        How deep each tip is pressed, mm.

    Returns
    -------
    Dataset (tip, magnet, component)
        `force_n` (N), `contact_area_mm2` (mm²), and `motion` of every magnet: displacement along
        x, y, z in mm and rotation vector in rad, in the object's frame.

    Raises
    ------
    InputError
        A tip on no sensed face, over a face's border, or overlapping another.

    Examples
    --------
    Two presses far apart bear nearly what each bears alone:

    >>> import instobj
    >>> tiny = instobj.ObjectSpec(
    ...     name="tiny", body={"sensed_faces": [1]},
    ...     mesh={"edge_mm": 8.0, "surface_edge_mm": 3.0, "envelope_mm": 0.1},
    ... )
    >>> one = instobj.fem.press(tiny, [(1, 0.0, 0.0)], 1.0)
    >>> two = instobj.fem.press(tiny, [(1, 0.0, 0.0), (1, 12.0, 12.0)], 1.0)
    >>> two.force_n.dims, two.force_n.attrs["units"]
    (('tip',), 'N')
    >>> bool(abs(two.force_n[0] / one.force_n[0] - 1) < 0.1)
    True
    """
    from fem.presses.joint import Tip, press_tips
    from instobj.stages.named import Results
    from instobj.stages.run import Run
    from instobj.store import readers

    if not tips:
        raise InputError("tips is empty. Give one (face, x_mm, y_mm) for each tip")
    depths = np.broadcast_to(np.asarray(depth_mm, float), len(tips))
    if not (np.isfinite(depths).all() and (depths > 0).all()):
        raise InputError(f"depth_mm must be positive; got {depth_mm}")
    placed = [Tip(int(face), float(x), float(y)) for face, x, y in tips]
    pressed = press_tips(spec, Run(spec).read(readers.RESPONSE), placed, depths)
    return Results(
        {
            "force_n": ("tip", pressed.force_n, {"units": "N"}),
            "contact_area_mm2": ("tip", pressed.contact_area_mm2, {"units": "mm2"}),
            "motion": (("magnet", "component"), pressed.motion, {"units": "mm mm mm rad rad rad"}),
        },
        coords={
            "face": ("tip", [tip.face for tip in placed]),
            "x_mm": ("tip", [tip.x_mm for tip in placed], {"units": "mm"}),
            "y_mm": ("tip", [tip.y_mm for tip in placed], {"units": "mm"}),
            "depth_mm": ("tip", pressed.depth_mm, {"units": "mm"}),
        },
    )


def indent_half_space(
    height_mm: ArrayLike,
    cell_mm: float,
    depth_mm: float,
    youngs_modulus_mpa: float,
    poisson_ratio: float = 0.5,
) -> xr.Dataset:
    """Press a rigid shape into a large elastic block, without friction.

    The shape is a map of heights over square cells. Pressure is constant in a cell, never negative,
    and zero where there is a gap.

    Parameters
    ----------
    height_mm : array_like (x, y)
        The shape's surface above its lowest point, mm. It stands at the cells' middles.
    cell_mm : float
        Edge of a cell, mm.
    depth_mm : float
        How far the lowest point goes below the block's surface, mm.
    youngs_modulus_mpa, poisson_ratio : float
        Of the block.

    Returns
    -------
    Dataset (x, y)
        `pressure_mpa` (MPa), and the whole `force_n` (N).

    Raises
    ------
    InputError
        Not a finite map of two dimensions, a number that is not positive, more than 6000 cells below
        `depth_mm`, or no elastic solid.

    Examples
    --------
    A sphere of radius 5 mm, as Hertz has it (4/3 E* √R δ^1.5):

    >>> import numpy as np
    >>> import instobj
    >>> x = np.arange(-2.0, 2.01, 0.1)
    >>> sphere = 5 - np.sqrt(25 - x[:, None] ** 2 - x**2)
    >>> pressed = instobj.fem.indent_half_space(sphere, 0.1, 0.25, 0.3)
    >>> hertz = 4 / 3 * 0.3 / (1 - 0.5**2) * np.sqrt(5) * 0.25**1.5
    >>> bool(abs(pressed.force_n / hertz - 1) < 0.02)
    True
    """
    from fem.contact.complementarity import contact_pressures
    from fem.contact.half_space import Patches, normal_compliance
    from instobj.stages.named import Results

    height = np.asarray(height_mm, float)
    if height.ndim != 2 or not np.isfinite(height).all():
        raise InputError(f"height_mm must be finite numbers of shape (x, y); got {height.shape}")
    for name, value in {"cell_mm": cell_mm, "depth_mm": depth_mm}.items():
        if not (np.isfinite(value) and value > 0):
            raise InputError(f"{name} must be positive; got {value:g}")
    lame_constants(youngs_modulus_mpa, poisson_ratio)  # refuses what is no elastic solid
    height = height - height.min()
    # only cells below the depth can touch: the block's surface is drawn in, never raised, under a push
    below = np.argwhere(height < depth_mm)
    if len(below) > _MOST_CELLS:
        raise InputError(
            f"{len(below)} cells lie below the depth, more than {_MOST_CELLS}. Give a larger cell_mm"
        )
    count, area = len(below), cell_mm**2
    # variance of a uniform square along each axis: edge²/12
    squares = Patches(np.full(count, area), below * cell_mm, np.full(count, area / 12))
    compliance = normal_compliance(
        squares, squares, float(youngs_modulus_mpa), float(poisson_ratio)
    )
    moments = height[tuple(below.T)] * area
    pressures = contact_pressures(
        compliance, moments, squares.area_mm2, np.array([float(depth_mm)])
    )[0]
    pressure = np.zeros_like(height)
    pressure[tuple(below.T)] = pressures
    return Results(
        {
            "pressure_mpa": (("x", "y"), pressure, {"units": "MPa"}),
            "force_n": ((), float(pressures.sum() * area), {"units": "N"}),
        }
    )
