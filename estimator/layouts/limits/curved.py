"""Limits of layouts on faces that are curved or differ in size: every part lies under its own surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from scipy.interpolate import RectBivariateSpline
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.fit.boards import beyond_core_mm
from design.fit.curved import room_for_recesses
from design.layout.body import body_of, face_frames
from design.spec.magnets import MagnetSize
from design.spec.object import ObjectSpec
from design.spec.worked_out import once
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
    worst_of_faces,
)
from estimator.layouts.surfaces import Surface, onto_patch_mm, pointwise, surfaces

_COVER_STEP_MM, _RIM_POINTS = 1.0, 24
_FEWEST_NODES = 8


def broken_on_surfaces_mm(
    spec: ObjectSpec, layouts: Layouts, face: int, pocket_gap_mm: float, board_gap_mm: float
) -> dict[str, Float[Tensor, "layout"]]:
    """By how much each rule of pockets, boards and chips is broken, on the face where it is most; of
    sensors that stay, boards not."""
    known = surfaces(spec)
    laid = {number: layouts.of(number) for number in known}
    pockets = {number: pockets_of(spec, one) for number, one in laid.items()}
    turned = {number: one.magnets(laid[number].magnet_mm) for number, one in known.items()}
    placed = {number: _placed(turned[number], laid[number], pockets[number]) for number in known}
    moving = spec.search.vary.sensor_reach_mm is not None
    radius = pockets[face].radius
    found = {
        "pocket gap": worst_of_faces(
            [pocket_gaps_mm(floor, top, radius, pocket_gap_mm) for floor, top, _ in placed.values()]
        ),
        "pockets near the edge": worst_of_faces(
            [past_border(one, pockets[number]) for number, one in known.items()]
        ),
        "pocket gap across an edge": pocket_gaps_across_edges_mm(spec, placed, radius),
        "seal": worst_of_faces(
            [unsealed_mm(one, laid[number], pockets[number]) for number, one in known.items()]
        ),
        "chip near a magnet": worst_of_faces(
            [
                chips_near_magnets_mm(
                    spec,
                    number,
                    one.chips(laid[number].sensor_mm)[0],
                    {n: centre for n, (centre, _) in turned.items()},
                )
                for number, one in known.items()
                if moving or number == face
            ]
        ),
    }
    if moving:
        recesses = {
            number: recess_boxes(one, laid[number], boards_of(spec, laid[number]))
            for number, one in known.items()
        }
        centre, axes, half_mm = (
            torch.cat(parts, dim=1) for parts in zip(*recesses.values(), strict=True)
        )
        least = board_gap_mm + SLACK_MM
        found["board gap"] = missing_between_boxes_mm(centre, axes, half_mm, least)
        found["board beside the wire hole"] = worst_of_faces(
            [boards_beside_hole(one, recesses[number]) for number, one in known.items()]
        )
        found["boards near the edge"] = worst_of_faces(
            [
                boards_past_edges(one, laid[number], recesses[number])
                for number, one in known.items()
            ]
        )
    return found


def _placed(turned: tuple[Tensor, Tensor], layouts: Layouts, pockets: Pockets) -> Prisms:
    """Pockets of a face in the object's frame, turned with the surface over each magnet."""
    centre, axes = turned
    local = torch.stack([*layouts.magnet_mm[..., :2].unbind(-1), -layouts.magnet_mm[..., 2]])
    turn = axes.permute(2, 3, 0, 1)
    floor, top = (
        centre.permute(2, 0, 1) + torch.einsum("ijlm,jlm->ilm", turn, ends - local)
        for ends in (pockets.floor, pockets.top)
    )
    return floor, top, torch.einsum("ijlm,jlm->ilm", turn, pockets.axis)


def past_border(surface: Surface, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Beyond the patch; of a box less the zone of the neighbouring face's pockets, as deep as the
    deepest."""
    frame = surface.frame
    half = torch.tensor(frame.half_extents_mm, dtype=pockets.reach.dtype)
    reach = pockets.reach
    if frame.round:
        share = ((reach + SLACK_MM) / half[:, None, None]).square().sum(0).sqrt()
        return torch.relu((share - 1) * half.min()).sum(dim=1)
    if body_of(surface.spec).cuboid:
        reach = reach + (-pockets.lowest).amax(dim=1, keepdim=True)
    return torch.relu(reach + SLACK_MM - half[:, None, None]).sum(dim=(0, 2))


def unsealed_mm(surface: Surface, layouts: Layouts, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Silicone missing over magnets and under pockets."""
    spec, depth = surface.spec, layouts.magnet_mm[..., 2]
    least = spec.silicone.thinnest_wall_mm + SLACK_MM
    if surface.frame.flat:
        up = pockets.axis[2]
        tilted = (1 - up * up).clamp(min=1e-12).sqrt()
        radius, half = outlines_mm(spec, depth.dtype)
        cover = depth - radius * tilted - up * half
    else:
        covers, which = covers_of(spec)[surface.number], spec.magnets.by_size
        parts = [
            pointwise(one.at, layouts.magnet_mm[:, those])[..., 0]
            for one, those in zip(covers, which, strict=True)
        ]
        cover = torch.cat(parts, dim=1)[:, np.argsort(np.concatenate(which))]
    above = torch.relu(least - cover)
    below = torch.relu(-pockets.lowest + least - spec.shell.thickness_mm)
    return (above + below).sum(dim=1)


@dataclass(frozen=True)
class _Cover:
    """Silicone over magnets without tilt, of one face, as `design.layout.places.positions.cover_mm`:
    splines over the patch at two depths, straight between them."""

    frame: FaceFrame
    depths_mm: tuple[float, float]
    splines: tuple[RectBivariateSpline, RectBivariateSpline]

    def at(self, xyd_mm: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 1"]:
        x, y = onto_patch_mm(self.frame, xyd_mm[:, :2]).T
        shallow, deep = (spline(x, y, grid=False) for spline in self.splines)
        first, last = self.depths_mm
        share = (xyd_mm[:, 2] - first) / (last - first)
        return (shallow + share * (deep - shallow))[:, None]


@once
def covers_of(spec: ObjectSpec) -> dict[int, tuple[_Cover, ...]]:
    """Of every curved face, over a magnet of each of the specification's sizes."""
    return {
        frame.number: tuple(_cover(spec, frame, size) for size in spec.magnets.distinct_sizes)
        for frame in face_frames(spec)
        if not frame.flat
    }


def _cover(spec: ObjectSpec, frame: FaceFrame, size: MagnetSize) -> _Cover:
    half = np.asarray(frame.half_extents_mm)
    nodes = [
        np.linspace(-h, h, max(_FEWEST_NODES, int(np.ceil(2 * h / _COVER_STEP_MM)))) for h in half
    ]
    x, y = np.meshgrid(*nodes, indexing="ij")
    xy = onto_patch_mm(frame, np.column_stack([x.ravel(), y.ravel()]))
    turn = np.linspace(0, 2 * np.pi, _RIM_POINTS, endpoint=False)
    rim = size.diameter_mm / 2 * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=-1)
    axes, up = frame.axes_at(xy), size.height_mm / 2
    depths, found = (up + 0.5, spec.shell.thickness_mm - up), []
    for depth in depths:
        top = frame.to_object(np.column_stack([xy, np.full(len(xy), up - depth)]))
        points = top[:, None] + np.einsum("pij,rj->pri", axes, rim)
        cover = -_highest(frame.from_object(points)[..., 2])
        found.append(RectBivariateSpline(nodes[0], nodes[1], cover.reshape(x.shape)))
    return _Cover(frame, depths, (found[0], found[1]))


def _highest(heights_mm: Float[np.ndarray, "place rim"]) -> Float[np.ndarray, "place"]:
    """Of what lies on the patch; the middle one's where nothing does."""
    known = np.where(np.isfinite(heights_mm), heights_mm, -np.inf).max(axis=1)
    return np.where(np.isfinite(known), known, np.median(known[np.isfinite(known)]))


_Boxes = tuple[
    Float[Tensor, "layout recess 3"],
    Float[Tensor, "layout recess 3 3"],
    Float[Tensor, "layout recess 3"],
]
"""Centres (mm), axes as rows, half edges (mm) of recesses, in the object's frame."""


def recess_boxes(surface: Surface, layouts: Layouts, boards: Boards) -> _Boxes:
    point, axes, sink = surface.boards(layouts.sensor_mm)
    deep = (surface.spec.core.recess_depth_mm + sink) / 2
    ahead = ((boards.centre - layouts.sensor_mm) * boards.radial).sum(-1)
    centre = point + ahead[..., None] * axes[..., 0, :] - deep[..., None] * axes[..., 2, :]
    radial, across = (torch.full_like(deep, half) for half in boards.half_mm)
    return centre, axes, torch.stack([radial, across, deep], dim=-1)


def boards_beside_hole(surface: Surface, recesses: _Boxes) -> Float[Tensor, "layout"]:
    """As `boards_beside_hole_mm`, of recesses turned with the core's surface: seen along the hole, which
    they come nearer to the deeper they are."""
    centre, axes, half = recesses
    middle, plane = (
        torch.tensor(part, dtype=centre.dtype)
        for part in (surface.core.centre_mm, surface.core.axes[:, :2])
    )
    seen, edges = (centre - middle) @ plane, (half[..., None] * axes) @ plane
    signs = torch.cartesian_prod(*3 * [torch.tensor([-1.0, 1.0])]).to(centre)
    across = torch.stack([-edges[..., 1], edges[..., 0]], dim=-1)
    ways = torch.cat([across, seen[..., None, :] + signs @ edges], dim=-2)
    length = ways.norm(dim=-1, keepdim=True)
    ways = ways / length.clamp(min=1e-9)
    reach = (ways @ edges.transpose(-1, -2)).abs().sum(-1)
    apart = (ways * seen[..., None, :]).sum(-1).abs() - reach
    along_the_hole = length[..., 0] < 1e-6
    away = apart.where(~along_the_hole, -torch.inf).amax(dim=-1)
    return missing_beside_hole_mm(surface.spec, away)


def boards_past_edges(
    surface: Surface, layouts: Layouts, recesses: _Boxes
) -> Float[Tensor, "layout"]:
    """A board must find room in its patch and its recess in the core, and a wall stay between the
    recess's floor and the next side of the core."""
    spec, place = surface.spec, layouts.sensor_mm
    centre, axes, half = recesses
    signs = torch.tensor([[1.0, 1, -1], [1, -1, -1], [-1, 1, -1], [-1, -1, -1]]).to(half)
    floors = centre[..., None, :] + (signs * half[..., None, :]) @ axes
    beyond = pointwise(lambda points: beyond_core_mm(spec, points)[:, None], floors)[..., 0]
    thin = torch.relu(beyond + spec.printer.wall_mm + SLACK_MM).amax(dim=-1)
    reach = pointwise(lambda at: surface.reach_mm(at)[:, None], place)[..., 0]
    off = torch.relu(place.norm(dim=-1) + SLACK_MM - reach)
    if not surface.core.flat:
        off = off + torch.relu(2 * half[..., 2] + SLACK_MM - room_for_recesses(spec)[0])
    return (thin + off).sum(dim=1)
