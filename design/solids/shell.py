"""The cast silicone shell: walls round the core's cavity, magnet pockets open outwards.

With a seal layer the shell leaves its mould thinner by that layer on every sensed face (of a body
that curves all over), and the layer is poured over it once the magnets lie in their pockets. A closed
body has the holes of the pins that held its core.
"""

from __future__ import annotations

from design.layout.blocks import core_keys, relief_slits
from design.layout.body import face_frames
from design.layout.core_hold import Locator, locators
from design.layout.pockets import shell_pockets
from design.solids.body import cast_outer_solid, cavity_solid
from design.solids.booleans import Solid, cut, one_solid
from design.solids.kernel import cq
from design.solids.primitives import (
    OVERSHOOT_MM,
    block_solid,
    cylinder_on_face,
    pocket_solid,
)
from design.spec.object import ObjectSpec


def make_shell(spec: ObjectSpec) -> Solid:
    """Shell as it leaves the mould, in the object's frame (mm), cavity open towards −z.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid, or the body has no exact one.
    """
    removed = (
        *cavity(spec, OVERSHOOT_MM),
        *pocket_prisms(spec),
        *slit_fins(spec),
        *(locator_hole(locator) for locator in locators(spec)),
    )
    return one_solid(cut(cast_outer_solid(spec), *removed), "shell")


def cavity(spec: ObjectSpec, overshoot_mm: float = 0.0) -> list[cq.Solid]:
    """Return what the core and its keys keep free of silicone, out through the open faces and beyond."""
    block = cavity_solid(spec, overshoot_mm)
    keys = [block_solid(key) for key in core_keys(spec)]
    return keys if block is None else [block, *keys]


def slit_fins(spec: ObjectSpec) -> list[cq.Solid]:
    """The relief slits as solids, each begun outside the body; the mould holds them as fins."""
    return [block_solid(slit) for slit in relief_slits(spec)]


def pocket_prisms(spec: ObjectSpec) -> list[cq.Solid]:
    """One prism per pocket, face by face, from the pocket's floor to just outside the face.

    The pockets' negatives are the mould's bosses, so that both come from here.
    """
    return [
        pocket_solid(frame.tangent(pocket.body.centre_mm[:2]), pocket)
        for frame, face in zip(face_frames(spec), shell_pockets(spec), strict=True)
        for pocket in face
    ]


def locator_hole(locator: Locator) -> cq.Solid:
    """Return what a locating pin leaves in the silicone, from within the core to outside the face."""
    past = OVERSHOOT_MM + locator.radius_mm * locator.rise_mm
    bottom = -locator.depth_mm - past
    return cylinder_on_face(locator.frame, (0.0, 0.0), locator.radius_mm, bottom, past)
