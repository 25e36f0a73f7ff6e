"""Bodies known by a triangulated surface: signed distance, core offset inwards, patches.

The core's surface is where the signed distance to the outside is minus the shell's thickness, so that
the wall measures that thickness wherever it is thinnest. Distances are measured on a grid once and
interpolated by cubic splines; the core is found by marching cubes on a finer one. On an ellipsoid of
60 × 50 × 44 mm the wall of 8 mm then measures 7.99 to 8.02 mm.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from math import factorial
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.body.meshes import simplified
from design.body.surface_chart import STEEPEST, STEEPEST_TOUCHED, FaceFrame, face_axes
from design.errors import InputError

if TYPE_CHECKING:
    import trimesh
    from scipy.interpolate import RectBivariateSpline

    from design.body.kinds.base import BodyKind

_GRID_POINTS = 45_000
_ALIKE_MM = 60.0
"""Longest edge at which distances to a file's body are measured."""
_MARGIN_STEPS = 3
_COARSE, _EXACT_STEPS = 3, 3
"""Outside a body, distances are exact within this number of steps; beyond, from a grid this many times
coarser."""
_FINE_STEP_MM = 1.0
_MOST_STEPS = 64
"""From the middle of a body to its side, of the core's grid and of a patch's: on larger bodies than
128 mm the steps grow, or time and memory would, with the cube and the square of the size."""
_MAX_TRACES = 80
"""Steps of a ray along the distance field, at most."""
_TRACED_MM = 1e-5
"""Distance from the surface at which a ray has arrived."""
_RELIEF_STEP_MM = 1.0
"""Step along a face at which its relief is sampled, about."""
_SLIVERS_MM = 0.01
"""Tolerance within which slivers among the triangles are merged."""
_REACH_SHARE = 0.97
"""Share of a body's half extents over which a face's relief is sampled."""


@dataclass(frozen=True)
class SampledRelief:
    """Heights of a surface over a frame's plane: cubic splines through a regular grid.

    Known within the ellipse of `half_mm`.
    """

    spline: RectBivariateSpline
    half_mm: tuple[float, float]

    def evaluate(
        self, xy_mm: Float[np.ndarray, "*n 2"]
    ) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n 2"]]:
        """Height (mm) and its slopes along x and y; NaN where the patch does not reach."""
        x, y = xy_mm[..., 0], xy_mm[..., 1]
        inside = (x / self.half_mm[0]) ** 2 + (y / self.half_mm[1]) ** 2 <= 1
        x, y = np.where(inside, x, 0.0), np.where(inside, y, 0.0)
        breaks_x, breaks_y, powers = self._pieces
        column, row = breaks_x.searchsorted(x, "right") - 1, breaks_y.searchsorted(y, "right") - 1
        u, v = x - breaks_x[column], y - breaks_y[row]
        coefficients = powers.take(column * len(breaks_y) + row, axis=1)
        # Horner's scheme, z = Σᵢ (Σⱼ cᵢⱼ vʲ) uⁱ: inner sums and their derivatives first
        lines = [coefficients[4 * i : 4 * i + 4] for i in range(4)]
        sums = [((d * v + c) * v + b) * v + a for a, b, c, d in lines]
        leans = [(3 * d * v + 2 * c) * v + b for _, b, c, d in lines]
        height = ((sums[3] * u + sums[2]) * u + sums[1]) * u + sums[0]
        along_x = (3 * sums[3] * u + 2 * sums[2]) * u + sums[1]
        along_y = ((leans[3] * u + leans[2]) * u + leans[1]) * u + leans[0]
        beyond = np.where(inside, 0.0, np.nan)
        return np.asarray(height + beyond), np.stack([along_x + beyond, along_y + beyond], axis=-1)

    @cached_property
    def _pieces(
        self,
    ) -> tuple[Float[np.ndarray, "i"], Float[np.ndarray, "j"], Float[np.ndarray, "16 i*j"]]:
        """Lower breaks along x and y, and the powers of each piece: rows 4 i + j belong to uⁱ vʲ.

        The spline's own call takes five times as long for the height and its slopes.
        """
        knots_x, knots_y = self.spline.get_knots()
        coefficients = self.spline.get_coeffs().reshape(len(knots_x) - 4, len(knots_y) - 4)
        along_x = _powers(knots_x, coefficients)
        powers = _powers(knots_y, np.moveaxis(along_x, 2, 0)).transpose(2, 0, 3, 1)
        return knots_x[3:-4], knots_y[3:-4], np.ascontiguousarray(powers.reshape(16, -1))


def _powers(
    knots: Float[np.ndarray, "k"], coefficients: Float[np.ndarray, "c *others"]
) -> Float[np.ndarray, "4 piece *others"]:
    """Return the powers of each piece of cubic splines: a Taylor series from its lower break."""
    from scipy.interpolate import BSpline

    spline = BSpline(knots, coefficients, 3)
    return np.stack([spline(knots[3:-4], nu=i) / factorial(i) for i in range(4)])


def outer_distance_mm(
    body: BodyKind, points_mm: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """Signed distance to the outer surface, negative inside; interpolated, see the module.

    Beyond a few millimetres outside the body it is only known to be positive.
    """
    return distance_field(body.outside).evaluate(points_mm)


def measured_distance_mm(
    surface: trimesh.Trimesh, points_mm: Float[np.ndarray, "n 3"]
) -> Float[np.ndarray, "n"]:
    """The same measured to the triangles at every point: exact, and a hundred times slower."""
    import pyvista

    polydata = pyvista.PolyData.from_regular_faces(surface.vertices, surface.faces)
    cloud = pyvista.PolyData(np.ascontiguousarray(points_mm, float))
    return np.asarray(cloud.compute_implicit_distance(polydata)["implicit_distance"], float)


def sampled_core(body: BodyKind) -> trimesh.Trimesh:
    """The core's surface, one shell thickness inside the outer one.

    Raises
    ------
    InputError
        No room for a core inside walls of that thickness, or it falls into pieces.
    """
    return _core(body.outside, body.thickness_mm).copy()


def sampled_frame(body: BodyKind, number: int, inward_mm: float) -> FaceFrame:
    """The patch about one of the six directions, of the surface `inward_mm` below the outer one.

    Raises
    ------
    InputError
        The surface is too small or too steep there for a patch.
    """
    return patch_frame(body.outside, number, inward_mm)


@dataclass(frozen=True)
class DistanceField:
    """Cubic splines of the signed distance on a regular grid."""

    origin_mm: Float[np.ndarray, "3"]
    step_mm: float
    coefficients: Float[np.ndarray, "x y z"]

    def evaluate(self, points_mm: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n"]:
        from scipy.ndimage import map_coordinates

        places = (np.asarray(points_mm) - self.origin_mm).T / self.step_mm
        return map_coordinates(self.coefficients, places, order=3, mode="nearest", prefilter=False)


def distance_field(body: BodyKind) -> DistanceField:
    """Return the field of a body; of a file's bodies of all scales they are one, made larger or smaller."""
    if not body.from_file:
        return _distance_field(body)
    size = max(body.size_mm) / _ALIKE_MM
    scale = float(f"{body.scale / size:.9g}")
    alike = replace(
        body, scale=scale, size_mm=tuple(round(edge / size, 6) for edge in body.size_mm)
    )
    field = _distance_field(alike)
    return DistanceField(size * field.origin_mm, size * field.step_mm, size * field.coefficients)


@lru_cache(maxsize=16)
def _distance_field(body: BodyKind) -> DistanceField:
    from scipy.ndimage import spline_filter

    size, surface = np.asarray(body.size_mm), body.outer_surface()
    distance, origin, step = measured_on_grid(surface, size, _GRID_POINTS, body.mirrored)
    return DistanceField(origin, step, spline_filter(distance, order=3, mode="nearest"))


def measured_where_near(
    surface: trimesh.Trimesh,
    points_mm: np.ndarray,
    count: tuple[int, ...],
    step_mm: float,
    mirrored: bool,
) -> np.ndarray:
    """Distances at a grid's points, farther outside than they are asked for from a coarser grid.

    A point is measured unless that grid says that it lies farther out than its error, at most its
    cell's half diagonal as a distance changes by one millimetre per millimetre, and some steps more.
    Of a surface that is `mirrored` in x, y and z it is measured in one octant, to that octant's triangles.
    """
    from scipy.ndimage import map_coordinates

    part = octant_of(surface) if mirrored else surface

    def measured_mm(points_mm: np.ndarray) -> np.ndarray:
        return measured_distance_mm(part, abs(points_mm) if mirrored else points_mm)

    first = points_mm[0]
    coarse = [np.arange(-(-(n - 1) // _COARSE) + 1) * _COARSE for n in count]
    coarse_index = np.stack(np.meshgrid(*coarse, indexing="ij"), axis=-1)
    coarse_mm = measured_mm((first + step_mm * coarse_index).reshape(-1, 3))
    places = np.stack(np.meshgrid(*map(np.arange, count), indexing="ij")) / _COARSE
    distance = map_coordinates(coarse_mm.reshape(coarse_index.shape[:-1]), places, order=1)
    near = distance < step_mm * (_EXACT_STEPS + np.sqrt(3) / 2 * _COARSE)
    index, middle = np.argwhere(near), (np.array(count) - 1) // 2
    if mirrored:
        index = middle + abs(index - middle)
    once, again = np.unique(np.ravel_multi_index(tuple(index.T), count), return_inverse=True)
    distance[near] = measured_mm(points_mm[once])[again]
    return distance


def octant_of(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """Triangles in which the nearest to a point of x, y, z ≥ 0 is, and enough beyond that none of them
    ends at a cut."""
    import trimesh

    corners = np.asarray(surface.triangles)
    beyond = 3 * float(np.ptp(corners, axis=1).max())
    kept = np.asarray(surface.faces)[(corners > -beyond).all(axis=(1, 2))]
    octant = trimesh.Trimesh(surface.vertices, kept, process=False)
    octant.remove_unreferenced_vertices()
    return octant


def measured_on_grid(
    surface: trimesh.Trimesh,
    size_mm: Float[np.ndarray, "3"],
    points: int,
    mirrored: bool = False,
) -> tuple[Float[np.ndarray, "x y z"], Float[np.ndarray, "3"], float]:
    """Return distances to a centred surface on a grid over its box, of about that number of points, as
    `measured_where_near`, with the grid's first point and step (mm)."""
    step = (float(np.prod(size_mm)) / points) ** (1 / 3)
    places, count = grid_points(size_mm / 2, step)
    distance = measured_where_near(surface, places, count, step, mirrored)
    return distance, places[0], step


def grid_points(half_mm: np.ndarray, step_mm: float) -> tuple[np.ndarray, tuple[int, ...]]:
    """Regular points round a centred box and a few steps beyond it, x slowest."""
    count = 2 * (np.ceil(half_mm / step_mm).astype(int) + _MARGIN_STEPS) + 1
    axes = [step_mm * (np.arange(n) - (n - 1) / 2) for n in count]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    return points, tuple(int(n) for n in count)


@lru_cache(maxsize=16)
def _core(body: BodyKind, thickness_mm: float) -> trimesh.Trimesh:
    half = np.asarray(body.size_mm) / 2 - thickness_mm
    if half.min() <= 0:
        raise InputError(_no_core(body, thickness_mm))
    step = max(min(_FINE_STEP_MM, float(half.min()) / 8), float(half.max()) / _MOST_STEPS)
    points, count = grid_points(half, step)
    distance = distance_field(body).evaluate(points).reshape(count)
    surface = contour_of(distance + thickness_mm, points[0], step)
    if not len(surface.faces):
        raise InputError(_no_core(body, thickness_mm))
    pieces = [piece for piece in surface.split(only_watertight=True) if abs(piece.volume) > 1]
    if len(pieces) != 1:
        raise InputError(
            f"walls of shell.thickness_mm = {thickness_mm:g} leave {len(pieces)} pieces of core in this "
            "body. Make the shell thinner or the body larger"
        )
    return simplified(pieces[0], _SLIVERS_MM)


def contour_of(
    distance_mm: Float[np.ndarray, "x y z"], origin_mm: Float[np.ndarray, "3"], step_mm: float
) -> trimesh.Trimesh:
    """Return the surface on which distances at the points of a grid are 0, turned outwards."""
    import pyvista
    import trimesh

    spacing = (step_mm,) * 3
    grid = pyvista.ImageData(dimensions=distance_mm.shape, spacing=spacing, origin=tuple(origin_mm))
    grid["distance"] = distance_mm.ravel(order="F")
    contour: Any = grid.contour([0.0], scalars="distance", method="flying_edges")
    if not contour.n_points:
        return trimesh.Trimesh()
    contour = contour.triangulate().clean()
    surface = trimesh.Trimesh(contour.points, contour.faces.reshape(-1, 4)[:, 1:])
    surface.fix_normals()
    return surface


def _no_core(body: BodyKind, thickness_mm: float) -> str:
    return (
        f"a body of {' × '.join(f'{edge:.4g}' for edge in body.size_mm)} mm has no room for a core "
        f"inside walls of shell.thickness_mm = {thickness_mm:g}. Make the shell thinner or the body larger"
    )


@lru_cache(maxsize=96)
def patch_frame(body: BodyKind, number: int, inward_mm: float) -> FaceFrame:
    from scipy.interpolate import RectBivariateSpline

    field = distance_field(body)

    normal, x, y = face_axes(number)
    half = np.asarray(body.size_mm) / 2
    reach = [_REACH_SHARE * (float(abs(axis) @ half) - inward_mm) for axis in (x, y)]
    if min(reach) <= 0:
        raise _no_patch(number)
    nodes = [np.linspace(-r, r, 2 * _steps(r) + 1) for r in reach]
    u, v = np.meshgrid(*nodes, indexing="ij")
    top = float(abs(normal) @ half)
    start = u[..., None] * x + v[..., None] * y + top * normal
    height = _traced(field, inward_mm, start.reshape(-1, 3), normal).reshape(u.shape)
    # tips touch the body's surface alone, not the core's
    most = STEEPEST if inward_mm else STEEPEST_TOUCHED
    share, touched = (_known_share(nodes, height, steepest) for steepest in (STEEPEST, most))
    if share < 0.2:
        raise _no_patch(number)
    middle = height[len(nodes[0]) // 2, len(nodes[1]) // 2]
    filled = _filled(height)
    spline = RectBivariateSpline(nodes[0], nodes[1], filled - middle, s=0)
    extents, reach_mm = (
        (part * float(nodes[0][-1]), part * float(nodes[1][-1])) for part in (share, touched)
    )
    centre = (top + middle) * normal
    return FaceFrame(
        number, normal, x, y, centre, extents, SampledRelief(spline, reach_mm), round=True
    )


def _no_patch(number: int) -> InputError:
    return InputError(
        f"the surface about face {number} is too steep or too small for a patch. Leave the face out "
        "with body.sensed_faces, or turn the body"
    )


def _steps(reach_mm: float) -> int:
    """Number of steps of a patch's grid, from its middle to its side; a cubic spline needs two on either."""
    return min(max(int(np.ceil(reach_mm / _RELIEF_STEP_MM)), 2), _MOST_STEPS)


def _traced(
    field: DistanceField, inward_mm: float, start_mm: np.ndarray, normal: np.ndarray
) -> np.ndarray:
    """Return how far lines from above go (downwards negative) until they meet the surface; NaN if never."""
    travel = np.zeros(len(start_mm))
    lowest = -2 * float(start_mm[0] @ normal)
    moving = np.arange(len(start_mm))
    for _ in range(_MAX_TRACES):
        distance = field.evaluate(start_mm[moving] + travel[moving, None] * normal) + inward_mm
        travel[moving] -= distance
        moving = moving[(abs(distance) > _TRACED_MM) & (travel[moving] > lowest)]
        if not len(moving):
            break
    travel[moving] = np.nan
    return np.where(travel > lowest, travel, np.nan)


def _known_share(nodes: list[np.ndarray], height: np.ndarray, steepest: float) -> float:
    """Largest share of the half extents within which heights are known and no steeper than that."""
    with np.errstate(invalid="ignore"):
        steep = np.hypot(*np.gradient(height, *nodes)) > steepest
    u, v = np.meshgrid(*nodes, indexing="ij")
    radius = np.hypot(u / nodes[0][-1], v / nodes[1][-1])
    bad = ~np.isfinite(height) | steep
    return min(1.0, float(radius[bad].min()) - 1e-9) if bad.any() else 1.0


def _filled(height: np.ndarray) -> np.ndarray:
    """Unknown heights taken from the nearest known ones, where no place will ask for them."""
    from scipy.ndimage import distance_transform_edt

    missing = ~np.isfinite(height)
    nearest: Any = distance_transform_edt(missing, return_distances=False, return_indices=True)
    return height[tuple(nearest)]
