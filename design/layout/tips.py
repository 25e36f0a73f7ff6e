"""Shapes of rigid indenters: height of a tip's surface above its lowest point.

Ellipsoids, and the hemisphere among them, are exact. Every other tip is a convex polytope (arcs in
steps of 2°, fillets of 9°), turned by yaw and tilt; its underside is the largest of its lower facets'
planes.
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
    """One tip about the place pressed: an ellipsoid, or a polytope's planes and outline.

    `ellipsoid` is A in pᵀ A p ≤ 1 about its centre. `planes` (plane, 3) are a, b, c of heights
    a x + b y + c; `outline` (edge, 3) are n and d of n·(x, y) ≤ d. `corners_mm` are the outline's,
    `lowest_mm` those of what is lowest, `height_mm` is the deepest press the shape allows.
    """

    ellipsoid: Float[np.ndarray, "3 3"] | None
    planes: Float[np.ndarray, "plane 3"]
    outline: Float[np.ndarray, "edge 3"]
    corners_mm: Float[np.ndarray, "corner 2"]
    lowest_mm: Float[np.ndarray, "lowest 2"]
    height_mm: float

    @property
    def radius_mm(self) -> float | None:
        """Geometric mean of an ellipsoid's two radii of curvature at its lowest point."""
        if self.ellipsoid is None:
            return None
        # z rises by H xᵀ S x/2 from the lowest point, S = B − b bᵀ/c of A's blocks: 1/(H √det S)
        across = self.ellipsoid[:2, 2]
        flat = self.ellipsoid[:2, :2] - np.outer(across, across) / self.ellipsoid[2, 2]
        return float(1 / (self.height_mm * np.sqrt(np.linalg.det(flat))))


def tip_shape(indenter: IndenterSpec) -> TipShape:
    """Shape of one tip of an indenter.

    The place pressed is under the middle of a flat's or cuboid's underside, else of what is lowest.
    """
    if indenter.kind in ("hemisphere", "ellipsoid"):
        return _ellipsoid(indenter)
    points = _turned(_BODIES[indenter.kind](indenter), indenter)
    low = points[:, 2].min()
    lowest = points[points[:, 2] < low + _LEVEL * np.ptp(points), :2]
    middle = (lowest.min(axis=0) + lowest.max(axis=0)) / 2
    if indenter.kind in ("flat", "cuboid"):
        middle = np.zeros(2)
    return _polytope(points - np.append(middle, low), lowest - middle)


def tip_heights_mm(shape: TipShape, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
    """Height of the tip's surface above its lowest point at lateral offsets; ∞ off the tip."""
    if shape.ellipsoid is not None:
        return _ellipsoid_heights_mm(shape.ellipsoid, np.asarray(xy_mm, float))
    height = np.max(xy_mm @ shape.planes[:, :2].T + shape.planes[:, 2], axis=-1)
    beside = np.any(xy_mm @ shape.outline[:, :2].T > shape.outline[:, 2] + _LEVEL, axis=-1)
    return np.where(beside, np.inf, height)


def _ellipsoid(indenter: IndenterSpec) -> TipShape:
    radius, half = indenter.radius_mm, np.asarray(indenter.size_mm) / 2
    axes = _turned(np.eye(3), indenter).T
    lengths = np.full(3, radius) if indenter.kind == "hemisphere" else np.append(half, radius)
    inverse = (axes * lengths**2) @ axes.T
    # the silhouette from above is the ellipse of the inverse's first block
    silhouette = _circle() @ np.linalg.cholesky(inverse[:2, :2]).T
    height, none = float(np.sqrt(inverse[2, 2])), np.zeros((0, 3))
    corners = silhouette + inverse[:2, 2] / height
    return TipShape(np.linalg.inv(inverse), none, none, corners, np.zeros((1, 2)), height)


def _ellipsoid_heights_mm(matrix: Float[np.ndarray, "3 3"], xy_mm: np.ndarray) -> np.ndarray:
    """z of the lower root of pᵀ A p = 1, above the lowest point, which lies at x = y = 0."""
    inverse = np.linalg.inv(matrix)
    lowest = -inverse[:, 2] / np.sqrt(inverse[2, 2])
    xy, last = xy_mm + lowest[:2], matrix[2, 2]
    across = xy @ matrix[:2, 2]
    level = np.sum((xy @ matrix[:2, :2]) * xy, axis=-1) - 1
    root = across**2 - last * level
    height = (-across - np.sqrt(np.clip(root, 0, None))) / last - lowest[2]
    return np.where(root >= -_LEVEL * last, height, np.inf)


def tip_places_mm(indenter: IndenterSpec) -> Float[np.ndarray, "tip 2"]:
    """Return where the lowest points of the probe's tips are, about the place pressed."""
    reach = float(np.linalg.norm(tip_shape(indenter).corners_mm, axis=1).max())
    places = tip_positions_mm(indenter.tip_count, reach)
    yaw = np.deg2rad(indenter.turn_deg[0])
    return places @ np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]])


def footprint_mm(indenter: IndenterSpec) -> Float[np.ndarray, "2 2"]:
    """Lowest and highest (x, y) of all tips about the place pressed."""
    corners = tip_shape(indenter).corners_mm
    places = tip_places_mm(indenter)
    return np.stack(
        [(places + corners.min(axis=0)).min(axis=0), (places + corners.max(axis=0)).max(axis=0)]
    )


def landing_mm(
    indenter: IndenterSpec,
    xy_mm: Float[np.ndarray, "*place 2"],
    low_mm: Float[np.ndarray, "2"],
    high_mm: Float[np.ndarray, "2"],
) -> Float[np.ndarray, "2 *place 2"]:
    """Ends, about the place pressed, of what must land on a face between `low_mm` and `high_mm`.

    Round tips land with every lowest point, for over a border they roll; others may hang over it.
    """
    if tip_shape(indenter).ellipsoid is not None:
        tips = tip_places_mm(indenter)
        ends = np.stack([tips.min(axis=0), tips.max(axis=0)])
        return ends.reshape(2, *[1] * (xy_mm.ndim - 1), 2) + 0 * xy_mm
    low, high = footprint_mm(indenter)
    nearest = np.clip((low_mm + high_mm) / 2 - xy_mm, low, high)
    return np.stack([nearest, nearest])


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


def _polytope(points: np.ndarray, lowest: np.ndarray) -> TipShape:
    from scipy.spatial import ConvexHull

    a, b, c, d = ConvexHull(points).equations.T
    lower = c < -_LEVEL
    planes = -np.stack([a[lower], b[lower], d[lower]], axis=1) / c[lower, None]
    outline = ConvexHull(points[:, :2])
    edges = outline.equations * [1, 1, -1]
    corners = points[outline.vertices, :2]
    height = float(points[:, 2].max())
    return TipShape(None, _distinct(planes), _distinct(edges), corners, lowest, height)


def _distinct(rows: np.ndarray) -> np.ndarray:
    """Each plane once: Qhull cuts every flat facet into triangles."""
    _, first = np.unique(rows.round(9), axis=0, return_index=True)
    return rows[np.sort(first)]


def _turned(points: np.ndarray, indenter: IndenterSpec) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    turn = Rotation.from_euler("zxy", indenter.turn_deg, degrees=True)
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
    ends = indenter.size_mm[0] / 2 * np.array([-1, 1])
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
