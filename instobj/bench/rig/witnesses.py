"""Load cell and chips as two witnesses of one contact; the chips alone where travel labels presses."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from design.errors import InputError
from instobj.bench.rig.chips import FRAMES, Chips
from instobj.bench.rig.contact_law import LARGEST_RATIO, ContactLaw, likely_unit
from instobj.bench.rig.load_cell import LoadCell

TOUCH_N = 0.2
"""Force that counts as touch, where the load cell's noise allows it."""
_TOUCHES = 5.0
"""Times its noise, a force that is none by chance in a million readings."""
_WITNESSED_N, _WITNESSED_FRAMES = 2.0, 5
"""A force that some chip sees wherever an object measures at all, and frames for which none does."""
_UNFELT_FRAMES = 3
"""The mean of three frames sees a contact for two more once it has ended."""
_STRENGTH = 4.0
"""Times the noise of one sum over all channels: by chance once in 30 000 steps."""
_DOUBTED, _TYPICAL_MM = 40, 0.5
"""Readings that are looked at for a doubt, and the least travel that chips or a missing touch tell."""


class Disagreement(InputError):
    """Load cell and chips do not witness the same contact."""


@dataclass
class Witnesses:
    """Both, and the force that the specification lets expect. Without a cell chips and depth alone bound a
    press."""

    cell: LoadCell | None
    chips: Chips
    law: ContactLaw
    _unwitnessed: int = 0
    _unfelt: int = 0
    _seen_mm: float = math.nan

    @property
    def touch_n(self) -> float:
        """Force at which the object counts as touched: what is certainly none of the cell's noise."""
        return TOUCH_N if self.cell is None else max(TOUCH_N, _TOUCHES * self.cell.noise_n)

    @property
    def touch_level(self) -> float:
        """Least of `strengths` at which the object counts as touched."""
        return _STRENGTH if self.cell is None else self.touch_n

    def touch(self, now_s: float) -> bool:
        """Return whether the object counts as touched."""
        return self.chips.see(now_s) if self.cell is None else self.cell.force_n >= self.touch_n

    def reading(self, readings: int, now_s: float) -> Float[np.ndarray, "channel"]:
        """Return the mean force of the last readings; without a cell the chips' change in as many frames."""
        if self.cell is None:
            return np.nan_to_num(self.chips.change(now_s, readings))
        return np.array([self.cell.mean_n(readings) - self.cell.tare_n])

    def strengths(self, readings: list[Float[np.ndarray, "channel"]]) -> Float[np.ndarray, "step"]:
        """Return forces of readings (N); without a cell how far they go the way of the last, in noise."""
        steps = np.array(readings)
        if self.cell is not None:
            return steps[:, 0]
        return steps @ steps[-1] / max(float(np.linalg.norm(steps[-1])), 1e-12)

    def begin(self) -> None:
        """Count frames of disagreement from now on."""
        self._unwitnessed, self._unfelt, self._seen_mm = 0, 0, math.nan

    def take_frame(self, height_mm: float, surface_mm: float, now_s: float) -> None:
        """Count a frame that the chips have taken, with the heights of tip and surface.

        A contact counts as not felt once the tip has gone on by so much since the chips saw it first that
        even the softest object would be felt. Without a cell it must be seen once the softest object would
        be loaded.
        """
        if self.cell is None:
            load_n = self.law.force_n(surface_mm - height_mm, 1 / LARGEST_RATIO)
        else:
            load_n = abs(self.cell.force_n)
        unseen = load_n > _WITNESSED_N and self.chips.see_nothing(now_s)
        self._unwitnessed = self._unwitnessed + 1 if unseen else 0
        if self.cell is None:
            return
        if not self.chips.see(now_s):
            self._seen_mm, self._unfelt = math.nan, 0
            return
        self._seen_mm = float(np.fmax(self._seen_mm, height_mm))
        below_mm = self.law.depth_mm(self.touch_n, 1 / LARGEST_RATIO)
        unfelt = self.cell.force_n < self.touch_n and self._seen_mm - height_mm > below_mm
        self._unfelt = self._unfelt + 1 if unfelt else 0

    def require_agreement(self, travel_mm: float) -> None:
        """Refuse a contact that only the chips or only the load cell sees; with the tip's travel below the
        expected surface.

        Raises
        ------
        Disagreement
            There is one.
        """
        if self._unwitnessed >= _WITNESSED_FRAMES:
            reason = f"the tip is {travel_mm:.2f} mm below the surface"
            question = "Has the object moved"
            if self.cell is not None:
                reason = f"the load cell says {self.cell.force_n:.2f} N"
                question = "Does something else press on the cell"
            raise Disagreement(
                f"{reason} and no chip sees a contact. {question}, and is this the board of this object?"
            )
        if self._unfelt >= _UNFELT_FRAMES and self.cell is not None:
            raise Disagreement(
                f"the chips see a contact and the load cell says {self.cell.force_n:.2g} N"
                f"{self.doubt(travel_mm)}"
            )

    def require_clear(self, height_mm: float, now_s: float, frames: int = FRAMES) -> None:
        """Refuse a contact on the way to a height above the surface (mm), by the chips' mean of frames.

        Raises
        ------
        Disagreement
            The chips see one.
        """
        if self.chips.see(now_s, frames):
            raise Disagreement(
                f"the chips see a contact {height_mm:.1f} mm above the surface. Has the machine lost steps, "
                "has the object moved, or is there steel or a magnet in the tip?"
            )

    def doubt(self, travel_mm: float) -> str:
        """The end of a sentence on a load cell that feels too little: what its last readings say."""
        if self.cell is None:
            return ". Are its chips alive, and is the object where --middle has it?"
        change_n = self.cell.changed_n(_DOUBTED)
        if change_n is None:
            return ". Its readings did not change: is it connected, and the object where --middle has it?"
        # Within a factor of three, since the surface is known within a millimetre only.
        expected_n = self.law.force_n(float(np.fmax(travel_mm, _TYPICAL_MM)))
        unit = likely_unit(change_n / expected_n)
        expected = f"where about {expected_n:.2g} N are expected{unit}"
        return f". Its readings changed by {change_n:.2g} N {expected}."
