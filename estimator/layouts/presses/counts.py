"""Counts of layouts in the deepest presses, where signals are far from linear in the motions."""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from estimator.field.gradient import FieldChange
from estimator.layouts.batch import Layouts
from estimator.layouts.near_field import PRESSED
from estimator.layouts.placed import own_magnets
from estimator.layouts.presses.basis import PressBasis
from estimator.layouts.presses.changes import PressChanges, counts_of_field, field_at, field_changes
from estimator.layouts.scorer import LayoutScorer
from estimator.layouts.spread import channel_spread


@dataclass(frozen=True)
class PressedCounts:
    """Counts of own channels, and their standard deviation between virtual objects."""

    counts: Float[Tensor, "layout channel"]
    sigma: Float[Tensor, "layout channel"]


def counts_when_pressed(
    scorer: LayoutScorer, layouts: Layouts, changes: PressChanges
) -> PressedCounts:
    """Return counts of each sensor in the deepest press, at the place where linear signals are largest."""
    _, _, by_force, in_press = changes.unclipped.unbind(2)
    sigma = scorer.sigma_counts.repeat(len(by_force) // 3)[:, None, None]
    resting = changes.resting_counts.flatten(1).T[..., None]
    linear = resting + sigma * (in_press + by_force * _deepest_excess_n(scorer))
    place = linear.abs().unflatten(0, (-1, 3)).amax(dim=1).argmax(dim=-1).T
    counts = _counts_of_pressed_boards if scorer.sensors_move else _counts_of_pressed_magnets
    return counts(scorer, layouts, changes, place)


def _counts_of_pressed_magnets(
    scorer: LayoutScorer,
    layouts: Layouts,
    changes: PressChanges,
    place: Int[Tensor, "layout sensor"],
) -> PressedCounts:
    """Return counts of every sensor with the face's magnets moved by its own press: their fields grow
    faster than their motions."""
    channels, sensors = changes.channels, place.shape[1]
    motion = layouts.magnet_mm.new_zeros(*place.shape, layouts.magnet_mm.shape[1], 6)
    for which, presses, rows in changes.motions:
        # l layout, m magnet, k of 6 motions, r vector of the basis, s sensor (the place of its own press)
        moved = torch.einsum("lmkr,rls->lsmk", rows, _deepest(scorer, presses)[:, place])
        motion[:, :, slice(None) if which is None else list(which)] = moved
    centre, axis = (part[:, :, None] for part in own_magnets(scorer.presses, layouts))
    shift, turn = motion.permute(3, 0, 1, 2).split(3)
    turned = axis + torch.linalg.cross(turn, axis.expand_as(turn), dim=0)
    magnets = (centre + shift).flatten(1, 2), (turned / turned.norm(dim=0)).flatten(1, 2)
    polarity = layouts.polarity.repeat_interleave(sensors, dim=0)
    change = field_at(scorer, channels.sensor_mm.flatten(1)[..., None], magnets, polarity, PRESSED)
    own_change = FieldChange(
        change.field[:, :, 0].unflatten(1, place.shape),
        change.by_motion[:, :, :, 0].unflatten(2, place.shape),
    )
    field = own_change.field.sum(-1) + channels.others.field.sum(-1)
    return PressedCounts(
        counts_of_field(scorer, channels.axes, field),
        channel_spread(scorer, channels.sensor_mm, channels.axes, own_change, channels.others),
    )


def _deepest(scorer: LayoutScorer, presses: PressBasis) -> Float[Tensor, "rank place"]:
    """Basis of the pressed face's motions in the deepest presses."""
    table = presses.own_table.basis.unflatten(1, (4, -1))
    return table[:, 3] + table[:, 2] * _deepest_excess_n(scorer)


def _deepest_excess_n(scorer: LayoutScorer) -> Float[Tensor, "place"]:
    """From the basis's force to that of the deepest press."""
    return scorer.presses.deepest_n - scorer.presses.force_n


def _counts_of_pressed_boards(
    scorer: LayoutScorer,
    layouts: Layouts,
    changes: PressChanges,
    place: Int[Tensor, "layout sensor"],
) -> PressedCounts:
    """Return counts of each board in the deepest press at its own place: near magnets the signals of
    boards are far from linear."""
    ((_, presses, rows),) = changes.motions
    # l layout, s sensor (its board, in the press at its own place), k of 6 motions, r vector
    motion = torch.einsum("lskr,rls->lsk", rows, _deepest(scorer, presses)[:, place])
    moved = changes.channels.sensor_mm + motion[..., :3].permute(2, 0, 1)
    own_field, other_field = field_changes(scorer, layouts, moved)
    field = (own_field.field.sum(-1) + other_field.field.sum(-1)).permute(1, 2, 0)
    felt = _turned_back(field, motion[..., 3:])
    axes = changes.channels.axes
    return PressedCounts(
        counts_of_field(scorer, axes, felt.permute(2, 0, 1)),
        channel_spread(scorer, moved, axes, own_field, other_field),
    )


def _turned_back(
    field: Float[Tensor, "layout sensor 3"], turn_rad: Float[Tensor, "layout sensor 3"]
) -> Float[Tensor, "layout sensor 3"]:
    """Return the field in the frame of a body turned by a rotation vector (Rodrigues)."""
    angle = (turn_rad.square().sum(-1, keepdim=True) + 1e-14).sqrt()
    once = torch.linalg.cross(turn_rad, field, dim=-1)
    twice = torch.linalg.cross(turn_rad, once, dim=-1)
    return field - angle.sin() / angle * once + (1 - angle.cos()) / angle**2 * twice
