"""Order numbers and guide prices of parts that are bought: maker's number, pack, price range, date."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.tables import read_table

PRICED = "2025-11"
"""Month of the prices' estimates."""


@dataclass(frozen=True)
class Order:
    """A part as it is ordered: number of its maker, pieces in a pack, prices of a pack (EUR)."""

    title: str
    maker: str
    number: str
    price_eur: tuple[float, float]
    pieces: int = 1
    note: str = ""
    source: str = ""

    @property
    def middle_eur(self) -> float:
        """Middle of the price range, a piece."""
        return sum(self.price_eur) / 2 / self.pieces

    def packs(self, pieces: int) -> int:
        """Number of packs that hold `pieces`."""
        return -(-pieces // self.pieces)


HX711, LOAD_CELL, VERNIER, BTA_ADAPTER = "HX711", "load cell", "force sensor", "BTA adapter"
MUX, EXPANDER, SHIFTER, BUFFER, RESISTOR, WIRE, STRIP, SCREW, GLUE, PRIMER, ADHESIVE, RELEASE = (
    "multiplexer board",
    "expander board",
    "level shifter",
    "supply buffer",
    "pull-up resistor",
    "wire",
    "stripboard",
    "M3 x 16",
    "instant adhesive",
    "primer",
    "silicone adhesive",
    "release agent",
)
SILICONE_KIT_G = 900.0
"""Mass of both parts together, in the kits below."""

ORDERS = read_table("orders", Order)
