"""A jig that centres the object under a machine's tool by its rigid core.

The silicone is too soft to be held by: a hollow post reaches into the core's cavity instead, with
the printer's clearance, and the rim rests on the plate. Where the body has a bore, the post goes through
it into the core's outlet, flat on flat, and the silicone stays clear of the plate; wires are laid into the
post's slot. A closed body can only lie in a recess or a cup of its own shape. Grooves along x and y
through the object's axis serve to align the plate, bolts hold it flat (face 1 up) or, on an angle plate,
upright (a side face up; the pattern of holes is square, so that it can be turned by quarter turns). A
pedestal lifts what stands on a post above the plate, so that the plates of probes clear it. Wires leave
through post and pedestal and a channel under the plate.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from design.layout.body import body_of
from design.layout.core_hold import core_outlet
from design.solids.body import core_hollow, outer_solid
from design.solids.booleans import Shape, Solid, convert_to_triangles, cut, one_body
from design.solids.kernel import cq
from design.solids.primitives import OVERSHOOT_MM, box_between, rod_about_z
from design.solids.probes import TIP_COUNTS, lowest_presses, make_probe
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

PLATE_MM = 6.0
MARGIN_MM = 16.0
BOLT_HOLE_MM = 5.5
BOLT_INSET_MM = 7.0
POST_IN_CORE_MM = 10.0
POST_WALL_MM = 3.0
WIRE_CHANNEL_MM = (8.0, 3.0)
MARK_MM = (1.0, 0.8)
RECESS_MM = 3.0
CLEAR_MM = 1.0
"""Clearance of the silicone round a bore above the plate: the core alone carries the object."""
PEDESTAL_WALL_MM = 4.0
"""Wall of a pedestal round a bore's post: as stiff as the core's own walls."""
CUP_SHARE = 0.2
"""Share of the body's height that lies in a cup."""
_UP = np.array([0.0, 0.0, 1.0])
_SEAT_LINES, _SEAT_STEP_MM = 25, 0.02
"""Lines of places over a post, and step of levels: its seat is below the core by up to the step."""
SLOT_SHARES = (0.9, 0.1)
"""Shares of a post's radius: width of its slot, and how far it goes beyond the middle."""


def make_jig(spec: ObjectSpec) -> Solid:
    """Plate under the open face with its post, in the object's frame (mm); triangles where it has a cup.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    seat, half, body = _seat_mm(spec), _half_plate_mm(spec), body_of(spec)
    if not (body.opening == "bore" or _stands_on_post(spec)):
        bottom = seat - PLATE_MM - (_cup_mm(spec) if _stands_in_cup(spec) else 0.0)
        room = cup_solid(spec, seat) if _stands_in_cup(spec) else recess_solid(spec, seat)
        plate = box_between((-half, -half, bottom), (half, half, seat))
        return one_body(cut(plate, *_plate_cuts(half, seat, seat - bottom), room), "jig")
    top = seat - pedestal_mm(spec)
    plate = box_between((-half, -half, top - PLATE_MM), (half, half, top))
    post, passage = _post_in_bore(spec, top) if body.opening == "bore" else core_post(spec, top)
    carried = plate.fuse(post) if top == seat else plate.fuse(_pedestal(spec, top, seat), post)
    cutters = *_plate_cuts(half, top, PLATE_MM), passage, channel_solid(half, top)
    return one_body(cut(carried, *cutters), "jig")


def _plate_cuts(half: float, top: float, thick: float) -> list[Shape]:
    return [*bolt_holes(half, top, thick), *axis_marks(half, top)]


def pedestal_mm(spec: ObjectSpec) -> float:
    """Height by which the object must stand above the plate to be pressed, however low on its sides.

    A probe's plate reaches below the location that its tips press, on round bodies far below the body.
    """
    low = float("inf")
    for tips in TIP_COUNTS:
        points = np.asarray(convert_to_triangles(make_probe(spec, tips)).vertices)
        for frame in lowest_presses(spec, tips, points):
            low = min(low, float(frame.to_object(points)[:, 2].min()))
    return max(_seat_mm(spec) - low + CLEAR_MM, 0.0)


def _pedestal(spec: ObjectSpec, top: float, seat: float) -> cq.Shape:
    """Between plate and seat: under a body with an open side, or round a bore's post.

    It stands back so far that a tip pressed into a side, half of it below the rim, does not meet it.
    """
    body, half = body_of(spec), np.asarray(spec.body.size_mm[:2]) / 2
    half = half - spec.press.depths_mm[-1] - CLEAR_MM
    if body.cuboid:
        return box_between((*-half, top - 1.0), (*half, seat))
    radius = half[0] if body.opens_sides else spec.body.bore_mm / 2 + PEDESTAL_WALL_MM
    return rod_about_z(float(radius), top - 1.0, seat)


def _seat_mm(spec: ObjectSpec) -> float:
    """Level of the plate's top: the open face, below a bore's rim, or above where the body lies in it."""
    low = -spec.body.size_mm[2] / 2
    if body_of(spec).opening == "bore":
        return low - CLEAR_MM
    if _stands_in_cup(spec):
        return low + _cup_mm(spec)
    return low if _stands_on_post(spec) else low + RECESS_MM


def _stands_on_post(spec: ObjectSpec) -> bool:
    body = body_of(spec)
    return body.opens_sides and spec.body.opened == (6,) and bool(core_hollow(spec))


def _stands_in_cup(spec: ObjectSpec) -> bool:
    """Return whether the body's lower end is round: a closed one, that has no flat end to stand on."""
    body = body_of(spec)
    return body.opening == "closed" and not (body.on_base or body.opens_sides)


def _cup_mm(spec: ObjectSpec) -> float:
    return CUP_SHARE * spec.body.size_mm[2]


def _half_plate_mm(spec: ObjectSpec) -> float:
    return max(spec.body.size_mm[:2]) / 2 + MARGIN_MM


def core_post(spec: ObjectSpec, top: float) -> tuple[cq.Solid, cq.Solid]:
    """Post from the plate's top that fills the core's cavity, and the passage through it (both mm)."""
    core = np.asarray(spec.core_size_mm)
    across = core[:2] / 2 - spec.core.wall_mm - spec.printer.clearance_mm
    depth = min(POST_IN_CORE_MM, core[2] - spec.core.wall_mm - 1.0)
    reach = -core[2] / 2 + depth
    inside = np.maximum(across - POST_WALL_MM, across / 3)
    ends, through = (
        (top - PLATE_MM + 1.0, reach),
        (top - PLATE_MM - OVERSHOOT_MM, reach + OVERSHOOT_MM),
    )
    if not body_of(spec).cuboid:
        return rod_about_z(float(across[0]), *ends), rod_about_z(float(inside[0]), *through)
    return (
        box_between((*-across, ends[0]), (*across, ends[1])),
        box_between((*-inside, through[0]), (*inside, through[1])),
    )


def _post_in_bore(spec: ObjectSpec, top: float) -> tuple[cq.Shape, cq.Solid]:
    """Post that carries the core on its outlet's flat, and the slot through it (both mm)."""
    outlet, play = core_outlet(spec), spec.printer.clearance_mm
    seat = flat_seat_mm(spec)
    rod = rod_about_z(spec.body.bore_mm / 2 - play, top - 1.0, seat)
    radius, past = outlet.radius_mm - play, 2 * spec.body.bore_mm
    nose = rod_about_z(radius, seat - 1.0, outlet.nose_mm)
    beyond = (outlet.flat_mm - play, -past, seat), (past, past, outlet.nose_mm + 1.0)
    wide, inward = SLOT_SHARES[0] * radius, SLOT_SHARES[1] * radius
    # open to the side as far as the pedestal reaches, so that wires are laid in and not threaded
    beside = -spec.body.bore_mm / 2 - PEDESTAL_WALL_MM - OVERSHOOT_MM
    low = (min(beside, -spec.body.bore_mm), -wide / 2, top - PLATE_MM - OVERSHOOT_MM)
    slot = box_between(low, (inward, wide / 2, outlet.nose_mm + OVERSHOOT_MM))
    return rod.fuse(nose).cut(box_between(*beyond)), slot


def flat_seat_mm(spec: ObjectSpec) -> float:
    """Level below all of the core that stands over the post, next to its outlet: on a body that leans or is
    lopsided the core is lowest anywhere there, not at the flat's middle."""
    outlet, body = core_outlet(spec), body_of(spec)
    radius = spec.body.bore_mm / 2 - spec.printer.clearance_mm
    side = np.linspace(-radius, radius, _SEAT_LINES)
    x, y = (part.ravel() for part in np.meshgrid(side, side))
    away = np.hypot(x, y)
    in_outlet = (away < outlet.radius_mm) & (x < outlet.flat_mm)
    over = np.column_stack([x, y])[(away <= radius + 1e-9) & ~in_outlet]
    flat, rim = min(outlet.flat_mm, radius), np.pi * np.linspace(-1, 1, 4 * _SEAT_LINES + 1)
    ends = np.sqrt(max(radius**2 - flat**2, 0.0)) * np.linspace(-1, 1, _SEAT_LINES)
    rims = [np.column_stack([np.full(_SEAT_LINES, flat), ends])]  # all that may be lowest
    for reach in {radius, min(outlet.radius_mm, radius)}:
        circle = reach * np.column_stack([np.cos(rim), np.sin(rim)])
        rims.append(circle[(circle[:, 0] >= flat) | (reach >= outlet.radius_mm)])
    over = np.vstack([over, *rims])
    levels = np.arange(-body.half_mm[2], 0.8 * outlet.floor_mm, _SEAT_STEP_MM)
    points = np.column_stack([np.tile(over, (len(levels), 1)), levels.repeat(len(over))])
    inside = (body.core_distance_mm(points) <= 0).reshape(len(levels), -1).any(axis=1)
    return float(levels[max(int(np.argmax(inside)) - 1, 0)])


def recess_solid(spec: ObjectSpec, top: float) -> cq.Solid:
    """Room for the lowest few millimetres of a body without a cavity for a post."""
    play, body = spec.printer.clearance_mm, body_of(spec)
    if body.round_below:
        return rod_about_z(body.radius_mm + play, top - RECESS_MM, top + OVERSHOOT_MM)
    box = outer_solid(spec).BoundingBox()
    low = (box.xmin - play, box.ymin - play, top - RECESS_MM)
    return box_between(low, (box.xmax + play, box.ymax + play, top + OVERSHOOT_MM))


def cup_solid(spec: ObjectSpec, top: float) -> trimesh.Trimesh:
    """Room for the lower end of a round body, with play, open upwards whatever its shape."""
    import trimesh

    body = body_of(spec)
    points = np.asarray(body.outer_surface().vertices) * (
        1 + spec.printer.clearance_mm / body.half_mm
    )
    below = points[points[:, 2] < top + RECESS_MM]
    return trimesh.convex.convex_hull(np.vstack([below, below + 2 * _cup_mm(spec) * _UP]))


def channel_solid(half: float, top: float) -> cq.Solid:
    """Under the plate, from its middle to the edge at −y."""
    width, depth = WIRE_CHANNEL_MM
    bottom = top - PLATE_MM
    low = (-width / 2, -half - OVERSHOOT_MM, bottom - OVERSHOOT_MM)
    return box_between(low, (width / 2, 0.0, bottom + depth))


def bolt_holes(half: float, top: float, thick: float) -> list[cq.Solid]:
    bolt_mm, length = half - BOLT_INSET_MM, thick + 2 * OVERSHOOT_MM
    return [
        cq.Solid.makeCylinder(
            BOLT_HOLE_MM / 2, length, cq.Vector(x, y, top + OVERSHOOT_MM), cq.Vector(0, 0, -1)
        )
        for x in (-bolt_mm, bolt_mm)
        for y in (-bolt_mm, bolt_mm)
    ]


def axis_marks(half: float, top: float) -> list[cq.Solid]:
    """Grooves in the plate's top along x and y, from its edges to near the body."""
    width, depth = MARK_MM
    inner, outer = half - MARGIN_MM + 2.0, half + OVERSHOOT_MM
    marks = []
    for sign in (-1, 1):
        near, far = sorted((sign * inner, sign * outer))
        marks.append(box_between((near, -width / 2, top - depth), (far, width / 2, top + 1)))
        marks.append(box_between((-width / 2, near, top - depth), (width / 2, far, top + 1)))
    return marks
