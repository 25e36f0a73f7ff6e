"""A template that is laid on a face to set its magnets, with the polarity of each engraved.

A plate of the face's size with a hole over every pocket and a lip over two edges that finds the
face. Beside each hole stands + where the magnet's north pole points outward, − where it points
inward; the corner at the face's +x, +y is cut off.
"""

from __future__ import annotations

import numpy as np

from design.layout.pockets import Pocket
from design.layout.template_marks import (
    CORNER_MM,
    bars,
    hole_centre_mm,
    mark_places,
    pockets_by_face,
)
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, single_solid
from design.spec.object import ObjectSpec

PLATE_MM = 3.0
"""Thickness of the template's plate."""
LIP_MM = (2.0, 3.0)
"""Width of the lip over the shell's edges, and how far it reaches down."""
MARK_DEPTH_MM = 0.8
"""Depth of the marks in the plate."""


def template_faces(spec: ObjectSpec) -> dict[int, tuple[int, ...]]:
    """First face → the faces of its size and layout, which one template serves."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for frame, pockets in pockets_by_face(spec):
        alike = [frame.half_extents_mm, *(pocket.body.centre_mm for pocket in pockets)]
        groups.setdefault(tuple(np.concatenate(alike).round(6)), []).append(frame.number)
    return {numbers[0]: tuple(numbers) for numbers in groups.values()}


def make_magnet_template(spec: ObjectSpec, face: int) -> cq.Solid:
    """Template of one face in that face's frame: its underside lies on the face (z = 0), mm.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    frame, pockets = next(pair for pair in pockets_by_face(spec) if pair[0].number == face)
    half = frame.half_extents_mm
    lip, drop, play = *LIP_MM, spec.printer.clearance_mm
    body = box_between((-half[0] - play - lip, -half[1] - play - lip, 0.0), (*half, PLATE_MM))
    lips = [
        box_between((-half[0] - play - lip, -half[1] - play - lip, -drop), (-half[0] - play, *_end(half))),
        box_between((-half[0] - play - lip, -half[1] - play - lip, -drop), (half[0], -half[1] - play, 1.0)),
    ]  # fmt: skip
    holes = [hole_solid(pocket, play) for pocket in pockets]
    places = mark_places(spec, pockets, half)
    marks = [
        bar
        for place, polarity in zip(places, spec.magnets.polarities, strict=True)
        for bar in _mark(place, polarity)
    ]
    return single_solid(body.fuse(*lips).cut(*holes, *marks, corner_cut(half)), "magnet_template")


def _end(half: tuple[float, float]) -> tuple[float, float]:
    return half[1], 1.0


def hole_solid(pocket: Pocket, play: float) -> cq.Solid:
    x, y = hole_centre_mm(pocket)
    half = [edge + play for edge in pocket.outline.half_mm]
    height = PLATE_MM + 2 * OVERSHOOT_MM
    if pocket.outline.round:
        base = cq.Vector(x, y, -OVERSHOOT_MM)
        return cq.Solid.makeCylinder(half[0], height, base, cq.Vector(0, 0, 1))
    low = (x - half[0], y - half[1], -OVERSHOOT_MM)
    return box_between(low, (x + half[0], y + half[1], height - OVERSHOOT_MM))


def _mark(place: np.ndarray, polarity: int) -> list[cq.Solid]:
    """Bars of + or −, cut into the top of the plate."""
    x, y = place
    low, high = PLATE_MM - MARK_DEPTH_MM, PLATE_MM + OVERSHOOT_MM
    return [box_between((x - a, y - b, low), (x + a, y + b, high)) for a, b in bars(polarity)]


def corner_cut(half: tuple[float, float]) -> cq.Solid:
    """Triangle at +x, +y."""
    x, y = half[0] + OVERSHOOT_MM, half[1] + OVERSHOOT_MM
    reach = CORNER_MM + 2 * OVERSHOOT_MM
    loop = [cq.Vector(*p, -10.0) for p in ((x, y), (x - reach, y), (x, y - reach))]
    wire = cq.Wire.makePolygon(loop, close=True)
    return cq.Solid.extrudeLinear(wire, [], cq.Vector(0, 0, 20.0))
