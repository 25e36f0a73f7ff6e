"""Fabrication in a specification: mould, printer, files.

Defaults give the paper's two-part mould (Knopke et al., RA-L 2024); docs/units.md gives the source
of each figure.
"""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from design.catalogue.printers import PRINTERS, Printer
from design.spec.base import Angle, SpecPart

Gap = Annotated[float, Field(ge=0.005, le=2)]
"""Between printed parts (mm)."""
Thickness = Annotated[float, Field(ge=0.1, le=100)]
"""Thickness of walls and features of printed parts (mm)."""
Bed = Annotated[float, Field(ge=20, le=5000)]


class MouldSpec(SpecPart):
    """The mould that the shell is cast in.

    "one-piece" is the paper's box with bosses on its walls, for bodies with an open side; "split"
    are two halves, pulled apart across a plane through z, with loose pins as bosses, drawn first,
    along their own axes (bosses that point along the pull stay on their half). Left out, the style
    is one piece where a side is open. The plane's normal has `parting_azimuth_deg` from x; left
    out, it is chosen for the body's kind (`design.layout.mould.frame.parting`).
    `printer.clearance_mm` is left between parts that slide. A closed mould is poured through a
    hole of `pour_mm`; vents of `printer.hole_mm` stand where air would be caught. Walls that shape
    silicone have the draft of the object's own; pins and rods are straight.
    """

    style: Literal["one-piece", "split"] | None = None
    wall_mm: Thickness = 1.5
    parting_azimuth_deg: Angle | None = None
    pour_mm: Thickness = 6.0


class PrinterSpec(SpecPart):
    """Limits of the printer of core, mould and probes; figures left out are those of the preset `name`, which
    gives the process too.

    In a file, `printer = "profile.toml"` takes this table from another one next to it. Walls,
    features (pins, ribs) and holes below the given sizes fail; bosses too slender
    and walls of too little draft for the process are warned of.
    """

    name: str = "fdm-0.4"
    bed_mm: tuple[Bed, Bed, Bed] = (220.0, 220.0, 240.0)
    wall_mm: Thickness = 0.8
    hole_mm: Thickness = 1.0
    clearance_mm: Gap = 0.1

    @property
    def preset(self) -> Printer:
        """Process of the printer, with aspect, draft and density of what it makes."""
        return PRINTERS.named(self.name)

    @model_validator(mode="before")
    @classmethod
    def _figures_left_out(cls, given: Any) -> Any:
        if not isinstance(given, dict) or not isinstance(given.get("name", ""), str):
            return given
        preset = asdict(PRINTERS.named(given.get("name", "fdm-0.4")))
        return {key: value for key, value in preset.items() if key in cls.model_fields} | given
