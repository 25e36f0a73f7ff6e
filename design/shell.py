"""The cast silicone shell: five walls round the core's cavity, magnet pockets open outwards."""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.layouts import FaceFrame, face_frames
from design.pockets import Pocket, pockets
from design.solids import OVERSHOOT_MM, box_between, single_solid
from design.spec import ObjectSpec


def make_shell(spec: ObjectSpec) -> cq.Solid:
    """Shell as it leaves the mould, in the object's frame (mm), cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    cavity = cavity_block(spec, OVERSHOOT_MM)
    return single_solid(envelope(spec).cut(cavity, *pocket_cylinders(spec)), "shell")


def envelope(spec: ObjectSpec) -> cq.Solid:
    """The body's outer box, mm, centred on the origin."""
    half = np.asarray(spec.body.size_mm) / 2
    return box_between(-half, half)


def cavity_block(spec: ObjectSpec, overshoot_mm: float = 0.0) -> cq.Solid:
    """What the cavity removes: the core's cross-section, from the core's top to the open face.

    The block ends `overshoot_mm` beyond the open face.
    """
    core_x, core_y, core_z = (edge / 2 for edge in spec.core_size_mm)
    bottom = -spec.body.size_mm[2] / 2 - overshoot_mm
    return box_between((-core_x, -core_y, bottom), (core_x, core_y, core_z))


def pocket_cylinders(spec: ObjectSpec) -> list[cq.Solid]:
    """One cylinder a pocket, face by face, from the pocket's floor to just outside the face.

    The pockets' negatives are the mould's bosses, so that both come from here.
    """
    local = pockets(spec.shell, spec.magnets)
    return [_pocket(frame, pocket) for frame in face_frames(spec) for pocket in local]


def _pocket(frame: FaceFrame, pocket: Pocket) -> cq.Solid:
    """The cylinder; a tilted one is cut off where the mould's wall still hides its end."""
    floor, above = pocket.axis_ends_mm
    lift = OVERSHOOT_MM / pocket.axis[2] * pocket.axis
    start, end = frame.to_object(floor), frame.to_object(above + lift)
    axis = cq.Vector(*(end - start))
    cylinder = cq.Solid.makeCylinder(pocket.radius_mm, axis.Length, cq.Vector(*start), axis)
    if pocket.axis[2] == 1:
        return cylinder
    reach = 2 * np.append(frame.half_extents_mm, 0)
    top = [0, 0, OVERSHOOT_MM]
    bottom = [0, 0, pocket.lowest_mm - OVERSHOOT_MM]
    corners = np.stack([frame.to_object(bottom - reach), frame.to_object(top + reach)])
    (piece,) = cylinder.intersect(box_between(corners.min(axis=0), corners.max(axis=0))).Solids()
    return piece
