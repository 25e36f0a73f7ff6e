"""Limits of layouts on flat faces that are alike: one layout turned from face to face."""

from __future__ import annotations

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.layout.body import core_frames, face_frames
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts
from estimator.layouts.limits.gaps import (
    missing_between_boxes_mm,
)
from estimator.layouts.limits.parts import (
    SLACK_MM,
    Boards,
    Pockets,
    boards_of,
    chips_near_magnets_mm,
    outlines_mm,
    placed_pockets,
    pocket_gaps_across_edges_mm,
    pocket_gaps_mm,
    pockets_of,
    worst_of_faces,
)
from estimator.layouts.surfaces import to_object


def broken_on_flat_faces_mm(
    spec: ObjectSpec, layouts: Layouts, face: int, pocket_gap_mm: float, board_gap_mm: float
) -> dict[str, Float[Tensor, "layout"]]:
    """Return how much each rule of pockets, boards and chips is broken; sensors that stay break none."""
    pockets = pockets_of(spec, layouts)
    placed = {frame.number: placed_pockets(frame, pockets) for frame in face_frames(spec)}
    moving = spec.search.vary.sensor_reach_mm is not None
    missing = {
        "pocket gap": pocket_gaps_mm(pockets.floor, pockets.top, pockets.radius, pocket_gap_mm),
        "pockets near the edge": past_edges(spec, pockets),
        "pocket gap across an edge": pocket_gaps_across_edges_mm(
            spec, placed, pockets.radius, pocket_gap_mm
        ),
        "seal": unsealed_mm(spec, layouts, pockets),
        "chip near a magnet": _chips_near_magnets(
            spec, layouts, spec.body.sensed if moving else (face,)
        ),
    }
    if moving:
        boards = boards_of(spec, layouts)
        missing["board gap"] = _board_gaps(spec, boards, board_gap_mm)
        missing["boards near the edge"] = boards_past_edges(spec, boards)
    return missing


def _chips_near_magnets(
    spec: ObjectSpec, layouts: Layouts, faces: tuple[int, ...]
) -> Float[Tensor, "layout"]:
    """On the worst of the faces."""
    place = layouts.sensor_mm
    below = torch.full_like(place[..., :1], -spec.sensors.depth_below_core_face_mm)
    chip = torch.cat([place, below], dim=-1)
    centre = layouts.magnet_mm * torch.tensor([1.0, 1.0, -1.0], dtype=place.dtype)
    centres = {frame.number: to_object(frame, centre) for frame in face_frames(spec)}
    return worst_of_faces(
        [
            chips_near_magnets_mm(spec, core.number, to_object(core, chip), centres)
            for core in core_frames(spec)
            if core.number in faces
        ]
    )


def past_edges(spec: ObjectSpec, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Beyond the face less the zone of the neighbouring face's pockets, as deep as the deepest."""
    half = _half_mm(spec, pockets.reach.dtype)
    deepest = (-pockets.lowest).amax(dim=1, keepdim=True)
    beyond = pockets.reach + deepest + SLACK_MM - half[:, None, None]
    return torch.relu(beyond).sum(dim=(0, 2))


def unsealed_mm(spec: ObjectSpec, layouts: Layouts, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Silicone missing over magnets and under pockets."""
    up, depth = pockets.axis[2], layouts.magnet_mm[..., 2]
    tilted = (1 - up * up).clamp(min=1e-12).sqrt()
    radius, half = outlines_mm(spec, depth.dtype)
    upwards = radius * tilted + up * half
    least = spec.silicone.thinnest_wall_mm + SLACK_MM
    above = torch.relu(upwards + least - depth)
    below = torch.relu(-pockets.lowest + least - spec.shell.thickness_mm)
    return (above + below).sum(dim=1)


def _half_mm(spec: ObjectSpec, dtype: torch.dtype) -> Float[Tensor, "2"]:
    """Half extents that every sensed face offers."""
    halves = np.array([frame.half_extents_mm for frame in face_frames(spec)]).min(axis=0)
    return torch.as_tensor(halves, dtype=dtype)


def _board_gaps(spec: ObjectSpec, boards: Boards, gap_mm: float) -> Float[Tensor, "layout"]:
    """Wall missing between any two recesses of the core, round its edges too."""
    centre, axes = recess_boxes(spec, boards)
    half = torch.tensor([*boards.half_mm, spec.core.recess_depth_mm / 2], dtype=centre.dtype)
    return missing_between_boxes_mm(centre, axes, half, gap_mm + SLACK_MM)


def recess_boxes(
    spec: ObjectSpec, boards: Boards
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
        centres.append(to_object(frame, local))
        axes.append(box @ turn)
    return torch.cat(centres, dim=1), torch.cat(axes, dim=1)


def boards_past_edges(spec: ObjectSpec, boards: Boards) -> Float[Tensor, "layout"]:
    """A wall must stay between the outer end of every recess and the next side of the core."""
    half, wide = boards.half_mm
    outer = boards.centre + half * boards.radial
    across = boards.radial.flip(-1).abs() * wide
    limit = _half_mm(spec, outer.dtype) - spec.shell.thickness_mm - spec.printer.wall_mm
    return torch.relu(outer.abs() + across + SLACK_MM - limit).sum(dim=(1, 2))
