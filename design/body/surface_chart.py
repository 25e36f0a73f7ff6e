"""A patch of the body's surface: a frame, and how high the surface lies over the frame's plane.

A point (x, y) of the plane stands for where the line through it along the frame's normal meets the
surface; a point at (x, y, h) lies h above that, along the surface's own normal there. A flat face is
the patch whose surface is its plane.

Parts are placed by these x and y. Contact locations are given by lengths along the surface instead
(`design.body.section_lengths`), so that equal steps lie evenly on it: `to_plane` and `from_plane`
lead from one to the other, and on flat faces they are the same.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Protocol, runtime_checkable

import numpy as np
from jaxtyping import Bool, Float

from design.body.section_lengths import SectionLengths, section_lengths

FACE_AXES = {
    1: ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    2: ((0, -1, 0), (0, 0, -1), (1, 0, 0)),
    3: ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    4: ((0, 1, 0), (0, 0, -1), (-1, 0, 0)),
    5: ((-1, 0, 0), (0, 0, -1), (0, -1, 0)),
    6: ((0, 0, -1), (1, 0, 0), (0, -1, 0)),
}
"""Face number → outward normal n and in-plane x, y (right-handed: x × y = n)."""

STEEPEST = np.tan(np.deg2rad(60))
"""Slope up to which a patch of a curved surface reaches."""
STEEPEST_TOUCHED = np.tan(np.deg2rad(75))
"""Slope up to which a tip that lands on a patch may touch the surface round it."""

_MAX_ITERATIONS = 60
_CONVERGED_MM = 1e-10
LARGEST_SQUARE = 0.97
"""Largest x²/a² + y²/b²: a cap is known up to a slope of 80°."""


@runtime_checkable
class Relief(Protocol):
    """Height of a surface over a frame's plane."""

    def evaluate(
        self, xy_mm: Float[np.ndarray, "*n 2"]
    ) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n 2"]]:
        """Height (mm) and its slopes along x and y; NaN where the patch does not reach."""
        ...


@dataclass(frozen=True)
class Cap:
    """Cap of an ellipsoid at the end of its third semi-axis; straight where one is infinite.

    c(√(1 − x²/a² − y²/b²) − 1): a plane has a = b = ∞, a cylinder one of them, a sphere a = b = c.
    """

    semi_axes_mm: tuple[float, float, float] = (np.inf, np.inf, 1.0)

    def evaluate(
        self, xy_mm: Float[np.ndarray, "*n 2"]
    ) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n 2"]]:
        across, c = np.asarray(self.semi_axes_mm[:2]), self.semi_axes_mm[2]
        share = xy_mm / across
        square = share[..., 0] ** 2 + share[..., 1] ** 2
        root = np.asarray(np.sqrt(1 - np.where(square <= LARGEST_SQUARE, square, np.nan)))
        return np.asarray(c * (root - 1)), -c * xy_mm / across**2 / root[..., None]


@dataclass(frozen=True)
class FaceFrame:
    """One sensed face: its number, orthonormal axes, centre, half extents (mm) and relief.

    The axes are those of the frame's plane, which touches the surface at the centre. A `round`
    face is an ellipse of its half extents, else a rectangle. `hole_mm` is the radius of the bore that
    leaves the body downwards, 0 where there is none.
    """

    number: int
    normal: Float[np.ndarray, "3"]
    x: Float[np.ndarray, "3"]
    y: Float[np.ndarray, "3"]
    centre_mm: Float[np.ndarray, "3"]
    half_extents_mm: tuple[float, float]
    relief: Relief = field(default_factory=Cap)
    round: bool = False
    hole_mm: float = 0.0

    @cached_property
    def flat(self) -> bool:
        """Return whether the surface is the frame's plane."""
        return self.relief == Cap()

    @cached_property
    def ends(self) -> tuple[bool, bool]:
        """Return whether the body itself ends at the border along x and y, not the patch alone.

        It does where the surface runs straight: on flat faces, and along a cylinder.
        """
        if not isinstance(self.relief, Cap):
            return False, False
        straight_x, straight_y = np.isinf(self.relief.semi_axes_mm[:2]).tolist()
        return straight_x, straight_y

    @cached_property
    def axes(self) -> Float[np.ndarray, "3 3"]:
        """Rotation whose columns are x, y, n: face coordinates to object coordinates; read-only."""
        axes = np.column_stack([self.x, self.y, self.normal])
        axes.flags.writeable = False
        return axes

    @cached_property
    def sections(self) -> tuple[SectionLengths | None, SectionLengths | None]:
        """Lengths along y = 0 and x = 0; None where such a section is straight."""
        if self.flat:
            return None, None
        half_x, half_y = self.half_extents_mm
        along_x, along_y = (partial(_slope_along, self.relief, axis) for axis in (0, 1))
        return section_lengths(along_x, half_x), section_lengths(along_y, half_y)

    def to_plane(self, place_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 2"]:
        """Contact locations, given by lengths along the surface, as (x, y) of the frame's plane."""
        return self._convert_by_sections(place_mm, "to_plane")

    def from_plane(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 2"]:
        """Inverse of `to_plane`."""
        return self._convert_by_sections(xy_mm, "to_lengths")

    def _convert_by_sections(self, given_mm: np.ndarray, way: str) -> np.ndarray:
        given = np.asarray(given_mm, float)
        columns = [
            given[..., k] if section is None else getattr(section, way)(given[..., k])
            for k, section in enumerate(self.sections)
        ]
        return np.stack(columns, axis=-1)

    def area_stretch(self, place_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n"]:
        """Area along the surface per area in lengths; NaN where the patch does not reach."""
        xy = self.to_plane(place_mm)
        _, slope = self.relief.evaluate(xy)
        rates = [
            1.0 if section is None else section.plane_rate(np.asarray(place_mm)[..., k])
            for k, section in enumerate(self.sections)
        ]
        return np.asarray(np.sqrt(1 + np.sum(slope**2, axis=-1)) * rates[0] * rates[1])

    @cached_property
    def lengths_mm(self) -> Float[np.ndarray, "2 2"]:
        """Least and greatest lengths along the sections, ends of x and y as columns; read-only."""
        half = np.asarray(self.half_extents_mm)
        ends = self.from_plane(np.stack([-half, half]))
        ends.flags.writeable = False
        return ends

    @property
    def half_lengths_mm(self) -> tuple[float, float]:
        """Lengths along both sections from the middle to the border, the shorter side of each."""
        x, y = abs(self.lengths_mm).min(axis=0).tolist()
        return x, y

    def border_mm(self, points: int = 240) -> Float[np.ndarray, "point 2"]:
        """The face's border as a closed polygon, in the coordinates of contact locations."""
        half = np.asarray(self.half_extents_mm)
        if self.round:
            turn = np.linspace(0, 2 * np.pi, points, endpoint=False)
            return self.from_plane(half * np.column_stack([np.cos(turn), np.sin(turn)]))
        return self.from_plane(half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]))

    def axes_at(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 3 3"]:
        """The same at places: n normal to the surface there, x in the plane of x and n."""
        if self.flat:
            return np.broadcast_to(self.axes, (*np.shape(xy_mm)[:-1], 3, 3)).copy()
        _, slope = self.relief.evaluate(np.asarray(xy_mm, float))
        return self.axes @ _local_axes(slope)

    def to_object(self, xyz_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Points given as (x, y, height above the surface) in mm, in the object's frame."""
        xyz = np.asarray(xyz_mm, float)
        return self.centre_mm + self.raised(xyz)[0] @ self.axes.T

    def raised(
        self, xyz_mm: Float[np.ndarray, "*n 3"]
    ) -> tuple[Float[np.ndarray, "*n 3"], Float[np.ndarray, "*n 3 3"]]:
        """Points given as (x, y, height above the surface) in mm, and the surface's axes there as columns,
        both in `plane_coordinates`: the same of faces whose reliefs are the same."""
        if self.flat:
            return xyz_mm, np.broadcast_to(np.eye(3), (*xyz_mm.shape, 3))
        height, slope = self.relief.evaluate(xyz_mm[..., :2])
        axes, foot = _local_axes(slope), np.concatenate([xyz_mm[..., :2], height[..., None]], -1)
        return foot + xyz_mm[..., 2:] * axes[..., 2], axes

    def plane_coordinates(self, points_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """(x, y, height over the frame's plane) of points in the object's frame."""
        return (np.asarray(points_mm, float) - self.centre_mm) @ self.axes

    def from_object(self, points_mm: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Inverse of `to_object`, by the foot of each point on the surface; NaN off the patch."""
        local = self.plane_coordinates(points_mm)
        if self.flat:
            return local
        points = local.reshape(-1, 3)
        xy, above = points[:, :2].copy(), np.full(len(points), np.nan)
        moving = np.arange(len(points))
        for _ in range(_MAX_ITERATIONS):
            (x, y, z), previous_xy = points[moving].T, xy[moving]
            height, slope = self.relief.evaluate(previous_xy)
            along_x, along_y = slope[:, 0], slope[:, 1]
            # sums over components take a third of the time of sums along an axis of three
            square = 1 + along_x**2 + along_y**2
            from_x, from_y = x - previous_xy[:, 0], y - previous_xy[:, 1]
            rise = (z - height - from_x * along_x - from_y * along_y) / square
            above[moving] = rise * np.sqrt(square)
            xy[moving] = np.stack([x + rise * along_x, y + rise * along_y], axis=-1)
            # a few points beside the patch never come to rest: the others must not wait for them
            moving = moving[np.any(abs(xy[moving] - previous_xy) > _CONVERGED_MM, axis=1)]
            if not len(moving):
                break
        return np.column_stack([xy, above]).reshape(local.shape)

    def covers(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Bool[np.ndarray, "*n"]:
        """Return whether places lie within the half extents."""
        share = np.asarray(xy_mm) / np.asarray(self.half_extents_mm)
        size = np.sum(share**2, axis=-1) if self.round else np.max(abs(share), axis=-1)
        return np.asarray(size <= 1 + 1e-9)

    def touched(self, xy_mm: Float[np.ndarray, "*n 2"]) -> Bool[np.ndarray, "*n"]:
        """Return whether tips that land on the face may touch the surface at places: on the face, and
        round a curved patch up to a slope of 75°, but where the body ends or has its bore."""
        covered = self.covers(xy_mm)
        if self.flat:
            return covered
        half = np.where(self.ends, self.half_extents_mm, np.inf)
        xy = np.asarray(xy_mm, float)
        # where the body itself ends a tip may hang over; not finite is nowhere
        within = np.all(np.isfinite(xy) & (abs(xy) <= half + 1e-9), axis=-1, keepdims=True)
        xy = np.where(within, xy, 0.0)
        slope = self.relief.evaluate(xy)[1]
        # not a number where the relief is not known, which no slope exceeds
        reached = within[..., 0] & (np.hypot(slope[..., 0], slope[..., 1]) <= STEEPEST_TOUCHED)
        if self.hole_mm:
            x, y, z = np.moveaxis(self.to_object(np.concatenate([xy, 0 * xy[..., :1]], -1)), -1, 0)
            reached &= (np.hypot(x, y) > self.hole_mm) | (z > 0)
        return covered | reached

    def tangent(self, xy_mm: Float[np.ndarray, "2"]) -> FaceFrame:
        """The flat face that touches this one at a place and calls the place (x, y) too."""
        if self.flat:
            return self
        xy = np.asarray(xy_mm, float)
        axes = self.axes_at(xy)
        origin = self.to_object(np.append(xy, 0.0)) - axes[:, :2] @ xy
        x, y, normal = axes.T
        return replace(self, normal=normal, x=x, y=y, centre_mm=origin, relief=Cap())

    def project_along(
        self,
        points_mm: Float[np.ndarray, "n 3"],
        line_direction: Float[np.ndarray, "3"] | Float[np.ndarray, "n 3"],
    ) -> Float[np.ndarray, "n 3"]:
        """Return where lines through points along a direction (out of the surface) meet the surface.

        In the coordinates of `plane_coordinates`; NaN where they miss the patch. Newton from outside, which
        converges from one side on a convex surface.
        """
        start = self.plane_coordinates(points_mm)
        direction = np.broadcast_to(line_direction @ self.axes, start.shape)
        offset, moving = np.zeros(len(start)), np.arange(len(start))
        for _ in range(_MAX_ITERATIONS):
            way = direction[moving]
            point = start[moving] + offset[moving, None] * way
            height, slope = self.relief.evaluate(point[:, :2])
            rise = way[:, 2] - slope[:, 0] * way[:, 0] - slope[:, 1] * way[:, 1]
            step = (point[:, 2] - height) / np.where(rise > 0, rise, np.nan)
            offset[moving] -= step
            moving = moving[abs(step) > _CONVERGED_MM]
            if not len(moving):
                break
        offset[moving] = np.nan
        return start + offset[:, None] * direction


def face_axes(number: int) -> tuple[Float[np.ndarray, "3"], ...]:
    """Outward normal, x and y of the face of that number."""
    return tuple(np.asarray(axis, float) for axis in FACE_AXES[number])


def flat_frame(number: int, half_mm: Float[np.ndarray, "3"], inward_mm: float = 0.0) -> FaceFrame:
    """A face of a centred box of those half edges, or of the one `inward_mm` within it."""
    normal, x, y = face_axes(number)
    extents = (float(abs(x) @ half_mm) - inward_mm, float(abs(y) @ half_mm) - inward_mm)
    centre = normal * (abs(normal) @ half_mm) - inward_mm * normal
    return FaceFrame(number, normal, x, y, centre, extents)


def less_on_faces(
    low_mm: Float[np.ndarray, "3"],
    high_mm: Float[np.ndarray, "3"],
    layer_mm: float,
    faces: tuple[int, ...],
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Corners of a box without a layer on some faces."""
    for face in faces:
        layer = layer_mm * face_axes(face)[0]
        high_mm, low_mm = high_mm - layer.clip(min=0), low_mm - layer.clip(max=0)
    return low_mm, high_mm


def cap_frame(
    number: int, semi_axes_mm: Float[np.ndarray, "3"], middle_mm: Float[np.ndarray, "3"]
) -> FaceFrame:
    """The patch of an ellipsoid, of those semi-axes along x, y, z about its middle, at a face's end."""
    normal, x, y = face_axes(number)
    a, b, c = (float(abs(axis) @ semi_axes_mm) for axis in (x, y, normal))
    extents = (steepest_reach_mm(a, c), steepest_reach_mm(b, c))
    centre = middle_mm + normal * c
    return FaceFrame(number, normal, x, y, centre, extents, Cap((a, b, c)), round=True)


def steepest_reach_mm(across_mm: float, high_mm: float) -> float:
    """Return where a cap of those semi-axes is as steep as a patch may be; 0 where there is no cap."""
    if across_mm <= 0:
        return 0.0
    return across_mm * STEEPEST / float(np.hypot(STEEPEST, high_mm / across_mm))


def _slope_along(
    relief: Relief, axis: int, at_mm: Float[np.ndarray, "*n"]
) -> Float[np.ndarray, "*n"]:
    """Slope of the central section along x (0) or y (1)."""
    return relief.evaluate(at_mm[..., None] * np.eye(2)[axis])[1][..., axis]


def _normals(slope: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 3"]:
    """Outward normals of a surface of those slopes, in its frame."""
    along_x, along_y = slope[..., 0], slope[..., 1]
    normal = np.empty((*along_x.shape, 3))
    upward = normal[..., 2] = 1 / np.sqrt(1 + along_x**2 + along_y**2)
    normal[..., 0] = -along_x * upward
    normal[..., 1] = -along_y * upward
    return normal


def _local_axes(slope: Float[np.ndarray, "*n 2"]) -> Float[np.ndarray, "*n 3 3"]:
    """Axes as columns: along the surface above x, across it, and its normal."""
    axes = np.empty((*slope.shape[:-1], 3, 3))
    axes[..., 2] = normal = _normals(slope)
    ahead = 1 / np.sqrt(1 + slope[..., 0] ** 2)
    climb = ahead * slope[..., 0]
    axes[..., 0, 0], axes[..., 1, 0], axes[..., 2, 0] = ahead, 0.0, climb
    # normal × x, written out: NumPy's function takes ten times as long on one place
    axes[..., 0, 1] = normal[..., 1] * climb
    axes[..., 1, 1] = normal[..., 2] * ahead - normal[..., 0] * climb
    axes[..., 2, 1] = -normal[..., 1] * ahead
    return axes
