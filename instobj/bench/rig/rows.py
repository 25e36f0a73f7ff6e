"""Frames that wait for the machine's position and the load cell's force, before they are recorded."""

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
    its travel and its force; rows that the load cell left without are counted, not written."""

    growing: GrowingRecording | None = None
    without_force: int = 0
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
        """Write rows whose travel never came without it; count those without a force."""
        rows_with_force = [row for row in self._waiting if row.force_n is not None]
        self.without_force += len(self._waiting) - len(rows_with_force)
        for row in rows_with_force:
            row.travel_mm = float("nan") if row.travel_mm is None else row.travel_mm
        self._waiting = deque(rows_with_force)
        self._write()

    def _write(self) -> None:
        while self._waiting and self.growing is not None:
            row = self._waiting[0]
            if row.travel_mm is None or row.force_n is None:
                return
            self._waiting.popleft()
            if np.isnan(row.force_n):
                self.without_force += 1
                continue
            last = [round(row.force_n, 4), *row.label, round(row.travel_mm, 4)]
            self.growing.append([*row.signals, *last])
