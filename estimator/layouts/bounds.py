"""Cramér–Rao bounds of many layouts at once, and their percentiles."""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

_SMALLEST = 1e-6
"""Share of a direction's information that the others do not explain, from which float32 holds."""


def bounds(
    jacobian: Float[Tensor, "channel layout 3 place"],
) -> tuple[Float[Tensor, "layout place"], Float[Tensor, "layout place"]]:
    """Position and force bounds from whitened derivatives by x, y and force.

    By elimination, with parameters in units of their own information. Where a direction is left
    with less than a millionth of it, the bound is held at what that gives. Elimination cancels: a bound
    rounds by at most 8 u / share (measured: 4), with u = 2^-24 in single precision and the share of x's and
    y's information (det, over xx yy) that the others do not explain; sums in another order, as another
    processor or batch takes them, differ by as much.
    """
    x, y, f = jacobian.unbind(2)
    xx, yy, ff = ((a * a).sum(0) + 1e-20 for a in (x, y, f))
    xy, xf, yf = ((a * b).sum(0) for a, b in ((x, y), (x, f), (y, f)))
    xx_f, yy_f, xy_f = xx - xf * xf / ff, yy - yf * yf / ff, xy - xf * yf / ff
    determinant = xx_f * yy_f - xy_f * xy_f
    determinant = torch.maximum(determinant, _SMALLEST * xx * yy)
    position = (torch.maximum(xx_f + yy_f, _SMALLEST * (xx + yy)) / determinant).sqrt()
    across = torch.maximum(xx * yy - xy * xy, _SMALLEST * xx * yy)
    force = (across / (ff * determinant)).sqrt()
    return position, force


def percentile(ordered: Float[Tensor, "layout place"], percent: float) -> Float[Tensor, "layout"]:
    """Linear between the two nearest ranks, as NumPy's."""
    rank = percent / 100 * (ordered.shape[1] - 1)
    below = min(int(rank), ordered.shape[1] - 2)
    return torch.lerp(ordered[:, below], ordered[:, below + 1], rank - below)
