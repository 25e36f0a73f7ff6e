"""Least distance of a chip from a magnet at which the lowest fidelity level's series is right.

The multipole series diverges within a magnet's circumscribed sphere, and just outside its short forms
are wrong by any factor: a search would place chips there. So orders are as high as the least
distance needs, and layouts with a chip nearer break a limit of their own
(`estimator.layouts.limits`); their field is taken at the least distance.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from estimator.field.gradient import FieldChange, field_change
from estimator.field.sources import Magnet


@dataclass(frozen=True)
class Reach:
    """Order of the series, and the least distance from a magnet's centre over its circumscribed
    radius; nearer, the field is that at the least distance, or goes on straight from there."""

    order: int
    least: float
    straight_on: bool = False

    def least_mm(self, magnet: Magnet) -> float:
        return self.least * magnet.circumscribed_radius_mm

    def kept_off(
        self, offset_mm: Float[Tensor, "3 *pair"], magnet: Magnet
    ) -> Float[Tensor, "3 *pair"]:
        """Offsets from magnet to chip; too short ones at the least distance."""
        distance = (offset_mm * offset_mm).sum(0).clamp(min=1e-12).sqrt()
        return offset_mm * (self.least_mm(magnet) / distance).clamp(min=1)


OWN = Reach(order=15, least=1.4)
OTHER = Reach(order=7, least=2.0)
"""Magnets of the chip's own face, and of the other faces: these are many, and further away.

At the least distance, on any side of disks, rods and rings, the field is right to 0.5 % and its
change with the magnet's motion to 1.5 % of the largest there; further away errors fall as fast as
distance to the power of order + 2.
"""
PRESSED = Reach(order=21, least=1.15, straight_on=True)
"""A face's own magnets in deep presses, which no limit keeps off: the field is 0.97 to 1.02 of the true one
at the least distance and 0.92 to 1.03 at 1.1 times the radius; at the radius 0.97 in the median and
0.63 or more in 95 % of the poses, least near a disk's rim."""

Magnets = tuple[Float[Tensor, "3 layout magnet"], Float[Tensor, "3 layout magnet"]]
"""Centres (mm) and unit axes, coordinates first."""


def field_of_size(
    magnet: Magnet,
    sensor_mm: Float[Tensor, "3 layout sensor"],
    magnets: Magnets,
    polarity: Float[Tensor, "layout magnet"],
    reach: Reach,
) -> FieldChange:
    """Field (T) at (layout, sensor) of each of the magnets of one size, and its change with their motions."""
    centre, axis = (part[:, :, None] for part in magnets)
    offset, axis = torch.broadcast_tensors(sensor_mm[..., None] - centre, axis)
    kept = reach.kept_off(offset, magnet)
    change = field_change(kept, axis, magnet, reach.order)
    field = change.field
    if reach.straight_on:
        field = field + (change.by_motion[:, :3] * (kept - offset)).sum(1)
    return FieldChange(field * polarity[:, None], change.by_motion * polarity[:, None])


def field_of_magnets(
    sizes: Sequence[Magnet],
    by_size: Sequence[Sequence[int]],
    sensor_mm: Float[Tensor, "3 layout sensor"],
    magnets: Magnets,
    polarity: Float[Tensor, "layout magnet"],
    reach: Reach,
) -> FieldChange:
    """The same of magnets of several sizes; `by_size` are a face's of each, and each magnet's places on
    several faces come one after the other."""
    if len(sizes) == 1:
        return field_of_size(sizes[0], sensor_mm, magnets, polarity, reach)
    faces = polarity.shape[1] // sum(len(which) for which in by_size)
    columns = [[faces * k + face for k in which for face in range(faces)] for which in by_size]
    parts = [
        field_of_size(
            size, sensor_mm, (magnets[0][..., c], magnets[1][..., c]), polarity[:, c], reach
        )
        for size, c in zip(sizes, columns, strict=True)
    ]
    back = torch.as_tensor(np.argsort(np.concatenate(columns)))
    field, by_motion = (
        torch.cat([getattr(part, name) for part in parts], dim=-1)[..., back]
        for name in ("field", "by_motion")
    )
    return FieldChange(field, by_motion)
