"""The cast silicone shell: five walls round the core's cavity, magnet pockets open outwards."""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.layouts import face_frames
from design.pockets import shell_pockets
from design.solids import OVERSHOOT_MM, box_between, pocket_solid, single_solid
from design.spec import ObjectSpec


def make_shell(spec: ObjectSpec) -> cq.Solid:
    """Shell as it leaves the mould, in the object's frame (mm), cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    cavity = cavity_block(spec, OVERSHOOT_MM)
    return single_solid(envelope(spec).cut(cavity, *pocket_prisms(spec)), "shell")


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


def pocket_prisms(spec: ObjectSpec) -> list[cq.Solid]:
    """One prism a pocket, face by face, from the pocket's floor to just outside the face.

    The pockets' negatives are the mould's bosses, so that both come from here.
    """
    return [
        pocket_solid(frame, pocket)
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]
