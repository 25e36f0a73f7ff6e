"""Calibration probes: tips of the indenter's kind on shafts under a mounting plate."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, tip_stays
from design.layout.tips import footprint_mm, path_mm, tip_places_mm, tip_shape
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, single_solid
from design.spec.mechanics import IndenterSpec
from design.spec.object import ObjectSpec

TIP_COUNTS = (1, 2, 3)
"""Numbers of tips of the probes that are made."""
SHAFT_LENGTH_MM = 10.0
"""Length of the shaft between a tip and the plate."""
PLATE_MM = 4.0
"""Thickness of the plate that tips hang from."""
PLATE_MARGIN_MM = 5.0
"""Plate beyond the outermost tip."""
_ABOVE_FILLET_MM = 4.0
"""Height of a flat tip above its fillet."""
_SHAFT_SHARE = 0.6
"""Diameter of the shaft over the tip's smaller width."""
_ORIGIN = cq.Vector(0, 0, 0)


def make_probe(spec: ObjectSpec, tips: int) -> cq.Solid:
    """Probe with 1, 2 or 3 tips of the indenter's kind and size, mm.

    The tips point to −z and their lowest points lie at z = 0, so that a probe placed in a face's
    frame touches that face.

    Raises
    ------
    InputError
        No such probe, or the dimensions do not give one valid solid.
    """
    indenter = spec.indenter.changed(tip_count=tips)
    tip = _hemisphere(indenter) if indenter.kind == "hemisphere" else _body(indenter)
    plate_z = _top_of_tip_mm(indenter, tip) + SHAFT_LENGTH_MM
    shaft = _shaft(indenter, tip, plate_z)
    reach = abs(footprint_mm(indenter)).max(axis=0) + PLATE_MARGIN_MM
    plate = box_between((-reach[0], -reach[1], plate_z), (reach[0], reach[1], plate_z + PLATE_MM))
    places = [cq.Vector(float(x), float(y), 0) for x, y in tip_places_mm(indenter)]
    pieces = [piece.translate(place) for place in places for piece in (tip, shaft)]
    return single_solid(plate.fuse(*pieces), f"probe_{tips}")


def lowest_presses(
    spec: ObjectSpec, tips: int, probe_mm: Float[np.ndarray, "point 3"]
) -> list[FaceFrame]:
    """Return the frame of a probe where it comes down furthest, in a deepest press, on each face.

    `probe_mm` are points of the probe. Where it has other tips than the specification's, only contact
    locations count at which all its tips stay on the face; a face without one is left out.
    """
    grid, presses = contact_grid(spec).xy_mm, list[FaceFrame]()
    depths, indenter = spec.press.depths_mm, spec.indenter.changed(tip_count=tips)
    path = np.append(path_mm(indenter, depths)[-1], -depths[-1])
    probed = spec.changed(indenter=indenter)
    for frame, has_place in zip(face_frames(spec), contact_places(spec), strict=True):
        places = grid[has_place]
        if tips != spec.indenter.tip_count:
            places = places[tip_stays(probed, frame, places)]
        if len(places):
            xy = frame.to_plane(places)
            axes = frame.axes_at(xy)
            tip = frame.to_object(np.column_stack([xy, np.zeros(len(xy))])) + axes @ path
            # z of every point of the probe (p) in every press (n): the third row of its axes (i)
            heights = tip[:, 2:] + np.einsum("ni,pi->np", axes[:, 2], probe_mm)
            least = int(heights.min(axis=1).argmin())
            presses.append(replace(frame.tangent(xy[least]), centre_mm=tip[least]))
    return presses


def _top_of_tip_mm(indenter: IndenterSpec, tip: cq.Shape) -> float:
    return indenter.radius_mm if indenter.kind == "hemisphere" else tip.BoundingBox().zmax


def _shaft(indenter: IndenterSpec, tip: cq.Shape, plate_z: float) -> cq.Solid:
    """A hemisphere's goes on with its own radius; others stand on the body's centre of mass."""
    if indenter.kind == "hemisphere":
        start, radius = cq.Vector(0, 0, indenter.radius_mm), indenter.radius_mm
    else:
        start, box = tip.Center(), tip.BoundingBox()
        radius = _SHAFT_SHARE * min(box.xlen, box.ylen) / 2
    length = plate_z + OVERSHOOT_MM - start.z
    return cq.Solid.makeCylinder(radius, length, start, cq.Vector(0, 0, 1))


def _hemisphere(indenter: IndenterSpec) -> cq.Shape:
    equator = cq.Vector(0, 0, indenter.radius_mm)
    return cq.Solid.makeSphere(indenter.radius_mm, equator, cq.Vector(0, 0, 1), -90, 0, 360)


def _body(indenter: IndenterSpec) -> cq.Shape:
    """The tip turned by yaw and tilt, its lowest point (or the middle of what is lowest) at 0."""
    solid: cq.Shape = _SOLIDS[indenter.kind](indenter)
    turns = zip(np.eye(3)[[2, 0, 1]], indenter.turn_deg, strict=True)
    for axis, angle in turns:
        solid = solid.rotate(_ORIGIN, cq.Vector(*axis), angle)
    if indenter.kind == "ellipsoid":  # its bounding box is that of the splines' corners
        matrix = tip_shape(indenter).ellipsoid
        assert matrix is not None
        inverse = np.linalg.inv(matrix)
        return solid.translate(cq.Vector(*(inverse[:, 2] / np.sqrt(inverse[2, 2])).tolist()))
    box, low = solid.BoundingBox(), footprint_mm(indenter.changed(tip_count=1))
    return solid.translate(cq.Vector(low[0, 0] - box.xmin, low[0, 1] - box.ymin, -box.zmin))


def _flat(indenter: IndenterSpec) -> cq.Solid:
    disk = cq.Solid.makeCylinder(indenter.radius_mm, indenter.fillet_mm + _ABOVE_FILLET_MM)
    if not indenter.fillet_mm:
        return disk
    return disk.fillet(indenter.fillet_mm, disk.faces("<Z").Edges())


def _cuboid(indenter: IndenterSpec) -> cq.Solid:
    half = np.asarray(indenter.size_mm) / 2
    box = box_between([*-half, 0.0], [*half, indenter.fillet_mm + _ABOVE_FILLET_MM])
    if not indenter.fillet_mm:
        return box
    sides = box.edges("|Z").Edges() + box.faces("<Z").Edges()
    return box.fillet(indenter.fillet_mm, sides)


def cylinder_tip(indenter: IndenterSpec) -> cq.Solid:
    start = cq.Vector(-indenter.size_mm[0] / 2, 0, 0)
    return cq.Solid.makeCylinder(indenter.radius_mm, indenter.size_mm[0], start, cq.Vector(1, 0, 0))


def _ellipsoid(indenter: IndenterSpec) -> cq.Shape:
    ball, half = (
        cq.Solid.makeSphere(1.0, angleDegrees1=-90, angleDegrees2=90),
        np.asarray(indenter.size_mm) / 2,
    )
    stretch = cq.Matrix([[half[0], 0, 0, 0], [0, half[1], 0, 0], [0, 0, indenter.radius_mm, 0]])
    return ball.transformGeometry(stretch)


def _polyhedron(indenter: IndenterSpec) -> cq.Solid:
    from scipy.spatial import ConvexHull

    corners = np.asarray(indenter.vertices_mm, float)
    hull = ConvexHull(corners)
    faces = []
    for simplex in hull.simplices:
        loop = [cq.Vector(*corner) for corner in corners[simplex]]
        faces.append(cq.Face.makeFromWires(cq.Wire.makePolygon(loop, close=True)))
    return cq.Solid.makeSolid(cq.Shell.makeShell(faces)).fix()


_SOLIDS = {
    "flat": _flat,
    "cuboid": _cuboid,
    "cylinder": cylinder_tip,
    "ellipsoid": _ellipsoid,
    "stl": _polyhedron,
}
