"""Limits that a batch of layouts breaks, as distances with gradients.

The rules are those that a specification is checked by, those of `check --fabrication` that layouts
decide (`design.fabrication.layout`, with its figures), and the search's own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.layout.boards import passage_radius_mm
from design.layout.body import core_frames, face_frames
from design.layout.pockets import neighbours
from design.spec.object import ObjectSpec
from estimator.field.sources import magnet_source
from estimator.layouts.batch import Layouts, magnet_axes
from estimator.layouts.near_field import OTHER, OWN
from estimator.layouts.vectors import LayoutSpace

SLACK_MM = 0.02
"""Kept from every limit, so that what keeps it still does once rounded to 0.01 mm and 0.1°."""
RULES = (
    "pocket gap",
    "pockets near the edge",
    "pocket gap across an edge",
    "seal",
    "board gap",
    "boards near the edge",
    "board beside the wire hole",
    "wiring",
    "chip near a magnet",
)


def broken_limits_mm(
    space: LayoutSpace, layouts: Layouts, face: int
) -> Float[Tensor, "layout rule"]:
    """By how much each of `RULES` is broken, mm summed over the parts; 0 where it is kept.

    The layouts are those of one face; magnets, and sensors that move, lie alike on all.
    """
    spec = space.structured
    limits, wall = spec.search.limits, spec.printer.wall_mm
    pockets = _pockets(spec, layouts)
    wire = layouts.sensor_mm.norm(dim=-1).sum(dim=1)
    longest = np.inf if limits.wiring_mm is None else limits.wiring_mm
    boards = _boards_mm(spec, layouts) if spec.search.vary.sensor_reach_mm else None
    nothing = torch.zeros_like(wire)
    return torch.stack(
        [
            _pocket_gaps(pockets, max(limits.pocket_gap_mm, spec.silicone.thinnest_wall_mm)),
            _past_edges(spec, pockets),
            _pocket_gaps_across_edges(spec, pockets),
            _unsealed(spec, layouts, pockets),
            nothing
            if boards is None
            else _board_gaps(spec, boards, max(limits.board_gap_mm, wall)),
            nothing if boards is None else _boards_past_edges(spec, boards),
            nothing if boards is None else _boards_beside_hole(spec, boards),
            torch.relu(wire - longest),
            _chips_near_magnets(spec, layouts, spec.body.sensed if space.sensors else (face,)),
        ],
        dim=1,
    )


@dataclass(frozen=True)
class _Pockets:
    """Of every magnet: axis, floor, top of the mouth's axis, reach and lowest point (mm)."""

    axis: Float[Tensor, "3 layout magnet"]
    floor: Float[Tensor, "3 layout magnet"]
    top: Float[Tensor, "3 layout magnet"]
    reach: Float[Tensor, "2 layout magnet"]
    lowest: Float[Tensor, "layout magnet"]
    radius: float


def _pockets(spec: ObjectSpec, layouts: Layouts) -> _Pockets:
    """As `design.layout.pockets.Pocket`, of round magnets."""
    radius, half = spec.shell.pocket_diameter_mm / 2, spec.magnets.height_mm / 2
    axis, depth = magnet_axes(layouts), layouts.magnet_mm[..., 2]
    centre = torch.stack([*layouts.magnet_mm[..., :2].unbind(-1), -depth])
    up, lean = axis[2], axis[:2] / axis[2]
    across = radius * (1 - up * up).clamp(min=1e-12).sqrt()
    mouth = depth / up
    floor = centre - half * axis
    on_floor = floor[:2].abs() + radius * (1 - axis[:2] ** 2).sqrt()
    # direction e_k − lean_k e_z is perpendicular to the axis: its support is its own length
    on_face = (centre[:2] + mouth * axis[:2]).abs() + radius * (1 + lean**2).sqrt()
    top = centre + (mouth + across / up) * axis
    return _Pockets(axis, floor, top, torch.maximum(on_floor, on_face), floor[2] - across, radius)


def _pocket_gaps(pockets: _Pockets, gap_mm: float) -> Float[Tensor, "layout"]:
    magnets = pockets.lowest.shape[1]
    i, j = torch.triu_indices(magnets, magnets, offset=1)
    between = _between_segments(
        *((ends[..., k]) for k in (i, j) for ends in (pockets.floor, pockets.top))
    )
    return torch.relu(2 * pockets.radius + gap_mm + SLACK_MM - _length(between)).sum(dim=1)


def _length(vector: Tensor) -> Tensor:
    """Of vectors, coordinates first."""
    return (vector**2).sum(0).clamp(min=1e-12).sqrt()


def _between_segments(p: Tensor, p_end: Tensor, q: Tensor, q_end: Tensor) -> Tensor:
    """Shortest way from the second of two segments to the first, coordinates first, as
    `design.layout.pockets` has it."""
    along, other, between = p_end - p, q_end - q, p - q
    aa, bb, ab = ((u * v).sum(0) for u, v in ((along, along), (other, other), (along, other)))
    pa, pb = (along * between).sum(0), (other * between).sum(0)
    determinant = aa * bb - ab * ab
    parallel = determinant < 1e-6 * aa * bb
    s = (ab * pb - bb * pa) / torch.where(parallel, 1.0, determinant)
    s = torch.where(parallel, 0.0, s).clamp(0, 1)
    t = ((ab * s + pb) / bb).clamp(0, 1)
    s = ((ab * t - pa) / aa).clamp(0, 1)
    return between + s * along - t * other


def _pocket_gaps_across_edges(spec: ObjectSpec, pockets: _Pockets) -> Float[Tensor, "layout"]:
    """Silicone missing between the pockets of two neighbouring faces, where most is missing; as
    `design.layout.pockets`."""
    least = spec.silicone.thinnest_wall_mm + SLACK_MM
    frames = face_frames(spec)
    pairs = neighbours(frames)
    if not pairs:
        return torch.zeros_like(pockets.lowest[:, 0])
    row = {frame.number: index for index, frame in enumerate(frames)}
    a, b = zip(*((row[one.number], row[other.number]) for one, other in pairs), strict=True)
    floor, top, axis = (
        torch.stack(parts, dim=1)
        for parts in zip(*(_placed(frame, pockets) for frame in frames), strict=True)
    )
    one, other = ((floor[:, [*at]], top[:, [*at]], axis[:, [*at]]) for at in (a, b))
    return _missing_mm(one, other, pockets.radius, least).sum(dim=(2, 3)).amax(dim=0)


_Prisms = tuple[Tensor, Tensor, Tensor]
"""Floor, top and axis, coordinates first, in the object's frame."""


def _placed(frame: FaceFrame, pockets: _Pockets) -> _Prisms:
    """Pockets of a face in the object's frame: ends of their axes, and these."""
    turn = torch.as_tensor(frame.axes.copy(), dtype=pockets.floor.dtype)
    centre = torch.as_tensor(frame.centre_mm.copy(), dtype=pockets.floor.dtype)
    floor, top, axis = (
        torch.einsum("ij,jlm->ilm", turn, part)
        for part in (pockets.floor, pockets.top, pockets.axis)
    )
    return floor + centre[:, None, None], top + centre[:, None, None], axis


def _missing_mm(
    one: _Prisms, other: _Prisms, radius: float, least: float
) -> Float[Tensor, "edge layout magnet other"]:
    """What the gap of every two prisms lacks; worked out in full only where spheres round them lack it."""
    p, p_end, u = (part[..., :, None] for part in one)
    q, q_end, v = (part[..., None, :] for part in other)
    parts = torch.broadcast_tensors(p, p_end, u, q, q_end, v)
    p, p_end, _, q, q_end, _ = (part.detach() for part in parts)
    apart = ((p + p_end - q - q_end) / 2).norm(dim=0)
    halves = ((p_end - p).norm(dim=0) + (q_end - q).norm(dim=0)) / 2
    close = (apart - halves - 2 * radius < least).nonzero(as_tuple=True)
    p, p_end, u, q, q_end, v = (part[:, *close] for part in parts)
    gap = _gap_of_prisms((p, p_end, u), (q, q_end, v), radius)
    return torch.zeros_like(apart).index_put(close, torch.relu(least - gap))


def _gap_of_prisms(one: _Prisms, other: _Prisms, radius: float) -> Float[Tensor, "pair"]:
    """Largest gap along either axis and along the shortest way between the axes."""
    (p, p_end, u), (q, q_end, v) = one, other
    way = _between_segments(p, p_end, q, q_end)
    gaps = []
    for d in (way / _length(way), u, v):
        a, a_end, b, b_end = ((d * end).sum(0) for end in (p, p_end, q, q_end))
        reach = sum((1 - (d * axis).sum(0) ** 2).clamp(min=1e-12).sqrt() for axis in (u, v))
        apart = torch.maximum(
            torch.minimum(a, a_end) - torch.maximum(b, b_end),
            torch.minimum(b, b_end) - torch.maximum(a, a_end),
        )
        gaps.append(apart - radius * reach)
    return torch.stack(gaps).amax(dim=0)


def _chips_near_magnets(
    spec: ObjectSpec, layouts: Layouts, faces: tuple[int, ...]
) -> Float[Tensor, "layout"]:
    """Distance missing between chips and magnets for the series of the field, on the worst of the faces."""
    magnet, place = magnet_source(spec.magnets), layouts.sensor_mm
    below = torch.full_like(place[..., :1], -spec.sensors.depth_below_core_face_mm)
    chip = torch.cat([place, below], dim=-1)
    centre = layouts.magnet_mm * torch.tensor([1.0, 1.0, -1.0], dtype=place.dtype)
    missing = []
    for core in (frame for frame in core_frames(spec) if frame.number in faces):
        chips = _in_object(core, chip)[:, :, None]
        short = torch.zeros_like(place[:, 0, 0])
        for frame in face_frames(spec):
            reach = OWN if frame.number == core.number else OTHER
            apart = (chips - _in_object(frame, centre)[:, None]).square().sum(-1)
            distance = apart.clamp(min=1e-12).sqrt()
            lacking = torch.relu(reach.least_mm(magnet) + SLACK_MM - distance)
            short = short + lacking.sum(dim=(1, 2))
        missing.append(short)
    return torch.stack(missing).amax(dim=0)


def _in_object(frame: FaceFrame, local_mm: Float[Tensor, "*part 3"]) -> Float[Tensor, "*part 3"]:
    turn = torch.as_tensor(frame.axes.T.copy(), dtype=local_mm.dtype)
    return local_mm @ turn + torch.as_tensor(frame.centre_mm.copy(), dtype=local_mm.dtype)


def _past_edges(spec: ObjectSpec, pockets: _Pockets) -> Float[Tensor, "layout"]:
    """Beyond the face less the zone of the neighbouring face's pockets, as deep as the deepest."""
    half = _half_mm(spec, pockets.reach.dtype)
    deepest = (-pockets.lowest).amax(dim=1, keepdim=True)
    beyond = pockets.reach + deepest + SLACK_MM - half[:, None, None]
    return torch.relu(beyond).sum(dim=(0, 2))


def _unsealed(spec: ObjectSpec, layouts: Layouts, pockets: _Pockets) -> Float[Tensor, "layout"]:
    """Silicone missing over magnets and under pockets."""
    up, depth = pockets.axis[2], layouts.magnet_mm[..., 2]
    tilted = (1 - up * up).clamp(min=1e-12).sqrt()
    upwards = spec.magnets.diameter_mm / 2 * tilted + up * spec.magnets.height_mm / 2
    least = spec.silicone.thinnest_wall_mm + SLACK_MM
    above = torch.relu(upwards + least - depth)
    below = torch.relu(-pockets.lowest + least - spec.shell.thickness_mm)
    return (above + below).sum(dim=1)


def _half_mm(spec: ObjectSpec, dtype: torch.dtype) -> Float[Tensor, "2"]:
    """Half extents that every sensed face offers."""
    halves = np.array([frame.half_extents_mm for frame in face_frames(spec)]).min(axis=0)
    return torch.as_tensor(halves, dtype=dtype)


@dataclass(frozen=True)
class _Boards:
    """Recesses: centre, radial direction (mm), half edges (radial, tangential)."""

    centre: Float[Tensor, "layout sensor 2"]
    radial: Float[Tensor, "layout sensor 2"]
    half_mm: tuple[float, float]


def _boards_mm(spec: ObjectSpec, layouts: Layouts) -> _Boards:
    """Recesses move along with their sensors and turn with their azimuth."""
    core, place = spec.core, layouts.sensor_mm
    radius = place.norm(dim=-1, keepdim=True)
    along = torch.tensor([1.0, 0.0], dtype=place.dtype)
    radial = torch.where(radius > 1e-6, place / radius.clamp(min=1e-6), along)
    middle = (core.recess_inner_radius_mm + core.recess_outer_radius_mm) / 2
    half = (core.recess_outer_radius_mm - core.recess_inner_radius_mm) / 2
    ahead = middle - spec.sensors.radius_mm
    return _Boards(place + ahead * radial, radial, (half, core.recess_width_mm / 2))


def _board_gaps(spec: ObjectSpec, boards: _Boards, gap_mm: float) -> Float[Tensor, "layout"]:
    """Wall missing between any two recesses of the core, round its edges too.

    As `design.layout.boards`: the gap of two boxes is the largest along any of their axes and the
    products of these. Worked out in full only where it may be missing: along its own axes a box
    reaches half its edges, a turned one no further than its corners.
    """
    centre, axes = _recesses(spec, boards)
    half = torch.tensor([*boards.half_mm, spec.core.recess_depth_mm / 2], dtype=centre.dtype)
    i, j = torch.triu_indices(centre.shape[1], centre.shape[1], offset=1)
    with torch.no_grad():
        way = (centre[:, i] - centre[:, j])[..., None]
        own = torch.maximum(*((axes[:, k] @ way)[..., 0].abs() for k in (i, j))) - half
        close = own.amax(dim=-1) < gap_mm + SLACK_MM + half.norm()
    layout, pair = close.nonzero(as_tuple=True)
    at, to = (layout, i[pair]), (layout, j[pair])
    a, b = axes[at], axes[to]
    crossed = torch.linalg.cross(a[..., :, None, :], b[..., None, :, :]).flatten(-3, -2)
    directions = torch.cat([a, b, crossed], dim=-2)
    length = (directions * directions).sum(-1, keepdim=True)
    parallel = length[..., 0] < 1e-6
    directions = directions / length.clamp(min=1e-6).sqrt()
    apart = (directions @ (centre[at] - centre[to])[..., None])[..., 0].abs()
    reach = sum((directions @ box.transpose(-1, -2)).abs() @ half for box in (a, b))
    gap = (apart - reach).masked_fill(parallel, -torch.inf).amax(dim=-1)
    missing = torch.relu(gap_mm + SLACK_MM - gap)
    return torch.zeros_like(centre[:, 0, 0]).index_add(0, layout, missing)


def _recesses(
    spec: ObjectSpec, boards: _Boards
) -> tuple[Float[Tensor, "layout recess 3"], Float[Tensor, "layout recess 3 3"]]:
    """Centres (mm) and axes as rows, in the object's frame, of one layout on all faces."""
    radial = boards.radial
    zero, down = torch.zeros_like(radial[..., :1]), spec.core.recess_depth_mm / 2
    local = torch.cat([boards.centre, zero - down], dim=-1)
    tangential = torch.stack([-radial[..., 1], radial[..., 0]], dim=-1)
    box = torch.stack(
        [
            torch.cat([radial, zero], dim=-1),
            torch.cat([tangential, zero], dim=-1),
            torch.cat([zero, zero, zero + 1], dim=-1),
        ],
        dim=-2,
    )
    centres, axes = [], []
    for frame in core_frames(spec):
        turn = torch.as_tensor(frame.axes.T.copy(), dtype=radial.dtype)
        centres.append(_in_object(frame, local))
        axes.append(box @ turn)
    return torch.cat(centres, dim=1), torch.cat(axes, dim=1)


def _boards_past_edges(spec: ObjectSpec, boards: _Boards) -> Float[Tensor, "layout"]:
    """A wall must stay between the outer end of every recess and the next side of the core."""
    half, wide = boards.half_mm
    outer = boards.centre + half * boards.radial
    across = boards.radial.flip(-1).abs() * wide
    limit = _half_mm(spec, outer.dtype) - spec.shell.thickness_mm - spec.printer.wall_mm
    return torch.relu(outer.abs() + across + SLACK_MM - limit).sum(dim=(1, 2))


def _boards_beside_hole(spec: ObjectSpec, boards: _Boards) -> Float[Tensor, "layout"]:
    """A recess holds the middle of the face, or leaves a wall round the wire hole there."""
    radial, tangential = (
        boards.radial,
        boards.radial.flip(-1) * torch.tensor([-1.0, 1.0]).to(boards.radial),
    )
    half = torch.tensor(boards.half_mm).to(radial)
    middle = torch.stack([(boards.centre * axis).sum(-1) for axis in (radial, tangential)], -1)
    beyond = middle.abs() - half
    outside = (beyond.clamp(min=0) ** 2).sum(-1).clamp(min=1e-12).sqrt()
    away = torch.where(beyond.amax(-1) > 0, outside, beyond.amax(-1))
    missing = torch.relu(passage_radius_mm(spec) + spec.printer.wall_mm + SLACK_MM - away)
    return torch.minimum(missing, torch.relu(away + SLACK_MM)).sum(dim=1)
