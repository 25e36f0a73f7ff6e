"""Least distance of a chip from a magnet at which the lowest fidelity level's series is right.

The multipole series diverges within a magnet's circumscribed sphere, and just outside its short forms
are wrong by any factor: a search would place chips there. So orders are as high as the least
distance needs, and layouts with a chip nearer break a limit of their own
(`estimator.layouts.limits`); their field is taken at the least distance.
"""

from __future__ import annotations

from dataclasses import dataclass

from jaxtyping import Float
from torch import Tensor

from estimator.field.sources import Magnet


@dataclass(frozen=True)
class Reach:
    """Order of the series, and the least distance from a magnet's centre over its circumscribed
    radius."""

    order: int
    least: float

    def least_mm(self, magnet: Magnet) -> float:
        return self.least * magnet.circumscribed_radius_mm

    def kept_off(
        self, offset_mm: Float[Tensor, "3 *pair"], magnet: Magnet
    ) -> Float[Tensor, "3 *pair"]:
        """Offsets from magnet to chip, those that are too short at the least distance."""
        distance = (offset_mm * offset_mm).sum(0).clamp(min=1e-12).sqrt()
        return offset_mm * (self.least_mm(magnet) / distance).clamp(min=1)


OWN = Reach(order=15, least=1.4)
OTHER = Reach(order=7, least=2.0)
"""Magnets of the chip's own face, and of the other faces: these are many, and further away.

At the least distance, on any side of disks, rods and rings, the field is right to 0.5 % and its
change with the magnet's motion to 1.5 % of the largest there; further away errors fall as fast as
distance to the power of order + 2.
"""
