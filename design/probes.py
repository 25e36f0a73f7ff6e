"""Calibration probes: hemispherical tips on shafts under a mounting plate."""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.solids import OVERSHOOT_MM, box_between, single_solid
from design.spec import ObjectSpec
from design.tips import tip_positions_mm

SHAFT_LENGTH_MM = 10.0
PLATE_MM = 4.0
PLATE_MARGIN_MM = 5.0


def make_probe(spec: ObjectSpec, tips: int) -> cq.Solid:
    """Probe with 1, 2 or 3 tips of the indenter's radius, mm.

    The tips point to −z and their lowest points lie at z = 0, so that a probe placed in a face's
    frame touches that face.

    Raises
    ------
    InputError
        No such probe, or the dimensions do not give one valid solid.
    """
    radius = spec.indenter.radius_mm
    centres = tip_positions_mm(tips, radius)
    plate_z = radius + SHAFT_LENGTH_MM
    reach = np.abs(centres).max(axis=0) + radius + PLATE_MARGIN_MM
    plate = box_between((-reach[0], -reach[1], plate_z), (reach[0], reach[1], plate_z + PLATE_MM))
    pieces = [piece for x, y in centres for piece in _tip(float(x), float(y), radius)]
    return single_solid(plate.fuse(*pieces), f"probe_{tips}")


def _tip(x: float, y: float, radius: float) -> tuple[cq.Shape, cq.Shape]:
    """Hemisphere below z = radius and the shaft above it, reaching into the plate."""
    equator, up = cq.Vector(x, y, radius), cq.Vector(0, 0, 1)
    hemisphere = cq.Solid.makeSphere(radius, equator, up, -90, 0, 360)
    shaft = cq.Solid.makeCylinder(radius, SHAFT_LENGTH_MM + OVERSHOOT_MM, equator, up)
    return hemisphere, shaft
