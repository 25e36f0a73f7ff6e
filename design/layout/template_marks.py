"""Marks of polarity on a template that sets magnets: where they stand, and the walls next to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import core_frames, face_frames
from design.layout.pockets import Pocket, core_pockets, shell_pockets
from design.spec.object import ObjectSpec

MARK_LENGTH_MM = 3.0
MARK_WIDTH_MM = 0.9
MARK_GAP_MM = 1.3
CORNER_MM = 4.0
"""Cut off a template at the face's +x, +y."""
_ANGLES, _CLOSER_MM, _ROUNDS = 32, (0.0, 0.25), 6
"""Number of places that are tried where marks stand too close: round a hole, by how much nearer to it, how
often."""

Places = Float[np.ndarray, "mark 2"]


def pockets_by_face(spec: ObjectSpec) -> list[tuple[FaceFrame, tuple[Pocket, ...]]]:
    """Each face that magnets are set on, and their pockets."""
    in_shell = spec.arrangement == "sensors-in-core"
    frames = face_frames(spec) if in_shell else core_frames(spec)
    pockets = shell_pockets(spec) if in_shell else core_pockets(spec)
    return list(zip(frames, pockets, strict=True))


def hole_centre_mm(pocket: Pocket) -> Float[np.ndarray, "2"]:
    """Return where the pocket's axis leaves the face."""
    return pocket.body.centre_mm[:2] + pocket.mouth_mm * pocket.axis[:2]


def mark_places(
    spec: ObjectSpec, pockets: Sequence[Pocket], half_mm: tuple[float, float]
) -> Places:
    """Middle of every magnet's mark on a template of these half extents, in the face's frame (mm).

    Each stands where most room is next to its own hole; where that leaves a wall that cannot be printed, or
    none, they make room for each other.
    """
    plate = _Plate(spec, pockets, half_mm)
    places = np.stack([mark_place(pockets, index, half_mm) for index in range(len(pockets))])
    if plate.least_mm(places) >= spec.printer.wall_mm:
        return places
    for _ in range(_ROUNDS):
        places_before = places.copy()
        for index in range(len(places)):
            places[index] = plate.roomiest(places, index)
        if (places_before == places).all():
            break
    return places


def mark_place(
    pockets: Sequence[Pocket], index: int, half_mm: tuple[float, float]
) -> Float[np.ndarray, "2"]:
    """Beside the hole, in the direction with most room to the other holes and the plate's edge."""
    centres = np.stack([hole_centre_mm(pocket) for pocket in pockets])
    radii = np.array([pocket.outline.radius_mm for pocket in pockets])
    places = _round_hole(centres[index], float(radii[index]), 16)
    gaps = np.linalg.norm(places[:, None] - centres, axis=2) - radii
    border = (np.asarray(half_mm) - abs(places)).min(axis=1)
    return places[np.argmax(np.round(np.minimum(gaps.min(axis=1), border), 6))]


def _round_hole(centre: np.ndarray, radius: float, count: int, closer: float = 0.0) -> Places:
    angle = np.arange(count) * 2 * np.pi / count
    away = radius + MARK_GAP_MM - closer + MARK_LENGTH_MM / 2
    return centre + away * np.column_stack([np.cos(angle), np.sin(angle)])


def bars(polarity: int) -> list[tuple[float, float]]:
    """Half edges of the bars of + or −."""
    long, wide = MARK_LENGTH_MM / 2, MARK_WIDTH_MM / 2
    return [(long, wide), (wide, long)] if polarity > 0 else [(long, wide)]


def thinnest_mark_wall_mm(spec: ObjectSpec) -> float:
    """Wall of the template between a mark and the nearest hole, other mark or edge of the plate; ∞ where
    there is none.

    Marks that meet, or reach past the edge, leave no wall.
    """
    walls = [np.inf]
    for frame, pockets in pockets_by_face(spec):
        half = frame.half_extents_mm
        walls.append(_Plate(spec, pockets, half).thinnest_mm(mark_places(spec, pockets, half)))
    return float(min(walls))


@dataclass(frozen=True)
class _Plate:
    """A template's holes, bars of its marks, and half extents."""

    spec: ObjectSpec
    pockets: Sequence[Pocket]
    half_mm: tuple[float, float]
    centres: Float[np.ndarray, "hole 2"] = field(init=False)
    radii: Float[np.ndarray, "hole"] = field(init=False)

    def __post_init__(self) -> None:
        radii = np.array([pocket.outline.radius_mm for pocket in self.pockets])
        centres = np.stack([hole_centre_mm(pocket) for pocket in self.pockets])
        object.__setattr__(self, "radii", radii + self.spec.printer.clearance_mm)
        object.__setattr__(self, "centres", centres)

    def thinnest_mm(self, places: Places) -> float:
        """Thinnest of all walls between marks and what is next to them."""
        walls = self._all_walls_mm(places)
        return float(walls[walls > -np.inf].min(initial=np.inf))

    def least_mm(self, places: Places) -> float:
        """The same, −∞ where marks meet or reach past the edge."""
        return float(self._all_walls_mm(places).min(initial=np.inf))

    def _all_walls_mm(self, places: Places) -> Float[np.ndarray, "wall"]:
        each = range(len(places))
        walls = [self._walls_mm(places[index, None], places, index) for index in each]
        return np.concatenate(walls, axis=None)

    def roomiest(self, places: Places, index: int) -> Float[np.ndarray, "2"]:
        """Place where a mark has the thickest walls next to it, the others standing where they do; first
        where it stands."""
        centre = hole_centre_mm(self.pockets[index])
        radius = self.pockets[index].outline.radius_mm
        tried = [_round_hole(centre, radius, _ANGLES, closer) for closer in _CLOSER_MM]
        candidates = np.concatenate([places[index, None], *tried])
        least = self._walls_mm(candidates, places, index).min(axis=1)
        return candidates[int(np.argmax(least.round(6)))]

    def _walls_mm(
        self, candidates: Float[np.ndarray, "n 2"], places: Places, index: int
    ) -> Float[np.ndarray, "n wall"]:
        """Walls of one mark, wherever it may stand, to holes, the plate's edges and the other marks; −∞ where
        there is none, as they meet."""
        polarities, half = self.spec.magnets.polarities, np.asarray(self.half_mm)
        of_others = [
            (*places[k], *bar)
            for k in range(len(places))
            if k != index
            for bar in bars(polarities[k])
        ]
        # middles and half edges of the other marks' bars
        middles, theirs = np.reshape(of_others, (-1, 2, 2)).swapaxes(0, 1)
        walls = list[np.ndarray]()
        for mine in map(np.array, bars(polarities[index])):
            beside = (abs(candidates[:, None] - self.centres) - mine).clip(min=0)
            walls.append(np.linalg.norm(beside, axis=2) - self.radii)
            corner = (half - candidates - mine).sum(axis=1, keepdims=True) - CORNER_MM
            walls += [_or_none(half - abs(candidates) - mine), _or_none(corner / np.sqrt(2))]
            apart = (abs(candidates[:, None] - middles) - mine - theirs).clip(min=0)
            walls.append(_or_none(np.linalg.norm(apart, axis=2)))
        return np.concatenate(walls, axis=1)


def _or_none(walls_mm: Float[np.ndarray, "..."]) -> Float[np.ndarray, "..."]:
    return np.where(walls_mm > 0, walls_mm, -np.inf)
