"""Faults of a split mould's seam that `check --fabrication` fails on, reported before anything is built.

Such an object fits together and can be simulated, but its mould has thin walls or does not come off.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import pairwise

import numpy as np
from jaxtyping import Float

from design.body.triangles import Block
from design.errors import InputError
from design.layout.blocks import relief_slits
from design.layout.body import body_of
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import (
    COMPLIANCE_FRACTION,
    Parting,
    mould_frame,
    mould_style,
    opening_of,
    parting,
    undercut_depth_mm,
    wall_to_plane_mm,
)
from design.layout.mould.pins import Pin, pin_holes, pins_thin_the_seam
from design.layout.mould.pouring import (
    Hole,
    hole_thins_the_seam,
    hole_within_mould,
    pins_of,
    pour_holes,
    thin_beside_others,
)
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec

_FAILS = "check --fabrication fails on it"
_ALONG_THE_SEAM = 1e-9
_AZIMUTHS_DEG = np.arange(0.0, 180.0, 3.0)
"""Azimuths of seams that are tried, until one does neither."""
_WINDOW_STEP_DEG, _MOST_WINDOWS = 1.5, 6
"""Step at which windows between pins are sought where none of these helps (degrees), and how many of them are
tried: those of nine magnets on each face are a few degrees wide."""


def seam_in_words(spec: ObjectSpec) -> list[str]:
    """Thin walls between the seam and holes of pins, or next to holes to pour through, and halves or fins of
    slits that hook, with places and the nearest `mould.parting_azimuth_deg` that has none of them; of a
    specification that fits."""
    wrong, hooking = _faults(spec)
    if not (wrong or hooking):
        return []
    better = _nearest_azimuth(spec)
    if better is None:
        way = f"No azimuth of the seam does without: {_seamless_advice(spec)}"
        messages = [f"{fault}; {_FAILS}. {way}" for fault in wrong]
        return messages + [f"{fault}; {_FAILS}. {_finless_advice(spec)}" for fault in hooking]
    way = f"A seam with mould.parting_azimuth_deg = {better:g} does without"
    return [f"{fault}; {_FAILS}. {way}" for fault in (*wrong, *hooking)]


def better_azimuth(spec: ObjectSpec) -> float | None:
    """Return the nearest `mould.parting_azimuth_deg` without the faults of this seam; None where it has
    none, or no seam is without."""
    return _nearest_azimuth(spec) if any(_faults(spec)) else None


def seam_azimuth_deg(spec: ObjectSpec) -> float:
    """Return the azimuth of a split mould's seam, given or chosen."""
    plane, frame = parting(spec), mould_frame(spec)
    return float(
        np.rad2deg(np.arctan2(plane.normal @ frame.length_axis, plane.normal @ frame.across))
    )


def windows_deg(spec: ObjectSpec) -> list[float]:
    """Return azimuths in the middle of the widest windows in which no pin's hole thins the seam."""
    azimuths = seam_azimuth_deg(spec) + np.arange(-90.0, 90.0, _WINDOW_STEP_DEG)
    is_thin = [pins_thin_the_seam(_turned(spec, azimuth)) for azimuth in azimuths.tolist()]
    thin = np.flatnonzero([True, *is_thin, True]) - 1
    windows = sorted(((b - a, (a + b) // 2) for a, b in pairwise(thin) if b > a + 1), reverse=True)
    return [round(float(azimuths[k]), 1) for _, k in windows[:_MOST_WINDOWS]]


def _azimuths_deg(spec: ObjectSpec) -> Iterator[float]:
    """Yield azimuths in even steps, the nearest to the seam first, then those of windows between pins."""
    away = abs((_AZIMUTHS_DEG - seam_azimuth_deg(spec) + 90.0) % 180.0 - 90.0)
    yield from _AZIMUTHS_DEG[np.argsort(away, kind="stable")].tolist()
    with suppress(InputError):
        yield from windows_deg(spec)


def _turned(spec: ObjectSpec, azimuth_deg: float) -> ObjectSpec:
    return spec.changed(mould=spec.mould.changed(parting_azimuth_deg=azimuth_deg))


def _faults(spec: ObjectSpec) -> tuple[list[str], list[str]]:
    """Return what is wrong with the seam, and which fins hook; nothing of a mould without a seam."""
    if mould_style(spec) != "split" or spec.silicone.cure == "none" or why_no_mould(spec):
        return [], []
    return [*_thin(spec), *_thin_pouring(spec), *_hooked(spec)], [*_hooking_fins(spec)]


def _thin(spec: ObjectSpec) -> Iterator[str]:
    least = spec.printer.wall_mm
    thin_walls = [
        (wall, place, pin) for wall, place, pin, whole in _walls(spec) if whole and wall < least
    ]
    if not thin_walls:
        return
    wall, place, pin = min(thin_walls, key=lambda thin_wall: thin_wall[0])
    label, face = pin.pocket.body.label, f"face {pin.frame.number}: "
    what = label if label.startswith(face) else f"{face}{label}"
    remainder = "a wall that ends in nothing" if wall == 0 else f"a wall of {wall:.2g} mm"
    yield (
        f"the mould's seam leaves {remainder} beside the hole for the pin of {what}, at "
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


def _thin_pouring(spec: ObjectSpec) -> Iterator[str]:
    """Yield where no place of the pouring holes is free of them."""
    for hole in _thin_pour_holes(spec)[:1]:
        place = ", ".join(f"{x:.1f}" for x in hole_within_mould(spec, hole)[1])
        yield (
            f"wherever the mould's pouring holes (mould.pour_mm = {spec.mould.pour_mm:g}) are clear of "
            f"pins, they leave a wall thinner than {spec.printer.wall_mm:g} mm to the seam, a side of its "
            f"flange or another hole, as at ({place})"
        )


def _thin_pour_holes(spec: ObjectSpec) -> list[Hole]:
    pins = pins_of(spec, first=True)
    return [
        hole
        for hole in pour_holes(spec)
        if hole_thins_the_seam(spec, hole) or thin_beside_others(spec, hole, pins)
    ]


def _hooked(spec: ObjectSpec) -> Iterator[str]:
    depth, room = undercut_depth_mm(spec), _room_mm(spec)
    if depth > room:
        beside = "" if body_of(spec).from_file else ": the seam is not along the body's sides"
        yield (
            f"the mould's halves hook the body by about {depth:.2g} mm, and the silicone gives way by "
            f"{room:.2g} mm{beside}"
        )


def _seamless_advice(spec: ObjectSpec) -> str:
    """Return what else helps where the seam cannot be turned."""
    if body_of(spec).from_file and undercut_depth_mm(spec) > _room_mm(spec):
        return "turn the body in its file so that both halves come off level"
    return "move magnets, or choose another mould.style"


def _hooking_fins(spec: ObjectSpec) -> Iterator[str]:
    fins = [(depth, slit) for depth, slit in _fins(spec, parting(spec)) if depth > _room_mm(spec)]
    if not fins:
        return
    depth, slit = max(fins, key=lambda fin: fin[0])
    place = ", ".join(f"{x:.1f}" for x in slit.centre_mm)
    yield (
        f"fins that form {len(fins)} of {len(relief_slits(spec))} slits hook the halves of the mould, as by "
        f"about {depth:.2g} mm at ({place}), and the silicone gives way by {_room_mm(spec):.2g} mm"
    )


def _fins(spec: ObjectSpec, plane: Parting) -> Iterator[tuple[float, Block]]:
    """Yield by how much every slit's fin moves the silicone aside, until it is out, when a half is drawn; one
    that is drawn across its own side, or that the seam splits, by its whole depth."""
    deep = spec.shell.slits.depth_mm
    for slit in relief_slits(spec):
        _, inward, across = slit.axes.T
        aside, outward = abs(plane.normal @ across), abs(plane.normal @ inward)
        yield deep * float(min(1.0, aside / max(outward, _ALONG_THE_SEAM))), slit


def _finless_advice(spec: ObjectSpec) -> str:
    one_piece = 'choose mould.style = "one-piece"'
    way = one_piece if opening_of(spec) == "open" else "open a side of the body (body.open_faces)"
    return f"Leave shell.slits.depth_mm out and cut the slits after casting, or {way}"


def _room_mm(spec: ObjectSpec) -> float:
    return COMPLIANCE_FRACTION * spec.shell.thickness_mm


@cached_geometry
def _nearest_azimuth(spec: ObjectSpec) -> float | None:
    """Return the seam turned least that leaves walls and hooks no deeper than the silicone allows; one in a
    window between pins where the steps miss all."""
    room = _room_mm(spec)
    for azimuth in _azimuths_deg(spec):
        turned = _turned(spec, azimuth)
        if any(depth > room for depth, _ in _fins(spec, parting(turned))):
            continue
        try:
            thin = any(wall < spec.printer.wall_mm for wall, *_ in _walls(turned))
            thin = thin or bool(_thin_pour_holes(turned))
        except InputError:
            continue
        if not thin and undercut_depth_mm(turned) <= room:
            return azimuth
    return None
