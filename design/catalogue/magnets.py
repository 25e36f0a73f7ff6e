"""Magnets as sold: `magnets.part` takes shape, dimensions and grade from here.

The catalogued parts stand with their seller's number. Names like D6x1 are sizes in which many
sellers stock sintered NdFeB and say nothing of the grade.
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
        """What `[magnets]` takes from the part."""
        known: dict[str, Any] = {"shape": self.shape, "height_mm": self.height_mm}
        if self.shape == "block":
            known["size_mm"] = self.across_mm
        else:
            known["diameter_mm"] = self.across_mm[0]
            known["inner_diameter_mm"] = self.across_mm[1] if self.shape == "ring" else 0.0
        return known


_STOCK = "stock size of many sellers"
_DISKS = {
    3.0: (1.0, 1.5, 2.0, 3.0),
    4.0: (1.0, 1.5, 2.0, 3.0),
    5.0: (1.0, 1.5, 2.0, 3.0),
    6.0: (1.0, 1.5, 2.0, 3.0),
    8.0: (1.0, 2.0, 3.0),
    10.0: (1.0, 2.0, 3.0),
}

MAGNET_PARTS = {
    part.name: part
    for part in (
        *(
            MagnetPart(f"D{diameter:g}x{height:g}", "disk", (diameter,), height, None, _STOCK)
            for diameter, heights in _DISKS.items()
            for height in heights
        ),
        *(
            MagnetPart(f"R{outer:g}x{inner:g}x{height:g}", "ring", (outer, inner), height, None, _STOCK)
            for outer, inner, height in ((6.0, 2.0, 2.0), (8.0, 4.0, 2.0), (10.0, 4.0, 2.0))
        ),
        *(
            MagnetPart(f"B{x:g}x{y:g}x{height:g}", "block", (x, y), height, None, _STOCK)
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
