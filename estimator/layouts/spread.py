"""Counts that 95 % of virtual objects keep to, for many layouts at once.

Lowest fidelity level of a layout search; `estimator.tolerances.saturation` draws such objects. To
first order `[tolerances]` give every channel a standard deviation s. Fields grow faster than chips
come near, so a channel is taken as c + s z + s² z²/(2 b): c its counts in the design, b those of its
chip's whole field, z standard normal. Channels count as independent, though some causes are common.
Of 24 layouts of a cube the counts that 95 of 100 drawn objects keep to were 0.94 to 1.04 times these
at rest, and 0.88 times where they are beyond the range by a quarter.
"""

from __future__ import annotations

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.catalogue.magnets import NDFEB_REMANENCE_PER_KELVIN
from design.layout.body import face_frames
from design.spec.assembly import TolerancesSpec
from estimator.field.gradient import FieldChange
from estimator.layouts.scorer import LayoutScorer
from estimator.tolerances.saturation import KEPT_BY

_HALVINGS = 24
"""Halvings of an interval of up to 20 standard deviations: to a millionth, which float32 holds."""
_MOST_SIGMAS = 8.0
"""That a channel is followed beyond its design's counts; z there is 5 or more."""
_LEAST_COUNTS = 1.0
"""Least fields and spreads (counts): no division by zero."""


def counts_kept(
    counts: Float[Tensor, "layout channel"],
    sigma_counts: Float[Tensor, "layout channel"],
    faces: int,
) -> Float[Tensor, "layout"]:
    """Counts that no channel of `faces` alike faces exceeds in `KEPT_BY` of the virtual objects.

    Found by bisection, then by one step of Newton's, through which gradients go.
    """
    field = counts.unflatten(1, (-1, 3)).norm(dim=2).repeat_interleave(3, dim=1)
    channels = counts.abs(), sigma_counts + _LEAST_COUNTS, field + _LEAST_COUNTS
    size, sigma, field = (part.detach() for part in channels)
    low = size.amax(dim=1)
    high = (size + _MOST_SIGMAS * sigma * (1 + _MOST_SIGMAS * sigma / field)).amax(dim=1)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        over = faces * _log_kept((size, sigma, field), middle) < np.log(KEPT_BY)
        low, high = torch.where(over, middle, low), torch.where(over, high, middle)
    with torch.enable_grad():
        limit = high.clone().requires_grad_()
        (slope,) = torch.autograd.grad(_log_kept((size, sigma, field), limit).sum(), limit)
    kept = _log_kept(channels, high)
    return high + (np.log(KEPT_BY) / faces - kept) / slope.clamp(min=1e-9)


_Channels = tuple[
    Float[Tensor, "layout channel"],
    Float[Tensor, "layout channel"],
    Float[Tensor, "layout channel"],
]


def _log_kept(channels: _Channels, most: Float[Tensor, "layout"]) -> Float[Tensor, "layout"]:
    """Logarithm of the probability that no channel of a face exceeds a count."""
    size, sigma, field = channels
    free, bend = (most[:, None] - size) / sigma, 0.5 * sigma / field
    # root of bend z² + z − free = 0 without cancellation; the straight line below the design's counts
    z = 2 * free / (1 + (1 + 4 * bend * free.clamp(min=0)).sqrt())
    return torch.special.log_ndtr(z).sum(dim=1)


def channel_spread(
    scorer: LayoutScorer,
    sensor_mm: Float[Tensor, "3 layout sensor"],
    axes: Float[Tensor, "layout sensor 3 3"],
    own_change: FieldChange,
    others: FieldChange,
) -> Float[Tensor, "layout channel"]:
    """Standard deviation of every channel (counts) to first order, from fields of single magnets.

    Left out are the seats of other faces' magnets, which are further away.
    """
    sizes = scorer.spec.tolerances
    # Change of channel a of sensor s with motion j of magnet m, in layout l; i is the field's coordinate.
    of_own = torch.einsum("lsai,ijlsm->lsajm", axes, own_change.by_motion)
    by_magnet = torch.einsum("lsai,ilsm->lsam", axes, own_change.field)
    seat, tilt = sizes.magnet_seat_mm, float(np.deg2rad(sizes.magnet_tilt_deg))
    weights = axes.new_tensor([seat, seat, seat, tilt, tilt, 0.0])
    square = (of_own * weights[:, None]).square().sum((-1, -2))
    square = square + (sizes.remanence_relative * by_magnet).square().sum(-1)
    field = (own_change.field.sum(-1) + others.field.sum(-1)).permute(1, 2, 0)
    of_others = torch.einsum("lsai,ijls->lsaj", axes, others.by_motion[:, :3].sum(-1))
    slope = -(of_own[..., :3, :].sum(-1) + of_others)  # a chip moves as magnets move the other way
    across = torch.linalg.cross(axes, field[:, :, None].expand_as(axes), dim=-1)
    square = square + _chip_variance(sizes, slope, across, (axes @ field[..., None])[..., 0])
    square = square + _yaw_variance(scorer, sensor_mm, slope, across)
    # offsets, and one component of a field of random direction
    uniform_t = 1e-6 * np.hypot(sizes.sensor_offset_ut, sizes.earth_field_ut / np.sqrt(3))
    return scorer.counts_per_t * (square + uniform_t**2).sqrt().flatten(1)


def _chip_variance(
    sizes: TolerancesSpec,
    slope: Float[Tensor, "layout sensor 3 3"],
    across: Float[Tensor, "layout sensor 3 3"],
    felt: Float[Tensor, "layout sensor 3"],
) -> Float[Tensor, "layout sensor 3"]:
    """Variance (T²) by what shifts and turns chips, and by what scales all that they read."""
    shift_mm = np.hypot(sizes.sensor_seat_mm, sizes.core_shift_mm)
    turn = float(np.deg2rad(sizes.sensor_rotation_deg))
    scale = np.hypot(sizes.sensor_gain_relative, NDFEB_REMANENCE_PER_KELVIN * sizes.temperature_k)
    parts = (shift_mm * slope).square().sum(-1), (turn * across).square().sum(-1)
    return parts[0] + parts[1] + (scale * felt).square()


def _yaw_variance(
    scorer: LayoutScorer,
    sensor_mm: Float[Tensor, "3 layout sensor"],
    slope: Float[Tensor, "layout sensor 3 3"],
    across: Float[Tensor, "layout sensor 3 3"],
) -> Float[Tensor, "layout sensor 3"]:
    """Variance (T²) by the core's turn about the object's z, which shifts chips and turns them."""
    face = scorer.presses.face
    frame = next(frame for frame in face_frames(scorer.spec) if frame.number == face)
    about = slope.new_tensor(frame.axes[2].tolist())
    centre = slope.new_tensor((frame.axes.T @ frame.centre_mm).tolist())
    arm_mm = sensor_mm.permute(1, 2, 0) + centre
    shift = torch.linalg.cross(about.expand_as(arm_mm), arm_mm, dim=-1)
    by_turn = (slope * shift[:, :, None]).sum(-1) - (across * about).sum(-1)
    return (float(np.deg2rad(scorer.spec.tolerances.core_yaw_deg)) * by_turn).square()
