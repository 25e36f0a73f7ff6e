"""Silicones: Young's modulus with its spread, from a name or from a Shore hardness.

Moduli of silicones scatter by a factor of two between sources: batches, mixing, hardness readings,
speed and size of the strain all enter. So every figure here is an interval with a likely value.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from design.catalogue.tables import read_table
from design.errors import InputError

_INCOMPRESSIBLE = 0.4999
"""Poisson's ratio of silicone: nearly incompressible; at 0.5 the bulk modulus would be infinite."""


@dataclass(frozen=True)
class ModulusEstimate:
    """Young's modulus at small strain (MPa), the interval that it may lie in, and the source."""

    youngs_modulus_mpa: float
    low_mpa: float
    high_mpa: float
    source: str

    @property
    def range_mpa(self) -> tuple[float, float]:
        return (self.low_mpa, self.high_mpa)

    def admits(self, youngs_modulus_mpa: float) -> bool:
        """Return whether a modulus lies in the interval."""
        return self.low_mpa <= youngs_modulus_mpa <= self.high_mpa


@dataclass(frozen=True)
class Casting:
    """Casting of a rubber: chemistry, parts A : B by mass, times at 23 °C, strain at break."""

    cure: Literal["platinum", "tin", "none"]
    mix_ratio: tuple[float, float]
    elongation_percent: float
    pot_life_min: float | None = None
    cure_h: float | None = None


@dataclass(frozen=True)
class Silicone:
    """A casting rubber by its trade name."""

    name: str
    modulus: ModulusEstimate
    density_g_per_cm3: float
    poisson_ratio: float = _INCOMPRESSIBLE
    casting: Casting | None = None


SILICONES = read_table(
    "silicones",
    Silicone,
    "silicone.name",
    ", or give silicone.youngs_modulus_mpa or silicone.modulus_from",
)


def modulus_from_shore(reading: str) -> ModulusEstimate:
    """E (MPa) of a hardness such as "A10" or "00-30", with the spread of the relation.

    Raises
    ------
    InputError
        Another scale, or a number outside 0 to 95.
    """
    match = re.fullmatch(r"\s*(A|00|OO)[\s-]*(\d+(?:\.\d+)?)\s*", reading, re.IGNORECASE)
    hardness = float(match[2]) if match else -1.0
    if match is None or not 0 <= hardness <= 95:
        raise InputError(
            f"silicone.modulus_from = {reading!r} is no hardness that can be converted. Write the scale (A "
            'or 00) and a number from 0 to 95, as in "A10" or "00-30", or a file (.csv)'
        )
    relation, low, high, source = _RELATIONS["A"] if match[1].upper() == "A" else _RELATIONS["00"]
    modulus = relation(hardness)
    return ModulusEstimate(modulus, low * modulus, high * modulus, f"{source} at {reading.strip()}")


def youngs_modulus_from_shore_a_mpa(shore_a: float) -> float:
    """Gent's relation, E in MPa; 0.414 at Shore A10.

    A. N. Gent, Rubber Chem. Technol. 31 (1958) 896: the truncated cone as a flat punch of its mean
    radius. Silicones of A10 to A30 lie at 0.3 to 0.45 of it by their initial slope in tensile tests,
    at 0.5 to 0.75 by their stress at 100 % strain, at 0.6 to 0.9 by the makers' 100 % moduli; five
    points of hardness, the trade's tolerance, are 20 to 36 %.
    """
    return 0.0981 * (56 + 7.66 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def youngs_modulus_from_shore_00_mpa(shore_00: float) -> float:
    """Hertz's relation for the 00 durometer, E in MPa; 0.106 at Shore 00-30.

    The ball of radius 1.19 mm is pressed δ = 2.5 (1 − S/100) mm deep with 0.203 + 0.00908 S newtons
    (ASTM D2240): E = ¾ (1 − ν²) F / (√R δ^1.5) with ν = ½, as Mix and Giacomin (J. Test. Eval. 39
    (2011) 696) treat hemispherical indenters. δ exceeds R below S = 52, far beyond Hertz: Ecoflex
    00-10 to 00-50 (tensile tests, 100 % moduli) lie at 0.4 to 2.1 of it.
    """
    force_n = 0.203 + 0.00908 * shore_00
    depth_mm = 2.5 * (1 - shore_00 / 100)
    return 0.75 * (1 - 0.5**2) * force_n / (1.19**0.5 * depth_mm**1.5)


_RELATIONS = {
    "A": (youngs_modulus_from_shore_a_mpa, 0.3, 1.3, "Gent's relation (1958)"),
    "00": (youngs_modulus_from_shore_00_mpa, 0.4, 2.1, "Hertz's relation for ASTM D2240's ball"),
}
"""Relation, lower and upper share of its result, name."""
