"""The hardware in a specification: body, shell, core.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from typing import Literal

from design.spec_types import Positive, SpecPart


class BodySpec(SpecPart):
    """Outer shape of the silicone shell."""

    kind: Literal["box"] = "box"
    size_mm: tuple[Positive, Positive, Positive] = (42.0, 42.0, 42.0)


class ShellSpec(SpecPart):
    """Silicone walls and the moulded pockets that take the magnets.

    Round bodies lie in pockets of `pocket_diameter_mm`; blocks and sensor boards in pockets of
    their own outline.
    """

    thickness_mm: Positive = 8.0
    pocket_diameter_mm: Positive = 6.0
    pocket_depth_mm: Positive = 3.0


class CoreSpec(SpecPart):
    """Rigid printed core that fills the shell's cavity down to the core's own height."""

    wall_mm: Positive = 4.5
    recess_width_mm: Positive = 7.0
    recess_inner_radius_mm: Positive = 4.5
    recess_outer_radius_mm: Positive = 11.0
    recess_depth_mm: Positive = 3.0
    hub_radius_mm: Positive = 2.0
    hub_depth_mm: Positive = 0.5
    wire_hole_top_diameter_mm: Positive = 2.0
    wire_hole_side_diameter_mm: Positive = 4.0
