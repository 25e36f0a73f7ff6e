"""The hardware in a specification: shell, core.

Defaults are the paper's cube (Knopke et al., RA-L 2024); docs/units.md gives the source of each.
"""

from __future__ import annotations

from design.spec.base import Count, Finite, NonNegative, Positive, SpecPart


class SlitsSpec(SpecPart):
    """Relief slits along the edges between sensed faces, against pressure on the neighbours.

    Each runs from the edge `depth_mm` inwards along the bisector of the two faces, `width_mm` wide,
    and ends `end_mm` before the corners of the body; a depth of 0 leaves them out.
    """

    width_mm: Positive = 1.0
    depth_mm: NonNegative = 0.0
    end_mm: NonNegative = 8.0


class ShellSpec(SpecPart):
    """Silicone walls and the moulded pockets that take the magnets.

    Round bodies lie in pockets of `pocket_diameter_mm`; blocks and sensor boards in pockets of
    their own outline. With a `seal_layer_mm` the shell is cast thinner by that much on every sensed
    face and gets its size in a second pour, which covers the pockets with a layer in one piece.
    """

    thickness_mm: Positive = 8.0
    pocket_diameter_mm: Positive = 6.0
    pocket_depth_mm: Positive = 3.0
    seal_layer_mm: NonNegative = 0.0
    slits: SlitsSpec = SlitsSpec()


class KeysSpec(SpecPart):
    """Blocks on every sensed face of the core that lock the shell against slipping.

    Each stands at a place of `positions_mm` (x, y in the face's frame), `size_mm` along the face's
    x and y, `height_mm` into the silicone. Without places there are none.
    """

    positions_mm: tuple[tuple[Finite, Finite], ...] = ()
    size_mm: tuple[Positive, Positive] = (3.0, 3.0)
    height_mm: Positive = 1.5


class CoreSpec(SpecPart):
    """Rigid printed core that fills the shell's cavity down to the core's own height.

    A `wire_channel_width_mm` above 0 cuts channels of that width and `wire_channel_depth_mm` from
    each sensor's recess to the wire hole. `bay_mm` widens or deepens the cavity by a box of that
    size (x, y, depth from the open face) for a board and a battery. The wires only enter the checks.
    """

    wall_mm: Positive = 4.5
    recess_width_mm: Positive = 7.0
    recess_inner_radius_mm: Positive = 4.5
    recess_outer_radius_mm: Positive = 11.0
    recess_depth_mm: Positive = 3.0
    hub_radius_mm: Positive = 2.0
    hub_depth_mm: Positive = 0.5
    wire_hole_top_diameter_mm: Positive = 2.0
    wire_hole_side_diameter_mm: Positive = 4.0
    wire_channel_width_mm: NonNegative = 0.0
    wire_channel_depth_mm: Positive = 1.0
    wire_diameter_mm: Positive = 0.4
    wires_per_sensor: Count = 4
    bay_mm: tuple[Positive, Positive, Positive] | None = None
    keys: KeysSpec = KeysSpec()
