"""How far small-strain mechanics can be trusted at a depth of indentation."""

from __future__ import annotations

import numpy as np

_DEPTH_OVER_THICKNESS = (0.0, 0.0625, 0.125, 0.25)
_FORCE_EXCESS = (0.0, 0.03, 0.07, 0.19)


def linear_force_shortfall(depth_mm: float, thickness_mm: float) -> float | None:
    """Share by which a neo-Hookean layer needs more force than the linear model says.

    Interpolated from an axisymmetric neo-Hookean study of a flat R5 punch on a bonded layer of
    8 mm (+3 % at 0.5 mm, +7 % at 1 mm, +19 % at 2 mm), scaled by depth over thickness. For
    another tip or layer it is an orientation, good to about a factor of two. None beyond a
    quarter of the thickness, where nothing was measured: more than 19 %.
    """
    ratio = depth_mm / thickness_mm
    if ratio > _DEPTH_OVER_THICKNESS[-1]:
        return None
    return float(np.interp(ratio, _DEPTH_OVER_THICKNESS, _FORCE_EXCESS))
