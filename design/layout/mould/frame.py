"""Opening, extents and parting plane of a mould: numbers alone.

A mould stands with `out` upwards when silicone is poured. Where the core's cavity runs out through
a whole side of the body, that side is open and a plug closes it ("open"). Where it runs out through
a bore, the core itself is cast in, held by a rod through the bore ("bore"); where it runs out
nowhere, by locating pins through its wire holes ("closed").
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from jaxtyping import Float

from design.body.meshes import undercut
from design.body.surface_chart import FACE_AXES
from design.layout.body import body_of
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    import trimesh

    from design.body.kinds.base import BodyKind, Opening
    from design.spec.object import ObjectSpec

_DOWN = 6
"""Face that points along −z (`FACE_AXES`): preferred as the open side, which is up while pouring."""
_STEP_DEG = 15.0
"""Step of the azimuths of parting planes that are tried for the least undercut."""
_WEDGE, _WEDGE_SINE = np.cos(np.deg2rad(15.0)), np.sin(np.deg2rad(15.0))
"""Cosine and sine of the sharpest wedge of plastic that a hole may leave next to the parting plane."""
_EDGES = 40
"""Triangles along a body, at least, where its undercuts are looked for."""
COMPLIANCE_FRACTION = 0.02
"""Share of its thickness by which silicone gives way on the spot, without room; an estimate."""
_AS_GOOD = 1e-4
"""Share of the surface by which an undercut may grow for a plane through the origin."""
FLANGE_THICKNESS_MM = 4.0
"""Thickness of each of the two flanges along the seam, one on either side of it."""
_FLANGE_WIDTH_MM = 8.0
"""Usual width of a flange: chosen, with walls of 1.9 mm next to its dowels."""
DOWEL_DIAMETER_MM, BOLT_HOLE_MM = 4.0, 3.4
"""Diameters of the dowels and of the holes for M3 bolts (ISO 273, medium fit) in the flanges' middle."""
_SLOPE = np.sin(np.deg2rad(2.0))
"""Sine of the slope below which an undercut does not count: facets crossed by the parting plane have it."""


@dataclass(frozen=True)
class MouldFrame:
    """A mould's axes and extents; lengths in mm along (across, along, out), origin the object's.

    `low_mm` and `high_mm` are the corners of the block. `plug_mm` are the lowest and the highest
    corner, across and along, of what passes through the side at `high_mm[2]`; zeros: nothing does.
    """

    opening: Opening
    across: Float[np.ndarray, "3"]
    length_axis: Float[np.ndarray, "3"]
    out: Float[np.ndarray, "3"]
    low_mm: Float[np.ndarray, "3"]
    high_mm: Float[np.ndarray, "3"]
    plug_mm: Float[np.ndarray, "2 2"]

    @property
    def axes(self) -> Float[np.ndarray, "3 3"]:
        """Columns across, along, out; they need not be right-handed."""
        return np.column_stack([self.across, self.length_axis, self.out])

    @property
    def plugged(self) -> bool:
        """Return whether a plug or a rod passes through the upper side."""
        return bool(self.plug_mm.any())

    @property
    def rim_mm(self) -> float:
        """Level of the block's upper side along `out`."""
        return float(self.high_mm[2])

    def corners(
        self, low_mm: Float[np.ndarray, "3"], high_mm: Float[np.ndarray, "3"]
    ) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
        """Lowest and highest corner, in the object's frame, of a box given along the axes."""
        ends = self.axes @ np.column_stack([low_mm, high_mm])
        return ends.min(axis=1), ends.max(axis=1)


@dataclass(frozen=True)
class Parting:
    """A plane as that between two halves: its unit normal, and how far along it from the origin, mm."""

    normal: Float[np.ndarray, "3"]
    offset_mm: float


def opening_of(spec: ObjectSpec) -> Opening:
    """Return how the core's cavity runs out of the silicone."""
    return body_of(spec).opening


def mould_style(spec: ObjectSpec) -> Literal["one-piece", "split"]:
    """The style given, else one piece where a side is open to draw the shell out of."""
    if spec.mould.style is not None:
        return spec.mould.style
    return "one-piece" if opening_of(spec) == "open" else "split"


def flange_width_mm(spec: ObjectSpec) -> float:
    """Width of a flange: its usual one, or what the printer's walls next to bolts and dowels need."""
    widest = max(BOLT_HOLE_MM, DOWEL_DIAMETER_MM + 2 * spec.printer.clearance_mm)
    return max(_FLANGE_WIDTH_MM, widest + 2 * spec.printer.wall_mm)


@cached_geometry
def mould_frame(spec: ObjectSpec) -> MouldFrame:
    """Axes and block of the object's mould. Of several open sides the lowest, else the first, is up.

    `across` is the axis with more walls at its ends: silicone is poured at those ends.
    """
    opening, out = opening_of(spec), _out(spec)
    # `out` is ±x, ±y or ±z: the other two axes are perpendicular to it (product 0, not ±1).
    x, y = (axis for axis in np.eye(3) if abs(axis @ out) < 0.5)
    across, length_axis = (y, x) if _open_ends(spec, x) > _open_ends(spec, y) else (x, y)
    low, high = envelope_corners_mm(spec)
    wall = spec.mould.wall_mm
    axes = np.column_stack([across, length_axis, out])
    ends = np.sort(axes.T @ np.column_stack([low, high]), axis=1)
    # An open side has no wall: the plug closes it.
    above = 0.0 if opening == "open" else wall
    block = ends[:, 0] - wall, ends[:, 1] + [wall, wall, above]
    return MouldFrame(opening, across, length_axis, out, *block, body_of(spec).passage_mm(axes))


def envelope_corners_mm(
    spec: ObjectSpec,
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Lowest and highest corner of the silicone's outside."""
    return body_of(spec).corners_mm


def up(spec: ObjectSpec) -> Float[np.ndarray, "3"]:
    """Unit vector that points upwards while silicone is poured.

    A closed mould stands on one of its corners: the opposite one, on the seam, is its highest
    point, far from the middles of the faces, and no ceiling lies flat.
    """
    frame = mould_frame(spec)
    if frame.opening != "closed":
        return frame.out
    # From the box's middle along the seam (`side`, level) until a side of the box, then up to its top.
    # 1e-9 stands for 0 where `side` is parallel to a side of the box, which it never meets.
    half = np.asarray(spec.body.size_mm) / 2
    side = np.cross(frame.out, parting(spec).normal)
    corner = float(np.min(half / np.maximum(abs(side), 1e-9))) * side + (half @ abs(frame.out)) * (
        frame.out
    )
    return corner / np.linalg.norm(corner)


@cached_geometry
def parting(spec: ObjectSpec) -> Parting:
    """The plane that parts the halves; it holds `out`.

    By default where the kind of body says, or where least of it is an undercut. Across a given azimuth it
    goes through the origin, but of a file's body, whose middle says little, where least is an undercut.
    """
    frame, given = mould_frame(spec), spec.mould.parting_azimuth_deg
    size = abs(frame.axes.T) @ np.asarray(spec.body.size_mm)
    azimuth = body_of(spec).parting_azimuth(size) if given is None else float(np.deg2rad(given))
    if azimuth is None:
        return silhouette_parting(body_of(spec).outside)
    normal = np.cos(azimuth) * frame.across + np.sin(azimuth) * frame.length_axis
    if not body_of(spec).from_file:
        return Parting(normal, 0.0)
    surface = _outside_in_small_triangles(body_of(spec).outside)
    return Parting(normal, least_undercut(surface, normal)[1])


def seam_ends_mm(spec: ObjectSpec, aside_mm: float = 0.0) -> tuple[float, float]:
    """Return where a level line next to the parting plane enters and leaves the block, across the mould;
    flanges begin there."""
    frame, plane = mould_frame(spec), parting(spec)
    # Slab method: where the line start + t · way meets the two sides of the block along each axis.
    # The last of the entries and the first of the exits bound what is inside; the axes along which
    # the line does not go (`steep` false) have no such t.
    way = frame.axes.T @ np.cross(frame.out, plane.normal)
    start = frame.axes.T @ ((plane.offset_mm + aside_mm) * plane.normal)
    steep = abs(way) > 1e-9
    ends = [(end - start)[steep] / way[steep] for end in (frame.low_mm, frame.high_mm)]
    return float(np.min(ends, axis=0).max()), float(np.max(ends, axis=0).min())


def undercut_depth_mm(spec: ObjectSpec) -> float:
    """Return by how much the outside must give way to the half that hooks it most (mm).

    An estimate from the body's surface, before a mould is built.
    """
    plane = parting(spec)
    return _hooked_mm(body_of(spec).outside, tuple(plane.normal.tolist()), plane.offset_mm)


@lru_cache(maxsize=512)
def _hooked_mm(body: BodyKind, normal: tuple[float, ...], offset_mm: float) -> float:
    """Return the greater depth of the two halves' undercuts; cached, as many shells share a seam."""
    import trimesh

    surface, pull = _outside_in_small_triangles(body), np.array(normal)
    side = np.sign(np.asarray(surface.triangles_center) @ pull - offset_mm)
    depths = []
    # A half's wall is the outside on its side, turned over, and is drawn away from the plane.
    for sign in (1, -1):
        faces = surface.faces[side == sign][:, ::-1]
        half = trimesh.Trimesh(surface.vertices, faces, process=False)
        depths.append(undercut(half, sign * pull, np.ones(len(faces), bool)).depth_mm)
    return float(max(depths))


def thin_at_seam(spec: ObjectSpec, ends_mm: Float[np.ndarray, "2 3"], radius_mm: float) -> bool:
    """Return whether a round hole along an axis leaves a wall to the parting plane that is too thin to print.

    Not where the plane cuts it, unless so near its side that a wedge of less than 15° is left.
    """
    return thin_beside(spec, ends_mm, parting(spec), radius_mm)


def thin_beside(
    spec: ObjectSpec, ends_mm: Float[np.ndarray, "2 3"], plane: Parting, radius_mm: float
) -> bool:
    """Return the same for any plane."""
    return wall_to_plane_mm(ends_mm, plane, radius_mm) < spec.printer.wall_mm


def wall_to_plane_mm(ends_mm: Float[np.ndarray, "2 3"], plane: Parting, radius_mm: float) -> float:
    """Return the wall that a round hole along an axis leaves to a plane (mm).

    0 where a wedge of less than 15° is left, ∞ where the plane cuts the hole.

    A hole that leans towards it may be cut at one end and leave a wall at the other; one that leans by
    15° or more leaves wedges alone.
    """
    # Signed distances of the axis' two ends, and the sine of the angle between axis and plane.
    aside = ends_mm @ plane.normal - plane.offset_mm
    lean = abs(aside[1] - aside[0]) / np.linalg.norm(ends_mm[1] - ends_mm[0])
    # A plane at distance d from the axis cuts the hole's side at the angle α with cos α = d / radius:
    # no sharper than 15° while d ≤ radius · cos 15°.
    if lean >= _WEDGE_SINE or abs(aside).max() <= radius_mm * _WEDGE:
        return float("inf")
    # From a point of its axis a leaning hole reaches radius / cos(angle) along the plane's normal.
    nearest = 0.0 if aside[0] * aside[1] <= 0 else float(abs(aside).min())
    return max(0.0, float(nearest - radius_mm / np.sqrt(1 - lean**2)))


def _out(spec: ObjectSpec) -> np.ndarray:
    """Return the outward normal of the side that is up: −z where it is open or no side is."""
    opened = spec.body.opened
    face = _DOWN if _DOWN in opened or not opened else opened[0]
    return np.asarray(FACE_AXES[face][0], float)


def _open_ends(spec: ObjectSpec, axis: np.ndarray) -> int:
    """Return how many open sides lie across an axis (their normals are ± the axis, or perpendicular)."""
    normals = [np.asarray(FACE_AXES[face][0], float) for face in spec.body.opened]
    return sum(abs(float(normal @ axis)) > 0.5 for normal in normals)


@lru_cache(maxsize=8)
def silhouette_parting(body: BodyKind) -> Parting:
    """Return the plane with the least undercut of those parallel to z.

    Tried are azimuths in steps of 15°, and for each the offset with the least undercut.
    """
    surface = _outside_in_small_triangles(body)
    best: tuple[float, Parting] | None = None
    for azimuth in np.deg2rad(45.0 + np.arange(0.0, 180.0, _STEP_DEG)):
        normal = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        hooked, offset = least_undercut(surface, normal)
        # Better by more than rounding: alike planes keep the first azimuth, which starts at 45°.
        if best is None or hooked < best[0] - 1e-7 * surface.area:
            best = hooked, Parting(normal, offset)
    assert best is not None
    return best[1]


@lru_cache(maxsize=8)
def _outside_in_small_triangles(body: BodyKind) -> trimesh.Trimesh:
    """Return the outer surface in triangles no longer than 1 / `_EDGES` of the body.

    A triangle counts for the side of a plane on which its middle lies. Those of a flat face may be as
    large as the face, and then stand for parts on both sides.
    """
    import trimesh

    surface = body.outer_surface()
    longest = float(max(surface.extents)) / _EDGES
    small = trimesh.remesh.subdivide_to_size(surface.vertices, surface.faces, longest)
    return trimesh.Trimesh(small[0], small[1], process=False)


def least_undercut(surface: trimesh.Trimesh, normal: Float[np.ndarray, "3"]) -> tuple[float, float]:
    """Return the least area that faces the wrong way next to a plane with that normal, and its offset.

    Areas are those projected along the normal, mm². The plane goes through the origin where that
    is as good as any.
    """
    rise = np.asarray(surface.face_normals) @ normal
    place = np.asarray(surface.triangles_center) @ normal
    order = np.argsort(place)
    area, rise, place = np.asarray(surface.area_faces)[order], rise[order], place[order]
    # A plane between triangles k − 1 and k: wrong are those below it (0 … k − 1) that face up, a sum
    # from the left, and those above it (k …) that face down, a sum from the right. All k at once.
    lower = np.append(0.0, np.cumsum(area * np.maximum(rise - _SLOPE, 0)))
    upper = np.append(np.cumsum((area * np.maximum(-rise - _SLOPE, 0))[::-1])[::-1], 0.0)
    wrong = lower + upper
    middle, least = int(np.searchsorted(place, 0.0)), int(np.argmin(wrong))
    if wrong[middle] <= wrong[least] + _AS_GOOD * float(area.sum()):
        return float(wrong[middle]), 0.0
    # The best plane stands halfway between the two triangles that it separates.
    ends = place[[max(least - 1, 0), min(least, len(place) - 1)]]
    return float(wrong[least]), float(ends.mean())
