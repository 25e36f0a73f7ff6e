"""The flanges along the seam of a split mould: where they reach, their notches, dowels and bolts.

Everything is numbers in the parting plane: across the mould and along `out`, mm.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from design.layout.mould.frame import (
    FLANGE_THICKNESS_MM,
    flange_width_mm,
    mould_frame,
    parting,
    seam_ends_mm,
)
from design.layout.mould.pins import Pin, loose_pins
from design.mould.openings import mould_holes
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

FLANGE_LENGTH_MM = 26.0
"""At least: dowels and bolts lie at shares of it and must not meet."""
PLACES = (0.15, 0.42, 0.7, 0.9)
"""Places of dowels and bolts in turn, as shares of the flange's length."""
LONGER_MM = (0.0, 6.0, 12.0, 18.0, 24.0)
"""Lengths by which flanges reach below the block where pins leave too little room."""
LEAST_GAP_MM = 5.0
"""Between the middles of a dowel and a bolt."""
BELOW_RIM_MM = 4.0
"""Depth of the flanges' upper ends, where a plug or a rod hangs in the mould."""
EDGE_MM = 3.0
"""From the middle of a dowel or a bolt to the end of the flange or a notch, at least."""
LEAST_STRETCH_MM = 4.0
"""Least length of flange between two notches; less is cut away."""
_STEP_MM = 0.5
"""Step along a round thing's way at which its levels next to a flange are found."""


@dataclass(frozen=True)
class Flange:
    """A strip next to the block, from `low_mm` to `high_mm` across and `bottom_mm` to `top_mm`.

    `notches` are the stretches along it that are cut away for pins, in rising order; above
    `pierced_mm` a hole for pouring or for air goes through it, and may cut off what is beyond.
    """

    low_mm: float
    high_mm: float
    bottom_mm: float
    top_mm: float
    notches: tuple[tuple[float, float], ...]
    pierced_mm: float = float("inf")

    @property
    def places_mm(self) -> list[tuple[float, float]]:
        """Dowels and bolts in turn, out of the notches' way.

        Each stands at its share of the length from the lower end, or as near as notches and those
        before it leave room; where there is none it is left out.
        """
        length, taken = self.top_mm - self.bottom_mm, []
        shifts = sorted(np.linspace(-0.85, 0.85, 69).tolist(), key=abs)
        for share in PLACES:
            levels = [self.bottom_mm + (share + shift) * length for shift in shifts]
            taken += [level for level in levels if self._is_clear(level, taken)][:1]
        return [((self.low_mm + self.high_mm) / 2, level) for level in taken]

    def _is_clear(self, level: float, taken: list[float]) -> bool:
        return (
            self.bottom_mm + EDGE_MM <= level <= min(self.top_mm, self.pierced_mm) - EDGE_MM
            and all(abs(level - other_level) >= LEAST_GAP_MM for other_level in taken)
            and not any(low - EDGE_MM < level < high + EDGE_MM for low, high in self.notches)
        )


@cached_geometry
def flanges(spec: ObjectSpec) -> tuple[Flange, Flange]:
    """Flanges of both ends of the seam, below the rim that a plug clips onto, as long as dowels and bolts
    need."""
    frame, wide = mould_frame(spec), flange_width_mm(spec)
    left, right = seam_ends_mm(spec)
    lower = BELOW_RIM_MM + 2 * spec.printer.clearance_mm if frame.plugged else 0.0
    top = frame.rim_mm - lower
    bottom = min(float(frame.low_mm[2]), top - FLANGE_LENGTH_MM)
    ends, pins = ((left - wide, left), (right, right + wide)), loose_pins(spec)
    pierced = [_pierced_mm(spec, *end) for end in ends]
    for longer in (*LONGER_MM, 0.0):
        low = bottom - longer
        pair = [
            Flange(*end, low, top, notches_of(spec, pins, *end, low, top), level)
            for end, level in zip(ends, pierced, strict=True)
        ]
        if all(len(flange.places_mm) == len(PLACES) for flange in pair):
            break
    return pair[0], pair[1]


def roots_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Ends of the block on all of both flanges' thickness: notches begin there. From the ends of the
    seam on a fin stood between a notch and the block, 0.2 mm thick next to a pin's head."""
    asides = (-FLANGE_THICKNESS_MM, 0.0, FLANGE_THICKNESS_MM)
    left, right = zip(*(seam_ends_mm(spec, aside) for aside in asides), strict=True)
    return max(left), min(right)


def notches_of(
    spec: ObjectSpec, pins: tuple[Pin, ...], low: float, high: float, bottom: float, top: float
) -> tuple[tuple[float, float], ...]:
    """Stretches through which pins are drawn, joined where too little is between or beyond them.

    What is below a notch hangs on the block: with too little of it next to the block it is cut away too.
    """
    block = float(mould_frame(spec).low_mm[2])
    pierced = [pierced_levels(spec, pin, low, high) for pin in pins]
    through = [levels for levels in pierced if levels is not None]
    merged: list[tuple[float, float]] = []
    for start, end in sorted(pair for pair in through if pair[1] > bottom and pair[0] < top):
        start = bottom - 1.0 if start - max(bottom, block) < LEAST_STRETCH_MM else start
        end = top + 1.0 if top - end < LEAST_STRETCH_MM else end
        if merged and start - merged[-1][1] < LEAST_STRETCH_MM:
            start, previous_end = merged.pop()
            end = max(end, previous_end)
        merged.append((start, end))
    return tuple(merged)


def _pierced_mm(spec: ObjectSpec, low: float, high: float) -> float:
    """From which level on a hole for pouring or for air is in a flange; inf: none is."""
    pierced = [
        _levels_of_path(
            spec, hole.top_mm, hole.end_mm - hole.top_mm, hole.diameter_mm / 2, low, high
        )
        for hole in mould_holes(spec)
    ]
    return min((levels[0] for levels in pierced if levels is not None), default=np.inf)


def pierced_levels(
    spec: ObjectSpec, pin: Pin, low: float, high: float
) -> tuple[float, float] | None:
    """Between which levels a pin's head is drawn through a flange; None where it passes by."""
    radius = pin.radius_mm + pin.rim_mm + spec.printer.clearance_mm
    return _levels_of_path(spec, pin.head_axis_mm[0], pin.way, radius, low, high)


def _levels_of_path(
    spec: ObjectSpec, start_mm: np.ndarray, way: np.ndarray, radius: float, low: float, high: float
) -> tuple[float, float] | None:
    """Between which levels something round meets a flange on its way; None where it passes by."""
    frame, plane = mould_frame(spec), parting(spec)
    steps = np.arange(0.0, 2 * max(spec.body.size_mm), _STEP_MM)
    path = steps[:, None] * way / np.linalg.norm(way) + start_mm
    across = path @ np.cross(frame.out, plane.normal)
    aside = abs(path @ plane.normal - plane.offset_mm)
    near = (aside < FLANGE_THICKNESS_MM + radius) & (across > low) & (across < high)
    levels = (path @ frame.out)[near]
    return (float(levels.min() - radius), float(levels.max() + radius)) if len(levels) else None
