"""Compliance of a soft pad between a rigid indenter and the face, in series with the face's own.

A pad is a layer of even thickness t, bonded to the indenter and free of friction at the face. Its surface
compliance is a half-space's times L(kt) at wavenumber k (`fem.contact.rigid_base`). The share 1 − L that
the backing takes back reaches about as far as the pad is thick; between two patches of summed variance s,
d apart, it is
    (1 − ν²)/(π E t) ∫ (1 − L(α)) exp(−α² s/2t²) J₀(α d/t) dα.
Limits: a stiff pad is rigid; pressure that changes slowly sinks t (1 + ν)(1 − 2ν)/((1 − ν) E) in. The layer
goes on beyond what is pressed, as of a pad that hangs over or is much wider than thick; it follows bent
indenters as if they were flat. docs/measured/presses.md says what both cost.
"""

from __future__ import annotations

import numpy as np
from jaxtyping import Float
from scipy.interpolate import RectBivariateSpline
from scipy.special import j0

from design.spec.mechanics import IndenterSpec
from fem.contact.half_space import Patches, normal_compliance
from fem.contact.rigid_base import log_taken_share

_LARGEST_ALPHA = 14.0
"""Wavenumber times thickness up to which 1 − L is integrated: it is below 1e-9 there."""
_NODES_PER_TURN = 12
"""Nodes of quadrature, at least, for each turn of the Bessel function."""
_DISTANCE_STEP = 0.1
"""Step in thicknesses of the table over distances: its spline is off by less than 1e-6."""
_VARIANCES = 6
"""Variances in the table: their exponential is smooth."""


def pad_compliance(patches: Patches, indenter: IndenterSpec) -> Float[np.ndarray, "cell cell"]:
    """∫ u_n dA over each cell per unit pressure on each, mm³/MPa; 0 without a pad."""
    count, (thickness, modulus, ratio) = len(patches.area_mm2), indenter.pad
    if not thickness:
        return np.zeros((count, count))
    away = patches.centre_mm[:, None] - patches.centre_mm[None]
    distance = np.linalg.norm(away, axis=-1) / thickness
    variance = np.add.outer(patches.variance_mm2, patches.variance_mm2) / thickness**2
    table = _taken_back(float(distance.max()), float(variance.min()), float(variance.max()), ratio)
    factor = (1 - ratio**2) / (np.pi * modulus * thickness)
    areas = np.multiply.outer(patches.area_mm2, patches.area_mm2)
    return normal_compliance(patches, patches, modulus, ratio) - factor * areas * table.ev(
        distance, variance
    )


def _taken_back(farthest: float, least: float, most: float, ratio: float) -> RectBivariateSpline:
    """Table of ∫ (1 − L) exp(−α² s/2) J₀(α d) dα over distance d and variance s, in thicknesses."""
    distance = np.arange(0, farthest + 4 * _DISTANCE_STEP, _DISTANCE_STEP)
    variance = np.linspace(0.99 * least, 1.01 * most, _VARIANCES)
    turns = _LARGEST_ALPHA * distance[-1] / (2 * np.pi)
    node, weight = np.polynomial.legendre.leggauss(int(_NODES_PER_TURN * turns) + 60)
    alpha, weight = (node + 1) * _LARGEST_ALPHA / 2, weight * _LARGEST_ALPHA / 2
    share = weight * np.exp(log_taken_share(alpha, ratio))
    # d distance, a node of α, s variance
    bessel = j0(np.multiply.outer(distance, alpha))
    faded = np.exp(-np.multiply.outer(variance, alpha**2) / 2)
    return RectBivariateSpline(distance, variance, np.einsum("da,sa,a->ds", bessel, faded, share))
