"""Holes that a mould is poured through, as numbers.

`design/mould/openings.py` adds the vents and cuts them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import body_of
from design.layout.mould.frame import (
    FLANGE_THICKNESS_MM,
    Parting,
    flange_width_mm,
    mould_frame,
    mould_style,
    parting,
    seam_ends_mm,
    thin_at_seam,
    thin_beside,
    up,
)
from design.layout.mould.pins import Pin, exit_mm, loose_pins
from design.layout.pockets import distance_of_segments_mm
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

    from design.body.kinds.base import BodyKind

_SECTIONS = 48
_POUR_SHIFTS = (0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0, 1.25, -1.25, 1.5, -1.5)
"""Along the flange, over the distance from the rod's axis across it."""
_MOST_CORNERS = 200
_WEDGE = np.cos(np.deg2rad(15.0))
_RIM_POINTS, _WITHIN = 24, 0.999
"""Number of points of a hole's rim that are looked at, and how far out: a hole may end where the silicone
does."""
_STEP_MM = 0.25
"""Along a hole, where it is looked for in a flange."""
LEAST_POUR_MM = 3.0
"""Silicone runs badly through narrower holes and slots."""


@dataclass(frozen=True)
class Hole:
    """A straight round hole from within the silicone, where `top_mm` is on its surface, to outside the
    mould."""

    use: Literal["pour", "vent"]
    start_mm: Float[np.ndarray, "3"]
    top_mm: Float[np.ndarray, "3"]
    end_mm: Float[np.ndarray, "3"]
    diameter_mm: float

    @property
    def outside(self) -> Hole:
        """The part of it that begins at the silicone's surface."""
        return replace(self, start_mm=self.top_mm)

    def surface(self) -> trimesh.Trimesh:
        import trimesh

        ends = [self.start_mm, self.end_mm]
        return trimesh.creation.cylinder(self.diameter_mm / 2, segment=ends, sections=_SECTIONS)


def hole_from(
    spec: ObjectSpec,
    use: Literal["pour", "vent"],
    top_mm: np.ndarray,
    way: np.ndarray,
    diameter_mm: float,
) -> Hole:
    """From below a point of the surface, so that all of its rim is open, to far outside."""
    return Hole(use, top_mm - diameter_mm * way, top_mm, top_mm + far_mm(spec) * way, diameter_mm)


def far_mm(spec: ObjectSpec) -> float:
    """A length that leaves the mould from anywhere in it."""
    return 3 * max(spec.body.size_mm) + flange_width_mm(spec) + spec.mould.wall_mm


def pour_holes(
    spec: ObjectSpec, first: bool = True, pins: tuple[Pin, ...] | None = None
) -> tuple[Hole, ...]:
    """Holes next to the rod through a bore, at both its sides; at the upper corner of a closed mould. They
    move along the flange of the rod, which stays next to them, or go down from that corner, until no pin is
    in their way.

    Of the mould that the shell is cast in, or, unless `first`, of the seal layer's, and with that
    mould's pins unless others are given.

    Raises
    ------
    InputError
        Wherever they might be, a pin is in the way, or no silicone is below them.
    """
    frame = mould_frame(spec)
    if frame.opening == "open":
        return ()
    pins = pins_of(spec, first) if pins is None else pins
    thin: tuple[Hole, ...] | None = None
    for tops in pour_places(spec, first):
        holes = tuple(hole_from(spec, "pour", top, up(spec), spec.mould.pour_mm) for top in tops)
        if all(is_clear(hole, pins) for hole in holes):
            if not any(
                hole_thins_the_seam(spec, hole) or thin_beside_others(spec, hole, pins)
                for hole in holes
            ):
                return holes
            thin = thin or holes
    if thin is not None:
        return thin
    which = "" if first else "seal layer's "
    raise InputError(
        f"wherever the {which}mould's pouring holes (mould.pour_mm = "
        f"{spec.mould.pour_mm:g}) might be, a pin of a magnet's pocket is in the way, or silicone "
        "is not below all of their rims"
    )


def pour_places(spec: ObjectSpec, first: bool) -> Iterator[list[np.ndarray]]:
    """Tops of the pouring holes on the silicone's surface, which lies below all of their rims; the best
    first."""
    frame, radius = mould_frame(spec), spec.mould.pour_mm / 2
    if frame.opening == "closed":
        way = up(spec)
        silhouette = _silhouette(spec, first, _axes_across(way))
        height = silhouette.vertices @ way
        for top in silhouette.vertices[np.argsort(-height, kind="stable")[:_MOST_CORNERS]]:
            if silhouette.lies_below_rim(silhouette.axes[:2] @ top, radius):
                yield [top]
        return
    silhouette = _silhouette(spec, first, np.stack([frame.across, frame.length_axis, frame.out]))
    aside = float(frame.plug_mm[1, 0]) + radius
    for shift in _POUR_SHIFTS:
        places = [sign * aside * np.array([1.0, shift]) for sign in (-1, 1)]
        heights = [silhouette.highest_mm(place) for place in places]
        if None not in heights and all(
            silhouette.lies_below_rim(place, radius) for place in places
        ):
            tops = zip(places, heights, strict=True)
            yield [np.array([*place, height]) @ silhouette.axes for place, height in tops]


def _axes_across(way: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3 3"]:
    """Orthonormal rows of which the last is that way."""
    side = np.cross(way, np.eye(3)[int(abs(way).argmin())])
    side /= np.linalg.norm(side)
    return np.stack([side, np.cross(way, side), way])


@dataclass(frozen=True)
class _Seen:
    """A surface, and its triangles along axes (rows) of which the last is the way that it is looked at.

    These stand in the order of their lowest first coordinate, `low`, from which none reaches
    farther than `widest`.
    """

    axes: Float[np.ndarray, "3 3"]
    vertices: Float[np.ndarray, "vertex 3"]
    triangles: Float[np.ndarray, "triangle 3 3"]
    low: Float[np.ndarray, "triangle"]
    widest: float

    def lies_below_rim(self, place_mm: Float[np.ndarray, "2"], radius_mm: float) -> bool:
        """Return whether the surface lies below all of a round hole's rim."""
        turn = 2 * np.pi * np.arange(_RIM_POINTS) / _RIM_POINTS
        rim = place_mm + _WITHIN * radius_mm * np.column_stack([np.cos(turn), np.sin(turn)])
        return all(self.highest_mm(place) is not None for place in rim)

    def highest_mm(self, place_mm: Float[np.ndarray, "2"]) -> float | None:
        first, last = np.searchsorted(self.low, place_mm[0] - [self.widest, 0.0], side="right")
        return _highest_mm(self.triangles[max(first - 1, 0) : last], place_mm)


def _silhouette(spec: ObjectSpec, first: bool, axes: Float[np.ndarray, "3 3"]) -> _Seen:
    """The silicone's outside, or unless it is the `first` pour's the finished one's."""
    layer = spec.shell.seal_layer_mm if first else 0.0
    return _seen_of(body_of(spec), layer, spec.body.sensed, tuple(axes.ravel().tolist()))


@lru_cache(maxsize=4)
def _seen_of(
    body: BodyKind, layer_mm: float, sensed: tuple[int, ...], axes: tuple[float, ...]
) -> _Seen:
    """Kept, as many layouts of one body are judged one after the other."""
    surface = body.cast_surface(layer_mm, sensed) if layer_mm else body.outer_surface()
    rows = np.reshape(axes, (3, 3))
    triangles = (np.asarray(surface.vertices) @ rows.T)[np.asarray(surface.faces)]
    low, high = triangles[:, :, 0].min(axis=1), triangles[:, :, 0].max(axis=1)
    order = np.argsort(low, kind="stable")
    return _Seen(
        rows, np.asarray(surface.vertices), triangles[order], low[order], float((high - low).max())
    )


def _highest_mm(
    triangles: Float[np.ndarray, "triangle 3 3"], place: Float[np.ndarray, "2"]
) -> float | None:
    """Largest third coordinate of a surface over a place in the first two; None where it has none."""
    corner_a, corner_b, corner_c = np.moveaxis(triangles[:, :, :2] - place, 1, 0)
    shares = np.stack(
        [_turned(corner_b, corner_c), _turned(corner_c, corner_a), _turned(corner_a, corner_b)],
        axis=1,
    )
    whole = shares.sum(axis=1)
    over = (whole != 0) & np.all(shares * whole[:, None] >= 0, axis=1)
    heights = np.sum(shares[over] * triangles[over, :, 2], axis=1) / whole[over]
    return float(heights.max()) if over.any() else None


def _turned(points_a: np.ndarray, points_b: np.ndarray) -> np.ndarray:
    """Twice the area of triangles from the origin, negative where they turn the other way."""
    return points_a[:, 0] * points_b[:, 1] - points_a[:, 1] * points_b[:, 0]


def pins_of(spec: ObjectSpec, first: bool) -> tuple[Pin, ...]:
    """Pins in the mould of the first pour; the seal layer's has none for pockets."""
    pins = loose_pins(spec) if mould_style(spec) == "split" else ()
    return pins if first else tuple(pin for pin in pins if pin.locator is not None)


def is_clear(hole: Hole, pins: tuple[Pin, ...]) -> bool:
    """Return whether no pin and no pin's head stands in a hole."""
    axis, half = np.stack([hole.start_mm, hole.end_mm]), hole.diameter_mm / 2
    return all(
        distance_of_segments_mm(axis, pin.axis_mm) > half + pin.radius_mm
        and distance_of_segments_mm(axis, pin.head_axis_mm) > half + pin.radius_mm + pin.rim_mm
        for pin in pins
    )


def thin_beside_others(
    spec: ObjectSpec, hole: Hole, pins: tuple[Pin, ...], holes: Sequence[Hole] = ()
) -> bool:
    """Return whether a hole leaves too thin a wall to the hole of the rod, of a pin or of its head, or to
    other holes for pouring or for air, or a wedge of less than 15° where they meet."""
    ends, radius = hole_within_mould(spec, hole), hole.diameter_mm / 2
    other_holes = [
        (hole_within_mould(spec, other_radius), other_radius.diameter_mm / 2)
        for other_radius in holes
    ]
    for axis, other_radius in (*_other_holes(spec, pins), *other_holes):
        away = distance_of_segments_mm(ends, axis)
        meets = np.sqrt(radius**2 + other_radius**2 + 2 * radius * other_radius * _WEDGE)
        if meets < away < radius + other_radius + spec.printer.wall_mm:
            return True
    return False


def _other_holes(
    spec: ObjectSpec, pins: tuple[Pin, ...]
) -> Iterator[tuple[Float[np.ndarray, "2 3"], float]]:
    """Axes and radii of those for the rod, and for pins and their heads."""
    frame, play = mould_frame(spec), spec.printer.clearance_mm
    if frame.opening == "bore":
        yield np.outer([0.0, frame.rim_mm], frame.out), spec.body.bore_mm / 2 + play
    for pin in pins:
        yield pin.shank_axis_mm, pin.radius_mm + play
        yield pin.head_axis_mm, pin.radius_mm + pin.rim_mm + play


def hole_thins_the_seam(spec: ObjectSpec, hole: Hole) -> bool:
    """Return whether a hole leaves a wall to the parting plane that is too thin, or to a side of a flange."""
    if mould_style(spec) != "split":
        return False
    ends, radius = hole_within_mould(spec, hole), hole.diameter_mm / 2
    return thin_at_seam(spec, ends, radius) or _thin_in_a_flange(spec, hole)


def _thin_in_a_flange(spec: ObjectSpec, hole: Hole) -> bool:
    """The same of a flange's sides, where the hole goes through it next to the block."""
    frame, plane, radius = mould_frame(spec), parting(spec), hole.diameter_mm / 2
    way = hole.end_mm - hole.top_mm
    steps = np.arange(0.0, float(np.linalg.norm(way)), _STEP_MM)
    path = hole.top_mm + steps[:, None] * way / np.linalg.norm(way)
    place = path @ frame.axes
    beyond = np.maximum(frame.low_mm - place, place - frame.high_mm)[:, :2].max(axis=1)
    left, right = seam_ends_mm(spec)
    middle, half = (left + right) / 2, (right - left) / 2 + flange_width_mm(spec)
    across = abs(path @ np.cross(frame.out, plane.normal) - middle)
    inside = (beyond > -radius) & (across < half + radius) & (place[:, 2] < frame.rim_mm + radius)
    if not inside.any():
        return False
    through = path[inside]
    ends = np.stack([through[0], through[-1] + _STEP_MM * way / np.linalg.norm(way)])
    return any(
        thin_beside(spec, ends, Parting(plane.normal, plane.offset_mm + side), radius)
        for side in (-FLANGE_THICKNESS_MM, FLANGE_THICKNESS_MM)
    )


def hole_within_mould(spec: ObjectSpec, hole: Hole) -> Float[np.ndarray, "2 3"]:
    """Return where a hole's axis leaves the silicone, and where the mould's block."""
    way = hole.end_mm - hole.top_mm
    way /= np.linalg.norm(way)
    return np.stack([hole.top_mm, hole.top_mm + exit_mm(spec, hole.top_mm, way) * way])
