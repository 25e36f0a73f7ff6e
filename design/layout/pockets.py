"""Rigid bodies on a face and the pockets that take them, in the face's own frame.

A body is a magnet or a sensor board. Its pocket is a prism of its outline along the body's
axis, from under it out through the face; both turn about the body's centre. Heights are above the
face that the pocket opens to, so that everything here is below 0.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from jaxtyping import Float

from design.spec.cached_geometry import cached_geometry, read_only

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame
    from design.spec.magnets import Places
    from design.spec.object import ObjectSpec


PerFace = TypeVar("PerFace")


@dataclass(frozen=True)
class Outline:
    """Cross-section of a body or a pocket: a disk of `half_mm[0]`, or a rectangle of half edges."""

    half_mm: tuple[float, float]
    round: bool

    @property
    def area_mm2(self) -> float:
        x, y = self.half_mm
        return float(np.pi * x * y) if self.round else 4 * x * y

    @property
    def radius_mm(self) -> float:
        """Radius of the circumscribed circle."""
        return self.half_mm[0] if self.round else float(np.hypot(*self.half_mm))

    def inset(self, by_mm: float) -> Outline:
        """The outline that lies `by_mm` inside this one."""
        x, y = (half - by_mm for half in self.half_mm)
        return Outline((x, y), self.round)

    def support_mm(self, across: Float[np.ndarray, "2"]) -> float:
        """Largest dot product of a vector in the outline's plane with its points."""
        if self.round:
            return self.half_mm[0] * float(np.hypot(*across))
        return float(abs(across) @ np.asarray(self.half_mm))

    def signed_distance_mm(self, xy_mm: Float[np.ndarray, "n 2"]) -> Float[np.ndarray, "n"]:
        """Distance of points in the outline's plane to it, negative inside."""
        if self.round:
            return np.linalg.norm(xy_mm, axis=1) - self.half_mm[0]
        beyond = abs(xy_mm) - np.asarray(self.half_mm)
        outside = np.linalg.norm(np.clip(beyond, 0, None), axis=1)
        return outside + np.clip(beyond.max(axis=1), None, 0)

    def corners_mm(self, sides: int) -> Float[np.ndarray, "corner 2"]:
        """Polygon of the outline's own area, counter-clockwise: `sides` corners where it is round."""
        if not self.round:
            return np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.asarray(self.half_mm)
        angle = 2 * np.pi / sides
        radius = self.half_mm[0] * np.sqrt(angle / np.sin(angle))
        theta = (np.arange(sides) + 0.5) * angle
        return radius * np.column_stack([np.cos(theta), np.sin(theta)])


@dataclass(frozen=True)
class Body:
    """A rigid body at rest on a face: centre (mm), its axes as columns (the third outward)."""

    centre_mm: Float[np.ndarray, "3"]
    frame: Float[np.ndarray, "3 3"]
    outline: Outline
    height_mm: float
    label: str
    """Name in the specification, for errors."""

    @property
    def volume_mm3(self) -> float:
        return self.outline.area_mm2 * self.height_mm


@dataclass(frozen=True)
class Pocket:
    """The pocket of a body: its floor touches the body's lower side."""

    body: Body
    outline: Outline

    @property
    def axis(self) -> Float[np.ndarray, "3"]:
        return self.body.frame[:, 2]

    @property
    def mouth_mm(self) -> float:
        """Distance along the axis from the body's centre to the face's plane."""
        return float(-self.body.centre_mm[2] / self.axis[2])

    @property
    def volume_mm3(self) -> float:
        """Volume that is left out: the face cuts the prism obliquely, but at its mean length."""
        return self.outline.area_mm2 * (self.body.height_mm / 2 + self.mouth_mm)

    @cached_property
    def axis_ends_mm(self) -> Float[np.ndarray, "2 3"]:
        """On the axis: the floor's centre, and the height that the mouth's highest point has."""
        beyond = self._support_mm(np.array([0.0, 0.0, 1.0])) / self.axis[2]
        ends = np.array([-self.body.height_mm / 2, self.mouth_mm + beyond])
        return read_only(self.body.centre_mm + ends[:, None] * self.axis)

    @property
    def lowest_mm(self) -> float:
        """Height of the pocket's lowest point, negative."""
        return float(self.axis_ends_mm[0, 2] - self._support_mm(np.array([0.0, 0.0, 1.0])))

    @cached_property
    def reach_mm(self) -> Float[np.ndarray, "2"]:
        """Largest |x| and |y| within the pocket and its mouth."""
        lean = self.axis[:2] / self.axis[2]
        middle = self.body.centre_mm[:2] + self.mouth_mm * self.axis[:2]
        reach = []
        for k, direction in enumerate(np.eye(3)[:2]):
            floor = abs(self.axis_ends_mm[0, k]) + self._support_mm(direction)
            # along the axis, the mouth's points lie where the face cuts the prism
            mouth = abs(middle[k]) + self._support_mm(
                direction - lean[k] * np.array([0.0, 0.0, 1.0])
            )
            reach.append(max(floor, mouth))
        return read_only(np.array(reach))

    def _support_mm(self, direction: Float[np.ndarray, "3"]) -> float:
        return self.outline.support_mm(direction @ self.body.frame[:, :2])


@cached_geometry
def shell_bodies(spec: ObjectSpec) -> tuple[tuple[Body, ...], ...]:
    """Return what moves with the silicone, face by face, heights above the body's face."""
    return magnet_bodies(spec) if spec.arrangement == "sensors-in-core" else sensor_boards(spec)


@cached_geometry
def shell_pockets(spec: ObjectSpec) -> tuple[tuple[Pocket, ...], ...]:
    """The shell's pockets, face by face: round ones as much wider than their bodies as
    `shell.pocket_diameter_mm` is than the widest."""
    return tuple(
        tuple(Pocket(body, _pocket_outline(spec, body.outline)) for body in face)
        for face in shell_bodies(spec)
    )


def _pocket_outline(spec: ObjectSpec, body: Outline) -> Outline:
    if not body.round:
        return body
    narrower = widest_mm(spec) - 2 * body.half_mm[0]
    radius = (spec.shell.pocket_diameter_mm - narrower) / 2
    return Outline((radius, radius), True)


@cached_geometry
def core_pockets(spec: ObjectSpec) -> tuple[tuple[Pocket, ...], ...]:
    """The core's pockets for magnets, face by face, heights above the core's face."""
    if spec.arrangement == "sensors-in-core":
        return ((),) * len(spec.body.sensed)
    return tuple(tuple(Pocket(body, body.outline) for body in face) for face in magnet_bodies(spec))


@cached_geometry
def magnet_bodies(spec: ObjectSpec) -> tuple[tuple[Body, ...], ...]:
    """Magnets of every face, in the order of `magnets.positions_mm`; of one list all faces share them.

    A ring is the body of its outline: its hole is full of the glue that holds it.
    """
    magnets, sizes = spec.magnets, spec.magnets.sizes
    tilts = magnets.tilt_deg or ((0.0, 0.0),) * magnets.count
    depths = magnets.depths_mm or tuple(_seated_depth_mm(spec, size.height_mm) for size in sizes)
    rows = list(zip(depths, tilts, sizes, strict=True))

    def bodies_on_face(key: str, places: Places) -> tuple[Body, ...]:
        return tuple(
            Body(
                np.array([x, y, -depth]),
                tilted_frame(*tilt),
                Outline(size.half_mm, size.shape != "block"),
                size.height_mm,
                f"{key}[{index}] = ({x:g}, {y:g})"
                + (f" with tilt_deg {list(tilt)}" if magnets.tilt_deg else ""),
            )
            for index, ((x, y), (depth, tilt, size)) in enumerate(zip(places, rows, strict=True))
        )

    if len(magnets.lists) == 1:
        return (bodies_on_face("magnets.positions_mm", magnets.lists[0]),) * len(spec.body.sensed)
    return tuple(
        bodies_on_face(f"face {face}: magnets.positions_mm", places)
        for face, places in zip(spec.body.sensed, magnet_places(spec), strict=True)
    )


def magnet_places(spec: ObjectSpec) -> tuple[Places, ...]:
    """x, y (mm, in the face's frame) of every magnet, sensed face by face."""
    lists = spec.magnets.lists
    return lists_of_sensed_faces(spec, lists * len(spec.body.sensed) if len(lists) == 1 else lists)


@cached_geometry
def widest_mm(spec: ObjectSpec) -> float:
    """Diameter of the widest round magnet."""
    return max(size.diameter_mm for size in spec.magnets.sizes)


def _seated_depth_mm(spec: ObjectSpec, height_mm: float) -> float:
    """Depth of a magnet's mid-plane below the face that its pocket opens to."""
    if spec.arrangement == "sensors-in-core":
        return spec.shell.pocket_depth_mm - height_mm / 2
    return spec.magnets.depth_below_core_face_mm + height_mm / 2


@cached_geometry
def sensor_places(spec: ObjectSpec) -> tuple[tuple[tuple[float, float, float], ...], ...]:
    """x, y (mm, in the face's frame) and azimuth (rad) of every sensor, sensed face by face."""
    return lists_of_sensed_faces(spec, spec.sensors.places)


def lists_of_sensed_faces(spec: ObjectSpec, lists: tuple[PerFace, ...]) -> tuple[PerFace, ...]:
    """The sensed faces' own: lists for faces 1, 2, …, over again where there are more faces."""
    sensed = spec.body.sensed
    if len(lists) == len(sensed):
        return lists
    return tuple(lists[(number - 1) % len(lists)] for number in sensed)


@cached_geometry
def sensor_boards(spec: ObjectSpec) -> tuple[tuple[Body, ...], ...]:
    """Sensor boards in the shell, seated on the floors of their pockets."""
    width, length, thickness = spec.sensors.package_mm
    outline = Outline((width / 2, length / 2), False)
    depth = boards_depth_mm(spec)
    return tuple(
        tuple(
            Body(
                np.array([x, y, -depth]),
                board_frame(azimuth),
                outline,
                thickness,
                f"sensor {index + 1} of face {face} at ({x:.4g}, {y:.4g})",
            )
            for index, (x, y, azimuth) in enumerate(places)
        )
        for face, places in zip(spec.body.sensed, sensor_places(spec), strict=True)
    )


def boards_depth_mm(spec: ObjectSpec) -> float:
    """Depth below a face of the mid-height of boards in the shell."""
    return spec.shell.pocket_depth_mm - spec.sensors.package_mm[2] / 2


def board_frame(
    azimuth_rad: float | Float[np.ndarray, "*board"],
) -> Float[np.ndarray, "*board 3 3"]:
    """Axes of sensor boards as columns: −tangential, radial outward, the face's normal."""
    cosine, sine = np.cos(azimuth_rad), np.sin(azimuth_rad)
    frame = np.zeros((*np.shape(azimuth_rad), 3, 3))
    frame[..., 0, 0] = frame[..., 1, 1] = sine
    frame[..., 0, 1], frame[..., 1, 0] = cosine, -cosine
    frame[..., 2, 2] = 1.0
    return frame


def tilted_frame(about_x_deg: float, about_y_deg: float) -> Float[np.ndarray, "3 3"]:
    """Rotation by the rotation vector (about x, about y, 0); its third column is the axis."""
    turn = np.deg2rad([about_x_deg, about_y_deg])
    angle = float(np.hypot(*turn))
    across = np.array([[0, 0, turn[1]], [0, 0, -turn[0]], [-turn[1], turn[0], 0]])
    turn_part = np.sinc(angle / np.pi) * across
    return np.eye(3) + turn_part + 0.5 * np.sinc(angle / (2 * np.pi)) ** 2 * across @ across


def near_pairs(
    ends_mm: Sequence[Float[np.ndarray, "2 3"]], reach_mm: Sequence[float]
) -> Iterator[tuple[int, int, float]]:
    """Numbers of straight pieces whose axes are no further apart than their reaches together, and the
    distance (mm) of the axes, in order.

    A tree of their middles leaves only neighbours to be measured.
    """
    from scipy.spatial import KDTree

    if len(ends_mm) < 2:
        return
    ends, reach = np.stack(ends_mm), np.array(reach_mm)
    halves = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / 2
    pairs = KDTree(ends.mean(axis=1)).query_pairs(
        2 * float((halves + reach).max()), output_type="ndarray"
    )
    pairs = pairs[np.lexsort(pairs.T[::-1])]
    for some in np.array_split(pairs, 1 + len(pairs) // _PAIRS_AT_ONCE):
        index_a, index_b = some.T
        distance = distances_of_segments_mm(ends[index_a], ends[index_b])
        meet = distance <= reach[index_a] + reach[index_b]
        yield from zip(
            index_a[meet].tolist(), index_b[meet].tolist(), distance[meet].tolist(), strict=True
        )


_PAIRS_AT_ONCE = 100_000
"""Their arrays take some 50 MB."""


def distance_of_segments_mm(a: Float[np.ndarray, "2 3"], b: Float[np.ndarray, "2 3"]) -> float:
    """Smallest distance between two straight pieces, given by their ends."""
    return float(np.linalg.norm(_way_between(a, b)))


def smallest_gap_mm(ends_mm: Float[np.ndarray, "n 2 3"], reach_mm: Float[np.ndarray, "n"]) -> float:
    """Smallest distance between any two of n rods with round ends; infinite of fewer than two."""
    first, second = np.triu_indices(len(ends_mm), 1)
    apart = distances_of_segments_mm(ends_mm[first], ends_mm[second])
    return float(np.min(apart - reach_mm[first] - reach_mm[second], initial=np.inf))


def distances_of_segments_mm(
    a: Float[np.ndarray, "*n 2 3"], b: Float[np.ndarray, "*n 2 3"]
) -> Float[np.ndarray, "*n"]:
    """Smallest distances (mm) between the two straight pieces of every pair, given by their ends."""
    return np.linalg.norm(_way_between(a, b), axis=-1)


def _way_between(
    a: Float[np.ndarray, "*n 2 3"], b: Float[np.ndarray, "*n 2 3"]
) -> Float[np.ndarray, "*n 3"]:
    p, q = a[..., 0, :], b[..., 0, :]
    way_a, way_b, between = a[..., 1, :] - p, b[..., 1, :] - q, p - q
    aa, bb, ab = np.vecdot(way_a, way_a), np.vecdot(way_b, way_b), np.vecdot(way_a, way_b)
    pa, pb = np.vecdot(way_a, between), np.vecdot(way_b, between)
    determinant = aa * bb - ab**2
    parallel = determinant < 1e-12 * aa * bb
    across = _share((ab * pb - bb * pa) / np.where(parallel, 1.0, determinant))
    s = np.where(parallel, 0.0, across)
    t = _share((ab * s + pb) / bb)
    s = _share((ab * t - pa) / aa)
    return between + s[..., None] * way_a - t[..., None] * way_b


def _share(of_length: Any) -> Any:
    """From one end to the other; NumPy's clip takes five times as long on one number."""
    return np.minimum(np.maximum(of_length, 0.0), 1.0)


def axis_in_object_mm(frame: FaceFrame, pocket: Pocket) -> Float[np.ndarray, "2 3"]:
    """`axis_ends_mm` in the object's frame: a pocket lies in the plane that touches its face there."""
    return frame.tangent(pocket.body.centre_mm[:2]).to_object(pocket.axis_ends_mm)


def neighbours(frames: tuple[FaceFrame, ...]) -> list[tuple[FaceFrame, FaceFrame]]:
    """Pairs of faces that lie next to each other: of a box the ones that meet at an edge."""
    return [(a, b) for a, b in combinations(frames, 2) if abs(a.normal @ b.normal) < 0.5]


@dataclass(frozen=True)
class PocketEnds:
    """Pockets of one face: their axes in the object's frame, and radii of their circumscribed circles."""

    axes_mm: Float[np.ndarray, "pocket 2 3"]
    radii_mm: Float[np.ndarray, "pocket"]


def pocket_ends(frame: FaceFrame, pockets: tuple[Pocket, ...]) -> PocketEnds:
    """Return where the pockets of a face lie in the object."""
    axes = [axis_in_object_mm(frame, pocket) for pocket in pockets]
    radii = [pocket.outline.radius_mm for pocket in pockets]
    return PocketEnds(np.reshape(axes, (-1, 2, 3)), np.asarray(radii, float))


def gaps_across_edge_mm(ones: PocketEnds, others: PocketEnds) -> Float[np.ndarray, "one other"]:
    """Silicone between pockets of two faces: the largest gap along either axis and along the shortest
    way between the axes, at most the true one.

    Negative where none of these ways is free.
    """
    a, b = np.broadcast_arrays(ones.axes_mm[:, None], others.axes_mm[None])
    way = _way_between(a, b)
    ways = np.stack([way, a[..., 1, :] - a[..., 0, :], b[..., 1, :] - b[..., 0, :]], axis=-2)
    length = np.linalg.norm(ways, axis=-1, keepdims=True)
    d = ways / np.where(length > 0, length, np.nan)  # axes that meet have no way between them
    reach = sum(
        radii[..., None] * np.sqrt(np.maximum(1 - np.vecdot(d, d[..., k : k + 1, :]) ** 2, 0.0))
        for radii, k in ((ones.radii_mm[:, None], 1), (others.radii_mm[None], 2))
    )
    shares_a, shares_b = (d @ np.swapaxes(ends, -1, -2) for ends in (a, b))
    apart = np.maximum(
        shares_a.min(axis=-1) - shares_b.max(axis=-1), shares_b.min(axis=-1) - shares_a.max(axis=-1)
    )
    return np.nanmax(apart - reach, axis=-1)
