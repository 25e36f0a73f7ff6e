"""Shapes of rigid indenters: height of a tip's surface above its lowest point.

A hemisphere is exact. Every other tip is a convex polytope (arcs in steps of 2°, fillets of 9°),
turned by yaw and tilt; its underside is the largest of its lower facets' planes.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.mechanics import IndenterSpec

_ARC_STEPS = 180
"""Corners by which a circle is drawn."""
_FILLET_STEPS = 10
"""Pieces into which a fillet's quarter circle is cut."""
_BODY_MM = 20.0
"""Height of a tip's straight side above its fillet."""
_LEVEL = 1e-9
"""Rounding within which points lie on one level, or on an outline, over the size."""
_HALF_TURN = np.deg2rad(np.arange(180))


@dataclass(frozen=True)
class TipShape:
    """One tip over its lowest point: a sphere's radius, or a polytope's planes and outline.

    `planes` (plane, 3) are a, b, c of heights a x + b y + c; `outline` (edge, 3) are n and d of
    n·(x, y) ≤ d. `corners_mm` are the outline's, `height_mm` is the deepest press the shape allows.
    """

    sphere_radius_mm: float | None
    planes: Float[np.ndarray, "plane 3"]
    outline: Float[np.ndarray, "edge 3"]
    corners_mm: Float[np.ndarray, "corner 2"]
    height_mm: float


def tip_shape(indenter: IndenterSpec) -> TipShape:
    """Shape of one tip of an indenter."""
    if indenter.kind == "hemisphere":
        radius, none = indenter.radius_mm, np.zeros((0, 3))
        return TipShape(radius, none, none, radius * _circle(), radius)
    points = _turned(_BODIES[indenter.kind](indenter), indenter)
    lowest = points[points[:, 2] < points[:, 2].min() + _LEVEL * np.ptp(points)]
    foot = np.append((lowest.min(axis=0) + lowest.max(axis=0))[:2] / 2, lowest[0, 2])
    return _polytope(points - foot)


def tip_heights_mm(shape: TipShape, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
    """Height of the tip's surface above its lowest point at lateral offsets; ∞ off the tip."""
    if shape.sphere_radius_mm is not None:
        radius, r2 = shape.sphere_radius_mm, np.sum(np.asarray(xy_mm) ** 2, axis=-1)
        return np.where(r2 <= radius**2, radius - np.sqrt(np.clip(radius**2 - r2, 0, None)), np.inf)
    height = np.max(xy_mm @ shape.planes[:, :2].T + shape.planes[:, 2], axis=-1)
    beside = np.any(xy_mm @ shape.outline[:, :2].T > shape.outline[:, 2] + _LEVEL, axis=-1)
    return np.where(beside, np.inf, height)


def tip_places_mm(indenter: IndenterSpec) -> Float[np.ndarray, "tip 2"]:
    """Return where the lowest points of the probe's tips are, about the place pressed."""
    reach = float(np.linalg.norm(tip_shape(indenter).corners_mm, axis=1).max())
    places = tip_positions_mm(indenter.tip_count, reach, indenter.tip_spacing_mm)
    yaw = np.deg2rad(indenter.yaw_deg)
    return places @ np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]])


def footprint_mm(indenter: IndenterSpec) -> Float[np.ndarray, "2 2"]:
    """Lowest and highest (x, y) of all tips about the place pressed."""
    corners = tip_shape(indenter).corners_mm
    places = tip_places_mm(indenter)
    return np.stack(
        [(places + corners.min(axis=0)).min(axis=0), (places + corners.max(axis=0)).max(axis=0)]
    )


def tips_overlap(indenter: IndenterSpec, offset_mm: Float[np.ndarray, "2"]) -> bool:
    """Return whether tips of two such indenters overlap, the second `offset_mm` next to the first.

    Convex outlines are apart where some direction separates them; directions are tried every 1°.
    """
    direction = np.stack([np.cos(_HALF_TURN), np.sin(_HALF_TURN)])
    width = np.ptp(tip_shape(indenter).corners_mm @ direction, axis=0)
    places = tip_places_mm(indenter)
    between = (places[:, None] - places - offset_mm).reshape(-1, 2)
    apart = np.any(abs(between @ direction) >= width - _LEVEL, axis=1)
    return not bool(apart.all())


def path_mm(
    indenter: IndenterSpec, depths_mm: Sequence[float] | np.ndarray
) -> Float[np.ndarray, "step 2"]:
    """Return how far the indenter has moved sideways at each depth of its oblique path."""
    return np.multiply.outer(np.asarray(depths_mm), np.tan(np.deg2rad(indenter.direction_deg)))


def _polytope(points: np.ndarray) -> TipShape:
    from scipy.spatial import ConvexHull

    a, b, c, d = ConvexHull(points).equations.T
    lower = c < -_LEVEL
    planes = -np.stack([a[lower], b[lower], d[lower]], axis=1) / c[lower, None]
    outline = ConvexHull(points[:, :2])
    edges = outline.equations * [1, 1, -1]
    corners = points[outline.vertices, :2]
    return TipShape(None, _distinct(planes), _distinct(edges), corners, float(points[:, 2].max()))


def _distinct(rows: np.ndarray) -> np.ndarray:
    """Each plane once: Qhull cuts every flat facet into triangles."""
    _, first = np.unique(rows.round(9), axis=0, return_index=True)
    return rows[np.sort(first)]


def _turned(points: np.ndarray, indenter: IndenterSpec) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    tilt_x, tilt_y = indenter.tilt_deg
    turn = Rotation.from_euler("zxy", [indenter.yaw_deg, tilt_x, tilt_y], degrees=True)
    return turn.apply(points)


def _circle() -> np.ndarray:
    """Polygon in the unit circle: 2e-4 less area."""
    angle = 2 * np.pi / _ARC_STEPS * np.arange(_ARC_STEPS)
    return np.column_stack([np.cos(angle), np.sin(angle)])


def _rounded_edge(fillet_mm: float) -> np.ndarray:
    """(inset, height) along the profile of a fillet, and of the straight side above it."""
    angle = np.linspace(0, np.pi / 2, _FILLET_STEPS + 1) if fillet_mm else np.array([np.pi / 2])
    inset, height = fillet_mm * (1 - np.sin(angle)), fillet_mm * (1 - np.cos(angle))
    return np.vstack([np.column_stack([inset, height]), [0, fillet_mm + _BODY_MM]])


def _flat(indenter: IndenterSpec) -> np.ndarray:
    rings = [
        np.column_stack([(indenter.radius_mm - inset) * _circle(), np.full(_ARC_STEPS, height)])
        for inset, height in _rounded_edge(indenter.fillet_mm)
    ]
    return np.concatenate(rings)


def _cuboid(indenter: IndenterSpec) -> np.ndarray:
    half = np.asarray(indenter.size_mm) / 2
    corners = half * np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    if not indenter.fillet_mm:
        return np.vstack([np.column_stack([corners, np.full(4, z)]) for z in (0.0, _BODY_MM)])
    centres = np.sign(corners) * (half - indenter.fillet_mm)
    rings = []
    for inset, height in _rounded_edge(indenter.fillet_mm):
        ring = (indenter.fillet_mm - inset) * _circle()
        around = (centres[:, None] + ring[None]).reshape(-1, 2)
        rings.append(np.column_stack([around, np.full(len(around), height)]))
    return np.concatenate(rings)


def _cylinder(indenter: IndenterSpec) -> np.ndarray:
    """A cylinder that lies along x, its ends flat."""
    y, z = indenter.radius_mm * _circle().T
    ends = indenter.length_mm / 2 * np.array([-1, 1])
    return np.concatenate([np.column_stack([np.full(len(y), x), y, z]) for x in ends])


def _stl(indenter: IndenterSpec) -> np.ndarray:
    return np.asarray(indenter.vertices_mm, float)


_BODIES = {"flat": _flat, "cuboid": _cuboid, "cylinder": _cylinder, "stl": _stl}


def tip_positions_mm(
    tips: int, radius_mm: float = 5.0, spacing_mm: float | None = None
) -> Float[np.ndarray, "tip 2"]:
    """Tip centres (x, y) in mm about the probe's axis: one, two 15 mm apart, or three 20 mm apart.

    Without a spacing these are the paper's (Knopke et al., RA-L 2024) for tips of 5 mm radius or
    less; larger tips keep the ratio, 3 and 4 radii, so that they stay apart.

    Raises
    ------
    InputError
        No such probe.
    """
    if tips == 1:
        return np.zeros((1, 2))
    if tips == 2:
        half = (spacing_mm or max(15.0, 3 * radius_mm)) / 2
        return np.array([[-half, 0.0], [half, 0.0]])
    if tips == 3:
        circumradius = (spacing_mm or max(20.0, 4 * radius_mm)) / np.sqrt(3)
        angle = np.deg2rad([90.0, 210.0, 330.0])
        return circumradius * np.column_stack([np.cos(angle), np.sin(angle)])
    raise InputError(f"a probe has 1, 2 or 3 tips; got {tips}. Choose one of these")
