"""Magnets and magnet grades as sold: `magnets.part` and `magnets.grade` take their figures from here.

All figures are typical: a delivered magnet may lie
anywhere in its grade's range, and makers' ranges differ by 0.01 to 0.02 T among themselves.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from design.catalogue.tables import read_table

MagnetShape = Literal["disk", "ring", "block"]


STOCK = "stock size of many sellers"


@dataclass(frozen=True)
class MagnetPart:
    """One magnet, magnetised along its height.

    `across_mm` is (diameter,) of a disk, (outer, inner diameter) of a ring, two edges of a block.
    """

    name: str
    shape: MagnetShape
    across_mm: tuple[float, ...]
    height_mm: float
    grade: str | None = None
    source: str = STOCK

    def figures(self) -> dict[str, Any]:
        """Return what `[magnets]` takes from the part."""
        values: dict[str, Any] = {"shape": self.shape, "height_mm": self.height_mm}
        if self.shape == "block":
            values["size_mm"] = self.across_mm
        else:
            values["diameter_mm"] = self.across_mm[0]
            values["inner_diameter_mm"] = self.across_mm[1] if self.shape == "ring" else 0.0
        return values


MAGNET_PARTS = read_table(
    "magnets",
    MagnetPart,
    "magnets.part",
    ", or leave it out and give magnets.shape and its dimensions",
)


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

    def admits(self, remanence_t: float) -> bool:
        """Return whether a magnet of this grade may have that remanence."""
        return self.remanence_min_t <= remanence_t <= self.remanence_max_t


GRADES = read_table(
    "grades", MagnetGrade, "magnets.grade", ", or leave it out and give magnets.remanence_t"
)
