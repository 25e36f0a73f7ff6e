"""Small helpers over CadQuery: primitives placed in face coordinates, and the one-solid check."""

from __future__ import annotations

from collections.abc import Sequence

import cadquery as cq
import numpy as np

from design.errors import InputError
from design.layouts import FaceFrame

OVERSHOOT_MM = 0.5
"""Cutters and bosses pass the surface they cross by this much: coplanar faces are never cut."""


def box_between(
    low_mm: Sequence[float] | np.ndarray, high_mm: Sequence[float] | np.ndarray
) -> cq.Solid:
    """Axis-aligned box from its lowest to its highest corner, mm."""
    low, high = np.asarray(low_mm, float), np.asarray(high_mm, float)
    length, width, height = (float(edge) for edge in high - low)
    return cq.Solid.makeBox(length, width, height, cq.Vector(*low))


def cylinder_on_face(
    frame: FaceFrame,
    xy_mm: tuple[float, float],
    radius_mm: float,
    bottom_mm: float,
    top_mm: float,
) -> cq.Solid:
    """Cylinder along the face's normal at (x, y); bottom and top are heights above the face, mm."""
    start = frame.to_object(np.array([*xy_mm, bottom_mm]))
    return cq.Solid.makeCylinder(
        radius_mm, top_mm - bottom_mm, cq.Vector(*start), cq.Vector(*frame.normal)
    )


def radial_box_on_face(
    frame: FaceFrame,
    azimuth_deg: float,
    width_mm: float,
    radii_mm: tuple[float, float],
    heights_mm: tuple[float, float],
) -> cq.Solid:
    """Box that is `width_mm` wide tangentially and spans two radii and two heights above the face.

    The azimuth runs from the face's x counter-clockwise, seen from outside.
    """
    (inner, outer), (bottom, top) = radii_mm, heights_mm
    local = box_between((inner, -width_mm / 2, bottom), (outer, width_mm / 2, top))
    turned = local.rotate(cq.Vector(0, 0, 0), cq.Vector(0, 0, 1), azimuth_deg)
    plane = cq.Plane(cq.Vector(*frame.centre_mm), cq.Vector(*frame.x), cq.Vector(*frame.normal))
    return turned.moved(cq.Location(plane))


def single_solid(shape: cq.Shape, part: str) -> cq.Solid:
    """The one valid solid that `shape` is made of, with split faces merged.

    Raises
    ------
    InputError
        The dimensions of the specification leave several pieces, or a body that is not valid.
    """
    merged = shape.clean()
    solids = merged.Solids()
    if len(solids) != 1 or not merged.isValid():
        state = "valid" if merged.isValid() else "invalid"
        raise InputError(
            f"{part} must be one valid solid; these dimensions give {len(solids)} ({state}). "
            "Move its recesses, holes or pockets apart, or make them smaller"
        )
    return solids[0]
