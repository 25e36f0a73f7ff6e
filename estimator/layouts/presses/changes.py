"""Changes of channels in presses, of layouts in batches, with signals linear in the motions.

What moves with the silicone, magnets or boards, are the bodies.

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
from estimator.layouts.presses.mixed_rows import interpolate_motion_rows
from estimator.layouts.scorer import LayoutScorer
from estimator.signals.hall import full_scale_counts
from estimator.signals.live import is_live


@dataclass(frozen=True)
class ChannelChanges:
    """Counts of own channels at rest, and their change with the motion of each body in the silicone.

    The change is whitened: in standard deviations of a channel per mm and per rad. It does not depend
    on the press. `by_own` is the share of the face's own bodies; `by_other` that of magnets of the other
    faces that move. A board changes its own channels alone. Besides: where the chips are (mm), their
    axes as rows, and the fields of the other faces' magnets there (T).
    """

    resting_counts: Float[Tensor, "layout sensor 3"]
    by_own: Float[Tensor, "layout channel motion"]
    by_other: Float[Tensor, "layout channel motion_of_others"]
    sensor_mm: Float[Tensor, "3 layout sensor"]
    axes: Float[Tensor, "layout sensor 3 3"]
    others: FieldChange


@dataclass(frozen=True)
class PressChanges:
    """Whitened derivatives of own channels by x, y and force, and their change in the press itself.

    `by_parameter` is what chips report: 0 of channels that are not live (`estimator.signals.live`).
    `unclipped` holds chips whose range has no end. `motions`, for each size of body: which of a
    face's bodies have it (None: all), its presses, and the rows of these bodies' motions.
    """

    by_parameter: Float[Tensor, "channel layout 4 place"]
    unclipped: Float[Tensor, "channel layout 4 place"]
    channels: ChannelChanges
    motions: tuple[
        tuple[tuple[int, ...] | None, PressBasis, Float[Tensor, "layout body 6 rank"]], ...
    ]

    @property
    def resting_counts(self) -> Float[Tensor, "layout sensor 3"]:
        return self.channels.resting_counts


def press_changes(scorer: LayoutScorer, layouts: Layouts) -> PressChanges:
    """Return what presses change."""
    presses = scorer.presses
    made_of = scorer.spec, presses.own_table.rows, presses.turn, presses.patches
    channels = layouts.kept("channels", made_of, lambda: _channel_changes(scorer, layouts))
    return layouts.kept("presses", (scorer,), lambda: _press_changes(scorer, layouts, channels))


def _channel_changes(scorer: LayoutScorer, layouts: Layouts) -> ChannelChanges:
    sensor, axes = chips(scorer.presses, layouts, scorer.sensor_depth_mm, scorer.chip)
    own_field, other_field = field_changes(scorer, layouts, sensor)
    # Fields of magnets add (superposition): sum over own magnets and over those of other faces.
    field = own_field.field.sum(-1) + other_field.field.sum(-1)
    counts = counts_of_field(scorer, axes, field).unflatten(1, (-1, 3))
    at_chips = sensor, axes, other_field
    # Rows are chip axes: field (T) → counts → standard deviations of each channel's noise.
    whitened = axes * (scorer.counts_per_t / scorer.sigma_counts)[:, None]
    if scorer.sensors_move:
        by_own = _block_diagonal(whitened @ sensor_motion_changes(own_field, other_field))
        return ChannelChanges(counts, by_own, by_own[..., :0], *at_chips)
    moving = _moving_face_changes(
        other_field.by_motion, layouts.magnet_mm.shape[1], len(scorer.presses.neighbours)
    )
    return ChannelChanges(
        counts,
        _channel_motion_changes(whitened, own_field.by_motion),
        _channel_motion_changes(whitened, moving),
        *at_chips,
    )


def _press_changes(
    scorer: LayoutScorer, layouts: Layouts, channels: ChannelChanges
) -> PressChanges:
    moving, motions = [], []
    for presses, bodies, which in scorer.size_variants(layouts):
        rows, tables = (
            interpolate_motion_rows(presses, bodies),
            (presses.own_table, presses.other_table),
        )
        count = bodies.magnet_mm.shape[1]
        motions.append((which, presses, rows[0].reshape(len(layouts), count, 6, -1)))
        some = (
            _body_columns(each, which, layouts) for each in (channels.by_own, channels.by_other)
        )
        # ∂S/∂(motion) · ∂(motion)/∂(basis vector): (layout, channel, motion) @ (layout, motion, rank)
        moving += [
            (by_channel @ row.reshape(len(layouts), by_channel.shape[2], -1), table.basis)
            for by_channel, row, table in zip(some, rows, tables, strict=True)
            if by_channel.numel()
        ]
    mixed, basis = torch.cat([m for m, _ in moving], dim=-1), torch.cat([b for _, b in moving])
    # Unfold the basis vectors to (∂x, ∂y, ∂F, change itself) at every place, all tables at once.
    change = mixed.transpose(0, 1).reshape(-1, len(basis)) @ basis
    unclipped = change.reshape(mixed.shape[1], len(layouts), 4, -1)
    reported = _reported(scorer, channels.resting_counts, unclipped)
    return PressChanges(reported, unclipped, channels, tuple(motions))


def _reported(
    scorer: LayoutScorer,
    resting_counts: Float[Tensor, "layout sensor 3"],
    unclipped: Float[Tensor, "channel layout 4 place"],
) -> Float[Tensor, "channel layout 4 place"]:
    """Return the changes that chips report, whose range ends at full scale."""
    sigma = scorer.sigma_counts.repeat(resting_counts.shape[1])[:, None, None]
    # All in standard deviations. Index 3 is the change in the press itself, 0 to 2 are derivatives.
    rest, change = resting_counts.flatten(1).T[..., None] / sigma, unclipped[:, :, 3]
    most = full_scale_counts(scorer.spec.sensors) / sigma
    live: Tensor = is_live(rest, change, most)
    if live.all():
        return unclipped
    # A reading stops at full scale. A channel clipped at rest has no rest to compare with: 0.
    pressed = torch.minimum(torch.maximum(rest + change, -most), most)
    read = torch.where(abs(rest) <= most, pressed - rest, 0.0)
    # A clipped reading stands still, so its derivatives are 0 too.
    return torch.cat([unclipped[:, :, :3] * live[:, :, None], read[:, :, None]], dim=2)


def _body_columns(
    by_channel: Float[Tensor, "layout channel motion"],
    which: tuple[int, ...] | None,
    layouts: Layouts,
) -> Float[Tensor, "layout channel some_motion"]:
    """Return the columns of the motions of some magnets, on all faces."""
    if which is None or not by_channel.numel():
        return by_channel
    count = layouts.magnet_mm.shape[1]
    return by_channel.unflatten(-1, (count, -1))[..., list(which), :].flatten(-2)


def sensor_motion_changes(*of_magnets: FieldChange) -> Float[Tensor, "layout sensor 3 6"]:
    """Return the change of the field that sensors feel with their own motions, from that with magnets'.

    A sensor moved one way sees magnets moved the other way; one that turns feels the field turned back.
    """
    field = torch.cat([part.field for part in of_magnets], dim=-1).sum(-1).permute(1, 2, 0)
    shifted = torch.cat([part.by_motion[:, :3] for part in of_magnets], dim=-1)
    # By a displacement of the sensor: −Σ ∂B/∂c over all magnets, c their centres.
    shift = -shifted.sum(-1).permute(2, 3, 0, 1)
    # By a small rotation ω of the sensor: −ω × B in its axes; row k is B × e_k = −e_k × B.
    about = torch.eye(3, dtype=field.dtype).expand(*field.shape, 3)
    turn = torch.linalg.cross(field[..., None, :].expand_as(about), about, dim=-1)
    return torch.cat([shift, turn.transpose(-1, -2)], dim=-1)


def _block_diagonal(
    by_motion: Float[Tensor, "layout sensor 3 6"],
) -> Float[Tensor, "layout channel motion"]:
    """Return a block for each sensor on the diagonal: a board's motion changes its own chip alone."""
    layouts, sensors = by_motion.shape[:2]
    diagonal = torch.eye(sensors, dtype=by_motion.dtype)[:, None, :, None]
    return (by_motion[:, :, :, None] * diagonal).reshape(layouts, 3 * sensors, -1)


def field_changes(
    scorer: LayoutScorer,
    layouts: Layouts,
    sensor_mm: Float[Tensor, "3 layout sensor"],
) -> tuple[FieldChange, FieldChange]:
    """Return fields and their changes with magnets' motions: of own magnets, and of other faces'.

    Axes are (layout, sensor, magnet); of other faces (magnet, face) lie along the last one.
    """
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
    """Return `field_of_magnets` for the scorer's sizes of magnets."""
    which = scorer.spec.magnets.numbers_by_size
    return field_of_magnets(scorer.sizes, which, sensor_mm, magnets, polarity, reach)


def counts_of_field(
    scorer: LayoutScorer,
    axes: Float[Tensor, "layout sensor 3 3"],
    field_t: Float[Tensor, "3 layout sensor"],
) -> Float[Tensor, "layout channel"]:
    """Return counts without noise, rounding or end of range: the field along each chip axis."""
    return scorer.counts_per_t * (axes @ field_t.permute(1, 2, 0)[..., None]).flatten(1)


def _moving_face_changes(
    by_motion: Float[Tensor, "3 6 layout sensor other"], magnets: int, faces: int
) -> Float[Tensor, "3 6 layout sensor moving"]:
    """Return the changes without those of the opposite face, the last one, where there is one."""
    by_face = by_motion.unflatten(-1, (magnets, by_motion.shape[-1] // magnets))
    return by_face[..., :faces].flatten(-2)


def _channel_motion_changes(
    whitened: Float[Tensor, "layout sensor 3 3"],
    by_motion: Float[Tensor, "3 6 layout sensor magnet"],
) -> Float[Tensor, "layout channel motion"]:
    """Return the change of whitened channels with motions, (magnet, 6) along the last axis."""
    layouts, sensors = whitened.shape[:2]
    # (field 3, motion 6, layout, sensor, magnet) → (layout, sensor, field 3, magnet · 6)
    by_field = by_motion.permute(2, 3, 0, 4, 1).reshape(layouts, sensors, 3, -1)
    return (whitened @ by_field).reshape(layouts, 3 * sensors, -1)
