"""Hold of a core that is cast in: by a rod through its bore, or by pins through its wire holes.

Where pockets are in the way of the wire holes, pins stand in sockets of their own.

Everything here is numbers. A rod has a flat on its nose, and the core's outlet one that meets it, so
that the core cannot turn. Pins leave holes in the silicone, from the core to the outside (or to the
floor of the pocket in the face's middle), through which the wires come out; they are filled last.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import Cap, FaceFrame
from design.layout.boards import (
    bay_block,
    count_wires,
    hole_for_wires_mm,
    wire_hole_diameter_mm,
)
from design.layout.body import body_of, core_frames, face_frames
from design.layout.core_sockets import Socket, roomiest_sockets, socket_beside
from design.layout.mould.frame import opening_of
from design.layout.pockets import Pocket, shell_pockets
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

FLAT_SHARE = 0.7
"""Distance of the outlet's flat from its axis, of its radius."""
NOSE_MM = 4.0
"""Length of the rod's nose beyond the core's wall."""
LOCATOR_NOSE_MM = 6.0
LOCATOR_GAP_MM = 0.8
"""Between a locating pin and a pocket that it does not go through, at least."""
_LEVEL = 0.02
"""Lean of the surface in the middle of a face (rad) below which a pin and a pocket there are one."""
LEAST_FLOOR = 0.3
"""Share of a pocket's floor that a locating pin leaves for the magnet to rest on, at least."""


@dataclass(frozen=True)
class Locator:
    """A pin through the silicone into a hole of the core: the wire hole in the middle of a face, or a
    `socket`.

    `frame` is flat: its normal is the line through the middles of the face and of the core's, also where
    the surface leans there. `depth_mm` is the depth of the core below the face, and its hole is `hole_mm`
    deep; `pockets` are the ones that the pin meets, and with whose pins it is one.
    """

    frame: FaceFrame
    radius_mm: float
    depth_mm: float
    hole_mm: float
    pockets: tuple[Pocket, ...] = ()
    socket: Socket | None = None

    @property
    def place(self) -> tuple[int, float, float]:
        """Face, and x and y (mm) in that face's frame."""
        x, y = (0.0, 0.0) if self.socket is None else self.socket.xy_mm
        return self.frame.number, x, y

    @property
    def rise_mm(self) -> float:
        """Rise of a leaning surface next to the pin, per mm."""
        return 0.0 if self.socket is None else float(np.tan(self.socket.lean))

    @property
    def volume_mm3(self) -> float:
        """Volume of silicone that is missing besides the pockets; exact on flat faces."""
        met = sum(
            common_area_mm2(self.radius_mm, pocket) * -float(pocket.axis_ends_mm[0, 2])
            for pocket in self.pockets
        )
        return float(np.pi * self.radius_mm**2 * self.depth_mm - met)


@dataclass(frozen=True)
class Outlet:
    """The core's hole to its bore, about −z: radius, level of the core's surface on its axis, and
    how far the wall reaches that carries the flat, mm. The flat is at x = `flat_mm`."""

    radius_mm: float
    floor_mm: float
    wall_mm: float

    @property
    def flat_mm(self) -> float:
        return FLAT_SHARE * self.radius_mm

    @property
    def key_mm(self) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
        """Corners of the box that stays of the core's wall within the outlet."""
        past = self.radius_mm + 1.0
        low = np.array([self.flat_mm, -past, self.floor_mm - past])
        return low, np.array([past, past, self.floor_mm + self.wall_mm])

    @property
    def nose_mm(self) -> float:
        """Level of the nose's tip."""
        return self.floor_mm + min(self.wall_mm + NOSE_MM, 0.8 * abs(self.floor_mm))


@cached_geometry
def core_outlet(spec: ObjectSpec) -> Outlet:
    """Outlet of a body that is open through a bore; the wall is at most half of the core."""
    floor = body_of(spec).core_floor_mm
    radius = min(spec.body.bore_mm / 2, 0.9 * abs(floor))
    return Outlet(radius, floor, min(spec.core.wall_mm, 0.5 * abs(floor)))


def least_bore_mm(spec: ObjectSpec) -> float:
    """Bore whose outlet takes all wires: they lie between its flat and the side across from it."""
    return 2 * hole_for_wires_mm(count_wires(spec), spec) / (1 + FLAT_SHARE)


@cached_geometry
def locators(spec: ObjectSpec) -> tuple[Locator, ...]:
    """Two pins at right angles that hold the core of a closed body, one where there is no second.

    Wide wire holes go before narrow ones. A pocket that the pin meets must have its direction, and be
    round or hold all of it, and keep `LEAST_FLOOR` of its floor; else the face is left out, and a pin
    that is missing stands in a socket, as do both where a layer is poured over the pockets later.
    """
    if opening_of(spec) != "closed":
        return ()
    cores = {frame.number: frame for frame in core_frames(spec)}
    fit = [
        locator
        for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
        if (locator := locator_in(spec, frame, cores[frame.number], pockets)) is not None
        and not (locator.pockets and spec.shell.seal_layer_mm)
    ]
    fit.sort(key=lambda locator: (-locator.radius_mm, locator.frame.number))
    if not fit:
        return tuple(map(_locator_in_socket, roomiest_sockets(spec)))
    second = [l for l in fit[1:] if abs(l.frame.normal @ fit[0].frame.normal) < 0.5]
    beside = second or map(_locator_in_socket, socket_beside(spec, fit[0].frame.normal))
    return (fit[0], *list(beside)[:1])


def _locator_in_socket(socket: Socket) -> Locator:
    return Locator(socket.frame, socket.radius_mm, socket.depth_mm, socket.length_mm, socket=socket)


def has_mould(spec: ObjectSpec) -> bool:
    """Return whether a mould can be made for the body."""
    return why_no_mould(spec) is None


def why_no_mould(spec: ObjectSpec) -> str | None:
    """Return what keeps the object from being cast in a mould of ours; None where nothing does."""
    if opening_of(spec) == "closed" and not locators(spec) and spec.shell.seal_layer_mm:
        return (
            "a layer is poured round a closed body while pins hold its core beside the magnets, and "
            "pockets leave no room for one. Leave shell.seal_layer_mm out and fill the pockets, move the "
            "magnets, or open face 6"
        )
    if opening_of(spec) == "closed" and not locators(spec):
        return (
            "no side of the body is open, pockets are in the way of every wire hole and leave no room for "
            "a pin beside them, so that nothing can hold the core in the mould. Move a face's pockets "
            "away from its middle, or exactly onto it where the surface does not lean there, make "
            "core.wire_hole_side_diameter_mm smaller, or open face 6"
        )
    return None


def locator_in(
    spec: ObjectSpec, frame: FaceFrame, core: FaceFrame, pockets: tuple[Pocket, ...]
) -> Locator | None:
    radius = wire_hole_diameter_mm(spec, frame.number) / 2
    depth = float((frame.centre_mm - core.centre_mm) @ frame.normal)
    lean = float(np.linalg.norm(frame.axes_at(np.zeros(2))[:, 2] - frame.normal))
    clear, met = radius + LOCATOR_GAP_MM + lean * depth, []
    for pocket in pockets:
        away = _away_mm(pocket)
        if pocket.axis[2] == 1 and away > clear + pocket.outline.radius_mm:
            continue
        parallel = pocket.axis[2] == 1 and (frame.flat or (away == 0 and lean < _LEVEL))
        within = away + radius <= min(pocket.outline.half_mm)
        if not parallel or not (pocket.outline.round or within):
            return None
        if common_area_mm2(radius, pocket) > (1 - LEAST_FLOOR) * pocket.outline.area_mm2:
            return None
        met.append(pocket)
    # A pin's nose stays in the wall of a bay, where the board and the battery lie already.
    bay = bay_block(spec)
    room = 0.0 if bay is None else float(np.abs(frame.normal) @ bay.half_mm)
    hole = float(frame.centre_mm @ frame.normal) - depth - room
    return Locator(replace(frame, relief=Cap()), radius, depth, hole, tuple(met))


def _away_mm(pocket: Pocket) -> float:
    return float(np.hypot(*pocket.body.centre_mm[:2]))


def common_area_mm2(radius_mm: float, pocket: Pocket) -> float:
    """Common area of the pin's section and a pocket's: the lens of two circles, or all of the pin."""
    r, away, radius_b = radius_mm, _away_mm(pocket), pocket.outline.half_mm[0]
    if away + r <= min(pocket.outline.half_mm):
        return float(np.pi * r**2)
    if away >= r + radius_b:
        return 0.0
    if away + radius_b <= r:
        return pocket.outline.area_mm2
    x = (away**2 + r**2 - radius_b**2) / (2 * away)
    sectors = r**2 * np.arccos(x / r) + radius_b**2 * np.arccos((away - x) / radius_b)
    return float(sectors - away * np.sqrt(r**2 - x**2))
