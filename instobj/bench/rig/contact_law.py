"""Force that a specification lets expect at a travel, to bound presses and to check a load cell's scale.

dF/dδ = 2 E* a for a frictionless rigid tip with contact radius a, E* = E / (1 − ν²): under a sphere
a = √(R δ) (Hertz), under a flat punch its own radius. A thin layer that is bonded to something rigid is
stiffer by 1 + 1.133 χ + 1.283 χ² + 0.769 χ³ + 0.0975 χ⁴, χ = √(R δ) / h, for ν = 1/2 (Dimitriadis et al.,
Biophysical Journal 82 (2002) 2798); taken here with χ = a / h for every tip and material. Near edges
and over small ν it is an upper estimate: bodies of finite size yield more. The chain's finite
elements give 5 to 9 N at 2 mm on the paper's cube, this law 7.9 N.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.body import body_of
from design.layout.tips import TipShape, tip_heights_mm, tip_shape
from design.spec.object import ObjectSpec

_LAYER = (1.0, 1.133, 1.283, 0.769, 0.0975)
_DEPTHS = 400
"""Steps of the law's table: the force of a power 1.5 within 0.1 %."""
_DEEPEST_SHARE = 0.95
"""Share of the shell that a press may go down: nearer to the core nothing of this law holds."""
_GRID = 201
_UNITS = {
    1e-3: "they may be kN read as N",
    9.8e-3: "they may be N scaled as grams",
    0.102: "they may be kgf read as N",
    0.2248: "they may be lbf read as N",
    3.6: "they may be ozf read as N",
    9.8: "they may be N scaled as kg",
    102.0: "they may be grams-force read as N",
    1e3: "they may be mN read as N",
}
"""Causes of readings that are too large, by their factor."""
_UNKNOWN_STIFFER = 2.0
"""Factor between true and stated modulus where nobody knows its interval, as the moduli below differ."""
LARGEST_RATIO = 10**0.5
"""Between measured and expected stiffness: a modulus is known within a factor of two (0.23 to 1.1 MPa were
found where 0.41 was drawn), this law within 1.5, and a wrong unit is off by 4.4 and more (ozf 3.6)."""


@dataclass(frozen=True)
class ContactLaw:
    """Forces (N) at rising travels (mm) of a tip into the middle of a face."""

    depths_mm: Float[np.ndarray, "depth"]
    forces_n: Float[np.ndarray, "depth"]

    def force_n(self, depth_mm: float, stiffer: float = 1.0) -> float:
        """Return the force at a travel of an object `stiffer` times as stiff."""
        return stiffer * float(np.interp(depth_mm, self.depths_mm, self.forces_n))

    def depth_mm(self, force_n: float, stiffer: float = 1.0) -> float:
        """Travel at which a force is expected; the deepest one where it never is."""
        return float(np.interp(force_n / stiffer, self.forces_n, self.depths_mm))

    def ratio(
        self, depths_mm: Float[np.ndarray, "step"], forces_n: Float[np.ndarray, "step"]
    ) -> float:
        """Measured forces over those expected at the same travels (least squares)."""
        expected = np.interp(depths_mm, self.depths_mm, self.forces_n)
        return float(expected @ forces_n / max(float(expected @ expected), 1e-12))


def contact_law(spec: ObjectSpec) -> ContactLaw:
    """The law of a specification's tips on its shell."""
    shell_mm, silicone = body_of(spec).silicone_mm, spec.silicone
    # Closer together near the surface, where the contact's radius grows the fastest.
    depths = _DEEPEST_SHARE * shell_mm * np.linspace(0.0, 1.0, _DEPTHS) ** 2
    radius = _contact_radius_mm(tip_shape(spec.indenter), depths)
    modulus = max(silicone.youngs_modulus_mpa, silicone.surface_modulus_mpa)
    slope = 2 * modulus / (1 - silicone.poisson_ratio**2) * radius * spec.indenter.tip_count
    steps = (slope[1:] + slope[:-1]) / 2 * np.diff(depths)
    layer = np.polynomial.polynomial.polyval(radius / shell_mm, _LAYER)
    return ContactLaw(depths, np.concatenate([[0.0], np.cumsum(steps)]) * layer)


def travel_bound_mm(spec: ObjectSpec, limit_n: float) -> float:
    """Return the travel below the stated surface that no press without a load cell exceeds.

    Even at the upper end of the modulus' interval less than the limit (N) is expected there, and it lies
    within `press.depths_mm`, where mechanics know the forces that a label by travel stands for.
    """
    modulus, interval = spec.silicone.youngs_modulus_mpa, spec.silicone.youngs_modulus_range_mpa
    stiffer = _UNKNOWN_STIFFER if interval is None else max(interval[1] / modulus, 1.0)
    return min(contact_law(spec).depth_mm(limit_n, stiffer), spec.press.depths_mm[-1])


def likely_unit(ratio: float) -> str:
    """The end of a sentence: what a load cell does whose forces are a multiple of those expected; empty
    where they may be right."""
    if ratio < 0:
        return ": pressing makes them smaller, so the sign of the scale is wrong"
    if 1 / LARGEST_RATIO <= ratio <= LARGEST_RATIO:
        return ""
    return f": {_UNITS[min(_UNITS, key=lambda times: abs(np.log(max(ratio, 1e-12) / times)))]}"


def _contact_radius_mm(
    shape: TipShape, depths_mm: Float[np.ndarray, "depth"]
) -> Float[np.ndarray, "depth"]:
    """√(R δ) under a round tip; else that of the disk as large as the tip's section at the depth, which is
    more than what touches."""
    if shape.radius_mm is not None:
        return np.sqrt(shape.radius_mm * depths_mm)
    low, high = shape.corners_mm.min(axis=0), shape.corners_mm.max(axis=0)
    axes = [np.linspace(low[k], high[k], _GRID) for k in (0, 1)]
    heights = np.sort(tip_heights_mm(shape, np.stack(np.meshgrid(*axes), axis=-1)), axis=None)
    cell_mm2 = float(np.prod(high - low)) / (_GRID - 1) ** 2
    below = np.searchsorted(heights, depths_mm, side="right")
    return np.sqrt(below * cell_mm2 / np.pi)
