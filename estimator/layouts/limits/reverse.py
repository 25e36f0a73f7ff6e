"""Limits of layouts whose sensors lie in the shell and magnets in the core: boxes, every face flat."""

from __future__ import annotations

import torch
from jaxtyping import Float
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.layout.boards import passage_radius_mm
from design.layout.body import core_frames, face_frames
from design.layout.pockets import Outline, boards_depth_mm, sensor_boards
from design.layout.template_marks import CORNER_MM
from design.spec.object import ObjectSpec
from estimator.layouts.batch import Layouts
from estimator.layouts.limits.parts import (
    SLACK_MM,
    Pockets,
    chips_near_magnets_mm,
    placed_pockets,
    pocket_gaps_across_edges_mm,
    pocket_gaps_mm,
    pockets_of,
    worst_of_faces,
)
from estimator.layouts.surfaces import to_object


def broken_in_reverse_mm(
    spec: ObjectSpec, layouts: Layouts, pocket_gap_mm: float
) -> dict[str, Float[Tensor, "layout"]]:
    """Return how much each rule is broken, on the face where it is most."""
    laid = {frame.number: layouts.layouts_of_face(frame.number) for frame in face_frames(spec)}
    boards = {
        number: _pockets_of_boards(spec, layouts_of_face)
        for number, layouts_of_face in laid.items()
    }
    magnets = {
        number: pockets_of(spec, layouts_of_face) for number, layouts_of_face in laid.items()
    }
    placed = {
        frame.number: placed_pockets(frame, boards[frame.number]) for frame in face_frames(spec)
    }
    radius = boards[spec.body.sensed[0]].radius
    return {
        "pocket gap": worst_of_faces(
            [
                pocket_gaps_mm(layouts_of_face.floor, layouts_of_face.top, radius, pocket_gap_mm)
                for layouts_of_face in boards.values()
            ]
        ),
        "pockets near the edge": worst_of_faces(
            [_past_edges(frame, boards[frame.number], SLACK_MM) for frame in face_frames(spec)]
        ),
        "pocket gap across an edge": pocket_gaps_across_edges_mm(
            spec, placed, radius, pocket_gap_mm
        ),
        "magnets in the core": worst_of_faces(
            [_magnets(spec, frame, magnets[frame.number]) for frame in core_frames(spec)]
        ),
        "chip near a magnet": _chips_near_magnets(spec, laid),
    }


def _pockets_of_boards(spec: ObjectSpec, layouts: Layouts) -> Pockets:
    """Return pockets of one face: circles round the boards, but turned boards towards the edges."""
    outline: Outline = sensor_boards(spec)[0][0].outline
    place = layouts.sensor_mm
    radius = place.norm(dim=-1, keepdim=True)
    x_axis = torch.tensor([1.0, 0.0], dtype=place.dtype)
    radial = torch.where(radius > 1e-6, place / radius.clamp(min=1e-6), x_axis).abs()
    across, ahead = outline.half_mm
    reach = place.abs() + across * radial.flip(-1) + ahead * radial
    x, y = place.unbind(-1)
    zero = torch.zeros_like(x)
    floor = zero - spec.shell.pocket_depth_mm
    up = torch.stack([zero, zero, zero + 1])
    return Pockets(
        up,
        torch.stack([x, y, floor]),
        torch.stack([x, y, zero]),
        reach.permute(2, 0, 1),
        floor,
        torch.full((x.shape[1],), outline.radius_mm, dtype=x.dtype),
    )


def _past_edges(frame: FaceFrame, pockets: Pockets, wall_mm: float) -> Float[Tensor, "layout"]:
    """Beyond the face less the zone of the neighbouring face's pockets, as deep as the deepest, and less a
    wall."""
    half = torch.tensor(frame.half_extents_mm, dtype=pockets.reach.dtype)
    deepest = (-pockets.lowest).amax(dim=1, keepdim=True)
    return torch.relu(pockets.reach + deepest + wall_mm - half[:, None, None]).sum(dim=(0, 2))


def _magnets(spec: ObjectSpec, core: FaceFrame, pockets: Pockets) -> Float[Tensor, "layout"]:
    """Walls that pockets in the core lack: to the next side, round the wire hole and below; and in their
    template, whose holes have their play, between each other and at its cut corner."""
    wall, play = spec.printer.wall_mm, spec.printer.clearance_mm
    between = pocket_gaps_mm(pockets.floor, pockets.top, pockets.radius, wall + 2 * play)
    to_corner = sum(core.half_extents_mm) - CORNER_MM - pockets.top[:2].sum(0)
    corner = torch.relu(pockets.radius + play + wall + SLACK_MM - to_corner / 2**0.5)
    beside = _past_edges(core, pockets, wall + SLACK_MM)
    away = pockets.floor[:2].square().sum(0).clamp(min=1e-12).sqrt() - pockets.radius
    hole = torch.relu(passage_radius_mm(spec) + wall + SLACK_MM - away)
    below = torch.relu(wall + SLACK_MM - pockets.lowest - spec.core.wall_mm)
    return between + beside + (hole + below + corner).sum(dim=1)


def _chips_near_magnets(spec: ObjectSpec, laid: dict[int, Layouts]) -> Float[Tensor, "layout"]:
    """On the worst of the faces."""
    frames, depth = face_frames(spec), boards_depth_mm(spec)
    down = torch.tensor([1.0, 1.0, -1.0], dtype=laid[frames[0].number].magnet_mm.dtype)
    centres = {
        frame.number: to_object(frame, laid[frame.number].magnet_mm * down) for frame in frames
    }
    missing = []
    for frame in frames:
        place = laid[frame.number].sensor_mm
        chips = torch.cat([place, torch.full_like(place[..., :1], -depth)], dim=-1)
        missing.append(chips_near_magnets_mm(spec, frame.number, to_object(frame, chips), centres))
    return worst_of_faces(missing)
