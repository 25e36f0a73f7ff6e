"""Batches of layouts as points of a search space, and the limits that they break.

One structure (counts, parts, shell) of `design.search.space` at a time; everything continuous has
gradients. The rules are those that a specification is checked by, as distances by which they are
broken, and the search's own limits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.layout.body import core_frames, face_frames
from design.layout.pockets import sensor_places
from design.search.places import PlaceMap, magnet_map, sensor_map
from design.search.space import SearchSpace
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts, magnet_axes

SLACK_MM = 0.02
"""Kept from every limit, so that what keeps it still does once rounded to 0.01 mm and 0.1°."""
RULES = (
    "pocket gap",
    "pockets near the edge",
    "seal",
    "board gap",
    "boards near the edge",
    "wiring",
)


@dataclass(frozen=True)
class LayoutSpace:
    """A structure of a search space as tensors; `layout_space` makes it.

    `low` and `span` take the unit cube to values; maps are those of `design.search.space`, that of
    sensors None where they stay.
    """

    structured: ObjectSpec
    low: Float[Tensor, "variable"]
    span: Float[Tensor, "variable"]
    magnets: PlaceMap
    sensors: PlaceMap | None


def layout_space(
    space: SearchSpace, structured: ObjectSpec, dtype: torch.dtype = torch.float32
) -> LayoutSpace:
    """Set up one structure, a specification that `design.search.space.with_structure` made."""
    low = np.array([v.low for v in space.continuous])
    high = np.array([v.high for v in space.continuous])
    moving = space.spec.search.vary.sensor_reach_mm is not None
    return LayoutSpace(
        structured,
        torch.as_tensor(low, dtype=dtype),
        torch.as_tensor(high - low, dtype=dtype),
        magnet_map(structured, space.continuous_names),
        sensor_map(structured, space.continuous_names) if moving else None,
    )


def layouts_at(
    space: LayoutSpace,
    unit: Float[Tensor, "layout variable"],
    polarity: Float[Tensor, "layout magnet"],
    face: int,
) -> Layouts:
    """Layouts of one face at points of the unit cube of the continuous variables."""
    values = space.low + unit * space.span
    magnets = _places(space.magnets, values)
    if space.sensors is None:
        placed = sensor_places(space.structured)[space.structured.body.sensed.index(face)]
        fixed = [(x, y) for x, y, _ in placed]
        sensors = torch.as_tensor(fixed, dtype=unit.dtype).expand(len(unit), -1, -1)
    else:
        sensors = _places(space.sensors, values)
    if space.sensors is not None and space.sensors.polar:
        azimuth = torch.deg2rad(sensors[..., 1])
        sensors = sensors[..., :1] * torch.stack([azimuth.cos(), azimuth.sin()], dim=-1)
    return Layouts(magnets[..., :3], torch.deg2rad(magnets[..., 3:]), polarity, sensors)


def _places(
    places: PlaceMap, values: Float[Tensor, "layout variable"]
) -> Float[Tensor, "layout part column"]:
    matrix, constant = (
        torch.as_tensor(part, dtype=values.dtype) for part in (places.matrix, places.constant)
    )
    return constant + torch.einsum("pcv,lv->lpc", matrix, values)


def broken_limits_mm(space: LayoutSpace, layouts: Layouts) -> Float[Tensor, "layout rule"]:
    """By how much each of `RULES` is broken, mm summed over the parts; 0 where it is kept."""
    spec = space.structured
    limits = spec.search.limits
    pockets = _pockets(spec, layouts)
    wire = layouts.sensor_mm.norm(dim=-1).sum(dim=1)
    longest = np.inf if limits.wiring_mm is None else limits.wiring_mm
    boards = _boards_mm(spec, layouts) if spec.search.vary.sensor_reach_mm else None
    nothing = torch.zeros_like(wire)
    return torch.stack(
        [
            _pocket_gaps(pockets, limits.pocket_gap_mm),
            _past_edges(spec, pockets),
            _unsealed(spec, layouts, pockets),
            nothing if boards is None else _board_gaps(spec, boards, limits.board_gap_mm),
            nothing if boards is None else _boards_past_edges(spec, boards),
            torch.relu(wire - longest),
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
    distance = _between_segments(
        *((ends[..., k]) for k in (i, j) for ends in (pockets.floor, pockets.top))
    )
    return torch.relu(2 * pockets.radius + gap_mm + SLACK_MM - distance).sum(dim=1)


def _between_segments(p: Tensor, p_end: Tensor, q: Tensor, q_end: Tensor) -> Tensor:
    """Smallest distance of two segments, coordinates first, as `design.layout.pockets` has it."""
    along, other, between = p_end - p, q_end - q, p - q
    aa, bb, ab = ((u * v).sum(0) for u, v in ((along, along), (other, other), (along, other)))
    pa, pb = (along * between).sum(0), (other * between).sum(0)
    determinant = aa * bb - ab * ab
    parallel = determinant < 1e-6 * aa * bb
    s = (ab * pb - bb * pa) / torch.where(parallel, 1.0, determinant)
    s = torch.where(parallel, 0.0, s).clamp(0, 1)
    t = ((ab * s + pb) / bb).clamp(0, 1)
    s = ((ab * t - pa) / aa).clamp(0, 1)
    return ((between + s * along - t * other) ** 2).sum(0).clamp(min=1e-12).sqrt()


def _past_edges(spec: ObjectSpec, pockets: _Pockets) -> Float[Tensor, "layout"]:
    """Beyond the face less the zone of the neighbouring face's pockets, as deep as the deepest."""
    half = _half_mm(spec, pockets.reach.dtype)
    deepest = (-pockets.lowest).amax(dim=1, keepdim=True)
    beyond = pockets.reach + deepest + SLACK_MM - half[:, None, None]
    return torch.relu(beyond).sum(dim=(0, 2))


def _unsealed(spec: ObjectSpec, layouts: Layouts, pockets: _Pockets) -> Float[Tensor, "layout"]:
    up, depth = pockets.axis[2], layouts.magnet_mm[..., 2]
    tilted = (1 - up * up).clamp(min=1e-12).sqrt()
    upwards = spec.magnets.diameter_mm / 2 * tilted + up * spec.magnets.height_mm / 2
    above = torch.relu(upwards + SLACK_MM - depth)
    below = torch.relu(-pockets.lowest + SLACK_MM - spec.shell.thickness_mm)
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
    products of these.
    """
    centre, axes = _recesses(spec, boards)
    half = torch.tensor([*boards.half_mm, spec.core.recess_depth_mm / 2], dtype=centre.dtype)
    i, j = torch.triu_indices(centre.shape[1], centre.shape[1], offset=1)
    a, b = axes[:, i], axes[:, j]
    crossed = torch.linalg.cross(a[..., :, None, :], b[..., None, :, :]).flatten(-3, -2)
    directions = torch.cat([a, b, crossed], dim=-2)
    length = (directions * directions).sum(-1, keepdim=True)
    parallel = length[..., 0] < 1e-6
    directions = directions / length.clamp(min=1e-6).sqrt()
    apart = (directions @ (centre[:, i] - centre[:, j])[..., None])[..., 0].abs()
    reach = sum((directions @ box.transpose(-1, -2)).abs() @ half for box in (a, b))
    gap = (apart - reach).masked_fill(parallel, -torch.inf).amax(dim=-1)
    return torch.relu(gap_mm + SLACK_MM - gap).sum(dim=1)


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
        centres.append(local @ turn + torch.tensor(frame.centre_mm, dtype=radial.dtype))
        axes.append(box @ turn)
    return torch.cat(centres, dim=1), torch.cat(axes, dim=1)


def _boards_past_edges(spec: ObjectSpec, boards: _Boards) -> Float[Tensor, "layout"]:
    """As the specification's check: the outer end of every recess must stay on the core's face."""
    half, wide = boards.half_mm
    outer = boards.centre + half * boards.radial
    across = boards.radial.flip(-1).abs() * wide
    limit = _half_mm(spec, outer.dtype) - spec.shell.thickness_mm
    return torch.relu(outer.abs() + across + SLACK_MM - limit).sum(dim=(1, 2))
