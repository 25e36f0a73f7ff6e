"""Volumes of the sealed silicone body, without keys and slits: closed forms where there are any."""

from __future__ import annotations

from collections.abc import Callable
from math import pi, prod
from typing import TYPE_CHECKING

import numpy as np

from design.body.kinds import base_top_mm, core_half_mm
from design.body.surface import open_span_mm, sealed_body_surface

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


def body_volume_mm3(spec: ObjectSpec) -> float:
    """Volume in mm³, pockets filled. That of an ellipsoid or an imported body is its surface's."""
    return _VOLUMES[spec.body.kind](spec)


def _box(spec: ObjectSpec) -> float:
    low, high = open_span_mm(spec, 0.0)
    return prod(spec.body.size_mm) - float(np.prod(high - low))


def _pad(spec: ObjectSpec) -> float:
    x, y, z = spec.body.size_mm
    return x * y * (z / 2 - base_top_mm(spec))


def _cylinder(spec: ObjectSpec) -> float:
    low, high = open_span_mm(spec, 0.0)
    diameter, _, height = spec.body.size_mm
    return pi * (diameter**2 / 4 * height - float(core_half_mm(spec)[0] ** 2 * (high - low)[2]))


def _sphere(spec: ObjectSpec) -> float:
    outer, inner = spec.body.size_mm[0] / 2, float(core_half_mm(spec)[0])
    bore = _above_bore(spec, outer) - _above_bore(spec, inner) if spec.body.opened else 0.0
    return 4 / 3 * pi * (outer**3 - inner**3) - bore


def _above_bore(spec: ObjectSpec, radius_mm: float) -> float:
    """Half of a ball within the bore's cylinder."""
    return 2 / 3 * pi * (radius_mm**3 - (radius_mm**2 - spec.body.bore_mm**2 / 4) ** 1.5)


def _dome(spec: ObjectSpec) -> float:
    outer = spec.body.size_mm[0] / 2
    inner = 0.0 if spec.body.inside == "silicone" else outer - spec.shell.thickness_mm
    return 2 / 3 * pi * (outer**3 - inner**3)


def _measured(spec: ObjectSpec) -> float:
    return float(sealed_body_surface(spec).volume)


_VOLUMES: dict[str, Callable[[ObjectSpec], float]] = {
    "box": _box,
    "pad": _pad,
    "cylinder": _cylinder,
    "sphere": _sphere,
    "ellipsoid": _measured,
    "dome": _dome,
    "imported": _measured,
}
