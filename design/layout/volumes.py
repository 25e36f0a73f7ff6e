"""Volume of the sealed body in closed form: no CAD kernel needed."""

from __future__ import annotations

from design.layout.blocks import keys_volume_mm3, slits_volume_mm3
from design.layout.body import body_of
from design.spec.object import ObjectSpec


def sealed_volume_mm3(spec: ObjectSpec) -> float:
    """Volume of the sealed body in mm³: pockets filled, magnets included (the meshed body).

    The cavity has the core's cross-section and runs from the core's top out of the open face; keys
    of the core add to it, and relief slits are left out.
    """
    return body_of(spec).volume_mm3() - keys_volume_mm3(spec) - slits_volume_mm3(spec)
