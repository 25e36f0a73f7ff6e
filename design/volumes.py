"""Closed-form volumes of the shell, for checks that need no CAD kernel."""

from __future__ import annotations

from math import prod

from design.pockets import shell_pockets
from design.spec import ObjectSpec


def sealed_volume_mm3(spec: ObjectSpec) -> float:
    """Volume of the sealed body in mm³: pockets filled, magnets included (the meshed body).

    The cavity has the core's cross-section and runs from the core's top out of the open face.
    """
    core_x, core_y, _ = spec.core_size_mm
    return prod(spec.body.size_mm) - core_x * core_y * cavity_depth_mm(spec)


def shell_volume_mm3(spec: ObjectSpec) -> float:
    """Volume of the cast shell in mm³: the sealed body less its open pockets."""
    pockets = sum(pocket.volume_mm3 for face in shell_pockets(spec) for pocket in face)
    return sealed_volume_mm3(spec) - pockets


def cavity_depth_mm(spec: ObjectSpec) -> float:
    """Depth of the shell's cavity from the open face, mm: the body's height less the top wall."""
    return spec.body.size_mm[2] - spec.shell.thickness_mm
