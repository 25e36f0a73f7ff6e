"""Changes of channels in presses, of layouts in batches, signals linear in what moves with the silicone.

J = ∂S/∂(motion) · ∂(motion)/∂(x, y, F), with the field's derivatives in closed form and the motions'
compressed (`estimator.layouts.presses.basis`).
"""

from __future__ import annotations

from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from estimator.field.gradient import FieldChange
from estimator.layouts.batch import Layouts
from estimator.layouts.near_field import OTHER, OWN, Magnets, Reach, field_of_magnets
from estimator.layouts.placed import chips, other_magnets, own_magnets
from estimator.layouts.presses.basis import PressBasis
from estimator.layouts.presses.mixed_rows import mixed_rows
from estimator.layouts.scorer import LayoutScorer
from estimator.signals.hall import full_scale_counts
from estimator.signals.live import is_live


@dataclass(frozen=True)
class ChannelChanges:
    """Counts of own channels at rest, and the change of whitened ones with the motion of each body in the
    silicone, whatever is pressed how hard: `by_own` and, of the faces that move, `by_other` magnets;
    boards change their own channels alone. Besides, where the chips are, their axes and the fields of the
    other faces' magnets there."""

    resting_counts: Float[Tensor, "layout sensor 3"]
    by_own: Float[Tensor, "layout channel motion"]
    by_other: Float[Tensor, "layout channel motion_of_others"]
    sensor_mm: Float[Tensor, "3 layout sensor"]
    axes: Float[Tensor, "layout sensor 3 3"]
    others: FieldChange


@dataclass(frozen=True)
class PressChanges:
    """Whitened derivatives of own channels by x, y and force, and their change in the press itself, as
    chips tell them: 0 of channels that are not live (`estimator.signals.live`); `unclipped` as of chips
    without an end of range. Of what moves with the silicone, which of a face's bodies (None: all), and
    how they move with the presses of their size."""

    by_parameter: Float[Tensor, "channel layout 4 place"]
    unclipped: Float[Tensor, "channel layout 4 place"]
    channels: ChannelChanges
    motions: tuple[
        tuple[tuple[int, ...] | None, PressBasis, Float[Tensor, "layout body 6 rank"]], ...
    ]

    @property
    def resting_counts(self) -> Float[Tensor, "layout sensor 3"]:
        return self.channels.resting_counts


def press_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_shift_mm: Float[Tensor, "layout sensor 3"] | None = None,
) -> PressChanges:
    """What presses change, with sensors shifted off their places (boards do not turn with it)."""
    if sensor_shift_mm is not None:
        return _press_changes(scorer, layouts, _channel_changes(scorer, layouts, sensor_shift_mm))
    presses = scorer.presses
    made_of = scorer.spec, presses.own.rows, presses.turn, presses.patches
    channels = layouts.kept("channels", made_of, lambda: _channel_changes(scorer, layouts))
    return layouts.kept("presses", (scorer,), lambda: _press_changes(scorer, layouts, channels))


def _channel_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_shift_mm: Float[Tensor, "layout sensor 3"] | None = None,
) -> ChannelChanges:
    sensor, axes = chips(scorer.presses, layouts, scorer.sensor_depth_mm, scorer.chip)
    if sensor_shift_mm is not None:
        sensor = sensor + sensor_shift_mm.permute(2, 0, 1)
    own, other = field_changes(scorer, layouts, sensor)
    field = own.field.sum(-1) + other.field.sum(-1)
    counts = counts_of_field(scorer, axes, field).unflatten(1, (-1, 3))
    there = sensor, axes, other
    whitened = axes * (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    if scorer.sensors_move:
        by_own = _each_its_own(whitened @ by_motion_of_sensors(own, other))
        return ChannelChanges(counts, by_own, by_own[..., :0], *there)
    moving = _of_moving_faces(
        other.by_motion, layouts.magnet_mm.shape[1], len(scorer.presses.neighbours)
    )
    return ChannelChanges(
        counts, _by_channel(whitened, own.by_motion), _by_channel(whitened, moving), *there
    )


def _press_changes(
    scorer: LayoutScorer, layouts: Layouts, channels: ChannelChanges
) -> PressChanges:
    moving, motions = [], []
    for presses, bodies, which in scorer.of_each_size(layouts):
        rows, tables = mixed_rows(presses, bodies), (presses.own, presses.other)
        count = bodies.magnet_mm.shape[1]
        motions.append((which, presses, rows[0].reshape(len(layouts), count, 6, -1)))
        some = (_of_bodies(each, which, layouts) for each in (channels.by_own, channels.by_other))
        moving += [
            (by_channel @ row.reshape(len(layouts), by_channel.shape[2], -1), table.basis)
            for by_channel, row, table in zip(some, rows, tables, strict=True)
            if by_channel.numel()
        ]
    mixed, basis = torch.cat([m for m, _ in moving], dim=-1), torch.cat([b for _, b in moving])
    change = mixed.transpose(0, 1).reshape(-1, len(basis)) @ basis
    unclipped = change.reshape(mixed.shape[1], len(layouts), 4, -1)
    told = _told(scorer, channels.resting_counts, unclipped)
    return PressChanges(told, unclipped, channels, tuple(motions))


def _told(
    scorer: LayoutScorer,
    resting_counts: Float[Tensor, "layout sensor 3"],
    unclipped: Float[Tensor, "channel layout 4 place"],
) -> Float[Tensor, "channel layout 4 place"]:
    """What chips tell of changes."""
    sigma = scorer.sigma_counts.repeat(resting_counts.shape[1])[:, None, None]
    rest, change = resting_counts.flatten(1).T[..., None] / sigma, unclipped[:, :, 3]
    most = full_scale_counts(scorer.spec.sensors) / sigma
    live: Tensor = is_live(rest, change, most)
    if live.all():
        return unclipped
    pressed = torch.minimum(torch.maximum(rest + change, -most), most)
    told = torch.where(abs(rest) <= most, pressed - rest, 0.0)
    return torch.cat([unclipped[:, :, :3] * live[:, :, None], told[:, :, None]], dim=2)


def _of_bodies(
    by_channel: Float[Tensor, "layout channel motion"],
    which: tuple[int, ...] | None,
    layouts: Layouts,
) -> Float[Tensor, "layout channel some_motion"]:
    """Columns of some magnets' motions, on all faces."""
    if which is None or not by_channel.numel():
        return by_channel
    count = layouts.magnet_mm.shape[1]
    return by_channel.unflatten(-1, (count, -1))[..., list(which), :].flatten(-2)


def by_motion_of_sensors(*of_magnets: FieldChange) -> Float[Tensor, "layout sensor 3 6"]:
    """Change of the field that sensors feel with their own motions, from that with magnets'.

    A sensor moved one way sees magnets moved the other way; one that turns feels the field turned back.
    """
    field = torch.cat([one.field for one in of_magnets], dim=-1).sum(-1).permute(1, 2, 0)
    shifted = torch.cat([one.by_motion[:, :3] for one in of_magnets], dim=-1)
    shift = -shifted.sum(-1).permute(2, 3, 0, 1)
    about = torch.eye(3, dtype=field.dtype).expand(*field.shape, 3)
    turn = torch.linalg.cross(field[..., None, :].expand_as(about), about, dim=-1)
    return torch.cat([shift, turn.transpose(-1, -2)], dim=-1)


def _each_its_own(
    by_motion: Float[Tensor, "layout sensor 3 6"],
) -> Float[Tensor, "layout channel motion"]:
    layouts, sensors = by_motion.shape[:2]
    own = torch.eye(sensors, dtype=by_motion.dtype)[:, None, :, None]
    return (by_motion[:, :, :, None] * own).reshape(layouts, 3 * sensors, -1)


def field_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_mm: Float[Tensor, "3 layout sensor"],
) -> tuple[FieldChange, FieldChange]:
    """Fields and their changes at (layout, sensor, magnet) of own and (magnet, face) of others."""
    presses, polarity = scorer.presses, layouts.polarity
    others = other_magnets(presses, layouts)
    faces, flat = others[0].shape[3], (others[0].flatten(2), others[1].flatten(2))
    return (
        field_at(scorer, sensor_mm, own_magnets(presses, layouts), polarity, OWN),
        field_at(scorer, sensor_mm, flat, polarity.repeat_interleave(faces, dim=1), OTHER),
    )


def field_at(
    scorer: LayoutScorer,
    sensor_mm: Float[Tensor, "3 layout sensor"],
    magnets: Magnets,
    polarity: Float[Tensor, "layout magnet"],
    reach: Reach,
) -> FieldChange:
    """`field_of_magnets` of the scorer's."""
    which = scorer.spec.magnets.by_size
    return field_of_magnets(scorer.sizes, which, sensor_mm, magnets, polarity, reach)


def counts_of_field(
    scorer: LayoutScorer,
    axes: Float[Tensor, "layout sensor 3 3"],
    field_t: Float[Tensor, "3 layout sensor"],
) -> Float[Tensor, "layout channel"]:
    return scorer.counts_per_t * (axes @ field_t.permute(1, 2, 0)[..., None]).flatten(1)


def _of_moving_faces(
    by_motion: Float[Tensor, "3 6 layout sensor other"], magnets: int, faces: int
) -> Float[Tensor, "3 6 layout sensor moving"]:
    """Without the opposite face, the last one, where there is one."""
    every = by_motion.unflatten(-1, (magnets, by_motion.shape[-1] // magnets))
    return every[..., :faces].flatten(-2)


def _by_channel(
    whitened: Float[Tensor, "layout sensor 3 3"],
    by_motion: Float[Tensor, "3 6 layout sensor magnet"],
) -> Float[Tensor, "layout channel motion"]:
    """Change of whitened channels with motions, (magnet, 6) along the last axis."""
    layouts, sensors = whitened.shape[:2]
    by_field = by_motion.permute(2, 3, 0, 4, 1).reshape(layouts, sensors, 3, -1)
    return (whitened @ by_field).reshape(layouts, 3 * sensors, -1)
