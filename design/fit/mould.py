"""Fit of the mould: whether it can be one, and its pins clear of each other and of what closes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import islice
from math import ceil
from typing import TYPE_CHECKING

from design.errors import InputError
from design.fit.magnet_places import (
    MEETING_MM3,
    MOST_TOLD,
    Placed,
    common_mm3,
    flange_solids,
    head_is_clear,
    moved_pin,
    nearest_inwards,
    placed_pockets,
    pockets_off_patches,
)
from design.layout.body import face_frame
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import mould_style, opening_of
from design.layout.mould.pins import Pin, loose_pins
from design.layout.mould.pouring import LEAST_POUR_MM, pins_of, pour_holes
from design.layout.pockets import Pocket, near_pairs

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec


def check_mould(spec: ObjectSpec, ways: bool = True) -> Iterator[str]:
    """Parts that cannot be moulded, what was given and how to fix it; unless `ways` without places and
    widths that are looked for."""
    opening = opening_of(spec)
    if spec.mould.style == "one-piece" and opening != "open":
        yield (
            f'mould.style = "one-piece" needs a whole side of the body open; this {spec.body.kind} has '
            f'body.open_faces = {list(spec.body.opened)}. Use "split", or leave the style out'
        )
    elif mould_style(spec) == "split" and spec.silicone.cure != "none":
        if pockets_off_patches(spec):
            return  # told with the patches: where such pins stand is not known
        yield from _check_closure(spec, ways)
        yield from check_pins_apart(spec)
        if why_no_mould(spec) is None:
            yield from check_pouring(spec, ways)


def _check_closure(spec: ObjectSpec, ways: bool = True) -> Iterator[str]:
    """Heads of pins and the flange of a plug or a rod, which reaches over the mould's walls."""
    flange = flange_solids(spec)
    for pin in loose_pins(spec) if flange else ():
        volume = common_mm3(pin.head(), flange)
        if volume > MEETING_MM3:
            label = pin.pocket.body.label
            alike = [place for place in placed_pockets(spec) if place[1].body.label == label]
            clear = partial(head_is_clear, spec, flange)
            yield (
                f"the head of the pin of {label} of face {pin.frame.number} stands {volume:.2g} mm³ in the "
                "flange by which the mould's rod or plug hangs over its walls. "
                f"{_place_for_magnet(alike, clear) if ways else ''}"
            )


def _place_for_magnet(placed: Sequence[Placed], works: Callable[[FaceFrame, Pocket], bool]) -> str:
    """Return where a magnet of these faces is to go, so that its pins work."""
    place = nearest_inwards(placed, works)
    if place is None:
        return "Leave the magnet out, or the face with body.sensed_faces"
    return f"Move the magnet inwards, as to ({place[0]:.4g}, {place[1]:.4g})"


def check_pins_apart(spec: ObjectSpec) -> Iterator[str]:
    """Beyond the silicone, where pins of a hollow lean towards each other."""
    pins = loose_pins(spec)
    near = near_pairs([pin.axis_mm for pin in pins], [pin.radius_mm + pin.rim_mm for pin in pins])
    for index_a, index_b, _ in islice(near, MOST_TOLD**2):
        a, b = pins[index_a], pins[index_b]
        volume = common_mm3(a.room(), [b.room()])
        if volume > MEETING_MM3:
            yield (
                f"the pins of {a.pocket.body.label} of face {a.frame.number} and "
                f"{b.pocket.body.label} of face {b.frame.number} share {volume:.2g} mm³ beyond the "
                "silicone, so that the mould cannot close. Move their magnets apart, or leave a face out "
                "with body.sensed_faces"
            )


def check_pouring(spec: ObjectSpec, ways: bool = True) -> Iterator[str]:
    """Holes to pour through, of the mould and of the seal layer's."""
    for first in (True, False) if spec.shell.seal_layer_mm else (True,):
        try:
            pour_holes(spec, first)
        except InputError as error:
            yield f"{error}. {_pour_advice(spec, first) if ways else ''}"
            return


def _pour_advice(spec: ObjectSpec, first: bool) -> str:
    """The widest holes that find room, else the place of the one magnet that is in the way."""
    width = _widest_mm(spec, first)
    if width is not None:
        return f"mould.pour_mm = {width:g} finds room"
    pins = pins_of(spec, first)
    for index, pin in enumerate(pins):
        others = (*pins[:index], *pins[index + 1 :])
        if pin.locator is None and _is_poured(spec, first, others):
            placed = [(face_frame(spec, pin.frame.number), pin.pocket)]
            way = _place_for_magnet(placed, partial(_is_poured_beside, spec, first, others))
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


def _is_poured_beside(
    spec: ObjectSpec, first: bool, others: tuple[Pin, ...], frame: FaceFrame, pocket: Pocket
) -> bool:
    pin = moved_pin(spec, frame, pocket)
    return pin is not None and _is_poured(spec, first, (*others, pin))


def _is_poured(spec: ObjectSpec, first: bool, pins: tuple[Pin, ...]) -> bool:
    try:
        pour_holes(spec, first, pins)
    except InputError:
        return False
    return True
