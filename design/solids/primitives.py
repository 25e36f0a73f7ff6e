"""Small helpers over CadQuery: primitives placed in face coordinates, and the one-solid check."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from OCP.ShapeAnalysis import (
    ShapeAnalysis_ShapeTolerance,  # pyright: ignore[reportAttributeAccessIssue]
)
from OCP.Standard import Standard_Failure  # pyright: ignore[reportAttributeAccessIssue]

from design.body.meshes import CRUMB_MM3
from design.body.surface_chart import FaceFrame
from design.body.triangles import Block
from design.errors import NotOneSolid
from design.layout.pockets import Pocket
from design.solids.kernel import cq

OVERSHOOT_MM = 0.5
"""Cutters and bosses pass the surface they cross by this much: coplanar faces are never cut."""
_LOOSE_MM = 1e-3
"""Least tolerance of a shape's vertices and edges."""


def box_between(
    low_mm: Sequence[float] | np.ndarray, high_mm: Sequence[float] | np.ndarray
) -> cq.Solid:
    """Axis-aligned box from its lowest to its highest corner, mm."""
    low, high = np.asarray(low_mm, float), np.asarray(high_mm, float)
    length, width, height = (float(edge) for edge in high - low)
    return cq.Solid.makeBox(length, width, height, cq.Vector(*low))


def block_solid(block: Block) -> cq.Solid:
    """A block as a solid in the object's frame."""
    x, normal = (cq.Vector(*block.axes[:, k]) for k in (0, 2))
    plane = cq.Plane(cq.Vector(*block.centre_mm), x, normal)
    return box_between(-block.half_mm, block.half_mm).moved(cq.Location(plane))


def tapered_rod(
    start: cq.Vector, axis: cq.Vector, radius_mm: float, end_radius_mm: float | None = None
) -> cq.Solid:
    """Solid as long as its axis: a cylinder, or a cone where the radius at the end is another, mm."""
    if end_radius_mm is None or end_radius_mm == radius_mm:
        return cq.Solid.makeCylinder(radius_mm, axis.Length, start, axis)
    return cq.Solid.makeCone(radius_mm, end_radius_mm, axis.Length, start, axis)


def rod_about_z(radius_mm: float, low_mm: float, high_mm: float) -> cq.Solid:
    """Cylinder on the z axis, between two levels."""
    return tapered_rod(cq.Vector(0, 0, low_mm), cq.Vector(0, 0, high_mm - low_mm), radius_mm)


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


def pocket_solid(frame: FaceFrame, pocket: Pocket) -> cq.Solid:
    """The pocket's prism on a face; a tilted one is cut off just above the face and below itself."""
    return pocket_prism(frame, pocket, None, OVERSHOOT_MM)


def pocket_prism(
    frame: FaceFrame,
    pocket: Pocket,
    bottom_mm: float | None,
    top_mm: float,
    grow_mm: float = 0.0,
) -> cq.Solid:
    """The pocket's prism, its outline grown on all sides, between two heights above the face.

    Without a bottom it begins at the pocket's floor; elsewhere planes parallel to the face end it.
    """
    floor, axis = pocket.axis_ends_mm[0], pocket.axis
    if axis[2] == 1:
        low = floor[2] if bottom_mm is None else bottom_mm
        start, end = (frame.to_object(np.array([*floor[:2], z])) for z in (low, top_mm))
        return _prism(pocket, frame, start, cq.Vector(*(end - start)), grow_mm)
    past = (pocket.outline.radius_mm + grow_mm) + OVERSHOOT_MM
    start = floor
    if bottom_mm is not None:
        start = floor + ((bottom_mm - floor[2]) / axis[2] - past) * axis
    end = floor + ((top_mm - floor[2]) / axis[2] + past) * axis
    origin, tip = frame.to_object(start), frame.to_object(end)
    prism = _prism(pocket, frame, origin, cq.Vector(*(tip - origin)), grow_mm)
    low = pocket.lowest_mm - OVERSHOOT_MM if bottom_mm is None else bottom_mm
    reach = 3 * np.append(frame.half_extents_mm, 0)
    corners = np.stack(
        [
            frame.to_object(np.array([0, 0, low]) - reach),
            frame.to_object(np.array([0, 0, top_mm]) + reach),
        ]
    )
    (piece,) = prism.intersect(box_between(corners.min(axis=0), corners.max(axis=0))).Solids()
    return piece


def _prism(
    pocket: Pocket,
    frame: FaceFrame,
    start: np.ndarray,
    axis: cq.Vector,
    grow_mm: float = 0.0,
) -> cq.Solid:
    half = [edge + grow_mm for edge in pocket.outline.half_mm]
    if pocket.outline.round:
        return tapered_rod(cq.Vector(*start), axis, half[0])
    side = frame.axes @ pocket.body.frame[:, 0]
    placed = cq.Location(cq.Plane(cq.Vector(*start), cq.Vector(*side), axis))
    return box_between((-half[0], -half[1], 0.0), (half[0], half[1], axis.Length)).moved(placed)


def single_solid(shape: cq.Shape, part: str) -> cq.Solid:
    """The one valid solid that `shape` is made of, with split faces merged where that leaves it valid
    and its edges where they were.

    Crumbs next to it are left out. The kernel's merging may fail or spoil a sound solid, such as one in
    which many passages meet.

    Raises
    ------
    NotOneSolid
        An InputError: the dimensions leave several pieces, or a body that is not valid.
    """
    merged = merged_faces(shape)
    valid = merged.isValid()  # takes as long as an operation
    if not (valid and _loose_mm(merged) <= _tight_mm(shape)) and shape.isValid():
        merged, valid = shape, True
    solids = merged.Solids()
    if len(solids) > 1:
        solids = [solid for solid in solids if solid.Volume() >= CRUMB_MM3] or solids
    if len(solids) != 1 or not (valid or solids[0].isValid()):
        state = "valid" if valid else "invalid"
        raise NotOneSolid(
            f"{part} must be one valid solid; these dimensions give {len(solids)} ({state}). "
            "Move its recesses, holes or pockets apart, or make them smaller",
            merged,
        )
    return solids[0]


def _loose_mm(shape: cq.Shape) -> float:
    """Distance by which the worst edge may leave the faces that it lies on."""
    return ShapeAnalysis_ShapeTolerance().Tolerance(shape.wrapped, 1)


def _tight_mm(shape: cq.Shape) -> float:
    """Return what merging may leave: a hole through a ball's seam got an edge 6.2 mm off the ball, whose
    triangles then closed half of the hole."""
    return max(_LOOSE_MM, _loose_mm(shape))


def merged_faces(shape: cq.Shape) -> cq.Shape:
    """With split faces merged, where the kernel can; of a copy, as it changes what it is given."""
    try:
        return shape.copy().clean()
    except Standard_Failure:  # "Courbes non jointives": a half of a mould with 15 heads of pins
        return shape
