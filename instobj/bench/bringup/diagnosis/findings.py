"""Findings of a bring-up: kind, where, what was measured, and what to do about it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from jaxtyping import Float

Kind = Literal[
    "silent chip",
    "dead axis",
    "noisy channel",
    "slow frames",
    "lost frames",
    "bus errors",
    "swapped chips",
    "turned chip",
    "mirrored chip",
    "gain",
    "offset",
    "surroundings",
    "flipped magnet",
    "misplaced magnet",
    "weak magnet",
    "resting levels",
]
HALF_95 = 1.96
"""Half of a 95 % interval, in standard deviations."""
_REMEDIES: dict[Kind, str] = {
    "silent chip": "Check its supply, SDA, SCL and address; resolder it",
    "dead axis": "Resolder or replace the chip; until then this axis is left out",
    "noisy channel": "Check its capacitor and supply wire",
    "slow frames": "Lower sensors.averaging or sensors.frame_rate_hz, or raise the bus clock",
    "lost frames": "Check the USB cable and the baud rate",
    "bus errors": "Shorten the bus, check pull-ups and solder joints",
    "swapped chips": "Exchange their supply pins or addresses, or their channels in the firmware's plan",
    "turned chip": "Resolder it as drawn, or keep it: as_built knows how it sits",
    "mirrored chip": "No rotation does this: fix order and signs of its axes in the firmware",
    "gain": "Check that the chip has the range of the specification; else replace it",
    "offset": "Look for a magnet or steel at the chip; else replace it",
    "surroundings": "Repeat Earth's field away from steel, magnets and currents",
    "flipped magnet": "Turn it over, or keep it: as_built knows",
    "misplaced magnet": "Move it to the pocket that was asked for",
    "weak magnet": "Exchange it, or push it down to the pocket's floor",
    "resting levels": "Check that core and magnets sit as drawn, and take the object away from steel",
}


@dataclass(frozen=True)
class Finding:
    """One thing out of order; `where` names chips (F3-S2), channels (F3-X2) or magnets (F3-M2)."""

    kind: Kind
    where: str
    measured: str

    @property
    def remedy(self) -> str:
        return _REMEDIES[self.kind]

    def __str__(self) -> str:
        return f"{self.kind}: {self.where}; {self.measured}"


@dataclass(frozen=True)
class ChipFound:
    """One chip by the name that its channels have.

    Attributes
    ----------
    site : place at which it sits, by its number among all sensors
    turn : signals = gain · turn · (field in the axes designed for that place); orthogonal
    gain, gain_interval : relative to the median of all channels; half of the 95 % interval
    mean_gain, mean_gain_interval : of its living axes together
    dead : which axes say nothing
    """

    site: int
    turn: Float[np.ndarray, "3 3"]
    gain: Float[np.ndarray, "3"] = field(default_factory=lambda: np.ones(3))
    gain_interval: Float[np.ndarray, "3"] = field(default_factory=lambda: np.full(3, np.nan))
    mean_gain: float = 1.0
    mean_gain_interval: float = np.nan
    dead: tuple[bool, bool, bool] = (False, False, False)

    @property
    def mirrored(self) -> bool:
        """Return whether its axes are left-handed."""
        return bool(np.linalg.det(self.turn) < 0)

    @property
    def angle_deg(self) -> float:
        """Angle by which it is turned; for mirrored axes after the sign of all three is changed."""
        proper = -self.turn if self.mirrored else self.turn
        return float(np.rad2deg(np.arccos(np.clip((np.trace(proper) - 1) / 2, -1, 1))))


def channel_name(sensor: str, axis: int) -> str:
    """F3-S2 and 0 → F3-X2."""
    face, number = sensor.split("-S")
    return f"{face}-{'XYZ'[axis]}{number}"
