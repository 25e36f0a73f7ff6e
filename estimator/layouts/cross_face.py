"""Effect of presses of one face on its neighbours' sensors, for many layouts at once.

Lowest fidelity level of a layout search, as `estimator.layouts.scoring`, on the same stored
presses: magnets, or boards in the silicone, of the pressed face and of its neighbours move, the opposite
face's are left out.
"""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from estimator.field.sources import Magnet
from estimator.layouts.batch import Layouts
from estimator.layouts.near_field import OTHER, OWN, Reach, field_of_size
from estimator.layouts.placed import chips, other_magnets, own_magnets
from estimator.layouts.presses.changes import (
    counts_of_field,
    field_at,
    press_changes,
    sensor_motion_changes,
)
from estimator.layouts.presses.mixed_rows import interpolate_motion_rows
from estimator.layouts.scorer import LayoutScorer, moving_bodies
from estimator.signals.hall import full_scale_counts
from estimator.signals.live import is_live

CROSS_FACE_FORCE_N = 10.0
"""Force of the presses whose disturbance is scored, as in `estimator.information.cross_face`."""
_TOGETHER = 4
"""Layouts whose pairs of places a processor's cache holds."""
_MOST_SHARE = 2.0
"""Largest false force, as a share of the score's force."""


@dataclass(frozen=True)
class _MovingFace:
    """One face's magnets of one size in the pressed face's frame, and their motions there on a basis; faces
    count from the pressed one."""

    index: int
    source: Magnet
    polarity: Float[Tensor, "layout magnet"]
    centre_mm: Float[Tensor, "3 layout magnet"]
    axis: Float[Tensor, "3 layout magnet"]
    rows: Float[Tensor, "layout magnet 6 rank"]
    basis: Float[Tensor, "rank column"]


def false_forces_n(
    scorer: LayoutScorer, layouts: Layouts
) -> Float[Tensor, "layout neighbour place"]:
    """Force that each neighbour reads on itself from presses of `CROSS_FACE_FORCE_N` on this face.

    Its own press, at the contact location and force whose signals are nearest; signals grow with the
    force here, and own presses are those of this face. Differentiable but for the choice of location.
    """
    presses, places = scorer.presses, scorer.presses.count
    motion = torch.arange(3 * places, 4 * places)
    share = CROSS_FACE_FORCE_N / presses.force_n
    change = share * neighbour_changes(scorer, layouts, motion).transpose(2, 3)
    by_force = press_changes(scorer, layouts).by_parameter[:, :, 3].permute(1, 2, 0)
    together = _TOGETHER if change.device.type == "cpu" else len(change)
    with torch.no_grad():
        parts = zip(change.split(together), by_force.split(together), strict=True)
        nearest = torch.cat([_nearest(*part) for part in parts])
    each = torch.arange(len(by_force))[:, None, None]
    chosen = by_force[each, nearest]
    part = (change * chosen).sum(-1) / (chosen.square().sum(-1) + 1e-20)
    return presses.force_n * part.clamp(0.0, _MOST_SHARE)


def _nearest(
    change: Float[Tensor, "layout neighbour place channel"],
    by_force: Float[Tensor, "layout own_place channel"],
) -> Int[Tensor, "layout neighbour place"]:
    """Own place some share of whose signals is nearest to a change."""
    products = change.flatten(1, 2) @ by_force.transpose(1, 2)
    squared = by_force.square().sum(-1)[:, None] + 1e-20
    part = torch.minimum(products.clamp(min=0.0), _MOST_SHARE * squared)
    worth = products.mul_(-2).add_(part).mul_(part).div_(squared)
    return worth.argmin(dim=-1).unflatten(1, change.shape[1:3])


def neighbour_changes(
    scorer: LayoutScorer, layouts: Layouts, columns: Int[Tensor, "column"]
) -> Float[Tensor, "layout neighbour channel column"]:
    """Whitened changes of each neighbour's own channels along columns of the bases; differentiable.

    On the paper's cube the median change over neighbours and places is 5 % off the full chain's.
    Channels that are clipped at rest tell nothing; what the press adds there is small.
    """
    if scorer.sensors_move:
        return _moving_sensor_changes(scorer, layouts, columns)
    moving = _moving_faces(scorer, layouts, columns)
    scale = (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    changes = []
    for number in range(len(scorer.presses.neighbours)):
        sensor, axes = chips(scorer.presses, layouts, scorer.sensor_depth_mm, scorer.chip, number)
        parts = [
            _signals(face, sensor, OWN if face.index == 1 + number else OTHER) for face in moving
        ]
        change, field = (torch.stack(of_faces).sum(0) for of_faces in zip(*parts, strict=True))
        live = _live_at_rest(scorer, axes, field)
        changes.append((axes * scale @ change).flatten(1, 2) * live)
    return torch.stack(changes, dim=1)


def _moving_sensor_changes(
    scorer: LayoutScorer, layouts: Layouts, columns: Int[Tensor, "column"]
) -> Float[Tensor, "layout neighbour channel column"]:
    presses = scorer.presses
    _, rows = interpolate_motion_rows(presses, moving_bodies(scorer, layouts))
    rows = rows.reshape(*layouts.sensor_mm.shape[:2], len(presses.neighbours), 6, -1)
    basis, scale = presses.other_table.basis[:, columns], scorer.counts_per_t / scorer.sigma_counts
    others = (parts.unbind(-1) for parts in other_magnets(presses, layouts))
    faces = [own_magnets(presses, layouts), *zip(*others, strict=True)]
    changes = []
    for number in range(len(presses.neighbours)):
        sensor, axes = chips(presses, layouts, scorer.sensor_depth_mm, scorer.chip, number)
        fields = [
            field_at(
                scorer, sensor, magnets, layouts.polarity, OWN if index == 1 + number else OTHER
            )
            for index, magnets in enumerate(faces)
        ]
        felt = axes * scale[:, None] @ sensor_motion_changes(*fields)
        field = torch.stack([field_of_face.field.sum(-1) for field_of_face in fields]).sum(0)
        live = _live_at_rest(scorer, axes, field)
        changes.append((felt @ rows[:, :, number] @ basis).flatten(1, 2) * live)
    return torch.stack(changes, dim=1)


def _live_at_rest(
    scorer: LayoutScorer,
    axes: Float[Tensor, "layout sensor 3 3"],
    field_t: Float[Tensor, "3 layout sensor"],
) -> Bool[Tensor, "layout channel 1"]:
    counts = counts_of_field(scorer, axes, field_t)[..., None]
    return is_live(counts, torch.zeros_like(counts), full_scale_counts(scorer.spec.sensors))


def _moving_faces(
    scorer: LayoutScorer, layouts: Layouts, columns: Int[Tensor, "column"]
) -> list[_MovingFace]:
    """The pressed face, then its neighbours, size by size."""
    faces_of_sizes = []
    for source, (presses, some, _) in zip(scorer.sizes, scorer.size_variants(layouts), strict=True):
        shape = some.magnet_mm.shape[:2]
        own_rows, other_rows = interpolate_motion_rows(presses, some)
        rows = other_rows.reshape(*shape, len(presses.neighbours), 6, -1).unbind(2)
        placed = (parts.unbind(-1) for parts in other_magnets(presses, some))
        faces = [
            (*own_magnets(presses, some), own_rows.reshape(*shape, 6, -1), presses.own_table),
            *(
                (centre, axis, row, presses.other_table)
                for row, centre, axis in zip(rows, *placed, strict=False)
            ),
        ]
        faces_of_sizes += [
            _MovingFace(index, source, some.polarity, centre, axis, row, table.basis[:, columns])
            for index, (centre, axis, row, table) in enumerate(faces)
        ]
    return faces_of_sizes


def _signals(
    face: _MovingFace, sensor: Float[Tensor, "3 layout sensor"], reach: Reach
) -> tuple[Float[Tensor, "layout sensor 3 column"], Float[Tensor, "3 layout sensor"]]:
    """Change of the field (T) at sensors by one face's magnets, and their field at rest, in the pressed
    face's frame."""
    magnets = face.centre_mm, face.axis
    change = field_of_size(face.source, sensor, magnets, face.polarity, reach)
    by_motion = change.by_motion.permute(2, 3, 0, 4, 1).flatten(3)
    rows = face.rows.flatten(1, 2)[:, None]
    return (by_motion @ rows) @ face.basis, change.field.sum(-1)
