"""Printers: limits of the usual processes, as defaults that a laboratory edits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from design.catalogue.tables import read_table


@dataclass(frozen=True)
class Printer:
    """A process with the smallest things it prints, mm; `aspect` is height over width."""

    process: Literal["fdm", "resin", "sls"]
    bed_mm: tuple[float, float, float]
    wall_mm: float
    hole_mm: float
    clearance_mm: float
    aspect: float
    draft_deg: float
    density_g_per_cm3: float


PRINTERS = read_table(
    "printers", Printer, "printer.name", " and give your printer's figures beside it"
)
