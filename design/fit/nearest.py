"""Nearest values that work, for messages: most are found by trying."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import combinations, product
from math import ceil
from typing import TYPE_CHECKING

import numpy as np

from design.layout.body import core_frames
from design.layout.tips import tip_places_mm, tip_shape, tips_overlap

if TYPE_CHECKING:
    from design.spec.mechanics import IndenterSpec
    from design.spec.object import ObjectSpec

Check = Callable[["ObjectSpec"], Iterator[str]]
Place = tuple[float, float]

_STEP_MM, _REACH_MM = 2.0, 8.0
"""Step and reach of the lattice round a key on which another place is looked for."""
_HALVINGS = 7
_LEAST_BAY_MM = 1.5
"""Nothing goes into a smaller one."""
_SMALLER = (0.7, 0.5, 0.35, 0.25)
"""Factors by which keys shrink that fit nowhere near."""


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
    """Places near by, or smaller keys and their places."""
    keys = spec.core.keys
    if keys.height_mm >= spec.shell.thickness_mm:
        return None
    for share in (1.0, *_SMALLER):
        size = tuple(round(share * edge, 1) for edge in keys.size_mm)
        smaller = spec.changed(core=spec.core.changed(keys=keys.changed(size_mm=size)))
        places = _nearest_places(smaller, check)
        if places is not None:
            sized = "" if share == 1 else f"size_mm = {list(size)} and "
            return f"core.keys would fit with {sized}positions_mm = {[list(p) for p in places]}"
    return None


def _nearest_places(spec: ObjectSpec, check: Check) -> list[Place] | None:
    """For one key after the other, those before it being placed; None where one finds none."""
    keys, placed = spec.core.keys, list[Place]()

    def works(place: Place) -> bool:
        changed = keys.changed(positions_mm=(*placed, place))
        return _is_sound(spec.changed(core=spec.core.changed(keys=changed)), check)

    for wanted in keys.positions_mm:
        nearest = _nearest_place(spec, wanted, works)
        if nearest is None:
            return None
        placed.append(nearest)
    return placed


def _nearest_place(spec: ObjectSpec, wanted: Place, works: Callable[[Place], bool]) -> Place | None:
    if works(wanted):
        return wanted
    limit = np.min([frame.half_extents_mm for frame in core_frames(spec)], axis=0)
    start = np.clip(wanted, -limit, limit)
    steps = np.arange(-_REACH_MM, _REACH_MM + _STEP_MM / 2, _STEP_MM)
    tried = sorted(
        (start + step for step in product(steps, steps)), key=_distance_from(np.array(wanted))
    )
    tried = [place for place in tried if (abs(place) <= limit).all()]
    nearest = next((place for place in tried if works(_rounded(place))), None)
    if nearest is None:
        return None
    low, high = np.array(wanted, float), nearest
    for _ in range(3):
        middle = (low + high) / 2
        low, high = (low, middle) if works(_rounded(middle)) else (middle, high)
    return _rounded(high)


def _distance_from(wanted: np.ndarray) -> Callable[[np.ndarray], float]:
    return lambda place: float(np.linalg.norm(place - wanted))


def _rounded(place: np.ndarray) -> Place:
    x, y = np.round(place, 1) + 0.0
    return float(x), float(y)


def _is_sound(spec: ObjectSpec, check: Check) -> bool:
    return next(check(spec), None) is None


def _largest_share(works: Callable[[float], bool]) -> float:
    """Between 0 (none) and 1, where what works for one share works for all that are smaller."""
    low, high = 0.0, 1.0
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (middle, high) if works(middle) else (low, middle)
    return low


def least_spacing_mm(indenter: IndenterSpec) -> float:
    """Least spacing of tips that do not overlap, rounded up to 0.1 mm."""
    single_tip = indenter.changed(tip_count=1)

    def apart(spacing: float) -> bool:
        places = tip_places_mm(indenter.changed(tip_spacing_mm=spacing))
        return not any(tips_overlap(single_tip, b - a) for a, b in combinations(places, 2))

    low, high = 0, ceil(40 * float(np.linalg.norm(tip_shape(indenter).corners_mm, axis=1).max()))
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if apart(middle / 10) else (middle, high)
    return high / 10


def excess(reach: tuple[float, float], limits: tuple[float, float]) -> str:
    """Return how far in x and y something reaches too far."""
    over = [max(r - limit, 0.0) for r, limit in zip(reach, limits, strict=True)]
    return " and ".join(
        f"{o:.3g} mm in {axis}" for o, axis in zip(over, "xy", strict=True) if o > 0
    )
