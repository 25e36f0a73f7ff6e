"""Limits of layouts on faces that are curved or differ in size: every part lies under its own surface."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import torch
from jaxtyping import Float
from scipy.interpolate import RectBivariateSpline
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.fit.boards import distance_beyond_core_mm
from design.fit.curved import room_for_recesses
from design.layout.body import body_of, face_frames
from design.spec.cached_geometry import SpecAlike, cached_geometry
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts
from estimator.layouts.limits.gaps import (
    Prisms,
    missing_between_boxes_mm,
)
from estimator.layouts.limits.parts import (
    SLACK_MM,
    Boards,
    Pockets,
    boards_of,
    chips_near_magnets_mm,
    missing_beside_hole_mm,
    outlines_mm,
    pocket_gaps_across_edges_mm,
    pocket_gaps_mm,
    pockets_of,
    prisms_in_object,
)
from estimator.layouts.surfaces import (
    Surface,
    clamp_to_patch_mm,
    pointwise,
    surfaces,
    to_object,
    turned_to_object,
)

_COVER_STEP_MM, _RIM_POINTS = 1.0, 24
"""Step of the nodes of the cover's splines along a face, about, and points on a magnet's rim."""
_FEWEST_NODES = 8
"""Nodes along an edge of a small face, at least; a bicubic spline needs four."""


def broken_on_surfaces_mm(
    spec: ObjectSpec, layouts: Layouts, face: int, pocket_gap_mm: float, board_gap_mm: float
) -> dict[str, Float[Tensor, "layout"]]:
    """Return by how much each rule of pockets, boards and chips is broken (mm), on the worst face.

    Rules of boards are left out where the search does not move the sensors.
    """
    by_number = surfaces(spec)
    laid = {number: layouts.layouts_of_face(number) for number in by_number}
    pockets = {n: laid[n].kept("pockets", (), lambda n=n: pockets_of(spec, laid[n])) for n in laid}
    of_faces = {n: _placed(surface, laid[n], pockets[n]) for n, surface in by_number.items()}
    placed = {n: prisms_in_object(by_number[n].frame, prisms) for n, prisms in of_faces.items()}
    centres = {n: to_object(s.frame, s.magnets(laid[n])[0]) for n, s in by_number.items()}
    moving = spec.search.vary.sensor_reach_mm is not None
    radius, judged = pockets[face].radius, _unlike(by_number, laid)

    def worst(
        rule: Callable[[int], Float[Tensor, "layout"]], numbers: Sequence[int] = judged
    ) -> Float[Tensor, "layout"]:
        return torch.stack([rule(number) for number in numbers]).amax(dim=0)

    def chips_near_magnets(number: int) -> Float[Tensor, "layout"]:
        surface = by_number[number]
        chips = to_object(surface.chip_frame, surface.chips(laid[number])[0])
        return chips_near_magnets_mm(spec, number, chips, centres)

    violations = {
        "pocket gap": worst(lambda n: pocket_gaps_mm(*of_faces[n][:2], radius, pocket_gap_mm)),
        "pockets near the edge": worst(lambda n: past_border(by_number[n], pockets[n])),
        "pocket gap across an edge": pocket_gaps_across_edges_mm(
            spec, placed, radius, pocket_gap_mm
        ),
        "seal": worst(lambda n: unsealed_mm(by_number[n], laid[n], pockets[n])),
        "chip near a magnet": worst(chips_near_magnets, judged if moving else (face,)),
    }
    if moving:
        boards = {n: laid[n].kept("boards", (), lambda n=n: boards_of(spec, laid[n])) for n in laid}
        recesses = {n: recess_boxes(s, laid[n], boards[n]) for n, s in by_number.items()}
        # Recesses of all faces together: boards of two faces may meet at an edge.
        centre, axes, half_mm = (
            torch.cat(parts, dim=1) for parts in zip(*recesses.values(), strict=True)
        )
        least = board_gap_mm + SLACK_MM
        violations["board gap"] = missing_between_boxes_mm(centre, axes, half_mm, least)
        violations["board beside the wire hole"] = worst(
            lambda n: boards_beside_hole(by_number[n], recesses[n])
        )
        violations["boards near the edge"] = worst(
            lambda n: boards_past_edges(by_number[n], laid[n], recesses[n])
        )
    return violations


_SIDES = frozenset((2, 3, 4, 5))
"""Faces that are turned into each other about z."""


def _unlike(by_number: Mapping[int, Surface], laid: Mapping[int, Layouts]) -> list[int]:
    """Return faces that stand for all: of sides of one shape with the same layouts the first, where all four
    are sensed, so that the object is the same from each of them."""
    turned = by_number.keys() >= _SIDES
    keys = {
        n: (s.shape, id(laid[n])) if turned and n in _SIDES else n for n, s in by_number.items()
    }
    return [*{key: number for number, key in reversed(keys.items())}.values()]


def _placed(surface: Surface, layouts: Layouts, pockets: Pockets) -> Prisms:
    """Return the pockets of a face in its frame, turned with the surface over each magnet."""

    def turned() -> Prisms:
        centre, axes = surface.magnets(layouts)
        # `pockets` stand on a flat face: take their ends about the magnet's centre there, and turn those.
        local = torch.stack([*layouts.magnet_mm[..., :2].unbind(-1), -layouts.magnet_mm[..., 2]])
        turn = axes.permute(2, 3, 0, 1)
        # i coordinate of the face, j axis of the surface, l layout, m magnet
        floor, top = (
            centre.permute(2, 0, 1) + torch.einsum("ijlm,jlm->ilm", turn, ends - local)
            for ends in (pockets.floor, pockets.top)
        )
        return floor, top, torch.einsum("ijlm,jlm->ilm", turn, pockets.axis)

    return layouts.kept(("placed pockets", surface.shape), (), turned)


def past_border(surface: Surface, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Return how far pockets reach beyond the patch (mm), summed over magnets.

    A box's patch is smaller: its border belongs to the neighbouring face's pockets, to the depth of
    the deepest one.
    """
    frame = surface.frame
    half = torch.tensor(frame.half_extents_mm, dtype=pockets.reach.dtype)
    reach = pockets.reach
    if frame.round:
        # Inside an ellipse where (x/a)² + (y/b)² ≤ 1. What is beyond 1 counts times the shorter half axis.
        share = ((reach + SLACK_MM) / half[:, None, None]).square().sum(0).sqrt()
        return torch.relu((share - 1) * half.min()).sum(dim=1)
    if body_of(surface.spec).cuboid:
        reach = reach + (-pockets.lowest).amax(dim=1, keepdim=True)
    return torch.relu(reach + SLACK_MM - half[:, None, None]).sum(dim=(0, 2))


def unsealed_mm(surface: Surface, layouts: Layouts, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Return the silicone missing over magnets and under pockets (mm), summed over magnets."""
    spec, depth = surface.spec, layouts.magnet_mm[..., 2]
    least = spec.silicone.thinnest_wall_mm + SLACK_MM
    if surface.frame.flat:
        # A cylinder tilted by θ reaches r sin θ + (h/2) cos θ above its centre; `up` is cos θ.
        # 1e-12 keeps the derivative of the root finite at θ = 0.
        up = pockets.axis[2]
        tilted = (1 - up * up).clamp(min=1e-12).sqrt()
        radius, half = outlines_mm(spec, depth.dtype)
        cover = depth - radius * tilted - up * half
    else:
        covers, which = covers_of(spec)[surface.number], spec.magnets.numbers_by_size
        parts = [
            pointwise(size_cover.wall_over, layouts.magnet_mm[:, magnets])[..., 0]
            for size_cover, magnets in zip(covers, which, strict=True)
        ]
        # Covers come size by size: back to the order of the magnets.
        cover = torch.cat(parts, dim=1)[:, np.argsort(np.concatenate(which))]
    # Pockets end on the core's side at `lowest` (below 0, from the outer face); a wall stays under them.
    above = torch.relu(least - cover)
    below = torch.relu(-pockets.lowest + least - spec.shell.thickness_mm)
    return (above + below).sum(dim=1)


@dataclass(frozen=True)
class _Cover:
    """Silicone over magnets without tilt, of one face, as `design.layout.places.positions.cover_mm`.

    Splines over the patch at two depths (mm, of a magnet's centre); straight between and beyond them.
    """

    frame: FaceFrame
    depths_mm: tuple[float, float]
    splines: tuple[RectBivariateSpline, RectBivariateSpline]

    def wall_over(self, xyd_mm: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 1"]:
        x, y = clamp_to_patch_mm(self.frame, xyd_mm[:, :2]).T
        shallow, deep = (spline(x, y, grid=False) for spline in self.splines)
        first, last = self.depths_mm
        share = (xyd_mm[:, 2] - first) / (last - first)
        return (shallow + share * (deep - shallow))[:, None]


@cached_geometry
def covers_of(spec: ObjectSpec) -> dict[int, tuple[_Cover, ...]]:
    """Return the covers of every curved face, for a magnet of each of the specification's sizes."""
    digest = body_of(spec).digest
    return {
        frame.number: tuple(
            _cover(SpecAlike(spec, (index, size, spec.body, spec.shell, digest)))
            for size in spec.magnets.distinct_sizes
        )
        for index, frame in enumerate(face_frames(spec))
        if not frame.flat
    }


@lru_cache(maxsize=64)
def _cover(alike: SpecAlike) -> _Cover:
    """Return the cover of the sensed face and the size of magnet that the key begins with."""
    spec, (index, size, *_) = alike.spec, alike.key
    frame = face_frames(spec)[index]
    half = np.asarray(frame.half_extents_mm)
    nodes = [
        np.linspace(-h, h, max(_FEWEST_NODES, int(np.ceil(2 * h / _COVER_STEP_MM)))) for h in half
    ]
    x, y = np.meshgrid(*nodes, indexing="ij")
    xy = clamp_to_patch_mm(frame, np.column_stack([x.ravel(), y.ravel()]))
    # Least silicone over a magnet is over some point of its upper rim: take the highest one.
    turn = np.linspace(0, 2 * np.pi, _RIM_POINTS, endpoint=False)
    rim = size.diameter_mm / 2 * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=-1)
    axes, up = frame.axes_at(xy), size.height_mm / 2
    # The shallow depth leaves 0.5 mm over the magnet's middle, the deep one has it on the core.
    depths, splines = (up + 0.5, spec.shell.thickness_mm - up), []
    for depth in depths:
        top = frame.to_object(np.column_stack([xy, np.full(len(xy), up - depth)]))
        # p place, r point of the rim, j own axis, i object coordinate
        points = top[:, None] + np.einsum("pij,rj->pri", axes, rim)
        cover = -_highest(frame.from_object(points)[..., 2])
        splines.append(RectBivariateSpline(nodes[0], nodes[1], cover.reshape(x.shape)))
    return _Cover(frame, depths, (splines[0], splines[1]))


def _highest(heights_mm: Float[np.ndarray, "place rim"]) -> Float[np.ndarray, "place"]:
    """Return the greatest height of rim points on the patch; the median place's where none lies on it.

    A spline needs a finite value at every node; layouts off the patch break `past_border` anyway.
    """
    heights = np.where(np.isfinite(heights_mm), heights_mm, -np.inf).max(axis=1)
    return np.where(np.isfinite(heights), heights, np.median(heights[np.isfinite(heights)]))


_Boxes = tuple[
    Float[Tensor, "layout recess 3"],
    Float[Tensor, "layout recess 3 3"],
    Float[Tensor, "layout recess 3"],
]
"""Centres (mm), axes as rows, half edges (mm) of recesses, in the object's frame."""


def recess_boxes(surface: Surface, layouts: Layouts, boards: Boards) -> _Boxes:
    """Return the boxes that boards take from the core: from its surface to the recess's floor."""
    local, columns, sink = surface.boards(layouts)
    point = to_object(surface.core, local)
    axes = turned_to_object(surface.core, columns.transpose(-1, -2))
    deep = (surface.spec.core.recess_depth_mm + sink) / 2
    # A chip is not in the middle of its board: go along the board's radial axis to its centre.
    ahead = ((boards.centre - layouts.sensor_mm) * boards.radial).sum(-1)
    centre = point + ahead[..., None] * axes[..., 0, :] - deep[..., None] * axes[..., 2, :]
    radial, across = (torch.full_like(deep, half) for half in boards.half_mm)
    return centre, axes, torch.stack([radial, across, deep], dim=-1)


def boards_beside_hole(surface: Surface, recesses: _Boxes) -> Float[Tensor, "layout"]:
    """Return the wall missing between the wire hole and recesses, as `boards_beside_hole_mm` (mm).

    Recesses are turned with the core's surface; the deeper they are the nearer they come. Seen along
    the hole a box is a convex polygon and the hole's axis a point, so their distance is found by the
    separating axis theorem: the largest gap along any direction that may separate them.
    """
    centre, axes, half = recesses
    middle, plane = (
        torch.tensor(part, dtype=centre.dtype)
        for part in (surface.core.centre_mm, surface.core.axes[:, :2])
    )
    # Centres from the hole's middle, and half edges, in the plane across the hole.
    from_hole, edges = (centre - middle) @ plane, (half[..., None] * axes) @ plane
    signs = torch.cartesian_prod(*3 * [torch.tensor([-1.0, 1.0])]).to(centre)
    # Directions to try: the normals of the three edges, and those from the hole to the eight corners
    # (the nearest point of a polygon lies on an edge or is a corner).
    across = torch.stack([-edges[..., 1], edges[..., 0]], dim=-1)
    ways = torch.cat([across, from_hole[..., None, :] + signs @ edges], dim=-2)
    # 1e-9 avoids 0/0 for an edge along the hole, which is seen as a point; left out below.
    length = ways.norm(dim=-1, keepdim=True)
    ways = ways / length.clamp(min=1e-9)
    # Gap along a direction: distance of the centre less the half width Σ |edge · direction|.
    reach = (ways @ edges.transpose(-1, -2)).abs().sum(-1)
    apart = (ways * from_hole[..., None, :]).sum(-1).abs() - reach
    along_the_hole = length[..., 0] < 1e-6
    away = apart.where(~along_the_hole, -torch.inf).amax(dim=-1)
    return missing_beside_hole_mm(surface.spec, away)


def boards_past_edges(
    surface: Surface, layouts: Layouts, recesses: _Boxes
) -> Float[Tensor, "layout"]:
    """Return how far boards break three rules (mm), summed over boards.

    A board has room in its patch, its recess has room in the core, and a wall stays between the
    recess's floor and the next side of the core.
    """
    spec, place = surface.spec, layouts.sensor_mm
    centre, axes, half = recesses
    # Corners of the floor: axis 2 points outwards, so the floor is at −1. `beyond` is < 0 inside the core.
    signs = torch.tensor([[1.0, 1, -1], [1, -1, -1], [-1, 1, -1], [-1, -1, -1]]).to(half)
    floors = centre[..., None, :] + (signs * half[..., None, :]) @ axes
    beyond = pointwise(lambda points: distance_beyond_core_mm(spec, points)[:, None], floors)[
        ..., 0
    ]
    thin = torch.relu(beyond + spec.printer.wall_mm + SLACK_MM).amax(dim=-1)
    # How far from the face's middle a board has room, in the direction of this one.
    reach = pointwise(lambda xy: surface.reach_mm(xy)[:, None], place)[..., 0]
    off = torch.relu(place.norm(dim=-1) + SLACK_MM - reach)
    # On a curved core boards sink in: half[2] is half the depth of the recess.
    if not surface.core.flat:
        off = off + torch.relu(2 * half[..., 2] + SLACK_MM - room_for_recesses(spec)[0])
    return (thin + off).sum(dim=1)
