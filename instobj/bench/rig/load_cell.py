"""The load cell of a press rig: its readings, its tare, and what shows that they are none."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass, field

import numpy as np

from design.errors import InputError
from design.spec.load_cell import SUPPLY_V, LoadCellSpec

RECENT = 400
_GAP_S = 1.0
_FEWEST = 15
"""Readings at rest, at least, from which its noise is learnt."""
_CHANCE = 1e-9
"""That a sound load cell stands still for longer than is allowed, at any reading."""
_SHORTEST_RUN, _MOST_REPEATS = 5, 0.95
_STILL_MM, _STILL_READINGS = 0.2, 3
"""Against a travel under load a force that does not change is none: 0.2 mm are 0.3 N and more on the
softest silicone with a 5 mm tip, a hundred times the last digit that a load cell may leave out."""
_NOISE_SHARE = 0.02
"""Noise, as a share of the limit, of a load cell that can hold it."""
_SURE = 8.0
"""Times the noise of a reading: what has certainly changed."""


_HX711_MV_PER_V = 4.0
"""End of its scale at gain 128: ±20 mV of a supply of 5 V."""
_END_SHARE = 0.95
"""Usable share of the end of a scale: supplies and gains are off by some per cent."""


def largest_reading_n(cell: LoadCellSpec) -> float:
    """Force (N, tare included) at the end of the scale of a cell that the board reads, infinite where the
    specification has none."""
    ends = {
        "hx711": abs(cell.newtons_per_unit) * _HX711_MV_PER_V,
        "analog": abs(cell.newtons_per_unit) * SUPPLY_V / 2,
    }
    return _END_SHARE * ends[cell.kind] if cell.kind in ends else math.inf


class NoReading(InputError):
    """The load cell says something that is no force."""


@dataclass
class LoadCell:
    """Forces of the one load cell, counted from its tare (N), with the times of their readings (s).

    `noise_n` is the rms of a reading at rest, `longest_run` how many equal readings in a row its noise
    allows; both are learnt before anything moves. `largest_n` is what it can hold, tare included
    (infinite where nobody knows).
    """

    largest_n: float = math.inf
    tare_n: float = 0.0
    tared: bool = False
    readings: int = 0
    heard_s: float = 0.0
    noise_n: float = 0.0
    longest_run: float = math.inf
    recent_n: deque[float] = field(default_factory=lambda: deque(maxlen=RECENT))
    times_s: deque[float] = field(default_factory=lambda: deque(maxlen=RECENT))
    _run: int = 1
    _run_from_mm: float | None = None

    @property
    def force_n(self) -> float:
        return self.recent_n[-1] - self.tare_n if self.recent_n else float("nan")

    def take(self, force_n: float, time_s: float) -> None:
        """Take one reading, tare included.

        Raises
        ------
        NoReading
            It is not finite, or at or beyond the end of the scale.
        """
        if not math.isfinite(force_n) or abs(force_n) >= self.largest_n:
            raise NoReading(
                f"the load cell says {force_n:g} N, which is no reading but the end of its scale or a "
                "failure. Check its cables and its amplifier's supply"
            )
        same = bool(self.recent_n) and force_n == self.recent_n[-1]
        self._run = self._run + 1 if same else 1
        self._run_from_mm = self._run_from_mm if same else None
        self.recent_n.append(force_n)
        self.times_s.append(time_s)
        self.readings += 1

    def learn(self, readings: int, limit_n: float) -> None:
        """Noise and tare of the last readings, with nothing touched.

        Raises
        ------
        NoReading
            They stand still, or scatter as no load cell does that can hold the limit.
        """
        last = np.array(list(self.recent_n)[-readings:])
        repeats = int(np.sum(last[1:] == last[:-1]))
        if len(last) < _FEWEST or repeats == len(last) - 1:
            raise NoReading(
                f"{len(last)} readings of the load cell are all {last[-1]:g} N: it stands still. A cell "
                "that works shows its noise. Check its cables, or have it send more digits"
            )
        self.noise_n = float(last.std(ddof=1))
        chance = (repeats + 1) / (len(last) + 1)
        # Few readings tell it within its binomial error: two of them upwards.
        chance = min(chance + 2 * math.sqrt(chance * (1 - chance) / len(last)), _MOST_REPEATS)
        self.longest_run = max(math.ceil(math.log(_CHANCE) / math.log(chance)), _SHORTEST_RUN)
        if self.noise_n > _NOISE_SHARE * limit_n:
            raise NoReading(
                f"at rest the load cell's readings scatter by {self.noise_n:.3g} N, more than "
                f"{100 * _NOISE_SHARE:g} % of the limit of {limit_n:.3g} N. Is its scale right (mN or grams "
                "read as N)? --load-port PORT=SCALE, or its figures in the specification"
            )
        self.tare_n, self.tared = float(last.mean()), True

    def require_alive(self, height_mm: float, loaded_n: float) -> None:
        """Refuse readings that stand still, beyond their noise or while the tip moves under load.

        Raises
        ------
        NoReading
            They do.
        """
        if self._run_from_mm is None:
            self._run_from_mm = height_mm
        moved = abs(height_mm - self._run_from_mm) > _STILL_MM and abs(self.force_n) > loaded_n
        if self._run > self.longest_run or (self._run >= _STILL_READINGS and moved):
            raise NoReading(
                f"{self._run} readings of the load cell in a row are {self.recent_n[-1]:g} N: it stands "
                "still. Check its cables"
            )

    def mean_n(self, readings: int) -> float:
        """Mean of the last readings, with the tare."""
        return float(np.mean(list(self.recent_n)[-readings:]))

    def changed_n(self, readings: int) -> float | None:
        """The largest change from the tare within the last readings (N), None if it is their noise."""
        last = np.array(list(self.recent_n)[-readings:]) - self.tare_n
        if not len(last):
            return None
        change = float(last[np.abs(last).argmax()])
        return change if abs(change) > _SURE * self.noise_n else None

    def force_at(self, time_s: float) -> float | None:
        """Force between the readings before and after a time (N): None until there is one after, NaN
        where they are more than a second apart."""
        if not self.times_s or self.times_s[-1] < time_s:
            return None
        after = next(k for k, reading_s in enumerate(self.times_s) if reading_s >= time_s)
        last_before = max(after - 1, 0)
        if self.times_s[after] - min(self.times_s[last_before], time_s) > _GAP_S:
            return float("nan")
        return float(np.interp(time_s, self.times_s, self.recent_n)) - self.tare_n
