"""Printers: limits of the usual processes, as defaults that a laboratory edits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from design.catalogue.tables import read_table, row_named


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


PRINTERS = read_table("printers", Printer)


def printer_preset(name: str) -> Printer:
    """The printer of that name.

    Raises
    ------
    InputError
        No such preset.
    """
    otherwise = " and give your printer's figures beside it"
    return row_named(PRINTERS, name, "printer.name", otherwise)
