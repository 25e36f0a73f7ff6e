"""Frames that wait for the machine's position and the load cell's force, before they are recorded.

Without a load cell travel is the label, of frames below the surface; the others carry none.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

import numpy as np

from estimator.recordings.boards.growing import GrowingRecording
from instobj.bench.rig.load_cell import LoadCell


@dataclass
class _Row:
    time_s: float
    signals: list[float]
    label: list[float]
    travel_mm: float | None = None
    force_n: float | None = None


@dataclass
class Rows:
    """Rows wait for the machine's next report and the load cell's next reading, so that every frame has
    its travel and its force; rows that were left without their label are counted, not written."""

    growing: GrowingRecording | None = None
    by_travel: bool = False
    unlabelled: int = 0
    _waiting: deque[_Row] = field(default_factory=deque)

    @property
    def waiting(self) -> bool:
        """Return whether rows wait for their travel or their force."""
        return bool(self._waiting)

    def add(self, time_s: float, signals: list[float], label: list[float]) -> None:
        """A frame, with the time on the load cell's clock."""
        self._waiting.append(_Row(time_s, signals, label))

    def travelled(self, travel_mm: float) -> None:
        """Travel of all that wait for one."""
        for row in self._waiting:
            row.travel_mm = travel_mm if row.travel_mm is None else row.travel_mm
        self._write()

    def loaded(self, cell: LoadCell) -> None:
        """Forces of all that wait for one."""
        for row in self._waiting:
            row.force_n = cell.force_at(row.time_s) if row.force_n is None else row.force_n

    def close(self) -> None:
        """Write rows with a force whose travel never came without it; count those without their label."""
        labelled = [row for row in self._waiting if row.force_n is not None and not self.by_travel]
        self.unlabelled += len(self._waiting) - len(labelled)
        for row in labelled:
            row.travel_mm = float("nan") if row.travel_mm is None else row.travel_mm
        self._waiting = deque(labelled)
        self._write()

    def _write(self) -> None:
        while self._waiting and self.growing is not None:
            row = self._waiting[0]
            if row.travel_mm is None or (row.force_n is None and not self.by_travel):
                return
            self._waiting.popleft()
            label = [*row.label, round(row.travel_mm, 4)]
            if self.by_travel:
                label = label if row.travel_mm > 0 else [np.nan] * len(label)
                self.growing.append([*row.signals, *label])
            elif row.force_n is None or np.isnan(row.force_n):
                self.unlabelled += 1
            else:
                self.growing.append([*row.signals, round(row.force_n, 4), *label])
