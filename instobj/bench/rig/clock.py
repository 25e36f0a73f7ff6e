"""Time of a run on a press rig, and how long of it was spent listening."""

from __future__ import annotations

import time

_SLOWEST_LOOKS = 5
"""Looks, at least, before anything is called silent."""


class Clock:
    """Time of this computer. A bench hands in one of its own, whose time passes as it says."""

    def now_s(self) -> float:
        """Seconds that never run backwards."""
        return time.monotonic()

    def epoch_s(self) -> float:
        """Seconds since 1970, for recordings."""
        return time.time()

    def nap(self, seconds: float) -> None:
        """Let time pass."""
        time.sleep(seconds)


class Listening:
    """Seconds spent listening: a program that was kept from looking, by a busy or
    suspended computer, heard nothing meanwhile, whoever spoke. From one look to the next passes a fifth
    of `patience_s` at most."""

    def __init__(self, patience_s: float, clock: Clock) -> None:
        self._most_s = patience_s / _SLOWEST_LOOKS
        self._clock = clock
        self._looked_s = self.now_s = clock.now_s()

    def look(self) -> float:
        """The time now."""
        now_s = self._clock.now_s()
        self.now_s += min(now_s - self._looked_s, self._most_s)
        self._looked_s = now_s
        return self.now_s
