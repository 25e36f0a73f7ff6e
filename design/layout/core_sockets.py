"""Sockets of a core that is cast in, where pockets are in the way of its wire holes.

A socket is a round hole in the core, from a place of its surface that no magnet lies over to where it
meets the wire holes, mostly in the middle of the body: a locating pin stands in it while silicone is
poured, and the wires come out through it. Everything here is numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float

from design.body.surface_chart import Cap, FaceFrame
from design.errors import InputError
from design.layout.blocks import core_keys, relief_slits
from design.layout.boards import cuts_of_core, passage_radius_mm
from design.layout.body import body_of, core_frames, face_frames
from design.layout.mould.frame import parting, up
from design.layout.pockets import axis_in_object_mm, core_pockets, shell_pockets
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec

CLEAR_MM = 0.8
"""Silicone between a pin in a socket and a pocket or a slit, at least."""
_ROOMY_MM = 2.5
"""From where on more silicone there is no better: heads of pins then have their rims."""
_PRINTED = 1.25
"""Walls of the core next to a socket, in the printer's thinnest."""
_STEEPEST_DEG = 20.0
"""Lean of the surface against a pin, at most."""
_CROSSING_DEG = 38.0
"""Least angle between a socket and a wire hole that it meets: less leaves knife edges."""
_ASIDE_COS = 0.6
"""Cosine of the angle between two pins, at most: they hold the core from turning."""
_EVEN_MM, _BENT_MM, _RIM = 1e-6, 0.5, 16
"""Depth below a plane that the core may have at a pin's rim, flat and curved; points of the rim."""
_FINEST, _STEPS, _SEAM_MM, OUT_MM = 9, 13, 8.0, 5.0


@dataclass(frozen=True)
class Socket:
    """A hole in the core of `radius_mm` and the pin that stands in it.

    `frame` is flat, its normal along the pin, its centre on the body's surface at the place `xy_mm` of
    the face of that number. The core's surface is `depth_mm` below it, and the hole goes on for
    `length_mm`, to `end_mm`. The surface leans by `lean` (rad) against the pin.
    """

    frame: FaceFrame
    xy_mm: tuple[float, float]
    radius_mm: float
    depth_mm: float
    length_mm: float
    lean: float

    @property
    def end_mm(self) -> Float[np.ndarray, "3"]:
        """Return where the hole meets the wire holes."""
        return self.frame.centre_mm - (self.depth_mm + self.length_mm) * self.frame.normal


@dataclass(frozen=True)
class Ways:
    """Pins that may be, one a row: face, its place, point of the surface, direction, hole's end, lean."""

    face: np.ndarray
    xy_mm: np.ndarray
    start_mm: np.ndarray
    way: np.ndarray
    end_mm: np.ndarray
    lean: np.ndarray

    def select(self, rows: np.ndarray) -> Ways:
        return Ways(*(values[rows] for values in vars(self).values()))

    def points_at(self, heights_mm: np.ndarray) -> Float[np.ndarray, "way step 3"]:
        """Points on the axes at heights (way, step) above the surface."""
        return self.start_mm[:, None] + heights_mm[..., None] * self.way[:, None]


@cached_geometry
def roomiest_sockets(spec: ObjectSpec) -> tuple[Socket, ...]:
    """Two sockets clear of pockets, recesses, keys and each other, the one with most room first.

    One where no second lies well aside of it, none where there is no room. Places in the middles of
    faces that have no sensors are as good as any other.
    """
    sockets = _sockets(spec, ())
    return sockets if not sockets else (*sockets, *_sockets(spec, (sockets[0].frame.normal,)))


def socket_beside(spec: ObjectSpec, way: Float[np.ndarray, "3"]) -> tuple[Socket, ...]:
    """The roomiest socket that is well aside of another pin along `way`; none where there is no room."""
    return _sockets(spec, (way,))


def _sockets(spec: ObjectSpec, other_ways: tuple[np.ndarray, ...]) -> tuple[Socket, ...]:
    radius = spec.core.wire_hole_side_diameter_mm / 2
    ways = ways_to_wires(spec)
    for other_way in other_ways:
        ways = ways.select(abs(ways.way @ other_way) < _ASIDE_COS)
    if not len(ways.face):
        return ()
    depth = core_depth_mm(spec, ways)
    room = room_mm(spec, ways, depth, radius)
    length = np.linalg.norm(ways.start_mm - ways.end_mm, axis=1) - depth
    fits = (depth > 0) & (length > radius) & foot_on_a_face(spec, ways, depth, radius)
    room[~fits] = -np.inf
    best = int(np.argmax(room.round(3)))
    if not room[best] > 0:
        return ()
    frame = flat_frame(int(ways.face[best]), ways.start_mm[best], ways.way[best])
    xy = ways.xy_mm[best]
    place = (float(xy[0]), float(xy[1]))
    return (
        Socket(
            frame, place, radius, float(depth[best]), float(length[best]), float(ways.lean[best])
        ),
    )


def ways_to_wires(spec: ObjectSpec) -> Ways:
    """From places of all faces to where wire holes meet or pass, as square to the surface as can be."""
    targets, axes = wire_targets(spec)
    kept: list[Ways] = []
    for number in body_of(spec).faces:
        try:
            frame = body_of(spec).frame(number)
        except InputError:
            continue
        xy = places_on(frame)
        start, normal = frame.to_object(np.column_stack([xy, 0 * xy[:, 0]])), frame.axes_at(xy)
        way = start[:, None] - targets
        way = way / np.linalg.norm(way, axis=2, keepdims=True)
        # Cosines of the ways with the normal and with wires: p place, t target, k coordinate, a wire
        rise = np.einsum("ptk,pk->pt", way, normal[:, :, 2])
        wire_cosine = np.einsum("ptk,tak->pta", way, axes)
        wire_cosine[:, 1:] = abs(
            wire_cosine[:, 1:]
        )  # in the middle wire holes end, elsewhere they pass
        sharp = np.any(wire_cosine > np.cos(np.deg2rad(_CROSSING_DEG)), axis=2)
        rise = np.where(sharp, -1.0, rise)
        best = np.argmax(rise.round(9), axis=1)
        row = np.arange(len(xy))
        lean = np.arccos(np.clip(rise[row, best], -1, 1))
        ways = Ways(np.full(len(xy), number), xy, start, way[row, best], targets[best], lean)
        kept.append(ways.select(lean < np.deg2rad(_STEEPEST_DEG)))
    if not kept:
        empty = np.zeros((0, 3))
        return Ways(np.zeros(0, int), empty[:, :2], empty, empty, empty, empty[:, 0])
    columns = zip(*(vars(ways).values() for ways in kept), strict=True)
    return Ways(*(np.concatenate(column) for column in columns))


def places_on(frame: FaceFrame) -> Float[np.ndarray, "place 2"]:
    """A lattice over the face, its middle included, less its border."""
    share = np.linspace(-0.95, 0.95, 2 * _FINEST + 1)
    x, y = np.meshgrid(share, share, indexing="ij")
    places = np.column_stack([x.ravel(), y.ravel()]) * frame.half_extents_mm
    places = places[frame.covers(places)]
    nearest_first = np.argsort(np.linalg.norm(places, axis=1), kind="stable")
    return places[nearest_first]


def wire_targets(spec: ObjectSpec) -> tuple[np.ndarray, np.ndarray]:
    """Points on the axes of the wire holes, the body's middle first, and axes that pass each, as unit
    vectors (zeros where fewer pass)."""
    frames = core_frames(spec)
    towards = [frame.centre_mm for frame in frames]
    shares = (0.25, 0.4, 0.55, 0.7)
    points = [np.zeros(3), *(share * end for end in towards for share in shares)]
    passing = np.zeros((len(points), len(towards), 3))
    units = [end / np.linalg.norm(end) for end in towards]
    passing[0] = units
    for index, unit in enumerate(np.repeat(units, len(shares), axis=0), start=1):
        passing[index, 0] = unit
    return np.array(points), passing


def foot_on_a_face(
    spec: ObjectSpec, ways: Ways, depth_mm: np.ndarray, radius_mm: float
) -> Bool[np.ndarray, "way"]:
    """Return where the core's surface is nowhere deeper along a pin's rim than the lean makes it, nor than
    solids cut: a pin that meets an edge of the core goes on next to it."""
    flat = body_of(spec).cuboid
    most = depth_mm + radius_mm * np.tan(ways.lean) + (_EVEN_MM if flat else _BENT_MM)
    side = np.cross(ways.way, np.eye(3)[abs(ways.way).argmin(axis=1)])
    side = side / np.linalg.norm(side, axis=1, keepdims=True)
    fits = np.ones(len(depth_mm), bool)
    for angle in np.linspace(0, 2 * np.pi, _RIM, endpoint=False):
        aside = np.cos(angle) * side + np.sin(angle) * np.cross(ways.way, side)
        shift = radius_mm * aside
        rim = replace(ways, start_mm=ways.start_mm + shift, end_mm=ways.end_mm + shift)
        fits &= core_depth_mm(spec, rim) <= most
    return fits


def core_depth_mm(spec: ObjectSpec, ways: Ways) -> Float[np.ndarray, "way"]:
    """From the body's surface to the core's along each way, by halving."""
    body = body_of(spec)
    low = np.zeros(len(ways.way))
    high = np.linalg.norm(ways.start_mm - ways.end_mm, axis=1)
    for _ in range(40):
        middle = (low + high) / 2
        outside = body.core_distance_mm(ways.start_mm - middle[:, None] * ways.way) > 0
        low, high = np.where(outside, middle, low), np.where(outside, high, middle)
    return (low + high) / 2


def room_mm(
    spec: ObjectSpec, ways: Ways, depth_mm: np.ndarray, radius_mm: float
) -> Float[np.ndarray, "way"]:
    """Silicone left next to each pin beyond the least, less what speaks against the place; −∞: no room."""
    share = np.linspace(0, 1, _STEPS)
    reach = spec.mould.wall_mm + OUT_MM
    outer = ways.points_at(-depth_mm[:, None] + share * (depth_mm + reach)[:, None])
    length = np.linalg.norm(ways.start_mm - ways.end_mm, axis=1) - depth_mm
    within = ways.points_at(-depth_mm[:, None] - share * length[:, None])
    room = np.full(len(depth_mm), _ROOMY_MM)
    for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True):
        for pocket in pockets:
            ends = axis_in_object_mm(frame, pocket)
            pocket_axis = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
            away = segment_distance_mm(outer, np.stack([ends[0], ends[1] + reach * pocket_axis]))
            room = np.minimum(room, away - pocket.outline.radius_mm - radius_mm - CLEAR_MM)
    for block in (*relief_slits(spec), *core_keys(spec)):
        room = np.minimum(room, block.distance_mm(outer).min(axis=1) - radius_mm - CLEAR_MM)
    wall = _PRINTED * spec.printer.wall_mm
    for block in cuts_of_core(spec):
        room = np.where(block.distance_mm(within).min(axis=1) > radius_mm + wall, room, -np.inf)
    for frame, pockets in zip(core_frames(spec), core_pockets(spec), strict=True):
        for pocket in pockets:
            ends = axis_in_object_mm(frame, pocket)
            clear = segment_distance_mm(within, ends) - pocket.outline.radius_mm > radius_mm + wall
            room = np.where(clear, room, -np.inf)
    core = ways.points_at(-depth_mm[:, None])[:, 0]
    for frame in core_frames(spec):
        hole = passage_radius_mm(spec)
        away = np.linalg.norm(core - frame.centre_mm, axis=1)
        room = np.where(away > radius_mm + hole + wall, room, -np.inf)
    room = np.where(off_pour(spec, ways, radius_mm), room, -np.inf)
    plane = parting(spec)
    aside = abs(ways.start_mm @ plane.normal - plane.offset_mm) - radius_mm
    seam = np.clip(1 - aside / _SEAM_MM, 0, None)
    return room - 0.3 * seam - 0.5 * ways.lean


def off_pour(spec: ObjectSpec, ways: Ways, radius_mm: float) -> np.ndarray:
    """Clear of the pouring hole, which is where a closed mould's corner is highest."""
    needed = radius_mm + spec.mould.pour_mm / 2 + 2 * spec.mould.wall_mm
    high = ways.start_mm @ up(spec)
    corner = float(np.max(high))
    across = ways.start_mm - high[:, None] * up(spec)
    top = across[int(np.argmax(high))]
    return (np.linalg.norm(across - top, axis=1) > needed) | (high < corner / 2)


def segment_distance_mm(points_mm: np.ndarray, ends_mm: np.ndarray) -> Float[np.ndarray, "way"]:
    """Least distance of each way's points (way, step, 3) from a straight piece."""
    piece = ends_mm[1] - ends_mm[0]
    share = np.clip((points_mm - ends_mm[0]) @ piece / (piece @ piece), 0, 1)
    return np.linalg.norm(points_mm - ends_mm[0] - share[..., None] * piece, axis=2).min(axis=1)


def flat_frame(face: int, centre_mm: np.ndarray, way: np.ndarray) -> FaceFrame:
    side = np.eye(3)[int(abs(way).argmin())]
    x = np.cross(side, way)
    x = x / np.linalg.norm(x)
    return FaceFrame(face, way, x, np.cross(way, x), centre_mm, (1.0, 1.0), Cap())
