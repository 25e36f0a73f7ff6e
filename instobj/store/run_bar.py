"""Bar of a whole run on a terminal: stage n of m, its name, time elapsed and about the time left."""

from __future__ import annotations

import json
import time
from collections.abc import Iterable, Sequence
from contextlib import suppress
from datetime import timedelta
from itertools import islice
from pathlib import Path
from statistics import median

from rich.console import Console, RenderableType
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from instobj.store.record import RECORD

MOST_RECORDS = 20
"""Records read for each stage: a search leaves thousands, and a median needs few."""
SHORT_S = 1.0
TYPICAL_S = (
    {"build": 9, "fabrication": 13, "sheet": 3, "mesh": 14, "response": 30, "presses": 12}
    | {"coarse_response": 23, "discretisation": 1, "robustness": 8, "networks": 160, "metrics": 76}
    | {"shapes": 2, "alternatives": 44, "scene": 9, "report": 9}
)
"""Rough time of a stage, s, rounded from a store of a few objects; `SHORT_S` for others. Only for a
store without records of the stage: other objects and machines take several times more or less."""


def expected_seconds(root: Path, stage: str) -> float:
    """Median time that the stage took, of records in the store at `root`; else its typical time."""
    seconds = []
    for record in islice((root / stage).glob(f"*/{RECORD}"), MOST_RECORDS):
        with suppress(OSError, ValueError, KeyError):  # a damaged one is told where it is needed
            seconds.append(float(json.loads(record.read_text(encoding="utf-8"))["seconds"]))
    return median(seconds) if seconds else float(TYPICAL_S.get(stage, SHORT_S))


def time_left(at_work_s: float, elapsed_s: float, later_s: Sequence[float]) -> str:
    """About the time left: the rest of the stage at work, and later stages; a bound once it is late."""
    seconds = max(0.0, at_work_s - elapsed_s) + sum(later_s)
    certainty = "about" if elapsed_s <= at_work_s else "over"
    return f"{certainty} {timedelta(seconds=round(seconds))} left"


class RunBar(Progress):
    """Bar of the stages `due`, each a title with its expected seconds; of one open end without any."""

    def __init__(self, console: Console, due: Sequence[tuple[str, float]]) -> None:
        name = TextColumn("{task.description}", markup=False)
        columns = (name, BarColumn(20), TimeElapsedColumn(), TextColumn("{task.fields[left]}"))
        self._due, self._at_work_s, self._began = list(due), 0.0, time.perf_counter()
        self._count, self._total_s = len(due), sum(seconds for _, seconds in due)
        super().__init__(*columns, console=console, transient=True)  # it renders at once
        self.add_task("", total=self._total_s if due else None, left="")

    def begin(self, title: str) -> None:
        """Count the stages before as done; what is not due, such as publishing, is not counted."""
        index = next((row for row, (name, _) in enumerate(self._due) if name == title), None)
        if index is not None:
            _, self._at_work_s = self._due.pop(index)
            self._began = time.perf_counter()
            to_come_s = self._at_work_s + sum(seconds for _, seconds in self._due)
            self.update(self.task_ids[0], completed=self._total_s - to_come_s)
        self.show(title)

    def show(self, line: str) -> None:
        """Show what is being done within the stage."""
        number = self._count - len(self._due)
        stage = f"stage {number} of {self._count}  " if self._count else ""
        self.update(self.task_ids[0], description=stage + line)

    def get_renderables(self) -> Iterable[RenderableType]:
        """Return the bar with the time left as it is now; rich asks several times a second."""
        elapsed_s = time.perf_counter() - self._began
        text = time_left(self._at_work_s, elapsed_s, [seconds for _, seconds in self._due])
        for task in self.tasks:
            task.fields["left"] = text if self._count else ""
        yield from super().get_renderables()
