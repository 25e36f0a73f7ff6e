"""A mould in two halves with loose pins for bosses, so that nothing is torn when it opens.

The parting plane contains the z axis; each half draws away along the plane's normal, after the
pins, each of which draws outwards along its own axis. By default the seam of a box runs along two
of its edges and every side wall leaves with plenty of draft. Tapered dowels on the
flanges find the halves, bolts or clamps outside them hold them together, and the plug of the
one-piece mould clips onto the same tabs.
"""

from __future__ import annotations

import cadquery as cq
import numpy as np

from design.layouts import FaceFrame, face_frames
from design.mould import CLIP_REACH_MM, fins_to_walls, play_mm, walls
from design.pockets import Pocket, shell_pockets
from design.shell import cast_envelope
from design.solids import OVERSHOOT_MM, box_between, pocket_prism, single_solid
from design.spec import ObjectSpec

FLANGE_THICKNESS_MM = 4.0
DOWEL_DIAMETER_MM = 4.0
DOWEL_HEIGHT_MM = 2.5
BOLT_HOLE_MM = 3.4
PIN_HEAD_MM = 2.0
PIN_HEAD_RIM_MM = 1.5


def make_mould_half(spec: ObjectSpec, side: int) -> cq.Solid:
    """The half on the side (1 or −1) of the parting plane that its normal points to, mm.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    room = cast_envelope(spec)
    outer = walls(spec, room).fuse(_flange(spec).cut(room), *fins_to_walls(spec))
    holes = [hole for place in _places(spec) for hole in _pin_holes(spec, *place)]
    half = outer.cut(*holes, *_bolt_holes(spec)).intersect(_half_space(spec, side))
    dowels = [_dowel(spec, *place, grow_mm=0.0) for place in _dowel_places(spec)]
    sockets = [_dowel(spec, *place, grow_mm=play_mm(spec)) for place in _dowel_places(spec)]
    joined = half.fuse(*dowels) if side > 0 else half.cut(*sockets)
    return single_solid(joined, "mould_half_a" if side > 0 else "mould_half_b")


def mould_pins(spec: ObjectSpec) -> list[cq.Solid]:
    """A pin for every pocket, face by face, in the object's frame.

    Raises
    ------
    InputError
        A pin is not one valid solid.
    """
    return [make_pin(spec, frame, pocket) for frame, pocket in _places(spec)]


def distinct_pins(spec: ObjectSpec) -> list[tuple[int, int]]:
    """Index of the first pin of each kind among `mould_pins`, and how many are alike.

    Pins are alike where outline, depth and tilt of their pockets are.
    """
    kinds: dict[tuple[float, ...], list[int]] = {}
    for index, (_, pocket) in enumerate(_places(spec)):
        shape = (*pocket.outline.half_mm, *pocket.axis_ends_mm[:, 2], *pocket.axis)
        kinds.setdefault(tuple(np.round(shape, 6)), []).append(index)
    return [(members[0], len(members)) for members in kinds.values()]


def make_pin(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket) -> cq.Solid:
    """Boss, shank through the wall, and a head that rests on the wall's outside."""
    top = spec.mould.wall_mm
    shank = pocket_prism(frame, pocket, None, top + OVERSHOOT_MM)
    head = pocket_prism(frame, pocket, top, top + PIN_HEAD_MM, PIN_HEAD_RIM_MM)
    return single_solid(shank.fuse(head), "mould_pin")


def parting_normal(spec: ObjectSpec) -> np.ndarray:
    """Unit normal of the parting plane: half A draws along it, half B against it."""
    given, (x, y, _) = spec.mould.parting_azimuth_deg, spec.body.size_mm
    azimuth = np.arctan2(x, y) if given is None else np.deg2rad(given)
    return np.array([np.cos(azimuth), np.sin(azimuth), 0.0])


def _places(spec: ObjectSpec) -> list[tuple[FaceFrame, Pocket]]:
    faces = zip(face_frames(spec), shell_pockets(spec), strict=True)
    return [(frame, pocket) for frame, face in faces for pocket in face]


def _pin_holes(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket) -> tuple[cq.Solid, cq.Solid]:
    """Hole through the wall, and room for the head where a flange would be in its way."""
    low, top = -spec.shell.seal_layer_mm - OVERSHOOT_MM, spec.mould.wall_mm
    high, play = top + PIN_HEAD_MM + spec.mould.flange_mm, play_mm(spec)
    return (
        pocket_prism(frame, pocket, low, top + OVERSHOOT_MM, play),
        pocket_prism(frame, pocket, top, high, PIN_HEAD_RIM_MM + play),
    )


def _parting_plane(spec: ObjectSpec) -> cq.Plane:
    """x across the mould in the parting plane, y upwards against z, normal as `parting_normal`."""
    normal = parting_normal(spec)
    across = np.cross(normal, [0.0, 0.0, 1.0])
    return cq.Plane(cq.Vector(0, 0, 0), cq.Vector(*across), cq.Vector(*normal))


def _in_plane(spec: ObjectSpec, low: list[float], high: list[float]) -> cq.Solid:
    """Box given across, along −z and along the normal."""
    return box_between(low, high).moved(cq.Location(_parting_plane(spec)))


def _reach(spec: ObjectSpec) -> tuple[float, float, float]:
    """Half width of the walls across the parting plane, and their levels from top to rim, −z."""
    half = np.asarray(spec.body.size_mm) / 2
    outer = half + spec.mould.wall_mm
    across = np.cross(parting_normal(spec), [0.0, 0.0, 1.0])
    inside = float(np.min(outer[:2] / np.maximum(abs(across[:2]), 1e-9)))
    return inside, -float(outer[2]), float(half[2]) - CLIP_REACH_MM - 2 * play_mm(spec)


def _flange(spec: ObjectSpec) -> cq.Solid:
    """Both halves' flanges along the seam, clear of the plug's clips."""
    inside, top, bottom = _reach(spec)
    wide = inside + spec.mould.flange_mm
    return _in_plane(spec, [-wide, top, -FLANGE_THICKNESS_MM], [wide, bottom, FLANGE_THICKNESS_MM])


def _half_space(spec: ObjectSpec, side: int) -> cq.Solid:
    reach = 4 * max(spec.body.size_mm) + 4 * spec.mould.flange_mm
    low, high = (0.0, reach) if side > 0 else (-reach, 0.0)
    return _in_plane(spec, [-reach, -reach, low], [reach, reach, high])


def _flange_points(spec: ObjectSpec, shares: tuple[float, float]) -> list[tuple[float, float]]:
    """Points in the middle of both flanges, at two shares of their length."""
    inside, top, bottom = _reach(spec)
    across = inside + spec.mould.flange_mm / 2
    levels = [top + share * (bottom - top) for share in shares]
    return [(side * across, level) for side in (-1, 1) for level in levels]


def _dowel_places(spec: ObjectSpec) -> list[tuple[float, float]]:
    return _flange_points(spec, (0.15, 0.7))


def _dowel(spec: ObjectSpec, across: float, level: float, grow_mm: float) -> cq.Shape:
    """Cone from half A into half B, tapered by the draft."""
    root, height = DOWEL_DIAMETER_MM / 2 + grow_mm, DOWEL_HEIGHT_MM + grow_mm
    tip = root - height * float(np.tan(np.deg2rad(spec.mould.dowel_draft_deg)))
    start, along = cq.Vector(across, level, OVERSHOOT_MM), cq.Vector(0, 0, -1)
    stem = cq.Solid.makeCylinder(root, OVERSHOOT_MM, start, along)
    end = cq.Vector(across, level, 0)
    cone = (
        cq.Solid.makeCone(root, tip, height, end, along)
        if tip < root
        else cq.Solid.makeCylinder(root, height, end, along)
    )
    return stem.fuse(cone).moved(cq.Location(_parting_plane(spec)))


def _bolt_holes(spec: ObjectSpec) -> list[cq.Solid]:
    long, along = 2 * FLANGE_THICKNESS_MM + 2 * OVERSHOOT_MM, cq.Vector(0, 0, 1)
    return [
        cq.Solid.makeCylinder(
            BOLT_HOLE_MM / 2, long, cq.Vector(across, level, -long / 2), along
        ).moved(cq.Location(_parting_plane(spec)))
        for across, level in _flange_points(spec, (0.42, 0.9))
    ]
