"""A jig that centres the object under a machine's tool by its rigid core.

The silicone is too soft to be held by: a hollow post reaches into the core's cavity instead, with
the printer's clearance, and the rim rests on the plate. Grooves along x and y through the object's
axis serve to align the plate, bolts hold it flat (face 1 up) or, on an angle plate, upright (a side
face up; the pattern of holes is square, so that it can be turned by quarter turns). Wires leave
through the post and a channel under the plate.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.layout.body import body_of
from design.layout.mould_frame import play_mm
from design.solids.body import core_hollow
from design.solids.primitives import OVERSHOOT_MM, box_between, single_solid
from design.solids.shell import envelope
from design.spec.object import ObjectSpec

PLATE_MM = 6.0
MARGIN_MM = 16.0
BOLT_HOLE_MM = 5.5
BOLT_INSET_MM = 7.0
POST_IN_CORE_MM = 10.0
POST_WALL_MM = 3.0
WIRE_CHANNEL_MM = (8.0, 3.0)
MARK_MM = (1.0, 0.8)
RECESS_MM = 3.0


def make_jig(spec: ObjectSpec) -> cq.Solid:
    """Plate under the open face with its post, in the object's frame (mm).

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    top, half = _seat_mm(spec), _half_plate_mm(spec)
    plate = box_between((-half, -half, top - PLATE_MM), (half, half, top))
    cutters = [*_bolt_holes(half, top), *_marks(half, top)]
    if _on_post(spec):
        post, passage = _post(spec, top)
        plate, cutters = plate.fuse(post), [*cutters, passage, _channel(half, top)]
    else:
        cutters.append(_recess(spec, top))
    return single_solid(plate.cut(*cutters), "jig")


def _seat_mm(spec: ObjectSpec) -> float:
    """Level of the plate's top: the open face, or above it where the body lies in a recess."""
    low = -spec.body.size_mm[2] / 2
    return low if _on_post(spec) else low + RECESS_MM


def _on_post(spec: ObjectSpec) -> bool:
    return body_of(spec).cuboid and spec.body.opened == (6,) and bool(core_hollow(spec))


def _half_plate_mm(spec: ObjectSpec) -> float:
    return max(spec.body.size_mm[:2]) / 2 + MARGIN_MM


def _post(spec: ObjectSpec, top: float) -> tuple[cq.Solid, cq.Solid]:
    """Post that fills the core's cavity, and the passage through it (both mm)."""
    core = np.asarray(spec.core_size_mm)
    across = core[:2] / 2 - spec.core.wall_mm - play_mm(spec)
    depth = min(POST_IN_CORE_MM, core[2] - spec.core.wall_mm - 1.0)
    reach = -core[2] / 2 + depth
    inside = np.maximum(across - POST_WALL_MM, across / 3)
    bottom = top - PLATE_MM
    post = box_between((*-across, bottom + 1.0), (*across, reach))
    passage = box_between((*-inside, bottom - OVERSHOOT_MM), (*inside, reach + OVERSHOOT_MM))
    return post, passage


def _recess(spec: ObjectSpec, top: float) -> cq.Solid:
    """Room for the lowest few millimetres of a body without a cavity for a post."""
    box, play = envelope(spec).BoundingBox(), play_mm(spec)
    low = (box.xmin - play, box.ymin - play, top - RECESS_MM)
    return box_between(low, (box.xmax + play, box.ymax + play, top + OVERSHOOT_MM))


def _channel(half: float, top: float) -> cq.Solid:
    """Under the plate, from its middle to the edge at −y."""
    width, depth = WIRE_CHANNEL_MM
    bottom = top - PLATE_MM
    low = (-width / 2, -half - OVERSHOOT_MM, bottom - OVERSHOOT_MM)
    return box_between(low, (width / 2, 0.0, bottom + depth))


def _bolt_holes(half: float, top: float) -> list[cq.Solid]:
    at, length = half - BOLT_INSET_MM, PLATE_MM + 2 * OVERSHOOT_MM
    return [
        cq.Solid.makeCylinder(
            BOLT_HOLE_MM / 2, length, cq.Vector(x, y, top + OVERSHOOT_MM), cq.Vector(0, 0, -1)
        )
        for x in (-at, at)
        for y in (-at, at)
    ]


def _marks(half: float, top: float) -> list[cq.Solid]:
    """Grooves in the plate's top along x and y, from its edges to near the body."""
    width, depth = MARK_MM
    inner, outer = half - MARGIN_MM + 2.0, half + OVERSHOOT_MM
    marks = []
    for sign in (-1, 1):
        near, far = sorted((sign * inner, sign * outer))
        marks.append(box_between((near, -width / 2, top - depth), (far, width / 2, top + 1)))
        marks.append(box_between((-width / 2, near, top - depth), (width / 2, far, top + 1)))
    return marks
