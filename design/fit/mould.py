"""Fit of the mould: whether it can be one, and its pins clear of each other and of what closes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import combinations
from math import ceil
from typing import TYPE_CHECKING

import numpy as np

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.core_hold import why_no_mould
from design.layout.mould_closure import flange_corners_mm
from design.layout.mould_frame import mould_style, opening_of
from design.layout.mould_pins import Pin, least_rim_mm, loose_pins, pin_of, rim_below_clips_mm
from design.layout.mould_pouring import LEAST_POUR_MM, pins_of, pour_holes
from design.layout.pockets import distance_of_segments_mm

if TYPE_CHECKING:
    from manifold3d import Manifold

    from design.spec.object import ObjectSpec

_MEETING_MM3 = 1e-3
_STEPS = 51
"""Of places between a magnet and the middle of its face."""


def check_mould(spec: ObjectSpec) -> Iterator[str]:
    """What cannot be moulded, what was given and how to fix it."""
    opening = opening_of(spec)
    if spec.mould.style == "one-piece" and opening != "open":
        yield (
            f'mould.style = "one-piece" needs a whole side of the body open; this {spec.body.kind} has '
            f'body.open_faces = {list(spec.body.opened)}. Use "split", or leave the style out'
        )
    elif mould_style(spec) == "split" and spec.silicone.cure != "none":
        yield from _check_closure(spec)
        yield from _check_pins_apart(spec)
        if why_no_mould(spec) is None:
            yield from _check_pouring(spec)


def _check_closure(spec: ObjectSpec) -> Iterator[str]:
    """Heads of pins and the flange of a plug or a rod, which reaches over the mould's walls."""
    flange = _flange(spec)
    for pin in loose_pins(spec) if flange else ():
        volume = _common_mm3(pin.head(), flange)
        if volume > _MEETING_MM3:
            yield (
                f"the head of the pin of {pin.pocket.body.label} of face {pin.frame.number} stands "
                f"{volume:.2g} mm³ in the flange by which the mould's rod or plug hangs over its walls. "
                f"{_where(spec, pin, lambda moved: _common_mm3(moved.head(), flange) <= _MEETING_MM3)}"
            )


def _flange(spec: ObjectSpec) -> list[Manifold]:
    from manifold3d import Manifold

    return [
        Manifold.cube(tuple(high - low)).translate(tuple(low))
        for low, high in flange_corners_mm(spec)
    ]


def _common_mm3(solid: Manifold, others: list[Manifold]) -> float:
    return max(float((solid ^ other).volume()) for other in others)


def _where(spec: ObjectSpec, pin: Pin, works: Callable[[Pin], bool]) -> str:
    """The first place on a magnet's way to the middle of its face where its pin works, with no less of
    a rim than the printer makes."""
    frame = next(frame for frame in face_frames(spec) if frame.number == pin.frame.number)
    x, y, height = pin.pocket.body.centre_mm
    for share in np.linspace(1, 0, _STEPS)[1:]:
        centre = np.array([share * x, share * y, height])
        pocket = replace(pin.pocket, body=replace(pin.pocket.body, centre_mm=centre))
        moved = pin_of(spec, frame.tangent(centre[:2]), pocket)
        rim = rim_below_clips_mm(spec, [moved])
        if rim >= least_rim_mm(spec) and works(replace(moved, rim_mm=rim)):
            return f"Move the magnet inwards, as to ({share * x:.4g}, {share * y:.4g})"
    return "Leave the magnet out, or the face with body.sensed_faces"


def _check_pins_apart(spec: ObjectSpec) -> Iterator[str]:
    """Beyond the silicone, where pins of a hollow lean towards each other."""
    for a, b in combinations(loose_pins(spec), 2):
        apart = distance_of_segments_mm(a.axis_mm, b.axis_mm) - a.radius_mm - b.radius_mm
        volume = 0.0 if apart > a.rim_mm + b.rim_mm else _common_mm3(a.room(), [b.room()])
        if volume > _MEETING_MM3:
            yield (
                f"the pins of {a.pocket.body.label} of face {a.frame.number} and "
                f"{b.pocket.body.label} of face {b.frame.number} share {volume:.2g} mm³ beyond the "
                "silicone, so that the mould cannot close. Move their magnets apart, or leave a face out "
                "with body.sensed_faces"
            )


def _check_pouring(spec: ObjectSpec) -> Iterator[str]:
    """Holes to pour through, of the mould and of the seal layer's."""
    for first in (True, False) if spec.shell.seal_layer_mm else (True,):
        try:
            pour_holes(spec, first)
        except InputError as error:
            yield f"{error}. {_how_poured(spec, first)}"
            return


def _how_poured(spec: ObjectSpec, first: bool) -> str:
    """The widest holes that find room, else the place of the one magnet that is in the way."""
    width = _widest_mm(spec, first)
    if width is not None:
        return f"mould.pour_mm = {width:g} finds room"
    pins = pins_of(spec, first)
    for index, pin in enumerate(pins):
        others = (*pins[:index], *pins[index + 1 :])
        if pin.locator is None and _is_poured(spec, first, others):
            way = _where(spec, pin, partial(_is_poured_beside, spec, first, others))
            return f"{pin.pocket.body.label} of face {pin.frame.number} is in the way. {way}"
    return "Move magnets towards the middles of their faces, or leave a face out with body.sensed_faces"


def _widest_mm(spec: ObjectSpec, first: bool) -> float | None:
    """In steps of half a millimetre, by halving; None where the narrowest that pour well find none."""

    def works(halves: int) -> bool:
        narrower = spec.changed(mould=spec.mould.changed(pour_mm=halves / 2))
        return _is_poured(narrower, first, pins_of(narrower, first))

    low, high = int(2 * LEAST_POUR_MM), ceil(2 * spec.mould.pour_mm)
    if low >= high or not works(low):
        return None
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if works(middle) else (low, middle)
    return low / 2


def _is_poured_beside(spec: ObjectSpec, first: bool, others: tuple[Pin, ...], pin: Pin) -> bool:
    return _is_poured(spec, first, (*others, pin))


def _is_poured(spec: ObjectSpec, first: bool, pins: tuple[Pin, ...]) -> bool:
    try:
        pour_holes(spec, first, pins)
    except InputError:
        return False
    return True
