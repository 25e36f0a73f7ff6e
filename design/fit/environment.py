"""Surroundings that stay outside the object."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from design.spec.environment import SteelPlateSpec, StrayMagnetSpec
    from design.spec.object import ObjectSpec


def check_environment(spec: ObjectSpec) -> Iterator[str]:
    """Yield where steel or a stray magnet reaches into the object, or one the other."""
    half = [edge / 2 for edge in spec.body.size_mm]
    for index, stray in enumerate(spec.environment.magnets):
        outside = [max(abs(p) - h, 0.0) for p, h in zip(stray.position_mm, half, strict=True)]
        inside = min(h - abs(p) for p, h in zip(stray.position_mm, half, strict=True))
        away = _dot(outside, outside) ** 0.5 - max(inside, 0.0)
        if away <= _reach_mm(stray):
            yield (
                f"environment.magnets[{index}] at {list(stray.position_mm)} may reach into the object: "
                f"its centre must be more than {_reach_mm(stray):.4g} mm from the body. Move "
                f"it outwards by more than {_reach_mm(stray) - away:.4g} mm"
            )
    for index, plate in enumerate(spec.environment.steel_plates):
        normal = _normal(plate)
        nearest = [("the object", -sum(abs(n) * h for n, h in zip(normal, half, strict=True)))]
        nearest += [
            ("a stray magnet", _dot(normal, stray.position_mm) - _reach_mm(stray))
            for stray in spec.environment.magnets
        ]
        for what, height in nearest:
            depth = _dot(normal, plate.position_mm) - height
            if depth > 1e-9:
                yield (
                    f"environment.steel_plates[{index}]: {what} reaches {depth:.4g} mm into the steel. "
                    f"Move position_mm back by {depth:.4g} mm or more, or turn normal round (it points out "
                    "of the steel)"
                )


def _reach_mm(stray: StrayMagnetSpec) -> float:
    """Radius of the sphere about a stray magnet."""
    return hypot(*stray.size_mm) / 2


def _normal(plate: SteelPlateSpec) -> list[float]:
    size = _dot(plate.normal, plate.normal) ** 0.5
    return [n / size for n in plate.normal]


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))
