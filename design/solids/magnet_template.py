"""A template that is laid on a face to set its magnets, with the polarity of each engraved.

A plate of the face's size with a hole over every pocket and a lip over two edges that finds the
face. Beside each hole stands + where the magnet's north pole points outward, − where it points
inward; the corner at the face's +x, +y is cut off.
"""

from __future__ import annotations

from itertools import combinations

import cadquery as cq
import numpy as np

from design.body.surface_chart import FaceFrame
from design.layout.body import core_frames, face_frames
from design.layout.mould.frame import play_mm
from design.layout.pockets import Pocket, core_pockets, shell_pockets
from design.solids.primitives import OVERSHOOT_MM, box_between, single_solid
from design.spec.object import ObjectSpec

PLATE_MM = 3.0
LIP_MM = (2.0, 3.0)
MARK_LENGTH_MM = 3.0
MARK_WIDTH_MM = 0.9
MARK_DEPTH_MM = 0.8
MARK_GAP_MM = 1.3
CORNER_MM = 4.0


def template_faces(spec: ObjectSpec) -> dict[int, tuple[int, ...]]:
    """First face → the faces of its size and layout, which one template serves."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for frame, pockets in pockets_by_face(spec):
        alike = [frame.half_extents_mm, *(pocket.body.centre_mm for pocket in pockets)]
        groups.setdefault(tuple(np.concatenate(alike).round(6)), []).append(frame.number)
    return {numbers[0]: tuple(numbers) for numbers in groups.values()}


def make_magnet_template(spec: ObjectSpec, face: int) -> cq.Solid:
    """Template of one face in that face's frame: its underside lies on the face (z = 0), mm.

    Raises
    ------
    InputError
        The dimensions do not give one valid solid.
    """
    frame, pockets = next(pair for pair in pockets_by_face(spec) if pair[0].number == face)
    half = frame.half_extents_mm
    lip, drop, play = *LIP_MM, play_mm(spec)
    body = box_between((-half[0] - play - lip, -half[1] - play - lip, 0.0), (*half, PLATE_MM))
    lips = [
        box_between((-half[0] - play - lip, -half[1] - play - lip, -drop), (-half[0] - play, *_end(half))),
        box_between((-half[0] - play - lip, -half[1] - play - lip, -drop), (half[0], -half[1] - play, 1.0)),
    ]  # fmt: skip
    holes = [_hole(pocket, play) for pocket in pockets]
    marks = [
        bar
        for index, polarity in enumerate(spec.magnets.polarities)
        for bar in _mark(mark_place(pockets, index, half), polarity)
    ]
    return single_solid(body.fuse(*lips).cut(*holes, *marks, _corner(half)), "magnet_template")


def pockets_by_face(spec: ObjectSpec) -> list[tuple[FaceFrame, tuple[Pocket, ...]]]:
    """Each face that magnets are set on, and their pockets."""
    in_shell = spec.arrangement == "sensors-in-core"
    frames = face_frames(spec) if in_shell else core_frames(spec)
    pockets = shell_pockets(spec) if in_shell else core_pockets(spec)
    return list(zip(frames, pockets, strict=True))


def _end(half: tuple[float, float]) -> tuple[float, float]:
    return half[1], 1.0


def _centre(pocket: Pocket) -> np.ndarray:
    """Where the pocket's axis leaves the face."""
    return pocket.body.centre_mm[:2] + pocket.mouth_mm * pocket.axis[:2]


def _hole(pocket: Pocket, play: float) -> cq.Solid:
    x, y = _centre(pocket)
    half = [edge + play for edge in pocket.outline.half_mm]
    height = PLATE_MM + 2 * OVERSHOOT_MM
    if pocket.outline.round:
        base = cq.Vector(x, y, -OVERSHOOT_MM)
        return cq.Solid.makeCylinder(half[0], height, base, cq.Vector(0, 0, 1))
    low = (x - half[0], y - half[1], -OVERSHOOT_MM)
    return box_between(low, (x + half[0], y + half[1], height - OVERSHOOT_MM))


def mark_place(pockets: tuple[Pocket, ...], index: int, half: tuple[float, float]) -> np.ndarray:
    """Beside the hole, in the direction with most room to the other holes and the plate's edge."""
    centres = np.stack([_centre(pocket) for pocket in pockets])
    radii = np.array([pocket.outline.radius_mm for pocket in pockets])
    angle = np.arange(16) * np.pi / 8
    away = radii[index] + MARK_GAP_MM + MARK_LENGTH_MM / 2
    places = centres[index] + away * np.column_stack([np.cos(angle), np.sin(angle)])
    gaps = np.linalg.norm(places[:, None] - centres, axis=2) - radii
    border = (np.asarray(half) - abs(places)).min(axis=1)
    return places[np.argmax(np.round(np.minimum(gaps.min(axis=1), border), 6))]


def _mark(place: np.ndarray, polarity: int) -> list[cq.Solid]:
    """Bars of + or −, cut into the top of the plate."""
    x, y = place
    low, high = PLATE_MM - MARK_DEPTH_MM, PLATE_MM + OVERSHOOT_MM
    return [box_between((x - a, y - b, low), (x + a, y + b, high)) for a, b in _bars(polarity)]


def _bars(polarity: int) -> list[tuple[float, float]]:
    """Half edges of the bars of + or −."""
    long, wide = MARK_LENGTH_MM / 2, MARK_WIDTH_MM / 2
    return [(long, wide), (wide, long)] if polarity > 0 else [(long, wide)]


def thinnest_mark_wall_mm(spec: ObjectSpec) -> float:
    """Wall of the template between a mark and the nearest hole or other mark; ∞ where there is none.

    Marks that meet leave no wall.
    """
    walls, polarities = [np.inf], spec.magnets.polarities
    for frame, pockets in pockets_by_face(spec):
        radius = np.array([pocket.outline.radius_mm for pocket in pockets]) + play_mm(spec)
        centre = np.stack([_centre(pocket) for pocket in pockets])
        bars = [
            (mark_place(pockets, index, frame.half_extents_mm), np.array(half), index)
            for index, polarity in enumerate(polarities)
            for half in _bars(polarity)
        ]
        for place, half, _ in bars:
            beside = (abs(centre - place) - half).clip(min=0)
            walls += (np.linalg.norm(beside, axis=1) - radius).tolist()
        for (a, half_a, of_a), (b, half_b, of_b) in combinations(bars, 2):
            gap = float(np.linalg.norm((abs(a - b) - half_a - half_b).clip(min=0)))
            walls += [gap] if of_a != of_b and gap > 0 else []
    return float(min(walls))


def _corner(half: tuple[float, float]) -> cq.Solid:
    """Triangle at +x, +y."""
    x, y = half[0] + OVERSHOOT_MM, half[1] + OVERSHOOT_MM
    reach = CORNER_MM + 2 * OVERSHOOT_MM
    loop = [cq.Vector(*p, -10.0) for p in ((x, y), (x - reach, y), (x, y - reach))]
    wire = cq.Wire.makePolygon(loop, close=True)
    return cq.Solid.extrudeLinear(wire, [], cq.Vector(0, 0, 20.0))
