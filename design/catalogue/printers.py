"""Printers: limits of the usual processes, as defaults that a laboratory edits.

Print services publish these figures for parts of this size (walls and pins that hold
without support, holes that stay open, play with which printed parts still slide), rounded to the
safe side, except the play of FDM: 0.1 mm is what the paper's own FDM mould leaves (Knopke et al.,
RA-L 2024). A machine may differ by half: measure yours and give its figures in `[printer]`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from design.errors import InputError

Process = Literal["fdm", "resin", "sls"]


@dataclass(frozen=True)
class Printer:
    """A process with the smallest things it prints, mm; `aspect` is height over width."""

    process: Process
    bed_mm: tuple[float, float, float]
    wall_mm: float
    hole_mm: float
    clearance_mm: float
    aspect: float
    draft_deg: float
    density_g_per_cm3: float


PRINTERS = {
    "fdm-0.4": Printer("fdm", (220.0, 220.0, 240.0), 0.8, 1.0, 0.1, 4.0, 1.0, 1.27),
    "fdm-0.25": Printer("fdm", (220.0, 220.0, 240.0), 0.5, 0.8, 0.1, 4.0, 1.0, 1.27),
    "resin": Printer("resin", (140.0, 80.0, 160.0), 0.5, 0.5, 0.1, 6.0, 1.0, 1.15),
    "sls": Printer("sls", (300.0, 300.0, 300.0), 0.8, 1.5, 0.2, 5.0, 1.0, 1.0),
}
"""Nozzles of 0.4 and 0.25 mm with PETG, a desktop resin printer, sintered PA12."""


def printer_preset(name: str) -> Printer:
    """The printer of that name.

    Raises
    ------
    InputError
        No such preset.
    """
    if name not in PRINTERS:
        raise InputError(
            f"printer.name = {name!r} is not built in ({', '.join(PRINTERS)}). Choose one of them, or "
            "give all figures of [printer] beside the name"
        )
    return PRINTERS[name]
