"""The cast silicone shell: walls round the core's cavity, magnet pockets open outwards.

With a seal layer the shell leaves its mould thinner by that layer on every sensed face, and the
layer is poured over it once the magnets lie in their pockets.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.blocks import core_keys, relief_slits
from design.layouts import face_frames
from design.pockets import shell_pockets
from design.solids import OVERSHOOT_MM, block_solid, box_between, pocket_solid, single_solid
from design.spec import ObjectSpec


def make_shell(spec: ObjectSpec) -> cq.Solid:
    """Shell as it leaves the mould, in the object's frame (mm), cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    removed = (*cavity(spec, OVERSHOOT_MM), *pocket_prisms(spec), *slit_fins(spec))
    return single_solid(cast_envelope(spec).cut(*removed), "shell")


def envelope(spec: ObjectSpec) -> cq.Solid:
    """The body's outer box, mm, centred on the origin."""
    half = np.asarray(spec.body.size_mm) / 2
    return box_between(-half, half)


def cast_envelope(spec: ObjectSpec) -> cq.Solid:
    """The outer box of what the first pour casts: the body's, less the seal layer."""
    high = np.asarray(spec.body.size_mm) / 2
    low, layer = -high, spec.shell.seal_layer_mm
    for frame in face_frames(spec):
        high = high - layer * frame.normal.clip(min=0)
        low = low - layer * frame.normal.clip(max=0)
    return box_between(low, high)


def cavity(spec: ObjectSpec, overshoot_mm: float = 0.0) -> list[cq.Solid]:
    """What the core and its keys keep free of silicone, down to the open face and beyond it."""
    keys = [block_solid(key) for key in core_keys(spec)]
    return [cavity_block(spec, overshoot_mm), *keys]


def slit_fins(spec: ObjectSpec) -> list[cq.Solid]:
    """The relief slits as solids, each begun outside the body; the mould holds them as fins."""
    return [block_solid(slit) for slit in relief_slits(spec)]


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
