"""Grasps in contacts that come frame by frame: each is measured once it has ended."""

from __future__ import annotations

from dataclasses import replace

from estimator.grasps.measures import Conditions, MeasuredGrasp, measured_grasp
from estimator.grasps.phases import HELD_N, PAUSE_S, find_grasps
from estimator.grasps.track import ContactTrack

_MOST_FRAMES = 36_000
"""Frames of a grasp, ten minutes of a page's readings: of a longer one the rest is a grasp of its own."""


class GrowingGrasps:
    """Finds and measures the grasps of contacts that grow, as `measured_grasps` does in whole recordings.

    Only frames of the grasp that goes on, and one before it, are kept: its phases count from these.
    """

    def __init__(self, conditions: Conditions) -> None:
        self._conditions = conditions
        self.count = 0
        self.forget()

    def forget(self) -> None:
        """Leave out the grasp that goes on, whose zero is taken again."""
        self._frames: list[ContactTrack] = []
        self._held_s: float | None = None

    def feed(self, frame: ContactTrack) -> list[MeasuredGrasp]:
        """Take a track of one frame; return the grasps that have ended with it, mostly none."""
        time_s = float(frame.time_s[0])
        self._frames.append(frame)
        if float(frame.total_n[0]) > HELD_N:
            self._held_s = time_s
        if self._held_s is None:
            self._frames = self._frames[-1:]
            return []
        if 0 <= time_s - self._held_s < PAUSE_S and len(self._frames) < _MOST_FRAMES:
            return []
        return self._ended()

    def _ended(self) -> list[MeasuredGrasp]:
        """Measure what has ended, and begin again with the newest frame, in which nothing is held."""
        track, newest = ContactTrack.joined(self._frames), self._frames[-1]
        self.forget()
        self._frames = [newest]
        measured = []
        for grasp in find_grasps(track.time_s, track.total_n):
            self.count += 1
            numbered = replace(grasp, number=self.count)
            measured.append(measured_grasp(track, numbered, self._conditions))
        return measured
