"""The rigid printed core, with sensor recesses, hub recesses, wire holes and a cavity."""

from __future__ import annotations

import numpy as np

from design.body.surface_chart import FACE_AXES, FaceFrame
from design.layout.blocks import core_keys
from design.layout.boards import (
    LID_RIM_MM,
    bay_block,
    has_lid,
    passage_radius_mm,
    wire_channels,
    wire_hole_diameter_mm,
)
from design.layout.body import body_of, core_frames
from design.layout.core_hold import locators
from design.layout.places.positions import board_places
from design.layout.pockets import core_pockets
from design.solids.body import core_hollow, core_solid
from design.solids.booleans import Solid, common, cut, join, one_solid
from design.solids.kernel import cq
from design.solids.primitives import (
    OVERSHOOT_MM,
    block_solid,
    box_between,
    cylinder_on_face,
    pocket_solid,
    radial_box_on_face,
)
from design.spec.body import HUB_DEPTH_MM
from design.spec.object import ObjectSpec


def make_core(spec: ObjectSpec) -> Solid:
    """Core in the object's frame (mm), its cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    cutters = [*_cavity(spec), *_outlets(spec), *_sockets(spec)]
    frames = core_frames(spec)
    for frame, places in board_places(spec):
        if spec.arrangement == "sensors-in-core":
            cutters += [_sensor_recess(spec, frame, place, sink) for place, sink in places]
            channels = wire_channels(spec, frame, [place for place, _ in places], OVERSHOOT_MM)
            cutters += [block_solid(channel) for channel in channels]
        cutters += wire_passage(spec, frame)
    for frame, pockets in zip(frames, core_pockets(spec), strict=True):
        cutters += [pocket_solid(frame, pocket) for pocket in pockets]
    body = core_solid(spec)
    keys = [block_solid(key) for key in core_keys(spec)]
    return one_solid(cut(join(body, *keys), *cutters), "core")


def make_core_base(spec: ObjectSpec) -> Solid:
    """Core of a closed body below the top of its bay: the bay is open there for a board and a battery.

    Raises
    ------
    InputError
        As `make_core`.
    """
    return one_solid(cut(make_core(spec), _above_bay(spec)), "core_base")


def make_core_lid(spec: ObjectSpec) -> Solid:
    """Core of a closed body above the top of its bay, with a rim below that stands in the bay.

    Raises
    ------
    InputError
        As `make_core`.
    """
    bay = bay_block(spec)
    assert bay is not None
    top = float(bay.half_mm[2])
    across = bay.half_mm[:2] - spec.printer.clearance_mm
    inner = across - spec.printer.wall_mm
    rim = box_between((*-across, top - LID_RIM_MM), (*across, top + OVERSHOOT_MM))
    room = box_between((*-inner, top - LID_RIM_MM - OVERSHOOT_MM), (*inner, top))
    wires = [
        tool
        for frame, _ in board_places(spec)
        if frame.normal[2] > 0.5
        for tool in wire_passage(spec, frame)
    ]
    lid = join(common(make_core(spec), _above_bay(spec)), cut(rim, room))
    return one_solid(cut(lid, *wires), "core_lid")


def _above_bay(spec: ObjectSpec) -> cq.Solid:
    bay, half = bay_block(spec), body_of(spec).half_mm + OVERSHOOT_MM
    assert bay is not None
    return box_between((*-half[:2], float(bay.half_mm[2])), half)


def _cavity(spec: ObjectSpec) -> list[cq.Solid]:
    rooms, bay = core_hollow(spec), bay_block(spec)
    if bay is not None:
        low, high = bay.centre_mm - bay.half_mm, bay.centre_mm + bay.half_mm
        past = 0.0 if has_lid(spec) else OVERSHOOT_MM
        rooms.append(box_between(low - [0, 0, past], high))
    return rooms


def _outlets(spec: ObjectSpec) -> list[cq.Solid]:
    """Outlets of a core without a cavity: from its middle, where the wire holes meet, out of every open
    face."""
    if core_hollow(spec):
        return []
    radius, half = spec.core.wire_hole_side_diameter_mm / 2, body_of(spec).core_half_mm
    middle, outlets = cq.Vector(0, 0, 0), []
    for face in spec.body.opened:
        normal = np.asarray(FACE_AXES[face][0], float)
        length = float(abs(normal) @ half) + OVERSHOOT_MM
        outlets.append(cq.Solid.makeCylinder(radius, length, middle, cq.Vector(*normal)))
    return outlets


def _sockets(spec: ObjectSpec) -> list[cq.Solid]:
    """Holes for pins that stand next to the wire holes."""
    return [
        cylinder_on_face(
            l.frame, (0.0, 0.0), l.radius_mm, -l.depth_mm - l.hole_mm, OVERSHOOT_MM - l.depth_mm
        )
        for l in locators(spec)
        if l.socket is not None
    ]


def _sensor_recess(
    spec: ObjectSpec, frame: FaceFrame, place: tuple[float, float, float], sink_mm: float
) -> cq.Solid:
    """Box of the recess's width and radial extent about the sensor, turned to its azimuth."""
    core, (x, y, azimuth) = spec.core, place
    offset = float(np.hypot(x, y)) - spec.sensors.radius_mm
    return radial_box_on_face(
        frame.tangent(np.array([x, y])),
        float(np.rad2deg(azimuth)),
        core.recess_width_mm,
        (core.recess_inner_radius_mm + offset, core.recess_outer_radius_mm + offset),
        (-core.recess_depth_mm - sink_mm, OVERSHOOT_MM),
    )


def wire_passage(spec: ObjectSpec, frame: FaceFrame) -> list[cq.Solid]:
    """Wire hole through the wall at the face centre, and the hub recess where it is wider."""
    radius, hub_mm = wire_hole_diameter_mm(spec, frame.number) / 2, passage_radius_mm(spec)
    through = -_passage_mm(spec, frame) - OVERSHOOT_MM
    passage = [cylinder_on_face(frame, (0.0, 0.0), radius, through, OVERSHOOT_MM)]
    if hub_mm > radius:
        hub = (hub_mm, -HUB_DEPTH_MM, OVERSHOOT_MM)
        passage.append(cylinder_on_face(frame, (0.0, 0.0), *hub))
    return passage


def _passage_mm(spec: ObjectSpec, frame: FaceFrame) -> float:
    """Return how deep a wire hole is: through the wall of a hollow core, else to where wires leave.

    A cavity that is narrower than the hole would leave a film round its mouth.
    """
    to_middle = float(abs(frame.normal) @ body_of(spec).core_half_mm)
    narrow = to_middle - spec.core.wall_mm < wire_hole_diameter_mm(spec, frame.number)
    if core_hollow(spec) and not (body_of(spec).opening == "bore" and narrow):
        return spec.core.wall_mm
    if body_of(spec).on_base:
        return float(frame.centre_mm[2]) + spec.body.size_mm[2] / 2
    return to_middle
