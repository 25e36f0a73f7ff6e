"""Colour scales of maps: one for all faces, numbers that can be read."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError

BOUND_COLOURS = "magma_r"
"""Perceptually uniform; dark is a large bound, that is a weak location."""
GAIN_COLOURS = "viridis"
"""Perceptually uniform; dark is a low value."""


@dataclass(frozen=True)
class MapScale:
    """Colours and numbers of a map: values are shown divided by 10 to the `exponent`."""

    norm: Any
    colours: str
    unit: str
    exponent: int

    @property
    def label(self) -> str:
        return f"10$^{{{self.exponent}}}$ {self.unit}" if self.exponent else self.unit


def finite_limits(values: Float[np.ndarray, "*any"]) -> tuple[float, float]:
    """Smallest and largest finite value, for one scale over all faces.

    Raises
    ------
    InputError
        No value is finite.
    """
    finite = values[np.isfinite(values)]
    if not finite.size:
        raise InputError(
            "nothing to draw: no value is finite. Check the scores for blind locations"
        )
    return float(finite.min()), float(finite.max())


_FEW_DECADES = 2.5
"""On a bar of 3 inches, with three numbers in each."""


def map_scale(
    unit: str, vmin: float, vmax: float, log: bool = False, colours: str = BOUND_COLOURS
) -> MapScale:
    """Scale from `vmin` to `vmax`; sizes of 10⁴ and more or below 10⁻³ get a power of ten.

    Raises
    ------
    InputError
        Limits out of order, or a logarithmic scale from a value that is not positive.
    """
    from matplotlib.colors import LogNorm, Normalize

    if vmin > vmax or (log and vmin <= 0):
        wanted = "0 < vmin ≤ vmax" if log else "vmin ≤ vmax"
        raise InputError(
            f"the map's limits must satisfy {wanted}; got {vmin:g} and {vmax:g} {unit}"
        )
    size = int(np.floor(np.log10(max(abs(vmin), abs(vmax), 1e-300))))
    exponent = size if size >= 4 or -300 < size < -3 else 0
    high = vmax if vmax > vmin else vmin + (abs(vmin) or 1.0) * 1e-3
    norm = (LogNorm if log else Normalize)(vmin / 10**exponent, high / 10**exponent)
    return MapScale(norm, colours, unit, exponent)


def set_plain_ticks(bar: Any, scale: MapScale) -> None:
    """Decimal numbers at 1, 2 and 5 of every decade, at 1 alone where there are many, instead of powers
    of ten."""
    from matplotlib.colors import LogNorm
    from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

    if isinstance(scale.norm, LogNorm):
        decades = np.log10(float(scale.norm.vmax or 1) / float(scale.norm.vmin or 1))
        bar.set_ticks(LogLocator(subs=(1.0, 2.0, 5.0) if decades <= _FEW_DECADES else (1.0,)))
        bar.minorlocator = NullLocator()
        bar.formatter = FuncFormatter(lambda value, _: f"{value:g}")
        bar.update_ticks()
