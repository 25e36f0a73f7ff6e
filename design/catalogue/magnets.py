"""Magnets and magnet grades as sold: `magnets.part` and `magnets.grade` take their figures from here.

The catalogued parts stand with their seller's number. Names like D6x1 are sizes in which many
sellers stock sintered NdFeB and say nothing of the grade. All figures are typical: a delivered magnet may lie
anywhere in its grade's range, and makers' ranges differ by 0.01 to 0.02 T among themselves.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from design.errors import InputError

MagnetShape = Literal["disk", "ring", "block"]


@dataclass(frozen=True)
class MagnetPart:
    """One magnet, magnetised along its height.

    `across_mm` is (diameter,) of a disk, (outer, inner diameter) of a ring, two edges of a block.
    """

    name: str
    shape: MagnetShape
    across_mm: tuple[float, ...]
    height_mm: float
    grade: str | None
    source: str

    def figures(self) -> dict[str, Any]:
        """Return what `[magnets]` takes from the part."""
        values: dict[str, Any] = {"shape": self.shape, "height_mm": self.height_mm}
        if self.shape == "block":
            values["size_mm"] = self.across_mm
        else:
            values["diameter_mm"] = self.across_mm[0]
            values["inner_diameter_mm"] = self.across_mm[1] if self.shape == "ring" else 0.0
        return values


STOCK = "stock size of many sellers"
_DISKS = {
    3.0: (1.0, 1.5, 2.0, 3.0),
    4.0: (1.0, 1.5, 2.0, 3.0),
    5.0: (1.0, 1.5, 2.0, 3.0),
    6.0: (1.0, 1.5, 2.0, 3.0),
    8.0: (1.0, 2.0, 3.0),
    10.0: (1.0, 2.0, 3.0),
    15.0: (3.0, 5.0),
    20.0: (3.0, 5.0),
}

MAGNET_PARTS = {
    part.name: part
    for part in (
        *(
            MagnetPart(f"D{diameter:g}x{height:g}", "disk", (diameter,), height, None, STOCK)
            for diameter, heights in _DISKS.items()
            for height in heights
        ),
        *(
            MagnetPart(f"R{outer:g}x{inner:g}x{height:g}", "ring", (outer, inner), height, None, STOCK)
            for outer, inner, height in ((6.0, 2.0, 2.0), (8.0, 4.0, 2.0), (10.0, 4.0, 2.0))
        ),
        *(
            MagnetPart(f"B{x:g}x{y:g}x{height:g}", "block", (x, y), height, None, STOCK)
            for x, y, height in ((5.0, 5.0, 1.0), (5.0, 5.0, 2.0), (5.0, 5.0, 5.0), (8.0, 4.0, 2.0))
        ),
        MagnetPart("MP 12x5x2 / N38", "ring", (12.0, 5.0), 2.0, "N38", "Dhit, catalogue no. 030498"),
        MagnetPart("MP 20x5x5 / N38", "ring", (20.0, 5.0), 5.0, "N38", "Dhit, catalogue no. 030186"),
        MagnetPart("MP 20x10x5 / N38", "ring", (20.0, 10.0), 5.0, "N38", "Dhit, catalogue no. 030184"),
        MagnetPart(
            "MPL 10x5x1.5 / N38", "block", (10.0, 5.0), 1.5, "N38", "Dhit, catalogue no. 020114"
        ),
        MagnetPart("MPL 20x5x3 / N38", "block", (20.0, 5.0), 3.0, "N38", "Dhit, catalogue no. 020131"),
    )
}  # fmt: skip
"""The paper's cube uses D6x1. Sellers state ±0.1 mm on every dimension."""


def magnet_part(name: str) -> MagnetPart:
    """The magnet of that part name.

    Raises
    ------
    InputError
        No such part.
    """
    if name not in MAGNET_PARTS:
        raise InputError(
            f"magnets.part = {name!r} is not a known part. Choose one of {', '.join(MAGNET_PARTS)}, "
            "or leave it out and give magnets.shape and its dimensions"
        )
    return MAGNET_PARTS[name]


REFERENCE_TEMPERATURE_C = 20.0
"""At which remanence is stated."""
NDFEB_REMANENCE_PER_KELVIN = -0.0011
"""Reversible change of remanence of sintered NdFeB; makers give −0.11 to −0.12 %/K up to 100 °C."""
NDFEB_RECOIL_PERMEABILITY = 1.05
"""Slope of the recoil line over μ0: makers of sintered NdFeB state 1.05 for all grades, 1.02 to 1.10."""


@dataclass(frozen=True)
class MagnetGrade:
    """A grade of sintered NdFeB: least, typical and largest remanence at 20 °C."""

    name: str
    remanence_min_t: float
    remanence_t: float
    remanence_max_t: float
    max_temperature_c: float = 80.0

    def admits(self, remanence_t: float) -> bool:
        """Return whether a magnet of this grade may have that remanence."""
        return self.remanence_min_t <= remanence_t <= self.remanence_max_t


GRADES = {
    grade.name: grade
    for grade in (
        MagnetGrade("N35", 1.17, 1.20, 1.23),
        MagnetGrade("N38", 1.22, 1.24, 1.26),
        MagnetGrade("N40", 1.25, 1.27, 1.29),
        MagnetGrade("N42", 1.28, 1.31, 1.33),
        MagnetGrade("N45", 1.32, 1.35, 1.38),
        MagnetGrade("N48", 1.37, 1.40, 1.42),
        MagnetGrade("N50", 1.40, 1.43, 1.46),
        MagnetGrade("N52", 1.42, 1.45, 1.48),
    )
}
"""Standard (80 °C) grades. Ranges span the tables of several makers and sellers (Magnet Expert,
Dura Magnetics, K&J Magnetics, Shanghai Magnet); Dura states 60 °C for N50 and N52."""


def magnet_grade(name: str) -> MagnetGrade:
    """The grade of that name.

    Raises
    ------
    InputError
        No such grade.
    """
    if name not in GRADES:
        raise InputError(
            f"magnets.grade = {name!r} is not a known grade. Choose one of {', '.join(GRADES)}, or "
            "leave it out and give magnets.remanence_t"
        )
    return GRADES[name]


def typical_grade(remanence_t: float) -> str | None:
    """The grade whose typical remanence that is, if any."""
    return next((g.name for g in GRADES.values() if g.remanence_t == remanence_t), None)


def remanence_at_temperature_t(remanence_t: float, temperature_c: float) -> float:
    """Remanence (T) of NdFeB at a temperature (°C), from that at 20 °C; linear and reversible."""
    rise_k = temperature_c - REFERENCE_TEMPERATURE_C
    return remanence_t * (1 + NDFEB_REMANENCE_PER_KELVIN * rise_k)
