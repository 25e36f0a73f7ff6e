"""Fit of the mould: whether it can be one, and its pins clear of each other and of what closes it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from design.layout.body import face_frames
from design.layout.mould_closure import flange_corners_mm
from design.layout.mould_frame import mould_style, opening_of
from design.layout.mould_pins import Pin, least_rim_mm, loose_pins, pin_of, rim_below_clips_mm
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


def _check_closure(spec: ObjectSpec) -> Iterator[str]:
    """Heads of pins and the flange of a plug or a rod, which reaches over the mould's walls."""
    flange = _flange(spec)
    for pin in loose_pins(spec) if flange else ():
        volume = _common_mm3(pin.head(), flange)
        if volume > _MEETING_MM3:
            yield (
                f"the head of the pin of {pin.pocket.body.label} of face {pin.frame.number} stands "
                f"{volume:.2g} mm³ in the flange by which the mould's rod or plug hangs over its walls. "
                f"{_where_clear(spec, pin, flange)}"
            )


def _flange(spec: ObjectSpec) -> list[Manifold]:
    from manifold3d import Manifold

    return [
        Manifold.cube(tuple(high - low)).translate(tuple(low))
        for low, high in flange_corners_mm(spec)
    ]


def _common_mm3(solid: Manifold, others: list[Manifold]) -> float:
    return max(float((solid ^ other).volume()) for other in others)


def _where_clear(spec: ObjectSpec, pin: Pin, flange: list[Manifold]) -> str:
    """The first place on a magnet's way to the middle of its face where the head is clear, with no
    less of a rim than the printer makes."""
    frame = next(frame for frame in face_frames(spec) if frame.number == pin.frame.number)
    x, y, height = pin.pocket.body.centre_mm
    for share in np.linspace(1, 0, _STEPS)[1:]:
        centre = np.array([share * x, share * y, height])
        pocket = replace(pin.pocket, body=replace(pin.pocket.body, centre_mm=centre))
        moved = pin_of(spec, frame.tangent(centre[:2]), pocket)
        rim = rim_below_clips_mm(spec, [moved])
        head = replace(moved, rim_mm=rim).head()
        if rim >= least_rim_mm(spec) and _common_mm3(head, flange) <= _MEETING_MM3:
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
