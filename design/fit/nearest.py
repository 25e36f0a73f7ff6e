"""Nearest values that work, for messages: most are found by trying."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

Check = Callable[["ObjectSpec"], Iterator[str]]

_HALVINGS = 7
_LEAST_BAY_MM = 1.5
"""Nothing goes into a smaller one."""
_LEAST_KEY_MM = 0.5
"""Nothing holds on a smaller one."""


def with_nearest(
    spec: ObjectSpec, check: Check, nearest: Callable[[ObjectSpec, Check], str | None]
) -> Iterator[str]:
    """The problems that a check finds, then what `nearest` says would work."""
    sound = True
    for problem in check(spec):
        sound = False
        yield problem
    works = None if sound else nearest(spec, check)
    if works is not None:
        yield works


def nearest_slits(spec: ObjectSpec, check: Check) -> str | None:
    """The deepest slits that work, as they would be written."""

    def changed(share: float) -> ObjectSpec:
        depth = round(share * spec.shell.slits.depth_mm - 0.005, 2)
        slits = spec.shell.slits.changed(depth_mm=max(depth, 0.01))
        return spec.changed(shell=spec.shell.changed(slits=slits))

    share = _largest_share(lambda share: _is_sound(changed(share), check))
    depth = changed(share).shell.slits.depth_mm if share else 0.0
    return f"shell.slits would fit with depth_mm = {depth:g}" if share else None


def nearest_bay(spec: ObjectSpec, check: Check) -> str | None:
    """The largest bay of those proportions that works."""
    bay = spec.core.bay_mm
    assert bay is not None

    def changed(share: float) -> ObjectSpec:
        x, y, z = (max(round(share * edge - 0.05, 1), 0.1) for edge in bay)
        return spec.changed(core=spec.core.changed(bay_mm=(x, y, z)))

    share = _largest_share(lambda share: _is_sound(changed(share), check))
    fits = list(changed(share).core.bay_mm or ())
    has_bay = share and min(fits) >= _LEAST_BAY_MM
    return f"a bay would fit with core.bay_mm = {fits}" if has_bay else None


def nearest_keys(spec: ObjectSpec, check: Check) -> str | None:
    """The widest keys of those proportions and height that work where they are."""

    def changed(share: float) -> ObjectSpec:
        keys = spec.core.keys
        x, y = (max(round(share * edge - 0.05, 1), 0.1) for edge in keys.size_mm[:2])
        size = x, y, keys.size_mm[2]
        return spec.changed(core=spec.core.changed(keys=keys.changed(size_mm=size)))

    share = _largest_share(lambda share: _is_sound(changed(share), check))
    size = list(changed(share).core.keys.size_mm)
    has_keys = share and min(size[:2]) >= _LEAST_KEY_MM
    return f"core.keys would fit with size_mm = {size}" if has_keys else None


def _is_sound(spec: ObjectSpec, check: Check) -> bool:
    return next(check(spec), None) is None


def _largest_share(works: Callable[[float], bool]) -> float:
    """Between 0 (none) and 1, where what works for one share works for all that are smaller."""
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if works(middle) else (low, middle)
    return low


def excess(reach: tuple[float, float], limits: tuple[float, float]) -> str:
    """Return how far in x and y something reaches too far."""
    over = [max(r - limit, 0.0) for r, limit in zip(reach, limits, strict=True)]
    return " and ".join(
        f"{o:.3g} mm in {axis}" for o, axis in zip(over, "xy", strict=True) if o > 0
    )
