"""Pockets and recesses of layouts in batches, each in the plane that touches its face at the place."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from design.body.surface_chart import FaceFrame
from design.layout.boards import passage_radius_mm
from design.layout.body import face_frames
from design.layout.pockets import core_pockets, neighbours, shell_pockets
from design.spec.object import ObjectSpec
from estimator.field.sources import magnet_sources
from estimator.layouts.batch import Layouts, magnet_axes, magnets_below_mm
from estimator.layouts.limits.gaps import (
    Prisms,
    length,
    missing_between_prisms_mm,
    shortest_way,
)
from estimator.layouts.near_field import OTHER, OWN

SLACK_MM = 0.02
"""Kept from every limit, so that what keeps it still does once rounded to 0.01 mm and 0.1°."""


@dataclass(frozen=True)
class Pockets:
    """Pockets of every magnet: axis, floor, top of the mouth's axis, reach and lowest point (mm)."""

    axis: Float[Tensor, "3 layout magnet"]
    floor: Float[Tensor, "3 layout magnet"]
    top: Float[Tensor, "3 layout magnet"]
    reach: Float[Tensor, "2 layout magnet"]
    lowest: Float[Tensor, "layout magnet"]
    radius: Float[Tensor, "magnet"]


def pockets_of(spec: ObjectSpec, layouts: Layouts) -> Pockets:
    """Return pockets as `design.layout.pockets.Pocket`, of round magnets; heights count from the core's
    face where they rest in it, in pockets as wide as they are."""
    pockets = shell_pockets if spec.arrangement == "sensors-in-core" else core_pockets
    of_face = pockets(spec)[0]
    radius, half = (
        torch.tensor(each, dtype=layouts.magnet_mm.dtype)
        for each in zip(
            *((p.outline.radius_mm, p.body.height_mm / 2) for p in of_face), strict=True
        )
    )
    axis, depth = magnet_axes(layouts), layouts.magnet_mm[..., 2] - magnets_below_mm(spec)
    centre = torch.stack([*layouts.magnet_mm[..., :2].unbind(-1), -depth])
    up, lean = axis[2], axis[:2] / axis[2]
    across = radius * (1 - up * up).clamp(min=1e-12).sqrt()
    mouth = depth / up
    floor = centre - half * axis
    on_floor = floor[:2].abs() + radius * (1 - axis[:2] ** 2).sqrt()
    # direction e_k − lean_k e_z is perpendicular to the axis: its support is its own length
    on_face = (centre[:2] + mouth * axis[:2]).abs() + radius * (1 + lean**2).sqrt()
    top = centre + (mouth + across / up) * axis
    return Pockets(axis, floor, top, torch.maximum(on_floor, on_face), floor[2] - across, radius)


def outlines_mm(
    spec: ObjectSpec, dtype: torch.dtype
) -> tuple[Float[Tensor, "magnet"], Float[Tensor, "magnet"]]:
    """Radius and half height of every magnet of a face."""
    sizes = spec.magnets.sizes
    radius, half = (
        [size.diameter_mm / 2 for size in sizes],
        [size.height_mm / 2 for size in sizes],
    )
    return torch.tensor(radius, dtype=dtype), torch.tensor(half, dtype=dtype)


def pocket_gaps_mm(
    floor: Float[Tensor, "3 layout magnet"],
    top: Float[Tensor, "3 layout magnet"],
    radius: Float[Tensor, "magnet"],
    gap_mm: float,
) -> Float[Tensor, "layout"]:
    """Silicone missing between the pockets of a face; floors and tops in any one frame."""
    magnets = floor.shape[2]
    i, j = torch.triu_indices(magnets, magnets, offset=1)
    between = shortest_way(*((ends[..., k]) for k in (i, j) for ends in (floor, top)))
    return torch.relu(radius[i] + radius[j] + gap_mm + SLACK_MM - length(between)).sum(dim=1)


@dataclass(frozen=True)
class Boards:
    """Recesses: centre, radial direction (mm), half edges (radial, tangential)."""

    centre: Float[Tensor, "layout sensor 2"]
    radial: Float[Tensor, "layout sensor 2"]
    half_mm: tuple[float, float]


def boards_of(spec: ObjectSpec, layouts: Layouts) -> Boards:
    """Recesses move along with their sensors and turn with their azimuth."""
    core, place = spec.core, layouts.sensor_mm
    radius = place.norm(dim=-1, keepdim=True)
    x_axis = torch.tensor([1.0, 0.0], dtype=place.dtype)
    radial = torch.where(radius > 1e-6, place / radius.clamp(min=1e-6), x_axis)
    middle = (core.recess_inner_radius_mm + core.recess_outer_radius_mm) / 2
    half = (core.recess_outer_radius_mm - core.recess_inner_radius_mm) / 2
    ahead = middle - spec.sensors.radius_mm
    return Boards(place + ahead * radial, radial, (half, core.recess_width_mm / 2))


def boards_beside_hole_mm(spec: ObjectSpec, boards: Boards) -> Float[Tensor, "layout"]:
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
    return missing_beside_hole_mm(spec, away)


def missing_beside_hole_mm(
    spec: ObjectSpec, away_mm: Float[Tensor, "layout recess"]
) -> Float[Tensor, "layout"]:
    """Return the wall missing at recesses that far from the hole's axis; negative distances hold it."""
    missing = torch.relu(passage_radius_mm(spec) + spec.printer.wall_mm + SLACK_MM - away_mm)
    return torch.minimum(missing, torch.relu(away_mm + SLACK_MM)).sum(dim=1)


def pocket_gaps_across_edges_mm(
    spec: ObjectSpec, placed: dict[int, Prisms], radius: Float[Tensor, "magnet"], gap_mm: float
) -> Float[Tensor, "layout"]:
    """Silicone missing between the pockets of two adjacent faces, where most is missing."""
    pairs = [(first.number, second.number) for first, second in neighbours(face_frames(spec))]
    floors = next(iter(placed.values()))[0]
    if not pairs:
        return torch.zeros_like(floors[0, :, 0])

    def prisms_of_side(side: int) -> Prisms:
        floor, top, axis = (
            torch.stack([placed[pair[side]][part] for pair in pairs], dim=1) for part in range(3)
        )
        return floor, top, axis

    first, second = prisms_of_side(0), prisms_of_side(1)
    least = gap_mm + SLACK_MM
    return missing_between_prisms_mm(first, second, radius, least).sum(dim=(2, 3)).amax(dim=0)


def placed_pockets(frame: FaceFrame, pockets: Pockets) -> Prisms:
    """Pockets of a face in the object's frame: ends of their axes, and these."""
    return prisms_in_object(frame, (pockets.floor, pockets.top, pockets.axis))


def prisms_in_object(frame: FaceFrame, prisms: Prisms) -> Prisms:
    """The same of ends and axes in the coordinates of the face's plane."""
    turn, centre = (prisms[0].new_tensor(part.tolist()) for part in (frame.axes, frame.centre_mm))
    # i object coordinate, j face axis, l layout, m magnet
    floor, top, axis = (torch.einsum("ij,jlm->ilm", turn, part) for part in prisms)
    return floor + centre[:, None, None], top + centre[:, None, None], axis


def worst_of_faces(of_faces: list[Float[Tensor, "layout"]]) -> Float[Tensor, "layout"]:
    return torch.stack(of_faces).amax(dim=0)


def chips_near_magnets_mm(
    spec: ObjectSpec,
    face: int,
    chips_mm: Float[Tensor, "layout sensor 3"],
    centres_mm: Mapping[int, Float[Tensor, "layout magnet 3"]],
) -> Float[Tensor, "layout"]:
    """Distance missing between a face's chips and the magnets of all faces for the series of the field; both
    in the object's frame."""
    sizes, which = magnet_sources(spec.magnets), spec.magnets.size_numbers
    short = torch.zeros_like(chips_mm[:, 0, 0])
    for number, centres in centres_mm.items():
        reach = OWN if number == face else OTHER
        apart = (chips_mm[:, :, None] - centres[:, None]).square().sum(-1)
        least = torch.tensor([reach.least_mm(sizes[n]) for n in which], dtype=apart.dtype)
        lacking = torch.relu(least + SLACK_MM - apart.clamp(min=1e-12).sqrt())
        short = short + lacking.sum(dim=(1, 2))
    return short
