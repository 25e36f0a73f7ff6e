"""Faults of a split mould's seam that `check --fabrication` fails on, told before anything is built.

Such an object fits together and can be simulated, but its mould has thin walls or does not come off.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import body_of
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import (
    YIELD_SHARE,
    hooked_depth_mm,
    mould_frame,
    mould_style,
    parting,
    wall_to_plane_mm,
)
from design.layout.mould.pins import Pin, pin_holes
from design.spec.object import ObjectSpec

_AZIMUTHS_DEG = np.arange(0.0, 180.0, 3.0)
"""Of seams that are tried, until one does neither."""


def seam_in_words(spec: ObjectSpec) -> list[str]:
    """Thin walls between the seam and holes of pins, and halves that hook, with places and the nearest
    `mould.parting_azimuth_deg` that has neither; of a specification that fits."""
    if mould_style(spec) != "split" or spec.silicone.cure == "none" or why_no_mould(spec):
        return []
    wrong = [*_thin(spec), *_hooked(spec)]
    if not wrong:
        return []
    better = _nearest_azimuth(spec)
    way = (
        "No azimuth of the seam does without: move magnets, or choose another mould.style"
        if better is None
        else f"A seam with mould.parting_azimuth_deg = {better:g} does without"
    )
    return [f"{told}; check --fabrication fails on it. {way}" for told in wrong]


def _thin(spec: ObjectSpec) -> Iterator[str]:
    least = spec.printer.wall_mm
    found = [
        (wall, place, pin) for wall, place, pin, whole in _walls(spec) if whole and wall < least
    ]
    if not found:
        return
    wall, place, pin = min(found, key=lambda one: one[0])
    label, face = pin.pocket.body.label, f"face {pin.frame.number}: "
    what = label if label.startswith(face) else f"{face}{label}"
    left = "a wall that ends in nothing" if wall == 0 else f"a wall of {wall:.2g} mm"
    yield (
        f"the mould's seam leaves {left} beside the hole for the pin of {what}, at "
        f"({', '.join(f'{x:.1f}' for x in place)}), where {spec.printer.wall_mm:g} mm can be printed"
    )


def _walls(spec: ObjectSpec) -> Iterator[tuple[float, Float[np.ndarray, "3"], Pin, bool]]:
    """Between the seam and every hole of a pin or of its head, and where; whether there is a wall: where the
    seam cuts the hole at both its ends, a wedge is left, which prints ragged and is no thin wall."""
    plane = parting(spec)
    for pin, axis, radius in pin_holes(spec):
        aside = axis @ plane.normal - plane.offset_mm
        nearest = int(abs(aside).argmin())
        place = axis[nearest] - np.sign(aside[nearest]) * radius * plane.normal
        whole = bool(abs(aside).max() > radius)
        yield wall_to_plane_mm(axis, plane, radius), place, pin, whole


def _hooked(spec: ObjectSpec) -> Iterator[str]:
    depth, room = hooked_depth_mm(spec), _room_mm(spec)
    if not body_of(spec).from_file and depth > room:
        yield (
            f"the mould's halves hook the body by about {depth:.2g} mm, and the silicone gives way by "
            f"{room:.2g} mm: the seam is not along the body's sides"
        )


def _room_mm(spec: ObjectSpec) -> float:
    return YIELD_SHARE * spec.shell.thickness_mm


def _nearest_azimuth(spec: ObjectSpec) -> float | None:
    """The seam turned least that leaves walls, and hooks no deeper than the silicone, or this one, allows."""
    plane, frame = parting(spec), mould_frame(spec)
    start = np.rad2deg(np.arctan2(plane.normal @ frame.along, plane.normal @ frame.across))
    room = max(_room_mm(spec), hooked_depth_mm(spec) if body_of(spec).from_file else 0.0)
    away = abs((_AZIMUTHS_DEG - start + 90.0) % 180.0 - 90.0)
    for azimuth in _AZIMUTHS_DEG[np.argsort(away, kind="stable")].tolist():
        turned = spec.changed(mould=spec.mould.changed(parting_azimuth_deg=azimuth))
        try:
            thin = any(wall < spec.printer.wall_mm for wall, *_ in _walls(turned))
        except InputError:
            continue
        if not thin and hooked_depth_mm(turned) <= room:
            return azimuth
    return None
