"""The rigid printed core: a box with sensor recesses, hub recesses, wire holes and a cavity."""

from __future__ import annotations

from dataclasses import replace

import cadquery as cq
import numpy as np

from design.layouts import FaceFrame, face_frames
from design.solids import (
    OVERSHOOT_MM,
    box_between,
    cylinder_on_face,
    radial_box_on_face,
    single_solid,
)
from design.spec import ObjectSpec

TOP_FACE = 1


def make_core(spec: ObjectSpec) -> cq.Solid:
    """Core in the object's frame (mm): fills ± core_size/2, its cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    half = np.asarray(spec.core_size_mm) / 2
    cutters = [_cavity(spec)]
    for frame, azimuth in zip(core_frames(spec), spec.sensors.first_azimuth_deg, strict=True):
        cutters += _sensor_recesses(spec, frame, float(azimuth))
        cutters += _wire_passage(spec, frame)
    return single_solid(box_between(-half, half).cut(*cutters), "core")


def core_frames(spec: ObjectSpec) -> tuple[FaceFrame, ...]:
    """The sensed faces' frames moved inwards onto the core's faces."""
    inward = spec.shell.thickness_mm
    return tuple(
        replace(
            frame,
            centre_mm=frame.centre_mm - inward * frame.normal,
            half_extents_mm=tuple(half - inward for half in frame.half_extents_mm),
        )
        for frame in face_frames(spec)
    )


def _cavity(spec: ObjectSpec) -> cq.Solid:
    x, y, z = np.asarray(spec.core_size_mm) / 2
    wall = spec.core.wall_mm
    return box_between((wall - x, wall - y, -z - OVERSHOOT_MM), (x - wall, y - wall, z - wall))


def _sensor_recesses(spec: ObjectSpec, frame: FaceFrame, first_deg: float) -> list[cq.Solid]:
    core, count = spec.core, spec.sensors.count_per_face
    return [
        radial_box_on_face(
            frame,
            first_deg + 360 * k / count,
            core.recess_width_mm,
            (core.recess_inner_radius_mm, core.recess_outer_radius_mm),
            (-core.recess_depth_mm, OVERSHOOT_MM),
        )
        for k in range(count)
    ]


def _wire_passage(spec: ObjectSpec, frame: FaceFrame) -> list[cq.Solid]:
    """Wire hole through the wall at the face centre, and the hub recess where it is wider."""
    core = spec.core
    radius = _wire_hole_diameter_mm(spec, frame.number) / 2
    through = -core.wall_mm - OVERSHOOT_MM
    passage = [cylinder_on_face(frame, (0.0, 0.0), radius, through, OVERSHOOT_MM)]
    if core.hub_radius_mm > radius:
        hub = (core.hub_radius_mm, -core.hub_depth_mm, OVERSHOOT_MM)
        passage.append(cylinder_on_face(frame, (0.0, 0.0), *hub))
    return passage


def _wire_hole_diameter_mm(spec: ObjectSpec, face: int) -> float:
    core = spec.core
    return core.wire_hole_top_diameter_mm if face == TOP_FACE else core.wire_hole_side_diameter_mm
