"""Progress of long work on standard error: a live line on a terminal, a line a stage elsewhere."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Event, Thread

from rich.console import Console
from rich.status import Status

NEWS_EVERY_S = 4.0
"""For code that has news all the time."""
MOST_SILENT_S = 5.0
"""Longest time without a change of the live line, s."""
LOG_EVERY_S = 300.0
"""Least time between two steps that a log shows, s: a log is read afterwards, not watched."""
_shown = Event()


def show_progress() -> None:
    """Let this process tell its progress, as the command line does; a library is silent."""
    _shown.set()


@dataclass
class ProgressLine:
    """Line that shows what the stage at work is doing now; `step` is handed to the stages.

    On a terminal a stage that says nothing for 5 s shows its last step again with the time it has
    taken. In a log a step is written once in 5 min at most.
    """

    console: Console = field(
        default_factory=lambda: Console(stderr=True, highlight=False, quiet=not _shown.is_set())
    )
    status_shown: Status | None = None
    _title: str = ""
    _step: str = ""
    _started: float = 0.0
    _told: float = 0.0
    _logged: float = field(default_factory=time.perf_counter)

    @contextmanager
    def stage(self, title: str) -> Iterator[None]:
        """Show `title` while the stage works; the live line is one, however stages lie in each other."""
        outer = self._title, self._step, self._started
        self._title, self._step = title, ""
        self._started = self._told = time.perf_counter()
        try:
            if outer[0]:
                yield
                return
            with self._live_line(title), self._reminder():
                yield
        finally:
            self._title, self._step, self._started = outer

    def step(self, message: str) -> None:
        """Say what is being done within the stage."""
        self._step, self._told = message, time.perf_counter()
        title = ": ".join(filter(None, (self._title, message)))
        elapsed = self._told - self._started
        line = f"{title} [dim]({elapsed:.0f} s)[/dim]" if self._title else message
        if self.status_shown is not None:
            self.status_shown.update(line)
        elif self._told - self._logged >= LOG_EVERY_S:
            self._log(f"  … {line}")

    def say(self, message: str) -> None:
        """A line that stays."""
        self._told = time.perf_counter()
        if self.console.is_terminal:
            self.console.print(message)
        else:
            self._log(message)

    def _log(self, line: str) -> None:
        """Write a line of a log, which has no columns to break at."""
        self._logged = time.perf_counter()
        self.console.print(line, soft_wrap=True)
        sys.stderr.flush()

    @contextmanager
    def _live_line(self, title: str) -> Iterator[None]:
        if not self.console.is_terminal:
            yield
            return
        with self.console.status(title) as self.status_shown:
            try:
                yield
            finally:
                self.status_shown = None

    @contextmanager
    def _reminder(self) -> Iterator[None]:
        """Print the last step again wherever nothing was printed for a while."""
        ended = Event()

        def remind() -> None:
            while not ended.wait(max(0.0, self._told + MOST_SILENT_S - time.perf_counter())):
                if time.perf_counter() - self._told >= MOST_SILENT_S:
                    self.step(self._step)

        thread = Thread(target=remind, name="reminder", daemon=True)
        thread.start()
        try:
            yield
        finally:
            ended.set()
            thread.join()
